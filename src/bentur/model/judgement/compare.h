#pragma once

namespace bentur {

/// Whether what is needed goes beyond what is given by more than round-off [length]. Of what is needed of a gap judge()
/// (judge.h) alone asks that, and those who find the level that governs.
/// @param scale of the displacements that the need is the difference of [length]
[[nodiscard]] bool falls_short(double given, double needed, double scale);

}  // namespace bentur
