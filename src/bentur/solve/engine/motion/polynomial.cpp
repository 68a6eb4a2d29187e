#include "bentur/solve/engine/motion/polynomial.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "bentur/solve/engine/motion/kernels/power_factors.h"
#include "bentur/solve/engine/motion/kernels/series.h"

namespace bentur::engine {
namespace {

/// Below this part of s an interval is a point.
constexpr double smallest_width = 1e-13;
/// A search by steps that comes no further than this part of s goes on by halves, or if it takes so many.
constexpr double least_progress = 1e-3;
constexpr int most_steps = 16;
/// A maximum is not refined beyond this part of its value.
constexpr double round_off = 1e-16;
constexpr double epsilon = std::numeric_limits<double>::epsilon();

using kernels::power_factors;

/// factor · p + offset.
struct Scaled {
  const Polynomial& p;
  double factor, offset;

  [[nodiscard]] double value(double s) const { return factor * engine::value(p, s) + offset; }
  [[nodiscard]] kernels::Derivatives derivatives(double s) const {
    const kernels::Derivatives at = kernels::derivatives(p.coefficients.data(), p.degree, s);
    return {factor * at.value + offset, factor * at.slope, factor * at.curvature};
  }
  [[nodiscard]] kernels::Survey survey(double end) const {
    const kernels::Survey all = kernels::survey(p.coefficients.data(), p.degree, end);
    const double size = std::abs(factor);
    return {factor * all.end + offset, size * all.rise, size * all.second, size * all.third};
  }
};

/// A place, and what is known there.
struct Place {
  double s, value;
  kernels::Split slope, curvature;

  Place(const Scaled& f, double at) : s(at) {
    const kernels::Splits splits = kernels::splits(f.p.coefficients.data(), f.p.degree, s);
    value = f.factor * splits.value + f.offset;
    slope = scaled(splits.slope, f.factor);
    curvature = scaled(splits.curvature, f.factor);
  }

 private:
  static kernels::Split scaled(const kernels::Split& of, double by) {
    return by < 0.0 ? kernels::Split{-by * of.below, -by * of.above} : kernels::Split{by * of.above, by * of.below};
  }
};

/// Where a derivative is between two places: what is positive in it, and what is negative, grow with s.
struct Range {
  double low, high;
  Range(const kernels::Split& a, const kernels::Split& b) : low(a.above - b.below), high(b.above - a.below) {}
  [[nodiscard]] bool has_one_sign() const { return low >= 0.0 || high <= 0.0; }
};

/// The root of a function between a and b, where it is fa and fb, of different signs or zero. `f` gives value and two
/// derivatives (the second may be zero): Halley's method, kept between the places where the sign is known.
template <class Function>
double bracketed_root(const Function& f, double a, double b, double fa, double fb) {
  if (fa == 0.0) return a;
  if (fb == 0.0) return b;
  constexpr int most = 100;
  double s = a - fa * (b - a) / (fb - fa);
  for (int n = 0; n < most; ++n) {
    const kernels::Derivatives at = f(s);
    ((at.value < 0.0) == (fa < 0.0) ? a : b) = s;
    const double newton = at.value / at.slope;
    if (std::abs(newton) <= epsilon * s || !(a < b)) return s;
    s -= newton / (1.0 - 0.5 * newton * at.curvature / at.slope);
    if (!(s > a && s < b)) s = 0.5 * (a + b);
  }
  return s;
}

double root_of_value(const Scaled& f, double a, double b, double fa, double fb) {
  return bracketed_root([&f](double s) { return f.derivatives(s); }, a, b, fa, fb);
}

double root_of_slope(const Scaled& f, double a, double b, double fa, double fb) {
  const auto slope = [&f](double s) {
    const kernels::Derivatives at = f.derivatives(s);
    return kernels::Derivatives{at.slope, at.curvature, 0.0};
  };
  return bracketed_root(slope, a, b, fa, fb);
}

class CrossingSearch {
 public:
  explicit CrossingSearch(const Scaled& f) : f_(f) {}

  /// First crossing in (0, 1], given f(0) = start ≥ 0.
  std::optional<double> search(double start) const {
    const kernels::Survey all = f_.survey(1.0);
    if (!std::isfinite(all.third)) return std::nullopt;  // numbers have overflowed: nothing can be proven
    if (std::min(start, all.end) >= all.rise) return std::nullopt;
    kernels::Derivatives at = f_.derivatives(0.0);
    double a = 0.0;
    for (int n = 0; n < most_steps; ++n) {
      const auto [safe, crossed] = safe_step(at, all);
      if (a + safe >= 1.0) return std::nullopt;
      if (crossed - safe <= 0.5 * epsilon * (a + safe)) return a + safe;
      if (safe <= 0.25 * epsilon * a) {
        // Where f only touches zero its slope goes with the root of its value.
        if (at.slope < 0.0 && at.slope * at.slope > 2.0 * all.second * at.value) return a;
        break;
      }
      if (n == 1 && safe < least_progress) break;
      a += safe;
      at = f_.derivatives(a);
      if (at.value < 0.0) return a;  // round-off: nothing before it is
    }
    return search(Place(f_, a), Place(f_, 1.0));
  }

 private:
  /// First crossing in (a, b], given f(a) ≥ 0.
  std::optional<double> search(const Place& a, const Place& b) const {
    const double width = b.s - a.s;
    const Range curvature(a.curvature, b.curvature);
    if (!std::isfinite(curvature.high)) return std::nullopt;
    if (std::min(a.value, b.value) >= std::max(curvature.high, 0.0) * width * width / 8.0) return std::nullopt;
    const bool monotone = Range(a.slope, b.slope).has_one_sign();
    if (monotone || curvature.high <= 0.0) {  // concave: never below its chord
      if (b.value >= 0.0) return std::nullopt;
      if (monotone || a.value > 0.0) return root_of_value(f_, a.s, b.s, a.value, b.value);
    } else if (curvature.low >= 0.0) {
      return search_convex(a, b);
    }
    if (width < smallest_width * b.s) return b.value < 0.0 ? std::optional(b.s) : std::nullopt;
    const Place middle(f_, 0.5 * (a.s + b.s));
    if (middle.value < 0.0) return search(a, middle);
    if (const auto found = search(a, middle)) return found;
    return search(middle, b);
  }

  struct Step {
    double safe, crossed;
  };
  /// Before d = `safe` f cannot have come to zero: it is no less than
  ///   f + f' d + c d²/2    with c = −B₂, or as far as X with c = f" − B₃ X/3,                                (T-6)
  /// and beyond `crossed`, where that is finite, it has.
  static Step safe_step(const kernels::Derivatives& at, const kernels::Survey& bounds) {
    const double safe = first_zero(at, -bounds.second);
    const double guess = first_zero(at, at.curvature);
    if (!(guess < 1.0)) return {safe, never};
    const double sag = bounds.third * guess / 3.0;
    const double most = at.curvature + 2.0 * sag;
    if (4.0 * most * at.value > at.slope * at.slope) return {safe, never};  // f may do no more than touch zero
    const double crossed = first_zero(at, most);
    double until = never;
    if (crossed <= 2.0 * guess) until = crossed;
    return {std::max(safe, std::min(guess, first_zero(at, at.curvature - sag))), until};
  }

  static constexpr double never = std::numeric_limits<double>::infinity();

  /// The first zero d ≥ 0 of value + slope d + curvature d²/2.
  static double first_zero(const kernels::Derivatives& at, double curvature) {
    const double square = at.slope * at.slope - 2.0 * curvature * at.value;
    if (square < 0.0) return never;
    if (at.slope < 0.0) return 2.0 * at.value / (std::sqrt(square) - at.slope);
    return curvature < 0.0 ? (at.slope + std::sqrt(square)) / -curvature : never;
  }

  std::optional<double> search_convex(const Place& a, const Place& b) const {
    if (b.value < 0.0) return root_of_value(f_, a.s, b.s, a.value, b.value);
    const double da = a.slope.above - a.slope.below;
    const double db = b.slope.above - b.slope.below;
    if (da >= 0.0 || db <= 0.0) return std::nullopt;
    const double lowest = root_of_slope(f_, a.s, b.s, da, db);
    const double least = f_.value(lowest);
    return least < 0.0 ? std::optional(root_of_value(f_, a.s, lowest, a.value, least)) : std::nullopt;
  }

  const Scaled f_;
};

/// Highest value of f, or of |f| where `absolute`.
template <bool absolute>
class MaximumSearch {
 public:
  MaximumSearch(const Scaled& f, double& best, double& where) : f_(f), best_(best), where_(where) {}

  /// On [0, end]; whether it has been raised.
  bool search(double end) {
    const kernels::Survey all = f_.survey(end);
    const double start = f_.derivatives(0.0).value;
    if (std::max(measure(start), measure(all.end)) + all.rise <= best_) return false;
    take(start, 0.0);
    take(all.end, end);
    if (std::isfinite(all.third)) search(Place(f_, 0.0), Place(f_, end));
    return raised_;
  }

 private:
  /// Between two places, whose values have been taken.
  void search(const Place& a, const Place& b) {
    const double width = b.s - a.s;
    const Range curvature(a.curvature, b.curvature);
    const double rise = (absolute ? std::max(curvature.high, -curvature.low) : -curvature.low) * width * width / 8.0;
    if (std::max(measure(a.value), measure(b.value)) + rise <= best_ || rise <= round_off * best_) return;
    if (width < smallest_width * b.s || Range(a.slope, b.slope).has_one_sign()) return;
    if (curvature.has_one_sign()) {  // one turning point
      const double da = a.slope.above - a.slope.below;
      const double db = b.slope.above - b.slope.below;
      if ((da > 0.0 && db < 0.0) || (absolute && da < 0.0 && db > 0.0)) {
        const double tangents_meet = (b.value - a.value - db * width) / (da - db);  // after a; f is on one side of both
        if (measure(a.value + da * tangents_meet) <= best_) return;
        const double top = root_of_slope(f_, a.s, b.s, da, db);
        take(f_.value(top), top);
      }
      return;
    }
    const Place middle(f_, 0.5 * (a.s + b.s));
    take(middle.value, middle.s);
    search(a, middle);
    search(middle, b);
  }

  static double measure(double x) { return absolute ? std::abs(x) : x; }

  void take(double candidate, double s) {
    if (measure(candidate) > best_) {
      best_ = measure(candidate);
      where_ = s;
      raised_ = true;
    }
  }

  const Scaled f_;
  double& best_;
  double& where_;
  bool raised_ = false;
};

}  // namespace

Polynomial::Polynomial(std::initializer_list<double> values) {
  std::copy(values.begin(), values.end(), coefficients.begin());
}

// Even and odd powers by Horner's rule side by side: neither waits for the other.
double value(const Polynomial& p, double s) {
  const double square = s * s;
  double even = 0.0;
  double odd = 0.0;
  for (int k = p.degree | 1; k > 0; k -= 2) {
    odd = odd * square + p[k];
    even = even * square + p[k - 1];
  }
  return odd * s + even;
}

double first_derivative(const Polynomial& p, double s) {
  return kernels::derivatives(p.coefficients.data(), p.degree, s).slope;
}

Polynomial second_derivative(const Polynomial& p, double rate) {
  Polynomial second;
  second.degree = std::max(p.degree - 2, 0);
  for (int k = 0; k + 2 <= p.degree; ++k) {
    second[k] = p[k + 2] * (power_factors.second[k + 2] * rate);
  }
  return second;
}

double integral(const Polynomial& p, double end) {
  double sum = 0.0;
  for (int k = p.degree; k >= 0; --k) sum = sum * end + p[k] * power_factors.integral[k];
  return sum * end;
}

double root(const Polynomial& p, double a, double b) {
  return root_of_value({p, 1.0, 0.0}, a, b, value(p, a), value(p, b));
}

std::optional<double> first_negative(const Polynomial& p, double factor, double offset) {
  const double start = factor * p[0] + offset;
  if (start < 0.0) return 0.0;
  return CrossingSearch({p, factor, offset}).search(start);
}

std::optional<double> last_zero(const Polynomial& p, double end) {
  const Scaled f{p, 1.0, 0.0};
  const kernels::Derivatives at = f.derivatives(end);
  if (at.value <= 0.0) return end;
  // So near that the slope is what it is at the end: an opening leaves its band there.
  const double step = at.value / at.slope;
  if (step > 0.0 && step <= end && f.survey(end).second * step * step <= epsilon * end * at.slope) return end - step;
  double largest = 0.0;
  double where = 0.0;
  if (!raise_to_maximum(p, end, largest, where, -1.0)) return std::nullopt;
  return root(p, where, end);
}

bool raise_to_maximum(const Polynomial& p, double end, double& best, double& where, double factor) {
  return MaximumSearch<false>({p, factor, 0.0}, best, where).search(end);
}

void raise_to_largest(const Polynomial& p, double end, double& best) {
  double where = 0.0;
  MaximumSearch<true>({p, 1.0, 0.0}, best, where).search(end);
}

}  // namespace bentur::engine
