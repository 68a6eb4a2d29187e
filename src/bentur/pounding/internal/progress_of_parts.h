#pragma once

#include <functional>

namespace bentur {

/// The progress of a solution as that of its two parts, without contact and with it; empty where it is.
struct ProgressOfParts {
  std::function<bool(double)> free, rest;

  explicit ProgressOfParts(const std::function<bool(double)>& progress) {
    constexpr double free_part = 0.25;  // of the work
    if (!progress) return;
    free = [progress](double fraction) { return progress(free_part * fraction); };
    rest = [progress](double fraction) { return progress(free_part + (1.0 - free_part) * fraction); };
  }
};

}  // namespace bentur
