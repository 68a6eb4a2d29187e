#include "bentur/model/limits.h"

#include <fmt/format.h>

#include <cmath>

#include "bentur/core/number_text.h"

namespace bentur {

std::string fastest_source(const Case& c, const Problem& problem, const Effort::Fastest& fastest) {
  using By = Effort::Fastest::By;
  switch (fastest.by) {
    case By::motion:
      return "the ground motion";
    case By::damping:
      return fmt::format("the damping of {}", problem.buildings[fastest.building].name);
    case By::contact: {
      const ContactPoint& point = problem.points[fastest.point];
      return fmt::format("the contact of {} at level {} {}", gap_name(problem, point.gap), number(point.elevation),
                         c.units.length);
    }
    case By::mode:
      break;
  }
  return fmt::format("mode {} of {}", fastest.mode + 1, problem.buildings[fastest.building].name);
}

namespace {

/// "35296 Hz, mode 3 of A".
std::string fastest_text(const Case& c, const Problem& problem, const Effort::Fastest& fastest) {
  return fmt::format("{} Hz, {}", number(fastest.frequency), fastest_source(c, problem, fastest));
}

/// @param why what makes it so many steps, as a sentence before a space
template <class Why>
std::string beyond(const LimitsSpec& limits, const Effort& effort, const Why& why) {
  if (effort.certain_steps > limits.steps) {
    return fmt::format(
        "a run takes {:.3g} steps or more, over the limit of {:.3g}. {}Is that meant? [analysis] limits = {{ steps = "
        "{:.1e} }} lets it run",
        effort.certain_steps, limits.steps, why(), 2 * effort.most_steps);
  }
  if (effort.memory > 1e6 * limits.memory) {
    const double of_histories = effort.memory - effort.memory_of_steps;
    const bool histories = effort.samples > 0 && of_histories > effort.memory_of_steps;
    return fmt::format(
        "a run takes {:.3g} MB of memory, over the limit of {:.3g}: {:.3g} MB for what is kept of the motion and of "
        "{:.3g} "
        "steps, {:.3g} MB for the program and histories of {:.3g} samples. Make {}duration shorter, or let it run with "
        "[analysis] limits = {{ memory = {:.0f} }}",
        effort.memory / 1e6, limits.memory, effort.memory_of_steps / 1e6, effort.steps, of_histories / 1e6,
        effort.samples, histories ? "output_step larger or " : "", std::ceil(effort.memory / 1e6));
  }
  return {};
}

}  // namespace

std::string beyond_limits(const Case& c, const Problem& problem, const Effort& effort) {
  return beyond(c.analysis.limits, effort,
                [&] { return fmt::format("The fastest motion is {}. ", fastest_text(c, problem, effort.apart)); });
}

std::string beyond_limits(const Case& c, const PlanProblem& /*problem*/, const Effort& effort) {
  return beyond(c.analysis.limits, effort, [] { return ""; });
}

}  // namespace bentur
