#include "bentur/solve/engine/motion/modal_system.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "bentur/solve/engine/motion/kernels/series.h"

namespace bentur::engine {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Rows of displacement, drift ratio and storey shear over the modes of a building (docs/theory/exact-solver.md), and a
/// column for ground.
MatrixXd output_rows(const Building& building) {
  const StructuralModel& model = building.model;
  const Index floors = model.floors();
  const MatrixXd shapes = building.modes.shapes.topRows(floors);
  const MatrixXd forces = (model.stiffness * building.modes.shapes).topRows(floors);
  MatrixXd rows = MatrixXd::Zero(3 * floors, shapes.cols() + 1);
  for (Index f = 0; f < floors; ++f) {
    const Index modes = shapes.cols();
    rows.row(f).head(modes) = shapes.row(f);
    rows.row(floors + f).head(modes) = shapes.row(f);
    if (f > 0) rows.row(floors + f).head(modes) -= shapes.row(f - 1);
    rows.row(floors + f) /= model.storey_heights[f];
    rows.row(2 * floors + f).head(modes) = forces.bottomRows(floors - f).colwise().sum();
  }
  return rows;
}

Index padded(Index coordinates) {
  constexpr Index four = 4;
  return (coordinates + four - 1) / four * four;
}

ModalSystem::Block make_block(const Building& building, Index begin) {
  ModalSystem::Block block;
  const Index modes = building.modes.omega.size();
  block.begin = begin;
  block.size = modes + 1;
  block.padded_size = padded(block.size);
  block.floors = building.model.floors();
  block.outputs = output_rows(building);
  block.acceleration = block.outputs.topRows(block.floors);
  block.acceleration.col(modes).setOnes();

  MatrixXd off_diagonal = building.modal_damping;
  off_diagonal.diagonal().setZero();
  double damping_norm = building.modal_damping.diagonal().cwiseAbs().maxCoeff();
  if (!off_diagonal.isZero(0.0)) {
    block.damping = MatrixXd::Zero(modes + 1, modes + 1);
    block.damping->topLeftCorner(modes, modes) = building.modal_damping;
    damping_norm = building.modal_damping.norm();
  }
  block.half_damping = 0.5 * damping_norm;
  block.omega_max = building.modes.omega.maxCoeff();
  return block;
}

/// Of displacements that are `shapes` over the modes.
VectorXd sense_row(const VectorXd& shapes, Kinematics kinematics, double sign) {
  const Index modes = shapes.size();
  VectorXd row = VectorXd::Zero(padded(modes + 1));
  row.head(modes) = sign * shapes;
  row(modes) = kinematics == Kinematics::absolute ? sign : 0.0;
  return row;
}

/// The same without what the ground does.
VectorXd push_column(VectorXd sense, Index modes) {
  sense(modes) = 0.0;
  return sense;
}

}  // namespace

ModalSystem::ModalSystem(const Problem& problem) : nu(angular_frequency(problem.motion)) {
  for (const Building& building : problem.buildings) {
    blocks.push_back(make_block(building, size));
    size += blocks.back().padded_size;
    classical = classical && !blocks.back().damping;
  }
  omega_squared = VectorXd::Zero(size);
  two_sigma = VectorXd::Zero(size);
  gamma = VectorXd::Zero(size);
  of_mode = VectorXd::Zero(size);
  initial_q = VectorXd::Zero(size);
  initial_v = VectorXd::Zero(size);
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    const Building& building = problem.buildings[b];
    const Index begin = blocks[b].begin;
    const Index modes = blocks[b].size - 1;
    omega_squared.segment(begin, modes) = building.modes.omega.cwiseAbs2();
    two_sigma.segment(begin, modes) = building.modal_damping.diagonal();
    gamma(begin + modes) = 1.0;
    of_mode.segment(begin, modes).setOnes();
    gamma.segment(begin, modes) = -building.modes.shapes.transpose() * building.model.load;
    const auto to_modes = [&building](const VectorXd& x) -> VectorXd {
      return building.modes.shapes.transpose() * (building.model.mass * x);
    };
    if (!problem.initial_displacement.empty()) {
      initial_q.segment(begin, modes) = to_modes(problem.initial_displacement[b]);
    }
    if (!problem.initial_velocity.empty()) initial_v.segment(begin, modes) = to_modes(problem.initial_velocity[b]);
  }

  const auto opening_between = [&](Index left, const VectorXd& left_shapes, const VectorXd& right_shapes) {
    Point point;
    point.left_begin = blocks[left].begin;
    point.left_size = blocks[left].padded_size;
    point.right_begin = blocks[left + 1].begin;
    point.right_size = blocks[left + 1].padded_size;
    point.sense_left = sense_row(left_shapes, problem.kinematics, -1.0);
    point.sense_right = sense_row(right_shapes, problem.kinematics, 1.0);
    return point;
  };
  for (const ContactPoint& contact : problem.points) {
    const Index left = contact.left;
    Point point = opening_between(left, problem.buildings[left].modes.shapes.row(contact.left_floor),
                                  problem.buildings[left + 1].modes.shapes.row(contact.right_floor));
    point.push_left = push_column(point.sense_left, blocks[left].size - 1);
    point.push_right = push_column(point.sense_right, blocks[left + 1].size - 1);
    points.push_back(std::move(point));
  }
  for (const WatchedFloor& floor : problem.watched) {
    const Index left = floor.left;
    watched.push_back(opening_between(left, problem.buildings[left].modes.shapes.transpose() * floor.left_row,
                                      problem.buildings[left + 1].modes.shapes.transpose() * floor.right_row));
  }
  const Index count = std::ssize(points);
  coupling = MatrixXd::Zero(count, count);
  for (Index i = 0; i < count; ++i) {
    VectorXd push = VectorXd::Zero(size);
    const Point& from = points[i];
    push.segment(from.left_begin, from.left_size) = from.push_left;
    push.segment(from.right_begin, from.right_size) = from.push_right;
    for (Index j = 0; j < count; ++j) coupling(i, j) = points[j].sense(push);
  }
}

double ModalSystem::rate(const ContactForces& forces) const {
  // The largest row sum of the pressing points' coupling bounds its largest eigenvalue.
  double stiffness = 0.0;
  double damping = 0.0;
  for (const Index i : forces.pressing) {
    double stiffness_row = 0.0;
    double damping_row = 0.0;
    for (const Index j : forces.pressing) {
      const double between = std::abs(coupling(i, j));
      stiffness_row += between * std::sqrt(std::abs(forces.linear[i].stiffness * forces.linear[j].stiffness));
      damping_row += between * std::sqrt(std::abs(forces.linear[i].damping * forces.linear[j].damping));
    }
    stiffness = std::max(stiffness, stiffness_row);
    damping = std::max(damping, damping_row);
  }
  double half_damping = 0.0;
  double omega = nu;
  for (const Block& block : blocks) {
    half_damping = std::max(half_damping, block.half_damping);
    omega = std::max(omega, block.omega_max);
  }
  half_damping += 0.5 * damping;
  return std::max(half_damping + std::sqrt(half_damping * half_damping + omega * omega + stiffness), forces.fading);
}

void ModalSystem::acceleration(const State& state, const std::vector<GroundInput>& inputs, const VectorXd& forces,
                               VectorXd& result) const {
  result.resize(size);
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    const Block& block = blocks[b];
    const Index begin = block.begin;
    kernels::accelerate(block.padded_size, omega_squared.data() + begin, two_sigma.data() + begin, gamma.data() + begin,
                        inputs[b].value, state.q.data() + begin, state.v.data() + begin, result.data() + begin);
    if (block.damping) {
      const auto speed = state.v.segment(block.begin, block.size);
      result.segment(block.begin, block.size) -=
          *block.damping * speed - two_sigma.segment(block.begin, block.size).cwiseProduct(speed);
    }
  }
  for (Index i = 0; i < forces.size(); ++i) {
    if (forces(i) != 0.0) push(i, forces(i), result);
  }
}

void ModalSystem::push(Index i, double force, VectorXd& result) const {
  const Point& point = points[i];
  const auto add = [&](Index begin, const VectorXd& by) {
    double* to = result.data() + begin;
    for (Index j = 0; j < by.size(); ++j) to[j] += force * by[j];
  };
  add(point.left_begin, point.push_left);
  add(point.right_begin, point.push_right);
}

VectorXd ModalSystem::forces_for(const std::vector<Index>& at, const VectorXd& missing) const {
  const Index count = std::ssize(at);
  MatrixXd matrix(count, count);
  for (Index i = 0; i < count; ++i) {
    for (Index j = 0; j < count; ++j) matrix(i, j) = coupling(at[i], at[j]);
  }
  return matrix.ldlt().solve(missing);
}

void ModalSystem::advance(GroundInput& in, double dt) const {
  if (nu == 0.0) {
    in.value += in.slope * dt;
    return;
  }
  const double c = std::cos(nu * dt);
  const double s = std::sin(nu * dt);
  in = {in.value * c + in.slope / nu * s, in.slope * c - in.value * nu * s};
}

void ModalSystem::advance(std::vector<GroundInput>& inputs, double dt) const {
  for (GroundInput& in : inputs) advance(in, dt);
}

double ModalSystem::Block::rate() const { return half_damping + std::hypot(half_damping, omega_max); }

}  // namespace bentur::engine
