#include "bentur/solve/spectrum/response_spectrum.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>

#include "bentur/core/errors.h"
#include "bentur/core/require.h"
#include "bentur/solve/engine/motion/polynomial.h"

namespace bentur {
namespace {

constexpr double reach = 2.0;  // largest ω h of one power series [-]; the first term left out is 2²⁷/27! = 1e-20
constexpr double turn_of_a_look = 0.05;  // largest ω h of one look at a path [rad]: what is missed is (ω h)²/8 of it
constexpr double shortest_period = 1e-3;  // of the record's step [-]; shorter ones follow the ground to the last digit

struct State {
  double x = 0;  ///< [length]
  double v = 0;  ///< [length/s]
};

/// a_g over one step: value at its start and change to its end [length/s²].
struct Ground {
  double value = 0, change = 0;
};

struct Oscillator {
  double omega = 0;  ///< [rad/s]
  double zeta = 0;   ///< [-]

  /// ẍ + a_g [length/s²].
  [[nodiscard]] double absolute(const State& q) const { return -omega * (2 * zeta * q.v + omega * q.x); }
};

/// Solution of (1) over a step h as a power series in s = τ/h.
engine::Polynomial series(const Oscillator& o, double h, const State& from, const Ground& ground) {
  const double turn = o.omega * h;
  engine::Polynomial p;
  p[0] = from.x;
  p[1] = from.v * h;
  for (int k = 0; k + 2 <= p.degree; ++k) {
    const double force = k == 0 ? ground.value : (k == 1 ? ground.change : 0);
    p[k + 2] = -(turn * turn * p[k] + 2 * o.zeta * turn * (k + 1) * p[k + 1] + force * h * h) / ((k + 2.0) * (k + 1));
  }
  return p;
}

/// The absolute acceleration that goes with it.
engine::Polynomial absolute_series(const Oscillator& o, double h, const engine::Polynomial& x) {
  engine::Polynomial p;
  p.degree = x.degree - 1;
  for (int k = 0; k <= p.degree; ++k) {
    p[k] = -o.omega * (2 * o.zeta * (k + 1) * x[k + 1] / h + o.omega * x[k]);
  }
  return p;
}

/// The end of a step as a linear map of its start and its ground acceleration.
class Step {
 public:
  Step(const Oscillator& o, double h)
      : o_(o),
        h_(h),
        from_x_(end({1, 0}, {0, 0})),
        from_v_(end({0, 1}, {0, 0})),
        from_value_(end({0, 0}, {1, 0})),
        from_change_(end({0, 0}, {0, 1})) {}

  [[nodiscard]] State advance(const State& q, const Ground& g) const {
    return {from_x_.x * q.x + from_v_.x * q.v + from_value_.x * g.value + from_change_.x * g.change,
            from_x_.v * q.x + from_v_.v * q.v + from_value_.v * g.value + from_change_.v * g.change};
  }

  /// Raises the peaks to those of this step. Between its ends a function strays from its chord by no more than h²/8
  /// of its largest second derivative, and S = √(u̇² + ω²u²) of a free oscillation u never grows. With u = x − p, p the
  /// particular solution for the step's linear input (p̈ = 0): |ẍ| = |ü| ≤ ω √(1+4ζ²) S_u; and the absolute acceleration
  /// ẍ + a_g has the second derivative d⁴u/dt⁴ ≤ ω √(1+4ζ²) S_ü. Only a step that could raise a peak is looked into.
  void watch(const State& from, const State& to, const Ground& g, double& displacement, double& acceleration) const {
    const double w = o_.omega;
    const double rate = g.change / h_;
    const double bend = w * std::sqrt(1 + 4 * o_.zeta * o_.zeta) * h_ * h_ / 8;
    const double u = from.x + (g.value - 2 * o_.zeta * rate / w) / (w * w);
    const double u1 = from.v + rate / (w * w);
    const double u2 = -w * (2 * o_.zeta * u1 + w * u);
    const double u3 = -w * (2 * o_.zeta * u2 + w * u1);
    const double highest_x = std::max(std::abs(from.x), std::abs(to.x)) + bend * std::hypot(u1, w * u);
    const double highest_a =
        std::max(std::abs(o_.absolute(from)), std::abs(o_.absolute(to))) + bend * std::hypot(u3, w * u2);
    if (highest_x <= displacement && highest_a <= acceleration) return;
    const engine::Polynomial x = series(o_, h_, from, g);
    engine::raise_to_largest(x, 1.0, displacement);
    engine::raise_to_largest(absolute_series(o_, h_, x), 1.0, acceleration);
  }

 private:
  [[nodiscard]] State end(const State& from, const Ground& ground) const {
    const engine::Polynomial p = series(o_, h_, from, ground);
    return {engine::value(p, 1), engine::first_derivative(p, 1) / h_};
  }

  Oscillator o_;
  double h_;
  State from_x_, from_v_, from_value_, from_change_;
};

/// Largest |u| from now on of a free oscillation: now, or at its first standstill,
/// tan(ω_d t) = ω_d u̇/(ω(ωu + ζu̇)), after which every swing is smaller.
double free_peak(const Oscillator& o, double u, double rate) {
  const double damped = o.omega * std::sqrt((1 - o.zeta) * (1 + o.zeta));
  double angle = std::atan2(damped * rate, o.omega * (o.omega * u + o.zeta * rate));
  if (angle < 0) angle += std::numbers::pi;
  const double swing = u * std::cos(angle) + (rate + o.zeta * o.omega * u) / damped * std::sin(angle);
  return std::max(std::abs(u), std::exp(-o.zeta * o.omega * angle / damped) * std::abs(swing));
}

void check(const SampledMotion& motion, double period, double damping_ratio) {
  require_positive("time_step", motion.time_step);
  if (motion.acceleration.empty()) throw InvalidParameter("acceleration", "0 samples", "needs one at least");
  require_positive("period", period);
  if (period < shortest_period * motion.time_step) {
    throw InvalidParameter("period", fmt::format("{}", period),
                           "must be at least a thousandth of the record's time step");
  }
  if (!(damping_ratio >= 0 && damping_ratio < 1)) {
    throw InvalidParameter("damping_ratio", std::to_string(damping_ratio), "must be in [0, 1)");
  }
}

}  // namespace

OscillatorPeaks oscillator_peaks(const SampledMotion& motion, double period, double damping_ratio) {
  check(motion, period, damping_ratio);
  const Oscillator o{2 * std::numbers::pi / period, damping_ratio};
  const double parts = std::max(1.0, std::ceil(o.omega * motion.time_step / reach));
  const Step step(o, motion.time_step / parts);
  State q;
  double displacement = 0, acceleration = 0;
  for (std::size_t i = 0; i + 1 < motion.acceleration.size(); ++i) {
    const double change = (motion.acceleration[i + 1] - motion.acceleration[i]) / parts;
    for (double part = 0; part < parts; ++part) {
      const Ground ground{motion.acceleration[i] + part * change, change};
      const State next = step.advance(q, ground);
      step.watch(q, next, ground, displacement, acceleration);
      q = next;
    }
  }
  displacement = std::max(displacement, free_peak(o, q.x, q.v));
  const double a = o.absolute(q);
  acceleration = std::max(acceleration, free_peak(o, a, -o.omega * (2 * o.zeta * a + o.omega * q.v)));
  require_finite("acceleration", displacement + acceleration + a);
  return {displacement, o.omega * displacement, o.omega * o.omega * displacement, acceleration};
}

std::vector<OscillatorPeaks> response_spectrum(const SampledMotion& motion, const std::vector<double>& periods,
                                               double damping_ratio) {
  std::vector<OscillatorPeaks> spectrum;
  spectrum.reserve(periods.size());
  for (const double period : periods) spectrum.push_back(oscillator_peaks(motion, period, damping_ratio));
  return spectrum;
}

double maximum_direction(const SampledMotion& x, const SampledMotion& y, double period, double damping_ratio) {
  check(x, period, damping_ratio);
  check(y, period, damping_ratio);
  if (x.time_step != y.time_step) {
    throw InvalidParameter("time_step", fmt::format("{}", y.time_step), "must be that of the other component");
  }
  const Oscillator o{2 * std::numbers::pi / period, damping_ratio};
  const double parts = std::max(1.0, std::ceil(o.omega * x.time_step / turn_of_a_look));
  const Step step(o, x.time_step / parts);
  // Free vibration is largest within one period after the last sample.
  const auto after = static_cast<std::size_t>(std::ceil(period / x.time_step));
  const std::size_t steps = std::max(x.acceleration.size(), y.acceleration.size()) + after;
  State q, r;
  double largest = 0;
  for (std::size_t i = 0; i < steps; ++i) {
    // A record ends with its last sample, without a slope to zero.
    const auto change = [&](const SampledMotion& motion) {
      return i + 1 < motion.acceleration.size() ? (motion.acceleration[i + 1] - motion.acceleration[i]) / parts : 0.0;
    };
    const auto value = [&](const SampledMotion& motion) {
      return i + 1 < motion.acceleration.size() ? motion.acceleration[i] : 0.0;
    };
    const double change_x = change(x), change_y = change(y), value_x = value(x), value_y = value(y);
    for (double part = 0; part < parts; ++part) {
      q = step.advance(q, {value_x + part * change_x, change_x});
      r = step.advance(r, {value_y + part * change_y, change_y});
      largest = std::max(largest, q.x * q.x + r.x * r.x);
    }
  }
  require_finite("acceleration", largest);
  return o.omega * o.omega * std::sqrt(largest);
}

std::vector<double> logarithmic_periods(double first, double last, int count) {
  require_positive("first", first);
  require_positive("last", last);
  if (!(count >= 2 && first < last) && !(count == 1 && first == last)) {
    throw InvalidParameter("count", std::to_string(count), "must be >= 2 and the first period less than the last");
  }
  std::vector<double> periods;
  for (int i = 0; i < count; ++i) {
    periods.push_back(first * std::pow(last / first, count == 1 ? 0.0 : static_cast<double>(i) / (count - 1)));
  }
  periods.back() = last;
  return periods;
}

}  // namespace bentur
