#include "bentur/solve/engine/run/tracer.h"

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>

namespace bentur::engine {

using Eigen::Index;
using Course = Outputs::Course;

namespace {

constexpr int free_parts = 4;                // of a step, looked at before it is halved further
constexpr int contact_parts = 16;            // likewise while something presses
constexpr int most_halvings = 8;             // of such a part
constexpr double penetration_noise = 1e-12;  // of a penetration, over displacements
constexpr std::size_t longest_wait = 256;
constexpr double first_room = 4e6;    // numbers kept before the bound grows: 32 MB
constexpr double no_time = 0x1p-46;   // of the duration: what is over so soon has not been
constexpr double least_scale = 0.01;  // of the largest scale

}  // namespace

Tracer::Tracer(const ModalSystem& system, const System& given, const std::vector<double>& offsets, const Solution& free,
               const std::vector<double>& openings)
    : system_(&system),
      duration_(given.duration),
      offsets_(offsets),
      points_(system.points()),
      others_(2 * system.joints),
      room_(first_room) {
  for (const auto& block : system.blocks) {
    for (const auto& group : block.outputs) {
      if (group.course == Course::followed) followed_ += group.count();
      if (group.course == Course::along) others_ += group.count();
    }
  }
  scales_.setZero(followed_ + points_);
  Index row = 0;
  for (std::size_t b = 0; b < system.blocks.size(); ++b) {
    for (std::size_t k = 0; k < system.blocks[b].outputs.size(); ++k) {
      const auto& group = system.blocks[b].outputs[k];
      if (group.course != Course::followed) continue;
      scales_.segment(row, group.count()) = free.outputs[b][k].peak;
      row += group.count();
    }
  }
  for (Index i = 0; i < points_; ++i) scales_(followed_ + i) = openings[static_cast<std::size_t>(i)];
  const double largest = scales_.size() > 0 ? scales_.maxCoeff() : 0.0;
  scales_ = scales_.cwiseMax(largest > 0.0 ? least_scale * largest : 1.0);
  forces_met_.setZero(points_);
  state_.q.setZero(system.size);
  state_.v.setZero(system.size);
}

void Tracer::evaluate(const Step& step, double s) {
  step.motion.evaluate(s, state_);
  inputs_ = step.inputs;
  system_->advance(inputs_, s * step.motion.h());
}

double Tracer::force(const Step& step, Index point, double s) {
  evaluate(step, s);
  step.elements.forces_at(state_, inputs_, forces_);
  return forces_(system_->opening(point));
}

double Tracer::speed(const Step& step, Index row, double s) {
  step.motion.evaluate(s, state_);
  if (row >= followed_) {
    return -system_->elements[system_->opening(row - followed_)].relation.along(state_.v);
  }
  for (const auto& block : system_->blocks) {
    for (const auto& group : block.outputs) {
      if (group.course != Course::followed) continue;
      if (row < group.count()) return group.of_position.row(row).dot(state_.v.segment(block.begin, block.size));
      row -= group.count();
    }
  }
  return 0.0;
}

Tracer::Instant Tracer::at(const Step& step, double s) {
  evaluate(step, s);
  step.elements.forces_at(state_, inputs_, forces_);
  Instant result{.s = s, .time = step.time + s * step.motion.h(), .values = {}, .speeds = {}};
  result.values.resize(followed_ + 2 * points_ + others_);
  result.speeds.resize(followed_ + points_);
  Index row = 0;
  Index extra = followed_ + 2 * points_;
  for (const auto& block : system_->blocks) {
    const auto q = state_.q.segment(block.begin, block.size);
    const auto v = state_.v.segment(block.begin, block.size);
    for (const auto& group : block.outputs) {
      if (group.course == Course::none) continue;
      const bool follows = group.course == Course::followed;
      Index& at = follows ? row : extra;
      group.evaluate(q, v, v, result.values.segment(at, group.count()));
      if (follows) result.speeds.segment(at, group.count()).noalias() = group.of_position * v;
      at += group.count();
    }
  }
  for (Index point = 0; point < points_; ++point) {
    const Index i = system_->opening(point);
    const auto& relation = system_->elements[i].relation;
    result.values(followed_ + point) = -offsets_[i] - relation.along(state_.q);
    result.speeds(followed_ + point) = -relation.along(state_.v);
    result.values(followed_ + points_ + point) = forces_(i);
  }
  for (Index i = 0; i < system_->joints; ++i) {
    result.values(extra++) = system_->elements[system_->joint(i)].relation.along(state_.q);
    result.values(extra++) = forces_(system_->joint(i));
  }
  return result;
}

bool Tracer::is_on_chord(const Instant& from, const Instant& one, const Instant& to) const {
  const double length = to.time - from.time;
  const double part = length > 0.0 ? (one.time - from.time) / length : 0.0;
  const auto away = [&](Index i) {
    return std::abs(one.values(i) - from.values(i) - part * (to.values(i) - from.values(i)));
  };
  for (Index i = 0; i < followed_ + points_; ++i) {
    if (away(i) > bound_ * scales_(i)) return false;
  }
  for (Index i = 0; i < points_; ++i) {
    const Index row = followed_ + points_ + i;
    const double deep = std::abs(one.values(followed_ + i));  // the force is no better known than the penetration
    const double noise =
        deep > 0.0 ? penetration_noise * scales_(followed_ + i) / deep * std::abs(one.values(row)) : 0.0;
    if (away(row) > bound_ / 4 * forces_met_(i) + noise) return false;
  }
  return true;
}

/// Adds what lies between two instants, and the second one.
void Tracer::halve(const Step& step, const Instant& from, const Instant& to, int depth, std::vector<Instant>& list) {
  Instant middle = at(step, 0.5 * (from.s + to.s));
  if (depth < most_halvings && !is_on_chord(from, middle, to)) {
    halve(step, from, middle, depth + 1, list);
    halve(step, middle, to, depth + 1, list);
    return;
  }
  list.push_back(std::move(middle));
  list.push_back(to);
}

/// Adds them to the instants of a step; they stay.
void Tracer::find_extrema(const Step& step, std::vector<Instant>& list) {
  std::vector<double> places;
  for (std::size_t n = 1; n < list.size(); ++n) {
    const Instant &a = list[n - 1], &b = list[n];
    for (Index i = 0; i < followed_ + points_; ++i) {
      const double before = a.speeds(i), after = b.speeds(i);
      if (!(before * after < 0.0)) continue;
      boost::uintmax_t most = 30;
      const auto root = boost::math::tools::toms748_solve([&](double s) { return speed(step, i, s); }, a.s, b.s, before,
                                                          after, boost::math::tools::eps_tolerance<double>(40), most);
      places.push_back(0.5 * (root.first + root.second));
    }
  }
  for (Index i = 0; i < points_; ++i) {
    const Index row = followed_ + points_ + i;
    const auto highest = std::max_element(
        list.begin(), list.end(), [&](const Instant& a, const Instant& b) { return a.values(row) < b.values(row); });
    if (!(highest->values(row) > 0.0)) continue;
    highest->stays = true;
    if (highest == list.begin() || std::next(highest) == list.end()) continue;
    boost::uintmax_t most = 60;
    const auto peak = boost::math::tools::brent_find_minima([&](double s) { return -force(step, i, s); },
                                                            std::prev(highest)->s, std::next(highest)->s, 26, most);
    places.push_back(peak.first);
    forces_met_(i) = std::max(forces_met_(i), -peak.second);
  }
  if (places.empty()) return;
  std::sort(places.begin(), places.end());
  places.erase(std::unique(places.begin(), places.end()), places.end());
  for (const double s : places) {
    Instant extremum = at(step, s);
    extremum.stays = true;
    list.push_back(std::move(extremum));
  }
  std::stable_sort(list.begin(), list.end(), [](const Instant& a, const Instant& b) { return a.s < b.s; });
}

void Tracer::take(const Expansion& motion, double time, double end, const std::vector<GroundInput>& inputs,
                  const Elements& elements) {
  if (!(end * motion.h() > no_time * duration_)) return;
  const Step step{motion, time, inputs, elements};
  std::vector<Instant> list = {at(step, 0.0)};
  const auto forces = [&](const Instant& one) { return one.values.segment(followed_ + points_, points_); };
  for (Index i = 0; i < points_; ++i) {
    if (forces(list.front())(i) == 0.0) forces_met_(i) = 0.0;
  }
  const auto presses = [&](const Instant& one) { return (forces(one).array() != 0.0).any(); };
  const int parts = presses(list.front()) || presses(at(step, 0.5 * end)) ? contact_parts : free_parts;
  std::vector<Instant> coarse = {list.front()};
  for (int n = 1; n <= parts; ++n) coarse.push_back(at(step, end * n / parts));
  for (const Instant& one : coarse) {
    scales_.head(followed_) = scales_.head(followed_).cwiseMax(one.values.head(followed_).cwiseAbs());
  }
  for (const Instant& one : coarse) forces_met_ = forces_met_.cwiseMax(forces(one).cwiseAbs());
  for (std::size_t n = 1; n < coarse.size(); ++n) halve(step, coarse[n - 1], coarse[n], 0, list);
  find_extrema(step, list);
  if (has_begun_) {  // where this step begins the last one has ended, but forces may have jumped
    Instant& first = list.front();
    const Instant& last = waiting_.empty() ? kept_ : waiting_.back();
    const bool jumps = points_ > 0 && (forces(first) - forces(last)).cwiseAbs().maxCoeff() >
                                          1e-9 * std::max(forces_met_.maxCoeff(), forces(last).cwiseAbs().maxCoeff());
    if (!jumps) {
      list.erase(list.begin());
    } else {
      changed();
      first.stays = true;
    }
  }
  for (Instant& one : list) {  // where steps meet their times differ by round-off
    latest_ = one.time = std::max(one.time, latest_);
    take(one);
  }
}

void Tracer::take(const Instant& one) {
  if (!has_begun_) {
    has_begun_ = true;
    keep(one);
    return;
  }
  const bool fits = waiting_.size() < longest_wait &&
                    std::all_of(waiting_.begin(), waiting_.end(),
                                [&](const Instant& waiting) { return is_on_chord(kept_, waiting, one); });
  if (!fits) {
    keep(waiting_.back());
    waiting_.clear();
  }
  if (one.stays) {
    keep(one);
    waiting_.clear();
  } else {
    waiting_.push_back(one);
  }
}

void Tracer::changed() {
  if (waiting_.empty()) return;
  keep(waiting_.back());
  waiting_.clear();
}

void Tracer::keep(const Instant& one) {
  times_.push_back(one.time);
  numbers_.insert(numbers_.end(), one.values.begin(), one.values.end());
  if (static_cast<double>(numbers_.size()) > room_) {
    bound_ *= 2;
    room_ *= 1.5;
  }
  kept_ = one;
}

void Tracer::finish(Solution& solution) {
  changed();
  Sampled& course = solution.course;
  course.time = std::move(times_);
  const Index count = std::ssize(course.time);
  if (count == 0) return;
  const Eigen::Map<const Eigen::MatrixXd> all(numbers_.data(), std::ssize(numbers_) / count, count);
  Index row = 0;
  Index extra = followed_ + 2 * points_;
  for (std::size_t b = 0; b < system_->blocks.size(); ++b) {
    for (std::size_t k = 0; k < system_->blocks[b].outputs.size(); ++k) {
      const auto& group = system_->blocks[b].outputs[k];
      if (group.course == Course::none) continue;
      Index& at = group.course == Course::followed ? row : extra;
      solution.outputs[b][k].course = all.middleRows(at, group.count());
      at += group.count();
    }
  }
  course.opening = all.middleRows(followed_, points_);
  course.force = all.middleRows(followed_ + points_, points_);
  const Index joints = system_->joints;
  course.joint_deformation = all(Eigen::seqN(extra, joints, Eigen::fix<2>), Eigen::all);
  course.joint_force = all(Eigen::seqN(extra + 1, joints, Eigen::fix<2>), Eigen::all);
}

}  // namespace bentur::engine
