#pragma once

#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

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

/// The storey of a building that drifts the most, with contact or without; nothing of one that does not move, or that
/// gravity acts on, whose collapse is looked for.
[[nodiscard]] std::optional<WorstDrift> worst_drift(const RunResults& run, Eigen::Index building);
[[nodiscard]] std::optional<WorstDrift> worst_drift(const PlanRun& run, Eigen::Index building);

/// A storey that yields, or the bearings of a building.
struct Yields {
  std::string name;                         ///< of the building, or of the plane of it
  double ductility = 1;                     ///< > 1 [-]
  std::optional<double> alone = {};         ///< without contact, where that is known
  std::optional<Eigen::Index> storey = {};  ///< its number, for people; nothing: bearings
};
/// Of a building those of the largest ductility.
[[nodiscard]] std::vector<Yields> yields_of(const RunResults& run, Eigen::Index building);
[[nodiscard]] std::vector<Yields> yields_of(const PlanRun& run, Eigen::Index building);

/// The storey of a building that has least of its strength left, where some has softened.
struct Softened {
  std::string name;
  const BuildingPeaks::Yielding& yielding;
  Eigen::Index storey = 0;  ///< from 0
};
[[nodiscard]] std::optional<Softened> softened_of(const RunResults& run, Eigen::Index building);
[[nodiscard]] std::optional<Softened> softened_of(const PlanRun& run, Eigen::Index building);

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

/// The ground motion as applied.
void tell_motion(const RunResults& run, std::vector<Statement>& statements);
void tell_motion(const PlanRun& run, std::vector<Statement>& statements);

/// What small displacements leave out of this run.
inline void tell_left_out(const RunResults& /*run*/, std::vector<Statement>& /*statements*/) {}
void tell_left_out(const PlanRun& run, std::vector<Statement>& statements);

/// A quantity of floors where it is largest over all buildings, along an axis in plan; NaN where none has one.
struct LargestOfFloors {
  double value = std::numeric_limits<double>::quiet_NaN();
  QuantityPlace at = {};
  std::string axis;
};
/// @param key as of a row; in plan with the axis behind "peak_displacement" and the like
[[nodiscard]] LargestOfFloors largest_of_floors(const RunResults& run, const std::string& key);
[[nodiscard]] LargestOfFloors largest_of_floors(const PlanRun& run, const std::string& key);
/// At a place found so.
[[nodiscard]] double value_at(const RunResults& run, const std::string& key, const LargestOfFloors& found);
[[nodiscard]] double value_at(const PlanRun& run, const std::string& key, const LargestOfFloors& found);

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
