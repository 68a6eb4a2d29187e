#include "bentur/elements/hinges.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "bentur/core/errors.h"
#include "bentur/core/require.h"
#include "bentur/elements/complementarity.h"

namespace bentur {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

constexpr double on_line = 1e-10;  // of upper + lower: a hinge that is so near its line is on it
constexpr double no_flow = 1e-12;  // of (upper + lower)/K_hh: a flow that counts nowhere
constexpr double no_slope = 1e-9;  // of what it is a sum of: a rate that is zero
constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

// Columns of a state's memory.
enum Column : Index {
  rotation,      // θ at the last event [rad]
  side,          // on which it flows; 0: it rests
  peak,          // max |θ|
  lost,          // ∫ (M − Hθ) dθ
  first_yield,   // [s]; NaN: none
  half_cycles,   //
  last_side,     // of the latest flow that counted
  flow_began,    // [s]
  mechanism_at,  // of the frame, in the first row [s]; NaN: none
  moved,         // 1: it flowed then
  begins,        // order of the zero that its guard begins the branch with; of a resting one times the side of its line
  columns
};

}  // namespace

/// The hinges that flow, and what their rotations follow from: θ_A = Q⁻¹ (δ_A − b), Q = (K_hh + H)_AA.
struct HingeLaw::Flow {
  std::shared_ptr<const FlowingSet> set;
  VectorXd b;
  VectorXd resting;  ///< θ of those that rest, zero of others

  [[nodiscard]] const std::vector<Index>& at() const { return set->seen.moving; }
};

HingeLaw::HingeLaw(Parameters parameters, Index kept) : of_(std::move(parameters)), sets_(kept) {
  const Index n = size();
  require_size("upper", of_.upper.size(), n);
  require_size("lower", of_.lower.size(), n);
  require_size("stiffness", of_.stiffness.rows(), n);
  require_size("stiffness", of_.stiffness.cols(), n);
  require_size("rows", of_.rows.rows(), n);
  for (Index h = 0; h < n; ++h) {
    require_not_negative(indexed("hardening", h), of_.hardening(h));
    require_finite(indexed("stiffness", h), of_.stiffness(h, h));
    for (const auto& [name, list] : {std::pair{"upper", &of_.upper}, std::pair{"lower", &of_.lower}}) {
      if ((*list)(h) > 0.0) continue;  // may be infinite
      throw InvalidParameter(indexed(name, h), fmt::format("{}", (*list)(h)), "must be > 0");
    }
  }
}

bool HingeLaw::same_as(const CoupledLaw& other) const {
  const auto* hinges = dynamic_cast<const HingeLaw*>(&other);
  return hinges != nullptr && hinges->size() == size() && hinges->of_.stiffness == of_.stiffness &&
         hinges->of_.hardening == of_.hardening && hinges->of_.upper == of_.upper && hinges->of_.lower == of_.lower;
}

/// upper + lower, or twice the one that is finite.
double HingeLaw::width(Index h) const {
  const double sum = of_.upper(h) + of_.lower(h);
  return std::isfinite(sum) ? sum : 2.0 * std::min(of_.upper(h), of_.lower(h));
}

HingeLaw::Flow HingeLaw::flow(const CoupledState& state) const {
  std::vector<Index> at;
  VectorXd resting = state.memory.col(rotation);
  for (Index h = 0; h < size(); ++h) {
    if (state.memory(h, side) == 0.0) continue;
    at.push_back(h);
    resting(h) = 0.0;
  }
  VectorXd b(std::ssize(at));
  for (std::size_t n = 0; n < at.size(); ++n) {
    const double s = state.memory(at[n], side);
    b(static_cast<Index>(n)) = s * line(at[n], s) + of_.stiffness.col(at[n]).dot(resting);
  }
  return {sets_.of(of_, at), std::move(b), std::move(resting)};
}

VectorXd HingeLaw::rotations(const CoupledState& state, const VectorXd& deformation) const {
  VectorXd theta = state.memory.col(rotation);
  const Flow now = flow(state);
  theta(now.at()) = now.set->inverse * (deformation(now.at()) - now.b);
  return theta;
}

CoupledState HingeLaw::begin(const VectorXd& deformation) const {
  const Index n = size();
  CoupledState state{0.0, MatrixXd::Zero(n, columns)};
  state.memory.col(first_yield).setConstant(nothing);
  state.memory.col(mechanism_at).setConstant(nothing);
  // Both lines of every hinge that has them: θ = S λ with S = (1, −1).
  std::vector<std::pair<Index, double>> lines;
  bool beyond = false;
  for (Index h = 0; h < n; ++h) {
    for (const double s : {1.0, -1.0}) {
      if (!std::isfinite(line(h, s))) continue;
      lines.emplace_back(h, s);
      beyond = beyond || s * deformation(h) > line(h, s);
    }
  }
  if (!beyond) return state;
  const Index count = std::ssize(lines);
  MatrixXd a(count, count);
  VectorXd b(count);
  for (Index i = 0; i < count; ++i) {
    const auto [h, s] = lines[i];
    b(i) = s * deformation(h) - line(h, s);
    for (Index j = 0; j < count; ++j) {
      const auto [other, t] = lines[j];
      a(i, j) = s * t * (of_.stiffness(h, other) + (h == other ? of_.hardening(h) : 0.0));
    }
  }
  const auto found = complementary(a, b);
  if (!found) return state;
  for (Index i = 0; i < count; ++i) {
    const auto [h, s] = lines[i];
    if (!((*found)(i) > 0.0)) continue;
    state.memory(h, rotation) = s * (*found)(i);
    state.memory(h, peak) = (*found)(i);
    state.memory(h, lost) = line(h, s) * (*found)(i);
    state.memory(h, first_yield) = 0.0;
    state.memory(h, half_cycles) = 1.0;
    state.memory(h, last_side) = s;
  }
  return state;
}

CoupledBranch HingeLaw::branch(const CoupledState& state) const {
  const Index n = size();
  const Flow now = flow(state);
  const CoupledSet& seen = now.set->seen;
  CoupledBranch branch{{now.set, &seen}, -state.memory.col(rotation), {}};
  branch.base(now.at()) = now.set->inverse * now.b;
  // y of those at rest beyond their rows, and what it is a sum of.
  VectorXd constant = VectorXd::Zero(n), sizes = VectorXd::Zero(n);
  const auto take = [&](const auto& column, double factor) {
    for (Index h = 0; h < n && factor != 0.0; ++h) {
      const double term = column(h) * factor;
      constant(h) -= term;
      sizes(h) += std::abs(term);
    }
  };
  for (Index j = 0; j < now.b.size(); ++j) take(seen.over.col(j), now.b(j));
  for (Index j = 0; j < n; ++j) take(of_.stiffness.col(j), now.resting(j));
  take(of_.hardening.cwiseProduct(state.memory.col(rotation)), 1.0);
  branch.guards.reserve(2 * n);
  for (Index h = 0; h < n; ++h) {
    const double s = state.memory(h, side);
    const int zeros = static_cast<int>(state.memory(h, begins));
    if (s != 0.0) {
      branch.guards.push_back({.of = h, .sense = s, .speed = h, .zeros = zeros});
      continue;
    }
    for (const double to : {1.0, -1.0}) {
      if (now.set->still[h] != 0 || !std::isfinite(line(h, to))) continue;
      branch.guards.push_back({.of = h,
                               .constant = line(h, to) - to * constant(h),
                               .size = line(h, to) + sizes(h),
                               .sense = -to,
                               .deformation = h,
                               .zeros = std::max(0, static_cast<int>(to) * zeros)});
    }
  }
  return branch;
}

CoupledState HingeLaw::at(const CoupledState& state, const VectorXd& deformation) const {
  CoupledState now = state;
  const VectorXd theta = rotations(state, deformation);
  for (Index h = 0; h < size(); ++h) {
    const double s = state.memory(h, side);
    if (s == 0.0) continue;
    const double turned = s * (theta(h) - state.memory(h, rotation));
    auto memory = now.memory.row(h);
    memory(rotation) = theta(h);
    memory(lost) += line(h, s) * turned;
    if (!(turned > no_flow * width(h) / of_.stiffness(h, h))) continue;
    memory(peak) = std::max(memory(peak), std::abs(theta(h)));
    if (std::isnan(memory(first_yield))) memory(first_yield) = memory(flow_began);
    if (memory(last_side) != s) memory(half_cycles) += 1.0;
    memory(last_side) = s;
  }
  return now;
}

CoupledState HingeLaw::next(const CoupledState& state, const CoupledBranch& branch, std::size_t guard, double time,
                            const CoupledMotion& motion) const {
  return settle(state, time, motion, &branch.guards[guard]);
}

CoupledState HingeLaw::settle(const CoupledState& state, double time, const CoupledMotion& motion) const {
  return settle(state, time, motion, nullptr);
}

/// `ended`: the guard that has come down to zero, so that a hinge is on its line, or flows no more, however well that
/// instant is known.
CoupledState HingeLaw::settle(const CoupledState& state, double time, const CoupledMotion& motion,
                              const CoupledGuard* ended) const {
  CoupledState now = at(state, motion.deformation);
  now.since = time;
  const VectorXd theta = now.memory.col(rotation);
  const VectorXd y = motion.deformation - of_.stiffness * theta - of_.hardening.cwiseProduct(theta);
  std::vector<Index> candidates, expected;
  std::vector<double> sides;
  for (Index h = 0; h < size(); ++h) {
    double s = now.memory(h, side);
    for (const double to : {1.0, -1.0}) {
      const bool met = ended != nullptr && ended->deformation >= 0 && ended->of == h && to * ended->sense < 0.0;
      if (s == 0.0 && std::isfinite(line(h, to)) && (met || std::abs(y(h) - to * line(h, to)) <= on_line * width(h)))
        s = to;
    }
    if (s == 0.0) continue;
    const bool flowed = state.memory(h, side) != 0.0, changes = ended != nullptr && ended->of == h;
    if (flowed != changes) expected.push_back(std::ssize(candidates));
    candidates.push_back(h);
    sides.push_back(s);
  }
  const Index count = std::ssize(candidates);
  MatrixXd both(count, count);
  VectorXd rate(count);
  for (Index i = 0; i < count; ++i) {
    const Index h = candidates[i];
    rate(i) = sides[i] * (motion.speed(h) + motion.soon * motion.acceleration(h));
    for (Index j = 0; j < count; ++j) both(i, j) = sides[i] * sides[j] * of_.stiffness(h, candidates[j]);
    both(i, i) += of_.hardening(h);
  }
  const VectorXd lambda = complementary(both, rate, std::move(expected)).value_or(VectorXd::Zero(count));
  now.memory.col(side).setZero();
  now.memory.col(begins).setZero();
  for (std::size_t n = 0; n < candidates.size(); ++n) {
    if (lambda(static_cast<Index>(n)) > 0.0) now.memory(candidates[n], side) = sides[n];
  }
  // What flows at a rate that is zero whatever x does would never cease to end its branch.
  Flow flows = flow(now);
  for (bool again = true; again;) {
    again = false;
    for (const Index h : flows.at()) {
      if (flows.set->still[h] == 0) continue;
      now.memory(h, side) = 0.0;
      again = true;
    }
    if (again) flows = flow(now);
  }
  note_mechanism(now, *flows.set, time);
  const VectorXd turning = flows.set->inverse * motion.speed(flows.at());
  const double fastest = turning.size() > 0 ? turning.cwiseAbs().maxCoeff() : 0.0;
  for (std::size_t n = 0, k = 0; n < candidates.size(); ++n) {
    const Index h = candidates[n];
    auto memory = now.memory.row(h);
    if (memory(side) != 0.0) {
      if (state.memory(h, side) != memory(side)) memory(flow_began) = time;
      memory(begins) = memory(side) * turning(static_cast<Index>(k++)) > no_slope * fastest ? 0.0 : 1.0;
      continue;
    }
    const VectorXd of_others = of_.stiffness(h, flows.at()).transpose().cwiseProduct(turning);
    const double falls = sides[n] * (of_others.sum() - motion.speed(h));
    const double size = of_others.cwiseAbs().sum() + std::abs(motion.speed(h));
    memory(begins) = sides[n] * (falls > no_slope * size ? 1.0 : 2.0);
  }
  return now;
}

double HingeLaw::stored_energy(const CoupledState& state, const VectorXd& deformation) const {
  const VectorXd theta = rotations(state, deformation);
  return -deformation.dot(theta) + 0.5 * theta.dot(of_.stiffness * theta + of_.hardening.cwiseProduct(theta));
}

double HingeLaw::lost_energy(const CoupledState& state, const VectorXd& deformation) const {
  return at(state, deformation).memory.col(lost).sum();
}

/// That the frame can move without bending, the first time that it can.
void HingeLaw::note_mechanism(CoupledState& state, const FlowingSet& set, double time) const {
  if (!set.movable || !std::isnan(state.memory(0, mechanism_at))) return;
  state.memory(0, mechanism_at) = time;
  for (const Index h : set.seen.moving) state.memory(h, moved) = 1.0;
}

std::optional<HingeLaw::Mechanism> HingeLaw::mechanism(const CoupledState& state) const {
  if (std::isnan(state.memory(0, mechanism_at))) return std::nullopt;
  Mechanism mechanism{.time = state.memory(0, mechanism_at), .hinges = {}};
  for (Index h = 0; h < size(); ++h) {
    if (state.memory(h, moved) != 0.0) mechanism.hinges.push_back(h);
  }
  return mechanism;
}

HingeLaw::Record HingeLaw::record(const CoupledState& state, Index hinge) const {
  const auto memory = state.memory.row(hinge);
  Record record{.rotation = memory(rotation),
                .peak_rotation = memory(peak),
                .lost = memory(lost),
                .first_yield = std::nullopt,
                .half_cycles = static_cast<int>(memory(half_cycles)),
                .flows = static_cast<int>(memory(side))};
  if (!std::isnan(memory(first_yield))) record.first_yield = memory(first_yield);
  return record;
}

}  // namespace bentur
