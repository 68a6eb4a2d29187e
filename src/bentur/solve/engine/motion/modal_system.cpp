#include "bentur/solve/engine/motion/modal_system.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "bentur/solve/engine/motion/kernels/series.h"

namespace bentur::engine {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Rows over the coordinates of a building (docs/theory/exact-solver.md): displacements, drift ratios (of a slab's, the
/// drift), storey shears; then its forces in columns with nodes, moments at hinges, and sway and rocking of its
/// foundation. Columns: modes, ground, and the forces of what yields.
MatrixXd output_rows(const Building& building, Index size) {
  const StructuralModel& model = building.model;
  const Index floors = model.floors();
  const Index modes = building.modes.omega.size();
  const Index columns = model.column_forces.rows();
  const Index hinges = model.hinges.rows.rows();
  MatrixXd rows = MatrixXd::Zero(3 * floors + columns + hinges + (model.has_soil ? 2 : 0), size);
  const auto of_dofs = [&](const MatrixXd& of) { return MatrixXd(of * building.modes.shapes); };
  rows.block(0, 0, floors, modes) = building.modes.shapes.topRows(floors);
  rows.block(floors, 0, floors, modes) = of_dofs(drift_rows(model));
  rows.block(2 * floors, 0, floors, modes) = of_dofs(shear_rows(model));
  for (Index f = 0; f < floors; ++f) {
    if (model.storey_heights[f] > 0.0) rows.row(floors + f) /= model.storey_heights[f];
  }
  Index force = modes + 1;
  for (const BuildingElement& element : building.elements) rows(2 * floors + element.storey, force++) = 1.0;
  for (const CoupledElement& element : building.coupled) {
    const MatrixXd shares = above_storeys(model) * element.rows.transpose();
    rows.block(2 * floors, force, floors, shares.cols()) = shares;
    force += shares.cols();
  }
  if (columns > 0) rows.block(3 * floors, 0, columns, modes) = of_dofs(model.column_forces);
  if (hinges > 0) {
    rows.block(3 * floors + columns, 0, hinges, modes) = of_dofs(model.hinges.rows);
    rows.block(3 * floors + columns, size - hinges, hinges, hinges) = model.hinges.stiffness;
    rows.block(3 * floors, size - hinges, columns, hinges) = -model.hinges.column_forces;
  }
  if (model.has_soil) rows.bottomLeftCorner(2, modes) = building.modes.shapes.bottomRows(2);
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
  block.modes = modes;
  block.size = modes + 1;
  block.size += std::ssize(building.elements);
  for (const CoupledElement& element : building.coupled) block.size += element.rows.rows();
  block.padded_size = padded(block.size);
  block.floors = building.model.floors();
  block.has_foundation = building.model.has_soil;
  block.soil_stiffness << building.model.soil_sway.stiffness, building.model.soil_rocking.stiffness;
  block.soil_damping << building.model.soil_sway.damping, building.model.soil_rocking.damping;
  block.outputs = output_rows(building, block.size);
  block.nodes = building.modes.shapes.middleRows(block.floors, building.model.nodes());
  block.column_forces = building.model.column_forces.rows();
  block.hinges = building.model.hinges.rows.rows();
  block.rotations = block.size - block.hinges;
  block.offsets = VectorXd::Zero(block.outputs.rows());
  block.offsets.segment(3 * block.floors + block.column_forces, block.hinges) = building.model.hinges.at_rest;
  block.acceleration = block.outputs.topRows(block.floors);
  block.acceleration.col(modes).setOnes();

  MatrixXd off_diagonal = building.modal_damping;
  off_diagonal.diagonal().setZero();
  double damping_norm = modes > 0 ? building.modal_damping.diagonal().cwiseAbs().maxCoeff() : 0.0;
  if (!off_diagonal.isZero(0.0)) {
    block.damping = MatrixXd::Zero(block.size, block.size);
    block.damping->topLeftCorner(modes, modes) = building.modal_damping;
    damping_norm = building.modal_damping.norm();
  }
  block.half_damping = 0.5 * damping_norm;
  block.omega_max = modes > 0 ? building.modes.omega.maxCoeff() : 0.0;
  return block;
}

/// δ of a displacement of the left building less one of the right; `shapes`: theirs over the modes.
ModalSystem::Relation between(const std::vector<ModalSystem::Block>& blocks, Index left, const VectorXd& left_shapes,
                              Index right, const VectorXd& right_shapes, Kinematics kinematics) {
  const auto row = [&](Index b, const VectorXd& shapes, double sign) {
    VectorXd result = VectorXd::Zero(blocks[b].padded_size);
    result.head(shapes.size()) = sign * shapes;
    result(shapes.size()) = kinematics == Kinematics::absolute ? sign : 0.0;
    return result;
  };
  ModalSystem::Relation relation;
  relation.left = left;
  relation.left_begin = blocks[left].begin;
  relation.left_size = blocks[left].padded_size;
  relation.left_row = row(left, left_shapes, 1.0);
  relation.right = right;
  relation.right_begin = blocks[right].begin;
  relation.right_size = blocks[right].padded_size;
  relation.right_row = row(right, right_shapes, -1.0);
  return relation;
}

/// A force F pushes against δ, and the ground is not moved by it.
void let_push(const std::vector<ModalSystem::Block>& blocks, ModalSystem::Relation& relation) {
  relation.left_push = -relation.left_row;
  relation.left_push(blocks[relation.left].modes) = 0.0;
  relation.right_push = -relation.right_row;
  if (relation.right_size > 0) relation.right_push(blocks[relation.right].modes) = 0.0;
}

/// The drift of one storey; `shape`: that of each mode.
ModalSystem::Relation drift(const ModalSystem::Block& block, Index building, const VectorXd& shape) {
  ModalSystem::Relation relation;
  relation.left = relation.right = building;
  relation.left_begin = relation.right_begin = block.begin;
  relation.left_size = block.padded_size;
  relation.left_row = VectorXd::Zero(block.padded_size);
  relation.left_row.head(block.modes) = shape;
  return relation;
}

}  // namespace

VectorXd ModalSystem::Block::foundation(const State& state) const {
  if (!has_foundation) return {};
  const auto rows = outputs.bottomRows<2>();
  const Eigen::Vector2d moved = rows * state.q.segment(begin, size);
  const Eigen::Vector2d speed = rows * state.v.segment(begin, size);
  VectorXd result(4);
  result << moved, soil_stiffness.cwiseProduct(moved) + soil_damping.cwiseProduct(speed);
  return result;
}

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
    const Index modes = blocks[b].modes;
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

  const auto shapes_of = [&](Index b, Index floor) -> VectorXd { return problem.buildings[b].modes.shapes.row(floor); };
  for (const ContactPoint& point : problem.points) {
    const Index right = point.left + 1;
    elements.push_back({between(blocks, point.left, shapes_of(point.left, point.left_floor), right,
                                shapes_of(right, point.right_floor), problem.kinematics)});
  }
  switched = std::ssize(elements);
  for (const Link& link : problem.links) {
    elements.push_back({between(blocks, link.left, shapes_of(link.left, link.left_floor), link.right,
                                shapes_of(link.right, link.right_floor), problem.kinematics)});
    spans.push_back(elements.back().relation);
  }
  for (std::size_t i = 0, links = spans.size(); i < links; ++i) {
    Relation opening = spans[i];
    opening.left_row *= -1.0;
    opening.right_row *= -1.0;
    spans.push_back(std::move(opening));
  }
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    const Building& building = problem.buildings[b];
    if (!building.has_gravity_loads) continue;
    const MatrixXd drifts = drift_rows(building.model);
    for (Index f = building.model.first_storey(); f < building.model.floors(); ++f) {
      const auto at = static_cast<Index>(b);
      elements.push_back({drift(blocks[b], at, building.modes.shapes.transpose() * drifts.row(f).transpose())});
      limits.push_back({at, f});
    }
  }
  storeys = std::ssize(elements);
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    const Building& building = problem.buildings[b];
    Index force = blocks[b].begin + blocks[b].modes + 1;
    for (const BuildingElement& element : building.elements) {
      const VectorXd shape = building.modes.shapes.transpose() * element.row;
      elements.push_back({drift(blocks[b], static_cast<Index>(b), shape), element.law->initial_stiffness(),
                          building.tangent_damping, force++});
    }
  }
  alone = std::ssize(elements);
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    const Building& building = problem.buildings[b];
    Index force = blocks[b].begin + blocks[b].modes + 1 + std::ssize(building.elements);
    for (const CoupledElement& element : building.coupled) {
      coupled.push_back({std::ssize(elements), element.rows.rows(), element.law});
      for (const auto& row : element.rows.rowwise()) {
        const VectorXd shape = building.modes.shapes.transpose() * row.transpose();
        elements.push_back({drift(blocks[b], static_cast<Index>(b), shape), 0.0, 0.0, force++});
      }
    }
  }
  for (Element& element : elements) let_push(blocks, element.relation);
  for (const WatchedFloor& floor : problem.watched) {
    const Index left = floor.left;
    watched.push_back(between(blocks, left, problem.buildings[left].modes.shapes.transpose() * floor.left_row, left + 1,
                              problem.buildings[left + 1].modes.shapes.transpose() * floor.right_row,
                              problem.kinematics));
  }
  const Index count = std::ssize(elements);
  coupling = MatrixXd::Zero(count, count);
  for (Index i = 0; i < count; ++i) {
    VectorXd pushed = VectorXd::Zero(size);
    push(i, -1.0, pushed);
    for (Index j = 0; j < count; ++j) coupling(i, j) = elements[j].relation.along(pushed);
  }
}

double ModalSystem::rate(const ElementForces& forces) const {
  // The largest row sum of the pressing elements' coupling bounds its largest eigenvalue.
  struct Sides {
    double above = 0, below = 0;  // of what is added and of what is taken away
  };
  const auto largest = [&](double ElementForces::Linear::*of) {
    Sides sides;
    for (const Index i : forces.pressing) {
      const double own = forces.linear[i].*of;
      double row = 0.0;
      for (const Index j : forces.pressing) {
        const double product = own * forces.linear[j].*of;
        const bool same_side = product > 0.0 && (own > 0.0) == (forces.linear[j].*of > 0.0);
        if (same_side) row += std::abs(coupling(i, j)) * std::sqrt(product);
      }
      double& side = own > 0.0 ? sides.above : sides.below;
      side = std::max(side, row);
    }
    return sides;
  };
  Sides stiffness = largest(&ElementForces::Linear::stiffness);
  Sides damping = largest(&ElementForces::Linear::damping);
  // Rᵀ X R of coupled rows R has the norm of Lᵀ X L, R Rᵀ = L Lᵀ.
  const auto add = [](const MatrixXd& x, const MatrixXd& l, Sides& sides) {
    if (x.size() == 0) return;
    const MatrixXd inner = l.transpose() * x * l;
    if (x == x.transpose()) {
      const VectorXd values = Eigen::SelfAdjointEigenSolver<MatrixXd>(inner, Eigen::EigenvaluesOnly).eigenvalues();
      sides.above += std::max(values.maxCoeff(), 0.0);
      sides.below += std::max(-values.minCoeff(), 0.0);
    } else {
      sides.above += inner.norm();
    }
  };
  for (const ElementForces::Coupled& of : forces.coupled) {
    const Eigen::SelfAdjointEigenSolver<MatrixXd> rows(coupling(of.at, of.at));
    const MatrixXd l = rows.eigenvectors() * rows.eigenvalues().cwiseMax(0.0).cwiseSqrt().asDiagonal();
    add(of.stiffness, l, stiffness);
    add(of.damping, l, damping);
  }
  double half_damping = 0.0;
  double omega = nu;
  for (const Block& block : blocks) {
    half_damping = std::max(half_damping, block.half_damping);
    omega = std::max(omega, block.omega_max);
  }
  half_damping = std::max(half_damping + 0.5 * damping.above, 0.5 * damping.below);
  const double stiffest = std::max(omega * omega + stiffness.above, stiffness.below);
  return std::max(half_damping + std::sqrt(half_damping * half_damping + stiffest), forces.fading);
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

void ModalSystem::fill_forces(const ElementForces::Coupled& of, const std::vector<double>& offsets,
                              State& state) const {
  const VectorXd forces = of.base + of.stiffness * deformations(of.at, offsets, state.q);
  const VectorXd rates = of.stiffness * speeds(of.at, state.v);
  for (Index n = 0; n < forces.size(); ++n) {
    if (elements[of.at[n]].force < 0) continue;
    state.q(elements[of.at[n]].force) = forces(n);
    state.v(elements[of.at[n]].force) = rates(n);
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

const double* ModalSystem::load_of(std::size_t b, const double* q, VectorXd& load) const {
  const Block& block = blocks[b];
  bool any = false;
  for (Index i = storeys; i < std::ssize(elements); ++i) {
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
  for (Index i = storeys; i < std::ssize(elements); ++i) {
    if (q[elements[i].force] == 0.0) continue;
    if (!any) load.setZero(size);
    any = true;
    push(i, q[elements[i].force], load);
  }
  return any ? load.data() : nullptr;
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
