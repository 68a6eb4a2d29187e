#include "bentur/solve/motion/polynomial.h"

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>

#include "bentur/solve/motion/kernels/series.h"

namespace bentur::engine {
namespace {

/// Below this part of s an interval is a point.
constexpr double smallest_width = 1e-13;
/// A maximum is not refined beyond this part of its value.
constexpr double round_off = 1e-16;

constexpr auto derivative_factors = [] {
  std::array<double, highest_degree + 1> factors{};
  for (int k = 0; k <= highest_degree; ++k) factors[static_cast<std::size_t>(k)] = k;
  return factors;
}();
constexpr auto integral_factors = [] {
  std::array<double, highest_degree + 1> factors{};
  for (int k = 0; k <= highest_degree; ++k) factors[static_cast<std::size_t>(k)] = 1.0 / (k + 1.0);
  return factors;
}();

/// Root of the continuous f between a and b, where fa and fb differ in sign (or are zero).
template <class Function>
double bracketed_root(const Function& f, double a, double b, double fa, double fb) {
  if (fa == 0.0) return a;
  if (fb == 0.0) return b;
  std::uintmax_t iterations = 100;
  const auto [low, high] =
      boost::math::tools::toms748_solve(f, a, b, fa, fb, boost::math::tools::eps_tolerance<double>(52), iterations);
  return 0.5 * (low + high);
}

kernels::Inspection inspect(const Polynomial& p, double mid, double b) {
  return kernels::inspect(p.coefficients.data(), p.degree, mid, b);
}

class CrossingSearch {
 public:
  explicit CrossingSearch(const Polynomial& p) : p_(p) {}

  /// First crossing in (0, 1], given p(0) ≥ 0.
  std::optional<double> search() const {
    const kernels::Inspection at = inspect(p_, 0.5, 1.0);
    return search(0.0, 1.0, p_[0], at.end, at);
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

  double crossing(double a, double b, double pa, double pb) const {
    return bracketed_root([this](double s) { return value(p_, s); }, a, b, pa, pb);
  }

  std::optional<double> search_convex(double a, double b, double pa, double pb) const {
    if (pb < 0.0) return crossing(a, b, pa, pb);
    const double da = first_derivative(p_, a);
    const double db = first_derivative(p_, b);
    if (da >= 0.0 || db <= 0.0) return std::nullopt;
    const double lowest = bracketed_root([this](double s) { return first_derivative(p_, s); }, a, b, da, db);
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
    const double at_end = value(p_, end);
    const double rise = kernels::leave_chord(p_.coefficients.data(), p_.degree, end);
    if (std::max(measure(p_[0]), measure(at_end)) + rise <= best_) return;
    search(0.0, end, p_[0], at_end);
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
      const double da = first_derivative(p_, a);
      const double db = first_derivative(p_, b);
      if ((da > 0.0 && db < 0.0) || (absolute && da < 0.0 && db > 0.0)) {
        const double tangents_meet = (pb - pa - db * width) / (da - db);  // after a; p stays on one side of both
        if (measure(pa + da * tangents_meet) <= best_) return;
        const double top = bracketed_root([this](double s) { return first_derivative(p_, s); }, a, b, da, db);
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
  const auto term = [&p](int k) { return derivative_factors[static_cast<std::size_t>(k)] * p[k]; };
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

double integral(const Polynomial& p, double end) {
  double sum = 0.0;
  for (int k = p.degree; k >= 0; --k) sum = sum * end + p[k] * integral_factors[static_cast<std::size_t>(k)];
  return sum * end;
}

double root(const Polynomial& p, double a, double b) {
  return bracketed_root([&p](double s) { return value(p, s); }, a, b, value(p, a), value(p, b));
}

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
