#include "bentur/io/results/result_csv.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

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

std::string impacts_csv(const RunView& run) {
  const std::vector<const Quantity*> columns = quantities_of(Owner::impact);
  std::string csv = fmt::format("left,right,elevation [{}],struck", run.units.length);
  for (const Quantity* quantity : columns) csv += "," + csv_heading(*quantity, run.units);
  csv += "\n";
  for (Eigen::Index i = 0; i < std::ssize(run.response.impacts); ++i) {
    const ContactPoint& point = run.problem.points.at(static_cast<std::size_t>(run.response.impacts[i].point));
    const std::optional<StruckColumn> struck = struck_column(run.problem, point);
    csv += fmt::format("{},{},{},{}", csv_field(run.problem.buildings[point.left].name),
                       csv_field(run.problem.buildings[point.right].name), csv_number(point.elevation),
                       struck ? csv_field(run.problem.buildings[struck->building].name) : "");
    for (const Quantity* quantity : columns) csv += "," + csv_number(value_of(*quantity, run, {i, 0}));
    csv += "\n";
  }
  return csv;
}

}  // namespace bentur
