#include "bentur/solve/engine/motion/stepper.h"

#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>

#include "bentur/core/algebra/factors.h"

namespace bentur::engine {
namespace {

constexpr double contact_tolerance = 1e-10;  // of the pair in the exact solver; by measurement, docs/decisions.md
constexpr double remainder_slack = 1e-9;     // of what is left: a remainder shorter than this is not a step
constexpr double parting_part = 0.8;         // of the time that is left of a contact
constexpr double parting_crossed = 1e-3;     // of a step: when so little is left the end is crossed
constexpr int attempts = 60;                 // each may shorten a step to a fifth
constexpr double first_part = 1e-3;          // of 1/rate: first length ever tried

double tolerance_of(const Solver& solver) {
  const auto* adaptive = std::get_if<AdaptiveSolver>(&solver);
  return adaptive != nullptr ? adaptive->tolerance : contact_tolerance;
}

}  // namespace

Stepper::Stepper(const ModalSystem& system, const std::vector<double>& offsets, const Solver& solver)
    : system_(&system),
      offsets_(offsets),
      solver_(solver),
      series_(system, offsets),
      pair_(system, tolerance_of(solver)),
      fixed_(system),
      range_{0, std::ssize(system.blocks)},
      first_guess_(first_part / std::max(system.rate({}), 1e-300)) {}

bool Stepper::advance(const Start& start, double longest, bool touching, Expansion& motion, State& to) {
  if (const auto* fixed = std::get_if<RungeKuttaSolver>(&solver_)) {
    way_ = Way::fixed;
    const double step = touching ? fixed->step / 3.0 : fixed->step;
    retake(start, step >= longest * (1.0 - remainder_slack) ? longest : step, motion, to);
    return true;
  }
  const bool adaptive = std::holds_alternative<AdaptiveSolver>(solver_);
  if (adaptive || !start.forces.nonlinear.empty()) {
    way_ = Way::pair;
    range_ = adaptive ? BodyRange{0, std::ssize(system_->blocks)} : island(start.forces);
    return advance_by_pair(start, longest, motion, to);
  }
  way_ = Way::series;
  double h = series_reach / start.forces.rate;
  if (h >= longest * (1.0 - remainder_slack)) h = longest;
  series_.expand(start.state, start.inputs, h, start.forces, motion);
  return true;
}

/// Where a force ends like a root of the penetration, steps across the end are hopeless until little is left of it.
/// Once a step has failed, those that would end the contact are kept to a part of what is left.
double Stepper::longest_before_parting(const Start& start, double h) const {
  for (const Eigen::Index i : start.forces.nonlinear) {
    const ModalSystem::Relation& relation = system_->elements[i].relation;
    const double depth = offsets_[i] + relation.along(start.state.q);
    const double opening_speed = -relation.along(start.state.v);
    if (depth <= 0.0 || depth > opening_speed * h) continue;
    const double left = depth / opening_speed;
    if (left > parting_crossed * parting_scale_) h = std::min(h, parting_part * left);
  }
  return h;
}

/// The first step of a nonlinear contact. A force that sets in like a root of time would take an embedded pair through
/// dozens of steps over almost nothing. Instead the step is so short that the force changes speeds by a part ε =
/// √(tolerance/10) at most, and is taken along the motion without it: what that neglects is of order ε². False when
/// that is no way to go: other forces are at work too.
bool Stepper::begin_contact(const Start& start, double longest, Expansion& motion, State& to) {
  using Gauss = boost::math::quadrature::gauss<double, 7>;
  const double limit = std::sqrt(0.1 * tolerance_of(solver_));
  const double size = system_->speed(start.state.v);
  const Eigen::Index elements = std::ssize(system_->elements);
  longest = std::min(longest, series_reach / start.forces.rate);
  double h = first_guess_;
  for (int attempt = 0; attempt < attempts; ++attempt) {
    if (h >= longest) return false;
    series_.expand(start.state, start.inputs, h, start.forces, motion);
    // ∫ F dt and ∫ (h − t) F dt with t = h u⁴, in which roots of time are smooth.
    auto& [impulse, moment, force, dv, dq] = push_;
    impulse.setZero(elements);
    moment.setZero(elements);
    const auto add = [&](double u, double weight) {
      const double s = u * u * u * u;
      motion.evaluate(s, to);
      start.force_at(to, start.inputs, push_.force);
      const double part = 4.0 * u * u * u * weight * h;
      push_.impulse += part * push_.force;
      push_.moment += part * h * (1.0 - s) * push_.force;
    };
    for (std::size_t n = 0; n < Gauss::abscissa().size(); ++n) {
      const double x = Gauss::abscissa()[n];
      const double weight = 0.5 * Gauss::weights()[n];
      add(0.5 * (1.0 + x), weight);
      if (x != 0.0) add(0.5 * (1.0 - x), weight);
    }
    dv.setZero(system_->size);
    dq.setZero(system_->size);
    for (const Eigen::Index i : start.forces.nonlinear) {
      system_->push(i, impulse(i), dv);
      system_->push(i, moment(i), dq);
    }
    const Eigen::VectorXd reactions = hold(start.forces.resting, dv);
    (void)hold(start.forces.resting, dq);
    double change = system_->speed(dv) / size;
    for (const Eigen::Index i : start.forces.nonlinear) {  // and, at each, its closing speed
      const ModalSystem::Relation& relation = system_->elements[i].relation;
      change = std::max(change, std::abs(relation.along(dv) / relation.along(start.state.v)));
    }
    if (!std::isfinite(change)) return false;
    if (change > limit || (change < 0.1 * limit && attempt == 0)) {  // forces grow with the 1.25th to the 2.5th power
      h *= std::clamp(std::pow(0.5 * limit / std::max(change, 1e-300), change > limit ? 0.8 : 0.4), 1e-4, 1e4);
      continue;
    }
    // As polynomials that end where they should.
    auto& c = motion.coefficients();
    c.col(2) += 3.0 * dq - h * dv;
    c.col(3) += h * dv - 2.0 * dq;
    motion.evaluate(1.0, to);
    for (Eigen::Index n = 0; n < std::ssize(start.forces.resting); ++n) {
      Polynomial held = motion.resting_force(start.forces.resting[n]);
      held[0] += reactions(n) / h;
      motion.set_resting_force(start.forces.resting[n], held);
    }
    first_guess_ = h;
    return true;
  }
  return false;
}

/// Takes from a change of velocities or positions what would move resting elements; returns their reactions, whose push
/// does so.
Eigen::VectorXd Stepper::hold(const std::vector<Eigen::Index>& resting, Eigen::VectorXd& change) const {
  if (resting.empty()) return {};
  Eigen::VectorXd missing(std::ssize(resting));
  for (Eigen::Index n = 0; n < std::ssize(resting); ++n) {
    missing(n) = system_->elements[resting[n]].relation.along(change);
  }
  Eigen::VectorXd reactions = system_->forces_for(resting, missing);
  for (Eigen::Index n = 0; n < std::ssize(resting); ++n) system_->push(resting[n], reactions(n), change);
  return reactions;
}

bool Stepper::advance_by_pair(const Start& start, double longest, Expansion& motion, State& to) {
  const bool all = range_.first == 0 && range_.end == std::ssize(system_->blocks);
  if (!all) longest = std::min(longest, series_reach / start.forces.rate);  // others advance by power series
  const bool first = fresh_;
  if (first) {
    fresh_ = false;
    parting_scale_ = 0.0;
    control_.reset();
    const bool exact = std::holds_alternative<ExactSolver>(solver_);
    const bool begun = exact && begin_contact(start, longest, motion, to);
    guess_ = first_guess_;
    if (begun) return true;
  }
  double h = guess_;
  for (int attempt = 0; attempt < attempts; ++attempt) {
    if (parting_scale_ > 0.0) h = longest_before_parting(start, h);
    const bool last = h >= longest * (1.0 - remainder_slack);
    if (last) h = longest;
    double error = pair_.step(start.state, start.inputs, h, range_, start.force_at, to);
    if (error <= 1.0) {
      expand_pair(start, h, motion, to);
      error = std::max(error, pair_.defect(start.force_at, motion));
    }
    const double next = control_.next(h, error);
    if (error <= 1.0) {
      if (first && !last) first_guess_ = h;
      guess_ = last ? std::max(next, guess_) : next;
      return true;
    }
    if (!first && parting_scale_ == 0.0) parting_scale_ = h;
    h = next;
  }
  return false;
}

/// The step that the pair has just taken, as an expansion of all bodies.
void Stepper::expand_pair(const Start& start, double h, Expansion& motion, State& to) {
  const bool all = range_.first == 0 && range_.end == std::ssize(system_->blocks);
  int degree = EmbeddedPair::degree;
  if (!all) {
    there_ = to;
    series_.expand(start.state, start.inputs, h, start.forces, motion);
    for (int k = motion.degree() + 1; k <= (degree | 3); ++k) motion.coefficients().col(k).setZero();
    degree = std::max(degree, motion.degree());
    motion.evaluate(1.0, to);
    const auto begin = system_->blocks[range_.first].begin;
    const auto count = system_->blocks[range_.end - 1].begin + system_->blocks[range_.end - 1].size - begin;
    to.q.segment(begin, count) = there_.q.segment(begin, count);
    to.v.segment(begin, count) = there_.v.segment(begin, count);
  }
  motion.begin(0, system_->size, h, degree);
  pair_.expand(start.force_at, motion);
  finish_expansion(start, motion, to);
}

void Stepper::retake(const Start& start, double h, Expansion& motion, State& to) {
  if (way_ == Way::fixed) {
    fixed_.step(start.state, start.inputs, h, start.force_at, to);
    motion.begin(0, system_->size, h, FixedStep::degree);
    fixed_.expand(start.force_at, motion);
    finish_expansion(start, motion, to);
  } else {
    (void)pair_.step(start.state, start.inputs, h, range_, start.force_at, to);
    expand_pair(start, h, motion, to);
  }
}

/// Forces of elements, where those of a series are part of it.
void Stepper::finish_expansion(const Start& start, Expansion& motion, State& to) const {
  motion.fill_forces(start.forces);
  for (const Eigen::Index i : start.forces.pressing) {
    const Eigen::Index at = system_->elements[i].force;
    if (at < 0) continue;
    const ElementForces::Linear& linear = start.forces.linear[i];
    const ModalSystem::Relation& relation = system_->elements[i].relation;
    to.q(at) = linear.base + linear.stiffness * (offsets_[i] + relation.along(to.q));
    to.v(at) = linear.stiffness * relation.along(to.v);
  }
  for (const ElementForces::Coupled& of : start.forces.coupled) system_->fill_forces(of, to);
  fill_resting(start, to, motion);
}

/// Forces of resting elements are found at eight places of the step and interpolated.
void Stepper::fill_resting(const Start& start, const State& to, Expansion& motion) const {
  if (start.forces.resting.empty()) return;
  constexpr int nodes = 8;
  using Square = Eigen::Matrix<double, nodes, nodes>;
  static const Square to_powers = [] {
    Square powers;
    for (int n = 0; n < nodes; ++n) {
      for (int k = 0; k < nodes; ++k) powers(n, k) = std::pow(n / (nodes - 1.0), k);
    }
    return Square(solve_general(powers, Square::Identity()));
  }();
  Eigen::MatrixXd values(nodes, std::ssize(system_->elements));
  State state = to;
  Eigen::VectorXd forces;
  for (int n = 0; n < nodes; ++n) {
    const double s = n / (nodes - 1.0);
    motion.evaluate(s, state);
    std::vector<GroundInput> inputs = start.inputs;
    system_->advance(inputs, s * motion.h());
    start.force_at(state, inputs, forces);
    values.row(n) = forces.transpose();
  }
  for (const Eigen::Index i : start.forces.resting) {
    const Eigen::Matrix<double, nodes, 1> powers = to_powers * values.col(i);
    Polynomial force;
    force.degree = nodes - 1;
    for (int k = 0; k < nodes; ++k) force[k] = powers(k);
    motion.set_resting_force(i, force);
  }
}

double Stepper::accuracy() const {
  constexpr double events_over_steps = 100.0;  // errors of an interpolant, and of all steps of one contact
  return events_over_steps * tolerance_of(solver_);
}

/// The bodies that a nonlinear force shakes, directly or through other elements.
BodyRange Stepper::island(const ElementForces& forces) const {
  BodyRange range{std::ssize(system_->blocks), 0};
  const auto take = [&](Eigen::Index i) {
    const ModalSystem::Relation& relation = system_->elements[i].relation;
    range.first = std::min(range.first, relation.left);
    range.end = std::max(range.end, relation.right + 1);
  };
  for (const Eigen::Index i : forces.nonlinear) take(i);
  const auto grows_by = [&](const std::vector<Eigen::Index>& list) {
    bool grows = false;
    for (const Eigen::Index i : list) {
      const ModalSystem::Relation& relation = system_->elements[i].relation;
      const bool reaches_in = relation.left < range.end && relation.right >= range.first;
      const bool reaches_out = relation.left < range.first || relation.right >= range.end;
      if (!reaches_in || !reaches_out) continue;
      take(i);
      grows = true;
    }
    return grows;
  };
  for (bool grows = true; grows;) {
    grows = grows_by(forces.pressing);
    grows = grows_by(forces.resting) || grows;
    for (const ElementForces::Coupled& of : forces.coupled) grows = grows_by(of.at()) || grows;
  }
  return range;
}

}  // namespace bentur::engine
