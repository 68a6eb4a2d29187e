#pragma once

#include <gtest/gtest.h>

#include "bentur/structure/plan/plan.h"

namespace bentur::test {

/// That the storeys of a plan with three floors bear what its stiffness pushes the floors above with, moments about the
/// centre of mass above. @param x displacements [length, rad] @return what they bear, as PlanModel::storey_forces has
/// it
inline Eigen::VectorXd expect_storeys_bear_what_acts_above(const Plan& plan, const PlanModel& model,
                                                           const Eigen::VectorXd& x) {
  const Eigen::VectorXd forces = model.stiffness * x, storeys = model.storey_forces * x;
  for (Eigen::Index j = 0; j < 3; ++j) {
    Eigen::Vector3d above = Eigen::Vector3d::Zero();
    for (Eigen::Index f = j; f < 3; ++f) {
      const PlanPoint arm = plan.centres_of_mass[f] - plan.centres_of_mass[j];
      above += forces.segment<3>(3 * f);
      above.z() += arm.x() * forces(3 * f + 1) - arm.y() * forces(3 * f);
    }
    EXPECT_LE((storeys.segment<3>(3 * j) - above).cwiseAbs().maxCoeff(), 1e-12 * storeys.cwiseAbs().maxCoeff());
  }
  return storeys;
}

}  // namespace bentur::test
