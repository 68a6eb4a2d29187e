#pragma once

namespace bentur {

/// Whether what is needed goes beyond what is given by more than round-off [length]. Of what is needed of a gap judge()
/// (judge.h) alone asks that, and those who find the level that governs.
/// @param scale of the displacements that the need is the difference of [length]
[[nodiscard]] bool falls_short(double given, double needed, double scale);

/// A need, or 0 where it is nothing but round-off [length].
[[nodiscard]] inline double without_round_off(double need, double scale) {
  return falls_short(0, need, scale) ? need : 0;
}

}  // namespace bentur
