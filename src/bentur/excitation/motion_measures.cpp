#include "bentur/excitation/motion_measures.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <variant>
#include <vector>

namespace bentur {
namespace {

double peak_velocity(const SampledMotion& motion) {
  const std::vector<double>& a = motion.acceleration;
  const double h = motion.time_step;
  double v = 0;
  double peak = 0;
  for (std::size_t i = 0; i + 1 < a.size(); ++i) {
    if (a[i] * a[i + 1] < 0) {  // v has its extremum where a is zero
      peak = std::max(peak, std::abs(v + a[i] * h * a[i] / (a[i] - a[i + 1]) / 2));
    }
    v += (a[i] + a[i + 1]) * h / 2;
    peak = std::max(peak, std::abs(v));
  }
  return peak;
}

/// ∫ a² dt over a part τ of the step in which a goes linearly from `a0` with slope `s`.
double squared(double a0, double s, double tau) {
  return a0 * a0 * tau + a0 * s * tau * tau + s * s * tau * tau * tau / 3;
}

double significant_duration(const SampledMotion& motion) {
  const std::vector<double>& a = motion.acceleration;
  const double h = motion.time_step;
  std::vector<double> sum = {0};
  for (std::size_t i = 0; i + 1 < a.size(); ++i) {
    sum.push_back(sum.back() + squared(a[i], (a[i + 1] - a[i]) / h, h));
  }
  if (!(sum.back() > 0)) return 0;
  const auto reached = [&](double fraction) {
    const double wanted = fraction * sum.back();
    const auto i = static_cast<std::size_t>(std::upper_bound(sum.begin(), sum.end() - 1, wanted) - sum.begin()) - 1;
    double low = 0;
    double high = h;
    for (int halving = 0; halving < 60; ++halving) {
      const double middle = (low + high) / 2;
      (sum[i] + squared(a[i], (a[i + 1] - a[i]) / h, middle) < wanted ? low : high) = middle;
    }
    return static_cast<double>(i) * h + high;
  };
  return reached(0.95) - reached(0.05);
}

}  // namespace

MotionMeasures motion_measures(const GroundMotion& motion) {
  MotionMeasures measures;
  measures.pga = peak_acceleration(motion);
  if (const auto* sampled = std::get_if<SampledMotion>(&motion)) {
    measures.pgv = peak_velocity(*sampled);
    measures.significant_duration = significant_duration(*sampled);
  } else if (const auto* harmonic = std::get_if<HarmonicMotion>(&motion)) {
    measures.pgv = std::abs(harmonic->displacement_amplitude) * angular_frequency(motion);
  }
  return measures;
}

}  // namespace bentur
