#include "bentur/structure/stick.h"

#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <string_view>

#include "bentur/core/errors.h"
#include "bentur/elements/kinematic_hardening.h"
#include "bentur/elements/peak_oriented.h"
#include "bentur/structure/modes.h"

namespace bentur {
namespace {

TEST(Stick, Matrices) {
  const StructuralModel model = stick_model({{3.5, 3.0, 3.0}, {30, 28, 25}, {40e3, 36e3, 30e3}}, 1.5);
  Eigen::MatrixXd stiffness(3, 3);
  stiffness << 76e3, -36e3, 0, -36e3, 66e3, -30e3, 0, -30e3, 30e3;
  EXPECT_EQ(model.stiffness, stiffness);
  EXPECT_EQ(model.load, (Eigen::Vector3d(30, 28, 25)));
  EXPECT_EQ(model.mass, Eigen::MatrixXd(model.load.asDiagonal()));
  EXPECT_EQ(model.elevations, (std::vector<double>{5.0, 8.0, 11.0}));
  EXPECT_EQ(model.storey_heights, (std::vector<double>{3.5, 3.0, 3.0}));
  EXPECT_EQ(model.floor_masses, (std::vector<double>{30, 28, 25}));
}

TEST(Stick, SpringsInSeries) {
  // A unit force at the top moves floor j by Σ 1/k up to it.
  const StructuralModel model = stick_model({{3, 3, 3}, {1, 1, 1}, {2e4, 5e4, 1e4}});
  const Eigen::Vector3d force(0, 0, 1);
  const Eigen::Vector3d expected(1 / 2e4, 1 / 2e4 + 1 / 5e4, 1 / 2e4 + 1 / 5e4 + 1 / 1e4);
  EXPECT_LE((model.stiffness * expected - force).norm(), 1e-14);
}

TEST(Stick, ReferencePeriods) {
  // The three sticks of the reference row [m, kN], from an independent program.
  const auto check = [](const Stick& stick, const std::vector<double>& expected) {
    const StructuralModel model = stick_model(stick);
    const Eigen::VectorXd actual = modal_properties(modes(model.mass, model.stiffness), model.load).periods;
    for (std::size_t i = 0; i < expected.size(); ++i) {
      EXPECT_NEAR(actual(static_cast<Eigen::Index>(i)) / expected[i], 1, 1e-12) << i;
    }
  };
  check({{3.5, 3, 3}, {30, 28, 25}, {40e3, 36e3, 30e3}},
        {0.3767042445936881, 0.14487761420553638, 0.10020873499112165});
  check({{3.5, 3, 3, 3}, {45, 45, 40, 40}, {38e3, 34e3, 30e3, 26e3}},
        {0.6274771721666011, 0.2354288264043829, 0.15219494522043855, 0.1242955622884058});
  check({{3.5, 3, 3, 3}, {20, 20, 20, 18}, {60e3, 50e3, 45e3, 40e3}},
        {0.34686896635381675, 0.12680928214474882, 0.08435774885893668, 0.0685902471212823});
}

double number_of(const Law& law, std::string_view name) {
  for (const auto& [key, value] : law.parameters()) {
    if (key == name) return value;
  }
  ADD_FAILURE() << name;
  return 0;
}

TEST(StoreyLaws, ThereAreNoneWithoutYieldForces) {
  Stick stick = {{3, 3}, {30, 25}, {40e3, 36e3}};
  EXPECT_TRUE(storey_laws(stick, stick_model(stick)).empty());
  stick.yield_forces = {std::numeric_limits<double>::infinity()};  // no storey ever reaches it
  EXPECT_TRUE(storey_laws(stick, stick_model(stick)).empty());
}

TEST(StoreyLaws, OneValueForAllOrOneEach) {
  Stick stick = {{3, 3, 3}, {30, 28, 25}, {40e3, 36e3, 30e3}};
  stick.yield_forces = {400, std::numeric_limits<double>::infinity(), 210};
  stick.hardening = {0.05};
  const auto laws = storey_laws(stick, stick_model(stick));
  ASSERT_EQ(laws.size(), 3U);
  EXPECT_EQ(laws[1], nullptr);
  EXPECT_EQ(laws[0]->name(), "bilinear");
  EXPECT_EQ(laws[0]->initial_stiffness(), 40e3);
  EXPECT_EQ(laws[2]->initial_stiffness(), 30e3);
  EXPECT_EQ(laws[0]->yield_deformation(), 400 / 40e3);
  EXPECT_EQ(number_of(*laws[2], "yield_force"), 210);
  EXPECT_EQ(number_of(*laws[2], "hardening"), 0.05);
  stick.yield_forces = {400};
  stick.hardening = {0.01, 0.02, 0.03};
  stick.hysteresis = "peak-oriented";
  stick.law_numbers["unloading_exponent"] = 0.4;
  const auto oriented = storey_laws(stick, stick_model(stick));
  for (std::size_t j = 0; j < 3; ++j) {
    EXPECT_EQ(oriented.at(j)->name(), "peak-oriented");
    EXPECT_EQ(number_of(*oriented[j], "yield_force"), 400);
    EXPECT_EQ(number_of(*oriented[j], "hardening"), stick.hardening[j]);
    EXPECT_EQ(number_of(*oriented[j], "unloading_exponent"), 0.4);
  }
}

// A stiffness that has been scaled is that of the laws, so that the elastic branch is what the modes are made of.
TEST(StoreyLaws, FollowACalibratedStiffness) {
  Stick stick = {{3, 3, 3}, {30, 28, 25}, {40e3, 36e3, 30e3}};
  stick.yield_forces = {300};
  StructuralModel model = stick_model(stick);
  calibrate_period(model, 0.8);
  const auto laws = storey_laws(stick, model);
  // K of a shear building is of neighbouring storeys: each off-diagonal is that of one. Two roundings apart.
  EXPECT_NEAR(laws.at(1)->initial_stiffness() / -model.stiffness(0, 1), 1, 5e-16);
  EXPECT_NEAR(laws.at(2)->initial_stiffness() / -model.stiffness(1, 2), 1, 5e-16);
  EXPECT_NEAR((laws.at(0)->initial_stiffness() + laws[1]->initial_stiffness()) / model.stiffness(0, 0), 1, 5e-16);
  EXPECT_EQ(number_of(*laws[0], "yield_force"), 300);  // which is not scaled
}

TEST(StoreyLaws, BadParametersAreRefused) {
  Stick stick = {{3, 3}, {30, 25}, {40e3, 36e3}};
  const StructuralModel model = stick_model(stick);
  const auto refused = [&](const std::vector<double>& forces, const std::vector<double>& hardening, double exponent) {
    stick.yield_forces = forces;
    stick.hardening = hardening;
    stick.law_numbers = {{"unloading_exponent", exponent}};
    EXPECT_THROW(static_cast<void>(storey_laws(stick, model)), InvalidParameter);
  };
  refused({1, 2, 3}, {}, 0);
  refused({1, 2}, {0, 0, 0}, 0);
  refused({0}, {}, 0);
  refused({-std::numeric_limits<double>::infinity()}, {}, 0);
  refused({1}, {1}, 0);
  stick.hysteresis = "peak-oriented";
  refused({1}, {}, 1.5);
}

TEST(Stick, BadParametersAreNamed) {
  const auto expect = [](const Stick& stick, const std::string& name) {
    try {
      static_cast<void>(stick_model(stick));
      ADD_FAILURE() << name << " was taken";
    } catch (const InvalidParameter& error) {
      EXPECT_EQ(std::string(error.what()).rfind(name + " = ", 0), 0U) << error.what();
    }
  };
  const double infinity = std::numeric_limits<double>::infinity();
  expect({{}, {}, {}}, "storey_heights");
  expect({{3, 3}, {1}, {1, 1}}, "masses");
  expect({{3, 3}, {1, 1}, {1, 1, 1}}, "stiffnesses");
  expect({{3, 0}, {1, 1}, {1, 1}}, "storey_heights[1]");
  expect({{3, 3}, {-1, 1}, {1, 1}}, "masses[0]");
  expect({{3, 3}, {1, 1}, {1, infinity}}, "stiffnesses[1]");
  EXPECT_THROW(static_cast<void>(stick_model({{3}, {1}, {1}}, infinity)), InvalidParameter);
}

}  // namespace
}  // namespace bentur
