#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bentur/core/number_text.h"
#include "bentur/report/html/internal/sections.h"

namespace bentur::html {
namespace {

/// What the sentence about the worst column names: the one nearest to what it bears, else the one with the largest
/// shear.
Eigen::Index worst_of(const Report& report, const std::vector<Eigen::Index>& points) {
  const auto demand = [&](Eigen::Index i) {
    const double ratio = value_of(quantity_named("column_demand_capacity", Owner::point), report.run, {i, 0});
    const std::optional<ColumnPeaks>& column = report.response.points[i].column;
    return std::pair{std::isnan(ratio) ? 0.0 : ratio, column ? column->shear : 0.0};
  };
  return *std::max_element(points.begin(), points.end(),
                           [&](Eigen::Index a, Eigen::Index b) { return demand(a) < demand(b); });
}

Html lead(const Report& report, const std::vector<Eigen::Index>& points) {
  const Words& say = report.say;
  const Eigen::Index i = worst_of(report, points);
  const ColumnPeaks column = report.response.points[i].column.value_or(ColumnPeaks{});
  const StruckColumn struck = struck_column(report.problem, report.problem.points[i]).value();
  std::string text =
      say("columns.worst", {{"building", report.problem.buildings[struck.building].name},
                            {"elevation", quantity(report.problem.points[i].elevation, report.c.units.length)},
                            {"shear", force_text(report, column.shear, "F")},
                            {"shear_without", force_text(report, column.shear_no_contact, "F")},
                            {"moment", force_text(report, column.moment, "F L")},
                            {"moment_without", force_text(report, column.moment_no_contact, "F L")}});
  const double ratio = value_of(quantity_named("column_demand_capacity", Owner::point), report.run, {i, 0});
  if (!std::isnan(ratio)) {
    text += " " + say(ratio > 1 ? "columns.fails" : "columns.holds", {{"ratio", fmt::format("{:.2f}", ratio)}});
  }
  return element("p", Html::text(text), "class=\"lead\"");
}

}  // namespace

std::vector<Eigen::Index> struck_points(const Problem& problem) {
  std::vector<Eigen::Index> points;
  for (Eigen::Index i = std::ssize(problem.points); i-- > 0;) {
    if (struck_column(problem, problem.points[i])) points.push_back(i);
  }
  return points;
}

std::string struck_text(const Report& report, Eigen::Index point) {
  const std::optional<StruckColumn> struck = struck_column(report.problem, report.problem.points[point]);
  return struck ? report.say("columns.of", {{"building", report.problem.buildings[struck->building].name}})
                : report.say("columns.floor");
}

PageSection columns_section(const Report& report) {
  const std::vector<Eigen::Index> points = struck_points(report.problem);
  if (points.empty()) return {};
  const Words& say = report.say;
  std::vector<std::string> gaps, struck, times;
  std::vector<double> elevations;
  for (const Eigen::Index i : points) {
    const ContactPoint& point = report.problem.points[i];
    const std::optional<double>& hardest = report.response.points[i].peak_force_time;
    gaps.push_back(gap_name(report.problem, point.gap));
    struck.push_back(report.problem.buildings[struck_column(report.problem, point)->building].name);
    elevations.push_back(point.elevation);
    times.push_back(hardest ? fmt::format("{:.3f}", *hardest) : "–");
  }
  HtmlTable table;
  if (report.problem.buildings.size() > 2) table.add(say("column.gap"), "", gaps, false);
  table.add(say("column.elevation"), report.c.units.length, elevations);
  table.add(say("columns.struck"), "", struck, false);
  table.add(say("columns.hardest"), "s", times);
  add_columns(table, table_columns(Owner::point, report.run, places_of(points), say.number(), QuantityTable::struck));
  return {"columns", say("heading.columns"),
          lead(report, points) + table.called(say("columns.table")).markup() +
              element("p", Html::text(say("columns.note")), "class=\"note\"")};
}

}  // namespace bentur::html
