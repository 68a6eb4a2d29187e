#include "bentur/solve/engine/motion/time_grid.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace bentur::engine {
namespace {

constexpr double segments_per_period = 32.0;  // where the motion has no step of its own
constexpr double merge = 1e-9;                // of the grid period: two delays nearer than this have the same phase

double grid_period(const System& system, bool fine) {
  if (const auto* sampled = std::get_if<SampledMotion>(&system.motion)) return sampled->time_step;
  if (!fine) return system.duration;
  if (const auto* harmonic = std::get_if<HarmonicMotion>(&system.motion)) {
    return std::min(harmonic->period / segments_per_period, system.duration);
  }
  double slowest = 0.0;
  for (const Body& body : system.bodies) {
    const double first = body.is_rigid() ? 0.0 : body.modes.omega(0);
    if (first > 0.0) slowest = std::max(slowest, 2.0 * std::numbers::pi / first);
  }
  const double period = slowest > 0.0 ? slowest / segments_per_period : system.duration / segments_per_period;
  return std::min(period, system.duration);
}

}  // namespace

TimeGrid::TimeGrid(const System& system, bool fine)
    : motion_(&system.motion), period_(grid_period(system, fine)), offsets_{0.0} {
  std::vector<double> phases;
  for (std::size_t b = 0; b < system.bodies.size(); ++b) {
    const double delay = std::min(system.delay(b), system.duration + period_);  // from there on nothing arrives
    double steps = std::floor(delay / period_);
    double phase = delay - steps * period_;
    if (phase > period_ * (1.0 - merge)) {
      steps += 1.0;
      phase = 0.0;
    }
    const auto same = std::find_if(offsets_.begin(), offsets_.end(),
                                   [&](double o) { return std::abs(o - phase) <= merge * period_; });
    if (same == offsets_.end()) {
      offsets_.push_back(phase);
    } else {
      phase = *same;
    }
    phases.push_back(phase);
    delays_.push_back({static_cast<long>(steps), 0});
  }
  std::sort(offsets_.begin(), offsets_.end());
  for (std::size_t b = 0; b < phases.size(); ++b) {
    delays_[b].offset =
        static_cast<std::size_t>(std::find(offsets_.begin(), offsets_.end(), phases[b]) - offsets_.begin());
  }
}

double TimeGrid::length(std::size_t kind) const {
  return (kind + 1 < offsets_.size() ? offsets_[kind + 1] : period_) - offsets_[kind];
}

double TimeGrid::start(long segment) const {
  const long count = std::ssize(offsets_);
  return start(segment / count, segment % count);
}

void TimeGrid::input(long segment, std::vector<GroundInput>& inputs) const {
  const long count = std::ssize(offsets_);
  input(segment / count, segment % count, inputs);
}

void TimeGrid::input(long period, std::size_t kind, std::vector<GroundInput>& inputs) const {
  inputs.resize(delays_.size());
  for (std::size_t b = 0; b < delays_.size(); ++b) {
    const bool before_phase = kind < delays_[b].offset;
    const double within = offsets_[kind] - offsets_[delays_[b].offset] + (before_phase ? period_ : 0.0);
    inputs[b] = input_at(period - delays_[b].steps - (before_phase ? 1 : 0), within);
  }
}

GroundInput TimeGrid::input_at(long period, double within) const {
  if (period < 0) return {};
  if (const auto* sampled = std::get_if<SampledMotion>(motion_)) {
    if (period + 1 >= std::ssize(sampled->acceleration)) return {};
    const double slope = (sampled->acceleration[period + 1] - sampled->acceleration[period]) / period_;
    return {sampled->acceleration[period] + slope * within, slope};
  }
  if (const auto* harmonic = std::get_if<HarmonicMotion>(motion_)) {
    const double nu = 2.0 * std::numbers::pi / harmonic->period;
    const double angle = nu * (static_cast<double>(period) * period_ + within);
    const double peak = harmonic->displacement_amplitude * nu * nu;
    if (harmonic->phase == HarmonicMotion::Phase::sine) {
      return {-peak * std::sin(angle), -peak * nu * std::cos(angle)};
    }
    return {-peak * std::cos(angle), peak * nu * std::sin(angle)};
  }
  return {};
}

}  // namespace bentur::engine
