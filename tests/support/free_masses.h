#pragma once

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <utility>

#include "bentur/pounding/response.h"
#include "tests/support/small_buildings.h"

namespace bentur::test {

/// One point between the only floors of two one-floor buildings, of any law.
inline ContactPoint contact(double width, std::shared_ptr<const ContactLaw> law, int left = 0) {
  ContactPoint point = contact(width, 1.0, 0, left);
  point.law = std::move(law);
  return point;
}

/// A building without springs and damping, given by its mass matrix: Φ = L⁻ᵀ with M = LLᵀ, so that ΦᵀMΦ = 1.
inline Building free_building(const Eigen::MatrixXd& mass) {
  Building building;
  building.name = "free";
  const auto floors = static_cast<std::size_t>(mass.rows());
  for (std::size_t f = 0; f < floors; ++f) building.model.elevations.push_back(static_cast<double>(f + 1));
  building.model.storey_heights.assign(floors, 1.0);
  building.model.mass = mass;
  building.model.stiffness = Eigen::MatrixXd::Zero(mass.rows(), mass.rows());
  building.model.load = mass.rowwise().sum();
  building.model.floor_masses.assign(building.model.load.begin(), building.model.load.end());
  building.modes.omega = Eigen::VectorXd::Zero(mass.rows());
  building.modes.shapes = Eigen::MatrixXd(mass.llt().matrixU()).inverse();
  building.modal_damping = building.model.stiffness;
  return building;
}

/// Two masses without springs; the left one moves towards the right one, which rests `width` away.
inline Problem free_masses(double left, double right, double width, double speed, std::shared_ptr<const ContactLaw> law,
                           double duration) {
  Problem problem = pair(oscillator(left, 0.0), oscillator(right, 0.0), {contact(width, std::move(law))}, duration);
  problem.initial_velocity[0](0) = speed;
  return problem;
}

/// Velocity of a one-floor building at the last sample.
inline double last_velocity(const Response& response, std::size_t building) {
  const Eigen::MatrixXd& velocity = response.histories.velocity[building];
  return velocity(0, velocity.cols() - 1);
}

}  // namespace bentur::test
