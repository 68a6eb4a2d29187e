#include "bentur/io/results/result_csv.h"

#include <fmt/format.h>

#include <cstddef>
#include <optional>

namespace bentur {
namespace {

/// A text field, quoted where it must be.
std::string field(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) {
    return text;
  }
  std::string quoted = "\"";
  for (const char c : text) {
    quoted += c == '"' ? "\"\"" : std::string(1, c);
  }
  return quoted + "\"";
}

/// A number to its last digit, without the sign of a zero.
std::string csv_number(double value) { return fmt::format("{}", value + 0.0); }

}  // namespace

std::string impacts_csv(const Units& units, const Problem& problem, const Response& response) {
  const std::string& length = units.length;
  const std::string& force = units.force;
  std::string csv = fmt::format(
      "left,right,elevation [{0}],start [s],end [s],open_ended,closing_speed [{0}/s],separation_speed [{0}/s],"
      "restitution,peak_force [{1}],peak_force_time [s],peak_penetration [{0}],impulse [{1} s],energy_lost [{1} {0}],"
      "peak_tension [{1}]\n",
      length, force);
  for (const Impact& impact : response.impacts) {
    const ContactPoint& point = problem.points.at(static_cast<std::size_t>(impact.point));
    const auto left = static_cast<std::size_t>(point.left);
    const std::optional<double> restitution = impact.restitution();
    csv += fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n", field(problem.buildings[left].name),
                       field(problem.buildings[left + 1].name), csv_number(point.elevation), csv_number(impact.start),
                       csv_number(impact.end), impact.open_ended ? 1 : 0, csv_number(impact.closing_speed),
                       csv_number(impact.separation_speed), restitution ? csv_number(*restitution) : "",
                       csv_number(impact.peak_force), csv_number(impact.peak_force_time),
                       csv_number(impact.peak_penetration), csv_number(impact.impulse), csv_number(impact.energy_lost),
                       csv_number(impact.peak_tension));
  }
  return csv;
}

}  // namespace bentur
