// Bearings that yield by both directions of a plane at once: a polygon's sides, a square as two laws, the way to a
// circle.
#include "bentur/elements/hinges/polygon_yield.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "bentur/core/errors.h"
#include "bentur/elements/bearing_laws.h"
#include "bentur/elements/hinges.h"
#include "tests/support/driven.h"
#include "tests/support/led_element.h"

namespace bentur::polygon_yields {
namespace {

using Eigen::Vector2d;
using Eigen::VectorXd;

constexpr double after = 900, strength = 50, yield = 0.008;  // K_h, Q, Δ_y
const Bearings bearing = bilinear_bearings(after, strength, yield);

/// A bearing led from place to place along straight lines.
class Led {
 public:
  explicit Led(int sides)
      : of_(polygon_yield(bearing.stiffness, strength, yield, sides)),
        state_(of_.law->begin(VectorXd::Zero(sides / 2))) {}

  void to(const Vector2d& place) {
    state_ = test::driven(*of_.law, state_, of_.directions * at_, of_.directions * place);
    at_ = place;
  }

  [[nodiscard]] Vector2d force() const {
    const auto& law = dynamic_cast<const HingeLaw&>(*of_.law);
    Vector2d sum = bearing.stiffness * at_;
    for (Eigen::Index n = 0; n < law.size(); ++n) {
      sum -= law.record(state_, n).rotation * of_.directions.row(n).transpose();
    }
    return sum;
  }
  [[nodiscard]] Yielded yielded() const { return yielded_of(of_, state_); }
  [[nodiscard]] double stored() const {
    return 0.5 * bearing.stiffness * at_.squaredNorm() + of_.law->stored_energy(state_, of_.directions * at_);
  }

 private:
  PolygonYield of_;
  CoupledState state_;
  Vector2d at_ = Vector2d::Zero();
};

/// Places of a course that turns, comes back and crosses itself.
std::vector<Vector2d> course(int count) {
  std::vector<Vector2d> places;
  for (int i = 1; i <= count; ++i) {
    const double t = 2 * std::numbers::pi * i / count;
    places.emplace_back(0.05 * std::sin(3 * t), 0.04 * std::sin(2 * t + 0.4) - 0.04 * std::sin(0.4));
  }
  return places;
}

/// Along a ray a polygon flows where the ray meets it.
TEST(BearingsInAPlane, APolygonHoldsWhatItsSidesDo) {
  for (const int sides : {4, 8, 12, 16, 64}) {
    for (const double angle : {0.0, 0.3, 0.785, 1.2, std::numbers::pi / 2, 2.9, 4.0}) {
      SCOPED_TRACE(testing::Message() << sides << " sides, " << angle);
      Led led(sides);
      const Vector2d along(std::cos(angle), std::sin(angle));
      led.to(0.2 * along);
      const Vector2d q = led.force() - after * 0.2 * along;
      double most = 0;  // of n · q over the sides
      for (int i = 0; i < sides; ++i) {
        const double normal = 2 * std::numbers::pi * i / sides;
        most = std::max(most, q.dot(Vector2d(std::cos(normal), std::sin(normal))));
      }
      EXPECT_NEAR(most, strength, 1e-9 * strength);
      EXPECT_LE(q.norm(), strength / std::cos(std::numbers::pi / sides) * (1 + 1e-9));
      EXPECT_GE(q.dot(along), strength * (1 - 1e-9));
      EXPECT_NEAR(led.yielded().residual.dot(along), 0.2 - led.force().dot(along) / bearing.stiffness, 1e-9 * 0.2);
    }
  }
}

/// Four sides are the two scalar laws that bearings have without a word.
TEST(BearingsInAPlane, ASquareIsTwoLaws) {
  Led led(4);
  test::LedElement x(*bearing.law, yield), y(*bearing.law, yield);
  for (const Vector2d& place : course(40)) {
    led.to(place);
    x.lead_to(place.x());
    y.lead_to(place.y());
    EXPECT_NEAR(led.force().x(), x.force(), 1e-9 * strength);
    EXPECT_NEAR(led.force().y(), y.force(), 1e-9 * strength);
  }
}

/// The law of a circle, by radial return in steps so small that halving them changes nothing that is looked at.
class Circle {
 public:
  void to(const Vector2d& place, int steps) {
    const Vector2d from = at_;
    for (int i = 1; i <= steps; ++i) {
      at_ = from + (place - from) * i / steps;
      const Vector2d tried = strength / yield * (at_ - yielded_);
      const double beyond = tried.norm() - strength;
      if (beyond > 0) {
        yielded_ += beyond / (strength / yield) * tried.normalized();
        lost_ += beyond / (strength / yield) * strength;
      }
    }
  }
  [[nodiscard]] Vector2d force() const { return after * at_ + strength / yield * (at_ - yielded_); }
  [[nodiscard]] double lost() const { return lost_; }

 private:
  Vector2d at_ = Vector2d::Zero(), yielded_ = Vector2d::Zero();
  double lost_ = 0;
};

/// Forces point up to π/n beside those of the circle, as q stays at corners; what is lost agrees as strengths do.
TEST(BearingsInAPlane, ManySidesAreACircle) {
  const std::vector<Vector2d> places = course(600);
  Circle circle;
  std::vector<Vector2d> wanted;
  for (const Vector2d& place : places) {
    circle.to(place, 400);
    wanted.push_back(circle.force());
  }
  double before = strength;
  for (const int sides : {8, 16, 32, 64}) {
    SCOPED_TRACE(sides);
    Led led(sides);
    double apart = 0;
    for (std::size_t i = 0; i < places.size(); ++i) {
      led.to(places[i]);
      apart = std::max(apart, (led.force() - wanted[i]).norm());
    }
    const double limit = 1 / std::cos(std::numbers::pi / sides) - 1;
    EXPECT_NEAR(led.yielded().energy, circle.lost(), limit * circle.lost());
    EXPECT_LT(apart, (std::numbers::pi / sides + limit) * strength);
    EXPECT_LT(apart, before / 1.8);
    before = apart;
  }
}

/// What goes in is stored or lost, to the midpoint rule of a fine course.
TEST(BearingsInAPlane, EnergyIsKept) {
  Led led(12);
  double work = 0;
  Vector2d at(0, 0), force(0, 0);
  for (const Vector2d& place : course(4000)) {
    led.to(place);
    work += 0.5 * (force + led.force()).dot(place - at);
    at = place;
    force = led.force();
  }
  EXPECT_GT(led.yielded().energy, 5.0);
  EXPECT_NEAR(work, led.stored() + led.yielded().energy, 1e-4 * work);
}

TEST(BearingsInAPlane, RefusesWhatIsNoPolygon) {
  const double k = bearing.stiffness;
  for (const int sides : {0, 2, 6, 68, -4}) {
    EXPECT_THROW((void)polygon_yield(k, strength, yield, sides), InvalidParameter) << sides;
  }
  EXPECT_THROW((void)polygon_yield(k, 0, yield, 8), InvalidParameter);
  EXPECT_THROW((void)polygon_yield(k, strength, 0, 8), InvalidParameter);
  EXPECT_THROW((void)polygon_yield(strength / yield, strength, yield, 8), InvalidParameter);
}

}  // namespace
}  // namespace bentur::polygon_yields
