#pragma once

#include <array>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "bentur/model/case.h"
#include "bentur/model/story/remarks.h"
#include "bentur/pounding/plan/plan_pounding.h"

// A case of buildings in plan (docs/theory/plan.md), beside Case, which is of a row.
namespace bentur {

/// What moves with the ground.
struct PlanWall {
  Footprint footprint;
  std::vector<double> elevations;  ///< [length] above the base, ascending
};

struct PlanBuildingSpec {
  std::string name;
  std::variant<Plan, PlanWall> structure;
  Damping damping = {};
  bool tangent_damping = false;  ///< as BuildingSpec's
  double base_elevation = 0;     ///< [length]

  [[nodiscard]] const Footprint& footprint() const;
  [[nodiscard]] bool is_rigid() const { return std::holds_alternative<PlanWall>(structure); }
};

/// A pair of buildings that may touch.
struct PlanGapSpec {
  Eigen::Index left = 0, right = 0;  ///< L and R of its stretch (P-6)
  Stretch stretch;
  std::vector<LevelPair> levels = {};          ///< floors of L and R that meet, from the lowest up
  int points = 2;                              ///< of each level
  ContactSpec contact = {};                    ///< lists are over the levels
  std::optional<double> level_tolerance = {};  ///< [length] as level_floors() takes it
};

/// What joins two buildings at a place of their joint, at some elevations.
struct PlanLinkSpec {
  LinkSpec link;  ///< of L and R of the stretch, whichever comes first in the case
  Stretch stretch;
  double at = 0;                             ///< on the stretch [length]
  PlanPoint direction = PlanPoint::UnitX();  ///< that it acts along, of length 1
};

/// A case as plain data, validated, in its own consistent units.
struct PlanCase {
  std::string title;
  Units units;
  std::vector<PlanBuildingSpec> buildings;
  std::vector<PlanGapSpec> gaps;
  std::vector<PlanLinkSpec> links = {};
  std::array<ExcitationSpec, 2> excitation;  ///< of [excitation] and [excitation.y]; delays and kinematics of the first
  double angle = 0;                          ///< of both, from x and y counter-clockwise [degrees] (P-3)
  InitialSpec initial;                       ///< u_x, u_y, θ of each floor
  AnalysisSpec analysis;
  std::optional<ProjectSpec> project = {};
  CodeSpec code = {};  ///< lists over the gaps are in the order of `gaps`
  ScreeningSpec screening = {};
  std::optional<CaseSource> source = {};
  std::shared_ptr<const TomlValue> given = {};  ///< as Case's
};

/// @throws InvalidParameter when a value is out of its range.
[[nodiscard]] PlanBuilding make_plan_building(const PlanBuildingSpec& spec);

/// The contacts of a gap, level after level and along the stretch, with the law of each point's share (P-7), (P-9).
/// @throws InvalidParameter, naming the key at fault, when the values of the law do not go together.
[[nodiscard]] std::vector<PlanContact> contacts_of(const PlanGapSpec& gap,
                                                   const std::vector<PlanBuildingSpec>& buildings);

/// What the gap watches: both ends of the stretch at every floor that faces the other building between that one's base
/// and top and has no contact there; two that are at one level as one. Nothing where they stand corner to corner.
[[nodiscard]] std::vector<PlanWatched> watched_floors(const PlanGapSpec& gap,
                                                      const std::vector<PlanBuilding>& buildings);

/// Floor levels of a model.
[[nodiscard]] FloorLevels levels_of(const PlanModel& model);

/// One link per elevation of each spec, in their order. @throws InvalidParameter as links_of() of a row.
[[nodiscard]] std::vector<PlanLink> links_of(const std::vector<PlanLinkSpec>& specs,
                                             const std::vector<PlanBuilding>& buildings);

/// links_by_spec() of a row's.
[[nodiscard]] std::vector<std::vector<Eigen::Index>> links_by_spec(const std::vector<PlanLinkSpec>& specs);
/// "A – B".
[[nodiscard]] std::string link_name(const PlanProblem& problem, const PlanLink& link);
/// What it acts along: "x", "y" or a direction such as "(0.6, 0.8)".
[[nodiscard]] std::string link_along(const PlanLink& link);

/// The problem a solver takes. @throws InvalidParameter when the case is not consistent.
[[nodiscard]] PlanProblem make_plan_problem(const PlanCase& c);
/// The same of buildings that make_plan_building() has made of the case's.
[[nodiscard]] PlanProblem make_plan_problem(const PlanCase& c, std::vector<PlanBuilding> buildings);

/// What a single run of a case is asked for, as that of a row.
[[nodiscard]] SolveOptions solve_options(const PlanCase& c);

/// A run of buildings in plan, just solved or read again from its results, whose records are known by their echo alone.
struct PlanRun {
  PlanCase c;
  PlanProblem problem;
  PlanResponse response;
  std::vector<Remark> remarks = {};
};

/// As those of a row (remarks.h): of the case alone, and of what came out.
[[nodiscard]] std::vector<Remark> remarks(const PlanCase& c, const PlanProblem& problem);
[[nodiscard]] std::vector<Remark> remarks(const PlanCase& c, const PlanProblem& problem, const PlanResponse& response);

/// The same as those of a row (run_results.h).
[[nodiscard]] PlanRun run_results(PlanCase c, PlanProblem problem, PlanResponse response);

/// Largest acceleration of a component of the ground's motion as applied [length/s²]; 0: there is none.
[[nodiscard]] double applied_pga(const PlanRun& run, std::size_t component);

}  // namespace bentur
