#include "bentur/report/run_tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "bentur/core/number_text.h"
#include "bentur/model/plan/plan_places.h"
#include "bentur/model/run_results.h"
#include "bentur/report/scene/names.h"

namespace bentur {
namespace {

using Eigen::Index;
using Indices = std::vector<Index>;

/// Writes columns in words of one language.
class Columns {
 public:
  Columns(const Units& units, const Words& say) : units_(units), say_(say) {}

  void add(std::string label, std::string unit, std::vector<double> values) {
    std::vector<std::string> cells = column(values);
    columns_.push_back({std::move(label), std::move(unit), std::move(cells), std::move(values)});
  }
  void add_length(std::string label, std::vector<double> values) {
    add(std::move(label), units_.length, std::move(values));
  }
  void add_words(std::string label, std::vector<std::string> cells) {
    columns_.push_back({.label = std::move(label), .cells = std::move(cells), .is_words = true});
  }
  void add_level(std::vector<double> levels) { add_length(say_("column.elevation"), std::move(levels)); }
  void add(TableColumn column) { columns_.push_back(std::move(column)); }
  /// @param at places in plan [length]
  void add_plan(const std::vector<PlanPoint>& at) {
    std::vector<double> x, y;
    for (const PlanPoint& one : at) {
      x.push_back(one.x());
      y.push_back(one.y());
    }
    add_length("x", std::move(x));
    add_length("y", std::move(y));
  }
  /// @return the table of these and what is given, which may be none
  [[nodiscard]] RunTable with(std::vector<TableColumn> quantities, std::vector<QuantityPlace> places) && {
    if (quantities.empty()) return {};
    std::move(quantities.begin(), quantities.end(), std::back_inserter(columns_));
    return {std::move(columns_), std::move(places)};
  }

 private:
  const Units& units_;
  const Words& say_;
  std::vector<TableColumn> columns_;
};

// What rows and buildings in plan have each of their own: where things are.

Indices points_from_top(const Problem& problem, std::size_t gap) {
  const Gap of = gap_at(problem, static_cast<Index>(gap));
  return {of.points.rbegin(), of.points.rend()};
}

Indices points_from_top(const PlanProblem& problem, std::size_t gap) {
  Indices points;
  for (Index i = 0; i < std::ssize(problem.gaps[gap].contacts); ++i) points.push_back(first_contact(problem, gap) + i);
  std::stable_sort(points.begin(), points.end(), [&](Index a, Index b) {
    return contact_at(problem, a).contact->elevation > contact_at(problem, b).contact->elevation;
  });
  return points;
}

template <class AnyProblem>
Indices all_points(const AnyProblem& problem) {
  Indices points;
  for (std::size_t gap = 0; gap < gap_names(problem).size(); ++gap) {
    const Indices of_gap = points_from_top(problem, gap);
    points.insert(points.end(), of_gap.begin(), of_gap.end());
  }
  return points;
}

void add_contacts(const Problem& problem, const Indices& points, Columns& columns) {
  std::vector<double> levels;
  for (const Index i : points) levels.push_back(problem.points[i].elevation);
  columns.add_level(std::move(levels));
}

void add_contacts(const PlanProblem& problem, const Indices& points, Columns& columns) {
  std::vector<double> levels;
  std::vector<PlanPoint> at;
  for (const Index i : points) {
    const PlanContactPlace place = contact_at(problem, i);
    levels.push_back(place.contact->elevation);
    at.push_back(place.at);
  }
  columns.add_level(std::move(levels));
  columns.add_plan(at);
}

void add_links(const Problem& problem, const Indices& links, const Words& /*say*/, Columns& columns) {
  std::vector<double> levels;
  for (const Index i : links) levels.push_back(problem.links.at(i).elevation);
  columns.add_level(std::move(levels));
}

void add_links(const PlanProblem& problem, const Indices& links, const Words& say, Columns& columns) {
  std::vector<double> levels;
  std::vector<PlanPoint> at;
  std::vector<std::string> along;
  for (const Index i : links) {
    const PlanLink& link = problem.links.at(i);
    levels.push_back(link.link.elevation);
    at.push_back(link.stretch.middle(link.along));
    along.push_back(link_along(link));
  }
  columns.add_level(std::move(levels));
  columns.add_plan(at);
  columns.add_words(say("column.along"), std::move(along));
}

std::optional<StruckColumn> struck_at(const Problem& problem, Index point) {
  return struck_column(problem, problem.points[point]);
}

std::optional<StruckColumn> struck_at(const PlanProblem& problem, Index point) {
  const PlanContactPlace place = contact_at(problem, point);
  return struck_column(problem, problem.gaps[place.gap], *place.contact);
}

RunTable bearing_table(const RunView& /*run*/, const Units& /*units*/, Index /*building*/, const Words& /*say*/) {
  return {};  // those of a row are the storey below its slab
}

RunTable bearing_table(const PlanRun& run, const Units& units, Index building, const Words& say) {
  const PlanModel& model = run.problem.buildings[building].model;
  std::vector<QuantityPlace> places = bearings_of(run.problem, building);
  if (places.empty()) return {};
  std::vector<PlanPoint> at;
  for (const PlanModel::Bearing& one : model.bearings) at.emplace_back(model.footprint.corner + one.at);
  Columns columns(units, say);
  columns.add_plan(at);
  std::vector<TableColumn> quantities = table_columns(Owner::bearing, run, places, say.number());
  return std::move(columns).with(std::move(quantities), std::move(places));
}

RunTable plane_table(const RunView& /*run*/, const Units& /*units*/, Index /*building*/, const Words& /*say*/) {
  return {};
}

RunTable plane_table(const PlanRun& run, const Units& units, Index building, const Words& say) {
  const PlanModel& model = run.problem.buildings[building].model;
  std::vector<QuantityPlace> places = planes_from_top(run.problem, building);
  if (places.empty()) return {};
  std::vector<std::string> names;
  std::vector<double> levels;
  for (const QuantityPlace& place : places) {
    names.push_back(model.planes[place.plane].name);
    levels.push_back(model.elevations[place.floor]);
  }
  Columns columns(units, say);
  columns.add_words(say("column.plane"), std::move(names));
  columns.add_level(std::move(levels));
  std::vector<TableColumn> quantities = table_columns(Owner::plane, run, places, say.number());
  return std::move(columns).with(std::move(quantities), std::move(places));
}

const Units& units_of(const RunView& run) { return run.units; }
const Units& units_of(const PlanRun& run) { return run.c.units; }

constexpr bool is_in_plan(const RunView& /*run*/) { return false; }
constexpr bool is_in_plan(const PlanRun& /*run*/) { return true; }

GapPair sides_at(const Problem& problem, Index point) { return sides_of(problem, problem.points.at(point).gap); }

GapPair sides_at(const PlanProblem& problem, Index point) {
  const PlanGap& gap = problem.gaps[contact_at(problem, point).gap];
  return {gap.left, gap.right};
}

// What they have alike.

template <class Run>
RunTable point_table(const Run& run, const Units& units, const Indices& points, const Words& say) {
  std::vector<QuantityPlace> places = places_of(points);
  Columns columns(units, say);
  add_contacts(run.problem, points, columns);
  std::vector<TableColumn> quantities =
      without_losses(table_columns(Owner::point, run, places, say.number()), Owner::point, run.response.points, say);
  return std::move(columns).with(std::move(quantities), std::move(places));
}

/// Which column a floor strikes, when it does so the hardest, and what that column bears.
template <class Run>
RunTable struck_table(const Run& run, const Units& units, const std::vector<std::string>& gaps, const Words& say) {
  Indices points;
  std::vector<std::string> between, struck, times;
  for (std::size_t gap = 0; gap < gaps.size(); ++gap) {
    for (const Index point : points_from_top(run.problem, gap)) {
      const std::optional<StruckColumn> column = struck_at(run.problem, point);
      if (!column) continue;
      const std::optional<double>& hardest = run.response.points[point].peak_force_time;
      points.push_back(point);
      between.push_back(gaps[gap]);
      struck.push_back(run.problem.buildings[column->building].name);
      times.push_back(hardest ? fmt::format("{:.3f}", *hardest) : "–");
    }
  }
  if (points.empty()) return {};
  std::vector<QuantityPlace> places = places_of(points);
  Columns columns(units, say);
  if (gaps.size() > 1) columns.add_words(say("column.gap"), std::move(between));
  add_contacts(run.problem, points, columns);
  columns.add_words(say("columns.struck"), std::move(struck));
  std::vector<TableColumn> quantities = table_columns(Owner::point, run, places, say.number(), QuantityTable::struck);
  quantities.insert(quantities.begin(), {.label = say("columns.hardest"), .unit = "s", .cells = std::move(times)});
  return std::move(columns).with(std::move(quantities), std::move(places));
}

template <class Run>
BuildingTables building_tables(const Run& run, const Units& units, Index b, const Words& say) {
  const auto& building = run.problem.buildings[b];
  std::vector<QuantityPlace> floors = floors_of(run.problem, b);
  std::reverse(floors.begin(), floors.end());
  const std::vector<double>& levels = building.model.elevations;
  const auto of_floors = [&](QuantityTable table) {
    Columns columns(units, say);
    columns.add_level({levels.rbegin(), levels.rend()});
    return std::move(columns).with(table_columns(Owner::floor, run, floors, say.number(), table), floors);
  };
  const std::vector<QuantityPlace> itself = {{.item = b}};
  return {.building = building.name,
          .moves_with_ground = building.is_rigid(),
          .floors = of_floors(QuantityTable::main),
          .forces = of_floors(QuantityTable::forces),
          .yielding = of_floors(QuantityTable::yielding),
          .foundation = Columns(units, say).with(table_columns(Owner::building, run, itself, say.number()), itself),
          .bearings = bearing_table(run, units, b, say),
          .planes = plane_table(run, units, b, say)};
}

template <class Run>
RunTable impacts_of(const Run& run, const Indices& impacts, const Words& say) {
  std::vector<std::string> names;
  for (const auto& building : run.problem.buildings) names.push_back(building.name);
  const std::vector<std::string> in_short = short_names(names);
  const std::vector<std::string>& called = are_parts_of(in_short, names) ? in_short : names;
  std::vector<std::string> numbers, gaps, struck;
  Indices points;
  for (const Index k : impacts) {
    const Index point = run.response.impacts.at(static_cast<std::size_t>(k)).point;
    const GapPair sides = sides_at(run.problem, point);
    const std::optional<StruckColumn> column = struck_at(run.problem, point);
    numbers.push_back(std::to_string(k + 1));
    gaps.push_back(called.at(sides.left) + "\u00A0|\u00A0" + called.at(sides.right));
    struck.push_back(column ? say("columns.of", {{"building", names.at(column->building)}}) : say("columns.floor"));
    points.push_back(point);
  }
  std::vector<QuantityPlace> places = places_of(impacts);
  std::vector<TableColumn> quantities =
      without_losses(table_columns(Owner::impact, run, places, say.number()), Owner::impact, run.response.points, say);
  Columns columns(units_of(run), say);
  columns.add({.label = "#", .cells = std::move(numbers)});
  if (gap_names(run.problem).size() > 1) columns.add_words(say("column.gap"), std::move(gaps));
  for (const char* const key : {"peak_force", "peak_force_time"}) {
    const std::string_view name = quantity_named(key, Owner::impact, is_in_plan(run)).label[say.number()];
    const auto first =
        std::find_if(quantities.begin(), quantities.end(), [&](const TableColumn& one) { return one.label == name; });
    if (first == quantities.end()) continue;
    columns.add(std::move(*first));
    quantities.erase(first);
  }
  add_contacts(run.problem, points, columns);
  const auto is_struck = [&](Index point) { return struck_at(run.problem, point).has_value(); };
  const Indices all = all_points(run.problem);
  if (std::any_of(all.begin(), all.end(), is_struck)) columns.add_words(say("columns.struck"), std::move(struck));
  return std::move(columns).with(std::move(quantities), std::move(places));
}

template <class Run>
RunTables tables_of(const Run& run, const Case& c, const Words& say) {
  RunTables all;
  const std::vector<std::string> gaps = gap_names(run.problem);
  for (std::size_t gap = 0; gap < gaps.size(); ++gap) {
    const Indices points = points_from_top(run.problem, gap);
    if (!points.empty()) all.contacts.push_back({gaps[gap], point_table(run, c.units, points, say)});
  }
  all.struck = struck_table(run, c.units, gaps, say);
  const std::vector<Indices> links = links_by_spec(c.links);
  for (std::size_t spec = 0; spec < links.size(); ++spec) {
    if (links[spec].empty()) continue;
    const Indices from_top(links[spec].rbegin(), links[spec].rend());
    std::vector<QuantityPlace> places = places_of(from_top);
    Columns columns(c.units, say);
    add_links(run.problem, from_top, say, columns);
    std::vector<TableColumn> quantities = table_columns(Owner::link, run, places, say.number());
    all.links.push_back({link_name(run.problem, run.problem.links.at(from_top.front())), c.links[spec].law,
                         std::move(columns).with(std::move(quantities), std::move(places))});
  }
  for (Index b = 0; b < std::ssize(run.problem.buildings); ++b) {
    all.buildings.push_back(building_tables(run, c.units, b, say));
  }
  return all;
}

}  // namespace

RunTables run_tables(const RunView& run, const Case& c, const Words& say) { return tables_of(run, c, say); }

RunTables run_tables(const PlanRun& run, const Words& say) { return tables_of(run, run.c, say); }

RunTable impact_table(const RunView& run, const Indices& impacts, const Words& say) {
  return impacts_of(run, impacts, say);
}

RunTable impact_table(const PlanRun& run, const Indices& impacts, const Words& say) {
  return impacts_of(run, impacts, say);
}

bool is_elastic(const std::vector<PointSummary>& points) {
  constexpr double round_off = 1e-9;
  const auto loses_nothing = [](const PointSummary& one) {
    return std::abs(one.energy_lost) <= round_off * one.peak_force * one.peak_penetration;
  };
  return std::any_of(points.begin(), points.end(), [](const PointSummary& one) { return one.impacts > 0; }) &&
         std::all_of(points.begin(), points.end(), loses_nothing);
}

std::vector<TableColumn> without_losses(std::vector<TableColumn> columns, Owner owner,
                                        const std::vector<PointSummary>& points, const Words& say) {
  const std::string_view lost = quantity_named("energy_lost", owner).label[say.number()];
  if (is_elastic(points)) std::erase_if(columns, [&](const TableColumn& one) { return one.label == lost; });
  return columns;
}

}  // namespace bentur
