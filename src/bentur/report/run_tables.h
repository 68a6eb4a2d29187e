#pragma once

#include <string>
#include <vector>

#include "bentur/model/plan/plan_run.h"
#include "bentur/model/quantities.h"
#include "bentur/report/words.h"

// The numbers of a run as people are shown them, of rows and of buildings in plan: terminal, report and studio write
// what stands here.
namespace bentur {

/// Where each row is, then its quantities.
struct RunTable {
  std::vector<TableColumn> columns = {};   ///< of one length; none: there is no such table
  std::vector<QuantityPlace> places = {};  ///< one per row

  [[nodiscard]] bool is_empty() const { return columns.empty(); }
  /// The rows of which `keeps` is true, with all columns.
  template <class Keeps>
  [[nodiscard]] RunTable where(const Keeps& keeps) const;
};

/// Of a gap with contact points, from the top down.
struct ContactTable {
  std::string gap;  ///< "A – B"
  RunTable points;
};

/// Of one [[link]] table, from the top down.
struct LinkTable {
  std::string link;  ///< "A – B"
  std::string law;
  RunTable links;
};

/// Of a building, from the top down; storeys by the floor above them.
struct BuildingTables {
  std::string building;
  bool moves_with_ground = false;
  RunTable floors;      ///< movements and drifts
  RunTable forces;      ///< accelerations and storey shears
  RunTable yielding;    ///< of storeys that can yield
  RunTable foundation;  ///< of a building on soil
  RunTable bearings;    ///< below a slab, of a building in plan
  RunTable planes;      ///< of a building in plan
};

struct RunTables {
  std::vector<ContactTable> contacts;
  RunTable struck;  ///< columns that floors strike, gap after gap
  std::vector<LinkTable> links;
  std::vector<BuildingTables> buildings;
};

/// Of a row, with the case that it is of.
[[nodiscard]] RunTables run_tables(const RunView& run, const Case& c, const Words& say);
/// Of buildings in plan; where contacts are has x and y, too.
[[nodiscard]] RunTables run_tables(const PlanRun& run, const Words& say);

/// Impacts by their places in the response, in that order: its number from 1, of several gaps which, how hard and when,
/// where, then all else.
[[nodiscard]] RunTable impact_table(const RunView& run, const std::vector<Eigen::Index>& impacts, const Words& say);
[[nodiscard]] RunTable impact_table(const PlanRun& run, const std::vector<Eigen::Index>& impacts, const Words& say);

/// Whether there was contact, and none lost more energy than round-off.
[[nodiscard]] bool is_elastic(const std::vector<PointSummary>& points);
/// Columns of contact, without what it loses where it loses nothing. @param owner point or impact
[[nodiscard]] std::vector<TableColumn> without_losses(std::vector<TableColumn> columns, Owner owner,
                                                      const std::vector<PointSummary>& points, const Words& say);

template <class Keeps>
RunTable RunTable::where(const Keeps& keeps) const {
  RunTable kept;
  for (const TableColumn& column : columns) {
    kept.columns.push_back({.label = column.label, .unit = column.unit, .is_words = column.is_words});
  }
  for (std::size_t row = 0; row < places.size(); ++row) {
    if (!keeps(places[row])) continue;
    kept.places.push_back(places[row]);
    for (std::size_t i = 0; i < columns.size(); ++i) {
      kept.columns[i].cells.push_back(columns[i].cells[row]);
      if (!columns[i].values.empty()) kept.columns[i].values.push_back(columns[i].values[row]);
    }
  }
  return kept;
}

}  // namespace bentur
