#include "bentur/solve/engine/tangent/tangent_step.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace bentur::engine {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::RowVectorXd;
using Eigen::VectorXd;

constexpr Index most_terms = 64;
constexpr Index least_terms = 6;        // of which no two that follow one another are zero by chance
constexpr double series_end = 0x1p-51;  // of the sum so far: smaller terms end a series
constexpr double rates_in_step = 4.0;   // e⁴ / 40! is below round-off by far

/// Whether what is added is nothing beside the sum so far.
bool is_nothing(Index size, const double* added, const double* sum) {
  double more = 0.0, all = 0.0;
  for (Index i = 0; i < size; ++i) {
    more = std::max(more, std::abs(added[i]));
    all = std::max(all, std::abs(sum[i]));
  }
  return more <= series_end * all;
}

/// term = factor × of, which is added to the sum.
void add_term(Index size, double factor, const double* of, double* term, double* sum) {
  for (Index i = 0; i < size; ++i) {
    term[i] = factor * of[i];
    sum[i] += term[i];
  }
}

}  // namespace

RowVectorXd along(const ModalSystem::Relation& at, const MatrixXd& x) {
  RowVectorXd result(x.cols());
  for (Index p = 0; p < x.cols(); ++p) result(p) = at.along(x.data() + p * x.rows());
  return result;
}

void TangentInputs::advance(const ModalSystem& modal, const Dependence& by, double dt) {
  const Index ways = modal.components();
  for (Index i = 0; i < (moves ? values.rows() : 0); ++i) {
    const double nu = modal.nu[i % ways];
    if (nu == 0.0) {
      values.row(i) += dt * slopes.row(i);
      continue;
    }
    const double c = std::cos(nu * dt), s = std::sin(nu * dt);
    const GroundInput& u = inputs[i];
    // Of value and slope themselves, and of ν within cos ν t and sin ν t / ν.
    const RowVectorXd value = c * values.row(i) + s / nu * slopes.row(i) +
                              (-u.value * dt * s + u.slope * (dt * c / nu - s / (nu * nu))) * by.nu().row(i % ways);
    slopes.row(i) = (c * slopes.row(i) - nu * s * values.row(i)).eval() +
                    (-u.slope * dt * s - u.value * (s + nu * dt * c)) * by.nu().row(i % ways);
    values.row(i) = value;
  }
  modal.advance(inputs, dt);
}

TangentStep::TangentStep(const ModalSystem& modal, const Dependence& by)
    : modal_(&modal), by_(&by), kept_(modal.size, most_terms) {
  const Index n = modal.size, count = by.count();
  a_.resize(n);
  by_a_.resize(n, count);
  for (Terms* of : {&term_, &sums_}) *of = {a_, a_, by_a_, by_a_};
}

double TangentStep::longest(const std::vector<Pressing>& pressing) const {
  ElementForces forces;
  forces.linear.resize(modal_->elements.size());
  for (const Pressing& one : pressing) {
    forces.linear[one.element] = one.force;
    forces.pressing.push_back(one.element);
  }
  const double rate = modal_->rate(forces);
  return rate > 0.0 ? rates_in_step / rate : std::numeric_limits<double>::infinity();
}

/// a_ and by_a_ of one term of the series; `rate` turns its v into lengths a second.
void TangentStep::accelerate(double rate, bool first, const std::vector<Pressing>& pressing,
                             const std::vector<double>& offsets) {
  const Index ways = modal_->components(), count = by_->count(), size = modal_->size;
  const double *stiff = modal_->omega_squared.data(), *damped = modal_->two_sigma.data();
  for (Index i = 0; i < size; ++i) a_(i) = -stiff[i] * term_.q(i) - rate * damped[i] * term_.v(i);
  for (Index p = 0; p < count; ++p) {
    const double *q = term_.by_q.data() + p * size, *v = term_.by_v.data() + p * size;
    double* a = by_a_.data() + p * size;
    for (Index i = 0; i < size; ++i) a[i] = -stiff[i] * q[i] - rate * damped[i] * v[i];
  }
  for (std::size_t b = 0; b < modal_->blocks.size(); ++b) {
    const ModalSystem::Block& block = modal_->blocks[b];
    const Index begin = block.begin, n = block.modes + ways;
    if (block.damping) {
      MatrixXd off = block.damping->topLeftCorner(block.modes, block.modes);
      off.diagonal().setZero();
      a_.segment(begin, block.modes).noalias() -= rate * (off * term_.v.segment(begin, block.modes));
      by_a_.middleRows(begin, block.modes).noalias() -= rate * (off * term_.by_v.middleRows(begin, block.modes));
    }
    for (Index c = 0; c < ways; ++c) {
      const Index input = static_cast<Index>(b) * ways + c;
      const double* gamma = modal_->gamma.data() + c * size + begin;
      for (Index i = 0; i < n; ++i) a_(begin + i) += u_[input] * gamma[i];
      for (Index p = 0; p < (moves_ ? count : 0); ++p) {
        double* a = by_a_.data() + p * size + begin;
        for (Index i = 0; i < n; ++i) a[i] += gamma[i] * by_u_(input, p);
      }
    }
  }
  for (const Pressing& one : pressing) {
    const ModalSystem::Relation& at = modal_->elements[one.element].relation;
    const double deformation = at.along(term_.q) + (first ? offsets[one.element] : 0.0);
    const double speed = rate * at.along(term_.v);
    const double force = (first ? one.force.base : 0.0) + one.force.stiffness * deformation + one.force.damping * speed;
    modal_->push(one.element, force, a_);
    for (Index p = 0; p < count; ++p) {
      double by = one.force.stiffness * at.along(term_.by_q.data() + p * size) + one.stiffness(p) * deformation +
                  one.force.damping * rate * at.along(term_.by_v.data() + p * size) + one.damping(p) * speed;
      if (first) by += one.base(p) + one.force.stiffness * by_->offsets()(one.element, p);
      double* a = by_a_.data() + p * size;
      for (Index i = 0; i < at.left_size; ++i) a[at.left_begin + i] += by * at.left_push(i);
      for (Index i = 0; i < at.right_size; ++i) a[at.right_begin + i] += by * at.right_push(i);
    }
    if (count == 0) continue;
    for (const Dependence::OfRow& moved : by_->rows(one.element)) {
      const double by =
          one.force.stiffness * moved.row.dot(term_.q) + one.force.damping * rate * moved.row.dot(term_.v);
      double* a = by_a_.data() + moved.parameter * size;
      for (Index i = 0; i < at.left_size; ++i) a[at.left_begin + i] += by * at.left_push(i);
      for (Index i = 0; i < at.right_size; ++i) a[at.right_begin + i] += by * at.right_push(i);
      for (Index i = 0; i < size; ++i) a[i] += force * moved.push(i);
    }
  }
  if (count == 0) return;
  for (std::size_t b = 0; b < modal_->blocks.size(); ++b) {
    const Dependence::OfBody& body = by_->body(b);
    if (body.parameters.empty()) continue;
    const Index begin = modal_->blocks[b].begin, n = modal_->blocks[b].modes;
    column_.resize(3 * n + ways);
    for (Index i = 0; i < n; ++i) {
      column_(i) = a_(begin + i);
      column_(n + i) = term_.q(begin + i);
      column_(2 * n + i) = rate * term_.v(begin + i);
    }
    for (Index c = 0; c < ways; ++c) column_(3 * n + c) = u_[b * ways + c];
    product_.noalias() = body.matrices * column_;
    for (Index m = 0; m < std::ssize(body.parameters); ++m) {
      double* a = by_a_.data() + body.parameters[m] * size + begin;
      for (Index i = 0; i < n; ++i) a[i] += product_(m * n + i);
    }
  }
}

void TangentStep::accelerations(const TangentState& state, const TangentInputs& at,
                                const std::vector<Pressing>& pressing, const std::vector<double>& offsets,
                                VectorXd& a) {
  u_.resize(at.inputs.size());
  for (std::size_t i = 0; i < u_.size(); ++i) u_[i] = at.inputs[i].value;
  moves_ = at.moves;
  by_u_ = at.values;
  term_ = {state.q, state.v, state.by_q, state.by_v};
  accelerate(1.0, true, pressing, offsets);
  a = a_;
}

/// The next term of the inputs, after the k-th.
void TangentStep::go_on_with_inputs(Index k, double h) {
  const Index ways = modal_->components();
  for (std::size_t i = 0; i < u_.size(); ++i) {
    const Index c = static_cast<Index>(i) % ways;
    const double nu = modal_->nu[c];
    const double factor = -h * h / static_cast<double>((k + 1) * (k + 2));
    const double later = factor * nu * nu * u_[i];
    if (moves_) {
      const auto row = static_cast<Index>(i);
      const RowVectorXd by = factor * (nu * nu * by_u_.row(row) + 2.0 * nu * u_[i] * by_->nu().row(c));
      by_u_.row(row) = by_u_next_.row(row);
      by_u_next_.row(row) = by;
    }
    u_[i] = u_next_[i];
    u_next_[i] = later;
  }
}

void TangentStep::advance(TangentState& state, const TangentInputs& at, const std::vector<Pressing>& pressing,
                          const std::vector<double>& offsets, double h) {
  const Index size = modal_->size, all = size * by_->count();
  const double rate = 1.0 / h;
  u_.resize(at.inputs.size());
  u_next_.resize(u_.size());
  for (std::size_t i = 0; i < u_.size(); ++i) {
    u_[i] = at.inputs[i].value;
    u_next_[i] = at.inputs[i].slope * h;
  }
  moves_ = at.moves;
  if (moves_) {
    by_u_ = at.values;
    by_u_next_ = h * at.slopes;
  }
  sums_.q = term_.q = state.q;
  sums_.v = term_.v = h * state.v;
  if (all > 0) {
    sums_.by_q = term_.by_q = state.by_q;
    sums_.by_v = term_.by_v = h * state.by_v;
  }
  kept_.col(0) = term_.q;
  bool was_nothing = false;
  for (Index k = 0; k + 1 < most_terms; ++k) {
    accelerate(rate, k == 0, pressing, offsets);
    const double next = 1.0 / static_cast<double>(k + 1);
    add_term(size, next, term_.v.data(), term_.q.data(), sums_.q.data());
    add_term(size, next * h * h, a_.data(), term_.v.data(), sums_.v.data());
    add_term(all, next, term_.by_v.data(), term_.by_q.data(), sums_.by_q.data());
    add_term(all, next * h * h, by_a_.data(), term_.by_v.data(), sums_.by_v.data());
    kept_.col(k + 1) = term_.q;
    terms_ = k + 2;
    go_on_with_inputs(k, h);
    const bool nothing = k + 1 >= least_terms && is_nothing(size, term_.v.data(), sums_.v.data()) &&
                         is_nothing(size, term_.q.data(), sums_.q.data()) &&
                         is_nothing(all, term_.by_v.data(), sums_.by_v.data()) &&
                         is_nothing(all, term_.by_q.data(), sums_.by_q.data());
    if (nothing && was_nothing) break;
    was_nothing = nothing;
  }
  state.q = sums_.q;
  state.v = rate * sums_.v;
  if (all > 0) {
    state.by_q = sums_.by_q;
    state.by_v = rate * sums_.by_v;
  }
}

}  // namespace bentur::engine
