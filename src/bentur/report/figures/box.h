#pragma once

#include <algorithm>

namespace bentur {

/// A rectangle in a frame; of names from its lower left corner [cm].
struct Box {
  double left = 0, right = 0, bottom = 0, top = 0;

  [[nodiscard]] bool meets(const Box& other) const {
    return left < other.right && other.left < right && bottom < other.top && other.bottom < top;
  }
  /// Whether a straight line between two places passes through it (by parameters of where it enters and leaves).
  [[nodiscard]] bool meets(double x0, double y0, double x1, double y1) const {
    double enter = 0, leave = 1;
    const auto cut = [&](double from, double to, double low, double up) {
      if (from == to) {
        if (from <= low || from >= up) leave = -1;
        return;
      }
      const double a = (low - from) / (to - from), b = (up - from) / (to - from);
      enter = std::max(enter, std::min(a, b));
      leave = std::min(leave, std::max(a, b));
    };
    cut(x0, x1, left, right);
    cut(y0, y1, bottom, top);
    return enter < leave;
  }
};

}  // namespace bentur
