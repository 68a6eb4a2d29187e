#include "bentur/structure/damping.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "bentur/core/errors.h"
#include "bentur/structure/modes.h"
#include "bentur/structure/stick.h"

namespace bentur {
namespace {

StructuralModel example() { return stick_model({{3, 3, 3, 3}, {45, 45, 40, 40}, {38e3, 34e3, 30e3, 26e3}}); }

Modes example_modes() {
  const StructuralModel model = example();
  return modes(model.mass, model.stiffness);
}

// ζ of each mode from a diagonal ΦᵀCΦ.
Eigen::VectorXd ratios(const Eigen::MatrixXd& damping, const Modes& shapes) {
  EXPECT_EQ((damping - Eigen::MatrixXd(damping.diagonal().asDiagonal())).norm(), 0);
  return damping.diagonal().cwiseQuotient(2 * shapes.omega);
}

TEST(Damping, OneRatioForAllModes) {
  const Modes shapes = example_modes();
  const Eigen::VectorXd actual = ratios(modal_damping(ModalDamping{{0.05}}, shapes), shapes);
  for (Eigen::Index j = 0; j < 4; ++j) EXPECT_DOUBLE_EQ(actual(j), 0.05);
  EXPECT_EQ(modal_damping(ModalDamping{{0.0}}, shapes).norm(), 0);
}

TEST(Damping, ARatioForEachMode) {
  const Modes shapes = example_modes();
  const Eigen::VectorXd actual = ratios(modal_damping(ModalDamping{{0.05, 0.04, 0.03, 0.0}}, shapes), shapes);
  EXPECT_LE((actual - Eigen::Vector4d(0.05, 0.04, 0.03, 0.0)).cwiseAbs().maxCoeff(), 1e-16);
}

TEST(Damping, RayleighMeetsBothPeriods) {
  const Modes shapes = example_modes();
  const double two_pi = 2 * std::numbers::pi;
  const Eigen::VectorXd actual =
      ratios(modal_damping(RayleighDamping{{0.05, 0.03}, {two_pi / shapes.omega(2), two_pi / shapes.omega(0)}}, shapes),
             shapes);
  EXPECT_NEAR(actual(2), 0.05, 1e-15);
  EXPECT_NEAR(actual(0), 0.03, 1e-15);
}

TEST(Damping, RayleighIsAlphaMPlusBetaK) {
  // ζ = α/(2ω) + βω/2 for equal ratios: α = 2ζω₁ω₂/(ω₁+ω₂), β = 2ζ/(ω₁+ω₂). The same C given as a matrix agrees.
  const StructuralModel model = example();
  const Modes shapes = example_modes();
  const double w1 = 2 * std::numbers::pi / 0.4, w2 = 2 * std::numbers::pi / 0.1;
  const double alpha = 2 * 0.05 * w1 * w2 / (w1 + w2), beta = 2 * 0.05 / (w1 + w2);
  const Eigen::MatrixXd rayleigh = modal_damping(RayleighDamping{{0.05, 0.05}, {0.4, 0.1}}, shapes);
  const Eigen::VectorXd actual = ratios(rayleigh, shapes);
  for (Eigen::Index j = 0; j < 4; ++j) {
    EXPECT_NEAR(actual(j), alpha / (2 * shapes.omega(j)) + beta * shapes.omega(j) / 2, 1e-15);
  }
  const Eigen::MatrixXd matrix = modal_damping(MatrixDamping{alpha * model.mass + beta * model.stiffness}, shapes);
  EXPECT_LE((matrix - rayleigh).cwiseAbs().maxCoeff(), 1e-12 * rayleigh.maxCoeff());
  EXPECT_EQ((matrix - Eigen::MatrixXd(matrix.diagonal().asDiagonal())).norm(), 0);  // classical: off-diagonals are zero
}

TEST(Damping, MassProportional) {
  // (2-25): α = 2 ζ₁ ω₁ is the same in every mode, so ζ_j = ζ₁ ω₁/ω_j.
  const Modes shapes = example_modes();
  const Eigen::VectorXd actual = ratios(modal_damping(MassProportionalDamping{0.05}, shapes), shapes);
  for (Eigen::Index j = 0; j < 4; ++j) EXPECT_NEAR(actual(j), 0.05 * shapes.omega(0) / shapes.omega(j), 1e-16);
}

TEST(Damping, StiffnessProportional) {
  // β = 2ζ₁/ω₁ is the same in every mode, so ζ_j = ζ₁ ω_j/ω₁; C = βK given as a matrix agrees.
  const StructuralModel model = example();
  const Modes shapes = example_modes();
  const Eigen::MatrixXd damping = modal_damping(StiffnessProportionalDamping{0.03}, shapes);
  const Eigen::VectorXd actual = ratios(damping, shapes);
  for (Eigen::Index j = 0; j < 4; ++j) {
    EXPECT_NEAR(actual(j), 0.03 * shapes.omega(j) / shapes.omega(0), 1e-16 * shapes.omega(j));
  }
  const double beta = *stiffness_part(StiffnessProportionalDamping{0.03}, shapes.omega(0));
  EXPECT_DOUBLE_EQ(beta, 2 * 0.03 / shapes.omega(0));
  const Eigen::MatrixXd matrix = modal_damping(MatrixDamping{beta * model.stiffness}, shapes);
  EXPECT_LE((matrix - damping).cwiseAbs().maxCoeff(), 1e-12 * damping.maxCoeff());
}

TEST(Damping, StiffnessPart) {
  // Equal ratios ζ at ω₁ and ω₂: β = 2ζ/(ω₁ + ω₂), whatever the first mode is.
  const double w1 = 2 * std::numbers::pi / 0.4, w2 = 2 * std::numbers::pi / 0.1;
  const auto beta = stiffness_part(RayleighDamping{{0.05, 0.05}, {0.4, 0.1}}, 3);
  ASSERT_TRUE(beta);
  EXPECT_NEAR(*beta, 2 * 0.05 / (w1 + w2), 1e-17);
  EXPECT_LT(*stiffness_part(RayleighDamping{{0.05, 0.001}, {0.4, 0.1}}, 3), 0);
  EXPECT_FALSE(stiffness_part(ModalDamping{{0.05}}, 3));
  EXPECT_FALSE(stiffness_part(MassProportionalDamping{0.05}, 3));
  EXPECT_FALSE(stiffness_part(MatrixDamping{}, 3));
}

TEST(Damping, MatrixThatIsNotClassicalKeepsItsCoupling) {
  // A dashpot at the top floor only: ΦᵀCΦ = c φ_n φ_nᵀ with φ_n the modes' top entries.
  const Modes shapes = example_modes();
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(4, 4);
  matrix(3, 3) = 12;
  const Eigen::MatrixXd actual = modal_damping(MatrixDamping{matrix}, shapes);
  const Eigen::VectorXd top = shapes.shapes.row(3);
  EXPECT_LE((actual - 12 * top * top.transpose()).cwiseAbs().maxCoeff(), 1e-15 * actual.maxCoeff() * 10);
  EXPECT_GT(std::abs(actual(0, 1)), 1e-3 * actual.maxCoeff());
}

TEST(Damping, WeakCouplingOfModesIsKept) {
  // The dashpot beside a C of its own that is classical: however weak, it couples the modes by c φ_n φ_nᵀ. Round-off of
  // the large part, some 1e-16 of it, hides no more than 1e-13 of the coupling that is 1e-3 … 1e-9 of it.
  const StructuralModel model = example();
  const Modes shapes = example_modes();
  const Eigen::MatrixXd classical = 0.3 * model.mass + 0.002 * model.stiffness;
  const double largest = modal_damping(MatrixDamping{classical}, shapes).maxCoeff();
  const Eigen::VectorXd top = shapes.shapes.row(3);
  for (const double part : {1e-3, 1e-6, 1e-9}) {
    const double c = part * largest / top.cwiseAbs2().maxCoeff();
    Eigen::MatrixXd matrix = classical;
    matrix(3, 3) += c;
    const Eigen::MatrixXd actual = modal_damping(MatrixDamping{matrix}, shapes);
    for (Eigen::Index i = 0; i < 4; ++i) {
      for (Eigen::Index j = 0; j < 4; ++j) {
        if (i == j) continue;
        EXPECT_NEAR(actual(i, j), c * top(i) * top(j), 1e-14 * largest) << part;
      }
    }
    EXPECT_GT(std::abs(actual(0, 1)), 1e-2 * c * top.cwiseAbs2().maxCoeff());
  }
}

TEST(Damping, BadParametersAreNamed) {
  const Modes shapes = example_modes();
  const auto expect = [&](const Damping& damping, const std::string& name) {
    try {
      static_cast<void>(modal_damping(damping, shapes));
      ADD_FAILURE() << name << " was taken";
    } catch (const InvalidParameter& error) {
      EXPECT_EQ(std::string(error.what()).rfind(name + " = ", 0), 0U) << error.what();
    }
  };
  expect(ModalDamping{{}}, "damping ratios");
  expect(ModalDamping{{0.05, 0.05}}, "damping ratios");
  expect(ModalDamping{{-0.01}}, "damping ratios[0]");
  expect(ModalDamping{{0.05, 0.05, std::nan(""), 0.05}}, "damping ratios[2]");
  expect(RayleighDamping{{0.05}, {0.4, 0.1}}, "rayleigh ratios");
  expect(RayleighDamping{{0.05, 0.05}, {0.4, 0.1, 0.2}}, "rayleigh periods");
  expect(RayleighDamping{{0.05, 0.05}, {0.4, 0.4}}, "rayleigh periods");
  expect(RayleighDamping{{0.05, 0.05}, {0.4, 0}}, "rayleigh periods[1]");
  expect(RayleighDamping{{0.05, -0.05}, {0.4, 0.1}}, "rayleigh ratios[1]");
  expect(RayleighDamping{{0.20, 0.0}, {0.6, 0.3}}, "rayleigh ratios");  // would feed energy into the upper modes
  expect(MassProportionalDamping{-1}, "mass_proportional");
  expect(StiffnessProportionalDamping{-1}, "stiffness_proportional");
  expect(MatrixDamping{Eigen::MatrixXd::Zero(3, 3)}, "damping matrix");
  expect(MatrixDamping{Eigen::MatrixXd::Constant(4, 4, std::nan(""))}, "damping matrix");
}

TEST(Building, IsPutTogether) {
  const StructuralModel model = example();
  const Building building = make_building("B", model, ModalDamping{{0.03}});
  const Modes shapes = example_modes();
  EXPECT_EQ(building.name, "B");
  EXPECT_EQ(building.model.stiffness, model.stiffness);
  EXPECT_EQ(building.modes.omega, shapes.omega);
  EXPECT_EQ(building.modes.shapes, shapes.shapes);
  EXPECT_EQ(building.modal_damping, modal_damping(ModalDamping{{0.03}}, shapes));
}

}  // namespace
}  // namespace bentur
