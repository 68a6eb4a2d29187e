#include "text/effort_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bentur/core/number_text.h"
#include "bentur/model/limits.h"
#include "text/table.h"

namespace bentur::cli {
namespace {

constexpr double long_run = 5.0;  // [s] that the work may take before it is said

/// "40 s", "7 min", "3 h": no more is known.
std::string time_text(double seconds) {
  if (seconds < 90)
    return fmt::format("{:.0f} s", seconds < 10 ? std::max(seconds, 1.0) : 10 * std::round(seconds / 10));
  if (seconds < 5400) return fmt::format("{:.0f} min", seconds / 60);
  if (seconds < 2e5) return fmt::format("{:.0f} h", seconds / 3600);
  return fmt::format("{:.3g} days", seconds / 86400);
}

bool same(const Effort::Fastest& a, const Effort::Fastest& b) { return a.frequency == b.frequency; }

}  // namespace

std::string effort_text(const Loaded& loaded, const Effort& effort) {
  std::string text = "Fastest: " + fastest_text(loaded.c, loaded.problem, effort.apart);
  if (!same(effort.apart, effort.in_contact)) {
    text += fmt::format("\nFastest in contact: {}", fastest_text(loaded.c, loaded.problem, effort.in_contact));
  }
  text += fmt::format("\nA run takes {} steps, and {} for every second in contact", number(effort.steps),
                      number(effort.steps_in_contact));
  if (effort.samples > 0) text += fmt::format("; histories {} samples", number(effort.samples));
  text += fmt::format("; memory {} MB\n", number(std::ceil(effort.memory / 1e6)));
  if (effort.growing_step > 0 && std::get<RungeKuttaSolver>(loaded.c.analysis.solver).step > effort.growing_step) {
    text += wrapped(fmt::format("warning: with steps over {} s the runge-kutta solver makes {} grow without end",
                                number(effort.growing_step), fastest_source(loaded.c, loaded.problem, effort.apart))) +
            "\n";
  }
  const std::string warning = long_run_text(loaded, effort);
  return warning.empty() ? text : text + warning + "\n";
}

std::string long_run_text(const Loaded& loaded, const Effort& effort) {
  const double most = std::min(effort.seconds, effort.seconds * loaded.c.analysis.limits.steps / effort.most_steps);
  if (most < long_run) return {};
  const double certain = effort.seconds * effort.certain_steps / effort.most_steps;
  return wrapped(fmt::format("This may take up to some {}{}: the fastest motion is {}", time_text(most),
                             certain < long_run ? " if floors stay in contact" : "",
                             fastest_text(loaded.c, loaded.problem, effort.in_contact)));
}

}  // namespace bentur::cli
