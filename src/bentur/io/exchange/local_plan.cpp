#include "bentur/io/exchange/local_plan.h"

#include <cmath>
#include <numbers>

namespace bentur {

PlanPoint local_plan(const GeographicPlace& at, const GeographicPlace& middle) {
  constexpr double a = 6378137, flattening = 1 / 298.257223563;  // of WGS 84
  constexpr double e2 = flattening * (2 - flattening);
  constexpr double degree = std::numbers::pi / 180;
  const double sine = std::sin(middle.latitude * degree);
  const double n = a / std::sqrt(1 - e2 * sine * sine);
  const double m = n * (1 - e2) / (1 - e2 * sine * sine);
  return {n * std::cos(middle.latitude * degree) * (at.longitude - middle.longitude) * degree,
          m * (at.latitude - middle.latitude) * degree};
}

}  // namespace bentur
