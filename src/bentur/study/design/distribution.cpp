#include "bentur/study/design/distribution.h"

#include <algorithm>
#include <boost/math/special_functions/erf.hpp>
#include <cmath>
#include <numbers>

namespace bentur {
namespace {

constexpr double smallest_probability = 0x1p-54;     // of any sample
constexpr double largest_probability = 1 - 0x1p-53;  // and the largest
constexpr double far = 40;                           // standard deviations that no sample is away

/// The standard normal z of probability u in what lies between z_low and z_high. Reckoned from the nearer tail, where
/// probabilities keep their digits.
double truncated(double u, double z_low, double z_high) {
  if (z_low > 0) return -truncated(1 - u, -z_high, -z_low);
  const double p_low = normal_probability(z_low);
  return std::clamp(normal_quantile(p_low + u * (normal_probability(z_high) - p_low)), z_low, z_high);
}

}  // namespace

double normal_probability(double z) { return 0.5 * std::erfc(-z / std::numbers::sqrt2); }

double log_normal_probability(double z) {
  constexpr double far_tail = -25.0;  // Φ is 3e-138 there, and five terms of its expansion are exact to 1e-11
  if (z > 1) return std::log1p(-normal_probability(-z));
  if (z > far_tail) return std::log(normal_probability(z));
  const double s = 1 / (z * z);
  const double series = 1 - s * (1 - 3 * s * (1 - 5 * s * (1 - 7 * s)));
  return -0.5 * z * z - 0.5 * std::log(2 * std::numbers::pi) + std::log(-series / z);
}

double normal_quantile(double p) { return -std::numbers::sqrt2 * boost::math::erfc_inv(2 * p); }

double Distribution::quantile(double u) const {
  switch (kind) {
    case Kind::uniform:
      return std::clamp(low + (high - low) * u, low, high);
    case Kind::log_uniform:
      return std::clamp(low * std::exp(std::log(high / low) * u), low, high);
    case Kind::normal:
      return std::clamp(centre + spread * truncated(u, (low - centre) / spread, (high - centre) / spread), low, high);
    case Kind::lognormal:
      break;
  }
  const double z_low = low > 0 ? std::log(low / centre) / spread : -std::numeric_limits<double>::infinity();
  const double z_high = std::log(high / centre) / spread;
  return std::clamp(centre * std::exp(spread * truncated(u, z_low, z_high)), std::max(low, 0.0), high);
}

double Distribution::deviations_off() const {
  if (kind == Kind::normal) return std::max({0.0, low - centre, centre - high}) / spread;
  if (kind == Kind::lognormal) {
    return std::max({0.0, low > 0 ? std::log(low / centre) : 0.0, std::log(centre / high)}) / spread;
  }
  return 0;
}

double lognormal_spread(double cov) { return std::sqrt(std::log1p(cov * cov)); }

Extremes extremes(const Distribution& d) {
  Extremes result{d.low, d.high};
  const bool normal = d.kind == Distribution::Kind::normal;
  if (normal && !std::isfinite(d.low)) result.low = -(std::abs(d.centre) + far * d.spread);
  if (d.kind == Distribution::Kind::lognormal && !(d.low > 0)) result.low = d.quantile(smallest_probability);
  if (!std::isfinite(d.high)) {
    result.high = std::max(2.0, normal ? d.centre + far * d.spread : d.quantile(largest_probability));
  }
  return result;
}

}  // namespace bentur
