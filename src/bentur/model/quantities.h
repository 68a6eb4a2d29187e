#pragma once

#include <cstddef>
#include <deque>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "bentur/core/units.h"
#include "bentur/model/restitution.h"
#include "bentur/pounding/problem.h"
#include "bentur/pounding/response.h"

namespace bentur {

struct PlanBuilding;
struct PlanProblem;
struct PlanRun;
struct Remark;
struct RunResults;

/// What the values of a quantity belong to: one value for the run, or one each. Of planes in plan one for each storey;
/// bearings are those of plans alone.
enum class Owner { run, building, floor, plane, point, gap, impact, link, hinge, column, bearing };

/// The units in which people read of a run: by its largest contact force or storey shear.
[[nodiscard]] ShownUnits shown_units(const Units& units, const Response& response);
[[nodiscard]] ShownUnits shown_units(const RunResults& run);
[[nodiscard]] ShownUnits shown_units(const PlanRun& run);

/// A run of a row as quantities are read from it; of buildings in plan that is PlanRun.
struct RunView {
  RunView(const Problem& p, const Response& r, const Units& u);

  const Problem& problem;
  const Response& response;
  const Units& units;
  const ShownUnits shown;
  const std::vector<Remark>* remarks = nullptr;  ///< of the case and what came out; null: not looked for
  std::vector<PointRestitution> restitutions;    ///< per contact point
};

/// Where a value is: number of the building, point, gap, impact or link (0 of the run), of points and impacts in plan
/// among those of all gaps; of the floor, or the floor above the storey, or the hinge, or the column that breaks; and
/// in plan of the plane or the bearing.
struct QuantityPlace {
  Eigen::Index item = 0, floor = 0, plane = 0;
};

/// Which buildings, points or runs have a quantity.
enum class When {
  always,
  moves,             ///< no wall
  edges,             ///< it is in plan and has no planes
  yields,            ///< a storey can yield
  yields_or_turns,   ///< or a frame has hinges
  loses_strength,    ///< a storey can
  infill,            ///< a frame has some
  infill_columns,    ///< that pushes on columns with a shear capacity
  soil,              ///< it stands on some
  hinges,            ///< a frame has some
  weakening_hinges,  ///< that lose strength
  breaking_columns,  ///< a frame has some
  bearings_yield,
  struck,  ///< a floor strikes a column there; the next ones: whose capacity is given
  struck_shear,
  struck_moment,
  struck_capacity,  ///< one of both
  rubs,             ///< a contact does
};

/// How a quantity is read from runs of one kind, and kept.
template <class Run, class Results>
struct SourceOf {
  std::function<double(const Run&, const QuantityPlace&)> value =
      {};  ///< NaN: there is none; empty: such runs have none
  /// Puts a value read from a file where it stands in results, which have all buildings, planes, points and impacts;
  /// empty where it is computed of others.
  std::function<void(Results&, const QuantityPlace&, double)> keep = {};
  std::function<bool(const Run&, Eigen::Index)> is_told = {};  ///< of an item, whatever its values; empty: always
};

/// Tables for people, each of what belongs together.
enum class QuantityTable { main, forces, yielding, struck };

/// Where the values of a quantity come from.
struct QuantitySource {
  SourceOf<RunView, Response> row = {};
  SourceOf<PlanRun, PlanRun> plan = {};
  When when = When::always;
  enum class Number { real, count, yes_or_no } number = Number::real;
  QuantityTable table = QuantityTable::main;
};

/// A number that is reported of a run. Summary, impact list, histories.nc, the rows of studies and all tables for
/// people are made from the list of these; a new quantity is one line there (docs/result-files.md has them all).
struct Quantity {
  std::string_view key;        ///< its name in every file and in studies
  Owner owner = Owner::run;    ///< what it is one of
  std::string_view units;      ///< as UDUNITS reads them, L for length and F for force: "L s-2"; "1" for none
  std::string_view symbol;     ///< in formulas
  std::string_view long_name;  ///< in words, of one of its owners
  /// Heads its column in tables, English and Indonesian; empty: it is in none.
  std::string_view label[2];
  QuantitySource source;
  std::string_view pointer = {};     ///< JSON pointer in the summary, from its owner's object; empty: the key
  std::string_view shown_unit = {};  ///< in tables, where another one reads better: "ms", "%"
  double shown_factor = 1;           ///< what the value is multiplied by for that
  std::optional<int> decimals = {};  ///< in tables; nothing: as many as its column needs
  bool audit_only = false;           ///< known with an energy audit alone
  bool by_size = false;              ///< of either sign: |value| is what runs are compared by
  bool single_run = false;           ///< known of a single run: studies do not have it
};

/// All of them, in the order in which files and tables have them.
[[nodiscard]] const std::deque<Quantity>& quantities();
/// Those of one kind of owner that runs of rows have, or runs of buildings in plan.
[[nodiscard]] std::vector<const Quantity*> quantities_of(Owner owner, bool in_plan = false);
/// The one of this key and owner among them. @throws InvalidParameter where there is none.
[[nodiscard]] const Quantity& quantity_named(std::string_view key, Owner owner, bool in_plan = false);
/// Adds one, for a program that tells of something of its own. Not while others read the list.
void add_quantity(const Quantity& quantity);

/// Its name in NetCDF, where names of all owners stand side by side: "link_peak_tension", "impact_start", else the key.
[[nodiscard]] std::string file_name(const Quantity& quantity);
/// Whether it is so of a building, or of a contact point of a problem.
[[nodiscard]] bool holds(When when, const Building& building);
[[nodiscard]] bool holds(When when, const PlanBuilding& building);
[[nodiscard]] bool holds(When when, const Problem& problem, const ContactPoint& point);
/// Whether a run tells it of any of these places, or where there are none.
[[nodiscard]] bool is_told_at_any(const Quantity& quantity, const RunView& run,
                                  const std::vector<QuantityPlace>& places);

/// Its value at a place; NaN where there is none.
[[nodiscard]] double value_of(const Quantity& quantity, const RunView& run, const QuantityPlace& place = {});
[[nodiscard]] double value_of(const Quantity& quantity, const PlanRun& run, const QuantityPlace& place = {});
/// Its values at places of one building, or of points or impacts; empty where it is not reported of these.
[[nodiscard]] std::vector<double> values_at(const Quantity& quantity, const PlanRun& run,
                                            const std::vector<QuantityPlace>& places);
/// Whether it is a count, or yes (1) or no.
[[nodiscard]] bool is_whole(const Quantity& quantity);

/// "kgf s-1", as UDUNITS reads it, of "F s-1".
[[nodiscard]] std::string udunits(std::string_view form, const Units& units);
/// A length or force unit as UDUNITS reads it.
[[nodiscard]] std::string udunit(const std::string& unit);
/// A unit of a NetCDF file as one reads it: "cm s-2" is "cm/s²", "kgf s" is "kgf·s", "1000 kgf" is "tf", "gravity" is
/// "g", "1" is "–".
[[nodiscard]] std::string unit_text(const std::string& udunits);
/// The same of a form, "F s-1"; empty for "1".
[[nodiscard]] std::string unit_text(std::string_view form, const Units& units);

/// A column of a table for people.
struct TableColumn {
  std::string label = {}, unit = {};
  std::vector<std::string> cells = {};
  std::vector<double> values = {};  ///< of which column() makes the cells; empty: they are words, or made otherwise
  bool is_words = false;            ///< to be read, not compared
};
/// A column for each quantity of this owner that has a label and is of this table, with a cell for each place. Of
/// buildings in plan what none of the places has is left out, and round-off is shown as 0.
/// @param language 0 English, 1 Indonesian
[[nodiscard]] std::vector<TableColumn> table_columns(Owner owner, const RunView& run,
                                                     const std::vector<QuantityPlace>& places, std::size_t language = 0,
                                                     QuantityTable table = QuantityTable::main);
[[nodiscard]] std::vector<TableColumn> table_columns(Owner owner, const PlanRun& run,
                                                     const std::vector<QuantityPlace>& places, std::size_t language = 0,
                                                     QuantityTable table = QuantityTable::main);
/// The floors of a building, bottom to top.
[[nodiscard]] std::vector<QuantityPlace> floors_of(const Problem& problem, Eigen::Index building);
/// The hinges of a building, in their order, and its columns that can break.
[[nodiscard]] std::vector<QuantityPlace> hinges_of(const Problem& problem, Eigen::Index building);
[[nodiscard]] std::vector<QuantityPlace> breaking_columns_of(const Problem& problem, Eigen::Index building);
/// From the top down, as it stands.
[[nodiscard]] std::vector<QuantityPlace> floors_from_top(const Problem& problem, Eigen::Index building);
/// The first `count` items as places.
[[nodiscard]] std::vector<QuantityPlace> first_places(Eigen::Index count);
/// Those items as places.
[[nodiscard]] std::vector<QuantityPlace> places_of(const std::vector<Eigen::Index>& items);
/// Those that an owner has in a building: its floors, its hinges, …
[[nodiscard]] std::vector<QuantityPlace> places_in(const Problem& problem, Owner owner, Eigen::Index building);

}  // namespace bentur
