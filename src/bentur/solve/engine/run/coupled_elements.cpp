#include "bentur/solve/engine/run/coupled_elements.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "bentur/solve/engine/motion/kernels/series.h"

namespace bentur::engine {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

constexpr double soon_part = 1e-7;       // of 1/ω of the fastest mode: an instant after an event
constexpr std::size_t most_known = 512;  // sets at a time of what rubs
constexpr double begins_band = 0x1p-40;  // of a guard's coefficients, where it has been divided by powers of time

/// The deformation that is all a guard depends on; −1: there are others.
Index only_one(const CoupledBranch& branch, const CoupledGuard& guard) {
  if (guard.deformation < 0 || guard.speed >= 0 || guard.acceleration >= 0 || !branch.set->moving.empty()) return -1;
  return branch.set->own[guard.deformation];
}

/// Whether sets that a law has made one after the other are the same.
bool alike(const CoupledSet& one, const CoupledSet& other) {
  const auto same = [](const MatrixXd& a, const MatrixXd& b) {
    return a.rows() == b.rows() && a.cols() == b.cols() && a == b;
  };
  return one.moving == other.moving && one.own == other.own && same(one.stiffness, other.stiffness) &&
         same(one.damping, other.damping) && same(one.over, other.over);
}

/// What guards that depend on one deformation alone say of each.
std::vector<Branch> branches_of(const CoupledBranch& branch, Index count) {
  std::vector<Branch> branches(count);
  for (std::size_t g = 0; g < branch.guard_count(); ++g) {
    const CoupledGuard guard = branch.guard(g);
    const Index n = only_one(branch, guard);
    if (n < 0 || std::isinf(guard.constant) || branches[n].guard_count == Branch::most_guards) continue;
    branches[n] = branches[n].guarded_by({{.constant = guard.constant, .deformation = guard.sense}});
  }
  return branches;
}

}  // namespace

std::vector<Branch> CoupledElements::first_branches(const ModalSystem& system, const Laws& laws) {
  std::vector<Branch> all;
  for (std::size_t e = 0; e < system.coupled.size(); ++e) {
    const Index count = system.coupled[e].count;
    if (e >= laws.size()) {
      all.resize(all.size() + count);
      continue;
    }
    const CoupledState rest = laws[e]->begin(VectorXd::Zero(count));
    for (const Branch& branch : branches_of(laws[e]->branch(rest), count)) all.push_back(branch);
  }
  return all;
}

CoupledElements::CoupledElements(const ModalSystem& system, const Laws& laws, const std::vector<double>& offsets,
                                 const State& state, std::shared_ptr<SetsOverModes> sets)
    : system_(&system),
      laws_(laws),
      own_(system.coupled.size() - system.rubbing),
      offsets_(offsets),
      sets_(sets ? std::move(sets) : std::make_shared<SetsOverModes>()),
      now_(laws.size()) {
  double fastest = 0.0;
  for (const ModalSystem::Block& block : system.blocks) fastest = std::max(fastest, block.omega_max);
  soon_ = fastest > 0.0 ? soon_part / fastest : 0.0;
  for (std::size_t e = 0; e < laws.size(); ++e) {
    const ModalSystem::Coupled& of = system.coupled[e];
    std::vector<Index>& at = all_.emplace_back(of.count);
    std::iota(at.begin(), at.end(), of.first);
    MatrixXd& rows = rows_.emplace_back(system.elements[of.first].relation.size(), of.count);
    MatrixXd& pushes = pushes_.emplace_back(rows.rows(), of.count);
    VectorXd& shifts = shifts_.emplace_back(of.count);
    for (Index n = 0; n < of.count; ++n) {
      const ModalSystem::Relation& each = system.elements[of.first + n].relation;
      ModalSystem::Relation::spread(each.left_row, each.right_row, rows.col(n));
      ModalSystem::Relation::spread(each.left_push, each.right_push, pushes.col(n));
      shifts(n) = offsets[of.first + n];
    }
    along_.emplace_back(rows.transpose());
    sizes_.emplace_back(rows.cwiseAbs().transpose());
    largest_.emplace_back(VectorXd::Zero(rows.rows()));
    states_.push_back(laws[e]->begin(deformation(e, state)));
  }
}

void CoupledElements::watch(GuardMonitor& monitor) {
  monitor_ = &monitor;
  for (std::size_t e = 0; e < states_.size(); ++e) enter(e);
}

std::shared_ptr<const SetOverModes> CoupledElements::known(std::size_t e, const std::shared_ptr<const CoupledSet>& of) {
  if (e < own_) return sets_->of(*system_, e, rows_[e], of);
  if (const auto found = known_.find({e, of.get()}); found != known_.end()) return found->second;
  const std::pair<std::size_t, const CoupledSet*> first{e, nullptr};
  for (auto at = known_.lower_bound(first); at != known_.end() && at->first.first == e; ++at) {
    if (alike(*at->second->set, *of)) return at->second;
  }
  if (known_.size() >= most_known) known_.clear();
  return known_.emplace(std::pair{e, of.get()}, std::make_shared<const SetOverModes>(*system_, e, rows_[e], of))
      .first->second;
}

/// Works out the branch of a state.
void CoupledElements::enter(std::size_t e) {
  const ModalSystem::Coupled& of = system_->coupled[e];
  Now& now = now_[e];
  now.branch = laws_[e]->branch(states_[e]);
  now.begins = true;
  now.known = known(e, now.branch.set);
  now.branch.set = now.known->set;
  now.is_new = true;
  for (std::size_t other = 0; other < own_; ++other) {  // of the same body
    if (begin_of(other) != begin_of(e)) continue;
    now_[other].until = -std::numeric_limits<double>::infinity();
    now_[other].next = -1;
  }
  now.may_fly = !now.known->modal;
  if (now.may_fly) tell_monitor(e);
  const MatrixXd& pushes = pushes_[e];
  now.constant.clear();
  now.load.setZero(pushes.rows());
  auto moving = now.branch.set->moving.begin();
  for (Index n = 0; n < of.count; ++n) {
    const bool moves = moving != now.branch.set->moving.end() && *moving == n;
    if (moves) ++moving;
    if (moves || now.branch.base(n) == 0.0) continue;
    now.constant.push_back(of.first + n);
    now.load += now.branch.base(n) * pushes.col(n);
  }
  for (CoupledGuard& guard : now.branch.guards) {
    if (guard.deformation >= 0 && e >= own_) {  // offsets of the others are zero
      guard.constant += guard.sense * now.branch.set->row(guard.deformation, of.count).dot(shifts_[e]);
    }
  }
  sort_guards(now);
}

void CoupledElements::sort_guards(Now& now) const {
  const Index rows = now.known->packed.rows();
  constexpr double any = std::numeric_limits<double>::infinity();
  const CoupledBounds& bounds = now.branch.bounds;
  now.least.setConstant(rows, -any);
  now.most.setConstant(rows, any);
  now.least.head(bounds.least.size()) = bounds.least;
  now.most.head(bounds.most.size()) = bounds.most;
  now.below.assign(rows, -1);
  now.above.assign(rows, -1);
  now.others.clear();
  now.delayed = false;
  for (int g = 0; g < static_cast<int>(now.branch.guards.size()); ++g) {
    const CoupledGuard& guard = now.branch.guards[g];
    const Index row = guard.deformation;
    const bool of_row = row >= 0 && guard.speed < 0 && guard.acceleration < 0, later = now.begins && guard.zeros > 0;
    const bool alone = of_row && !later;
    now.delayed = now.delayed || (of_row && later);
    std::vector<int>& of = guard.sense > 0.0 ? now.below : now.above;
    if (!alone || of[row] >= 0 || now.branch.bound(row, guard.sense < 0.0) >= 0) {
      now.others.push_back(g);
      continue;
    }
    of[row] = g;
    (guard.sense > 0.0 ? now.least : now.most)(row) = guard.sense > 0.0 ? -guard.constant : guard.constant;
  }
}

void CoupledElements::tell_monitor(std::size_t e) {
  const ModalSystem::Coupled& of = system_->coupled[e];
  Now& now = now_[e];
  const std::vector<Branch> branches = branches_of(now.branch, of.count);
  std::vector<char> watched(of.count, 0);
  for (Index n = 0; n < of.count; ++n) watched[n] = monitor_->enter(of.first + n, branches[n]) ? 1 : 0;
  for (std::size_t g = 0; g < now.branch.guard_count(); ++g) {
    const CoupledGuard guard = now.branch.guard(g);
    if (std::isinf(guard.constant)) continue;
    const Index only = only_one(now.branch, guard);
    now.may_fly = now.may_fly && only >= 0 && watched[only] != 0;
  }
}

VectorXd CoupledElements::deformation(std::size_t e, const State& state) const {
  VectorXd result = along_[e] * state.q.segment(begin_of(e), along_[e].cols());
  if (e >= own_) result += shifts_[e];
  return result;
}

CoupledMotion CoupledElements::motion_of(std::size_t e, const State& state, const VectorXd& acceleration) const {
  const auto along = [&](const VectorXd& x) -> VectorXd {
    return along_[e] * x.segment(begin_of(e), along_[e].cols());
  };
  return {deformation(e, state), along(state.v), along(acceleration), soon_};
}

bool CoupledElements::gather(ElementForces& forces, State& state) {
  forces.coupled.clear();
  bool may_fly = true;
  for (std::size_t e = 0; e < now_.size(); ++e) {
    Now& now = now_[e];
    const auto [first, count] = system_->coupled[e];
    may_fly = may_fly && now.may_fly;
    const Index force = system_->elements[first].force;  // of its other deformations they follow
    if (force >= 0) {
      state.q.segment(force, count) = now.branch.base;
      state.v.segment(force, count).setZero();
    }
    for (Index n = 0; now.is_new && n < count; ++n) forces.linear[first + n] = {.base = now.branch.base(n)};
    now.is_new = false;
    forces.constant.insert(forces.constant.end(), now.constant.begin(), now.constant.end());
    if (!now.known->modal) continue;
    const CoupledSet& set = *now.branch.set;
    ElementForces::Coupled& of = forces.coupled.emplace_back();
    of.set = now.branch.set;
    of.base.resize(std::ssize(set.moving));
    for (Index n = 0; n < of.base.size(); ++n) of.base(n) = now.branch.base(set.moving[n]);
    if (e >= own_) of.base += set.stiffness * shifts_[e](set.moving);
    of.modal = now.known->modal;
    of.steady.noalias() = of.modal->push * of.base;
    system_->fill_forces(of, state);
  }
  return may_fly;
}

void CoupledElements::add_loads(VectorXd& load) const {
  for (std::size_t e = 0; e < now_.size(); ++e) load.segment(begin_of(e), now_[e].load.size()) += now_[e].load;
}

void CoupledElements::add_forces(const State& state, VectorXd& forces) const {
  for (std::size_t e = 0; e < now_.size(); ++e) {
    const Now& now = now_[e];
    forces.segment(system_->coupled[e].first, system_->coupled[e].count) = now.branch.base;
    if (!now.known->modal) continue;
    const CoupledSet& set = *now.branch.set;
    const std::vector<Index>& at = now.known->modal->at;
    forces(at) += set.stiffness * system_->deformations(at, offsets_, state.q);
    if (set.damping.size() > 0) forces(at) += set.damping * system_->speeds(at, state.v);
  }
}

double CoupledElements::band(std::size_t e, const CoupledGuard& guard, const State& state, const Bands& bands) const {
  const Index first = system_->coupled[e].first;
  const CoupledSet& set = *now_[e].branch.set;
  const auto sum = [&](Index row, const auto& of) {
    double result = set.own[row] >= 0 ? of(set.own[row]) : 0.0;
    for (std::size_t n = 0; n < set.moving.size(); ++n) {
      result += std::abs(set.over(row, static_cast<Index>(n))) * of(set.moving[n]);
    }
    return result;
  };
  double result = bands.part * std::max(std::abs(guard.constant), guard.size);
  if (guard.deformation >= 0) result += sum(guard.deformation, [&](Index n) { return bands.displacement[first + n]; });
  if (guard.speed >= 0) {
    result += bands.part *
              sum(guard.speed, [&](Index n) { return system_->elements[first + n].relation.along_abs(state.v); });
  }
  return result;
}

/// A row of an element's guards over the expanded step.
Polynomial CoupledElements::row_of(std::size_t e, Index row, const Expansion& motion) const {
  const MatrixXd& rows = now_[e].known->rows;
  const MatrixXd& c = motion.coefficients();
  const double* begin = c.data() + begin_of(e);
  Polynomial p;
  p.degree = motion.degree();
  kernels::row_series({0, nullptr, begin}, {rows.rows(), rows.col(row).data(), begin}, c.rows(), p.degree,
                      p.coefficients.data());
  return p;
}

/// Where in the expanded step a guard ends its branch.
std::optional<double> CoupledElements::end_of(std::size_t e, const CoupledGuard& guard, const Expansion& motion,
                                              const State& from, const Bands& bands) const {
  const int zeros = now_[e].begins ? guard.zeros : 0;
  if (zeros == 0 && guard.deformation >= 0 && guard.speed < 0 && guard.acceleration < 0) {
    const Polynomial row = row_of(e, guard.deformation, motion);
    if (!first_negative(row, guard.sense, guard.constant)) return std::nullopt;  // whatever the band
    const double slack = band(e, guard, from, bands), start = guard.sense * row[0];
    const double over = start + guard.constant + slack;
    const bool at_zero = over < 0.0 && over >= -bands.start_slack * slack;
    return first_negative(row, guard.sense, at_zero ? -start : guard.constant + slack);
  }
  Polynomial p;
  p.degree = motion.degree();
  double size = 0.0;
  const auto add = [&](int k, double term) {
    p[k] += guard.sense * term;
    size += std::abs(term);
  };
  if (guard.deformation >= 0) {
    const Polynomial delta = row_of(e, guard.deformation, motion);
    for (int k = 0; k <= p.degree; ++k) add(k, delta[k]);
  }
  if (guard.speed >= 0) {
    const Polynomial delta = row_of(e, guard.speed, motion);
    for (int k = 0; k < p.degree; ++k) add(k, (k + 1.0) * delta[k + 1] / motion.h());
  }
  if (guard.acceleration >= 0) {
    const Polynomial bent = second_derivative(row_of(e, guard.acceleration, motion), 1.0 / (motion.h() * motion.h()));
    for (int k = 0; k <= bent.degree; ++k) add(k, bent[k]);
  }
  if (zeros > 0) {
    for (int k = 0; k <= p.degree; ++k) p[k] = k + zeros <= p.degree ? p[k + zeros] : 0.0;
  } else {
    p[0] += guard.constant;
  }
  if (!first_negative(p)) return std::nullopt;  // whatever the band
  double slack = band(e, guard, from, bands);
  if (guard.acceleration >= 0) slack += bands.part * size;
  if (zeros > 0) return first_negative(p, 1.0, begins_band * size + slack);
  const bool at_zero = p[0] + slack < 0.0 && p[0] + slack >= -bands.start_slack * slack;
  return first_negative(p, 1.0, at_zero ? -p[0] : slack);
}

/// Whether its guard of speed cannot fail in the expanded step: speeds leave their chord by a quarter of the step times
/// how far accelerations lie apart in it, which is in speed_rise_.
bool CoupledElements::keeps_speed(std::size_t e, const CoupledGuard& guard, const State& from, const State& to) const {
  if (guard.speed < 0 || guard.deformation >= 0 || guard.acceleration >= 0) return false;
  if (now_[e].begins && guard.zeros > 0) return false;
  const MatrixXd& rows = now_[e].known->rows;
  const double* row = rows.col(guard.speed).data();
  const Index size = rows.rows(), begin = begin_of(e);
  const double start = guard.sense * kernels::dot(size, row, from.v.data() + begin);
  const double end = guard.sense * kernels::dot(size, row, to.v.data() + begin);
  return guard.constant + std::min(start, end) >= kernels::dot_abs(size, row, speed_rise_.data() + begin);
}

/// The first change of one element; `risen`: speed_rise_ is that of the step.
std::optional<CoupledElements::Event> CoupledElements::search(std::size_t e, const Expansion& motion, const State& from,
                                                              const State& to, const Bands& bands, bool& risen) {
  const Now& now = now_[e];
  const Index rows = now.known->packed.rows();
  low_.resize(rows);
  high_.resize(rows);
  beyond_.resize(rows);
  const Index fours = kernels::fours_beyond(now.known->packed, from.q.data() + begin_of(e), to.q.data() + begin_of(e),
                                            motion.rise().data() + begin_of(e), now.least.data(), now.most.data(),
                                            low_.data(), high_.data(), beyond_.data());
  asked_.assign(now.others.begin(), now.others.end());
  const auto ask = [&](int guard, Index row, bool high) {
    asked_.push_back(guard >= 0 ? guard : now.branch.bound(row, high));
  };
  for (Index n = 0; n < fours; ++n) {
    for (Index row = beyond_[n]; row < beyond_[n] + 4; ++row) {
      if (!(low_(row) >= now.least(row))) ask(now.below[row], row, false);
      if (!(high_(row) <= now.most(row))) ask(now.above[row], row, true);
    }
  }
  if (asked_.size() > now.others.size()) std::sort(asked_.begin(), asked_.end());
  if (!risen && !now.others.empty()) motion.find_speed_rise(speed_rise_);
  risen = risen || !now.others.empty();
  std::optional<Event> found;
  for (const int g : asked_) {
    if (g < 0) continue;  // of rows that are not numbers
    const CoupledGuard guard = now.branch.guard(g);
    if (keeps_speed(e, guard, from, to)) continue;
    const auto s = end_of(e, guard, motion, from, bands);
    if (s && (!found || *s < found->s)) found = Event{e, static_cast<std::size_t>(g), *s};
  }
  return found;
}

std::optional<CoupledElements::Event> CoupledElements::next_event(const Expansion& motion, const State& from,
                                                                  const State& to, const Bands& bands, double time,
                                                                  bool apart) {
  constexpr double same_instant = 0x1p-50;  // of the time
  std::optional<Event> first;
  bool risen = false;
  const double end = time + motion.h();
  const bool lasts = apart && now_.size() == own_;
  for (std::size_t e = 0; e < now_.size(); ++e) {
    Now& now = now_[e];
    std::optional<Event> found;
    if (lasts && (now.next >= 0 || end <= now.until + same_instant * end)) {
      const double s = (now.until - time) / motion.h();
      if (now.next >= 0 && s <= 1.0) found = Event{e, static_cast<std::size_t>(now.next), std::max(s, 0.0)};
    } else {
      found = search(e, motion, from, to, bands, risen);
      now.next = found && lasts ? static_cast<int>(found->guard) : -1;
      now.until = !lasts ? -std::numeric_limits<double>::infinity() : found ? time + found->s * motion.h() : end;
    }
    if (found && (!first || found->s < first->s)) first = found;
  }
  return first;
}

void CoupledElements::gauge(const State& state, double part, std::vector<double>& displacement) {
  for (std::size_t e = 0; e < now_.size(); ++e) {
    const double* q = state.q.data() + begin_of(e);
    bool grows = false;
    for (double& largest : largest_[e]) {
      const double size = std::abs(*q++);
      grows = grows || size > largest;
      largest = std::max(largest, size);
    }
    if (!grows) continue;
    sums_.noalias() = sizes_[e] * largest_[e];
    for (Index n = 0; n < system_->coupled[e].count; ++n) {
      double& of = displacement[system_->coupled[e].first + n];
      of = std::max(of, part * sums_(n));
    }
  }
}

std::optional<CoupledElements::Event> CoupledElements::due(const State& state, const VectorXd& acceleration,
                                                           const Bands& bands) const {
  for (std::size_t e = 0; e < now_.size(); ++e) {
    const Now& now = now_[e];
    const Index begin = begin_of(e);
    const auto along = [&](Index row, const VectorXd& x) {
      return row < 0 ? 0.0 : kernels::dot(now.known->rows.rows(), now.known->rows.col(row).data(), x.data() + begin);
    };
    for (std::size_t g = 0; g < now.branch.guard_count(); ++g) {
      const CoupledGuard guard = now.branch.guard(g);
      const double sum =
          along(guard.deformation, state.q) + along(guard.speed, state.v) + along(guard.acceleration, acceleration);
      if (guard.constant + guard.sense * sum < -band(e, guard, state, bands)) return Event{e, g, 1.0};
    }
  }
  return std::nullopt;
}

void CoupledElements::go_on() {
  for (Now& now : now_) {
    now.begins = false;
    if (now.delayed) sort_guards(now);
  }
}

void CoupledElements::change(const Event& event, double time, const State& state, const VectorXd& acceleration) {
  const std::size_t e = event.element;
  states_[e] = laws_[e]->next(states_[e], now_[e].branch, event.guard, time, motion_of(e, state, acceleration));
  enter(e);
}

void CoupledElements::enter_state(std::size_t e, CoupledState state) {
  states_[e] = std::move(state);
  enter(e);
}

void CoupledElements::settle(double time, const State& state, const VectorXd& acceleration) {
  for (std::size_t e = 0; e < states_.size(); ++e) {
    states_[e] = laws_[e]->settle(states_[e], time, motion_of(e, state, acceleration));
    enter(e);
  }
}

void CoupledElements::resume(const std::vector<CoupledState>& states, const std::vector<VectorXd>& largest) {
  std::copy(states.begin(), states.end(), states_.begin());
  std::copy(largest.begin(), largest.end(), largest_.begin());
  for (std::size_t e = 0; e < states_.size(); ++e) enter(e);
  go_on();  // their branches began before
}

std::vector<CoupledState> CoupledElements::states_at(const State& state) const {
  std::vector<CoupledState> result;
  for (std::size_t e = 0; e < own_; ++e) {
    result.push_back(laws_[e]->at(states_[e], deformation(e, state)));
  }
  return result;
}

double CoupledElements::stored_energy(const State& state) const {
  double sum = 0.0;
  for (std::size_t e = 0; e < own_; ++e) {
    sum += laws_[e]->stored_energy(states_[e], deformation(e, state));
  }
  return sum;
}

double CoupledElements::lost_energy(const State& state) const {
  double sum = 0.0;
  for (std::size_t e = 0; e < own_; ++e) {
    sum += laws_[e]->lost_energy(states_[e], deformation(e, state));
  }
  return sum;
}

}  // namespace bentur::engine
