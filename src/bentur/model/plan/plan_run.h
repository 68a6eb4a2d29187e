#pragma once

#include <memory>
#include <string>
#include <vector>

#include "bentur/model/case.h"
#include "bentur/model/closer/dense_run.h"
#include "bentur/model/story/remarks.h"
#include "bentur/pounding/plan/plan_pounding.h"

// What a case of buildings in plan (docs/theory/plan.md) is solved as, and a run of it.
namespace bentur {

struct RunResults;

/// @throws InvalidParameter when a value is out of its range.
[[nodiscard]] PlanBuilding make_plan_building(const BuildingSpec& spec);

/// The gap of a pair, with its contacts, level after level and along the stretch, with the law of each point's share
/// (P-7), (P-9), and its seams. @param left L of its stretch, `right` R
/// @throws InvalidParameter, naming the key at fault, when the values of the law do not go together.
[[nodiscard]] PlanGap gap_with_contacts(const GapSpec& gap, const BuildingSpec& left, const BuildingSpec& right);

/// What the gap watches: both ends of the stretch, and those of the joints of other pairs of parts, at every floor that
/// faces the other building between that one's base and top and has no contact there; two that are at one level as one.
/// Nothing where they stand corner to corner.
[[nodiscard]] std::vector<PlanWatched> watched_floors(const GapSpec& gap, const std::vector<PlanBuilding>& buildings);

/// Floor levels of a model.
[[nodiscard]] FloorLevels levels_of(const PlanModel& model);

/// One link per elevation of each spec, in their order. @throws InvalidParameter as links_of() of a row.
[[nodiscard]] std::vector<PlanLink> links_of(const std::vector<LinkSpec>& specs,
                                             const std::vector<PlanBuilding>& buildings);

/// "A – B".
[[nodiscard]] std::string link_name(const PlanProblem& problem, const PlanLink& link);
/// "x", "y" or a direction such as "(0.6, 0.8)".
[[nodiscard]] std::string direction_text(const PlanPoint& along);
/// What it acts along, likewise.
[[nodiscard]] std::string link_along(const PlanLink& link);

/// The problem a solver takes. @throws InvalidParameter when the case is not consistent.
[[nodiscard]] PlanProblem make_plan_problem(const Case& c);
/// The same of buildings that make_plan_building() has made of the case's.
[[nodiscard]] PlanProblem make_plan_problem(const Case& c, std::vector<PlanBuilding> buildings);
/// The ground motion of a case, and how long it is followed, into a problem that has all else of it.
/// @throws InvalidParameter where the problem is not valid then
void take_motion(const Case& c, PlanProblem& problem);

/// A run of buildings in plan, just solved or read again from its results, whose records are known by their echo alone.
struct PlanRun {
  Case c;
  PlanProblem problem;
  PlanResponse response;
  std::vector<Remark> remarks = {};
  std::shared_ptr<const RunResults> row = {};  ///< row_of() it, where that has been made
  DenseFindings closer = {};  ///< what figures show beyond the histories, where that has been found (plan_dense_run.h)

  [[nodiscard]] const PlanRun& view() const { return *this; }  ///< as RunResults::view(), where quantities are read
};

/// As those of a row (remarks.h).
[[nodiscard]] std::vector<Remark> remarks(const Case& c, const PlanProblem& problem,
                                          const PlanResponse* response = nullptr);

/// The same as those of a row (run_results.h).
[[nodiscard]] PlanRun run_results(Case c, PlanProblem problem, PlanResponse response);

/// Largest acceleration of a component of the ground's motion as applied [length/s²]; 0: there is none.
[[nodiscard]] double applied_pga(const PlanRun& run, std::size_t component);

}  // namespace bentur
