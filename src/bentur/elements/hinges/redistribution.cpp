// What the hinges of HingeLaw do in one go, with their deformations held: (H-8), (H-15), (H-20).
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "bentur/elements/hinges/falling.h"
#include "bentur/elements/hinges/rate_problem.h"

namespace bentur {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// That it has flowed along side s by `turned` > 0 since `began`.
void HingeLaw::note_flow(CoupledState& state, Index h, double s, double turned, double began) const {
  auto memory = state.memory.row(h);
  memory(peak) = std::max(memory(peak), std::abs(memory(rotation)));
  if (!(turned > no_flow * width(h) / of_.stiffness(h, h))) return;
  if (nothing_left(state, h)) return;  // it moves, but yields no more
  if (std::isnan(memory(first_yield))) memory(first_yield) = began;
  if (memory(last_side) != s) memory(half_cycles) += 1.0;
  memory(last_side) = s;
}

/// From the θ of a state to one with which nothing is beyond its line at δ, in one go: θ + S λ, S both sides of every
/// hinge that has them. What would flow and can break breaks, and it is done anew. `broken`: what just has. (H-8),
/// (H-15)
void HingeLaw::load(CoupledState& state, const VectorXd& deformation, double time, std::vector<Index> broken) const {
  const VectorXd before = state.memory.col(rotation), y = borne(state, deformation);
  HingeSides lines;
  VectorXd lambda;
  for (bool again = true; again;) {
    again = false;
    lines = {};
    for (const bool of_free : {false, true}) {
      for (Index h = 0; h < size(); ++h) {
        if (nothing_left(state, h) != of_free) continue;
        for (const double s : {1.0, -1.0}) {
          if (!std::isfinite(line(state, h, s)) || (of_free && s < 0)) continue;
          lines.add(h, s, of_free);
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
    set_out(state, h, s);
    memory(rotation) += s * lambda(i);
    if (std::find(broken.begin(), broken.end(), h) != broken.end()) continue;
    const double lost_here = line(state, h, s) * lambda(i);
    memory(lost) += lost_here;
    left -= lost_here;
    if (breaks(h)) continue;
    note_flow(state, h, s, lambda(i), time);
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

/// M − H θ at the last event, M of one that has come to its cap.
VectorXd HingeLaw::borne(const CoupledState& state, const VectorXd& deformation) const {
  const VectorXd theta = state.memory.col(rotation);
  VectorXd y = deformation - of_.stiffness * theta - of_.hardening.cwiseProduct(theta);
  for (Index h = 0; h < size() && any_softened(state); ++h) {
    if (stage_of(state, h) != virgin) y(h) += of_.hardening(h) * theta(h);
  }
  return y;
}

/// What can break and is on its line does; a hinge that then is off its own no longer flows. (H-14)
bool HingeLaw::break_at_lines(CoupledState& state, double time, const VectorXd& deformation,
                              const CoupledGuard* ended) const {
  if (of_.kept.size() == 0) return false;
  const VectorXd y = borne(state, deformation);
  std::vector<Index> broken;
  for (Index h = 0; h < size(); ++h) {
    if (!breaks(h) || !whole(state, h)) continue;
    for (const double to : {1.0, -1.0}) {
      if (!guard_says_met(ended, h, to) && to * y(h) < line(state, h, to) - on_line * width(h)) continue;
      state.memory(h, broke_at) = time;
      broken.push_back(h);
      break;
    }
  }
  if (broken.empty()) return false;
  const CoupledState before = state;
  if (!any_softened(state)) load(state, deformation, time, broken);
  if (any_softened(state) || past_a_cap(state)) {
    state = before;
    std::vector<Fall> falls;
    for (const Index h : broken) falls.push_back(fall_of(state, h, false, y(h)));
    for (Fall& fall : falls) fall.line[0] = of_.upper(fall.hinge), fall.line[1] = of_.lower(fall.hinge);
    redistribute(state, deformation, deformation, time, std::move(falls));
  }
  rest_off_lines(state, deformation);
  return true;
}

/// A hinge that flowed and is off its line no longer does.
void HingeLaw::rest_off_lines(CoupledState& state, const VectorXd& deformation) const {
  const VectorXd y = borne(state, deformation);
  for (Index h = 0; h < size(); ++h) {
    const double s = state.memory(h, side);
    if (s != 0.0 && std::abs(y(h) - s * line(state, h, s)) > on_line * width(h)) state.memory(h, side) = 0.0;
  }
}

/// From the lines of now to those of what it keeps for good, or of nothing. `borne`: y of now.
HingeLaw::Fall HingeLaw::fall_of(const CoupledState& state, Index h, bool fails, double borne) const {
  Fall fall{.hinge = h, .fails = fails};
  for (const double s : {1.0, -1.0}) {
    const int n = Fall::number(s);
    double& now = fall.line[n];
    now = line(state, h, s);
    if (breaks(h)) {
      fall.end[n] = 0.5 * (of_.kept(h) * (of_.upper(h) + of_.lower(h)) + s * (of_.upper(h) - of_.lower(h)));
      continue;
    }
    const double at_rest = s * backbone(h)->at_rest;
    fall.end[n] = fails ? -at_rest : level(state, h) * strength_at_cap(state, h, s) - at_rest;
    if (!std::isfinite(now) && std::isfinite(fall.end[n])) now = std::max(s * borne, fall.end[n]);
  }
  return fall;
}

/// Hinges whose lines have come down at once, those of `hinges` to what they keep for good, and all that follows.
/// (H-20)
void HingeLaw::snap(CoupledState& state, const VectorXd& deformation, double time,
                    const std::vector<Index>& hinges) const {
  const VectorXd y = borne(state, deformation);
  std::vector<Fall> falls;
  for (const Index h : hinges) falls.push_back(fall_of(state, h, false, y(h)));
  for (Fall& fall : falls) {
    const HingeBackbone& of = *backbone(fall.hinge);
    if (of.residual == 0.0 || levelled_at(state, fall.hinge) > of.ultimate)
      fall = fall_of(state, fall.hinge, true, y(fall.hinge));
    state.memory(fall.hinge, snapped_at) = time;
  }
  redistribute(state, deformation, deformation, time, std::move(falls));
  rest_off_lines(state, deformation);
}

/// What loses most in a way that releases energy, with all that lose as much. (H-20)
std::vector<Index> HingeLaw::losing_most(const CoupledState& state, const HingeSides& sides,
                                         const VectorXd& way) const {
  constexpr double as_much = 1e-6;
  VectorXd loses = VectorXd::Zero(way.size());
  for (Index i = 0; i < way.size() - sides.free; ++i) {
    loses(i) = std::max(0.0, -slope(state, sides.of[i], sides.side[i])) * way(i) * way(i);
  }
  std::vector<Index> hinges;
  for (Index i = 0; i < way.size(); ++i) {
    if (loses(i) > 0.0 && loses(i) >= (1.0 - as_much) * loses.maxCoeff()) hinges.push_back(sides.of[i]);
  }
  return hinges;
}

/// As δ goes from one place to another, and lines come down while it does, hinges turn as little as they must, and
/// each follows its backbone: in stretches in which the same ones flow on lines of the same slopes. What comes to a
/// line and can break does, what would run away snaps, and both come down in what is left of the way.
void HingeLaw::redistribute(CoupledState& state, VectorXd from, const VectorXd& to, double time,
                            std::vector<Fall> falls) const {
  std::vector<const Fall*> falling;
  const auto find_falling = [&] {
    falling.assign(size(), nullptr);
    for (const Fall& fall : falls) falling[fall.hinge] = &fall;
  };
  const auto line_of = [&](Index h, double s) { return falling[h] != nullptr ? falling[h]->at(s) : line(state, h, s); };
  const auto slope_of = [&](Index h, double s) { return falling[h] != nullptr ? 0.0 : slope(state, h, s); };
  const auto add_fall = [&](const Fall& fall) {
    if (falling[fall.hinge] != nullptr) return;
    falls.push_back(fall);
    find_falling();
  };
  find_falling();
  const auto can_break = [&](Index h) { return breaks(h) && whole(state, h) && falling[h] == nullptr; };
  for (Index stretches = 0; stretches < 1000 * (size() + 1); ++stretches) {
    const VectorXd y = borne(state, from);
    for (Index h = 0; h < size(); ++h) {
      for (const double s : {1.0, -1.0}) {
        if (!can_break(h) || s * y(h) < line(state, h, s) - on_line * width(h)) continue;
        add_fall(fall_of(state, h, false, y(h)));
        state.memory(h, broke_at) = time;
      }
    }
    const std::vector<char> free = moving_freely(state);
    HingeSides sides;
    for (const bool of_free : {false, true}) {
      for (Index h = 0; h < size(); ++h) {
        if (nothing_left(state, h) && falling[h] == nullptr) {
          if (of_free && free[h] != 0) sides.add(h, 1.0, true);
          continue;
        }
        if (of_free) continue;
        for (const double s : {1.0, -1.0}) {
          const double limit = line_of(h, s);
          if (!std::isfinite(limit) || s * y(h) < limit - on_line * width(h)) continue;
          sides.add(h, s, false);
          break;
        }
      }
    }
    const Index count = std::ssize(sides.of);
    MatrixXd a = of_.stiffness(sides.of, sides.of);
    VectorXd b(count), sizes(count);
    for (Index i = 0; i < count; ++i) {
      const Index h = sides.of[i];
      const double s = sides.side[i];
      a(i, i) += slope_of(h, s);
      b(i) = s * (to(h) - from(h)) + (falling[h] != nullptr ? falling[h]->drop(s) : 0.0);
      sizes(i) = of_.stiffness(h, h);
    }
    const auto s = Eigen::Map<const VectorXd>(sides.side.data(), count);
    const RateSolution found = least_rate(s.asDiagonal() * a * s.asDiagonal(), b, sides.free, sizes);
    if (found.unbounded) {
      const std::vector<Index> hinges = losing_most(state, sides, found.pace);
      if (hinges.empty()) break;
      for (const Index h : hinges) {
        const HingeBackbone& of = *backbone(h);
        add_fall(fall_of(state, h, of.residual == 0.0 || levelled_at(state, h) > of.ultimate, y(h)));
        state.memory(h, snapped_at) = time;
      }
      continue;
    }
    VectorXd turns = VectorXd::Zero(size());
    for (Index i = 0; i < count; ++i) turns(sides.of[i]) = sides.side[i] * found.pace(i);
    // How far until a hinge comes to its line, or to where its own has another slope.
    VectorXd rises = to - from - of_.stiffness * turns;
    for (Index h = 0; h < size(); ++h) {
      if (stage_of(state, h) == virgin) rises(h) -= of_.hardening(h) * turns(h);
    }
    double part = 1.0;
    std::vector<double> flows_on(size(), 0.0);
    for (Index i = 0; i < count; ++i) flows_on[sides.of[i]] = sides.side[i];
    for (Index h = 0; h < size(); ++h) {
      if (nothing_left(state, h) && falling[h] == nullptr) continue;
      if (turns(h) != 0.0 && falling[h] == nullptr) {
        const double side = flows_on[h], end = stage_end(state, h, side);
        if (std::isfinite(end))
          part = std::min(part, std::max(0.0, (end - side * state.memory(h, rotation)) / std::abs(turns(h))));
      }
      for (const double to_side : {1.0, -1.0}) {
        const double limit = line_of(h, to_side);
        if (flows_on[h] == to_side || !std::isfinite(limit)) continue;
        const double closes = to_side * rises(h) + (falling[h] != nullptr ? falling[h]->drop(to_side) : 0.0);
        if (closes > 0.0) part = std::min(part, std::max(0.0, (limit - to_side * y(h)) / closes));
      }
    }
    for (Index i = 0; i < count; ++i) {
      const Index h = sides.of[i];
      const double side = sides.side[i], turned = part * found.pace(i);
      if (turned == 0.0) continue;
      auto memory = state.memory.row(h);
      const double bears = line_of(h, side), falls_by = falling[h] != nullptr ? part * falling[h]->drop(side) : 0.0;
      const double softens = std::min(0.0, slope_of(h, side)) * turned;
      const double lost_here = (bears - 0.5 * falls_by + 0.5 * softens) * turned;
      set_out(state, h, side);
      memory(rotation) += side * turned;
      memory(lost) += lost_here;
      memory(peak) = std::max(memory(peak), std::abs(memory(rotation)));
      const bool slips = breaks(h);
      if (falling[h] != nullptr) {
        const double at_rest = slips ? 0.5 * (of_.lower(h) - of_.upper(h)) : backbone(h)->at_rest;
        memory(released) += lost_here + at_rest * side * turned;
      }
      if (slips) continue;
      if (falling[h] != nullptr) continue;  // it gives way to what acts on it, this way and that
      note_flow(state, h, side, turned, time);
      sync(state, h, side);
    }
    from = part < 1.0 ? VectorXd(from + part * (to - from)) : to;
    for (Fall& fall : falls) {
      for (const int n : {0, 1}) {
        const double left = (1.0 - part) * (fall.line[n] - fall.end[n]);
        if (fall.line[n] > fall.end[n]) fall.line[n] = fall.end[n] + left;
      }
    }
    bool more = false;
    for (Index h = 0; h < size(); ++h) {
      const double side = flows_on[h];
      if (turns(h) == 0.0 || falling[h] != nullptr || nothing_left(state, h)) continue;
      const double end = stage_end(state, h, side);
      if (!std::isfinite(end) || side * state.memory(h, rotation) < end * (1.0 - at_end)) continue;
      if (!end_stage(state, h, side, time)) continue;
      add_fall(fall_of(state, h, true, borne(state, from)(h)));
      more = true;
    }
    if (part == 1.0 && !more) break;
  }
  for (const Fall& fall : falls) {
    if (breaks(fall.hinge)) continue;
    auto memory = state.memory.row(fall.hinge);
    memory(stage) = fall.fails ? spent : levelled;
    if (fall.fails) {
      memory(failed_at) = time;
    } else {
      memory(worn) = std::max(memory(worn), levelled_at(state, fall.hinge));
    }
  }
}

}  // namespace bentur
