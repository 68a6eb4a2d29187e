#include "bentur/solve/engine/run/tracer.h"

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>

namespace bentur::engine {

using Eigen::Index;

namespace {

constexpr int free_parts = 4;                // of a step, looked at before it is halved further
constexpr int contact_parts = 16;            // likewise while something presses
constexpr int most_halvings = 8;             // of such a part
constexpr double penetration_noise = 1e-12;  // of a penetration, over displacements
constexpr std::size_t longest_wait = 256;
constexpr double first_room = 4e6;    // numbers kept before the bound grows: 32 MB
constexpr double no_time = 0x1p-46;   // of the duration: what is over so soon has not been
constexpr double least_scale = 0.01;  // of the row's largest displacement

}  // namespace

Tracer::Tracer(const ModalSystem& system, const Problem& problem, const std::vector<BuildingPeaks>& peaks,
               const std::vector<double>& openings)
    : system_(&system), problem_(&problem), points_(system.switched), room_(first_room) {
  for (const auto& block : system.blocks) floors_ += block.floors;
  for (const Building& building : problem.buildings) {
    others_ += building.model.nodes() + (building.storeys_yield() ? 2 * building.model.floors() : 0) +
               (building.model.has_soil ? 4 : 0);
  }
  others_ += 2 * std::ssize(problem.links);
  scales_.setZero(floors_ + points_);
  Index row = 0;
  for (std::size_t b = 0; b < system.blocks.size(); ++b) {
    const Index floors = system.blocks[b].floors;
    scales_.segment(row, floors) = peaks[b].displacement_no_contact.head(floors);
    row += floors;
  }
  for (Index i = 0; i < points_; ++i) scales_(floors_ + i) = openings[static_cast<std::size_t>(i)];
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
  return forces_(point);
}

double Tracer::speed(const Step& step, Index row, double s) {
  step.motion.evaluate(s, state_);
  if (row >= floors_) return -system_->elements[row - floors_].relation.along(state_.v);
  for (const auto& block : system_->blocks) {
    if (row < block.floors) return block.outputs.row(row).dot(state_.v.segment(block.begin, block.size));
    row -= block.floors;
  }
  return 0.0;
}

Tracer::Instant Tracer::at(const Step& step, double s) {
  evaluate(step, s);
  step.elements.forces_at(state_, inputs_, forces_);
  Instant result{.s = s, .time = step.time + s * step.motion.h(), .values = {}, .speeds = {}};
  result.values.resize(floors_ + 2 * points_ + others_);
  result.speeds.resize(floors_ + points_);
  Index row = 0;
  Index extra = floors_ + 2 * points_;
  for (std::size_t b = 0; b < system_->blocks.size(); ++b) {
    const auto& block = system_->blocks[b];
    const auto q = state_.q.segment(block.begin, block.size);
    result.values.segment(row, block.floors) = block.outputs.topRows(block.floors) * q;
    result.speeds.segment(row, block.floors) =
        block.outputs.topRows(block.floors) * state_.v.segment(block.begin, block.size);
    row += block.floors;
    result.values.segment(extra, block.nodes.rows()) = block.nodes * q.head(block.modes);
    extra += block.nodes.rows();
    const Eigen::VectorXd foundation = block.foundation(state_);
    result.values.segment(extra, foundation.size()) = foundation;
    extra += foundation.size();
    if (!problem_->buildings[b].storeys_yield()) continue;
    result.values.segment(extra, 2 * block.floors) = block.outputs.middleRows(block.floors, 2 * block.floors) * q;
    extra += 2 * block.floors;
  }
  for (Index i = 0; i < points_; ++i) {
    const auto& relation = system_->elements[i].relation;
    result.values(floors_ + i) = problem_->points[i].width - relation.along(state_.q);
    result.speeds(floors_ + i) = -relation.along(state_.v);
    result.values(floors_ + points_ + i) = forces_(i);
  }
  for (Index i = 0; i < std::ssize(problem_->links); ++i) {
    result.values(extra++) = system_->elements[system_->link(i)].relation.along(state_.q);
    result.values(extra++) = forces_(system_->link(i));
  }
  return result;
}

bool Tracer::is_on_chord(const Instant& from, const Instant& one, const Instant& to) const {
  const double length = to.time - from.time;
  const double part = length > 0.0 ? (one.time - from.time) / length : 0.0;
  const auto away = [&](Index i) {
    return std::abs(one.values(i) - from.values(i) - part * (to.values(i) - from.values(i)));
  };
  for (Index i = 0; i < floors_ + points_; ++i) {
    if (away(i) > bound_ * scales_(i)) return false;
  }
  for (Index i = 0; i < points_; ++i) {
    const Index row = floors_ + points_ + i;
    const double deep = std::abs(one.values(floors_ + i));  // the force is no better known than the penetration
    const double noise = deep > 0.0 ? penetration_noise * scales_(floors_ + i) / deep * std::abs(one.values(row)) : 0.0;
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
    for (Index i = 0; i < floors_ + points_; ++i) {
      const double before = a.speeds(i), after = b.speeds(i);
      if (!(before * after < 0.0)) continue;
      boost::uintmax_t most = 30;
      const auto root = boost::math::tools::toms748_solve([&](double s) { return speed(step, i, s); }, a.s, b.s, before,
                                                          after, boost::math::tools::eps_tolerance<double>(40), most);
      places.push_back(0.5 * (root.first + root.second));
    }
  }
  for (Index i = 0; i < points_; ++i) {
    const Index row = floors_ + points_ + i;
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
  if (!(end * motion.h() > no_time * problem_->duration)) return;
  const Step step{motion, time, inputs, elements};
  std::vector<Instant> list = {at(step, 0.0)};
  const auto forces = [&](const Instant& one) { return one.values.segment(floors_ + points_, points_); };
  for (Index i = 0; i < points_; ++i) {
    if (forces(list.front())(i) == 0.0) forces_met_(i) = 0.0;
  }
  const auto presses = [&](const Instant& one) { return (forces(one).array() != 0.0).any(); };
  const int parts = presses(list.front()) || presses(at(step, 0.5 * end)) ? contact_parts : free_parts;
  std::vector<Instant> coarse = {list.front()};
  for (int n = 1; n <= parts; ++n) coarse.push_back(at(step, end * n / parts));
  for (const Instant& one : coarse) {
    scales_.head(floors_) = scales_.head(floors_).cwiseMax(one.values.head(floors_).cwiseAbs());
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

Histories Tracer::finish() {
  changed();
  Histories course;
  course.time = std::move(times_);
  const Index count = std::ssize(course.time);
  const Index rows = count > 0 ? std::ssize(numbers_) / count : 0;
  const Eigen::Map<const Eigen::MatrixXd> all(numbers_.data(), rows, count);
  Index row = 0;
  Index extra = floors_ + 2 * points_;
  for (std::size_t b = 0; b < system_->blocks.size() && count > 0; ++b) {
    const Index floors = system_->blocks[b].floors;
    course.displacement.emplace_back(all.middleRows(row, floors));
    row += floors;
    const Index nodes = system_->blocks[b].nodes.rows();
    course.node_displacement.emplace_back(all.middleRows(extra, nodes));
    extra += nodes;
    const Index foundation = system_->blocks[b].has_foundation ? 4 : 0;
    course.foundation.emplace_back(all.middleRows(extra, foundation));
    extra += foundation;
    course.drift_ratio.emplace_back();
    course.storey_shear.emplace_back();
    if (!problem_->buildings[b].storeys_yield()) continue;
    course.drift_ratio.back() = all.middleRows(extra, floors);
    course.storey_shear.back() = all.middleRows(extra + floors, floors);
    extra += 2 * floors;
  }
  if (count > 0) {
    course.opening = all.middleRows(floors_, points_);
    course.force = all.middleRows(floors_ + points_, points_);
    const Index links = std::ssize(problem_->links);
    course.link_deformation = all(Eigen::seqN(extra, links, Eigen::fix<2>), Eigen::all);
    course.link_force = all(Eigen::seqN(extra + 1, links, Eigen::fix<2>), Eigen::all);
  }
  return course;
}

}  // namespace bentur::engine
