#include <algorithm>
#include <utility>

#include "bentur/model/gap/gap_outcome.h"
#include "bentur/model/judgement/judged_gaps.h"
#include "bentur/model/plan/plan_frames.h"
#include "bentur/model/plan/plan_places.h"
#include "bentur/report/kinds/internal/kind_table.h"
#include "bentur/report/kinds/internal/plan_figures.h"
#include "bentur/report/kinds/internal/run_figures.h"
#include "bentur/report/kinds/kinds.h"
#include "bentur/report/words.h"

namespace bentur {
namespace {

bool tells_above(const PlanRun&) { return false; }

using PlanKind = KindOf<PlanRun>;

bool has_points(const PlanRun& run) { return !run.response.points.empty() && !run.response.histories.time.empty(); }
bool has_force(const PlanRun& run) {
  const std::vector<PointSummary>& points = run.response.points;
  return has_points(run) &&
         std::any_of(points.begin(), points.end(), [](const PointSummary& one) { return one.peak_force > 0; });
}
bool has_friction(const PlanRun& run) {
  for (Eigen::Index i = 0; has_points(run) && i < std::ssize(run.response.points); ++i) {
    if (contact_at(run.problem, i).contact->rubbing && run.response.points[i].impacts > 0) return true;
  }
  return false;
}
bool has_soil(const PlanRun& run) {
  const std::vector<Eigen::MatrixXd>& all = run.response.histories.foundation;
  return std::any_of(all.begin(), all.end(), [](const Eigen::MatrixXd& one) { return one.rows() > 0; });
}
bool has_hinges(const PlanRun& run) {
  const auto has_some = [&](const PlanFramePlace& at) {
    return run.problem.buildings[at.building].model.planes[at.plane].hinges.size() > 0;
  };
  const std::vector<PlanFramePlace> places = frames_that_yield(run.problem);
  return !run.response.histories.time.empty() && std::any_of(places.begin(), places.end(), has_some);
}
bool has_formed_hinges(const PlanRun& run) {
  const auto formed = [](const BuildingPeaks::Hinge& hinge) { return hinge.first_yield.has_value(); };
  for (const auto& [b, p] : frames_that_yield(run.problem)) {
    const std::vector<BuildingPeaks::Hinge>& hinges = run.response.buildings[b].planes[p].frame.hinges;
    if (std::any_of(hinges.begin(), hinges.end(), formed)) return has_hinges(run);
  }
  return false;
}
/// Drawn as frames of a row are: of all of them, as a gap has no part in it.
FigureOptions of_frames(FigureOptions options) {
  options.gap.reset();
  return options;
}
Figure frame_hinges_figure(const PlanRun& run, const FigureOptions& options) {
  return hinges_figure(frames_of(run), of_frames(options));
}
Figure frame_loop_figure(const PlanRun& run, const FigureOptions& options) {
  return hinge_loop_figure(frames_of(run), of_frames(options));
}
bool has_floor_spectra(const PlanRun& run) { return !run.closer.floors.floors.empty(); }
bool has_frames(const PlanRun& run) { return !run.closer.frames.empty(); }
bool has_bearings(const PlanRun& run) {
  const std::vector<Eigen::MatrixXd>& all = run.response.histories.bearing;
  return std::any_of(all.begin(), all.end(), [](const Eigen::MatrixXd& one) { return one.rows() > 0; });
}
bool has_energy(const PlanRun& run) { return run.response.energy && run.response.energy->histories.input.size() > 0; }

/// So many that a list of them says little of where they stand.
bool has_a_block(const PlanRun& run) { return run.problem.buildings.size() > 6 && run.problem.gaps.size() > 1; }

const PlanKind plan_kinds[] = {
    {"map", "houses of a block and what lies between them from above, by what is judged of it", has_a_block, map_figure,
     tells_above},
    {"overview", "the buildings from above at the hardest impact, the opening over time, given and needed gap",
     has_points, overview_figure, tells_above},
    {"scene", "the buildings from above at the hardest impact, else where they come closest", has_points, scene_figure,
     tells_above},
    {"displacement", "displacements along x and y and rotations of both floors at one contact, contacts marked",
     has_points, displacement_figure, always<PlanRun>, true},
    {"opening", "opening of the gap at both ends of one stretch", has_points, opening_figure, always<PlanRun>, true},
    {"orbit", "how both ends of one stretch move, seen from above", has_points, orbit_figure, always<PlanRun>, true},
    {"force", "contact forces at one level of a gap", has_force, force_figure, always<PlanRun>, true},
    {"friction-cone", "force along the joint over contact force, between the limits of friction", has_friction,
     friction_figure},
    {"bearing-loop", "force of the bearing of each building that moves most over its displacement", has_bearings,
     bearing_loop_figure},
    {"soil-loop", "force and moment of the soil over sway, rocking and twist of foundations", has_soil,
     soil_loop_figure},
    {"hinges", "hinges on the frames by how far they turned, numbered in the order in which they formed", has_hinges,
     frame_hinges_figure, has_formed_hinges},
    {"hinge-loop", "moment over rotation of the hinge of each frame that turned furthest", has_formed_hinges,
     frame_loop_figure},
    {"floor-spectrum", "response spectra of the motion of the floors that are hit and the roofs, across the joint",
     has_floor_spectra, floor_spectrum_figure},
    {"frame-forces", "moments, shears and axial forces over the frames that carry most, at the hardest impact",
     has_frames, frame_forces_figure},
    {"frame-envelope", "the largest of the run of all three over these frames", has_frames, frame_envelope_figure},
    {"frame-moment", "moments over these frames alone, at the hardest impact and the largest of the run", has_frames,
     frame_moment_figure, tells_above},
    {"frame-shear", "shears over these frames, likewise", has_frames, frame_shear_figure, tells_above},
    {"frame-axial", "axial forces of columns over these frames, likewise", has_frames, frame_axial_figure, tells_above},
    {"energy", "where the energy is", has_energy, energy_figure, always<PlanRun>, true},
};

}  // namespace

std::vector<FigureKind> figure_kinds(const PlanRun& run) { return kinds_of(plan_kinds, run); }

std::vector<std::string> plan_figure_names() { return names_of(plan_kinds); }

Figure make_figure(const PlanRun& run, const std::string& kind, const FigureOptions& options) {
  for (const PlanKind& one : plan_kinds) {
    if (kind != one.name) continue;
    Figure figure = one.make(run, options);
    figure.title = figure_title(options.language, caption_key(kind, true), std::move(figure.title));
    if (is_of_a_place(kind) && !options.gap && !options.elevation) {
      const Eigen::Index point = chosen_point(run, options);
      const std::vector<JudgedGap> judged = judged_gaps(run);
      const std::size_t gap = contact_at(run.problem, point).gap;
      tell_place(one, run, judged, gap, run.response.points[point].impacts > 0, options, figure);
    }
    if (kind == "floor-spectrum") {
      const Impact* const hardest = hardest_impact(run.response.impacts);
      std::optional<std::size_t> hit;
      if (hardest != nullptr) hit = static_cast<std::size_t>(contact_at(run.problem, hardest->point).gap);
      figure.part = floors_text(run.closer.floors, hit, gap_names(run.problem), judged_gaps(run),
                                run.problem.buildings.size(), options);
    }
    tell_bands(figure, options);
    return figure;
  }
  const std::vector<std::string> of_rows = row_figure_names();
  const bool is_of_rows = std::find(of_rows.begin(), of_rows.end(), kind) != of_rows.end();
  refuse_figure(kind, is_of_rows ? "buildings in plan, but of a row" : "this run", figure_kinds(run));
}

}  // namespace bentur
