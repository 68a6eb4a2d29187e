#pragma once

#include <cmath>
#include <vector>

#include "bentur/study/fragility/fragility.h"

// What fits by maximum likelihood of a probability over z = a + b u have in common.
namespace bentur {

/// One intensity of standardised data: u, and the parts of all runs that have the event there and that have not.
struct StandardLevel {
  double u = 0, events = 0, others = 0;
};

/// Intensities so that neither their unit nor their range nor the number of runs matters: u = (ln x − mean)/spread.
struct StandardLevels {
  double runs = 0, events = 0, mean = 0, spread = 0;
  std::vector<StandardLevel> levels;

  explicit StandardLevels(const std::vector<IntensityCount>& counts) {
    for (const IntensityCount& one : counts) {
      const auto n = static_cast<double>(one.runs);
      runs += n;
      events += static_cast<double>(one.events);
      mean += n * std::log(one.intensity);
    }
    mean /= runs;
    for (const IntensityCount& one : counts) {
      spread += static_cast<double>(one.runs) * std::pow(std::log(one.intensity) - mean, 2);
    }
    spread = std::sqrt(spread / runs);
    for (const IntensityCount& one : counts) {
      levels.push_back({(std::log(one.intensity) - mean) / spread, static_cast<double>(one.events) / runs,
                        static_cast<double>(one.runs - one.events) / runs});
    }
  }
};

/// Raises a concave logarithm of a likelihood of a and b from where they stand to its maximum, by Newton's method with
/// steps halved until it does not fall by more than a part of itself that is round-off. It takes about 6 steps; halving
/// may need some more far from the maximum.
/// @tparam Likelihood made of levels, a, b: `value`, gradient `da`, `db`, negative Hessian `haa`, `hab`, `hbb`
template <class Likelihood>
Likelihood maximised(const std::vector<StandardLevel>& levels, double& a, double& b, double round_off = 0) {
  Likelihood at(levels, a, b);
  constexpr int most_steps = 200;
  for (int i = 0; i < most_steps; ++i) {
    const double determinant = at.haa * at.hbb - at.hab * at.hab;
    double step_a = (at.hbb * at.da - at.hab * at.db) / determinant;
    double step_b = (at.haa * at.db - at.hab * at.da) / determinant;
    if (!std::isfinite(step_a + step_b)) break;
    Likelihood next(levels, a + step_a, b + step_b);
    const double enough = at.value - round_off * std::abs(at.value);
    while (!(next.value >= enough) && std::hypot(step_a, step_b) > 1e-15 * std::hypot(a, b)) {
      step_a /= 2;
      step_b /= 2;
      next = Likelihood(levels, a + step_a, b + step_b);
    }
    if (!(next.value >= enough)) break;
    a += step_a;
    b += step_b;
    at = next;
    if (std::hypot(step_a, step_b) <= 1e-13 * std::hypot(a, b)) break;
  }
  return at;
}

}  // namespace bentur
