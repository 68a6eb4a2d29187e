#include "bentur/solve/engine/run/account/balance.h"

#include <algorithm>
#include <cmath>
#include <utility>

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

/// What joints and what yields have pushed over a step of such a length [s].
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
    VectorXd impulses = length * of.base + of.stiffness() * system_->speeds(of.at(), of_step_);
    if (of.damping().size() > 0) impulses += of.damping() * system_->speeds(of.at(), end_ - start);
    for (Index n = 0; n < impulses.size(); ++n) system_->push(of.at()[n], impulses(n), pushed_);
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
    if (impacts[n].point < system_->switched) system_->push(impacts[n].point, impacts[n].impulse, pushed_);
  }
  double missing = 0.0;
  double largest = 0.0;
  for (const ModalSystem::Block& block : system_->blocks) {
    const auto shaken = (state.v - start_.v).segment(block.begin + block.modes, system_->components());
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
          state.v(mode) - start_.v(mode) + spring + damped - system_->gamma.row(mode).dot(shaken) - pushed_(mode);
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

double force_imbalance(const System& given, const ModalSystem& system, const State& state,
                       const std::vector<GroundInput>& inputs, const Elements& elements) {
  VectorXd forces;
  VectorXd acceleration;
  elements.forces_at(state, inputs, forces);
  system.acceleration(state, inputs, forces, acceleration);
  const std::vector<Body>& bodies = given.bodies;
  std::vector<VectorXd> pushes;  // per body, on its degrees of freedom
  std::vector<double> largest(bodies.size(), 0.0);
  for (const Body& body : bodies) pushes.emplace_back(VectorXd::Zero(body.dofs()));
  const auto push = [&](const BodyRow& at, double force) {
    if (at.body < 0 || force == 0.0 || bodies[at.body].is_rigid()) return;
    pushes[at.body] -= force * at.row;
    largest[at.body] =
        std::max(largest[at.body], std::abs(force) * (bodies[at.body].modes.shapes.transpose() * at.row).norm());
  };
  Index element = 0;
  const auto push_both = [&](const Interface& interface) {
    push(interface.left, forces(element));
    push(interface.right, forces(element++));
  };
  for (const Contact& contact : given.contacts) push_both(contact.at);
  for (const bentur::Element& joint : given.joints) push_both(joint.at);
  element = system.rubs;
  for (const RubbingContact& contact : given.rubbing) {
    push_both(contact.at);
    push_both(contact.along);
  }
  element = system.members;
  for (Index b = 0; b < std::ssize(bodies); ++b) {
    for (const BuildingElement& member : bodies[b].elements) push({b, member.row}, forces(element++));
  }
  double worst = 0.0;
  for (Index b = 0; b < std::ssize(bodies); ++b) {
    const Body& body = bodies[b];
    for (const CoupledElement& coupled : body.coupled) {
      for (const auto& row : coupled.rows.rowwise()) push({b, row.transpose()}, forces(element++));
    }
    if (body.is_rigid()) continue;
    const ModalSystem::Block& block = system.blocks[b];
    const Eigen::MatrixXd& shapes = body.modes.shapes;
    const auto modes = [&block](const VectorXd& x) { return x.segment(block.begin, block.modes); };
    const VectorXd x = shapes * modes(state.q);
    const VectorXd inertia = shapes.transpose() * (body.mass * (shapes * modes(acceleration)));
    const VectorXd stiffness = shapes.transpose() * (body.stiffness * x);
    const VectorXd damping = body.modal_damping * modes(state.v);
    VectorXd load = VectorXd::Zero(block.modes);
    for (Index c = 0; c < system.components(); ++c) {
      load += system.of_body(inputs, b)[c].value * (shapes.transpose() * body.load.col(c));
    }
    const VectorXd pushed = shapes.transpose() * pushes[b];
    for (const VectorXd* term : {&inertia, &stiffness, &damping, &std::as_const(load)}) {
      largest[b] = std::max(largest[b], term->norm());
    }
    if (!(largest[b] > 0.0)) continue;
    worst = std::max(worst, (inertia + stiffness + damping + load - pushed).norm() / largest[b]);
  }
  return worst;
}

}  // namespace bentur::engine
