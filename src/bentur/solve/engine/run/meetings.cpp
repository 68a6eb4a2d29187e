#include "bentur/solve/engine/run/meetings.h"

#include <algorithm>
#include <cmath>

#include "bentur/solve/engine/run/elements.h"

namespace bentur::engine {

using Eigen::Index;

namespace {

constexpr double same_speed = 1e-9;  // of closing speeds that are one

}  // namespace

Meetings::Meetings(const std::vector<MeetingPlace>& places) : places_(places), passed_(places.size(), 0) {
  for (Index point = 0; point < std::ssize(places); ++point) {
    const Index meeting = places[point].meeting;
    if (meeting < 0) continue;
    if (meeting >= std::ssize(points_)) points_.resize(meeting + 1);
    points_[meeting].push_back(point);
  }
  sharing_.assign(points_.size(), 1);
}

Branch passed_branch(const Branch& apart) {
  Branch branch;
  branch.guard_count = apart.guard_count;
  for (std::size_t g = 0; g < apart.guard_count; ++g) {
    const Guard& guard = apart.guards[g];
    branch.guards[g] = {-guard.constant, -guard.deformation, -guard.speed, -guard.decaying, guard.rate};
  }
  return branch;
}

Branch PartOfLaw::branch(const LawState& state) const noexcept {
  Branch branch = whole_->branch(state);
  branch.base *= part_;
  branch.stiffness *= part_;
  branch.damping *= part_;
  return branch;
}

bool Elements::touches_at(Index point) const {
  return point < system_->switched ? branches_[point].touching() : touches(rub(point - system_->switched));
}

bool Elements::is_closed(Index point) const { return meetings_.passed(point) || touches_at(point); }

/// Whether bodies touch at a point of a meeting that closes: all other families are closed and none of them pushes. Of
/// families that close at one instant it is the one with the greatest closing speed; equal ones share.
bool Elements::may_touch(Index point, const State& state) {
  if (meetings_.is_seam(point)) return false;
  const Index own = system_->opening(point);
  const double closing = speed(own, state);
  const std::vector<Index>& all = meetings_.points_with(point);
  int sharing = 1;
  std::vector<Index> seen;  // a point of each other family
  for (const Index first : all) {
    const auto of_first = [&](Index one) { return meetings_.are_of_one_family(first, one); };
    if (meetings_.are_of_one_family(point, first) || std::any_of(seen.begin(), seen.end(), of_first)) continue;
    seen.push_back(first);
    bool closed = false, pushes = false, closes_now = false, wins = false, ties = false;
    for (const Index one : all) {
      if (!of_first(one)) continue;
      closed = closed || is_closed(one);
      pushes = pushes || touches_at(one);
      const Index at = system_->opening(one);
      if (is_closed(one) || std::abs(deformation(at, state)) > start_slack_ * tolerances_[at]) continue;
      const double its = speed(at, state);
      closes_now = closes_now || its > 0.0;
      wins = wins || its > closing * (1.0 + same_speed);
      ties = ties || std::abs(its - closing) <= same_speed * closing;
    }
    if (pushes && meetings_.sharing(point) == 1) return false;
    if (closed) continue;
    if (!closes_now || wins) return false;
    if (ties) ++sharing;
  }
  const bool some_push = std::any_of(all.begin(), all.end(), [&](Index one) { return touches_at(one); });
  if (!some_push) meetings_.sharing(point) = point < system_->switched && !law(point).restitution() ? sharing : 1;
  return true;
}

/// A contact has its law, or a part of it where as many families share.
void Elements::take(Index contact, int sharing) {
  if (const auto* part = dynamic_cast<const PartOfLaw*>(laws_[contact].get())) {
    laws_[contact] = std::shared_ptr<const Law>(part->whole());
  }
  if (sharing > 1) laws_[contact] = std::make_shared<PartOfLaw>(laws_[contact], 1.0 / sharing);
}

/// A point is no longer closed: where nothing is of its family, bodies slip off all others.
void Elements::part(Index point, double time, State& state) {
  if (!meetings_.has(point)) return;
  const std::vector<Index>& all = meetings_.points_with(point);
  const auto keeps = [&](Index one) { return meetings_.are_of_one_family(point, one) && is_closed(one); };
  if (std::none_of(all.begin(), all.end(), keeps)) {
    for (const Index one : all) {
      if (touches_at(one)) slip_off(one, time, state);
    }
  }
  if (std::none_of(all.begin(), all.end(), [&](Index one) { return touches_at(one); })) meetings_.sharing(point) = 1;
}

/// Ends a contact where it is: its force is gone, and with it what its spring held.
void Elements::slip_off(Index point, double time, State& state) {
  const Index at = system_->opening(point);
  const bool rubs = point >= system_->switched;
  const Rub of = rubs ? rub(point - system_->switched) : Rub{};
  const Index log = rubs ? of.log : point;
  Impact& impact = log_.under_way(log);
  impact.slipped = true;
  if (rubs) {
    const LawState before = of.law->normal_state(coupled_.states()[of.coupled]);
    impact.energy_lost += of.law->normal().stored_energy(before, deformation(at, state));
  } else if (resting(point)) {
    let_go(point, state);
  } else {
    impact.energy_lost += law(point).stored_energy(states_[point], deformation(point, state));
  }
  log_.end(log, time, -speed(at, state));
  if (!rubs) take(point, 1);
  pass(point, time, state);
  meetings_.slip_off(point);
}

/// A point is closed and nothing pushes there.
void Elements::pass(Index point, double time, State& state) {
  meetings_.pass(point);
  if (point < system_->switched) {
    touches_[point] = {};
    const bool dented = branches_[point].bodies == Bodies::apart;  // a surface that is remembered
    set(point, dented ? states_[point] : LawState{}, state);
    return;
  }
  const Rub of = rub(point - system_->switched);
  touches_[of.log] = {};
  coupled_.enter_state(of.coupled, of.law->passed(coupled_.states()[of.coupled], time));
  gather(state);
}

/// A guard of a point of a meeting has failed. Whether that is all that follows.
bool Elements::is_settled(Index point, double time, State& state) {
  if (meetings_.passed(point)) {
    meetings_.come_back(point);
    meetings_.settle();
    if (point < system_->switched) {
      set(point, states_[point], state);
    } else {
      const Rub of = rub(point - system_->switched);
      coupled_.enter_state(of.coupled, of.law->returned(coupled_.states()[of.coupled]));
      gather(state);
    }
    part(point, time, state);
    return true;
  }
  if (touches_at(point)) return false;
  if (may_touch(point, state)) {
    if (point < system_->switched) take(point, meetings_.sharing(point));
    return false;
  }
  pass(point, time, state);
  meetings_.settle();
  return true;
}

}  // namespace bentur::engine
