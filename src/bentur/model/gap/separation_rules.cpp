#include "bentur/model/gap/separation_rules.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "bentur/core/errors.h"

namespace bentur {

double separation_abs(const SeparationInput& a, const SeparationInput& b) { return a.displacement + b.displacement; }

double separation_srss(const SeparationInput& a, const SeparationInput& b) {
  return std::hypot(a.displacement, b.displacement);
}

double separation_ddc(const SeparationInput& a, const SeparationInput& b) {
  const double u_a = a.displacement;
  const double u_b = b.displacement;
  // (u_A − u_B)² + 2(1 − ρ) u_A u_B keeps its digits where ρ is near one and the displacements are alike.
  const double square = (u_a - u_b) * (u_a - u_b) + 2 * (1 - ddc_correlation(a, b)) * u_a * u_b;
  return std::sqrt(std::max(0.0, square));
}

double ddc_correlation(const SeparationInput& a, const SeparationInput& b) {
  for (const SeparationInput* side : {&a, &b}) {
    if (!(side->period > 0) || !std::isfinite(side->period)) {
      throw InvalidParameter("period", std::to_string(side->period), "must be finite and > 0");
    }
    if (!(side->damping_ratio >= 0) || !std::isfinite(side->damping_ratio)) {
      throw InvalidParameter("damping_ratio", std::to_string(side->damping_ratio), "must be finite and >= 0");
    }
  }
  const double za = a.damping_ratio;
  const double zb = b.damping_ratio;
  const double r = b.period / a.period;
  const double detuning = (1 - r) * (1 + r);
  const double denominator = detuning * detuning + 4 * za * zb * r * (1 + r * r) + 4 * (za * za + zb * zb) * r * r;
  if (denominator == 0) {
    return 1;  // undamped and of one period: the limit of equal damping ratios going to zero
  }
  return 8 * std::sqrt(za * zb) * (zb + r * za) * r * std::sqrt(r) / denominator;
}

}  // namespace bentur
