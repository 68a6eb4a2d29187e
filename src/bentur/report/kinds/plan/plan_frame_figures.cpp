#include <algorithm>
#include <set>
#include <utility>

#include "bentur/model/gap/gap_outcome.h"
#include "bentur/model/plan/plan_dense_run.h"
#include "bentur/model/plan/plan_places.h"
#include "bentur/model/plan/plan_row.h"
#include "bentur/report/kinds/internal/plan_figures.h"
#include "bentur/report/kinds/internal/run_figures.h"
#include "bentur/report/scene/tones.h"
#include "bentur/structure/modes.h"

namespace bentur {
namespace {

using Eigen::Index;

double largest_moment(const FrameForces& frame) {
  return std::max(frame.most.moments.maxCoeff(), -frame.least.moments.minCoeff());
}

/// Of frames with members, as FrameForces::building counts them, the two to be shown, in their order: of both buildings
/// at the hardest impact, else of any two, the one with the largest moment, and where but one has frames two of it.
std::vector<Index> shown_frames(const PlanRun& run, const std::vector<PlanFramePlace>& places) {
  constexpr std::size_t most = 2;
  std::vector<Index> at_impact;
  if (const Impact* const hardest = hardest_impact(run.response.impacts)) {
    const PlanGap& gap = run.problem.gaps[contact_at(run.problem, hardest->point).gap];
    at_impact = {gap.left, gap.right};
  }
  const auto building = [&](const FrameForces& frame) { return places.at(frame.building).building; };
  const auto is_struck = [&](const FrameForces& frame) {
    return std::find(at_impact.begin(), at_impact.end(), building(frame)) != at_impact.end();
  };
  std::vector<FrameForces> order = run.closer.frames;
  std::stable_sort(order.begin(), order.end(), [&](const FrameForces& a, const FrameForces& b) {
    return std::pair(is_struck(b), largest_moment(b)) < std::pair(is_struck(a), largest_moment(a));
  });
  std::set<Index> buildings;
  std::vector<Index> shown, others;
  for (const FrameForces& frame : order) {
    (buildings.insert(building(frame)).second ? shown : others).push_back(frame.building);
  }
  shown.insert(shown.end(), others.begin(), others.end());
  shown.resize(std::min(shown.size(), most));
  std::sort(shown.begin(), shown.end());
  return shown;
}

/// Drawn by what draws those of a row.
Figure of_frames(const PlanRun& run, FigureOptions options, Figure (*draw)(const RunResults&, const FigureOptions&)) {
  const std::vector<PlanFramePlace> all = frames_with_members(run.c, run.problem);
  const std::vector<Index> shown = shown_frames(run, all);
  std::vector<PlanFramePlace> places;
  options.gap.reset();
  options.elevation.reset();
  options.tones.clear();
  const std::vector<Tone> tones = tones_of(run.problem, run.response);
  for (const Index n : shown) {
    places.push_back(all[n]);
    options.tones.push_back(tones.at(all[n].building));
  }
  RunResults frames = frames_of(run, places);
  frames.response.impacts = run.response.impacts;
  for (std::size_t i = 0; i < shown.size(); ++i) {
    for (const FrameForces& frame : run.closer.frames) {
      if (frame.building != shown[i]) continue;
      frames.figures.frames.push_back(frame);
      frames.figures.frames.back().building = static_cast<Index>(i);
    }
  }
  Figure figure = draw(frames, options);
  if (shown.size() < run.closer.frames.size()) {
    figure.part = word(options, "{} of {} frames are shown, those with the largest moments",
                       std::to_string(shown.size()), std::to_string(run.closer.frames.size()));
    figure.finding += "; " + figure.part;
  }
  return figure;
}

}  // namespace

Figure floor_spectrum_figure(const PlanRun& run, const FigureOptions& options) {
  FigureOptions with_tones = options;
  with_tones.tones = tones_of(run.problem, run.response);
  RunResults row = *row_of(run);
  row.response.impacts = run.response.impacts;
  row.figures.floor_spectra = run.closer.floors;
  // The first mode of each building is here the one that moves the most of its mass along the spectrum's direction.
  for (const FloorSpectra::Floor& floor : row.figures.floor_spectra.floors) {
    const PlanBuilding& building = run.problem.buildings[floor.building];
    if (building.modes.shapes.cols() == 0) continue;
    const Eigen::VectorXd load = building.model.load.leftCols<2>() * floor.along;
    Eigen::Index most = 0;
    modal_properties(building.modes, load).effective_mass_fraction.maxCoeff(&most);
    row.problem.buildings[floor.building].modes.omega = building.modes.omega.segment<1>(most);
  }
  return floor_spectrum_figure(row, with_tones);
}

Figure frame_forces_figure(const PlanRun& run, const FigureOptions& options) {
  return of_frames(run, options, frame_forces_figure);
}

Figure frame_envelope_figure(const PlanRun& run, const FigureOptions& options) {
  return of_frames(run, options, frame_envelope_figure);
}

Figure frame_moment_figure(const PlanRun& run, const FigureOptions& options) {
  return of_frames(run, options, frame_moment_figure);
}

Figure frame_shear_figure(const PlanRun& run, const FigureOptions& options) {
  return of_frames(run, options, frame_shear_figure);
}

Figure frame_axial_figure(const PlanRun& run, const FigureOptions& options) {
  return of_frames(run, options, frame_axial_figure);
}

}  // namespace bentur
