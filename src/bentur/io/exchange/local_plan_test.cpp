#include "bentur/io/exchange/local_plan.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace bentur {
namespace {

constexpr double radian = std::numbers::pi / 180;

/// On the ellipsoid, from the centre of the Earth [m].
Eigen::Vector3d earth_place(const GeographicPlace& at) {
  const double a = 6378137, f = 1 / 298.257223563, e2 = f * (2 - f);
  const double phi = at.latitude * radian, lambda = at.longitude * radian;
  const double n = a / std::sqrt(1 - e2 * std::sin(phi) * std::sin(phi));
  return {n * std::cos(phi) * std::cos(lambda), n * std::cos(phi) * std::sin(lambda), n * (1 - e2) * std::sin(phi)};
}

TEST(LocalPlan, ADegreeIsAsLongAsTablesOfTheEllipsoidSay) {
  // At 45° a degree of latitude is 111.132 km long, one of longitude 78.847 km; at the equator 110.574 and 111.320.
  const GeographicPlace middle{.longitude = 10, .latitude = 45};
  EXPECT_NEAR(local_plan({10, 45.01}, middle).y(), 1111.32, 0.005);
  EXPECT_NEAR(local_plan({10.01, 45}, middle).x(), 788.47, 0.005);
  EXPECT_NEAR(local_plan({0, 0.01}, {0, 0}).y(), 1105.74, 0.005);
  EXPECT_NEAR(local_plan({0.01, 0}, {0, 0}).x(), 1113.20, 0.006);
  EXPECT_EQ(local_plan(middle, middle), PlanPoint(0, 0));
}

TEST(LocalPlan, DistancesOverABlockOf500MetresAreTrueToFourCentimetres) {
  // The chord through the Earth is shorter than the geodesic by d³/(24 R²), 0.4 μm of a diagonal of 700 m.
  double worst = 0;
  for (const double latitude : {0.0, -6.9, 45.0, 60.0}) {
    const GeographicPlace middle{.longitude = 107.6, .latitude = latitude};
    const double to_x = 1 / local_plan({108.6, latitude}, middle).x();
    const double to_y = 1 / local_plan({107.6, latitude + 1}, middle).y();
    std::vector<GeographicPlace> places;
    for (const double x : {-250.0, -90.0, 0.0, 250.0}) {
      for (const double y : {-250.0, 40.0, 250.0}) places.push_back({107.6 + x * to_x, latitude + y * to_y});
    }
    for (const GeographicPlace& one : places) {
      for (const GeographicPlace& other : places) {
        const double plane = (local_plan(one, middle) - local_plan(other, middle)).norm();
        const double error = std::abs(plane - (earth_place(one) - earth_place(other)).norm());
        worst = std::max(worst, error);
        EXPECT_LE(error, 500 * 250 * std::tan(std::abs(latitude) * radian) / 6.35e6 + 1e-3);
      }
    }
  }
  EXPECT_LT(worst, 0.04);
  EXPECT_GT(worst, 0.03);  // along the edges of a block at 60°
}

}  // namespace
}  // namespace bentur
