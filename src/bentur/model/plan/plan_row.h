#pragma once

#include <memory>
#include <optional>

#include "bentur/model/gap/gap_outcome.h"
#include "bentur/model/plan/plan_run.h"
#include "bentur/model/run_results.h"

// Buildings in plan seen along their gaps, as a row is, for what is reported of gaps of rows and plans alike.
namespace bentur {

/// Whether gravity acts on a building of a row, or in plan.
[[nodiscard]] inline bool has_gravity(const Building& building) { return building.has_gravity_loads; }
[[nodiscard]] inline bool has_gravity(const PlanBuilding& building) { return building.has_gravity_loads(); }

/// Whether it stands on soil.
[[nodiscard]] inline bool has_soil(const Building& building) { return building.model.foundation.has_value(); }
[[nodiscard]] inline bool has_soil(const PlanBuilding& building) { return building.model.soil.has_value(); }

/// The gaps of a problem in their order, each between its L and R, with the contact points of its joints and what it
/// watches. Known of the buildings are names, levels, masses and, where they move, circular frequencies; of their
/// damping nothing, as modes of floors that turn are of no one direction.
[[nodiscard]] Problem row_of(const PlanProblem& problem);
/// The same with the case's [code].
[[nodiscard]] RunResults row_of(const Case& c, const PlanProblem& problem);
/// The same with what the response says of points and watched floors, and of the buildings how far the edges of their
/// floors move without contact; that of run_results() where the run has it.
/// @throws InvalidParameter unless the response is of this problem.
[[nodiscard]] std::shared_ptr<const RunResults> row_of(const PlanRun& run);

/// Where a gap falls short the most of what the motion without contact needs, and what that motion times −1 needs
/// there, where the case asks for it and it is known.
[[nodiscard]] std::optional<GoverningLevel> governing_level(const PlanRun& run, std::size_t gap);

/// Of a gap's contacts those that a row_of() its problem has as points: of the joint of each pair of parts, from the
/// lowest level up.
[[nodiscard]] std::vector<Eigen::Index> contacts_in_row(const PlanGap& gap);

/// A contact point (else what is watched) of a row_of() a problem: the gap that it is in, and its place among the
/// contacts, or what is watched, of that.
struct PlaceInGap {
  std::size_t gap = 0;
  Eigen::Index index = 0;
};
[[nodiscard]] PlaceInGap place_in_gap(const PlanProblem& problem, const Problem& row, bool is_point,
                                      Eigen::Index index);
/// Where it is, in the middle of its gap [length].
[[nodiscard]] PlanPoint place_of(const PlanProblem& problem, const Problem& row, bool is_point, Eigen::Index index);

}  // namespace bentur
