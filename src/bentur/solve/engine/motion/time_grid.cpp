#include "bentur/solve/engine/motion/time_grid.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "bentur/core/errors.h"

namespace bentur::engine {
namespace {

constexpr double segments_per_period = 32.0;  // where the motion has no step of its own
constexpr double merge = 1e-9;                // of the grid period: two delays nearer than this have the same phase
constexpr long most_in_period = 64;           // of a record in a period
constexpr double same_time = 1e-12;           // of a period

/// The shortest time of which the steps of all records are whole parts; 0: there are none.
double common_period(const std::vector<GroundMotion>& motions) {
  std::vector<double> steps;
  for (const GroundMotion& motion : motions) {
    if (const auto* sampled = std::get_if<SampledMotion>(&motion)) steps.push_back(sampled->time_step);
  }
  if (steps.empty()) return 0.0;
  for (long count = 1; count <= most_in_period; ++count) {
    const double period = static_cast<double>(count) * steps.front();
    const bool common = std::all_of(steps.begin(), steps.end(), [&](double step) {
      const double parts = std::round(period / step);
      return parts >= 1.0 && parts <= most_in_period && std::abs(parts * step - period) <= same_time * period;
    });
    if (common) return period;
  }
  throw InvalidParameter("motions", "records with different time steps",
                         fmt::format("must have one of at most {} steps of each", most_in_period));
}

double grid_period(const System& system, bool fine) {
  if (const double common = common_period(system.motions); common > 0.0) return common;
  if (!fine) return system.duration;
  double period = system.duration;
  bool harmonic = false;
  for (const GroundMotion& motion : system.motions) {
    if (const auto* of = std::get_if<HarmonicMotion>(&motion)) {
      period = std::min(of->period / segments_per_period, period);
      harmonic = true;
    }
  }
  if (harmonic) return period;
  double slowest = 0.0;
  for (const Body& body : system.bodies) {
    const double first = body.is_rigid() ? 0.0 : body.modes.omega(0);
    if (first > 0.0) slowest = std::max(slowest, 2.0 * std::numbers::pi / first);
  }
  period = slowest > 0.0 ? slowest / segments_per_period : system.duration / segments_per_period;
  return std::min(period, system.duration);
}

}  // namespace

TimeGrid::TimeGrid(const System& system, bool fine)
    : motions_(&system.motions), period_(grid_period(system, fine)), offsets_{0.0} {
  for (const GroundMotion& motion : system.motions) {
    const auto* sampled = std::get_if<SampledMotion>(&motion);
    steps_.push_back(sampled != nullptr ? std::lround(period_ / sampled->time_step) : 1);
  }
  /// Where a phase stands among the offsets, which take it in.
  const auto take = [this](double phase) {
    const auto same = std::find_if(offsets_.begin(), offsets_.end(),
                                   [&](double o) { return std::abs(o - phase) <= merge * period_; });
    if (same != offsets_.end()) return *same;
    offsets_.push_back(phase);
    return phase;
  };
  std::vector<double> phases;
  for (std::size_t b = 0; b < system.bodies.size(); ++b) {
    const double delay = std::min(system.delay(b), system.duration + period_);  // from there on nothing arrives
    double steps = std::floor(delay / period_);
    double phase = delay - steps * period_;
    if (phase > period_ * (1.0 - merge)) {
      steps += 1.0;
      phase = 0.0;
    }
    phase = take(phase);
    phases.push_back(phase);
    for (const long parts : steps_) {
      for (long n = 1; n < parts; ++n) {
        const double sample = phase + static_cast<double>(n) * period_ / static_cast<double>(parts);
        const double within = sample < period_ * (1.0 - merge) ? sample : sample - period_;
        (void)take(std::max(within, 0.0));
      }
    }
    delays_.push_back({static_cast<long>(steps)});
  }
  std::sort(offsets_.begin(), offsets_.end());
  for (std::size_t b = 0; b < phases.size(); ++b) {
    delays_[b].offset =
        static_cast<std::size_t>(std::find(offsets_.begin(), offsets_.end(), phases[b]) - offsets_.begin());
    const auto first = std::find_if(
        delays_.begin(), delays_.begin() + static_cast<std::ptrdiff_t>(b),
        [&](const Delay& one) { return one.periods == delays_[b].periods && one.offset == delays_[b].offset; });
    delays_[b].first = static_cast<std::size_t>(first - delays_.begin());
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
  inputs.resize(delays_.size() * steps_.size());
  GroundInput* at = inputs.data();
  for (std::size_t b = 0; b < delays_.size(); ++b) {
    if (delays_[b].first < b) {
      at = std::copy_n(inputs.data() + delays_[b].first * steps_.size(), steps_.size(), at);
      continue;
    }
    const bool before_phase = kind < delays_[b].offset;
    const double within = offsets_[kind] - offsets_[delays_[b].offset] + (before_phase ? period_ : 0.0);
    const long of_body = period - delays_[b].periods - (before_phase ? 1 : 0);
    for (std::size_t c = 0; c < steps_.size(); ++c) *at++ = input_at(c, of_body, within);
  }
}

GroundInput TimeGrid::input_at(std::size_t component, long period, double within) const {
  if (period < 0) return {};
  const GroundMotion& motion = (*motions_)[component];
  if (const auto* sampled = std::get_if<SampledMotion>(&motion)) {
    long sample = period;
    if (steps_[component] > 1) {
      const double before = std::floor(within / sampled->time_step + merge);
      within -= before * sampled->time_step;
      sample = period * steps_[component] + static_cast<long>(before);
    }
    if (sample + 1 >= std::ssize(sampled->acceleration)) return {};
    const double* at = sampled->acceleration.data() + sample;
    const double slope = (at[1] - at[0]) / sampled->time_step;
    return {at[0] + slope * within, slope};
  }
  if (const auto* harmonic = std::get_if<HarmonicMotion>(&motion)) {
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
