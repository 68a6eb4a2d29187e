#pragma once

#include <deque>
#include <functional>
#include <string_view>
#include <vector>

#include "bentur/model/plan/plan_case.h"
#include "bentur/model/quantities.h"

namespace bentur {

/// What quantities of buildings in plan are one of; of a plane one for each storey. Of a building: its foundation.
/// Hinges and columns that break are those of frames.
enum class PlanOwner { floor, plane, building, bearing, point, gap, impact, link, hinge, column, run };

/// Number of the building, of the contact among those of all gaps, of the gap, of the impact, or of the link (0 of the
/// run); of the floor, or the floor above the storey, or of the hinge or the column that breaks of its frame; and of
/// the plane, or the bearing.
struct PlanPlace {
  Eigen::Index item = 0, floor = 0, plane = 0;
};

/// A number that is told of a run of buildings in plan: what Quantity is of a row. Of points, gaps and impacts a row's
/// are among them.
struct PlanQuantity {
  /// Of what moves: not of walls; where strength goes: of planes that can lose it, as far as that is known.
  enum class When { always, of_what_moves, where_known, where_strength_goes };
  PlanOwner owner = PlanOwner::floor;
  Quantity told;                                                  ///< its words; `value` stands in for its source
  std::function<double(const PlanRun&, const PlanPlace&)> value;  ///< NaN where there is none
  When when = When::always;
  /// Puts a value read from a file where it stands in a response, which has all buildings, planes, points and impacts;
  /// empty where it is computed of others.
  std::function<void(PlanRun&, const PlanPlace&, double)> keep = {};
};

/// All of them, in the order in which files and tables have them.
[[nodiscard]] const std::deque<PlanQuantity>& plan_quantities();
/// The one of this key and owner. @throws InvalidParameter where there is none.
[[nodiscard]] const PlanQuantity& plan_quantity_named(std::string_view key, PlanOwner owner);
/// Its values at places of one building, or of points or impacts; empty where it is not told of these.
[[nodiscard]] std::vector<double> values_at(const PlanQuantity& quantity, const PlanRun& run,
                                            const std::vector<PlanPlace>& places);
/// The floors of a building, or the storeys of one of its planes, from the lowest up.
[[nodiscard]] std::vector<PlanPlace> floors_of(const PlanProblem& problem, Eigen::Index building,
                                               Eigen::Index plane = 0);
/// The hinges of its frames, one frame after the other, and the columns that can break.
[[nodiscard]] std::vector<PlanPlace> hinges_of(const PlanProblem& problem, Eigen::Index building);
[[nodiscard]] std::vector<PlanPlace> breaking_columns_of(const PlanProblem& problem, Eigen::Index building);
/// The storeys of its planes, one plane after the other, each from the top down.
[[nodiscard]] std::vector<PlanPlace> planes_from_top(const PlanProblem& problem, Eigen::Index building);

/// The bearings below a building, none without a slab.
[[nodiscard]] std::vector<PlanPlace> bearings_of(const PlanProblem& problem, Eigen::Index building);

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

/// In the units in which people are told of it: by its largest contact force or storey shear.
[[nodiscard]] ShownUnits shown_units(const PlanRun& run);

/// Columns of a table for people of those quantities that have a label and, `of_forces` or not, are of accelerations,
/// shears and torques. What none of the places has is left out; round-off is shown as 0.
[[nodiscard]] std::vector<TableColumn> table_columns(PlanOwner owner, bool of_forces, const PlanRun& run,
                                                     const std::vector<PlanPlace>& places, std::size_t language = 0);

}  // namespace bentur
