#include "bentur/solve/engine/motion/polynomial.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

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

using kernels::power_factors;

kernels::Derivatives derivatives(const Polynomial& p, double s) {
  return kernels::derivatives(p.coefficients.data(), p.degree, s);
}

/// The root of a function between a and b, where it is fa and fb, of different signs or zero. `f` gives value and
/// slope: Newton's method, kept between the places where the sign is known.
template <class Function>
double bracketed_root(const Function& f, double a, double b, double fa, double fb) {
  if (fa == 0.0) return a;
  if (fb == 0.0) return b;
  constexpr int most = 100;
  double s = a - fa * (b - a) / (fb - fa);
  for (int n = 0; n < most; ++n) {
    const auto [value, slope] = f(s);
    ((value < 0.0) == (fa < 0.0) ? a : b) = s;
    const double step = value / slope;
    if (std::abs(step) <= std::numeric_limits<double>::epsilon() * s || !(a < b)) return s;
    s -= step;
    if (!(s > a && s < b)) s = 0.5 * (a + b);
  }
  return s;
}

double root_of_value(const Polynomial& p, double a, double b, double pa, double pb) {
  const auto f = [&p](double s) {
    const kernels::Derivatives at = derivatives(p, s);
    return std::make_pair(at.value, at.slope);
  };
  return bracketed_root(f, a, b, pa, pb);
}

double root_of_slope(const Polynomial& p, double a, double b, double da, double db) {
  const auto f = [&p](double s) {
    const kernels::Derivatives at = derivatives(p, s);
    return std::make_pair(at.slope, at.curvature);
  };
  return bracketed_root(f, a, b, da, db);
}

kernels::Inspection inspect(const Polynomial& p, double mid, double b) {
  return kernels::inspect(p.coefficients.data(), p.degree, mid, b);
}

class CrossingSearch {
 public:
  explicit CrossingSearch(const Polynomial& p) : p_(p) {}

  /// First crossing in (0, 1], given p(0) ≥ 0.
  std::optional<double> search() const {
    const kernels::Survey all = kernels::survey(p_.coefficients.data(), p_.degree, 1.0);
    if (!std::isfinite(all.second)) return std::nullopt;  // numbers have overflowed: nothing can be proven
    if (std::min(p_[0], all.end) >= all.rise) return std::nullopt;
    kernels::Derivatives at{p_[0], p_[1], 0.0};
    double a = 0.0;
    for (int n = 0; n < most_steps; ++n) {
      const double safe = safe_step(at, all.second);
      if (a + safe >= 1.0) return std::nullopt;
      if (safe <= 0.25 * std::numeric_limits<double>::epsilon() * a) {
        // Where p only touches zero its slope goes with the root of its value.
        if (at.slope < 0.0 && at.slope * at.slope > 2.0 * all.second * at.value) return a;
        break;
      }
      if (n == 1 && safe < least_progress) break;
      a += safe;
      at = derivatives(p_, a);
      if (at.value < 0.0) return a;  // round-off: nothing before it is
    }
    return search(a, 1.0, at.value, all.end);
  }

 private:
  /// First crossing in (a, b], given p(a) = pa ≥ 0 and p(b) = pb.
  std::optional<double> search(double a, double b, double pa, double pb) const {
    return search(a, b, pa, pb, inspect(p_, 0.5 * (a + b), b));
  }

  std::optional<double> search(double a, double b, double pa, double pb, const kernels::Inspection& at) const {
    const double width = b - a;
    const double mid = 0.5 * (a + b);
    if (!std::isfinite(at.second)) return std::nullopt;  // numbers have overflowed: nothing can be proven
    if (std::min(pa, pb) >= at.second * width * width / 8.0) return std::nullopt;
    const bool monotone = std::abs(at.slope) > at.second * width / 2.0;
    if (monotone) return pb < 0.0 ? std::optional(crossing(a, b, pa, pb)) : std::nullopt;
    if (std::abs(at.curvature) > at.third * width / 2.0) {
      if (at.curvature > 0.0) return search_convex(a, b, pa, pb);
      if (pb >= 0.0) return std::nullopt;  // concave: never below its chord
      if (pa > 0.0) return crossing(a, b, pa, pb);
    }
    if (width < smallest_width * b) return pb < 0.0 ? std::optional(b) : std::nullopt;
    const double pm = value(p_, mid);
    if (pm < 0.0) return search(a, mid, pa, pm);
    if (const auto found = search(a, mid, pa, pm)) return found;
    return search(mid, b, pm, pb);
  }

  /// Largest d for which value + slope d − bound d²/2 ≥ 0.                                                    (T-6)
  static double safe_step(const kernels::Derivatives& at, double bound) {
    const double root = std::sqrt(at.slope * at.slope + 2.0 * bound * at.value);
    return at.slope < 0.0 ? 2.0 * at.value / (root - at.slope) : (at.slope + root) / bound;
  }

  double crossing(double a, double b, double pa, double pb) const { return root_of_value(p_, a, b, pa, pb); }

  std::optional<double> search_convex(double a, double b, double pa, double pb) const {
    if (pb < 0.0) return crossing(a, b, pa, pb);
    const double da = first_derivative(p_, a);
    const double db = first_derivative(p_, b);
    if (da >= 0.0 || db <= 0.0) return std::nullopt;
    const double lowest = root_of_slope(p_, a, b, da, db);
    const double pl = value(p_, lowest);
    return pl < 0.0 ? std::optional(crossing(a, lowest, pa, pl)) : std::nullopt;
  }

  const Polynomial& p_;
};

/// Highest value of p, or of |p| where `absolute`.
template <bool absolute>
class MaximumSearch {
 public:
  MaximumSearch(const Polynomial& p, double& best, double& where) : p_(p), best_(best), where_(where) {}

  /// On [0, end].
  void search(double end) {
    const kernels::Survey all = kernels::survey(p_.coefficients.data(), p_.degree, end);
    if (std::max(measure(p_[0]), measure(all.end)) + all.rise <= best_) return;
    search(0.0, end, p_[0], value(p_, end));
  }

  [[nodiscard]] bool raised() const { return raised_; }

 private:
  /// On [a, b], given p(a) = pa and p(b) = pb.
  void search(double a, double b, double pa, double pb) { search(a, b, pa, pb, inspect(p_, 0.5 * (a + b), b)); }

  void search(double a, double b, double pa, double pb, const kernels::Inspection& at) {
    take(pa, a);
    take(pb, b);
    const double width = b - a;
    const double mid = 0.5 * (a + b);
    const double rise = at.second * width * width / 8.0;
    if (!std::isfinite(rise)) return;  // numbers have overflowed
    if (std::max(measure(pa), measure(pb)) + rise <= best_ || rise <= round_off * best_ || width < smallest_width * b) {
      return;
    }
    if (std::abs(at.slope) > at.second * width / 2.0) return;  // monotone: the ends were taken
    if (std::abs(at.curvature) > at.third * width / 2.0) {     // p' is monotone: one turning point
      const double da = derivatives(p_, a).slope;
      const double db = derivatives(p_, b).slope;
      if ((da > 0.0 && db < 0.0) || (absolute && da < 0.0 && db > 0.0)) {
        const double tangents_meet = (pb - pa - db * width) / (da - db);  // after a; p stays on one side of both
        if (measure(pa + da * tangents_meet) <= best_) return;
        const double top = root_of_slope(p_, a, b, da, db);
        take(value(p_, top), top);
      }
      return;
    }
    const double pm = value(p_, mid);
    search(a, mid, pa, pm);
    search(mid, b, pm, pb);
  }

  static double measure(double x) { return absolute ? std::abs(x) : x; }

  void take(double candidate, double s) {
    if (measure(candidate) > best_) {
      best_ = measure(candidate);
      where_ = s;
      raised_ = true;
    }
  }

  const Polynomial& p_;
  double& best_;
  double& where_;
  bool raised_ = false;
};

}  // namespace

Polynomial::Polynomial(std::initializer_list<double> values) {
  std::copy(values.begin(), values.end(), coefficients.begin());
}

Polynomial Polynomial::operator-() const {
  Polynomial p = *this;
  for (int k = 0; k <= degree; ++k) p[k] = -p[k];
  return p;
}

// Even and odd powers by Horner's rule side by side: neither waits for the other.

double value(const Polynomial& p, double s) {
  const double square = s * s;
  double first = p[p.degree];
  double second = p.degree > 0 ? p[p.degree - 1] : 0.0;
  int k = p.degree - 2;
  for (; k >= 1; k -= 2) {
    first = first * square + p[k];
    second = second * square + p[k - 1];
  }
  if (k == 0) return (first * s + second) * s + p[0];
  return p.degree > 0 ? first * s + second : first;
}

double first_derivative(const Polynomial& p, double s) {
  if (p.degree == 0) return 0.0;
  const double square = s * s;
  const auto term = [&p](int k) { return power_factors.first[k] * p[k]; };
  double first = term(p.degree);
  double second = term(p.degree - 1);
  int k = p.degree - 2;
  for (; k >= 2; k -= 2) {
    first = first * square + term(k);
    second = second * square + term(k - 1);
  }
  if (k == 1) return (first * s + second) * s + p[1];
  return p.degree > 1 ? first * s + second : first;
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

double root(const Polynomial& p, double a, double b) { return root_of_value(p, a, b, value(p, a), value(p, b)); }

std::optional<double> first_negative(const Polynomial& p) {
  if (p[0] < 0.0) return 0.0;
  return CrossingSearch(p).search();
}

bool raise_to_maximum(const Polynomial& p, double end, double& best, double& where) {
  MaximumSearch<false> search(p, best, where);
  search.search(end);
  return search.raised();
}

void raise_to_largest(const Polynomial& p, double end, double& best) {
  double where = 0.0;
  MaximumSearch<true>(p, best, where).search(end);
}

}  // namespace bentur::engine
