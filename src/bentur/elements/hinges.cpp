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
  broke_at,      // [s]; NaN: it has not
  released,      // energy lost then [force·length]
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
  if (of_.kept.size() > 0) require_size("kept", of_.kept.size(), n);
  for (Index h = 0; h < of_.kept.size(); ++h) {
    const double part = of_.kept(h);
    if (!(part >= 0 && part <= 1)) throw InvalidParameter(indexed("kept", h), fmt::format("{}", part), "must be 0 … 1");
  }
  for (Index h = 0; h < n; ++h) {
    require_not_negative(indexed("hardening", h), of_.hardening(h));
    require_finite(indexed("stiffness", h), of_.stiffness(h, h));
    for (const auto& [name, list] : {std::pair{"upper", &of_.upper}, std::pair{"lower", &of_.lower}}) {
      if ((*list)(h) > 0.0) continue;  // may be infinite
      throw InvalidParameter(indexed(name, h), fmt::format("{}", (*list)(h)), "must be > 0");
    }
  }
  hardened_ = of_.stiffness;
  hardened_.diagonal() += of_.hardening;
}

bool HingeLaw::same_as(const CoupledLaw& other) const {
  const auto* hinges = dynamic_cast<const HingeLaw*>(&other);
  return hinges != nullptr && hinges->size() == size() && hinges->of_.stiffness == of_.stiffness &&
         hinges->of_.hardening == of_.hardening && hinges->of_.upper == of_.upper && hinges->of_.lower == of_.lower &&
         hinges->of_.kept.size() == of_.kept.size() && hinges->of_.kept == of_.kept;
}

bool HingeLaw::whole(const CoupledState& state, Index h) const { return std::isnan(state.memory(h, broke_at)); }

bool HingeLaw::is_free(const CoupledState& state, Index h) const {
  return breaks(h) && of_.kept(h) == 0.0 && !whole(state, h);
}

/// How far s (M − Hθ) may rise on side s. (H-14)
double HingeLaw::line(const CoupledState& state, Index h, double s) const {
  const double given = s > 0 ? of_.upper(h) : of_.lower(h);
  if (!breaks(h) || whole(state, h)) return given;
  return 0.5 * (of_.kept(h) * (of_.upper(h) + of_.lower(h)) + s * (of_.upper(h) - of_.lower(h)));
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
    b(static_cast<Index>(n)) = s * line(state, at[n], s) + of_.stiffness.col(at[n]).dot(resting);
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
  for (const Column time : {first_yield, mechanism_at, broke_at}) state.memory.col(time).setConstant(nothing);
  const bool beyond =
      (deformation.array() > of_.upper.array()).any() || (-deformation.array() > of_.lower.array()).any();
  if (beyond) load(state, deformation, 0.0, {});
  for (Index h = 0; h < n; ++h) state.memory(h, side) = is_free(state, h) ? 1.0 : 0.0;
  return state;
}

namespace {

/// Sides of hinges, those that move either way last.
struct Sides {
  std::vector<Index> of;
  std::vector<double> side;
  Index free = 0;

  /// λ ≥ 0 with w = S a S λ − b ≥ 0 complementary, w = 0 of those that move either way. (H-7), (H-8)
  /// `mixed`: rotations and slips, so that each is measured by its own stiffness.
  [[nodiscard]] std::optional<VectorXd> solve(const MatrixXd& a, const VectorXd& b, bool mixed,
                                              std::vector<Index> guess = {}) const {
    const auto s = Eigen::Map<const VectorXd>(side.data(), std::ssize(side));
    if (!mixed) return complementary(s.asDiagonal() * a(of, of) * s.asDiagonal(), b, std::move(guess));
    const VectorXd sizes = a.diagonal()(of).cwiseMax(0.0);
    const VectorXd unit = (sizes.array() > 0.0).select(sizes.cwiseSqrt().cwiseInverse(), 1.0);
    const VectorXd scale = s.cwiseProduct(unit);
    auto found = complementary(scale.asDiagonal() * a(of, of) * scale.asDiagonal(), unit.cwiseProduct(b), free);
    if (found) *found = found->cwiseProduct(unit);
    return found;
  }
};

}  // namespace

/// From the θ of a state to one with which nothing is beyond its line at δ, in one go: θ + S λ, S both sides of every
/// hinge that has them. What would flow and can break breaks, and it is done anew. `broken`: what just has. (H-8),
/// (H-15)
void HingeLaw::load(CoupledState& state, const VectorXd& deformation, double time, std::vector<Index> broken) const {
  const VectorXd before = state.memory.col(rotation), y = borne(state, deformation);
  Sides lines;
  VectorXd lambda;
  for (bool again = true; again;) {
    again = false;
    lines = {};
    for (const bool of_free : {false, true}) {
      for (Index h = 0; h < size(); ++h) {
        if (is_free(state, h) != of_free) continue;
        for (const double s : {1.0, -1.0}) {
          if (!std::isfinite(line(state, h, s)) || (of_free && s < 0)) continue;
          lines.of.push_back(h);
          lines.side.push_back(s);
          lines.free += of_free ? 1 : 0;
        }
      }
    }
    VectorXd b(std::ssize(lines.of));
    for (Index i = 0; i < b.size(); ++i) {
      b(i) = lines.side[i] * y(lines.of[i]) - line(state, lines.of[i], lines.side[i]);
    }
    const auto found = lines.solve(hardened_, b, of_.kept.size() > 0);
    if (!found) return;
    lambda = *found;
    for (Index i = 0; i < lambda.size(); ++i) {
      const Index h = lines.of[i];
      if (!(lambda(i) > 0.0) || !breaks(h) || !whole(state, h)) continue;
      state.memory(h, broke_at) = time;
      broken.push_back(h);
      again = true;
    }
  }
  const auto energy = [&](const VectorXd& theta) { return theta.dot(0.5 * (hardened_ * theta) - deformation); };
  double left = energy(before);
  for (Index i = 0; i < lambda.size(); ++i) {
    const Index h = lines.of[i];
    if (lambda(i) == 0.0) continue;
    const double s = lines.side[i];
    auto memory = state.memory.row(h);
    memory(rotation) += s * lambda(i);
    if (std::find(broken.begin(), broken.end(), h) != broken.end()) continue;
    const double lost_here = line(state, h, s) * lambda(i);
    memory(lost) += lost_here;
    left -= lost_here;
    if (breaks(h)) continue;
    memory(peak) = std::max(memory(peak), std::abs(memory(rotation)));
    if (std::isnan(memory(first_yield))) memory(first_yield) = time;
    if (memory(last_side) != s) memory(half_cycles) += 1.0;
    memory(last_side) = s;
  }
  // What remains is what those that broke have lost, each by the mean of its forces before and after.
  const VectorXd theta = state.memory.col(rotation), after = borne(state, deformation);
  left -= energy(theta);
  const auto share = [&](Index h) { return 0.5 * (y(h) + after(h)) * (theta(h) - before(h)); };
  double all = 0.0;
  for (const Index h : broken) all += share(h);
  for (const Index h : broken) {
    const double lost_here = all > 0.0 ? left * share(h) / all : 0.0;
    state.memory(h, lost) += lost_here;
    state.memory(h, released) = lost_here - 0.5 * (of_.upper(h) - of_.lower(h)) * (theta(h) - before(h));
  }
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
    if (is_free(state, h)) continue;
    if (s != 0.0) {
      branch.guards.push_back({.of = h, .sense = s, .speed = h, .zeros = zeros});
      continue;
    }
    for (const double to : {1.0, -1.0}) {
      if (now.set->still[h] != 0 || !std::isfinite(line(state, h, to))) continue;
      branch.guards.push_back({.of = h,
                               .constant = line(state, h, to) - to * constant(h),
                               .size = std::abs(line(state, h, to)) + sizes(h),
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
    memory(lost) += line(state, h, s) * turned;
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

namespace {

/// Whether a guard that has come down to zero says that a hinge is on its line of side `to`.
bool is_met(const CoupledGuard* ended, Index h, double to) {
  return ended != nullptr && ended->deformation >= 0 && ended->of == h && to * ended->sense < 0.0;
}

}  // namespace

/// M − H θ at the last event.
VectorXd HingeLaw::borne(const CoupledState& state, const VectorXd& deformation) const {
  const VectorXd theta = state.memory.col(rotation);
  return deformation - of_.stiffness * theta - of_.hardening.cwiseProduct(theta);
}

/// What can break and is on its line does; a hinge that then is off its own no longer flows. (H-14)
void HingeLaw::break_at_lines(CoupledState& state, double time, const VectorXd& deformation,
                              const CoupledGuard* ended) const {
  if (of_.kept.size() == 0) return;
  VectorXd y = borne(state, deformation);
  std::vector<Index> broken;
  for (Index h = 0; h < size(); ++h) {
    if (!breaks(h) || !whole(state, h)) continue;
    for (const double to : {1.0, -1.0}) {
      if (!is_met(ended, h, to) && to * y(h) < line(state, h, to) - on_line * width(h)) continue;
      state.memory(h, broke_at) = time;
      broken.push_back(h);
      break;
    }
  }
  if (broken.empty()) return;
  load(state, deformation, time, broken);
  y = borne(state, deformation);
  for (Index h = 0; h < size(); ++h) {
    const double s = state.memory(h, side);
    if (s != 0.0 && std::abs(y(h) - s * line(state, h, s)) > on_line * width(h)) state.memory(h, side) = 0.0;
  }
}

/// `ended`: the guard that has come down to zero, so that a hinge is on its line, or flows no more, however well that
/// instant is known.
CoupledState HingeLaw::settle(const CoupledState& state, double time, const CoupledMotion& motion,
                              const CoupledGuard* ended) const {
  CoupledState now = at(state, motion.deformation);
  now.since = time;
  break_at_lines(now, time, motion.deformation, ended);
  const VectorXd y = borne(now, motion.deformation);
  Sides candidates;
  std::vector<Index> expected;  // to flow: those that did, and what has met its line, but not what has ceased to
  for (const bool of_free : {false, true}) {
    for (Index h = 0; h < size(); ++h) {
      if (is_free(now, h) != of_free) continue;
      double s = of_free ? 1.0 : now.memory(h, side);
      for (const double to : {1.0, -1.0}) {
        const bool met = is_met(ended, h, to) && whole(now, h) == whole(state, h);
        const double limit = line(now, h, to);
        if (s == 0.0 && std::isfinite(limit) && (met || std::abs(y(h) - to * limit) <= on_line * width(h))) s = to;
      }
      if (s == 0.0) continue;
      const bool flowed = state.memory(h, side) != 0.0, changes = ended != nullptr && ended->of == h;
      if (flowed != changes && !of_free) expected.push_back(std::ssize(candidates.of));
      candidates.of.push_back(h);
      candidates.side.push_back(s);
      candidates.free += of_free ? 1 : 0;
    }
  }
  const std::vector<double>& sides = candidates.side;
  const auto s = Eigen::Map<const VectorXd>(sides.data(), std::ssize(sides));
  const VectorXd rate = (motion.speed + motion.soon * motion.acceleration)(candidates.of).cwiseProduct(s);
  const VectorXd lambda = candidates.solve(hardened_, rate, of_.kept.size() > 0, std::move(expected))
                              .value_or(VectorXd::Zero(std::ssize(sides)));
  now.memory.col(side).setZero();
  now.memory.col(begins).setZero();
  // Rotations and slips side by side, by what they would do to the energy.
  const bool mixed = of_.kept.size() > 0;
  const VectorXd weights =
      mixed ? VectorXd(of_.stiffness.diagonal().cwiseMax(0.0).cwiseSqrt()) : VectorXd::Ones(size());
  const double nil = no_slope * weights(candidates.of).dot(lambda.cwiseAbs());
  for (Index n = 0; n < lambda.size(); ++n) {
    const Index h = candidates.of[n];
    // With zeros it turned at next to no rate and ends: the instant is not known well enough to tell that by λ.
    const bool stopped = ended != nullptr && ended->of == h && ended->speed >= 0 && (mixed || ended->zeros > 0);
    const bool flows_on = lambda(n) > 0.0 && !(stopped && lambda(n) * weights(h) <= nil);
    if (flows_on || is_free(now, h)) now.memory(h, side) = sides[n];
  }
  // What flows at a rate that is zero whatever x does would never cease to end its branch.
  Flow flows = flow(now);
  for (bool changed = true; changed;) {
    changed = false;
    for (const Index h : flows.at()) {
      if (is_free(now, h) || flows.set->still[h] == 0) continue;
      now.memory(h, side) = 0.0;
      changed = true;
    }
    if (changed) flows = flow(now);
  }
  note_mechanism(now, *flows.set, time);
  const VectorXd turning = flows.set->inverse * motion.speed(flows.at());
  const VectorXd paces = turning.cwiseProduct(weights(flows.at()));
  const double fastest = paces.size() > 0 ? paces.cwiseAbs().maxCoeff() : 0.0;
  for (std::size_t n = 0; n < sides.size(); ++n) {
    const Index h = candidates.of[n];
    auto memory = now.memory.row(h);
    if (memory(side) != 0.0) {
      const Index k = std::lower_bound(flows.at().begin(), flows.at().end(), h) - flows.at().begin();
      if (state.memory(h, side) != memory(side)) memory(flow_began) = time;
      memory(begins) = memory(side) * paces(k) > no_slope * fastest ? 0.0 : 1.0;
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
                .flows = static_cast<int>(memory(side)),
                .broke = std::nullopt,
                .released = memory(released)};
  if (!std::isnan(memory(broke_at))) record.broke = memory(broke_at);
  if (!std::isnan(memory(first_yield))) record.first_yield = memory(first_yield);
  return record;
}

}  // namespace bentur
