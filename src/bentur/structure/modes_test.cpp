#include "bentur/structure/modes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>
#include <vector>

#include "bentur/core/errors.h"
#include "bentur/structure/frame/plane_frame.h"
#include "bentur/structure/stick.h"
#include "tests/support/exact/monograph_frames.h"
#include "tests/support/exact/shear_building.h"

namespace bentur {
namespace {

using Solver = Modes (*)(const Eigen::MatrixXd&, const Eigen::MatrixXd&);
constexpr Solver solvers[] = {&modes, &modes_by_jacobi};

StructuralModel uniform_stick(int storeys, double mass, double stiffness) {
  const auto n = static_cast<std::size_t>(storeys);
  return stick_model({std::vector<double>(n, 3.0), std::vector<double>(n, mass), std::vector<double>(n, stiffness)});
}

// Structures of several kinds: shear buildings, frames condensed and not, matrices from elsewhere.
std::vector<StructuralModel> examples() {
  std::vector<StructuralModel> result = {uniform_stick(1, 2, 300), uniform_stick(12, 30, 4e4),
                                         stick_model({{3, 3, 3, 3}, {45, 45, 40, 40}, {38e3, 34e3, 30e3, 26e3}})};
  for (int model = 1; model <= 4; ++model) {
    for (const Condensation each : {Condensation::static_, Condensation::dynamic, Condensation::none}) {
      PlaneFrame frame = exact::monograph_frame(model);
      frame.condensation = each;
      result.push_back(plane_frame_model(frame));
    }
  }
  StructuralModel imported;
  imported.mass.resize(4, 4);
  imported.mass << 52, 1.5, 0, 0, 1.5, 50, 1.5, 0, 0, 1.5, 50, 1.2, 0, 0, 1.2, 44;
  imported.stiffness.resize(4, 4);
  imported.stiffness << 150e3, -78e3, 6e3, 0, -78e3, 138e3, -70e3, 5e3, 6e3, -70e3, 116e3, -52e3, 0, 5e3, -52e3, 47e3;
  imported.load = imported.mass.rowwise().sum();
  result.push_back(imported);
  return result;
}

TEST(Modes, UniformShearBuilding) {
  const double m = 25, k = 3.2e4;
  for (const Solver solver : solvers) {
    for (const int n : {1, 2, 3, 7, 20}) {
      const StructuralModel model = uniform_stick(n, m, k);
      const Modes result = solver(model.mass, model.stiffness);
      for (int j = 1; j <= n; ++j) {
        const double expected = exact::shear_building_omega(k, m, n, j);
        // ω² is known to round-off of the largest one, (2n+1)²/2.5 times the smallest: 700 for 20 storeys.
        EXPECT_NEAR(result.omega(j - 1) / expected, 1, 1e-12) << n << " storeys, mode " << j;
        for (int i = 1; i <= n; ++i) {
          EXPECT_NEAR(result.shapes(i - 1, j - 1), exact::shear_building_shape(m, n, j, i), 1e-12);
        }
      }
    }
  }
}

TEST(Modes, SolveTheEigenproblemAndAreOrthonormal) {
  for (const Solver solver : solvers) {
    for (const StructuralModel& model : examples()) {
      const Modes result = solver(model.mass, model.stiffness);
      const Eigen::Index n = model.dofs();
      const Eigen::MatrixXd unit = result.shapes.transpose() * model.mass * result.shapes;
      EXPECT_LE((unit - Eigen::MatrixXd::Identity(n, n)).cwiseAbs().maxCoeff(), 1e-12);
      const Eigen::MatrixXd squares = result.shapes.transpose() * model.stiffness * result.shapes;
      const double largest = std::pow(result.omega(n - 1), 2);
      const Eigen::MatrixXd expected = result.omega.cwiseAbs2().asDiagonal();
      EXPECT_LE((squares - expected).cwiseAbs().maxCoeff(), 1e-12 * largest);
      for (Eigen::Index j = 1; j < n; ++j) EXPECT_LE(result.omega(j - 1), result.omega(j));
      for (Eigen::Index j = 0; j < n; ++j) {
        Eigen::Index first = 0;
        while (std::abs(result.shapes(first, j)) <= 1e-9 * result.shapes.col(j).cwiseAbs().maxCoeff()) ++first;
        EXPECT_GT(result.shapes(first, j), 0);
      }
    }
  }
}

TEST(Modes, JacobiAgreesWithTheLibrary) {
  for (const StructuralModel& model : examples()) {
    const Modes a = modes(model.mass, model.stiffness);
    const Modes b = modes_by_jacobi(model.mass, model.stiffness);
    for (Eigen::Index j = 0; j < model.dofs(); ++j) {
      EXPECT_NEAR(std::pow(a.omega(j) / b.omega(j), 2), 1, 1e-12) << "mode " << j << " of " << model.dofs();
      const double scale = a.shapes.col(j).cwiseAbs().maxCoeff();
      EXPECT_LE((a.shapes.col(j) - b.shapes.col(j)).cwiseAbs().maxCoeff(), 1e-12 * scale)
          << "mode " << j << " of " << model.dofs();
    }
  }
}

TEST(Modes, RepeatedFrequenciesShareTheirSubspace) {
  // Two equal three-storey sticks side by side in one model: every ω twice. Single shapes are not unique, their plane
  // is: compare the projectors Φ_k Φ_kᵀ M of each pair.
  const StructuralModel one = uniform_stick(3, 20, 5e4);
  Eigen::MatrixXd mass = Eigen::MatrixXd::Zero(6, 6), stiffness = mass;
  for (const Eigen::Index at : {0, 3}) {
    mass.block(at, at, 3, 3) = one.mass;
    stiffness.block(at, at, 3, 3) = one.stiffness;
  }
  // Mixed by a change of coordinates, so that the solvers cannot see the blocks.
  Eigen::MatrixXd mix = Eigen::MatrixXd::Identity(6, 6);
  for (Eigen::Index i = 0; i < 6; ++i) {
    for (Eigen::Index j = 0; j < 6; ++j) mix(i, j) += 0.1 * std::sin(1.0 + 3.0 * double(i) + 5.0 * double(j));
  }
  mass = (mix.transpose() * mass * mix).eval();
  stiffness = (mix.transpose() * stiffness * mix).eval();
  const Modes a = modes(mass, stiffness), b = modes_by_jacobi(mass, stiffness);
  for (Eigen::Index pair = 0; pair < 3; ++pair) {
    const double expected = exact::shear_building_omega(5e4, 20, 3, static_cast<int>(pair) + 1);
    std::vector<Eigen::MatrixXd> projectors;
    for (const Modes& each : {a, b}) {
      EXPECT_NEAR(each.omega(2 * pair) / expected, 1, 1e-12);
      EXPECT_NEAR(each.omega(2 * pair + 1) / expected, 1, 1e-12);
      const Eigen::MatrixXd shapes = each.shapes.middleCols(2 * pair, 2);
      EXPECT_LE((shapes.transpose() * mass * shapes - Eigen::MatrixXd::Identity(2, 2)).cwiseAbs().maxCoeff(), 1e-12);
      projectors.emplace_back(shapes * shapes.transpose() * mass);
    }
    EXPECT_LE((projectors[0] - projectors[1]).cwiseAbs().maxCoeff(), 1e-12);
  }
}

TEST(Modes, SignComesFromTheFirstEntryThatIsNotRoundOff) {
  // Floor 1 hangs on stiff springs and does not take part in the antisymmetric mode of its two neighbours: K and M are
  // symmetric under the exchange of dofs 2 and 3, so that mode is (0, a, −a), a > 0 by the rule.
  Eigen::Matrix3d stiffness;
  stiffness << 300, -50, -50, -50, 80, 0, -50, 0, 80;
  const Eigen::Matrix3d mass = Eigen::Vector3d(2, 1, 1).asDiagonal();
  for (const Solver solver : solvers) {
    const Modes result = solver(mass, stiffness);
    EXPECT_NEAR(std::pow(result.omega(1), 2), 80, 1e-10);
    EXPECT_NEAR(result.shapes(0, 1), 0, 1e-12);
    EXPECT_NEAR(result.shapes(1, 1), std::sqrt(0.5), 1e-12);
    EXPECT_NEAR(result.shapes(2, 1), -std::sqrt(0.5), 1e-12);
  }
}

TEST(Modes, RefuseMatricesThatAreNotPositiveDefinite) {
  const Eigen::Matrix2d good = Eigen::Vector2d(2, 1).asDiagonal();
  const Eigen::Matrix2d semi = Eigen::Vector2d(2, 0).asDiagonal();
  const Eigen::Matrix2d bad = Eigen::Vector2d(2, -1).asDiagonal();
  const Eigen::Matrix2d nan = Eigen::Matrix2d::Constant(std::nan(""));
  for (const Solver solver : solvers) {
    for (const Eigen::Matrix2d& spoilt : {semi, bad, nan}) {
      EXPECT_THROW(static_cast<void>(solver(spoilt, good)), std::runtime_error);
      EXPECT_THROW(static_cast<void>(solver(good, spoilt)), std::runtime_error);
    }
  }
}

TEST(ModalProperties, ReferencePeriodsOfFullMatrices) {
  // The imported matrices [m, kN] of the reference case, whose periods come from an independent program.
  const StructuralModel model = examples().back();
  const Eigen::Vector4d expected(0.5279368726005467, 0.1888949916125842, 0.11718103976469493, 0.0875290907713309);
  const Eigen::VectorXd actual = modal_properties(modes(model.mass, model.stiffness), model.load).periods;
  EXPECT_LE((actual.cwiseQuotient(expected).array() - 1).abs().maxCoeff(), 1e-12);
}

TEST(ModalProperties, EffectiveMassesAddUp) {
  for (const StructuralModel& model : examples()) {
    const Modes shapes = modes(model.mass, model.stiffness);
    const ModalProperties result = modal_properties(shapes, model.load);
    EXPECT_NEAR(result.effective_mass_fraction.sum(), 1, 1e-13);
    EXPECT_GT(result.effective_mass_fraction.minCoeff(), -1e-300);
    // ΣΓ² = loadᵀ M⁻¹ load, and Σ Γ φ = M⁻¹ load.
    EXPECT_TRUE((model.mass * (shapes.shapes * result.participation)).isApprox(model.load, 1e-11));
    for (Eigen::Index j = 0; j < model.dofs(); ++j) {
      EXPECT_DOUBLE_EQ(result.periods(j) * shapes.omega(j), 2 * std::numbers::pi);
    }
  }
}

TEST(ModalProperties, ShearBuildingSumIsTheMovingMass) {
  const StructuralModel model = uniform_stick(5, 12, 3e3);
  const ModalProperties result = modal_properties(modes(model.mass, model.stiffness), model.load);
  EXPECT_NEAR(result.participation.squaredNorm(), 60, 60 * 1e-13);
  for (int j = 1; j <= 5; ++j) {
    double sum = 0;
    for (int i = 1; i <= 5; ++i) sum += 12 * exact::shear_building_shape(12, 5, j, i);
    EXPECT_NEAR(result.participation(j - 1), sum, 1e-11);
  }
}

TEST(SmallestEigenvalue, OfASymmetricMatrix) {
  const Eigen::MatrixXd definite{{2, 1}, {1, 2}}, indefinite{{1, 2}, {2, 1}};  // 1 and 3; −1 and 3
  EXPECT_NEAR(smallest_eigenvalue(definite), 1, 1e-15);                        // a few units of round-off
  EXPECT_NEAR(smallest_eigenvalue(indefinite), -1, 1e-15);
}

TEST(CalibratePeriod, ScalesStiffnessOnly) {
  for (StructuralModel model : examples()) {
    const StructuralModel before = model;
    const Eigen::VectorXd old = modes(model.mass, model.stiffness).omega;
    calibrate_period(model, 0.164);
    const Eigen::VectorXd now = modes(model.mass, model.stiffness).omega;
    EXPECT_NEAR(2 * std::numbers::pi / now(0) / 0.164, 1, 1e-12);
    EXPECT_EQ(model.mass, before.mass);
    EXPECT_EQ(model.load, before.load);
    EXPECT_TRUE((now / now(0)).isApprox(old / old(0), 1e-12));  // one factor for all modes
  }
}

TEST(CalibratePeriod, RefusesAPeriodThatIsNone) {
  StructuralModel model = uniform_stick(2, 1, 1);
  for (const double bad : {0.0, -0.1, std::nan("")})
    EXPECT_THROW(calibrate_period(model, bad), InvalidParameter) << bad;
}

}  // namespace
}  // namespace bentur
