// What yields of buildings in plan, or drifts beyond what stands for collapse: planes, edges, bearings, frames.
#include <algorithm>
#include <optional>
#include <utility>

#include "bentur/model/story/internal/story_parts.h"

namespace bentur::story {
namespace {

using Eigen::Index;

/// "A, south wall".
std::string plane_name(const PlanRun& run, Index b, std::size_t plane) {
  return run.problem.buildings[b].name + ", " + run.problem.buildings[b].model.planes[plane].name;
}

/// A storey of a plane, or of the edges of a building without planes, that drifts the most.
struct Drift {
  std::string name;  ///< of what does
  Index storey = 0;
  double ratio = 0;
};
Drift largest_drift(const PlanRun& run, Index b, const PlanPeaks& peaks) {
  Drift most;
  const auto take = [&](const std::string& name, const Eigen::VectorXd& ratios) {
    for (Index storey = 0; storey < ratios.size(); ++storey) {
      if (ratios(storey) > most.ratio) most = {name, storey, ratios(storey)};
    }
  };
  for (std::size_t p = 0; p < peaks.planes.size(); ++p) take(plane_name(run, b, p), peaks.planes[p].drift_ratio);
  take(run.problem.buildings[b].name, peaks.edge_drift_ratio());
  return most;
}

/// Of each building the plane with the largest ductility.
void tell_planes(const PlanRun& run, std::vector<Statement>& statements) {
  for (Index b = 0; b < std::ssize(run.problem.buildings); ++b) {
    const auto& planes = run.response.buildings[b].planes;
    double ductility = 1;
    std::optional<std::pair<std::size_t, Index>> yields;
    for (std::size_t p = 0; p < planes.size(); ++p) {
      const auto& list = planes[p].yielding.ductility;
      for (Index f = 0; f < list.size(); ++f) {
        if (!(list(f) > ductility)) continue;
        ductility = list(f);
        yields = {p, f};
      }
    }
    if (!yields) continue;
    const PlanModel& model = run.problem.buildings[b].model;
    const auto& alone = run.response.buildings_no_contact[b].planes[yields->first].yielding.ductility;
    statements.push_back(
        {.kind = "storey_yields",
         .buildings = {b},
         .values = {text_of("building", plane_name(run, b, yields->first)), value_in("ductility", ductility),
                    count_of("storey", model.storey_number(yields->second)), value_in("alone", alone(yields->second)),
                    word_of("comparison", "story.ductility_alone")}});
  }
}

/// The largest ductility of the bearings of each building, along x or along y. Results do not keep what they do without
/// contact.
void tell_bearings(const PlanRun& run, std::vector<Statement>& statements) {
  for (Index b = 0; b < std::ssize(run.problem.buildings); ++b) {
    const PlanBuilding& building = run.problem.buildings[b];
    const PlanPeaks::Bearings& peaks = run.response.buildings[b].bearings;
    double ductility = 1;
    for (Index n = 0; n < peaks.x.size(); ++n) {
      const HystereticLaw* const law = building.model.bearings[n].law.get();
      if (law == nullptr) continue;
      ductility = std::max(ductility, std::max(peaks.x(n), peaks.y(n)) / law->yield_deformation());
    }
    if (!(ductility > 1)) continue;
    statements.push_back(
        {.kind = "bearings_yield",
         .buildings = {b},
         .values = {text_of("building", building.name), value_in("ductility", ductility), text_of("comparison", "")}});
  }
}

/// Of each building the storey of a plane that has least of its strength left, where some has softened.
void tell_lost_strength(const PlanRun& run, std::vector<Statement>& statements) {
  for (Index b = 0; b < std::ssize(run.problem.buildings); ++b) {
    const auto& planes = run.response.buildings[b].planes;
    std::optional<std::pair<std::size_t, Index>> worst;
    double least = 0;
    for (std::size_t p = 0; p < planes.size(); ++p) {
      const Index storey = most_softened(planes[p].yielding);
      if (storey < 0) continue;
      const double left = planes[p].yielding.strength_left(storey);
      if (worst && !(left < least)) continue;
      worst = {p, storey};
      least = left;
    }
    if (!worst) continue;
    const auto& [plane, storey] = *worst;
    Statement statement = lost_strength(planes[plane].yielding, storey);
    statement.buildings = {b};
    statement.level = run.problem.buildings[b].model.elevations[storey];
    statement.values.push_back(text_of("building", plane_name(run, b, plane)));
    statement.values.push_back(count_of("storey", run.problem.buildings[b].model.storey_number(storey)));
    statements.push_back(std::move(statement));
  }
}

}  // namespace

void tell_drifts(const PlanRun& run, std::vector<Statement>& statements) {
  for (Index b = 0; b < std::ssize(run.problem.buildings); ++b) {
    const PlanBuilding& building = run.problem.buildings[b];
    if (building.is_rigid() || building.has_gravity_loads()) continue;
    const Drift with = largest_drift(run, b, run.response.buildings[b]);
    const Drift alone = largest_drift(run, b, run.response.buildings_no_contact[b]);
    const bool is_alone = alone.ratio > with.ratio;
    const Drift& worst = is_alone ? alone : with;
    tell_drift_beyond({.building = b,
                       .name = worst.name,
                       .storey = building.model.storey_number(worst.storey),
                       .level = building.model.elevations[worst.storey],
                       .ratio = worst.ratio,
                       .is_alone = is_alone},
                      run.problem.collapse_drift, statements);
  }
}

void tell_yielding(const PlanRun& run, Story& told) {
  tell_planes(run, told.statements);
  tell_bearings(run, told.statements);
  tell_frames(run, told);
  tell_lost_strength(run, told.statements);
}

}  // namespace bentur::story
