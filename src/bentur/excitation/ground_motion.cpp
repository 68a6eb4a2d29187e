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

/// @param position t over the time step
double at_position(const SampledMotion& motion, double position) {
  const auto last = static_cast<double>(motion.acceleration.size()) - 1.0;
  if (!(position >= 0.0) || position > last) return 0.0;
  const auto k = std::min(static_cast<std::size_t>(position), motion.acceleration.size() - 1);
  if (k + 1 == motion.acceleration.size()) return motion.acceleration[k];
  const double fraction = position - static_cast<double>(k);
  return motion.acceleration[k] + fraction * (motion.acceleration[k + 1] - motion.acceleration[k]);
}

double at(const SampledMotion& motion, double t) { return at_position(motion, t / motion.time_step); }

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

/// Of the sum at the samples of `one`, between which it is linear unless `other` has some there; and right after `one`,
/// where it ends before `other`.
double peak_at_samples(const SampledMotion& one, double weight, const SampledMotion& other, double other_weight) {
  double largest = 0, position = 0, at_other = 0;
  for (std::size_t k = 0; k < one.acceleration.size(); ++k) {
    position = static_cast<double>(k) * one.time_step / other.time_step;
    constexpr double round_off = 1e-9;  // of a time at which both have samples
    if (std::abs(position - std::round(position)) < round_off) position = std::round(position);
    at_other = other_weight * at_position(other, position);
    largest = std::max(largest, std::abs(weight * one.acceleration[k] + at_other));
  }
  const bool ends_first = position < static_cast<double>(other.acceleration.size()) - 1;
  return ends_first ? std::max(largest, std::abs(at_other)) : largest;
}

}  // namespace

GroundMotion reversed(GroundMotion motion) {
  if (auto* sampled = std::get_if<SampledMotion>(&motion)) {
    for (double& value : sampled->acceleration) value = -value;
  }
  if (auto* harmonic = std::get_if<HarmonicMotion>(&motion)) harmonic->displacement_amplitude *= -1;
  return motion;
}

double acceleration_at(const GroundMotion& motion, double t) {
  return std::visit([t](const auto& m) { return at(m, t); }, motion);
}

double peak_acceleration(const GroundMotion& motion) {
  return std::visit([](const auto& m) { return peak(m); }, motion);
}

std::optional<double> peak_acceleration(const std::array<GroundMotion, 2>& motions,
                                        const std::array<double, 2>& weights) {
  const std::array<double, 2> alone = {std::abs(weights[0]) * peak_acceleration(motions[0]),
                                       std::abs(weights[1]) * peak_acceleration(motions[1])};
  if (alone[0] == 0 || alone[1] == 0) return std::max(alone[0], alone[1]);
  const auto *first = std::get_if<SampledMotion>(&motions[0]), *second = std::get_if<SampledMotion>(&motions[1]);
  if (first != nullptr && second != nullptr) {
    return std::max(peak_at_samples(*first, weights[0], *second, weights[1]),
                    peak_at_samples(*second, weights[1], *first, weights[0]));
  }
  const auto *one = std::get_if<HarmonicMotion>(&motions[0]), *other = std::get_if<HarmonicMotion>(&motions[1]);
  if (one == nullptr || other == nullptr || one->period != other->period) return std::nullopt;
  if (one->phase != other->phase) return std::hypot(alone[0], alone[1]);
  return std::abs(weights[0] * harmonic_peak(*one) + weights[1] * harmonic_peak(*other));
}

double angular_frequency(const GroundMotion& motion) {
  const auto* harmonic = std::get_if<HarmonicMotion>(&motion);
  return harmonic != nullptr ? two_pi / harmonic->period : 0.0;
}

}  // namespace bentur
