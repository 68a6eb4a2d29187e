#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "bentur/elements/bearing_laws.h"
#include "bentur/io/case/case_parts.h"
#include "bentur/model/plan/plan_case.h"

// The parts that a case of buildings in plan is read in, as case_parts.h has those of a row.
namespace bentur {

/// A building as read; `told` is what readers that it shares with buildings of a row take: name, path and levels.
struct ReadPlanBuilding {
  PlanBuildingSpec spec;
  ReadBuilding told;
  TomlView view;
  bool is_whole = false;  ///< its footprint and floors are known
};

/// plan_buildings.cpp
[[nodiscard]] std::vector<ReadPlanBuilding> read_plan_buildings(const TomlView& root, const Units& units);
/// The buildings with modes and damping, of what is right otherwise; an error at each that cannot be made.
[[nodiscard]] std::vector<PlanBuilding> make_buildings(const PlanCase& c,
                                                       const std::vector<ReadPlanBuilding>& buildings);

/// plan_buildings.cpp: one pair for all, or a list of one each; empty (and an error) unless all are right.
/// @param count how many of a list; 0: any number from one
[[nodiscard]] std::vector<PlanPoint> read_pairs(const TableView& table, const char* key, std::size_t count);

/// case_support.cpp: [building.soil] of a building in plan; nothing (and an error) where it says too little to go on.
[[nodiscard]] std::optional<PlanSoil> read_soil_in_plan(const TomlView& given, const Footprint& footprint);

/// A law of bearings and its numbers.
struct ReadBearings {
  const LawEntryOf<Bearings>* law = nullptr;
  std::map<std::string, double, std::less<>> numbers = {};
  bool is_whole = false;  ///< all numbers that it needs are there and right
};

/// case_support.cpp: the law that a table says in its own keys, or in a table that has its name.
[[nodiscard]] ReadBearings read_bearings(const TableView& view);

/// plan_isolation.cpp: [building.isolation] of a building whose floors are known; nothing (and an error) where it says
/// too little to go on. @param gravity [length/s²], of what lies on bearings that need it
[[nodiscard]] std::optional<PlanIsolation> read_isolation(const TomlView& given, const Plan& plan, double gravity);

/// plan_gaps.cpp: the pairs that may touch, in the order of their buildings.
[[nodiscard]] std::vector<PlanGapSpec> read_plan_gaps(const TomlView& root,
                                                      const std::vector<ReadPlanBuilding>& buildings);

/// plan_links.cpp
[[nodiscard]] std::vector<PlanLinkSpec> read_plan_links(const TomlView& root,
                                                        const std::vector<ReadPlanBuilding>& buildings);

/// plan_excitation.cpp: both components, and the angle of their axes, into the case.
void read_plan_excitation(const TomlView& root, const std::vector<ReadPlanBuilding>& buildings, const CaseFiles& files,
                          PlanCase& c);

/// plan_excitation.cpp @param moves set when something is given an initial displacement or velocity.
[[nodiscard]] InitialSpec read_plan_initial(const TomlView& root, const std::vector<ReadPlanBuilding>& buildings,
                                            bool& moves);

}  // namespace bentur
