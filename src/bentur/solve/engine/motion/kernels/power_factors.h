#pragma once

#include <array>
#include <cstddef>

namespace bentur::engine::kernels {

/// What powers s^k are multiplied by when they are derived or integrated, so that no loop has to convert its index.
struct PowerFactors {
  static constexpr int powers = 32;  // more than any expansion has
  std::array<double, powers> first{}, second{}, third{}, fourth{}, next{}, scale{}, integral{};
  std::array<double, powers> rise{};         ///< max x − x^k on [0, 1]: how far s^k leaves its chord
  std::array<double, powers> second_rise{};  ///< the same of its second derivative

  constexpr PowerFactors() {
    for (int k = 0; k < powers; ++k) {
      const auto at = static_cast<std::size_t>(k);
      first[at] = k;
      second[at] = k * (k - 1.0);
      third[at] = second[at] * (k - 2.0);
      fourth[at] = (k - 2.0) * (k - 3.0);  // on top of the second
      next[at] = k + 1.0;
      integral[at] = 1.0 / (k + 1.0);
      scale[at] = 1.0 / ((k + 2.0) * (k + 1.0));
      rise[at] = k < 2 ? 0.0 : most_above_power(k);
      second_rise[at] = k < 4 ? 0.0 : second[at] * rise[at - 2];
    }
  }

 private:
  static constexpr double power(double x, int k) {
    double result = 1.0;
    for (; k > 0; --k) result *= x;
    return result;
  }
  /// max x − x^k, where k x^(k−1) = 1.
  static constexpr double most_above_power(int k) {
    double low = 0.0;
    double high = 1.0;
    for (int n = 0; n < 60; ++n) {
      const double middle = 0.5 * (low + high);
      (k * power(middle, k - 1) < 1.0 ? low : high) = middle;
    }
    return low - power(low, k);
  }
};
constexpr PowerFactors power_factors;

}  // namespace bentur::engine::kernels
