#include "bentur/structure/known/generic.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

#include "bentur/core/errors.h"
#include "bentur/elements/law.h"
#include "bentur/structure/modes.h"
#include "bentur/structure/stick.h"

namespace bentur {
namespace {

GenericBuilding uniform(std::size_t storeys, double alpha, double period = 0.9) {
  GenericBuilding building;
  building.storey_heights.assign(storeys, 3.2);
  building.floor_masses.assign(storeys, 120);
  building.period = period;
  building.stiffness_ratio = alpha;
  return building;
}

double period(const GenericBuilding& building, Eigen::Index mode) {
  const StructuralModel model = generic_model(building);
  return 2 * std::numbers::pi / modes(model.mass, model.stiffness).omega(mode);
}

double root_between(double from, double to, const std::function<double(double)>& f) {
  const bool rises = f(from) < 0;
  for (int i = 0; i < 200; ++i) {
    const double middle = 0.5 * (from + to);
    ((f(middle) < 0) == rises ? from : to) = middle;
  }
  return from;
}

/// ω_i up to a factor: γ_i √(γ_i² + α²) of a uniform cantilever of flexural and shear stiffness [MirandaTaghavi2005].
/// Its shapes satisfy u'''' − α² u'' = λ u: sin γz, cos γz, sinh βz, cosh βz with β² = α² + γ²; clamped at the foot,
/// free of moment and shear at the top, so that the determinant of those four conditions is zero.
std::vector<double> characteristic_frequencies(double alpha, int count) {
  const auto determinant = [alpha](double gamma) {
    const double beta = std::hypot(alpha, gamma);
    // Divided by cosh β, which overflows.
    return 2 / std::cosh(beta) + (2 + std::pow(alpha, 4) / (gamma * gamma * beta * beta)) * std::cos(gamma) +
           alpha * alpha / (gamma * beta) * std::sin(gamma) * std::tanh(beta);
  };
  std::vector<double> found;
  constexpr double step = 1e-3;
  for (double gamma = step; std::ssize(found) < count; gamma += step) {
    if ((determinant(gamma) < 0) == (determinant(gamma + step) < 0)) continue;
    const double root = root_between(gamma, gamma + step, determinant);
    found.push_back(root * std::hypot(root, alpha));
  }
  return found;
}

TEST(Generic, FirstPeriodIsAsGiven) {
  for (const double alpha : {0.0, 1.0, 4.0, 12.0, 30.0}) EXPECT_NEAR(period(uniform(8, alpha), 0), 0.9, 1e-12) << alpha;
  GenericBuilding by_formula = uniform(8, 4, 0);
  for (double& height : by_formula.storey_heights) height *= 100;  // in cm
  by_formula.period_formula = {{0.0466, 0.9, 100}};
  EXPECT_NEAR(period(by_formula, 0), 0.0466 * std::pow(25.6, 0.9), 1e-12);
}

TEST(Generic, PureBendingIsAPrismaticCantilever) {
  // Lumped at the tip: k = 3EI/h³, so T₂/T₁ of two floors in closed form; the flexibility of a beam.
  const GenericBuilding two = uniform(2, 0);
  const StructuralModel model = generic_model(two);
  Eigen::Matrix2d flexibility;  // EI/h³ times
  flexibility << 1.0 / 3, 5.0 / 6, 5.0 / 6, 8.0 / 3;
  const Eigen::Matrix2d product = model.stiffness * flexibility;
  EXPECT_LE((product / product(0, 0) - Eigen::Matrix2d::Identity()).norm(), 1e-12);
}

TEST(Generic, PureShearIsAStick) {
  const StructuralModel found = generic_model(uniform(5, 30));
  const StructuralModel stick = stick_model(
      {std::vector<double>(5, 3.2), std::vector<double>(5, 120.0), std::vector<double>(5, found.stiffness(4, 4))});
  EXPECT_LE((found.stiffness - stick.stiffness).norm(), 1e-12 * stick.stiffness.norm());
}

TEST(Generic, PeriodsApproachThoseOfTheContinuousCantilever) {
  EXPECT_NEAR(period(uniform(400, 0), 0) / period(uniform(400, 0), 1), 6.2669, 0.02);
  EXPECT_NEAR(period(uniform(400, 30), 0) / period(uniform(400, 30), 1), 3, 0.01);
  for (const double alpha : {0.3, 1.0, 4.0, 12.0, 25.0}) {
    const std::vector<double> expected = characteristic_frequencies(alpha, 4);
    double before = 1;
    for (const std::size_t storeys : {30U, 120U}) {
      double largest = 0;
      for (Eigen::Index mode = 1; mode < 4; ++mode) {
        const GenericBuilding building = uniform(storeys, alpha);
        const double ratio = period(building, 0) / period(building, mode);
        largest = std::max(largest, std::abs(ratio * expected[0] / expected[mode] - 1));
      }
      EXPECT_LT(largest, 3.0 / static_cast<double>(storeys)) << alpha;
      EXPECT_LT(largest, 0.5 * before) << alpha << ": it converges";
      before = largest;
    }
  }
  // The roots themselves at both ends: bending 1.8751², 4.6941²; shear (2i − 1) π/2 times α.
  const std::vector<double> bending = characteristic_frequencies(1e-6, 2);
  EXPECT_NEAR(bending[1] / bending[0], std::pow(4.694091133 / 1.875104069, 2), 1e-6);
  const std::vector<double> shear = characteristic_frequencies(600, 2);
  EXPECT_NEAR(shear[1] / shear[0], 3, 1e-3);
}

TEST(Generic, ShearSpringsYieldAsTheFirstModeLoadsThem) {
  GenericBuilding building = uniform(4, 30);
  building.yield_base_shear = 0.2;
  building.hardening = 0.03;
  const StructuralModel model = generic_model(building);
  const auto laws = storey_laws(building, model, 9.80665);
  ASSERT_EQ(laws.size(), 4U);
  const Eigen::VectorXd shape = modes(model.mass, model.stiffness).shapes.col(0);
  const Eigen::VectorXd drifts = drift_rows(model) * shape;
  const double stiffness = model.stiffness(3, 3);
  EXPECT_NEAR(laws[0]->yield_deformation() * stiffness, 0.2 * 480 * 9.80665, 1e-9 * 480);
  for (Eigen::Index storey = 1; storey < 4; ++storey) {
    EXPECT_NEAR(laws[storey]->yield_deformation() / laws[0]->yield_deformation(), drifts(storey) / drifts(0), 1e-10);
  }
  building.stiffness_ratio = 12;
  EXPECT_THROW((void)storey_laws(building, generic_model(building), 9.80665), InvalidParameter);
  building.yield_base_shear.reset();
  EXPECT_TRUE(storey_laws(building, model, 9.80665).empty());
}

TEST(Generic, ImpossibleOnesAreRefused) {
  EXPECT_THROW((void)generic_model(uniform(0, 4)), InvalidParameter);
  EXPECT_THROW((void)generic_model(uniform(3, -1)), InvalidParameter);
  EXPECT_THROW((void)generic_model(uniform(3, 4, 0)), InvalidParameter);
  GenericBuilding uneven = uniform(3, 4);
  uneven.floor_masses.pop_back();
  EXPECT_THROW((void)generic_model(uneven), InvalidParameter);
  EXPECT_EQ(generic_model(uniform(1, 0)).stiffness.rows(), 1);
}

}  // namespace
}  // namespace bentur
