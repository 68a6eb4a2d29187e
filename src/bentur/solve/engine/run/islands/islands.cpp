#include "bentur/solve/engine/run/islands/islands.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace bentur::engine {
namespace {

using Eigen::Index;

constexpr double whole_slack = 1e-9;   // of what is left of a segment: a remainder shorter than this is not a step
constexpr long most_changes = 100000;  // in a segment, per body: more cannot be a pounding problem
constexpr double eighth = 0.125;       // of a bound of the second derivative: how far a step leaves its chord

/// p(shift + factor s) as a polynomial of s.
void substitute(Polynomial& p, double shift, double factor) {
  if (shift != 0.0) {
    for (int i = 0; i < p.degree; ++i) {
      for (int k = p.degree - 1; k >= i; --k) p[k] += shift * p[k + 1];
    }
  }
  double power = factor;
  for (int k = 1; k <= p.degree; ++k, power *= factor) p[k] *= power;
}

bool decays(const Branch& branch) {
  return std::any_of(branch.guards, branch.guards + branch.guard_count,
                     [](const Guard& guard) { return guard.decaying != 0.0; });
}

}  // namespace

bool Islands::serve(const ModalSystem& system, const ElementLaws& laws) {
  return system.blocks.size() >= least_bodies && system.classical && system.rubbing == 0 &&
         system.switched == std::ssize(system.elements) &&
         std::none_of(laws.laws.begin(), laws.laws.end(),
                      [](const auto& law) { return law->restitution().has_value(); });
}

Islands::Islands(const ModalSystem& system, const ElementLaws& laws, Parts parts)
    : system_(&system),
      parts_(std::move(parts)),
      series_(system, laws.offsets),
      motion_(system, laws.offsets),
      offsets_(laws.offsets),
      of_body_(system.blocks.size()),
      courses_(system.blocks.size()),
      island_(system.blocks.size(), 0),
      versions_(static_cast<std::size_t>(system.switched), 0),
      stays_(static_cast<std::size_t>(system.switched), 0) {
  std::map<std::pair<Index, Index>, std::size_t> numbers;
  const auto pair_between = [&](const ModalSystem::Relation& at) {
    const auto [found, is_new] =
        numbers.try_emplace(std::pair<Index, Index>(std::minmax(at.left, at.right)), pairs_.size());
    if (is_new) {
      pairs_.push_back({.left = at.left, .right = at.right, .contacts = {}, .watched = {}});
      of_body_[at.left].push_back(found->second);
      if (at.right != at.left) of_body_[at.right].push_back(found->second);
    }
    return found->second;
  };
  for (Index i = 0; i < system.switched; ++i) {
    pair_of_.push_back(pair_between(system.elements[i].relation));
    pairs_[pair_of_.back()].contacts.push_back(i);
  }
  for (Index n = 0; n < std::ssize(system.watched); ++n) {
    pairs_[pair_between(system.watched[n])].watched.push_back(n);
  }
  stamps_.assign(pairs_.size(), 0);
  const Eigen::VectorXd zero = Eigen::VectorXd::Zero(system.size);
  from_ = to_ = now_ = ends_.from = ends_.to = {zero, zero};
  for (Eigen::VectorXd* x : {&from_acceleration_, &to_acceleration_, &rise_, &acceleration_rise_, &bend_,
                             &now_acceleration_, &part_, &acceleration_part_, &fourth_, &ends_.rise}) {
    *x = zero;
  }
}

bool Islands::presses(Index i) const {
  const ElementForces::Linear& linear = parts_.elements.forces_.linear[i];
  return linear.base != 0.0 || linear.stiffness != 0.0 || linear.damping != 0.0;
}

bool Islands::is_served(const Pair& pair) const {
  return std::all_of(pair.contacts.begin(), pair.contacts.end(), [&](Index i) {
    const Branch& branch = parts_.elements.branches_[i];
    return branch.linear && !decays(branch);
  });
}

/// Where a body is, by its series.
void Islands::place(Index b, double time, State& to) const {
  const Course& course = courses_[b];
  const Index begin = block(b).begin, count = block(b).padded_size;
  const State* known = time == course.start ? &from_ : time == course.end() ? &to_ : nullptr;
  if (known != nullptr) {
    to.q.segment(begin, count) = known->q.segment(begin, count);
    to.v.segment(begin, count) = known->v.segment(begin, count);
    return;
  }
  const double* c = std::as_const(motion_).coefficients().data() + begin;
  kernels::evaluate(count, c, system_->size, course.degree, (time - course.start) / course.h, course.h,
                    {to.q.data() + begin, to.v.data() + begin, nullptr});
}

void Islands::evaluate(double time, State& state) {
  for (Index b = 0; b < std::ssize(courses_); ++b) {
    place(b, std::clamp(time - start_, courses_[b].start, courses_[b].end()), state);
  }
  parts_.elements.gather(state);
}

/// Both ends of what is looked at of a pair.
void Islands::look_ahead(const Pair& pair) {
  const auto take = [&](Index b) {
    place(b, pair.start, ends_.from);
    place(b, pair.start + pair.length, ends_.to);
    const double part = pair.length / courses_[b].h;
    const Index begin = block(b).begin, count = block(b).padded_size;
    ends_.rise.segment(begin, count) = (eighth * part * part) * bend_.segment(begin, count);
  };
  take(pair.left);
  if (pair.right != pair.left) take(pair.right);
}

/// row · q of one body, over what is looked at.
Polynomial Islands::side(Index b, Index begin, const Eigen::VectorXd& row, const Pair& pair) const {
  const Course& course = courses_[b];
  Polynomial p;
  p.degree = course.degree;
  const double* c = std::as_const(motion_).coefficients().data() + begin;
  kernels::row_series({0, nullptr, c}, {row.size(), row.data(), c}, system_->size, p.degree, p.coefficients.data());
  substitute(p, (pair.start - course.start) / course.h, pair.length / course.h);
  return p;
}

Polynomial Islands::deformation(const ModalSystem::Relation& of, double offset, const Pair& pair) const {
  const Course& left = courses_[of.left];
  const Course& right = courses_[of.right];
  const bool together = left.start == right.start && left.h == right.h && left.degree == right.degree;
  Polynomial p;
  if (together && left.start == pair.start && left.h == pair.length) {
    const double* c = std::as_const(motion_).coefficients().data();
    p.degree = left.degree;
    kernels::row_series({of.right_size, of.right_row.data(), c + of.right_begin},
                        {of.left_size, of.left_row.data(), c + of.left_begin}, system_->size, p.degree,
                        p.coefficients.data());
  } else {
    p = side(of.left, of.left_begin, of.left_row, pair);
    if (of.right_size > 0) {
      const Polynomial other = side(of.right, of.right_begin, of.right_row, pair);
      p.degree = std::max(p.degree, other.degree);
      for (int k = 0; k <= p.degree; ++k) p[k] += other[k];
    }
  }
  p[0] += offset;
  return p;
}

/// Looks ahead from a time on, as far as the series of both bodies go.
void Islands::open(Pair& pair, double time) {
  Elements& elements = parts_.elements;
  pair.start = time;
  pair.length = std::min(courses_[pair.left].end(), courses_[pair.right].end()) - time;
  for (const Index i : pair.contacts) ++versions_[i];
  if (!(pair.length > 0.0)) return;
  look_ahead(pair);
  for (const Index i : pair.contacts) {
    const Branch& branch = elements.branches_[i];
    const ModalSystem::Relation& of = elements.relation(i);
    bool stays = true;
    if (branch.guard_count > 0) {
      const double first = offsets_[i] + of.along(ends_.from.q), last = offsets_[i] + of.along(ends_.to.q);
      const double rise = of.along_abs(ends_.rise);
      for (std::size_t g = 0; g < branch.guard_count && stays; ++g) {
        const Guard& guard = branch.guards[g];
        const double low = guard.constant + std::min(guard.deformation * first, guard.deformation * last);
        stays = guard.speed == 0.0 && guard.decaying == 0.0 && low - std::abs(guard.deformation) * rise > 0.0;
      }
    }
    stays_[i] = stays ? 1 : 0;
    if (stays) continue;
    elements.gauge(i, ends_.to);
    const Polynomial delta = deformation(of, offsets_[i], pair);
    const auto event = elements.next_event(i, {delta, pair.length, start_ + time}, ends_.from);
    if (event) queue_.push({time + event->s * pair.length, i, event->guard, versions_[i]});
  }
}

/// Takes in what has been looked at up to a time; now_ has both bodies there.
void Islands::close(Pair& pair, double time) {
  Elements& elements = parts_.elements;
  if (!(pair.length > 0.0)) return;
  const double end = (time - pair.start) / pair.length;
  const bool lasts = time - pair.start > parts_.instant;
  for (const Index i : pair.contacts) {
    const Branch& branch = elements.branches_[i];
    if (branch.touching()) {
      if (!lasts) continue;
      const Polynomial delta = deformation(elements.relation(i), offsets_[i], pair);
      double speeds = 0.0;
      if (branch.damping != 0.0) {
        look_ahead(pair);
        speeds = elements.relation(i).along_abs(ends_.from.v);
      }
      elements.accumulate(i, {delta, pair.length, start_ + pair.start}, end, speeds);
    } else if (elements.awaits(i)) {
      const double at = surface(branch);
      if (stays_[i] != 0 || elements.deformation(i, now_) < at) {
        elements.touches_[i] = {};
      } else {
        const Polynomial delta = deformation(elements.relation(i), offsets_[i], pair);
        elements.note_touch({i, i, at, elements.tolerances_[i], elements.leaves_band_[i] != 0},
                            {delta, pair.length, start_ + pair.start}, end);
      }
    }
  }
  if (lasts) close_watched(pair, time);
}

void Islands::close_watched(const Pair& pair, double time) {
  if (pair.watched.empty()) return;
  Pair part = pair;
  part.length = time - pair.start;
  look_ahead(part);
  for (const Index n : pair.watched) {
    const ModalSystem::Relation& of = system_->watched[n];
    const double reach = std::max(of.along(ends_.from.q), of.along(ends_.to.q)) + of.along_abs(ends_.rise);
    if (reach > parts_.watched.nearest()[n].reach) {
      parts_.watched.take(n, deformation(of, 0.0, part), part.length, start_ + part.start);
    }
  }
}

/// Takes in where bodies have been up to a time, from which on they have other series; now_ has them there.
void Islands::close(const std::vector<Index>& bodies, double time) {
  const Eigen::MatrixXd& c = std::as_const(motion_).coefficients();
  for (const Index b : bodies) {
    const Course& course = courses_[b];
    const Index begin = block(b).begin, count = block(b).padded_size;
    if (time - course.start > parts_.instant) {
      const double s = (time - course.start) / course.h;
      const auto at = [begin](auto& x) { return x.data() + begin; };
      kernels::evaluate(count, c.data() + begin, system_->size, course.degree, s, course.h,
                        {at(now_.q), at(now_.v), at(now_acceleration_)});
      part_.segment(begin, count) = (s * s) * rise_.segment(begin, count);
      acceleration_part_.segment(begin, count) = (s * s) * acceleration_rise_.segment(begin, count);
      parts_.peaks.take(
          static_cast<std::size_t>(b),
          {at(from_.q), at(now_.q), at(from_acceleration_), at(now_acceleration_), at(part_), at(acceleration_part_)},
          {c.data() + begin, system_->size, course.degree, course.h, s});
      ++steps_;
    }
    from_.q.segment(begin, count) = now_.q.segment(begin, count);
    from_.v.segment(begin, count) = now_.v.segment(begin, count);
  }
}

/// Finds which of some bodies, all of some islands, contacts with a force join now. Each is known by one of its bodies.
void Islands::gather_islands(const std::vector<Index>& bodies) {
  for (const Index b : bodies) {
    islands_[island_[b]].clear();
    island_[b] = -1;
  }
  for (const Index first : bodies) {
    if (island_[first] >= 0) continue;
    std::vector<Index>& members = islands_[first];
    members = {first};
    island_[first] = first;
    for (std::size_t n = 0; n < members.size(); ++n) {
      for (const std::size_t p : of_body_[members[n]]) {
        const Pair& pair = pairs_[p];
        const Index other = pair.left == members[n] ? pair.right : pair.left;
        if (island_[other] >= 0) continue;
        if (std::none_of(pair.contacts.begin(), pair.contacts.end(), [&](Index i) { return presses(i); })) continue;
        island_[other] = first;
        members.push_back(other);
      }
    }
    std::sort(members.begin(), members.end());
  }
}

/// A power series for an island, from from_ on; false where it is not finite.
bool Islands::expand(const std::vector<Index>& bodies, double time) {
  const double left = length_ - time;
  if (!(left > 0.0)) {
    for (const Index b : bodies) courses_[b] = {time, 0.0, courses_[b].degree, courses_[b].version + 1};
    return true;
  }
  std::vector<Index> pressing;
  for (const Index b : bodies) {
    for (const std::size_t p : of_body_[b]) {
      if (pairs_[p].left != b) continue;
      for (const Index i : pairs_[p].contacts) {
        if (presses(i)) pressing.push_back(i);
      }
    }
  }
  std::sort(pressing.begin(), pressing.end());
  const auto& linear = parts_.elements.forces_.linear;
  const double rate = system_->rate(bodies, pressing, linear);
  double h = series_reach / rate;
  if (h >= left * (1.0 - whole_slack)) h = left;
  std::vector<GroundInput>& inputs = inputs_at_;
  const Index ways = system_->components();
  for (const Index b : bodies) {
    std::copy_n(inputs_.data() + b * ways, ways, inputs.data() + b * ways);
    system_->advance(inputs.data() + b * ways, time);
  }
  series_.expand_some(bodies, from_, inputs, h, rate, pressing, linear, motion_);
  const Eigen::MatrixXd& c = std::as_const(motion_).coefficients();
  const int degree = motion_.degree();
  double sum = 0.0;
  for (const Index b : bodies) {
    const Index begin = block(b).begin, count = block(b).padded_size;
    const auto at = [begin](auto& x) { return x.data() + begin; };
    sum += kernels::end_of_step(count, at(c), system_->size, degree, h, {at(to_.q), at(to_.v), at(to_acceleration_)},
                                at(rise_), at(acceleration_rise_));
    kernels::bound(count, at(c), system_->size, degree, 1.0, 1.0, 1.0, at(bend_), at(fourth_));
    from_acceleration_.segment(begin, count) = (2.0 / (h * h)) * c.col(2).segment(begin, count);
    courses_[b] = {time, h, degree, courses_[b].version + 1};
  }
  if (h < left) queue_.push({time + h, -1 - bodies.front(), 0, courses_[bodies.front()].version});
  return std::isfinite(sum);
}

std::vector<Islands::Pair*> Islands::pairs_of(const std::vector<Index>& bodies) {
  ++stamp_;
  std::vector<Pair*> found;
  for (const Index b : bodies) {
    for (const std::size_t p : of_body_[b]) {
      if (stamps_[p] == stamp_) continue;
      stamps_[p] = stamp_;
      found.push_back(&pairs_[p]);
    }
  }
  return found;
}

/// All bodies of the islands of these.
std::vector<Index> Islands::islands_of(std::initializer_list<Index> bodies) const {
  std::vector<Index> all;
  for (const Index b : bodies) {
    if (std::find(all.begin(), all.end(), b) != all.end()) continue;
    const std::vector<Index>& more = islands_[island_[b]];
    all.insert(all.end(), more.begin(), more.end());
  }
  return all;
}

/// New series for the islands that some bodies are now, from from_ on.
bool Islands::go_on_from(const std::vector<Index>& bodies, double time) {
  gather_islands(bodies);
  for (const Index b : bodies) {
    std::vector<Index>& members = islands_[island_[b]];
    if (island_[b] == b && !expand(members, time)) return false;
  }
  for (Pair* pair : pairs_of(bodies)) open(*pair, time);
  return true;
}

/// Ends the series of some islands, and all that is looked at of them, and goes on from there.
bool Islands::renew(const std::vector<Index>& bodies, double time) {
  for (const Index b : bodies) place(b, time, now_);
  for (Pair* pair : pairs_of(bodies)) {
    place(pair->left, time, now_);
    place(pair->right, time, now_);
    close(*pair, time);
  }
  close(bodies, time);
  return go_on_from(bodies, time);
}

/// What follows from the next event; false where a number is not finite.
bool Islands::change(const Next& next) {
  Elements& elements = parts_.elements;
  const double time = next.time;
  if (next.element < 0) return renew(islands_of({-1 - next.element}), time);
  Pair& pair = pairs_[pair_of_[next.element]];
  place(pair.left, time, now_);
  place(pair.right, time, now_);
  close(pair, time);
  std::vector<ElementForces::Linear> before;
  for (const Index i : pair.contacts) before.push_back(elements.forces_.linear[i]);
  // Inputs count for elements of more deformations alone, of which there are none.
  elements.change({next.element, next.guard, 1.0}, start_ + time, inputs_, now_);
  served_ = served_ && is_served(pair);
  bool changed = false;
  for (std::size_t n = 0; n < before.size(); ++n) {
    const ElementForces::Linear& now = elements.forces_.linear[pair.contacts[n]];
    changed = changed || now.base != before[n].base || now.stiffness != before[n].stiffness ||
              now.damping != before[n].damping;
  }
  if (!changed) {
    open(pair, time);
    return true;
  }
  pair.length = 0.0;  // it is closed
  return renew(islands_of({pair.left, pair.right}), time);
}

/// Takes in all that is under way.
void Islands::end_here(double time, State& state) {
  std::vector<Index> all(courses_.size());
  for (Index b = 0; b < std::ssize(all); ++b) {
    all[b] = b;
    place(b, std::min(time, courses_[b].end()), now_);
  }
  for (Pair& pair : pairs_) close(pair, time);
  close(all, time);
  state.q = from_.q;
  state.v = from_.v;
}

double Islands::pass(double start, double length, const std::vector<GroundInput>& inputs, State& state) {
  Elements& elements = parts_.elements;
  const ElementForces& forces = elements.forces_;
  if (!forces.nonlinear.empty() || !forces.resting.empty() || forces.fading != 0.0) return 0.0;
  elements.by_islands_ = true;
  served_ = true;
  start_ = start;
  length_ = length;
  inputs_ = inputs;
  inputs_at_.resize(inputs.size());
  from_ = state;
  queue_ = {};
  islands_.assign(courses_.size(), {});
  std::vector<Index> all(courses_.size());
  for (Index b = 0; b < std::ssize(all); ++b) {
    all[b] = island_[b] = b;
    courses_[b].start = courses_[b].h = 0.0;
  }
  bool finite = go_on_from(all, 0.0);
  double reached = length;
  long changes = 0;
  while (finite && !queue_.empty() && queue_.top().time <= length_) {
    const Next next = queue_.top();
    queue_.pop();
    const long version = next.element < 0 ? courses_[-1 - next.element].version : versions_[next.element];
    if (next.version != version) continue;
    parts_.before(start_ + next.time);
    if (!parts_.go_on() || ++changes > most_changes * std::ssize(courses_)) break;
    finite = change(next);
    if (!served_) {
      reached = next.time;
      break;
    }
  }
  const bool stuck = changes > most_changes * std::ssize(courses_);
  if (finite && !stuck) {
    parts_.before(start_ + reached);
    end_here(reached, state);
  }
  elements.by_islands_ = false;
  elements.gather(state);
  return finite && !stuck ? reached : -1.0;
}

}  // namespace bentur::engine
