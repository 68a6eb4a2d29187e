#include "bentur/elements/hinges.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "bentur/core/algebra/factors.h"
#include "bentur/core/errors.h"
#include "bentur/core/not_known.h"
#include "bentur/core/require.h"
#include "bentur/elements/hinges/falling.h"
#include "bentur/elements/hinges/rate_problem.h"

namespace bentur {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

constexpr double no_slope = 1e-9;            // of what it is a sum of: a rate that is zero
constexpr std::size_t flowing_at_once = 16;  // for which there is room
constexpr double unbounded = std::numeric_limits<double>::infinity();

/// Some entries of a list; by Eigen the numbers of these would be copied too.
VectorXd entries(const VectorXd& list, const std::vector<Index>& at) {
  VectorXd result(std::ssize(at));
  for (Index n = 0; n < result.size(); ++n) result(n) = list(at[n]);
  return result;
}

}  // namespace

/// The hinges that flow, and what their rotations follow from: θ_A = Q⁻¹ (δ_A − b), Q = (K_hh + H)_AA.
struct HingeLaw::Flow {
  std::shared_ptr<const FlowingSet> set;
  VectorXd b;
  VectorXd held;    ///< K_hh θ of those that rest
  double size = 0;  ///< Σ √K_hh |θ|, each by its own entry: that times √K_hh is what `held` is a sum of, or more
  int changes = 0;  ///< since `held` was summed anew

  [[nodiscard]] const std::vector<Index>& at() const { return set->seen.moving; }
  /// θ of those that flow.
  [[nodiscard]] VectorXd rotations(const VectorXd& deformation) const {
    return set->inverse * (entries(deformation, at()) - b);
  }
};

HingeLaw::HingeLaw(Parameters parameters, Index kept) : of_(std::move(parameters)), keeps_(kept > 0), sets_(kept) {
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
  if (!of_.backbones.empty()) require_size("backbones", of_.backbones.size(), static_cast<std::size_t>(n));
  check_backbones();
  wears_ = std::any_of(of_.backbones.begin(), of_.backbones.end(), [](const HingeBackbone& of) { return of.wears(); });
  weakens_ = of_.kept.size() > 0 || !of_.backbones.empty();
  hardened_ = of_.stiffness;
  hardened_.diagonal() += of_.hardening;
  roots_ = of_.stiffness.diagonal().cwiseMax(0.0).cwiseSqrt();
  widths_ = of_.upper + of_.lower;
  for (Index h = 0; h < n; ++h) {
    if (!std::isfinite(widths_(h))) widths_(h) = 2.0 * std::min(of_.upper(h), of_.lower(h));
  }
  near_upper_ = of_.upper - 2.0 * on_line * widths_;
  near_lower_ = of_.lower - 2.0 * on_line * widths_;
}

bool HingeLaw::same_as(const CoupledLaw& other) const {
  const auto* hinges = dynamic_cast<const HingeLaw*>(&other);
  return hinges != nullptr && hinges->size() == size() && hinges->of_.stiffness == of_.stiffness &&
         hinges->of_.hardening == of_.hardening && hinges->of_.upper == of_.upper && hinges->of_.lower == of_.lower &&
         hinges->of_.kept.size() == of_.kept.size() && hinges->of_.kept == of_.kept &&
         hinges->of_.backbones == of_.backbones;
}

bool HingeLaw::whole(const CoupledState& state, Index h) const { return std::isnan(state.memory(h, broke_at)); }

/// Broken or failed, without strength.
bool HingeLaw::has_nothing_left(const CoupledState& state, Index h) const {
  return (breaks(h) && of_.kept(h) == 0.0 && !whole(state, h)) || stage_of(state, h) == spent;
}

bool HingeLaw::is_free(const CoupledState& state, Index h) const {
  return nothing_left(state, h) && state.memory(h, side) != 0.0;
}

/// Which of those without strength move: of failed hinges, such as all of one joint, only those whose rotations can be
/// told apart.
std::vector<char> HingeLaw::moving_freely(const CoupledState& state) const {
  constexpr double apart = 1e-9;
  std::vector<char> moves(size(), 0);
  if (!weakens_) return moves;
  std::vector<Index> so_far;
  for (const bool of_slips : {true, false}) {
    for (Index h = 0; h < size(); ++h) {
      if (breaks(h) != of_slips || !nothing_left(state, h)) continue;
      if (!of_slips && !so_far.empty()) {
        const VectorXd with = of_.stiffness(so_far, h);
        const double alone = of_.stiffness(h, h) - with.dot(Ldlt(of_.stiffness(so_far, so_far)).solve(with));
        if (!(alone > apart * of_.stiffness(h, h))) continue;
      }
      so_far.push_back(h);
      moves[h] = 1;
    }
  }
  return moves;
}

/// Rotations of those that harden, zero of what has come to its cap.
VectorXd HingeLaw::hardened_rotations(const CoupledState& state, VectorXd rotations) const {
  if (!any_softened(state)) return rotations;
  return (state.memory.col(stage).array() > 0.0).select(0.0, rotations);
}

/// How far s (M − Hθ), beyond the cap s M, may rise on side s. (H-14), (H-18), (H-21)
double HingeLaw::weakened_line(const CoupledState& state, Index h, double s) const {
  if (stage_of(state, h) != virgin) return softened_line(state, h, s);
  const double given = s > 0 ? of_.upper(h) : of_.lower(h);
  const double left = left_by_wear(state, h, s);
  if (left < 1.0) return given - (1.0 - left) * (s > 0 ? backbone(h)->clockwise : backbone(h)->anticlockwise);
  if (!breaks(h) || whole(state, h)) return given;
  return 0.5 * (of_.kept(h) * (of_.upper(h) + of_.lower(h)) + s * (of_.upper(h) - of_.lower(h)));
}

/// `before`: from which no other θ have changed than of what flowed; null: not known.
std::shared_ptr<const HingeLaw::Flow> HingeLaw::flow(const CoupledState& state, const Flow* before) const {
  constexpr int most_changes = 32;  // by what begins and ceases to flow, each of which adds a round-off
  if (state.known) return std::static_pointer_cast<const Flow>(state.known);
  const auto result = std::make_shared<Flow>();
  std::vector<Index> at;
  at.reserve(flowing_at_once);
  const bool goes_on = before != nullptr && before->changes < most_changes;
  if (goes_on) {
    result->held = before->held;
    result->size = before->size;
    result->changes = before->changes + 1;
  } else {
    result->held.setZero(size());
  }
  auto flowed = goes_on ? before->at().begin() : at.end();
  const auto end = goes_on ? before->at().end() : at.end();
  for (Index h = 0; h < size(); ++h) {
    const double theta = state.memory(h, rotation);
    const bool flows = state.memory(h, side) != 0.0, did = flowed != end && *flowed == h;
    if (did) ++flowed;
    if (flows) at.push_back(h);
    const double adds = !flows && (did || !goes_on) ? theta : flows && !did && goes_on ? -theta : 0.0;
    if (adds == 0.0) continue;
    result->held += adds * of_.stiffness.col(h);
    result->size += std::copysign(roots_(h) * std::abs(theta), flows ? -1.0 : 1.0);
  }
  result->b.resize(std::ssize(at));
  std::vector<double> slopes;
  const bool softens = any_softened(state);
  for (std::size_t n = 0; n < at.size(); ++n) {
    const Index h = at[n];
    const double s = state.memory(h, side);
    double& of = result->b(static_cast<Index>(n));
    of = s * line(state, h, s) + result->held(h);
    if (!softens) continue;
    slopes.push_back(slope(state, h, s));
    if (stage_of(state, h) != virgin) of -= slopes.back() * state.memory(h, rotation);
  }
  result->set = sets_.of(of_, at, slopes);
  return result;
}

VectorXd HingeLaw::rotations(const CoupledState& state, const VectorXd& deformation) const {
  VectorXd theta = state.memory.col(rotation);
  const auto now = flow(state);
  theta(now->at()) = now->rotations(deformation);
  return theta;
}

CoupledState HingeLaw::begin(const VectorXd& deformation) const {
  const Index n = size();
  CoupledState state{0.0, MatrixXd::Zero(n, wears_ ? columns : weakens_ ? without_wear : without_weakening)};
  if (wears_) state.memory(Eigen::all, {left_above, left_below, left_before}).setOnes();
  for (const Column time : {first_yield, mechanism_at, broke_at, cap_at, snapped_at, failed_at}) {
    if (time < state.memory.cols()) state.memory.col(time).setConstant(not_known);
  }
  const CoupledState unloaded = state;
  const bool beyond =
      (deformation.array() > of_.upper.array()).any() || (-deformation.array() > of_.lower.array()).any();
  if (beyond) load(state, deformation, 0.0, {});
  if (past_a_cap(state)) {
    state = unloaded;
    redistribute(state, VectorXd::Zero(n), deformation, 0.0, {});
  }
  wear(state, 0.0, deformation);
  const std::vector<char> free = moving_freely(state);
  for (Index h = 0; h < n; ++h) state.memory(h, side) = free[h] != 0 ? 1.0 : 0.0;
  return state;
}

/// borne() of a state in which no other hinges have turned than those that flowed.
VectorXd HingeLaw::borne_after(const Flow& flowed, const CoupledState& state, const VectorXd& deformation) const {
  const auto theta = state.memory.col(rotation);
  VectorXd y = deformation - flowed.held - of_.hardening.cwiseProduct(theta);
  for (const Index h : flowed.at()) y -= theta(h) * of_.stiffness.col(h);
  return y;
}

CoupledBranch HingeLaw::branch(const CoupledState& state) const {
  const Index n = size();
  const auto now = flow(state);
  const CoupledSet& seen = now->set->seen;
  CoupledBranch branch{{now->set, &seen}, -state.memory.col(rotation), {}};
  const VectorXd without = now->set->inverse * now->b;
  for (Index j = 0; j < without.size(); ++j) branch.base(now->at()[j]) = without(j);
  branch.guards.reserve(2 * now->at().size() + 2);
  // How far rows of those at rest are past y, and what that is a sum of.
  VectorXd past = now->held, sizes = now->size * roots_;
  for (Index j = 0; j < now->b.size(); ++j) {
    past += now->b(j) * seen.over.col(j);
    sizes += std::abs(now->b(j)) * seen.over.col(j).cwiseAbs();
  }
  const VectorXd hardened = of_.hardening.cwiseProduct(hardened_rotations(state, state.memory.col(rotation)));
  past += hardened;
  sizes += hardened.cwiseAbs();
  CoupledBounds& bounds = branch.bounds;
  const auto limit = [&](const VectorXd& upper, const VectorXd& lower) {
    bounds = {past - lower, past + upper, lower + sizes, upper + sizes};
  };
  if (weakens_) {
    VectorXd upper(n), lower(n);
    for (Index h = 0; h < n; ++h) upper(h) = line(state, h, 1.0), lower(h) = line(state, h, -1.0);
    limit(upper, lower);
  } else {
    limit(of_.upper, of_.lower);
  }
  const auto no_bound = [&](Index h, bool high) {
    (high ? bounds.most : bounds.least)(h) = high ? unbounded : -unbounded;
  };
  for (Index h = 0; h < n; ++h) {
    const double s = state.memory(h, side);
    const int zeros = static_cast<int>(state.memory(h, begins));
    const bool rests = s == 0.0 && now->set->still[h] == 0 && !nothing_left(state, h);
    if (rests && zeros == 0) continue;
    if (rests) {
      const bool high = zeros > 0;
      const std::size_t bound = branch.guards.size() + 2 * static_cast<std::size_t>(h) + (high ? 0 : 1);
      if (branch.bound(h, high) < 0) continue;
      CoupledGuard guard = branch.guard(bound);
      guard.zeros = std::abs(zeros);
      branch.guards.push_back(guard);
      no_bound(h, high);
      continue;
    }
    for (const bool high : {true, false}) no_bound(h, high);
    if (s == 0.0 || nothing_left(state, h)) continue;
    branch.guards.push_back({.of = h, .sense = s, .speed = h, .zeros = zeros});
    const double end = stage_end(state, h, s);
    if (!std::isfinite(end)) continue;
    const double beyond = -branch.base(h);  // θ is the row and this
    branch.guards.push_back(
        {.of = h, .constant = end - s * beyond, .size = end + std::abs(beyond), .sense = -s, .deformation = h});
  }
  return branch;
}

CoupledState HingeLaw::at(const CoupledState& state, const VectorXd& deformation) const {
  CoupledState now{state.since, state.memory};
  const auto flowing = flow(state);
  const VectorXd theta = flowing->rotations(deformation);
  for (Index n = 0; n < theta.size(); ++n) {
    const Index h = flowing->at()[static_cast<std::size_t>(n)];
    const double s = state.memory(h, side);
    const double turned = s * (theta(n) - state.memory(h, rotation));
    auto memory = now.memory.row(h);
    memory(rotation) = theta(n);
    memory(lost) += line(state, h, s) * turned;
    if (stage_of(state, h) == softened) {
      memory(lost) += 0.5 * slope(state, h, s) * turned * turned;
      sync(now, h, s);
    }
    note_flow(now, h, s, turned, memory(flow_began));
  }
  return now;
}

CoupledState HingeLaw::next(const CoupledState& state, const CoupledBranch& branch, std::size_t guard, double time,
                            const CoupledMotion& motion) const {
  const CoupledGuard ended = branch.guard(guard);
  return settle(state, time, motion, &ended);
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
  bool softens_anew = end_stages(now, time, motion.deformation);
  break_at_lines(now, time, motion.deformation, softens_anew ? nullptr : ended);
  HingeSides candidates;
  VectorXd lambda;
  for (bool again = true; again;) {
    std::vector<Index> expected;  // to flow: those that did, and what has met its line, but not what has ceased to
    candidates = {};
    candidates.of.reserve(flowing_at_once);
    candidates.side.reserve(flowing_at_once);
    expected.reserve(flowing_at_once);
    const VectorXd y = weakens_ ? borne(now, motion.deformation) : borne_after(*flow(state), now, motion.deformation);
    const std::vector<char> free = weakens_ ? moving_freely(now) : std::vector<char>{};
    for (const bool of_free : {false, true}) {
      if (of_free && !weakens_) break;
      for (Index h = 0; h < size(); ++h) {
        const bool may_weaken_or_end = weakens_ || (ended != nullptr && ended->of == h);
        if (!may_weaken_or_end && now.memory(h, side) == 0.0 && y(h) < near_upper_(h) && -y(h) < near_lower_(h)) {
          continue;  // as most do
        }
        if (nothing_left(now, h) != of_free || (of_free && free[h] == 0)) continue;
        double s = of_free ? 1.0 : now.memory(h, side);
        for (const double to : {1.0, -1.0}) {
          const bool met = !softens_anew && guard_says_met(ended, h, to) && whole(now, h) == whole(state, h);
          const double limit = line(now, h, to);
          if (s == 0.0 && std::isfinite(limit) && (met || std::abs(y(h) - to * limit) <= on_line * width(h))) s = to;
        }
        if (s == 0.0) continue;
        const bool flowed = state.memory(h, side) != 0.0, changes = ended != nullptr && ended->of == h;
        if (flowed != changes && !of_free) expected.push_back(std::ssize(candidates.of));
        candidates.add(h, s, of_free);
      }
    }
    VectorXd rate(std::ssize(candidates.of));
    for (Index i = 0; i < rate.size(); ++i) {
      const Index h = candidates.of[i];
      rate(i) = (motion.speed(h) + motion.soon * motion.acceleration(h)) * candidates.side[i];
    }
    const std::vector<Index> snapping = paces(now, candidates, rate, std::move(expected), lambda);
    again = !snapping.empty();
    if (again) snap(now, motion.deformation, time, snapping);
    softens_anew = softens_anew || again;
  }
  const std::vector<double>& sides = candidates.side;
  now.memory.col(side).setZero();
  now.memory.col(begins).setZero();
  // Rotations and slips side by side, by what they would do to the energy.
  const bool mixed = of_.kept.size() > 0;
  const auto weight = [&](Index h) { return mixed ? roots_(h) : 1.0; };
  double sum = 0.0;
  for (Index n = 0; n < lambda.size(); ++n) sum += weight(candidates.of[n]) * std::abs(lambda(n));
  const double nil = no_slope * sum;
  for (Index n = 0; n < lambda.size(); ++n) {
    const Index h = candidates.of[n];
    // With zeros it turned at next to no rate and ends: the instant is not known well enough to tell that by λ.
    const bool stopped = ended != nullptr && ended->of == h && ended->speed >= 0 && (mixed || ended->zeros > 0);
    const bool flows_on = lambda(n) > 0.0 && !(stopped && lambda(n) * weight(h) <= nil);
    if (flows_on || nothing_left(now, h)) now.memory(h, side) = sides[n];
  }
  // What flows at a rate that is zero whatever x does would never cease to end its branch.
  const auto turns_at_rest = [&] {
    for (Index h = 0; h < size(); ++h) {
      if (state.memory(h, side) == 0.0 && state.memory(h, rotation) != now.memory(h, rotation)) return true;
    }
    return false;
  };
  const auto* before = static_cast<const Flow*>(state.known.get());
  auto flows = flow(now, before != nullptr && !turns_at_rest() ? before : nullptr);
  for (bool changed = true; changed;) {
    changed = false;
    for (const Index h : flows->at()) {
      if (nothing_left(now, h) || flows->set->still[h] == 0) continue;
      now.memory(h, side) = 0.0;
      changed = true;
    }
    if (changed) flows = flow(now);
  }
  note_mechanism(now, *flows->set, time);
  const VectorXd turning = flows->set->inverse * entries(motion.speed, flows->at());
  const auto weighed = [&](Index k) { return turning(k) * weight(flows->at()[k]); };
  double fastest = 0.0;
  for (Index k = 0; k < turning.size(); ++k) fastest = std::max(fastest, std::abs(weighed(k)));
  for (std::size_t n = 0; n < sides.size(); ++n) {
    const Index h = candidates.of[n];
    auto memory = now.memory.row(h);
    if (memory(side) != 0.0) {
      const Index k = std::lower_bound(flows->at().begin(), flows->at().end(), h) - flows->at().begin();
      if (state.memory(h, side) != memory(side)) memory(flow_began) = time;
      set_out(now, h, memory(side));
      memory(begins) = memory(side) * weighed(k) > no_slope * fastest ? 0.0 : 1.0;
      continue;
    }
    double of_others = 0.0, size = std::abs(motion.speed(h));
    for (Index k = 0; k < turning.size(); ++k) {
      const double held = of_.stiffness(flows->at()[k], h) * turning(k);
      of_others += held;
      size += std::abs(held);
    }
    const double falls = sides[n] * (of_others - motion.speed(h));
    memory(begins) = sides[n] * (falls > no_slope * size ? 1.0 : 2.0);
  }
  if (wear(now, time, motion.deformation)) return settle(now, time, motion, nullptr);
  now.known = flows;
  return now;
}

double HingeLaw::stored_energy(const CoupledState& state, const VectorXd& deformation) const {
  const VectorXd theta = rotations(state, deformation);
  const VectorXd hardened = of_.hardening.cwiseProduct(hardened_rotations(state, theta));
  return -deformation.dot(theta) + 0.5 * theta.dot(of_.stiffness * theta + hardened);
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
                .released = memory(released),
                .strength_left = share_left(state, hinge) *
                                 std::min(left_by_wear(state, hinge, 1.0), left_by_wear(state, hinge, -1.0)),
                .cap = std::nullopt,
                .failed = std::nullopt,
                .snapped = std::nullopt};
  if (!std::isnan(memory(broke_at))) record.broke = memory(broke_at);
  if (!std::isnan(memory(first_yield))) record.first_yield = memory(first_yield);
  if (!weakens_) return record;
  if (!std::isnan(memory(cap_at))) record.cap = memory(cap_at);
  if (!std::isnan(memory(failed_at))) record.failed = memory(failed_at);
  if (!std::isnan(memory(snapped_at))) record.snapped = memory(snapped_at);
  return record;
}

}  // namespace bentur
