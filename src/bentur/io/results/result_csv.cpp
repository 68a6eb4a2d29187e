#include "bentur/io/results/result_csv.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "bentur/model/plan/plan_places.h"

namespace bentur {

std::string csv_heading(const Quantity& quantity, const Units& units) {
  std::string unit = unit_text(quantity.units, units);
  for (std::size_t dot = unit.find("·"); dot != std::string::npos; dot = unit.find("·")) unit.replace(dot, 2, " ");
  return std::string(quantity.key) + (unit.empty() ? "" : " [" + unit + "]");
}

std::string csv_number(double value) { return std::isnan(value) ? "" : fmt::format("{}", value + 0.0); }

std::string csv_field(const std::string& text) {
  const bool is_formula = text.find_first_of("=+-@\t") == 0;
  if (!is_formula && text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = is_formula ? "\"'" : "\"";
  for (const char c : text) {
    quoted += c == '"' ? "\"\"" : std::string(1, c);
  }
  return quoted + "\"";
}

namespace {

/// @param seen where quantities are read from @param places_of the first fields of an impact, as `headings` call them
template <class Seen, class PlacesOf>
std::string csv_of(const Seen& seen, const Units& units, const std::vector<const Quantity*>& columns,
                   const std::string& headings, const PlacesOf& places_of) {
  std::string csv = headings;
  for (const Quantity* const quantity : columns) csv += "," + csv_heading(*quantity, units);
  csv += "\n";
  for (Eigen::Index i = 0; i < std::ssize(seen.response.impacts); ++i) {
    csv += places_of(seen.response.impacts[i].point);
    for (const Quantity* const quantity : columns) csv += "," + csv_number(value_of(*quantity, seen, {i}));
    csv += "\n";
  }
  return csv;
}

}  // namespace

std::string impacts_csv(const RunView& run) {
  const std::string headings = fmt::format("left,right,elevation [{}],struck", run.units.length);
  return csv_of(run, run.units, quantities_of(Owner::impact), headings, [&](Eigen::Index at) {
    const ContactPoint& point = run.problem.points.at(static_cast<std::size_t>(at));
    const std::optional<StruckColumn> struck = struck_column(run.problem, point);
    return fmt::format("{},{},{},{}", csv_field(run.problem.buildings[point.left].name),
                       csv_field(run.problem.buildings[point.right].name), csv_number(point.elevation),
                       struck ? csv_field(run.problem.buildings[struck->building].name) : "");
  });
}

std::string impacts_csv(const PlanRun& run) {
  const std::string headings = fmt::format("left,right,elevation [{0}],x [{0}],y [{0}]", run.c.units.length);
  return csv_of(run, run.c.units, quantities_of(Owner::impact, true), headings, [&](Eigen::Index at) {
    const PlanContactPlace place = contact_at(run.problem, at);
    const PlanGap& gap = run.problem.gaps[place.gap];
    return fmt::format("{},{},{},{},{}", csv_field(run.problem.buildings[gap.left].name),
                       csv_field(run.problem.buildings[gap.right].name), csv_number(place.contact->elevation),
                       csv_number(place.at.x()), csv_number(place.at.y()));
  });
}

}  // namespace bentur
