#include "text/effort_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bentur/core/number_text.h"
#include "bentur/model/limits.h"
#include "bentur/report/errors.h"
#include "text/table.h"

namespace bentur::cli {
namespace {

constexpr double long_run = 5.0;  // [s] that the work may take before it is said

/// "40 s", "7 min", "3 h": no more is known.
std::string time_text(double seconds, const Words& say) {
  const auto of = [&](const char* unit, double count) { return say(unit, {{"n", fmt::format("{:.3g}", count)}}); };
  if (seconds < 90)
    return of("checked.time.seconds",
              seconds < 10 ? std::round(std::max(seconds, 1.0)) : 10 * std::round(seconds / 10));
  if (seconds < 5400) return of("checked.time.minutes", std::round(seconds / 60));
  if (seconds < 2e5) return of("checked.time.hours", std::round(seconds / 3600));
  return of("checked.time.days", seconds / 86400);
}

template <class AnyProblem>
std::string motion_text(const Case& c, const AnyProblem& problem, const Effort::Fastest& fastest, const Words& say) {
  return fmt::format("{} Hz, {}", number(fastest.frequency),
                     error_words(fastest_source(c, problem, fastest), say.language()));
}

bool same(const Effort::Fastest& a, const Effort::Fastest& b) { return a.frequency == b.frequency; }

template <class AnyProblem>
std::string warning_of(const Case& c, const AnyProblem& problem, const Effort& effort, const Words& say) {
  const double most = std::min(effort.seconds, effort.seconds * c.analysis.limits.steps / effort.most_steps);
  if (most < long_run) return {};
  const double certain = effort.seconds * effort.certain_steps / effort.most_steps;
  return wrapped(say(certain < long_run ? "checked.long_in_contact" : "checked.long",
                     {{"time", time_text(most, say)}, {"motion", motion_text(c, problem, effort.in_contact, say)}}));
}

template <class AnyProblem>
std::string text_of(const Case& c, const AnyProblem& problem, const Effort& effort, const Words& say) {
  std::string text = say("checked.fastest", {{"motion", motion_text(c, problem, effort.apart, say)}});
  if (!same(effort.apart, effort.in_contact)) {
    text += "\n" + say("checked.fastest_in_contact", {{"motion", motion_text(c, problem, effort.in_contact, say)}});
  }
  text +=
      "\n" + say("checked.steps", {{"steps", number(effort.steps)}, {"in_contact", number(effort.steps_in_contact)}});
  if (effort.samples > 0) text += say("checked.samples", {{"samples", number(effort.samples)}});
  text += say("checked.memory", {{"memory", number(std::ceil(effort.memory / 1e6))}}) + "\n";
  if (effort.growing_step > 0 && std::get<RungeKuttaSolver>(c.analysis.solver).step > effort.growing_step) {
    const std::string source = fastest_source(c, problem, effort.apart);
    text += wrapped(say("checked.grows",
                        {{"step", number(effort.growing_step)}, {"source", error_words(source, say.language())}})) +
            "\n";
  }
  const std::string warning = warning_of(c, problem, effort, say);
  return warning.empty() ? text : text + warning + "\n";
}

}  // namespace

std::string effort_text(const Case& c, const Problem& problem, const Effort& effort, const Words& say) {
  return text_of(c, problem, effort, say);
}
std::string effort_text(const Case& c, const PlanProblem& problem, const Effort& effort, const Words& say) {
  return text_of(c, problem, effort, say);
}

std::string long_run_text(const Case& c, const Problem& problem, const Effort& effort, const Words& say) {
  return warning_of(c, problem, effort, say);
}
std::string long_run_text(const Case& c, const PlanProblem& problem, const Effort& effort, const Words& say) {
  return warning_of(c, problem, effort, say);
}

}  // namespace bentur::cli
