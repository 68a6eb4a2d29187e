#pragma once

#include <cmath>
#include <string>
#include <type_traits>
#include <vector>

#include "bentur/core/not_known.h"
#include "bentur/model/plan/plan_places.h"
#include "bentur/model/plan/plan_row.h"
#include "bentur/model/quantities.h"
#include "bentur/model/story/internal/storeys.h"
#include "bentur/model/story/internal/story_parts.h"

// What run_story.cpp asks of a run: of a row in run_of_row.cpp, of buildings in plan in run_in_plan.cpp.
namespace bentur::story {

template <class AnyRun>
constexpr bool is_in_plan = std::is_same_v<AnyRun, PlanRun>;

/// The level where a point is, and with {points} how many places the gap has.
void put_place(const RunResults& run, std::size_t gap, Eigen::Index point, long points, Statement& statement);
void put_place(const PlanRun& run, std::size_t gap, Eigen::Index point, long points, Statement& statement);

/// Columns beyond what they carry: of each gap of a row the worst in shear and in moment.
void tell_columns(const RunResults& run, std::vector<Statement>& statements);
void tell_columns(const PlanRun& run, std::vector<Statement>& statements);

/// Of bearings in plan, along x or along y. Results do not keep what they do without contact.
[[nodiscard]] double ductility_of_bearings(const PlanRun& run, Eigen::Index building);
[[nodiscard]] bool has_bearings_by_axes(const PlanProblem& problem);
[[nodiscard]] bool some_building_yields(const PlanProblem& problem, const PlanResponse& response);
/// Buildings that no gap has, and that could meet by how far both move.
void tell_pairs_without_contact(const PlanRun& run, std::vector<Statement>& statements);
/// Buildings that slip off one another sideways.
void tell_slips(const PlanRun& run, std::vector<Statement>& statements);
/// Floors that contact turns; whether there are any.
bool tell_turning(const PlanRun& run, std::vector<Statement>& statements);
/// What small displacements leave out of this run.
void tell_left_out(const PlanRun& run, std::vector<Statement>& statements);

/// A quantity of floors where it is largest over all buildings, along an axis in plan; NaN where none has one.
struct LargestOfFloors {
  double value = not_known;
  QuantityPlace at = {};
  std::string axis = {};
};
/// "peak_displacement_x_no_contact"; without an axis the key itself.
[[nodiscard]] std::string key_along(const std::string& key, const std::string& axis);

/// @param key as of a row; in plan with the axis behind "peak_displacement" and the like
template <class AnyRun>
[[nodiscard]] LargestOfFloors largest_of_floors(const AnyRun& run, const std::string& key) {
  const bool has_axes = is_in_plan<AnyRun> && !key.ends_with("rotation");
  LargestOfFloors most;
  for (const std::string& axis : has_axes ? std::vector<std::string>{"x", "y"} : std::vector<std::string>{""}) {
    const Quantity& quantity = quantity_named(key_along(key, axis), Owner::floor, is_in_plan<AnyRun>);
    for (Eigen::Index b = 0; b < std::ssize(run.problem.buildings); ++b) {
      for (const QuantityPlace& at : floors_of(run.problem, b)) {
        const double value = value_of(quantity, run.view(), at);
        if (!std::isnan(value) && !(value <= most.value)) most = {value, at, axis};
      }
    }
  }
  return most;
}

/// At a place found so.
template <class AnyRun>
[[nodiscard]] double value_at(const AnyRun& run, const std::string& key, const LargestOfFloors& found) {
  const Quantity& quantity = quantity_named(key_along(key, found.axis), Owner::floor, is_in_plan<AnyRun>);
  return value_of(quantity, run.view(), found.at);
}

/// {building} and {level}, in plan with the axis.
template <class AnyRun>
[[nodiscard]] Statement of_floor(const AnyRun& run, const LargestOfFloors& found, std::string kind) {
  const auto& building = run.problem.buildings[found.at.item];
  const double level = building.model.elevations[found.at.floor];
  Statement statement{.kind = std::move(kind),
                      .buildings = {found.at.item},
                      .level = level,
                      .values = {text_of("building", building.name)}};
  statement.values.push_back(value_in(found.axis.empty() ? "level" : "elevation", level, run.c.units.length));
  if (found.axis.empty()) return statement;
  return with(std::move(statement), text_of("axis", found.axis), word_of("level", "story.level_along"));
}

}  // namespace bentur::story
