#pragma once

#include <cstddef>
#include <deque>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "bentur/core/units.h"
#include "bentur/model/restitution.h"
#include "bentur/pounding/problem.h"
#include "bentur/pounding/response.h"

namespace bentur {

struct Remark;

/// What the values of a quantity belong to: one value for the run, or one each. Bearings are those of plans alone.
enum class Owner { run, building, floor, point, gap, impact, link, hinge, column, bearing };

/// The units in which people are told of a run: by its largest contact force or storey shear.
[[nodiscard]] ShownUnits shown_units(const Units& units, const Response& response);

/// A run as quantities are read from it.
struct RunView {
  RunView(const Problem& p, const Response& r, const Units& u);

  const Problem& problem;
  const Response& response;
  const Units& units;
  const ShownUnits shown;
  const std::vector<Remark>* remarks = nullptr;  ///< of the case and what came out; null: not looked for
  std::vector<PointRestitution> restitutions;    ///< per contact point
};

/// Where a value is: number of the building, point, gap, impact or link, and of the floor, the hinge, or the column
/// that breaks.
struct QuantityPlace {
  Eigen::Index item = 0;
  Eigen::Index floor = 0;
};

/// A list of what storeys that yield do, of the run or of the free response.
struct YieldingSource {
  BuildingPeaks::Yielding BuildingPeaks::*of;
  Eigen::VectorXd BuildingPeaks::Yielding::*list;
};

/// A list of what the infill of a frame did.
struct InfillSource {
  Eigen::VectorXd BuildingPeaks::Infill::*list;
};

/// What the foundation of a building on soil did: its sway (0) or its rocking (1).
struct FoundationSource {
  Eigen::Index entry = 0;
};

/// What a column bears that is struck: as it stands in a response, or computed of it and of what the case says of the
/// contact point.
struct ColumnSource {
  double ColumnPeaks::*kept = nullptr;
  double (*computed)(const ColumnPeaks&, const ContactPoint&) = nullptr;
};

/// Where a value stands in a response, or how it is computed. Only the former is read back from files of results.
using QuantitySource =
    std::variant<Eigen::VectorXd BuildingPeaks::*, YieldingSource, InfillSource, FoundationSource, ColumnSource,
                 double PointSummary::*, int PointSummary::*, std::optional<double> PointSummary::*, double Impact::*,
                 bool Impact::*, double LinkSummary::*, double BuildingPeaks::Hinge::*, int BuildingPeaks::Hinge::*,
                 std::optional<double> BuildingPeaks::Hinge::*, double BuildingPeaks::Breaking::*,
                 std::optional<double> BuildingPeaks::Breaking::*, double (*)(const RunView&, const QuantityPlace&),
                 long (*)(const RunView&, const QuantityPlace&)>;

/// A number that is told of a run. Summary, impact list, histories.nc, the rows of studies and all tables for people
/// are made from the list of these; a new quantity is one line there (docs/result-files.md has them all).
struct Quantity {
  std::string_view key;        ///< its name in every file and in studies
  Owner owner = Owner::run;    ///< what it is one of
  std::string_view units;      ///< as UDUNITS reads them, L for length and F for force: "L s-2"; "1" for none
  std::string_view symbol;     ///< in formulas
  std::string_view long_name;  ///< in words, of one of its owners
  /// Heads its column in tables, English and Indonesian; empty: it is in none.
  std::string_view label[2];
  QuantitySource source;             ///< NaN where there is no such value
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
/// Those of one kind of owner.
[[nodiscard]] std::vector<const Quantity*> quantities_of(Owner owner);
/// The one of this key and owner. @throws InvalidParameter where there is none.
[[nodiscard]] const Quantity& quantity_named(std::string_view key, Owner owner);
/// Adds one, for a program that tells of something of its own. Not while others read the list.
void add_quantity(const Quantity& quantity);

/// Its name in NetCDF, where names of all owners stand side by side: "link_peak_tension", "impact_start", else the key.
[[nodiscard]] std::string file_name(const Quantity& quantity);
/// Whether it is told only of buildings that have storeys that can yield.
[[nodiscard]] bool is_of_yielding(const Quantity& quantity);
/// Whether it is one of those, and told of this building: of a frame with hinges residual drifts alone are.
[[nodiscard]] bool is_of_yielding(const Quantity& quantity, const Building& building);
/// Whether it is told only of buildings that stand on soil.
[[nodiscard]] bool is_of_foundation(const Quantity& quantity);
/// Whether it tells what contact does to floor accelerations and storey shears, which have a table of their own.
[[nodiscard]] bool is_of_forces(const Quantity& quantity);
/// Whether it is told only of frames that have infill.
[[nodiscard]] bool is_of_infill(const Quantity& quantity);
/// Whether it is one of those, and told of this building: what columns bear only where one has a shear capacity.
[[nodiscard]] bool is_of_infill(const Quantity& quantity, const Building& building);
/// Whether it is told only of buildings that have hinges, or of hinges.
[[nodiscard]] bool is_of_hinges(const Quantity& quantity);
/// Whether it is told only of hinges that lose strength.
[[nodiscard]] bool is_of_weakening(const Quantity& quantity);
/// Whether it is told only of columns that can break.
[[nodiscard]] bool is_of_breaking(const Quantity& quantity);
/// Whether it is told only of contact points where a floor strikes a column.
[[nodiscard]] bool is_of_columns(const Quantity& quantity);
/// Whether a quantity of columns has a value at a contact point: a column is struck there and, of demand over capacity,
/// the case says what it bears.
[[nodiscard]] bool column_has(const Quantity& quantity, const Problem& problem, const ContactPoint& point);
/// Whether it is told of item `item` of its owner.
[[nodiscard]] bool is_told(const Quantity& quantity, const RunView& run, Eigen::Index item);
/// The same of any of these places, or where there are none.
[[nodiscard]] bool is_told_at_any(const Quantity& quantity, const RunView& run,
                                  const std::vector<QuantityPlace>& places);

/// Its value at a place; NaN where there is none.
[[nodiscard]] double value_of(const Quantity& quantity, const RunView& run, const QuantityPlace& place = {});
/// Whether it is a count, or yes (1) or no.
[[nodiscard]] bool is_whole(const Quantity& quantity);
/// Whether a response holds it; else it is computed.
[[nodiscard]] bool is_kept(const Quantity& quantity);
/// Puts a value read from a file where it stands in a response; does nothing for one that is computed.
void put_value(const Quantity& quantity, double value, const QuantityPlace& place, Response& response);

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
  std::string label, unit;
  std::vector<std::string> cells;
};
/// A column for each quantity of this owner that has a label, with a cell for each place; without those of yielding,
/// of forces and of struck columns.
/// @param language 0 English, 1 Indonesian
[[nodiscard]] std::vector<TableColumn> table_columns(Owner owner, const RunView& run,
                                                     const std::vector<QuantityPlace>& places,
                                                     std::size_t language = 0);
/// The same of what the storeys of one building do that yield; none where it cannot.
[[nodiscard]] std::vector<TableColumn> yielding_columns(const RunView& run, const std::vector<QuantityPlace>& floors,
                                                        std::size_t language = 0);
/// The same of accelerations and storey shears of one building, with and without contact.
[[nodiscard]] std::vector<TableColumn> force_columns(const RunView& run, const std::vector<QuantityPlace>& floors,
                                                     std::size_t language = 0);
/// The same of columns that are struck, at contact points where they are.
[[nodiscard]] std::vector<TableColumn> struck_column_columns(const RunView& run,
                                                             const std::vector<QuantityPlace>& points,
                                                             std::size_t language = 0);
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

}  // namespace bentur
