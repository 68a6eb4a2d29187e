#pragma once

#include <optional>
#include <string>

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

}  // namespace bentur
