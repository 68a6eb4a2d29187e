#include "bentur/structure/known/modal.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "bentur/core/errors.h"
#include "bentur/structure/modes.h"
#include "bentur/structure/stick.h"

namespace bentur {
namespace {

using Eigen::Index;

const Stick three = {{3.5, 3.0, 3.0}, {30, 28, 25}, {40e3, 36e3, 30e3}};

/// What another program would tell of a building: shapes of any scale, the roof 1.
ModalBuilding told(const Stick& stick, Index count) {
  const StructuralModel model = stick_model(stick);
  const Modes known = modes(model.mass, model.stiffness);
  ModalBuilding building{.elevations = model.elevations, .masses = stick.masses, .modes = {}};
  for (Index mode = 0; mode < count; ++mode) {
    building.modes.periods.push_back(2 * std::numbers::pi / known.omega(mode));
    const Eigen::VectorXd shape = known.shapes.col(mode) / known.shapes(model.floors() - 1, mode);
    building.modes.shapes.emplace_back(shape.begin(), shape.end());
  }
  return building;
}

TEST(Modal, AllModesAreTheMatrices) {
  const StructuralModel expected = stick_model(three);
  const Modes known = modes(expected.mass, expected.stiffness);
  ModalBuilding building = told(three, 3);
  std::swap(building.modes.periods[0], building.modes.periods[2]);  // any order
  std::swap(building.modes.shapes[0], building.modes.shapes[2]);
  const ModalModel found = modal_model(building, 2.0);
  EXPECT_LE((found.model.stiffness - expected.stiffness).norm(), 1e-9 * expected.stiffness.norm());
  EXPECT_LE((found.model.mass - expected.mass).norm(), 1e-12);
  EXPECT_LE((found.known.modes.omega - known.omega).norm(), 1e-12 * known.omega.norm());
  EXPECT_LE((found.known.modes.shapes - known.shapes).norm(), 1e-12 * known.shapes.norm());
  EXPECT_LE(found.known.largest_product, 1e-14);
  for (const double share : found.known.mass_shares) EXPECT_NEAR(share, 1, 1e-12);
  EXPECT_EQ(found.model.elevations, (std::vector<double>{5.5, 8.5, 11.5}));
  // K x of all floors above the foot is the shear that M Φ Ω² q is.
  const Eigen::Vector3d q(0.3, -0.2, 0.1);
  const Eigen::VectorXd forces =
      expected.mass * found.known.modes.shapes * found.known.modes.omega.cwiseAbs2().asDiagonal() * q;
  const Eigen::VectorXd shears = shear_rows(found.model) * (found.known.modes.shapes * q);
  EXPECT_NEAR(shears(1), forces.tail(2).sum(), 1e-9 * forces.norm());
}

TEST(Modal, RoundedShapesAreMadeOrthogonal) {
  ModalBuilding building = told(three, 3);
  for (auto& shape : building.modes.shapes) {
    for (double& value : shape) value = std::round(100 * value) / 100;
  }
  const ModalModel found = modal_model(building);
  EXPECT_GT(found.known.largest_product, 1e-4);
  EXPECT_LT(found.known.largest_product, 0.02);
  const Eigen::MatrixXd products = found.known.modes.shapes.transpose() * found.model.mass * found.known.modes.shapes;
  EXPECT_LE((products - Eigen::MatrixXd::Identity(3, 3)).norm(), 1e-13);
  // Each stays as near to what was given as it can: the symmetric way favours none.
  for (Index mode = 0; mode < 3; ++mode) {
    Eigen::VectorXd given = Eigen::Map<const Eigen::Vector3d>(building.modes.shapes[mode].data());
    given /= std::sqrt(given.dot(found.model.mass * given));
    EXPECT_NEAR(std::abs(given.dot(found.model.mass * found.known.modes.shapes.col(mode))), 1, 1e-3) << mode;
  }
}

TEST(Modal, FewerModesThanFloors) {
  const ModalModel found = modal_model(told(three, 1));
  EXPECT_EQ(found.known.modes.shapes.cols(), 1);
  const Eigen::VectorXd shape = found.known.modes.shapes.col(0);
  double sum = 0;
  for (Index floor = 0; floor < 3; ++floor) {
    EXPECT_NEAR(found.known.mass_shares[floor], three.masses[floor] * shape(floor) * shape(floor), 1e-12);
    sum += found.known.mass_shares[floor];
  }
  EXPECT_NEAR(sum, 1, 1e-12) << "one mode, of unit modal mass";
}

TEST(Modal, FractionsAreOfAllMassWhateverModesAreKnown) {
  const auto building = [](Index count) {
    ModalModel known = modal_model(told(three, count));
    return Building{"A", std::move(known.model), std::move(known.known.modes), {}};
  };
  const Eigen::VectorXd all = modal_properties(building(3)).effective_mass_fraction;
  const Eigen::VectorXd one = modal_properties(building(1)).effective_mass_fraction;
  EXPECT_NEAR(all.sum(), 1, 1e-12);
  EXPECT_NEAR(one(0), all(0), 1e-12);
  EXPECT_LT(one(0), 0.99);
}

TEST(Modal, ShapesOfOtherMassesAreRefused) {
  ModalBuilding building = told(three, 3);
  building.modes.shapes[1][2] *= 1.2;
  try {
    (void)modal_model(building);
    ADD_FAILURE() << "not orthogonal";
  } catch (const InvalidParameter& error) {
    const std::string message = error.what();
    EXPECT_NE(message.find("between modes"), std::string::npos) << message;
    EXPECT_NE(message.find('2'), std::string::npos) << message;
  }
  ModalBuilding still = told(three, 2);
  still.modes.shapes[0] = {0, 0, 0};
  EXPECT_THROW((void)modal_model(still), InvalidParameter);
  ModalBuilding descending = told(three, 2);
  std::reverse(descending.elevations.begin(), descending.elevations.end());
  EXPECT_THROW((void)modal_model(descending), InvalidParameter);
  ModalBuilding many = told(three, 3);
  many.modes.periods.push_back(0.01);
  many.modes.shapes.push_back({1, 1, 1});
  EXPECT_THROW((void)modal_model(many), InvalidParameter);
}

}  // namespace
}  // namespace bentur
