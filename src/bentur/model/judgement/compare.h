#pragma once

#include <cmath>
#include <optional>

namespace bentur {

/// Whether what is needed goes beyond what is given by more than round-off [length]. Of what is needed of a gap judge()
/// (judge.h) alone asks that, and those who find the level that governs.
/// @param scale of the displacements that the need is the difference of [length]
[[nodiscard]] bool is_below_target(double given, double needed, double scale);

/// A need, or 0 where it is nothing but round-off [length].
[[nodiscard]] inline double without_round_off(double need, double scale) {
  return is_below_target(0, need, scale) ? need : 0;
}

/// Whether what may still come after the end of a run asks for more than is given, or than has been needed so far, by
/// more than round-off. @param to_come what it may need in all [length]; nothing: the buildings come to rest
[[nodiscard]] inline bool more_may_come(const std::optional<double>& to_come, double than, double scale) {
  return to_come && is_below_target(than, *to_come, scale);
}
/// Whether nothing bounds what may come, as where a motion goes on.
[[nodiscard]] inline bool comes_without_bound(const std::optional<double>& to_come) {
  return to_come && std::isinf(*to_come);
}

}  // namespace bentur
