#include "bentur/model/limits.h"

#include <fmt/format.h>

#include <cmath>

#include "bentur/core/number_text.h"
#include "bentur/model/plan/plan_places.h"

namespace bentur {

namespace {

/// The gap of a contact by name, and its level [length].
std::pair<std::string, double> place_of_contact(const Problem& problem, Eigen::Index point) {
  const ContactPoint& at = problem.points.at(point);
  return {gap_name(problem, at.gap), at.elevation};
}
std::pair<std::string, double> place_of_contact(const PlanProblem& problem, Eigen::Index point) {
  const PlanContactPlace at = contact_at(problem, point);
  return {gap_name(problem, problem.gaps[at.gap]), at.contact->elevation};
}

template <class AnyProblem>
std::string source_of(const Case& c, const AnyProblem& problem, const Effort::Fastest& fastest) {
  using By = Effort::Fastest::By;
  switch (fastest.by) {
    case By::motion:
      return "the ground motion";
    case By::damping:
      return fmt::format("the damping of {}", problem.buildings[fastest.building].name);
    case By::contact: {
      const auto [gap, elevation] = place_of_contact(problem, fastest.point);
      return fmt::format("the contact of {} at level {} {}", gap, number(elevation), c.units.length);
    }
    case By::mode:
      break;
  }
  return fmt::format("mode {} of {}", fastest.mode + 1, problem.buildings[fastest.building].name);
}

template <class AnyProblem>
std::string beyond(const Case& c, const AnyProblem& problem, const Effort& effort) {
  const LimitsSpec& limits = c.analysis.limits;
  if (effort.certain_steps > limits.steps) {
    return fmt::format(
        "a run takes {:.3g} steps or more, over the limit of {:.3g}. The fastest motion is {} Hz, {}. Is that meant? "
        "[analysis] limits = {{ steps = "
        "{:.1e} }} lets it run",
        effort.certain_steps, limits.steps, number(effort.apart.frequency), source_of(c, problem, effort.apart),
        2 * effort.most_steps);
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

std::string fastest_source(const Case& c, const Problem& problem, const Effort::Fastest& fastest) {
  return source_of(c, problem, fastest);
}
std::string fastest_source(const Case& c, const PlanProblem& problem, const Effort::Fastest& fastest) {
  return source_of(c, problem, fastest);
}

std::string beyond_limits(const Case& c, const Problem& problem, const Effort& effort) {
  return beyond(c, problem, effort);
}
std::string beyond_limits(const Case& c, const PlanProblem& problem, const Effort& effort) {
  return beyond(c, problem, effort);
}

}  // namespace bentur
