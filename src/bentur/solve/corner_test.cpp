// Corners of floors that turn, which strike a wall: closed forms of every law.
#include <gtest/gtest.h>

#include <cmath>

#include "bentur/contact/laws/darmawan.h"
#include "bentur/contact/laws/hertz_damp.h"
#include "bentur/contact/laws/kelvin_voigt.h"
#include "bentur/contact/laws/kelvin_voigt_approach.h"
#include "bentur/contact/laws/linear.h"
#include "bentur/contact/laws/restitution.h"
#include "bentur/contact/restitution_relations.h"
#include "tests/support/free_rectangle.h"

namespace bentur {
namespace {

using namespace bentur::test;

/// Contact points on the wall, `above` the middle of the rectangle, all by one law.
System against_wall(const std::shared_ptr<const ContactLaw>& law, const Vector3d& velocity,
                    const std::vector<double>& above) {
  System system = rectangle(velocity, 0.5);
  for (const double y : above) system.contacts.push_back({{{0, Vector3d(1, 0, -y)}}, law, 0});
  return system;
}

/// The mass that a corner strikes with: 1/m_p = 1/m + y²/J.
constexpr double corner_mass = 1 / (1 / plate_mass + 36 / plate_inertia);

TEST(Corner, RestitutionIsThatOfTheLaw) {  // space-targets 2
  struct One {
    double restitution, impulse, tolerance;  // of the impulse: integrated contacts read it off an interpolant
    std::shared_ptr<const ContactLaw> law;
  };
  constexpr double k = corner_stiffness, speed = 0.8;
  const double d = exact_damping_factor(0.6);
  for (const One& one :
       {One{1.0, 26, 1e-10, std::make_shared<Linear>(k)}, One{0.6, 20.8, 1e-10, std::make_shared<Restitution>(0.6)},
        One{0.35, 17.55, 1e-10, std::make_shared<Restitution>(0.35)},
        One{0.55, 20.15, 1e-10,
            std::make_shared<KelvinVoigt>(k, exact_separation_damping_ratio(0.55), corner_mass,
                                          KelvinVoigt::Release::separation)},
        One{0.6, 20.8, 1e-9, std::make_shared<HertzDamp>(10 * k, d)},
        One{0.6, 20.8, 1e-9, std::make_shared<Darmawan>(k, d / speed)}}) {
    const Solution solution = solved(against_wall(one.law, {-1.6, 0.3, 0.4}, {-6, -1}));
    ASSERT_EQ(solution.impacts.size(), 1U) << one.law->name();
    const Impact& impact = solution.impacts[0];
    EXPECT_EQ(impact.point, 0);
    EXPECT_NEAR(impact.closing_speed, speed, 1e-12);
    EXPECT_NEAR(impact.impulse, one.impulse, one.impulse * one.tolerance) << one.law->name();
    const Vector3d expected(-1.6 - one.impulse / plate_mass, 0.3, 0.4 - 6 * one.impulse / plate_inertia);
    EXPECT_LT((after(solution) - expected).cwiseAbs().maxCoeff(), 1e-10) << one.law->name();
    EXPECT_NEAR(*impact.restitution(), one.restitution, 1e-10) << one.law->name();
  }
}

TEST(Corner, BothPointsAtOnce) {  // space-targets 2, (E-1)
  const Solution solution = solved(against_wall(std::make_shared<Restitution>(0.6), {0.8, 0.3, 0}, {-6, -1}));
  for (const Impact& impact : solution.impacts) {
    EXPECT_NEAR(impact.impulse, impact.point == 0 ? 0.0 : 60.509090909091, 1e-10);
  }
  EXPECT_NEAR(after(solution).x(), 0.8 - 60.509090909091 / plate_mass, 1e-12);
  EXPECT_NEAR(after(solution).z(), -60.509090909091 / plate_inertia, 1e-12);
}

TEST(Corner, DampingRatioOfTheStretchAtACorner) {  // space-targets 2, (P-10)
  constexpr double stretch = 2 * corner_stiffness, ratio = 0.2;
  const double at_corner = ratio * std::sqrt(0.5 * plate_mass / corner_mass);
  struct One {
    double corner, flat;
    std::shared_ptr<const ContactLaw> of_corner, of_stretch;
  };
  using enum KelvinVoigt::Release;
  for (const One& one : {One{0.50860135752094, 0.57174002758478,
                             std::make_shared<KelvinVoigt>(stretch / 2, at_corner, corner_mass, zero_force),
                             std::make_shared<KelvinVoigt>(stretch, ratio, plate_mass, zero_force)},
                         One{0.71316292494839, 0.75613492683831,
                             std::make_shared<KelvinVoigtApproach>(stretch / 2, at_corner, corner_mass),
                             std::make_shared<KelvinVoigtApproach>(stretch, ratio, plate_mass)}}) {
    const Solution corner = solved(against_wall(one.of_corner, {-1.6, 0.3, 0.4}, {-6, -1}));
    EXPECT_NEAR(*corner.impacts.at(0).restitution(), one.corner, 1e-10) << one.of_corner->name();
    const Solution flat = solved(against_wall(one.of_stretch, {0.8, 0, 0}, {0}));
    EXPECT_NEAR(*flat.impacts.at(0).restitution(), one.flat, 1e-10) << one.of_stretch->name();
  }
}

}  // namespace
}  // namespace bentur
