#include "bentur/solve/walk/peak_search.h"

#include <algorithm>

namespace bentur::engine {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

constexpr std::size_t most_open = 4096;  // flights and steps kept at a time
constexpr int few_parts = 4;             // of a step, at a first look
constexpr int many_parts = 8;            // at the last one

}  // namespace

PeakSearch::PeakSearch(const ModalSystem& system, PeakWatch::Scope scope)
    : system_(&system),
      watch_(system, scope),
      state_{VectorXd::Zero(system.size), VectorXd::Zero(system.size)},
      bounds_(Flight::make_bounds(system.size)),
      start_acceleration_(VectorXd::Zero(system.size)),
      end_acceleration_(VectorXd::Zero(system.size)),
      rise_(VectorXd::Zero(system.size)),
      acceleration_rise_(VectorXd::Zero(system.size)) {}

std::size_t PeakSearch::keep(const double* q, const double* v, Index count) {
  const std::size_t place = kept_.size();
  kept_.insert(kept_.end(), q, q + count);
  kept_.insert(kept_.end(), v, v + count);
  return place;
}

std::size_t PeakSearch::keep_reach() {
  const std::size_t place = kept_.size();
  PeakWatch::append(reach_, kept_);
  return place;
}

/// Takes up what is known of an interval, and returns whether that has been settled since.
bool PeakSearch::recall(std::size_t block, std::size_t reach) {
  watch_.read(block, kept_.data() + reach, reach_);
  return watch_.settled(block, reach_);
}

/// Whether a flight of one building stays below its peaks. States and bounds by where its coordinates begin.
bool PeakSearch::settled(std::size_t b, const double* q, const double* v, const double* q_end, const double* v_end,
                         const GroundInput& input, const GroundInput& end_input, const Flight::Bounds& bounds) {
  const PeakWatch::Open open = watch_.open_at_once(b, bounds);
  if (!open.positions && !open.accelerations) return true;
  const auto& block = system_->blocks[b];
  const auto at = [&block](const VectorXd& x) { return x.data() + block.begin; };
  if (open.accelerations) {
    const auto accelerate = [&](double value, const double* from_q, const double* from_v, VectorXd& to) {
      kernels::accelerate(block.room, at(system_->omega_squared), at(system_->two_sigma), at(system_->gamma), value,
                          from_q, from_v, to.data() + block.begin);
    };
    accelerate(input.value, q, v, start_acceleration_);
    accelerate(end_input.value, q_end, v_end, end_acceleration_);
  }
  return watch_.settled_by_bound(
      b, {q, q_end, at(start_acceleration_), at(end_acceleration_), at(bounds.rise), at(bounds.acceleration_rise)},
      open, reach_);
}

void PeakSearch::take_flight(const Flights& flights, std::size_t halvings, const State& from,
                             const std::vector<GroundInput>& inputs, const State& to,
                             const std::vector<GroundInput>& end_inputs, const Flight::Bounds& bounds) {
  for (std::size_t b = 0; b < system_->blocks.size(); ++b) {
    const auto& block = system_->blocks[b];
    const double* q = from.q.data() + block.begin;
    const double* v = from.v.data() + block.begin;
    watch_.forget(b, reach_);
    if (settled(b, q, v, to.q.data() + block.begin, to.v.data() + block.begin, inputs[b], end_inputs[b], bounds)) {
      continue;
    }
    const std::size_t start = keep(q, v, block.room);
    flights_.push_back({b, &flights, halvings, inputs[b], start, keep_reach()});
  }
}

void PeakSearch::take_step(const Expansion& motion, double cut, const State& from,
                           const std::vector<GroundInput>& inputs, const ContactForces& forces, long changes) {
  bool first = true;
  std::size_t start = 0;
  for (std::size_t b = 0; b < system_->blocks.size(); ++b) {
    watch_.forget(b, reach_);
    if (watch_.settled_by_samples(b, motion, cut, few_parts, reach_)) continue;
    if (first) {
      start = keep(from.q.data(), from.v.data(), system_->size);
      kept_inputs_.insert(kept_inputs_.end(), inputs.begin(), inputs.end());
      if (kept_forces_.empty() || kept_changes_ != changes) kept_forces_.push_back(forces);
      kept_changes_ = changes;
    }
    first = false;
    steps_.push_back(
        {b, cut * motion.h(), start, kept_inputs_.size() - inputs.size(), kept_forces_.size() - 1, keep_reach()});
  }
}

void PeakSearch::take_approximate_step(const Expansion& motion, double cut, const State& from, const State& to,
                                       const VectorXd& start_acceleration, const VectorXd& end_acceleration) {
  const PeakWatch::Open everything{true, watch_.scope() == PeakWatch::Scope::everything};
  const double chord = cut * cut / 8.0;
  rise_ = chord * motion.curvature();
  acceleration_rise_ = chord / (motion.h() * motion.h()) * motion.fourth_derivative();
  for (std::size_t b = 0; b < system_->blocks.size(); ++b) {
    const auto at = [begin = system_->blocks[b].begin](const VectorXd& x) { return x.data() + begin; };
    const PeakWatch::Interval interval{at(from.q),           at(to.q),  at(start_acceleration),
                                       at(end_acceleration), at(rise_), at(acceleration_rise_)};
    watch_.forget(b, reach_);
    if (!watch_.settled_by_bound(b, interval, everything, reach_)) watch_.scan(b, motion, reach_);
  }
}

bool PeakSearch::much_is_open() const { return flights_.size() + steps_.size() >= most_open; }

/// Halves a flight, whose reach is known, until bounds settle its parts, or it cannot be halved any more.
void PeakSearch::halve(const OpenFlight& flight, const double* q, const double* v) {
  const std::size_t n = flight.halvings + 1;
  const std::size_t b = flight.block;
  const Flight& half = (*flight.flights)[n];
  const Index room = system_->blocks[b].room;
  if (at_.size() < 4 * (n + 1)) at_.resize(4 * (n + 1));
  if (whole_.size() <= n) whole_.resize(n + 1);
  whole_[n] = reach_;
  GroundInput input = flight.input;
  for (std::size_t part = 0; part < 2; ++part) {
    VectorXd& q_end = at_[4 * n + 2 * part];
    VectorXd& v_end = at_[4 * n + 2 * part + 1];
    q_end.resize(room);
    v_end.resize(room);
    reach_ = whole_[n];
    half.advance_block(b, q, v, input, q_end.data(), v_end.data(), bounds_);
    GroundInput end_input = input;
    system_->advance(end_input, half.length());
    if (!settled(b, q, v, q_end.data(), v_end.data(), input, end_input, bounds_)) {
      OpenFlight open{b, flight.flights, n, input, 0, 0};
      if (n + 1 < flight.flights->size()) {
        halve(open, q, v);
      } else {
        open.start = keep(q, v, room);
        open.reach = keep_reach();
        parts_.push_back(open);
      }
    }
    q = at_[4 * n + 2 * part].data();  // where they are after at_ has grown
    v = at_[4 * n + 2 * part + 1].data();
    input = end_input;
  }
}

void PeakSearch::expand(const OpenFlight& flight, Series& series, Expansion& motion) {
  const auto& block = system_->blocks[flight.block];
  const double* start = kept_.data() + flight.start;
  std::copy_n(start, block.room, state_.q.data() + block.begin);
  std::copy_n(start + block.room, block.room, state_.v.data() + block.begin);
  series.expand_block(flight.block, state_, flight.input, (*flight.flights)[flight.halvings].length(), motion);
}

void PeakSearch::expand(const OpenStep& step, Series& series, Expansion& motion) {
  const auto all = static_cast<std::size_t>(system_->size);
  const auto inputs = kept_inputs_.begin() + static_cast<std::ptrdiff_t>(step.inputs);
  std::copy_n(kept_.data() + step.start, all, state_.q.data());
  std::copy_n(kept_.data() + step.start + all, all, state_.v.data());
  inputs_.assign(inputs, inputs + static_cast<std::ptrdiff_t>(system_->blocks.size()));
  if (kept_forces_[step.forces].none()) {
    series.expand_block(step.block, state_, inputs_[step.block], step.length, motion);
  } else {
    series.expand(state_, inputs_, step.length, kept_forces_[step.forces], motion);
  }
}

/// By bounds and samples first, which raise all peaks nearly to where they belong; what is then still open is searched.
void PeakSearch::settle(Series& series, Expansion& motion) {
  const auto look = [&](auto& open, bool search) {
    std::erase_if(open, [&](auto& interval) {
      if (recall(interval.block, interval.reach)) return true;
      expand(interval, series, motion);
      (void)motion.bound();
      if (watch_.settled_by_samples(interval.block, motion, 1.0, many_parts, reach_)) return true;
      interval.reach = keep_reach();
      if (search) watch_.scan(interval.block, motion, reach_);
      return false;
    });
  };
  look(steps_, false);
  for (const OpenFlight& flight : flights_) {
    if (recall(flight.block, flight.reach)) continue;
    if (flight.halvings + 1 == flight.flights->size()) {
      parts_.push_back(flight);
      continue;
    }
    const auto room = static_cast<std::size_t>(system_->blocks[flight.block].room);
    const auto start = kept_.begin() + static_cast<std::ptrdiff_t>(flight.start);
    start_.assign(start, start + static_cast<std::ptrdiff_t>(2 * room));
    halve(flight, start_.data(), start_.data() + room);
  }
  look(parts_, false);
  look(steps_, true);
  look(parts_, true);
  flights_.clear();
  parts_.clear();
  steps_.clear();
  kept_.clear();
  kept_inputs_.clear();
  kept_forces_.clear();
}

}  // namespace bentur::engine
