#include "text/effort_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bentur/core/number_text.h"
#include "text/table.h"

namespace bentur::cli {
namespace {

constexpr double long_run = 5.0;  // [s] that the work may take before it is said

/// "mode 3 of "A"".
std::string source_text(const Loaded& loaded, const Effort::Fastest& fastest) {
  const Problem& problem = loaded.problem;
  using By = Effort::Fastest::By;
  switch (fastest.by) {
    case By::motion:
      return "the ground motion";
    case By::damping:
      return fmt::format("the damping of {}", problem.buildings[fastest.building].name);
    case By::contact: {
      const ContactPoint& point = problem.points[fastest.point];
      return fmt::format("the contact of {} at elevation {} {}", gap_name(problem, point.left), number(point.elevation),
                         loaded.c.units.length);
    }
    case By::mode:
      break;
  }
  return fmt::format("mode {} of {}", fastest.mode + 1, problem.buildings[fastest.building].name);
}

std::string fastest_text(const Loaded& loaded, const Effort::Fastest& fastest) {
  return fmt::format("{} Hz, {}", number(fastest.frequency), source_text(loaded, fastest));
}

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
  std::string text = "Fastest: " + fastest_text(loaded, effort.apart);
  if (!same(effort.apart, effort.in_contact)) {
    text += fmt::format("\nFastest in contact: {}", fastest_text(loaded, effort.in_contact));
  }
  text += fmt::format("\nA run takes {} steps, and {} for every second in contact", number(effort.steps),
                      number(effort.steps_in_contact));
  if (effort.samples > 0) text += fmt::format("; histories {} samples", number(effort.samples));
  text += fmt::format("; memory {} MB\n", number(std::ceil(effort.memory / 1e6)));
  if (effort.growing_step > 0 && std::get<RungeKuttaSolver>(loaded.c.analysis.solver).step > effort.growing_step) {
    text += wrapped(fmt::format("warning: with steps over {} s the runge-kutta solver makes {} grow without end",
                                number(effort.growing_step), source_text(loaded, effort.apart))) +
            "\n";
  }
  const std::string warning = long_run_text(loaded, effort);
  return warning.empty() ? text : text + warning + "\n";
}

std::string beyond_limits(const Loaded& loaded, const Effort& effort) {
  const LimitsSpec& limits = loaded.c.analysis.limits;
  if (effort.certain_steps > limits.steps) {
    return fmt::format(
        "a run takes {:.3g} steps or more, over the limit of {:.3g}. The fastest motion is {}. "
        "Is that meant? [analysis] limits = {{ steps = {:.1e} }} lets it run",
        effort.certain_steps, limits.steps, fastest_text(loaded, effort.apart), 2 * effort.most_steps);
  }
  if (effort.memory > 1e6 * limits.memory) {
    return fmt::format(
        "a run takes {:.3g} MB of memory, over the limit of {:.3g}, for {:.3g} steps and histories of "
        "{:.3g} samples. Make output_step larger or duration shorter, or let it run with [analysis] "
        "limits = {{ memory = {:.0f} }}",
        effort.memory / 1e6, limits.memory, effort.steps, effort.samples, std::ceil(effort.memory / 1e6));
  }
  return {};
}

std::string long_run_text(const Loaded& loaded, const Effort& effort) {
  const double most = std::min(effort.seconds, effort.seconds * loaded.c.analysis.limits.steps / effort.most_steps);
  if (most < long_run) return {};
  const double certain = effort.seconds * effort.certain_steps / effort.most_steps;
  return wrapped(fmt::format("This may take up to some {}{}: the fastest motion is {}", time_text(most),
                             certain < long_run ? " if floors stay in contact" : "",
                             fastest_text(loaded, effort.in_contact)));
}

}  // namespace bentur::cli
