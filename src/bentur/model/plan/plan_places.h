#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bentur/model/plan/plan_run.h"
#include "bentur/model/quantities.h"

// Where quantities of buildings in plan are.
namespace bentur {

/// The floors of a building, or the storeys of one of its planes, from the lowest up.
[[nodiscard]] std::vector<QuantityPlace> floors_of(const PlanProblem& problem, Eigen::Index building,
                                                   Eigen::Index plane = 0);
/// The hinges of its frames, one frame after the other, and the columns that can break.
[[nodiscard]] std::vector<QuantityPlace> hinges_of(const PlanProblem& problem, Eigen::Index building);
[[nodiscard]] std::vector<QuantityPlace> breaking_columns_of(const PlanProblem& problem, Eigen::Index building);
/// The storeys of its planes, one plane after the other, each from the top down.
[[nodiscard]] std::vector<QuantityPlace> planes_from_top(const PlanProblem& problem, Eigen::Index building);

/// The bearings below a building, none without a slab.
[[nodiscard]] std::vector<QuantityPlace> bearings_of(const PlanProblem& problem, Eigen::Index building);

/// A contact by its place among those of all gaps.
struct PlanContactPlace {
  std::size_t gap = 0;
  const PlanContact* contact = nullptr;
  PlanPoint at;  ///< in the middle of the gap [length]
};
[[nodiscard]] PlanContactPlace contact_at(const PlanProblem& problem, Eigen::Index contact);
/// The first of a gap's contacts among those of all gaps.
[[nodiscard]] Eigen::Index first_contact(const PlanProblem& problem, std::size_t gap);
/// How many contacts all gaps have.
[[nodiscard]] Eigen::Index contact_count(const PlanProblem& problem);

/// Corners of a joint that have no place of their own, being too near to others. Of outlines that turn inwards none is
/// known: other corners are other pairs' of parts.
[[nodiscard]] std::vector<StretchCorner> merged_corners(const PlanProblem& problem, const PlanGap& gap);

/// Of each contact of all gaps its deformation, in the system_of() the problem.
[[nodiscard]] std::vector<const Interface*> contact_interfaces(const PlanProblem& problem, const System& system);

/// Those that an owner has in a building.
[[nodiscard]] std::vector<QuantityPlace> places_in(const PlanProblem& problem, Owner owner, Eigen::Index building);

/// Who moves where a gap becomes wider and all else keeps its place, as far as that can be: R of the joint, and beyond
/// the joint all but L that are joined to one that moves by a gap, or that it would meet, however far off; ascending.
[[nodiscard]] std::vector<Eigen::Index> buildings_beyond(const PlanProblem& problem, std::size_t gap);

/// A building that does not move, which those that do meet after so long a way [length].
struct InTheWay {
  Eigen::Index building = 0;
  double way = 0;
};
/// The first of them where `movers` go away from a gap across it; nothing where they meet none.
[[nodiscard]] std::optional<InTheWay> first_in_the_way(const PlanProblem& problem, std::size_t gap,
                                                       const std::vector<Eigen::Index>& movers);

/// The gaps of a problem by name, in their order.
[[nodiscard]] std::vector<std::string> gap_names(const PlanProblem& problem);

}  // namespace bentur
