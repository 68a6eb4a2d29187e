#include "bentur/report/kinds/kinds.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "bentur/core/diagnostics.h"
#include "bentur/model/gap/gap_outcome.h"
#include "bentur/report/kinds/internal/kind_table.h"
#include "bentur/report/kinds/internal/run_figures.h"
#include "bentur/report/kinds/internal/scene_panel.h"
#include "bentur/report/scene/tones.h"
#include "bentur/report/words.h"

namespace bentur {
namespace {

bool stands_above(const RunResults&) { return false; }  // or another has it too

using RunKind = KindOf<RunResults>;

bool has_histories(const RunResults& run) { return !run.response.histories.time.empty(); }
bool has_points(const RunResults& run) {
  return !run.problem.points.empty() || asked_inside(run, FigureOptions{}) != nullptr;
}
bool has_force(const RunResults& run) {
  const std::vector<Impact>& impacts = run.response.impacts;
  return std::any_of(impacts.begin(), impacts.end(), [](const Impact& impact) { return impact.peak_force > 0; });
}
bool has_impacts(const RunResults& run) { return !run.response.impacts.empty(); }
bool has_ratios(const RunResults& run) {
  const std::vector<BuildingPeaks>& buildings = run.response.buildings;
  return has_impacts(run) && std::any_of(buildings.begin(), buildings.end(), [](const BuildingPeaks& peaks) {
           return peaks.storey_shear_no_contact.size() > 0;
         });
}
bool has_heights(const RunResults& run) {
  const std::vector<Building>& buildings = run.problem.buildings;
  return std::any_of(buildings.begin(), buildings.end(),
                     [](const Building& building) { return !building.is_rigid() && building.model.floors() > 1; });
}
bool has_storeys(const RunResults& run) {
  const std::vector<BuildingPeaks>& buildings = run.response.buildings;
  return std::any_of(buildings.begin(), buildings.end(),
                     [](const BuildingPeaks& peaks) { return !peaks.drift_ratio.array().isNaN().all(); });
}
bool has_loop(const RunResults& run) { return !is_lossless(run); }
bool has_close_up(const RunResults& run) { return run.figures.close_up.has_value(); }
bool has_energy(const RunResults& run) {
  return run.response.energy && run.response.energy->histories.input.size() > 0;
}
bool has_yielding(const RunResults& run) {
  const std::vector<BuildingPeaks>& buildings = run.response.buildings;
  bool any = false;
  for (std::size_t b = 0; b < buildings.size(); ++b) {
    const Eigen::VectorXd& ductility = buildings[b].yielding.ductility;
    for (Eigen::Index f = run.problem.buildings[b].model.first_storey(); f < ductility.size(); ++f) {
      any = any || !std::isnan(ductility(f));
    }
  }
  return any && !run.response.histories.time.empty();
}
bool has_hinges(const RunResults& run) {
  const std::vector<BuildingPeaks>& buildings = run.response.buildings;
  return has_histories(run) && std::any_of(buildings.begin(), buildings.end(),
                                           [](const BuildingPeaks& peaks) { return !peaks.hinges.empty(); });
}
bool has_formed_hinges(const RunResults& run) {
  const auto formed = [](const BuildingPeaks::Hinge& hinge) { return hinge.first_yield.has_value(); };
  const std::vector<BuildingPeaks>& buildings = run.response.buildings;
  return has_hinges(run) && std::any_of(buildings.begin(), buildings.end(), [&](const BuildingPeaks& peaks) {
           return std::any_of(peaks.hinges.begin(), peaks.hinges.end(), formed);
         });
}
bool has_bearings(const RunResults& run) {
  const std::vector<Building>& buildings = run.problem.buildings;
  return !run.response.histories.time.empty() &&
         std::any_of(buildings.begin(), buildings.end(),
                     [](const Building& one) { return one.model.slab.has_value(); });
}
bool has_soil(const RunResults& run) {
  const std::vector<Eigen::MatrixXd>& all = run.response.histories.foundation;
  return std::any_of(all.begin(), all.end(), [](const Eigen::MatrixXd& one) { return one.rows() > 0; });
}
bool has_links(const RunResults& run) { return run.response.histories.link_force.rows() > 0; }
bool has_column(const RunResults& run) {
  const std::vector<PointSummary>& points = run.response.points;
  return std::any_of(points.begin(), points.end(), [](const PointSummary& point) { return point.column.has_value(); });
}
bool has_floor_spectra(const RunResults& run) { return !run.figures.floor_spectra.floors.empty(); }
bool has_frames(const RunResults& run) { return !run.figures.frames.empty(); }
bool has_spectrum(const RunResults& run) { return !run.figures.spectrum.empty(); }

const RunKind run_kinds[] = {
    {"overview", "the buildings at the hardest impact, the opening over time, given and needed gap", has_histories,
     overview_figure, stands_above},
    {"scene", "the buildings at the hardest impact, else where they come closest", has_histories, scene_figure,
     stands_above},
    {"displacement", "displacements of both buildings at one contact point, contacts marked", has_points,
     displacement_figure, always<RunResults>, true},
    {"opening", "opening of the gap at one contact point", has_points, opening_figure, always<RunResults>, true},
    {"force", "contact force at one contact point", has_force, force_figure, always<RunResults>, true},
    {"impact", "the hardest impact in close-up: penetration and force", has_close_up, impact_figure},
    {"loop", "force against penetration in the hardest impact", has_close_up, loop_figure, has_loop},
    {"forces", "floor acceleration and storey shear with contact over those without, over the height", has_ratios,
     forces_figure, has_heights},
    {"envelope", "largest displacements over the height, with and without contact", always<RunResults>, envelope_figure,
     has_heights},
    {"amplification", "largest displacement with contact over that without, over the height", has_impacts,
     amplification_figure, has_heights},
    {"drift", "largest storey drift over the height, and what is left of it at the end where something yields",
     has_storeys, drift_figure, has_heights},
    {"modes", "mode shapes of each building", always<RunResults>, modes_figure, has_heights},
    {"hinges", "hinges on the frames by how far they turned, numbered in the order in which they formed", has_hinges,
     hinges_figure, has_formed_hinges},
    {"hinge-loop", "moment over rotation of the hinge of each building that turned furthest", has_formed_hinges,
     hinge_loop_figure},
    {"storey-loop", "storey shear over drift, of the storey of each building that yields most", has_yielding,
     storey_loop_figure},
    {"bearing-loop", "force of the bearings over their displacement", has_bearings, bearing_loop_figure},
    {"soil-loop", "force and moment of the soil over sway and rocking of foundations", has_soil, soil_loop_figure},
    {"link-loop", "force over deformation of the link with the largest force", has_links, link_loop_figure},
    {"column-shear", "shear of a struck column below and above the blow", has_column, column_shear_figure},
    {"column-moment", "moments of a struck column at its ends and where it is struck", has_column,
     column_moment_figure},
    {"energy", "where the energy is", has_energy, energy_figure, always<RunResults>, true},
    {"spectrum", "response spectra of the ground motion, with the buildings' periods", has_spectrum,
     run_spectrum_figure},
    {"floor-spectrum", "response spectra of the motion of the floors that are hit and the roofs", has_floor_spectra,
     floor_spectrum_figure},
    {"frame-forces", "moments, shears and axial forces over the frames at the hardest impact", has_frames,
     frame_forces_figure},
    {"frame-envelope", "the largest of the run of all three", has_frames, frame_envelope_figure},
    {"frame-moment", "moments over the frames alone, at the hardest impact and the largest of the run", has_frames,
     frame_moment_figure, stands_above},
    {"frame-shear", "shears over the frames, likewise", has_frames, frame_shear_figure, stands_above},
    {"frame-axial", "axial forces of columns over the frames, likewise", has_frames, frame_axial_figure, stands_above},
};

/// Whether a kind shows buildings beside one another, of many a part.
bool is_of_buildings(const std::string& kind) {
  constexpr std::string_view all[] = {"forces",       "envelope",       "amplification", "drift",       "modes",
                                      "hinges",       "hinge-loop",     "storey-loop",   "spectrum",    "bearing-loop",
                                      "frame-forces", "frame-envelope", "frame-moment",  "frame-shear", "frame-axial"};
  return std::find(std::begin(all), std::end(all), kind) != std::end(all);
}

/// Of many buildings, whose colours say nothing but for two, which these are: in the figures that do not say it.
void tell_colours(const RunResults& run, const std::string& kind, const FigureOptions& options, Figure& figure) {
  const Impact* const hardest = hardest_impact(run.response.impacts);
  if (run.problem.buildings.size() <= std::size(building_tones) || hardest == nullptr || is_of_a_place(kind)) return;
  const bool has_colour = std::any_of(figure.panels.begin(), figure.panels.end(), [](const Panel& panel) {
    return std::any_of(panel.curves.begin(), panel.curves.end(),
                       [](const Curve& curve) { return curve.tone == building_tones[0]; });
  });
  if (!has_colour) return;
  const auto [struck, worst] = pairs_of_note(run.problem, run.response);
  const auto name_of = [&](const BuildingPair& pair) { return gap_name(run.problem, static_cast<int>(pair->first)); };
  add_part(figure, worst && worst != struck
                       ? word(options, "In colour {}, with the hardest impact, and {}, the worst gap", name_of(struck),
                              name_of(worst))
                       : word(options, "In colour {}, with the hardest impact", name_of(struck)));
}

/// Whether each building has a place of its own there, over its height.
bool is_over_the_height(const std::string& kind) {
  constexpr std::string_view all[] = {"forces", "envelope", "amplification", "drift", "modes"};
  return std::find(std::begin(all), std::end(all), kind) != std::end(all);
}

}  // namespace

std::vector<FigureKind> figure_kinds(const RunResults& run) { return kinds_of(run_kinds, run); }

std::vector<std::string> row_figure_names() { return names_of(run_kinds); }

std::vector<std::string> run_figure_names() {
  std::vector<std::string> names = row_figure_names();
  for (const std::string& name : plan_figure_names()) {
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  }
  return names;
}

void refuse_figure(const std::string& kind, const std::string& of, const std::vector<FigureKind>& kinds) {
  std::vector<std::string> known;
  for (const FigureKind& one : kinds) known.push_back(one.name);
  const std::string near = nearest(kind, known);
  throw NoFigure(fmt::format("no figure \"{}\" of {}{} There are {}.", kind, of,
                             near.empty() ? "." : "; did you mean \"" + near + "\"?", fmt::join(known, ", ")));
}

Figure make_figure(const RunResults& run, const std::string& kind, const FigureOptions& options) {
  for (const RunKind& one : run_kinds) {
    if (kind != one.name) continue;
    Figure figure = one.make(run, options);
    figure.title = figure_title(options.language, caption_key(kind, false), std::move(figure.title));
    if (is_of_a_place(kind) && !options.gap && !options.elevation && asked_inside(run, options) == nullptr &&
        !run.problem.points.empty()) {
      const Eigen::Index point = chosen_point(run, options);
      const std::vector<JudgedGap> judged = judged_gaps(run);
      const auto gap = static_cast<std::size_t>(run.problem.points[point].gap);
      tell_place(one, run, judged, gap, hardest_impact(run, point) != nullptr, options, figure);
    }
    if (kind == "floor-spectrum") {
      const Impact* const hardest = hardest_impact(run.response.impacts);
      std::optional<std::size_t> hit;
      if (hardest != nullptr) hit = static_cast<std::size_t>(run.problem.points[hardest->point].gap);
      figure.part = floors_text(run.figures.floor_spectra, hit, gap_names(run.problem), judged_gaps(run),
                                run.problem.buildings.size(), options);
    }
    if (kind == "scene" || kind == "overview") {
      if (const std::string inside = inside_besides(run, options); !inside.empty()) {
        add_part(figure, inside);
        if (kind == "scene") figure.finding += "; " + inside;
      }
    }
    if (is_of_buildings(kind) && !options.gap && !options.elevation) {
      const std::size_t most = is_over_the_height(kind) ? most_apart : most_together;
      const std::size_t shown = shown_buildings(run, options, most).size(), all = run.problem.buildings.size();
      if (shown < all) {
        figure.part = word(options,
                           "Shown are {} of {} buildings: those of the hardest impact, those that the verdict names, "
                           "and as many of the worst gaps as have room",
                           std::to_string(shown), std::to_string(all));
        figure.finding = figure.part + (figure.finding.empty() ? "" : "; " + figure.finding);
      }
    }
    tell_colours(run, kind, options, figure);
    tell_bands(figure, options);
    return figure;
  }
  refuse_figure(kind, "this run", figure_kinds(run));
}

}  // namespace bentur
