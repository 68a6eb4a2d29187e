#include "bentur/solve/engine/motion/runge_kutta/step_control.h"

#include <algorithm>
#include <cmath>

namespace bentur::engine {
namespace {

constexpr double power = 1.0 / 8.0;
constexpr double safety = 0.9;
constexpr double least_change = 0.2;
constexpr double most_change = 6.0;
constexpr double most_trend = 3.0;
constexpr double least_error = 1e-8;  // smaller ones say no more than that the step may grow as much as it can

}  // namespace

double StepControl::next(double h, double error) {
  if (!std::isfinite(error)) return h * least_change;
  error = std::max(error, least_error);
  double change = safety * std::pow(error, -power);
  if (error <= 1.0) {
    if (last_h_ > 0.0) {
      const double trend = h / last_h_ * std::pow(last_error_ / error, power);
      change *= std::clamp(trend, 1.0 / most_trend, most_trend);
    }
    last_h_ = h;
    last_error_ = error;
  }
  return h * std::clamp(change, least_change, most_change);
}

}  // namespace bentur::engine
