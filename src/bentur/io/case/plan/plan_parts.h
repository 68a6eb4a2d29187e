#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "bentur/elements/bearing_laws.h"
#include "bentur/io/case/case_parts.h"
#include "bentur/model/plan/plan_run.h"
#include "bentur/structure/plan/plan_generic.h"

// The parts of a case that buildings in plan alone have, beside those of case_parts.h.
namespace bentur {

/// Of buildings and planes of them, both by number from 0, the nodes of frames in columns that are struck.
using StruckNodes = std::map<std::pair<std::size_t, std::size_t>, std::vector<ColumnNode>>;

/// plan_buildings.cpp
[[nodiscard]] std::vector<ReadBuilding> read_plan_buildings(const TomlView& root, const Units& units,
                                                            const CaseFiles& files, const StruckNodes& nodes = {});
/// plan_columns.cpp: those that gaps say, of buildings that have been read without. No error is said of these.
[[nodiscard]] StruckNodes struck_nodes(const TomlView& root, const std::vector<ReadBuilding>& buildings);
/// plan_columns.cpp: the level at which a floor of one of the two buildings of a gap strikes columns of the other;
/// nothing (and an error) where none can.
[[nodiscard]] std::optional<LevelPair> read_struck_level(const TomlView& elevation, double wanted, const GapSpec& gap,
                                                         const ReadBuilding& left, const ReadBuilding& right);
/// The buildings with modes and damping, of what is right otherwise; an error at each that cannot be made, or followed
/// for so long. @param made those that have been made before
[[nodiscard]] std::vector<PlanBuilding> make_buildings(const TomlView& root, const Case& c,
                                                       const std::vector<ReadBuilding>& buildings,
                                                       std::vector<PlanBuilding> made = {});

/// plan_buildings.cpp: an error at each building whose masses go both ways under a spectrum, which says what they do
/// where they are expected alone.
void refuse_masses_elsewhere(const TomlView& root, const Case& c, const std::vector<ReadBuilding>& buildings);

/// plan_buildings.cpp: one pair for all, or a list of one each; empty (and an error) unless all are right.
/// @param count how many of a list; 0: any number from one
[[nodiscard]] std::vector<PlanPoint> read_pairs(const TableView& table, const char* key, std::size_t count);

/// case_support.cpp: [building.soil] of a building in plan; nothing (and an error) where it says too little to go on.
[[nodiscard]] std::optional<PlanSoil> read_soil_in_plan(const TomlView& given, const Footprint& footprint);

/// case_known.cpp: [building.modal] of a building in plan; without shapes (and an error) where something is wrong.
[[nodiscard]] GivenModes read_modes_in_plan(const TomlView& modal, const Units& units, const CaseFiles& files,
                                            const std::vector<double>& storey_heights, BuildingSpec& spec);
/// case_known.cpp: [building.generic] of a building in plan; without storeys where their number is not known.
[[nodiscard]] std::optional<GenericPlan> read_generic_in_plan(const TomlView& generic, const Units& units);

/// case_matrices.cpp: the stiffness of a building in plan, three rows per storey; empty (and an error) where it is
/// wrong.
[[nodiscard]] Eigen::MatrixXd read_stiffness_in_plan(const TomlView& matrices, std::size_t storeys);

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
[[nodiscard]] std::vector<GapSpec> read_plan_gaps(const TomlView& root, const std::vector<ReadBuilding>& buildings);

/// case_gaps.cpp: whether floors strike columns in a gap, and what these carry, where `spec` has its levels.
void read_strikes_columns(const TableView& gap, GapSpec& spec);
void read_column_capacity(const TableView& gap, const GapSides& sides, GapSpec& spec);

/// A floor of one of two buildings that strikes a column of the other.
struct Strike {
  int struck = 0;  ///< whose column: 0 the left one's, 1 the right one's
  int floor = 0;   ///< of the other
};
/// case_columns.cpp: which floor may strike at an elevation [length], of those of the left building first, to within a
/// part of its height; nothing where neither has one there.
[[nodiscard]] std::optional<Strike> strike_at(const FloorLevels& left, const FloorLevels& right, double elevation);
/// case_columns.cpp: a number, where a value is one; no error is said.
[[nodiscard]] std::optional<double> number_in(const std::optional<TomlView>& view);
/// case_columns.cpp: elevations that a gap names to be struck [length], as far as they are numbers: what is wrong with
/// it is said where it is read.
[[nodiscard]] std::vector<double> elevations_to_strike(const TomlView& gap);
/// case_columns.cpp: why no column can be struck at an elevation [length], by the storeys of its building; nothing
/// where one can.
[[nodiscard]] std::optional<std::string> no_column_at(const ReadBuilding& struck, double elevation);

/// case_gaps.cpp: `elevations = []`.
[[nodiscard]] bool models_no_contact(const TomlView& elevations);

/// case_gaps.cpp: whether some floor of either building is between base and top of the other; an error at the gap where
/// none is.
[[nodiscard]] bool checked_to_face(const TomlView& gap, const ReadBuilding& left, const ReadBuilding& right);

/// plan_links.cpp: the place of a link between two buildings, its joint and what it acts along, into `spec`, and
/// `sides` in the order of that; an error where they do not face one another.
void read_place(const TableView& link, const std::vector<ReadBuilding>& buildings,
                std::optional<std::pair<std::size_t, std::size_t>>& sides, LinkSpec& spec);

}  // namespace bentur
