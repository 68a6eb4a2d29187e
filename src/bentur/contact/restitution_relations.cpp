#include "bentur/contact/restitution_relations.h"

#include <fmt/format.h>

#include <boost/math/special_functions/log1p.hpp>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>

#include "bentur/core/errors.h"
#include "bentur/core/require.h"

namespace bentur {
namespace {

constexpr double smallest_restitution = 1e-150;

void require_restitution(double e) {
  if (!(e > 0 && e <= 1)) throw InvalidParameter("restitution", fmt::format("{}", e), "must be in (0, 1]");
  if (e < smallest_restitution) {
    throw InvalidParameter("restitution", fmt::format("{}", e), fmt::format("must be >= {}", smallest_restitution));
  }
}

/// The root of f in [low, high], where f has different signs, to the last bit that f can tell.
template <class Function>
double root(const Function& f, double low, double high) {
  const double at_low = f(low), at_high = f(high);
  if (at_low == 0) return low;
  if (at_high == 0) return high;
  std::uintmax_t iterations =
      200;  // bisection alone would need 64 for every double of one binade, and TOMS 748 is faster
  const auto closed = [](double a, double b) { return std::nextafter(a, b) == b || a == b; };
  const auto [a, b] = boost::math::tools::toms748_solve(f, low, high, at_low, at_high, closed, iterations);
  return std::abs(f(a)) < std::abs(f(b)) ? a : b;
}

/// z A(z) of (C-10): from 0 at z = 0 upwards without end, and above ln z.
double damping_exponent(double z) {
  if (z < 1) return z * std::acos(z) / std::sqrt((1 - z) * (1 + z));
  if (z > 1) return z * std::acosh(z) / (std::sqrt(z - 1) * std::sqrt(z + 1));
  return 1;
}

/// z of exp(−z A(z)) = e.
double inverse_damping_exponent(double e) {
  if (e == 1) return 0;
  const double wanted = -std::log(e);
  return root([&](double z) { return damping_exponent(z) - wanted; }, 0, 2 / e);
}

}  // namespace

double damping_factor_restitution(double d) {
  require_not_negative("damping_factor", d);
  if (d == 0) return 1;
  // With b = d e: ln(1 + d) − d = ln(1 − b) + b. The right side falls from 0 at b = 0 to −∞ at b = 1, and faster than
  // the left one falls with d, so that b < d.
  const double left = boost::math::log1pmx(d);
  const auto gap = [&](double b) { return boost::math::log1pmx(-b) - left; };
  const double below_one = std::nextafter(1.0, 0.0);
  const double most = std::min(d, below_one);
  if (gap(most) >= 0) return most / d;  // nearer to its bound than doubles are to each other
  return root(gap, 0, most) / d;
}

double exact_damping_factor(double e) {
  require_restitution(e);
  if (e == 1) return 0;
  // (C-6) as above, in b = d e, which stays in (0, 1) whatever e. Where b is small, b ≈ 3 e (1 − e²)/(2 (1 + e³)).
  const auto gap = [&](double b) { return boost::math::log1pmx(-b) - boost::math::log1pmx(b / e); };
  const double estimate = 1.5 * e * (1 - e * e) / (1 + e * e * e);
  const double low = std::min(estimate, 0.5) / 16;
  const double high = std::nextafter(1.0, 0.0);
  if (gap(high) >= 0) return high / e;  // nearer to 1/e than doubles are to each other
  return root(gap, low, high) / e;
}

double approach_restitution(double damping_ratio, double exponent) {
  require_not_negative("damping_ratio", damping_ratio);
  require_positive("exponent", exponent);
  return std::exp(-damping_exponent(damping_ratio * std::sqrt(2 / (exponent + 1))));
}

double exact_approach_damping_ratio(double e, double exponent) {
  require_restitution(e);
  require_positive("exponent", exponent);
  return inverse_damping_exponent(e) * std::sqrt((exponent + 1) / 2);
}

double zero_force_restitution(double damping_ratio) {
  require_not_negative("damping_ratio", damping_ratio);
  return std::exp(-2 * damping_exponent(damping_ratio));
}

double exact_zero_force_damping_ratio(double e) {
  require_restitution(e);
  return inverse_damping_exponent(std::sqrt(e));
}

double separation_restitution(double damping_ratio) {
  require_not_negative("damping_ratio", damping_ratio);
  if (damping_ratio >= 1)
    throw InvalidParameter("damping_ratio", fmt::format("{}", damping_ratio), "must be in [0, 1)");
  return std::exp(-std::numbers::pi * damping_ratio / std::sqrt((1 - damping_ratio) * (1 + damping_ratio)));
}

double exact_separation_damping_ratio(double e) {
  require_restitution(e);
  return -std::log(e) / std::hypot(std::numbers::pi, std::log(e)) + 0.0;  // + 0: no negative zero at e = 1
}

namespace published {

double anagnostopoulos_damping_ratio(double e) { return exact_separation_damping_ratio(e); }

double mahmoud_jankowski_damping_ratio(double e) {
  require_restitution(e);
  return (1 - e * e) / (e * (e * (std::numbers::pi - 2) + 2));
}

double jankowski_damping_ratio(double e) {
  require_restitution(e);
  return 4.5 * std::sqrt(5.0) * (1 - e * e) / (e * (e * (9 * std::numbers::pi - 16) + 16));
}

double muthukumar_desroches_damping_factor(double e) {
  require_restitution(e);
  return 0.75 * (1 - e * e);
}

double ye_damping_factor(double e) {
  require_restitution(e);
  return 8 * (1 - e) / (5 * e);
}

}  // namespace published
}  // namespace bentur
