#include "bentur/solve/engine/motion/modal_system.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "bentur/core/algebra/factors.h"
#include "bentur/core/algebra/symmetric.h"
#include "bentur/core/errors.h"
#include "bentur/core/require.h"
#include "bentur/solve/engine/motion/kernels/series.h"

namespace bentur::engine {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// rows · shapes. Most rows have few entries: a floor's displacement one, a storey's drift two.
MatrixXd over_modes(const MatrixXd& rows, const MatrixXd& shapes) {
  if ((rows.array() != 0.0).count() > 2 * rows.rows()) return rows * shapes;
  MatrixXd result = MatrixXd::Zero(rows.rows(), shapes.cols());
  for (Index k = 0; k < rows.cols(); ++k) {
    for (Index i = 0; i < rows.rows(); ++i) {
      if (rows(i, k) != 0.0) result.row(i) += rows(i, k) * shapes.row(k);
    }
  }
  return result;
}

/// Outputs of a body of `size` coordinates over them: modes, ground, and the forces of what yields.
ModalSystem::Block::Group over_coordinates(const Body& body, const Outputs& outputs, Index size, Index components) {
  const Index modes = body.modes.omega.size();
  ModalSystem::Block::Group group;
  group.at_rest = outputs.at_rest.size() > 0 ? outputs.at_rest : VectorXd(VectorXd::Zero(outputs.count));
  group.has_peak = outputs.has_peak;
  group.course = outputs.course;
  const auto over = [&](const MatrixXd& of_dofs, MatrixXd& result) {
    if (of_dofs.size() == 0) return;
    result = MatrixXd::Zero(outputs.count, size);
    result.leftCols(modes) = over_modes(of_dofs, body.modes.shapes);
  };
  over(outputs.rows, group.of_position);
  over(outputs.rates, group.of_speed);
  over(outputs.absolute, group.of_acceleration);
  if (outputs.absolute.size() > 0 && outputs.ground.size() > 0) {
    group.of_acceleration.middleCols(modes, components) = outputs.ground;
  } else if (outputs.absolute.size() > 0) {
    group.of_acceleration.col(modes).setOnes();
  }
  if (outputs.forces.size() > 0) {
    if (group.of_position.size() == 0) group.of_position = MatrixXd::Zero(outputs.count, size);
    group.of_position.rightCols(size - modes - components) = outputs.forces;
  }
  return group;
}

Index padded(Index coordinates) {
  constexpr Index four = 4;
  return (coordinates + four - 1) / four * four;
}

ModalSystem::Block make_block(const Body& body, Index begin, Index components) {
  ModalSystem::Block block;
  const Index modes = body.modes.omega.size();
  block.begin = begin;
  block.modes = modes;
  block.size = modes + components;
  block.size += std::ssize(body.elements);
  for (const CoupledElement& element : body.coupled) block.size += element.rows.rows();
  block.padded_size = padded(block.size);
  block.moving_size = padded(modes + components);
  for (const Outputs& outputs : body.outputs) {
    block.outputs.push_back(over_coordinates(body, outputs, block.size, components));
  }

  MatrixXd off_diagonal = body.modal_damping;
  off_diagonal.diagonal().setZero();
  double damping_norm = modes > 0 ? body.modal_damping.diagonal().cwiseAbs().maxCoeff() : 0.0;
  if (!off_diagonal.isZero(0.0)) {
    block.damping = MatrixXd::Zero(block.size, block.size);
    block.damping->topLeftCorner(modes, modes) = body.modal_damping;
    damping_norm = body.modal_damping.norm();
  }
  block.half_damping = 0.5 * damping_norm;
  block.omega_max = modes > 0 ? body.modes.omega.maxCoeff() : 0.0;
  return block;
}

/// A row over the modes and the ground of one body, which may be left out.
struct Side {
  Index body = 0, begin = 0, size = 0;
  VectorXd row = {};
};

Side side_of(const std::vector<ModalSystem::Block>& blocks, const std::vector<Body>& bodies, const BodyRow& of) {
  const ModalSystem::Block& block = blocks[of.body];
  Side side{of.body, block.begin, block.moving_size, VectorXd::Zero(block.moving_size)};
  side.row.head(block.modes) = bodies[of.body].modes.shapes.transpose() * of.row;
  side.row.segment(block.modes, of.ground.size()) = of.ground;
  return side;
}

ModalSystem::Relation relation_of(const std::vector<ModalSystem::Block>& blocks, const std::vector<Body>& bodies,
                                  const Interface& interface) {
  if (interface.right.body >= 0 && interface.right.body < interface.left.body) {  // bodies in their order
    return relation_of(blocks, bodies, {interface.right, interface.left});
  }
  const Side left = side_of(blocks, bodies, interface.left);
  ModalSystem::Relation relation;
  relation.left = relation.right = left.body;
  relation.left_begin = relation.right_begin = left.begin;
  relation.left_size = left.size;
  relation.left_row = left.row;
  if (interface.right.body < 0) return relation;
  const Side right = side_of(blocks, bodies, interface.right);
  relation.right = right.body;
  relation.right_begin = right.begin;
  relation.right_size = right.size;
  relation.right_row = right.row;
  return relation;
}

/// A force F pushes against δ, and the ground is not moved by it.
void let_push(const std::vector<ModalSystem::Block>& blocks, Index components, ModalSystem::Relation& relation) {
  relation.left_push = -relation.left_row;
  relation.left_push.segment(blocks[relation.left].modes, components).setZero();
  relation.right_push = -relation.right_row;
  if (relation.right_size > 0) relation.right_push.segment(blocks[relation.right].modes, components).setZero();
}

/// ModalSystem::coupling. An element feels nothing of one between two other bodies.
Couplings couplings(const ModalSystem& system) {
  const auto& elements = system.elements;
  const Index count = std::ssize(elements);
  std::vector<std::vector<Index>> of_body(system.blocks.size());
  for (Index i = 0; i < count; ++i) {
    const ModalSystem::Relation& at = elements[i].relation;
    of_body[at.left].push_back(i);
    if (at.right != at.left) of_body[at.right].push_back(i);
  }
  Couplings coupling(count);
  std::vector<std::pair<Index, double>> row;
  VectorXd pushed = VectorXd::Zero(system.size);
  for (Index i = 0; i < count; ++i) {
    const ModalSystem::Relation& at = elements[i].relation;
    system.push(i, -1.0, pushed);
    row.clear();
    for (const Index j : of_body[at.left]) row.emplace_back(j, elements[j].relation.along(pushed));
    for (const Index j : of_body[at.right]) {
      const ModalSystem::Relation& other = elements[j].relation;
      const bool is_taken = other.left == at.left || other.right == at.left;
      if (!is_taken) row.emplace_back(j, other.along(pushed));
    }
    coupling.set_row(i, row);
    pushed.segment(at.left_begin, at.left_size).setZero();
    pushed.segment(at.right_begin, at.right_size).setZero();
  }
  return coupling;
}

}  // namespace

void ModalSystem::Block::Group::evaluate(const Coordinates& q, const Coordinates& v, const Coordinates& a,
                                         Eigen::Ref<MatrixXd> result) const {
  result.colwise() = at_rest;
  if (of_position.size() > 0) result.noalias() += of_position * q;
  if (of_speed.size() > 0) result.noalias() += of_speed * v;
  if (of_acceleration.size() > 0) result.noalias() += of_acceleration * a;
}

ModalSystem::Relation ModalSystem::Relation::times(double factor) const {
  Relation result = *this;
  result.left_row *= factor;
  result.right_row *= factor;
  return result;
}

ModalSystem::ModalSystem(const System& of) {
  const Index ways = std::ssize(of.motions);
  if (ways < 1 || of.motions.size() > most_components) {
    throw InvalidParameter("motions", std::to_string(ways), "must be 1 to " + std::to_string(most_components));
  }
  for (const GroundMotion& motion : of.motions) nu.push_back(angular_frequency(motion));
  for (const Body& body : of.bodies) {
    require_size("columns of load", body.load.cols(), ways);
    blocks.push_back(make_block(body, size, ways));
    size += blocks.back().padded_size;
    classical = classical && !blocks.back().damping;
  }
  omega_squared = VectorXd::Zero(size);
  two_sigma = VectorXd::Zero(size);
  gamma = MatrixXd::Zero(size, ways);
  of_mode = VectorXd::Zero(size);
  initial_q = VectorXd::Zero(size);
  initial_v = VectorXd::Zero(size);
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    const Body& body = of.bodies[b];
    const Index begin = blocks[b].begin;
    const Index modes = blocks[b].modes;
    omega_squared.segment(begin, modes) = body.modes.omega.cwiseAbs2();
    two_sigma.segment(begin, modes) = body.modal_damping.diagonal();
    of_mode.segment(begin, modes).setOnes();
    for (Index c = 0; c < ways; ++c) {
      gamma(begin + modes + c, c) = 1.0;
      gamma.col(c).segment(begin, modes) = -body.modes.shapes.transpose() * body.load.col(c);
    }
    const auto to_modes = [&body](const VectorXd& x) -> VectorXd {
      return body.modes.shapes.transpose() * (body.mass * x);
    };
    if (!of.initial_displacement.empty()) initial_q.segment(begin, modes) = to_modes(of.initial_displacement[b]);
    if (!of.initial_velocity.empty()) initial_v.segment(begin, modes) = to_modes(of.initial_velocity[b]);
  }

  const auto add = [&](const Interface& interface) -> const Relation& {
    elements.push_back({relation_of(blocks, of.bodies, interface)});
    return elements.back().relation;
  };
  for (const Contact& contact : of.contacts) add(contact.at);
  switched = std::ssize(elements);
  for (const bentur::Element& joint : of.joints) spans.push_back(add(joint.at));
  joints = std::ssize(spans);
  for (Index i = 0; i < joints; ++i) spans.push_back(spans[i].times(-1.0));
  for (const bentur::Element& limit : of.limits) add(limit.at);
  members = std::ssize(elements);
  const auto add_member = [&](Index b, const VectorXd& row, double stiffness, double tangent_damping, Index force) {
    elements.push_back({relation_of(blocks, of.bodies, {{b, row}}), stiffness, tangent_damping, force});
  };
  for (Index b = 0; b < std::ssize(blocks); ++b) {
    Index force = ground_of(b) + ways;
    for (const BuildingElement& element : of.bodies[b].elements) {
      add_member(b, element.row, element.law->initial_stiffness(), element.damped ? of.bodies[b].tangent_damping : 0.0,
                 force++);
      if (!element.law->yields_unevenly()) continue;
      spans.push_back(elements.back().relation);
      spans.push_back(spans.back().times(-1.0));
    }
  }
  alone = std::ssize(elements);
  for (Index b = 0; b < std::ssize(blocks); ++b) {
    Index force = ground_of(b) + ways + std::ssize(of.bodies[b].elements);
    for (const CoupledElement& element : of.bodies[b].coupled) {
      coupled.push_back({std::ssize(elements), element.rows.rows()});
      for (const auto& row : element.rows.rowwise()) add_member(b, row.transpose(), 0.0, 0.0, force++);
    }
  }
  rubs = std::ssize(elements);
  rubbing = std::ssize(of.rubbing);
  for (const RubbingContact& contact : of.rubbing) {
    coupled.push_back({std::ssize(elements), 2});
    add(contact.at);
    add(contact.along);
  }
  for (Element& element : elements) let_push(blocks, ways, element.relation);
  for (const Interface& interface : of.watched) watched.push_back(relation_of(blocks, of.bodies, interface));
  for (const Interface& interface : of.watched_free) watched_free.push_back(relation_of(blocks, of.bodies, interface));
  const auto has_ground = [&](const Relation& at) {
    return !at.left_row.segment(blocks[at.left].modes, ways).isZero(0.0) ||
           (at.right_size > 0 && !at.right_row.segment(blocks[at.right].modes, ways).isZero(0.0));
  };
  ground_counts =
      std::any_of(elements.begin(), elements.end(), [&](const auto& e) { return has_ground(e.relation); }) ||
      std::any_of(watched.begin(), watched.end(), has_ground);
  coupling = couplings(*this);
}

namespace {

/// Bounds of what is added to squares of frequencies or to damping, and of what is taken away.
struct Sides {
  double above = 0, below = 0;
};

/// The largest row sum of the pressing elements' coupling bounds its largest eigenvalue.
Sides largest_of(const Couplings& coupling, const std::vector<Index>& pressing,
                 const std::vector<ElementForces::Linear>& linear, double ElementForces::Linear::*of) {
  Sides sides;
  for (const Index i : pressing) {
    const double own = linear[i].*of;
    double row = 0.0;
    coupling.in_row(i, pressing, [&](Index j, double value) {
      const double product = own * linear[j].*of;
      const bool same_side = product > 0.0 && (own > 0.0) == (linear[j].*of > 0.0);
      if (same_side) row += std::abs(value) * std::sqrt(product);
    });
    double& side = own > 0.0 ? sides.above : sides.below;
    side = std::max(side, row);
  }
  return sides;
}

/// Of blocks as fast, and so damped.
double growth(double omega, double half_damping, const Sides& stiffness, const Sides& damping) {
  half_damping = std::max(half_damping + 0.5 * damping.above, 0.5 * damping.below);
  const double stiffest = std::max(omega * omega + stiffness.above, stiffness.below);
  return half_damping + std::sqrt(half_damping * half_damping + stiffest);
}

}  // namespace

[[gnu::flatten]] double ModalSystem::rate(const ElementForces& forces) const {
  Sides stiffness = largest_of(coupling, forces.pressing, forces.linear, &ElementForces::Linear::stiffness);
  Sides damping = largest_of(coupling, forces.pressing, forces.linear, &ElementForces::Linear::damping);
  for (const ElementForces::Coupled& of : forces.coupled) {
    stiffness.above += of.modal->stiffer;
    stiffness.below += of.modal->softer;
    damping.above += of.modal->damped;
    damping.below += of.modal->driven;
  }
  double half_damping = 0.0;
  double omega = fastest_input();
  for (const Block& block : blocks) {
    half_damping = std::max(half_damping, block.half_damping);
    omega = std::max(omega, block.omega_max);
  }
  return std::max(growth(omega, half_damping, stiffness, damping), forces.fading);
}

double ModalSystem::rate(const std::vector<Index>& bodies, const std::vector<Index>& pressing,
                         const std::vector<ElementForces::Linear>& linear) const {
  double half_damping = 0.0;
  double omega = fastest_input();
  for (const Index b : bodies) {
    half_damping = std::max(half_damping, blocks[b].half_damping);
    omega = std::max(omega, blocks[b].omega_max);
  }
  return growth(omega, half_damping, largest_of(coupling, pressing, linear, &ElementForces::Linear::stiffness),
                largest_of(coupling, pressing, linear, &ElementForces::Linear::damping));
}

ElementForces::Coupled::Modal ModalSystem::modal_of(const std::vector<Index>& at, const MatrixXd& stiffness,
                                                    const MatrixXd& damping) const {
  ElementForces::Coupled::Modal of;
  const Relation& first = elements[at.front()].relation;
  of.at = at;
  of.begin = first.left_begin;
  MatrixXd rows(first.size(), std::ssize(at));
  of.push.resizeLike(rows);
  for (Index n = 0; n < rows.cols(); ++n) {
    const Relation& each = elements[at[n]].relation;
    Relation::spread(each.left_row, each.right_row, rows.col(n));
    Relation::spread(each.left_push, each.right_push, of.push.col(n));
  }
  of.pull = rows * stiffness.transpose();
  of.packed_pull = kernels::PackedRows(of.pull.transpose(), of.pull.rows());
  if (rows.rows() <= 2 * rows.cols()) of.tied = of.push * of.pull.transpose();
  const auto norms = [](const MatrixXd& inner, bool symmetric, double& above, double& below) {
    above = below = inner.norm();
    if (!symmetric) return;
    const VectorXd values = symmetric_values(inner);
    above = std::max(values.maxCoeff(), 0.0);
    below = std::max(-values.minCoeff(), 0.0);
  };
  const bool symmetric = stiffness == stiffness.transpose();
  if (symmetric && of.tied.size() > 0 && damping.size() == 0) {
    norms(-of.tied, true, of.stiffer, of.softer);
    return of;
  }
  // Rᵀ X R of coupled rows R has the norm of Lᵀ X L, R Rᵀ = L Lᵀ.
  const SymmetricModes gram = symmetric_modes(coupling.among(at));
  const MatrixXd l = gram.vectors * gram.values.cwiseMax(0.0).cwiseSqrt().asDiagonal();
  norms(l.transpose() * stiffness * l, symmetric, of.stiffer, of.softer);
  if (damping.size() > 0) {
    norms(l.transpose() * damping * l, damping == damping.transpose(), of.damped, of.driven);
  }
  return of;
}

void ModalSystem::acceleration(const State& state, const std::vector<GroundInput>& inputs, const VectorXd& forces,
                               VectorXd& result) const {
  result.resize(size);
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    const Block& block = blocks[b];
    const Index begin = block.begin;
    kernels::accelerate(block.padded_size, omega_squared.data() + begin, two_sigma.data() + begin, gamma.data() + begin,
                        of_body(inputs, b)->value, state.q.data() + begin, state.v.data() + begin,
                        result.data() + begin);
    for (Index c = 1; c < components(); ++c) {
      result.segment(begin, block.size) += of_body(inputs, b)[c].value * gamma.col(c).segment(begin, block.size);
    }
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

VectorXd ModalSystem::speeds(const std::vector<Index>& at, const VectorXd& v) const {
  VectorXd result(std::ssize(at));
  for (Index n = 0; n < result.size(); ++n) result(n) = elements[at[n]].relation.along(v);
  return result;
}

VectorXd ModalSystem::deformations(const std::vector<Index>& at, const std::vector<double>& offsets,
                                   const VectorXd& q) const {
  VectorXd result = speeds(at, q);
  for (Index n = 0; n < result.size(); ++n) result(n) += offsets[at[n]];
  return result;
}

void ModalSystem::fill_forces(const ElementForces::Coupled& of, State& state) const {
  if (elements[of.at().front()].force < 0) return;
  const ElementForces::Coupled::Modal& modal = *of.modal;
  const Index size = modal.pull.rows();
  for (Index n = 0; n < modal.pull.cols(); ++n) {
    const double* pull = modal.pull.col(n).data();
    const Index to = elements[modal.at[n]].force;
    state.q(to) = of.base(n) + kernels::dot(size, pull, state.q.data() + modal.begin);
    state.v(to) = kernels::dot(size, pull, state.v.data() + modal.begin);
  }
}

void ModalSystem::push(Index i, double force, VectorXd& result) const {
  const Relation& relation = elements[i].relation;
  const auto add = [&](Index begin, const VectorXd& by) {
    double* to = result.data() + begin;
    for (Index j = 0; j < by.size(); ++j) to[j] += force * by[j];
  };
  add(relation.left_begin, relation.left_push);
  add(relation.right_begin, relation.right_push);
}

void ModalSystem::push(const ElementForces::Coupled& of, const State& state, VectorXd& result) const {
  const ElementForces::Coupled::Modal& modal = *of.modal;
  const Index size = modal.pull.rows();
  auto pushed = result.segment(modal.begin, size);
  pushed += of.steady;
  for (Index n = 0; n < modal.pull.cols(); ++n) {
    pushed += kernels::dot(size, modal.pull.col(n).data(), state.q.data() + modal.begin) * modal.push.col(n);
  }
  if (of.damping().size() > 0) pushed.noalias() += modal.push * (of.damping() * speeds(of.at(), state.v));
}

const double* ModalSystem::load_of(std::size_t b, const double* q, VectorXd& load) const {
  const Block& block = blocks[b];
  bool any = false;
  for (Index i = members; i < rubs; ++i) {
    const Element& element = elements[i];
    if (element.relation.left_begin != block.begin || q[element.force] == 0.0) continue;
    if (!any) {
      load.resize(size);
      load.segment(block.begin, block.padded_size).setZero();
    }
    any = true;
    push(i, q[element.force], load);
  }
  return any ? load.data() : nullptr;
}

const double* ModalSystem::load_of(const double* q, VectorXd& load) const {
  bool any = false;
  for (Index i = members; i < rubs; ++i) {
    if (q[elements[i].force] == 0.0) continue;
    if (!any) load.setZero(size);
    any = true;
    push(i, q[elements[i].force], load);
  }
  return any ? load.data() : nullptr;
}

VectorXd ModalSystem::forces_for(const std::vector<Index>& at, const VectorXd& missing) const {
  const Index count = std::ssize(at);
  const MatrixXd matrix = coupling.among(at);
  if (count == 0) return missing;
  constexpr double apart = 1e-11;  // of the largest pivot: what holds more than can move does so with the least norm
  const Ldlt factors(matrix);
  if (factors.is_definite(apart)) return factors.solve(missing);
  return least_norm_solution(matrix, missing, apart);
}

void ModalSystem::advance(GroundInput* input, double dt) const {
  for (const double by : nu) {
    *input = input->later(dt, by);
    ++input;
  }
}

void ModalSystem::advance(std::vector<GroundInput>& inputs, double dt) const {
  if (fastest_input() == 0.0) {
    for (GroundInput& input : inputs) input.value += input.slope * dt;
    return;
  }
  for (std::size_t b = 0; b < blocks.size(); ++b) advance(inputs.data() + b * nu.size(), dt);
}

double ModalSystem::Block::rate() const { return half_damping + std::hypot(half_damping, omega_max); }

}  // namespace bentur::engine
