#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "bentur/contact/law.h"
#include "bentur/excitation/ground_motion.h"
#include "bentur/pounding/plan/faces.h"
#include "bentur/pounding/problem.h"
#include "bentur/solve/system.h"
#include "bentur/structure/plan/plan.h"

namespace bentur {

/// A place where two buildings in plan can touch.
struct PlanContact {
  Eigen::Index left_floor = 0, right_floor = 0;  ///< of L and R, 0 the lowest
  double elevation = 0;                          ///< [length]
  double along = 0;                              ///< on the stretch [length]
  std::shared_ptr<const ContactLaw> law;         ///< with the share of this point
  std::shared_ptr<const Rubbing> rubbing = {};   ///< that law with friction along the stretch; null: without
};

/// What lies between two buildings that face each other.
struct PlanGap {
  Eigen::Index left = 0, right = 0;  ///< L and R of the stretch, indices into PlanProblem::buildings
  Stretch stretch;
  std::vector<PlanContact> contacts = {};  ///< level after level from the lowest up, each along the stretch
};

/// Buildings in plan and what a solver needs of them, in consistent units: what Problem is of a row.
struct PlanProblem {
  std::vector<PlanBuilding> buildings;
  std::vector<PlanGap> gaps;                           ///< by their buildings
  std::array<GroundMotion, 2> motions;                 ///< two components, by default along x and y
  Eigen::Matrix2d axes = Eigen::Matrix2d::Identity();  ///< columns: along which they act (P-3)
  std::vector<double> delays = {};                     ///< [s] ≥ 0, one per building; empty: all zero
  Kinematics kinematics = Kinematics::relative;
  std::vector<Eigen::VectorXd> initial_displacement;  ///< per building, dofs [length, rad]; empty: at rest
  std::vector<Eigen::VectorXd> initial_velocity;      ///< likewise [length/s, rad/s]
  double duration = 0;                                ///< [s] > 0
};

/// "A | B", as the buildings stand in the problem.
[[nodiscard]] std::string gap_name(const PlanProblem& problem, const PlanGap& gap);

/// @throws InvalidParameter when sizes disagree or a value is outside its range.
void validate(const PlanProblem& problem);

/// Bodies and contacts of a valid problem, gap after gap (P-6), those that rub apart. What the motion times −1 needs is
/// watched in the free response: −δ of every contact, in the order of the gaps.
[[nodiscard]] System system_of(const PlanProblem& problem);

}  // namespace bentur
