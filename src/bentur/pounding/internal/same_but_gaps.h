#pragma once

#include <fmt/format.h>

#include <optional>
#include <string>
#include <vector>

#include "bentur/core/errors.h"
#include "bentur/pounding/problem.h"
#include "bentur/solve/system.h"

namespace bentur {

/// What of a system is not that of another: its name, as problems have it, and what it is there.
struct Difference {
  std::string what, value;
};

/// Nothing where both systems are the same but for widths and laws of contacts, motions and duration. At rest is the
/// same with and without saying so.
[[nodiscard]] std::optional<Difference> difference_but_gaps(const System& system, const System& other);

/// Whether the ground moves alike.
[[nodiscard]] bool alike(const std::vector<GroundMotion>& motions, const std::vector<GroundMotion>& others);

/// The same of valid problems, of a row or in plan, whose systems are given.
template <class AnyProblem>
[[nodiscard]] std::optional<Difference> difference_but_gaps(const AnyProblem& problem, const System& free,
                                                            const AnyProblem& other, const System& system) {
  const auto number = [](double value) { return fmt::format("{}", value); };
  if (problem.kinematics != other.kinematics) {
    return Difference{"kinematics", other.kinematics == Kinematics::absolute ? "absolute" : "relative"};
  }
  if (problem.duration != other.duration) return Difference{"duration", number(other.duration)};
  if (problem.goes_on != other.goes_on) return Difference{"goes_on", fmt::format("{}", other.goes_on)};
  if (problem.collapse_drift != other.collapse_drift) return Difference{"collapse_drift", number(other.collapse_drift)};
  if (!alike(free.motions, system.motions)) return Difference{"motion", "another one"};
  return difference_but_gaps(free, system);
}

/// @throws InvalidParameter where there is one
inline void require_none(const std::optional<Difference>& found) {
  if (found) throw InvalidParameter(found->what, found->value, "must be that of the free response");
}

}  // namespace bentur
