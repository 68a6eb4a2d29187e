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
                       field(problem.buildings[left + 1].name), point.elevation, impact.start, impact.end,
                       impact.open_ended ? 1 : 0, impact.closing_speed, impact.separation_speed,
                       restitution ? fmt::format("{}", *restitution) : "", impact.peak_force, impact.peak_force_time,
                       impact.peak_penetration, impact.impulse, impact.energy_lost, impact.peak_tension);
  }
  return csv;
}

}  // namespace bentur
