#pragma once

#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

#include "bentur/model/plan/plan_places.h"
#include "bentur/model/plan/plan_row.h"
#include "bentur/model/quantities.h"
#include "bentur/model/story/internal/story_parts.h"

// What run_story.cpp asks of a run: of a row in run_of_row.cpp, of buildings in plan in run_in_plan.cpp.
namespace bentur::story {

/// The gaps of a run, which must outlive it, all judged.
class ToldGaps {
 public:
  explicit ToldGaps(const RunResults& run) : view_(judged_view_of(run)) {}
  explicit ToldGaps(const PlanRun& run) : row_(row_of(run)), view_(judged_view_of(run, *row_)) {}

  [[nodiscard]] std::size_t count() const { return view_.facts.size(); }
  [[nodiscard]] const GapView& view() const { return view_; }

 private:
  std::shared_ptr<const RunResults> row_;
  GapView view_;
};

/// Contact in a gap.
struct Hit {
  long impacts = 0, touched = 0, points = 0;
  Eigen::Index point = 0;           ///< that is hit the hardest, among those of all gaps
  const Impact* hardest = nullptr;  ///< there; null where it is not known
};
[[nodiscard]] Hit hit_of(const RunResults& run, std::size_t gap);
[[nodiscard]] Hit hit_of(const PlanRun& run, std::size_t gap);
/// The level where it is, and with {points} how many places the gap has.
void put_place(const RunResults& run, std::size_t gap, const Hit& hit, Statement& statement);
void put_place(const PlanRun& run, std::size_t gap, const Hit& hit, Statement& statement);

/// Columns beyond what they bear: of each gap of a row the worst in shear and in moment.
void tell_columns(const RunResults& run, std::vector<Statement>& statements);
inline void tell_columns(const PlanRun& /*run*/, std::vector<Statement>& /*statements*/) {}

/// What the storeys of a building did, of a row all of them; in plan those of each plane, and of a building without
/// planes its edges. Lists may be empty.
struct Storeys {
  std::string name;  ///< of the building, or of the plane of it
  Eigen::VectorXd drift, drift_alone;
  BuildingPeaks::Yielding yielding = {}, yielding_alone = {};
};
[[nodiscard]] std::vector<Storeys> storeys_of(const RunResults& run, Eigen::Index building);
[[nodiscard]] std::vector<Storeys> storeys_of(const PlanRun& run, Eigen::Index building);
/// The largest ductility of bearings that are no storey of these.
[[nodiscard]] inline double ductility_of_bearings(const RunResults& /*run*/, Eigen::Index /*building*/) { return 0; }
/// Along x or along y. Results do not keep what they do without contact.
[[nodiscard]] double ductility_of_bearings(const PlanRun& run, Eigen::Index building);

/// What else fails: columns that break, infill. In plan columns are reported with their frames.
void tell_failures(const RunResults& run, Story& told);
inline void tell_failures(const PlanRun& /*run*/, Story& /*told*/) {}
/// Buildings that no gap has, and that could meet by how far both move.
inline void tell_pairs_without_contact(const RunResults& /*run*/, std::vector<Statement>& /*statements*/) {}
void tell_pairs_without_contact(const PlanRun& run, std::vector<Statement>& statements);

/// Buildings that slip off one another sideways.
inline void tell_slips(const RunResults& /*run*/, std::vector<Statement>& /*statements*/) {}
void tell_slips(const PlanRun& run, std::vector<Statement>& statements);

/// Floors that contact turns; whether there are any.
inline bool tell_turning(const RunResults& /*run*/, std::vector<Statement>& /*statements*/) { return false; }
bool tell_turning(const PlanRun& run, std::vector<Statement>& statements);

/// What small displacements leave out of this run.
inline void tell_left_out(const RunResults& /*run*/, std::vector<Statement>& /*statements*/) {}
void tell_left_out(const PlanRun& run, std::vector<Statement>& statements);

/// A quantity of floors where it is largest over all buildings, along an axis in plan; NaN where none has one.
struct LargestOfFloors {
  double value = std::numeric_limits<double>::quiet_NaN();
  QuantityPlace at = {};
  std::string axis;
};
/// "peak_displacement_x_no_contact"; without an axis the key itself.
[[nodiscard]] std::string key_along(const std::string& key, const std::string& axis);

template <class AnyRun>
constexpr bool is_in_plan = std::is_same_v<AnyRun, PlanRun>;

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
  statement.values.push_back(text_of("axis", found.axis));
  statement.values.push_back(word_of("level", "story.level_along"));
  return statement;
}

}  // namespace bentur::story
