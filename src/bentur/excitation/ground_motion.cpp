#include "bentur/excitation/ground_motion.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace bentur {
namespace {

constexpr double two_pi = 2.0 * std::numbers::pi;

double harmonic_peak(const HarmonicMotion& motion) {
  const double omega = two_pi / motion.period;
  return motion.displacement_amplitude * omega * omega;
}

double at(const NoMotion&, double) { return 0.0; }

double at(const SampledMotion& motion, double t) {
  const double position = t / motion.time_step;
  const auto last = static_cast<double>(motion.acceleration.size()) - 1.0;
  if (!(position >= 0.0) || position > last) return 0.0;
  const auto k = std::min(static_cast<std::size_t>(position), motion.acceleration.size() - 1);
  if (k + 1 == motion.acceleration.size()) return motion.acceleration[k];
  const double fraction = position - static_cast<double>(k);
  return motion.acceleration[k] + fraction * (motion.acceleration[k + 1] - motion.acceleration[k]);
}

double at(const HarmonicMotion& motion, double t) {
  if (!(t >= 0.0)) return 0.0;
  const double angle = two_pi * t / motion.period;
  return -harmonic_peak(motion) * (motion.phase == HarmonicMotion::Phase::sine ? std::sin(angle) : std::cos(angle));
}

double peak(const NoMotion&) { return 0.0; }

double peak(const SampledMotion& motion) {
  double largest = 0.0;
  for (const double a : motion.acceleration) largest = std::max(largest, std::abs(a));
  return largest;
}

double peak(const HarmonicMotion& motion) { return std::abs(harmonic_peak(motion)); }

}  // namespace

double acceleration_at(const GroundMotion& motion, double t) {
  return std::visit([t](const auto& m) { return at(m, t); }, motion);
}

double peak_acceleration(const GroundMotion& motion) {
  return std::visit([](const auto& m) { return peak(m); }, motion);
}

double angular_frequency(const GroundMotion& motion) {
  const auto* harmonic = std::get_if<HarmonicMotion>(&motion);
  return harmonic != nullptr ? two_pi / harmonic->period : 0.0;
}

}  // namespace bentur
