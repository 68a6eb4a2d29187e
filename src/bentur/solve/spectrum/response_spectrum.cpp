#include "bentur/solve/spectrum/response_spectrum.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>

#include "bentur/core/errors.h"
#include "bentur/core/require.h"
#include "bentur/solve/engine/motion/kernels/four.h"
#include "bentur/solve/engine/motion/polynomial.h"

namespace bentur {
namespace {

using engine::kernels::abs, engine::kernels::all, engine::kernels::every, engine::kernels::max;
using engine::kernels::Bits, engine::kernels::Four, engine::kernels::four;

constexpr double reach = 2.0;  // largest ω h of one power series [-]; the first term left out is 2²⁷/27! = 1e-20
constexpr double turn_of_a_look = 0.05;  // largest ω h of one look at a path [rad]: what is missed is (ω h)²/8 of it
constexpr double shortest_period = 1e-3;  // of the record's step [-]; shorter ones follow the ground to the last digit

/// Of four oscillators that are followed side by side.
struct States {
  Four x = all(0);  ///< [length]
  Four v = all(0);  ///< [length/s]
};

struct State {
  double x = 0, v = 0;
};

/// a_g over one step: value at its start and change to its end [length/s²], of all or of each of four.
template <class Number = double>
struct Ground {
  Number value, change;
};

struct Oscillator {
  double omega = 0;  ///< [rad/s]
  double zeta = 0;   ///< [-]
};

/// Solution of (1) over a step h as a power series in s = τ/h.
engine::Polynomial series(const Oscillator& o, double h, const State& from, const Ground<>& ground) {
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

struct Peaks {
  Four displacement = all(0), acceleration = all(0);
};

/// The end of a step of oscillators of one damping as a linear map of its start and its ground acceleration.
class Step {
 public:
  Step(Four omega, double zeta, double h)
      : omega_(omega),
        zeta_(zeta),
        h_(h),
        bend_(omega * (std::sqrt(1 + 4 * zeta * zeta) * h * h / 8)),
        from_still_(1 / (omega * omega)),
        from_rate_(from_still_ / h),
        from_drift_(2 * zeta * from_rate_ / omega) {
    for (int lane = 0; lane < four; ++lane) {
      const auto put = [&](States& to, const State& from, const Ground<>& ground) {
        const engine::Polynomial p = series(oscillator(lane), h, from, ground);
        to.x[lane] = engine::value(p, 1), to.v[lane] = engine::first_derivative(p, 1) / h;
      };
      put(from_x_, {1, 0}, {0, 0});
      put(from_v_, {0, 1}, {0, 0});
      put(from_value_, {0, 0}, {1, 0});
      put(from_change_, {0, 0}, {0, 1});
    }
  }

  [[nodiscard]] Oscillator oscillator(int lane) const { return {omega_[lane], zeta_}; }

  template <class Number>
  [[nodiscard]] BENTUR_INLINE States advance(const States& q, const Ground<Number>& g) const {
    return {from_x_.x * q.x + from_v_.x * q.v + from_value_.x * g.value + from_change_.x * g.change,
            from_x_.v * q.x + from_v_.v * q.v + from_value_.v * g.value + from_change_.v * g.change};
  }

  /// ẍ + a_g [length/s²].
  [[nodiscard]] BENTUR_INLINE Four absolute(const States& q) const {
    return -omega_ * (2 * zeta_ * q.v + omega_ * q.x);
  }

  /// Raises the peaks to those of this step. Between its ends a function strays from its chord by no more than h²/8
  /// of its largest second derivative, and S = √(u̇² + ω²u²) ≤ |u̇| + ω|u| of a free oscillation u never grows. With
  /// u = x − p, p the particular solution for the step's linear input (p̈ = 0): |ẍ| = |ü| ≤ ω √(1+4ζ²) S_u; and the
  /// absolute acceleration ẍ + a_g has the second derivative d⁴u/dt⁴ ≤ ω √(1+4ζ²) S_ü. Only a step that could raise a
  /// peak is looked into.
  BENTUR_INLINE void raise(const States& from, const States& to, const Ground<>& g, Peaks& peaks) const {
    const Four& w = omega_;
    const Four u = from.x + g.value * from_still_ - g.change * from_drift_;
    const Four u1 = from.v + g.change * from_rate_;
    const Four u2 = -w * (2 * zeta_ * u1 + w * u);
    const Four u3 = -w * (2 * zeta_ * u2 + w * u1);
    const Four highest_x = max(abs(from.x), abs(to.x)) + bend_ * (abs(u1) + abs(w * u));
    const Four highest_a = max(abs(absolute(from)), abs(absolute(to))) + bend_ * (abs(u3) + abs(w * u2));
    const Bits below = (highest_x <= peaks.displacement) & (highest_a <= peaks.acceleration);
    if (every(below)) return;
    const States here = from;  // copies, so that what most steps need stays in registers
    Peaks highest = peaks;
    look_into(here, g, below, highest);
    peaks = highest;
  }

 private:
  void look_into(const States& from, const Ground<>& g, const Bits& below, Peaks& peaks) const {
    for (int lane = 0; lane < four; ++lane) {
      if (below[lane] != 0) continue;
      double displacement = peaks.displacement[lane], acceleration = peaks.acceleration[lane];
      const engine::Polynomial x = series(oscillator(lane), h_, {from.x[lane], from.v[lane]}, g);
      engine::raise_to_largest(x, 1.0, displacement);
      engine::raise_to_largest(absolute_series(oscillator(lane), h_, x), 1.0, acceleration);
      peaks.displacement[lane] = displacement, peaks.acceleration[lane] = acceleration;
    }
  }

  Four omega_;
  double zeta_;
  double h_;
  Four bend_;                                 ///< h²/8 of the largest second derivative over S_u, S_ü
  Four from_still_, from_rate_, from_drift_;  ///< p of a ground that stands, its rate, and how far that lags behind
  States from_x_, from_v_, from_value_, from_change_;
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

/// Into how many equal parts a step of the record is cut.
double parts_of_a_step(const SampledMotion& motion, double omega) {
  return std::max(1.0, std::ceil(omega * motion.time_step / reach));
}

/// Every step of a record, from rest. @param visit(from, to, ground) @return where the oscillators are at its end
template <class Visit>
BENTUR_INLINE States go_through(const SampledMotion& motion, const Step& step, double parts, const Visit& visit) {
  const double* const acceleration = motion.acceleration.data();
  const std::size_t steps = motion.acceleration.size() - 1;
  States q;
  for (std::size_t i = 0; i < steps; ++i) {
    const double change = (acceleration[i + 1] - acceleration[i]) / parts;
    for (double part = 0; part < parts; ++part) {
      const Ground<> ground{acceleration[i] + part * change, change};
      const States next = step.advance(q, ground);
      visit(q, next, ground);
      q.x = next.x, q.v = next.v;  // a States would be copied by halves of a vector, for which the next step waits
    }
  }
  return q;
}

/// Raises a displacement to those at the ends of steps.
BENTUR_FOR_ALL_PROCESSORS States raise_to_ends(const SampledMotion& motion, const Step& of, double parts,
                                               Four& displacement) {
  const Step step = of;  // and so below: a copy, of which a compiler knows that nothing else changes it
  Four highest = displacement;
  const States last = go_through(
      motion, step, parts, [&](const States&, const States& to, const Ground<>&) __attribute__((always_inline)) {
        highest = max(abs(to.x), highest);
      });
  displacement = highest;
  return last;
}

/// Raises peaks to those of the whole record: to its largest ends of steps first, as few steps are then left that could
/// hold more.
BENTUR_FOR_ALL_PROCESSORS States raise_to_record(const SampledMotion& motion, const Step& of, double parts,
                                                 Peaks& peaks) {
  const Step step = of;
  Peaks highest = peaks;
  go_through(
      motion, step, parts, [&](const States&, const States& to, const Ground<>&) __attribute__((always_inline)) {
        highest.displacement = max(abs(to.x), highest.displacement);
        highest.acceleration = max(abs(step.absolute(to)), highest.acceleration);
      });
  const States last = go_through(
      motion, step,
      parts, [&](const States& from, const States& to, const Ground<>& ground) __attribute__((always_inline)) {
        step.raise(from, to, ground, highest);
      });
  peaks.displacement = highest.displacement, peaks.acceleration = highest.acceleration;
  return last;
}

/// @param within whether to look between samples; without that displacements alone are found
Peaks peaks_of(const SampledMotion& motion, Four omega, double zeta, bool within) {
  const double parts = parts_of_a_step(motion, omega[0]);
  const Step step(omega, zeta, motion.time_step / parts);
  Peaks peaks;
  const States last =
      within ? raise_to_record(motion, step, parts, peaks) : raise_to_ends(motion, step, parts, peaks.displacement);
  const Four a = step.absolute(last);
  for (int lane = 0; lane < four; ++lane) {
    const Oscillator o = step.oscillator(lane);
    const double displacement = free_peak(o, last.x[lane], last.v[lane]);
    const double acceleration = free_peak(o, a[lane], -o.omega * (2 * o.zeta * a[lane] + o.omega * last.v[lane]));
    peaks.displacement[lane] = std::max(peaks.displacement[lane], displacement);
    peaks.acceleration[lane] = std::max(peaks.acceleration[lane], acceleration);
    require_finite("acceleration", peaks.displacement[lane] + peaks.acceleration[lane] + a[lane]);
  }
  return peaks;
}

std::vector<OscillatorPeaks> spectrum_of(const SampledMotion& motion, const std::vector<double>& periods, double zeta,
                                         bool within) {
  for (const double period : periods) check(motion, period, zeta);
  std::vector<OscillatorPeaks> spectrum;
  spectrum.reserve(periods.size());
  while (spectrum.size() < periods.size()) {
    // As many as take the same steps; those of four that are left over are the last of them once more.
    const auto omega_of = [](double period) { return 2 * std::numbers::pi / period; };
    const auto parts_of = [&](double period) { return parts_of_a_step(motion, omega_of(period)); };
    const auto first = periods.begin() + std::ssize(spectrum);
    const auto end = std::find_if(first, first + std::min(four, periods.end() - first),
                                  [&](double period) { return parts_of(period) != parts_of(*first); });
    Four omega{};
    for (int lane = 0; lane < four; ++lane) omega[lane] = omega_of(*std::min(first + lane, end - 1));
    const Peaks peaks = peaks_of(motion, omega, zeta, within);
    for (int lane = 0; lane < end - first; ++lane) {
      const double w = omega[lane], displacement = peaks.displacement[lane];
      spectrum.push_back({displacement, w * displacement, w * w * displacement, peaks.acceleration[lane]});
    }
  }
  return spectrum;
}

}  // namespace

OscillatorPeaks oscillator_peaks(const SampledMotion& motion, double period, double damping_ratio) {
  return spectrum_of(motion, {period}, damping_ratio, true).front();
}

std::vector<OscillatorPeaks> response_spectrum(const SampledMotion& motion, const std::vector<double>& periods,
                                               double damping_ratio) {
  return spectrum_of(motion, periods, damping_ratio, true);
}

std::vector<double> pseudo_accelerations_at_samples(const SampledMotion& motion, const std::vector<double>& periods,
                                                    double damping_ratio) {
  std::vector<double> accelerations;
  for (const OscillatorPeaks& peaks : spectrum_of(motion, periods, damping_ratio, false)) {
    accelerations.push_back(peaks.pseudo_acceleration);
  }
  return accelerations;
}

double maximum_direction(const SampledMotion& x, const SampledMotion& y, double period, double damping_ratio) {
  check(x, period, damping_ratio);
  check(y, period, damping_ratio);
  if (x.time_step != y.time_step) {
    throw InvalidParameter("time_step", fmt::format("{}", y.time_step), "must be that of the other component");
  }
  const double omega = 2 * std::numbers::pi / period;
  const double parts = std::max(1.0, std::ceil(omega * x.time_step / turn_of_a_look));
  const Step step(all(omega), damping_ratio, x.time_step / parts);
  // Free vibration is largest within one period after the last sample.
  const auto after = static_cast<std::size_t>(std::ceil(period / x.time_step));
  const std::size_t steps = std::max(x.acceleration.size(), y.acceleration.size()) + after;
  States q;  // x and y are the first two of four
  double largest = 0;
  for (std::size_t i = 0; i < steps; ++i) {
    // A record ends with its last sample, without a slope to zero.
    const auto change = [&](const SampledMotion& motion) {
      return i + 1 < motion.acceleration.size() ? (motion.acceleration[i + 1] - motion.acceleration[i]) / parts : 0.0;
    };
    const auto value = [&](const SampledMotion& motion) {
      return i + 1 < motion.acceleration.size() ? motion.acceleration[i] : 0.0;
    };
    const Four changes{change(x), change(y)}, values{value(x), value(y)};
    for (double part = 0; part < parts; ++part) {
      q = step.advance(q, Ground<Four>{values + part * changes, changes});
      largest = std::max(largest, q.x[0] * q.x[0] + q.x[1] * q.x[1]);
    }
  }
  require_finite("acceleration", largest);
  return omega * omega * std::sqrt(largest);
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
