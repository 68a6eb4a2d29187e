#include "bentur/solve/engine/run/account/balance.h"

#include <algorithm>
#include <cmath>

namespace bentur::engine {

using Eigen::Index;
using Eigen::VectorXd;

namespace {

constexpr long most_steps_of_contact = 1024;  // of one contact: a longer one, that rests, is let go

}  // namespace

MomentumBalance::MomentumBalance(const ModalSystem& system) : system_(&system) {
  for (VectorXd* x : {&start_.q, &start_.v, &shift_, &pushed_, &of_step_, &end_}) x->setZero(system.size);
  weights_.setZero(highest_degree + 1);
}

void MomentumBalance::take(const Expansion& motion, double end, const State& from, Elements& elements, bool meets) {
  if (!under_way_) {
    if (!meets || elements.any_touching()) return;
    if (++seen_ < next_) return;
    next_ *= 4;
    under_way_ = true;
    steps_ = 0;
    impacts_before_ = elements.impacts().size();
    start_ = from;
    shift_.setZero();
    pushed_.setZero();
  }
  if (++steps_ > most_steps_of_contact) {
    under_way_ = false;
    return;
  }
  const auto c = motion.coefficients().leftCols(motion.degree() + 1);
  auto weights = weights_.head(c.cols());
  double power = 1.0;
  for (Index k = 0; k < c.cols(); ++k) {
    power *= end;
    weights(k) = motion.h() * power / static_cast<double>(k + 1);
  }
  of_step_.noalias() = c * weights;
  shift_ += of_step_;
  const ElementForces& forces = elements.forces();
  if (forces.constant.empty() && forces.pressing.empty() && forces.coupled.empty()) return;
  power = 1.0;
  for (Index k = 0; k < c.cols(); ++k, power *= end) weights(k) = power;
  end_.noalias() = c * weights;
  push_others(motion, end * motion.h(), elements);
}

/// What links and storeys that yield have pushed over a step of such a length [s].
void MomentumBalance::push_others(const Expansion& motion, double length, const Elements& elements) {
  const ElementForces& forces = elements.forces();
  for (const auto* list : {&forces.constant, &forces.pressing}) {
    for (const Index i : *list) {
      if (elements.two_bodies(i)) continue;
      const ElementForces::Linear& linear = forces.linear[i];
      const ModalSystem::Relation& relation = system_->elements[i].relation;
      const double stretch = relation.along(end_) - relation.along(motion.coefficients().col(0).data());
      const double impulse =
          linear.base * length + linear.stiffness * relation.along(of_step_) + linear.damping * stretch;
      system_->push(i, impulse, pushed_);
    }
  }
  const auto start = motion.coefficients().col(0);
  for (const ElementForces::Coupled& of : forces.coupled) {
    VectorXd impulses = length * of.base + of.stiffness * system_->speeds(of.at, of_step_);
    if (of.damping.size() > 0) impulses += of.damping * system_->speeds(of.at, end_ - start);
    for (Index n = 0; n < impulses.size(); ++n) system_->push(of.at[n], impulses(n), pushed_);
  }
}

void MomentumBalance::changed(const State& state, Elements& elements) {
  if (!under_way_ || elements.any_touching()) return;
  under_way_ = false;
  close(state, elements);
}

void MomentumBalance::close(const State& state, Elements& elements) {
  const std::vector<Impact>& impacts = elements.impacts();
  for (std::size_t n = impacts_before_; n < impacts.size(); ++n) {
    system_->push(impacts[n].point, impacts[n].impulse, pushed_);
  }
  double missing = 0.0;
  double largest = 0.0;
  for (const ModalSystem::Block& block : system_->blocks) {
    const Index ground = block.begin + block.modes;
    const double shaken = state.v(ground) - start_.v(ground);
    const auto moved = [&](Index mode) { return state.q(mode) - start_.q(mode); };
    // Squares of what is missing and of the terms, over the modes.
    double rest = 0.0, after = 0.0, before = 0.0, sprung = 0.0, pushed = 0.0;
    for (Index i = 0; i < block.modes; ++i) {
      const Index mode = block.begin + i;
      double damped = system_->two_sigma(mode) * moved(mode);
      if (block.damping) {
        damped = 0.0;
        for (Index j = 0; j < block.modes; ++j) damped += (*block.damping)(i, j) * moved(block.begin + j);
      }
      const double spring = system_->omega_squared(mode) * shift_(mode);
      const double left =
          state.v(mode) - start_.v(mode) + spring + damped - shaken * system_->gamma(mode) - pushed_(mode);
      rest += left * left;
      after += state.v(mode) * state.v(mode);
      before += start_.v(mode) * start_.v(mode);
      sprung += spring * spring;
      pushed += pushed_(mode) * pushed_(mode);
    }
    missing = std::max(missing, std::sqrt(rest));
    largest = std::max(largest, std::sqrt(std::max({after, before, sprung, pushed})));
  }
  if (largest > 0.0) worst_ = std::max(worst_, missing / largest);
}

double force_imbalance(const Problem& problem, const ModalSystem& system, const State& state,
                       const std::vector<GroundInput>& inputs, const Elements& elements) {
  VectorXd forces;
  VectorXd acceleration;
  elements.forces_at(state, inputs, forces);
  system.acceleration(state, inputs, forces, acceleration);
  std::vector<VectorXd> pushes;  // per building, on its degrees of freedom
  std::vector<double> largest(problem.buildings.size(), 0.0);
  for (const Building& building : problem.buildings) pushes.emplace_back(VectorXd::Zero(building.model.dofs()));
  const auto push = [&](Index b, const VectorXd& row, double force) {
    pushes[b] += force * row;
    largest[b] = std::max(largest[b], std::abs(force) * (problem.buildings[b].modes.shapes.transpose() * row).norm());
  };
  const auto push_at = [&](Index b, Index dof, double force) {
    if (force != 0.0 && !problem.buildings[b].is_rigid()) push(b, VectorXd::Unit(pushes[b].size(), dof), force);
  };
  Index element = 0;
  for (const ContactPoint& point : problem.points) {
    push_at(point.left, point.left_floor, -forces(element));
    push_at(point.left + 1, point.right_floor, forces(element++));
  }
  for (const Link& link : problem.links) {
    push_at(link.left, link.left_floor, -forces(element));
    push_at(link.right, link.right_floor, forces(element++));
  }
  element = system.storeys;
  Index hinge = system.alone;
  double worst = 0.0;
  for (std::size_t b = 0; b < system.blocks.size(); ++b) {
    const Building& building = problem.buildings[b];
    if (building.is_rigid()) continue;
    const ModalSystem::Block& block = system.blocks[b];
    const Eigen::MatrixXd& shapes = building.modes.shapes;
    for (const BuildingElement& yielding : building.elements) {
      push(static_cast<Index>(b), yielding.row, -forces(element++));
    }
    for (const CoupledElement& coupled : building.coupled) {
      for (const auto& row : coupled.rows.rowwise()) push(static_cast<Index>(b), row.transpose(), -forces(hinge++));
    }
    const auto modes = [&block](const VectorXd& x) { return x.segment(block.begin, block.modes); };
    const VectorXd x = shapes * modes(state.q);
    const VectorXd inertia = shapes.transpose() * (building.model.mass * (shapes * modes(acceleration)));
    const VectorXd stiffness = shapes.transpose() * (building.model.stiffness * x);
    const VectorXd damping = building.modal_damping * modes(state.v);
    const VectorXd load = inputs[b].value * (shapes.transpose() * building.model.load);
    const VectorXd pushed = shapes.transpose() * pushes[b];
    for (const VectorXd* term : {&inertia, &stiffness, &damping, &load}) {
      largest[b] = std::max(largest[b], term->norm());
    }
    if (!(largest[b] > 0.0)) continue;
    worst = std::max(worst, (inertia + stiffness + damping + load - pushed).norm() / largest[b]);
  }
  return worst;
}

}  // namespace bentur::engine
