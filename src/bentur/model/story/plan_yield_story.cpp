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

/// That a storey drifts beyond what stands for collapse. @param name of what does
Statement drift_beyond(const PlanRun& run, Index b, const std::string& name, Index storey, double drift) {
  return {
      .kind = "drift_beyond",
      .severity = Severity::danger,
      .buildings = {b},
      .level = run.problem.buildings[b].model.elevations[storey],
      .values = {text_of("building", name), count_of("storey", run.problem.buildings[b].model.storey_number(storey)),
                 value_in("drift", percent * drift, "%"),
                 value_in("limit", percent * run.c.analysis.collapse_drift, "%")}};
}

/// Edges of buildings without planes whose drift does that.
void tell_edges(const PlanRun& run, std::vector<Statement>& statements) {
  for (Index b = 0; b < std::ssize(run.problem.buildings); ++b) {
    const PlanBuilding& building = run.problem.buildings[b];
    const Eigen::VectorXd drifts = run.response.buildings[b].edge_drift_ratio();
    if (drifts.size() == 0 || building.has_gravity_loads()) continue;
    Index storey = 0;
    const double most = drifts.maxCoeff(&storey);
    if (most > run.c.analysis.collapse_drift) {
      statements.push_back(drift_beyond(run, b, building.name, storey, most));
    }
  }
}

/// Of each building the plane with the largest ductility and that with the largest drift, where that is beyond what
/// stands for collapse.
void tell_planes(const PlanRun& run, std::vector<Statement>& statements) {
  for (Index b = 0; b < std::ssize(run.problem.buildings); ++b) {
    const auto& planes = run.response.buildings[b].planes;
    double ductility = 1, drift = run.c.analysis.collapse_drift;
    std::optional<std::pair<std::size_t, Index>> yields, drifts;
    for (std::size_t p = 0; p < planes.size(); ++p) {
      for (Index f = 0; f < planes[p].drift_ratio.size(); ++f) {
        const auto& list = planes[p].yielding.ductility;
        if (f < list.size() && list(f) > ductility) {
          ductility = list(f);
          yields = {p, f};
        }
        if (planes[p].drift_ratio(f) > drift) {
          drift = planes[p].drift_ratio(f);
          drifts = {p, f};
        }
      }
    }
    const PlanModel& model = run.problem.buildings[b].model;
    if (drifts && !run.problem.buildings[b].has_gravity_loads()) {
      statements.push_back(drift_beyond(run, b, plane_name(run, b, drifts->first), drifts->second, drift));
    }
    if (!yields) continue;
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

void tell_yielding(const PlanRun& run, Story& told) {
  tell_planes(run, told.statements);
  tell_edges(run, told.statements);
  tell_bearings(run, told.statements);
  tell_frames(run, told);
  tell_lost_strength(run, told.statements);
}

}  // namespace bentur::story
