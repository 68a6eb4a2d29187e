#pragma once

#include <cmath>
#include <initializer_list>
#include <memory>
#include <string>
#include <vector>

#include "bentur/contact/laws/linear.h"
#include "bentur/pounding/assemble.h"
#include "bentur/structure/damping.h"
#include "bentur/structure/modes.h"

namespace bentur::test {

/// A building given by mass and stiffness, floors 1 [length] apart; stiffness may be singular (a free mass).
/// The load is M·1; damping is a full matrix C.
inline Building matrix_building(const Eigen::MatrixXd& mass, const Eigen::MatrixXd& stiffness,
                                const Eigen::MatrixXd& c) {
  Building building;
  building.name = "test";
  for (Eigen::Index f = 0; f < mass.rows(); ++f) {
    building.model.elevations.push_back(static_cast<double>(f + 1));
    building.model.storey_heights.push_back(1.0);
  }
  building.model.mass = mass;
  building.model.stiffness = stiffness;
  building.model.load = mass.rowwise().sum();
  building.model.floor_masses.assign(building.model.load.begin(), building.model.load.end());
  building.modes = modes(mass, stiffness);
  building.modes.omega = building.modes.omega.unaryExpr([](double w) { return std::isfinite(w) ? w : 0.0; });
  building.modal_damping = modal_damping(MatrixDamping{c}, building.modes);
  return building;
}

/// One mass m [mass] on a spring k [force/length] with damping ratio ζ (of k and m).
inline Building oscillator(double m, double k, double zeta = 0.0) {
  Building building;
  building.name = "oscillator";
  building.model.elevations = {1.0};
  building.model.storey_heights = {1.0};
  building.model.mass = Eigen::MatrixXd::Constant(1, 1, m);
  building.model.stiffness = Eigen::MatrixXd::Constant(1, 1, k);
  building.model.load = Eigen::VectorXd::Constant(1, m);
  building.model.floor_masses = {m};
  building.modes.omega = Eigen::VectorXd::Constant(1, std::sqrt(k / m));
  building.modes.shapes = Eigen::MatrixXd::Constant(1, 1, 1.0 / std::sqrt(m));
  building.modal_damping = Eigen::MatrixXd::Constant(1, 1, 2.0 * zeta * std::sqrt(k / m));
  return building;
}

/// A building that contact cannot move: 10¹⁵ times the mass and 10²⁰ times the stiffness of its neighbour's order.
inline Building wall() { return oscillator(1e15, 1e20); }

inline ContactPoint contact(double width, double stiffness, int floor = 0, int left = 0) {
  ContactPoint point;
  point.left = point.gap = left;
  point.right = left + 1;
  point.left_floor = floor;
  point.right_floor = floor;
  point.elevation = floor + 1.0;
  point.width = width;
  point.law = std::make_shared<Linear>(stiffness);
  return point;
}

inline Problem pair(Building left, Building right, std::vector<ContactPoint> points, double duration) {
  Problem problem;
  problem.buildings = {std::move(left), std::move(right)};
  problem.points = std::move(points);
  problem.delays = {0.0, 0.0};
  problem.duration = duration;
  for (const Building& building : problem.buildings) {
    problem.initial_displacement.emplace_back(Eigen::VectorXd::Zero(building.model.dofs()));
    problem.initial_velocity.emplace_back(Eigen::VectorXd::Zero(building.model.dofs()));
  }
  return problem;
}

}  // namespace bentur::test
