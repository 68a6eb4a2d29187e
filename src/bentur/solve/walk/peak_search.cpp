#include "bentur/solve/walk/peak_search.h"

#include <algorithm>

#include "bentur/solve/motion/kernels/series.h"

namespace bentur::engine {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

constexpr std::size_t most_open = 4096;  // flights and steps kept at a time
constexpr int few_parts = 4;             // of a step, at a first look
constexpr int many_parts = 8;            // at the last one
constexpr Index few_quantities = 4;      // that are searched at once

State state_of(Index size) { return {VectorXd::Zero(size), VectorXd::Zero(size)}; }

}  // namespace

PeakSearch::PeakSearch(const ModalSystem& system, kernels::Lumped& lumped)
    : system_(&system),
      lumped_(&lumped),
      watch_(system, lumped),
      state_(state_of(system.size)),
      rises_{VectorXd::Zero(system.size), VectorXd::Zero(system.size)},
      start_acceleration_(VectorXd::Zero(system.size)),
      end_acceleration_(VectorXd::Zero(system.size)) {}

/// Makes room for so many numbers in kept_; returns where.
Index PeakSearch::claim(Index count) {
  const Index at = kept_count_;
  kept_count_ += count;
  if (kept_count_ > kept_.size()) kept_.conservativeResize(2 * kept_count_);
  return at;
}

void PeakSearch::keep(Index at, const double* q, const double* v, Index count) {
  std::copy_n(q, count, kept_.data() + at);
  std::copy_n(v, count, kept_.data() + at + count);
}

void PeakSearch::recall(Index at, Index first, Index count) {
  std::copy_n(kept_.data() + at, count, state_.q.data() + first);
  std::copy_n(kept_.data() + at + count, count, state_.v.data() + first);
}

/// Whether a flight of one building stays below its peaks.
bool PeakSearch::settled(std::size_t b, const Flown& flown, PeakWatch::Open open, const double* before, double* reach) {
  const auto& block = system_->blocks[b];
  const Index begin = block.begin;
  if (open.accelerations) {
    const auto accelerate = [&](double value, const double* q, const double* v, VectorXd& result) {
      kernels::accelerate(block.room, system_->omega_squared.data() + begin, system_->two_sigma.data() + begin,
                          system_->gamma.data() + begin, value, q + begin, v + begin, result.data() + begin);
    };
    accelerate(flown.value, flown.q, flown.v, start_acceleration_);
    accelerate(flown.end_value, flown.q_end, flown.v_end, end_acceleration_);
  }
  return watch_.settled_by_bound(
      b,
      {flown.q + begin, flown.q_end + begin, start_acceleration_.data() + begin, end_acceleration_.data() + begin,
       flown.rise + begin, flown.acceleration_rise + begin},
      open, before, reach);
}

/// Takes in what is open of a flight; keeps it where bounds do not settle it.
void PeakSearch::take(std::size_t b, const Flown& flown, PeakWatch::Open open, const double* before,
                      const OpenFlight& flight) {
  const auto& block = system_->blocks[b];
  const Index quantities = watch_.quantities(b);
  const Index at = claim(quantities + 2 * block.room);
  if (settled(b, flown, open, before, kept_.data() + at)) {
    kept_count_ = at;
    return;
  }
  keep(at + quantities, flown.q + block.begin, flown.v + block.begin, block.room);
  flights_.push_back(flight);
  flights_.back().at = at;
}

void PeakSearch::take_course(const Course& course) {
  for (std::size_t b = 0; b < system_->blocks.size(); ++b) {
    watch_.raise(b, course);
    before_.resize(watch_.quantities(b));
    for (Index n = 0; n < course.legs(); ++n) {
      const PeakWatch::Open open = watch_.open(b, course, n, before_.data());
      if (open.none()) continue;
      const kernels::FlightInput& input = course.input(n, b);
      take(b,
           {course.q(n), course.v(n), course.q(n + 1), course.v(n + 1), course.rise(n), course.acceleration_rise(n),
            input.value, input.end},
           open, before_.data(), {b, &course.flights(n), 0, {input.value, input.slope}, 0});
    }
  }
}

void PeakSearch::take_flight(const Flights& flights, std::size_t halvings, const Interval& interval,
                             const kernels::Rises& rises, const std::vector<kernels::Sums>& sums) {
  for (std::size_t b = 0; b < sums.size(); ++b) {
    const PeakWatch::Open open = watch_.open(b, sums[b]);
    if (open.none()) continue;
    take(b,
         {interval.from.q.data(), interval.from.v.data(), interval.to.q.data(), interval.to.v.data(),
          rises.position.data(), rises.acceleration.data(), interval.inputs[b].value, interval.end_inputs[b].value},
         open, watch_.unknown(), {b, &flights, halvings, interval.inputs[b], 0});
  }
}

void PeakSearch::take_step(const Expansion& motion, double cut, const Interval& interval, const ContactForces& forces,
                           long changes) {
  const double chord = cut * cut / 8.0;
  const double rate = 1.0 / (motion.h() * motion.h());
  bool first = true;
  Index start = 0;
  for (std::size_t b = 0; b < system_->blocks.size(); ++b) {
    const auto& block = system_->blocks[b];
    const auto at = [&block](const VectorXd& x) { return x.data() + block.begin; };
    const auto part = [&block](VectorXd& x) { return x.segment(block.begin, block.room); };
    const double* curved = motion.coefficients().col(2).data() + block.begin;
    const kernels::Stretch stretch{interval.from.q.data(),
                                   interval.to.q.data(),
                                   motion.coefficients().col(2).data(),
                                   motion.curved().data(),
                                   motion.curvature().data(),
                                   motion.fourth_derivative().data(),
                                   cut,
                                   motion.h()};
    const PeakWatch::Open open = watch_.open(b, kernels::sum_up({block.begin, block.room}, stretch, *lumped_));
    if (open.none()) continue;
    part(start_acceleration_) = 2.0 * rate * Eigen::Map<const VectorXd>(curved, block.room);
    part(end_acceleration_) = rate * Eigen::Map<const VectorXd>(at(motion.curved()), block.room);
    part(rises_.position) = chord * Eigen::Map<const VectorXd>(at(motion.curvature()), block.room);
    part(rises_.acceleration) = chord * rate * Eigen::Map<const VectorXd>(at(motion.fourth_derivative()), block.room);
    const Index reach = claim(watch_.quantities(b));
    if (watch_.settled_by_bound(b,
                                {at(interval.from.q), at(interval.to.q), at(start_acceleration_), at(end_acceleration_),
                                 at(rises_.position), at(rises_.acceleration)},
                                open, watch_.unknown(), kept_.data() + reach) ||
        watch_.settled_by_samples(b, motion, cut, few_parts, kept_.data() + reach, kept_.data() + reach)) {
      kept_count_ = reach;
      continue;
    }
    if (first) {
      start = claim(2 * system_->size);
      keep(start, interval.from.q.data(), interval.from.v.data(), system_->size);
      kept_inputs_.insert(kept_inputs_.end(), interval.inputs.begin(), interval.inputs.end());
      keep_forces(forces, changes);
    }
    first = false;
    steps_.push_back({b, cut * motion.h(), start, reach, kept_inputs_.size() - interval.inputs.size(), last_forces_,
                      kept_forces_.size()});
  }
}

void PeakSearch::take_approximate_step(const Expansion& motion, double cut, const Interval& interval,
                                       const VectorXd& start_acceleration, const VectorXd& end_acceleration) {
  const double chord = cut * cut / 8.0;
  rises_.position = chord * motion.curvature();
  rises_.acceleration = chord / (motion.h() * motion.h()) * motion.fourth_derivative();
  for (std::size_t b = 0; b < system_->blocks.size(); ++b) {
    const auto at = [begin = system_->blocks[b].begin](const VectorXd& x) { return x.data() + begin; };
    const PeakWatch::Interval ends{at(interval.from.q),  at(interval.to.q),   at(start_acceleration),
                                   at(end_acceleration), at(rises_.position), at(rises_.acceleration)};
    const Index reach = claim(watch_.quantities(b));
    if (!watch_.settled_by_bound(b, ends, {}, watch_.unknown(), kept_.data() + reach)) {
      watch_.scan(b, motion, kept_.data() + reach);
    }
    kept_count_ = reach;
  }
}

bool PeakSearch::much_is_open() const { return flights_.size() + steps_.size() >= most_open; }

/// Halves a flight, whose reach is known, until bounds settle its parts, or it cannot be halved any more.
void PeakSearch::halve(const OpenFlight& flight, const State& from, const double* before) {
  const std::size_t n = flight.halvings + 1;
  const std::size_t b = flight.block;
  const auto& block = system_->blocks[b];
  const Flight& half = (*flight.flights)[n];
  Halving& at = halvings_[n];
  OpenFlight part{b, flight.flights, n, flight.input, 0};
  const State* start = &from;
  for (State* to : {&at.middle, &at.end}) {
    const kernels::Sums sums = half.advance_block(b, *start, part.input, *lumped_, *to, rises_);
    GroundInput end_input = part.input;
    system_->advance(end_input, half.length());
    const PeakWatch::Open open = watch_.open(b, sums);
    const Flown flown{start->q.data(),  start->v.data(),        to->q.data(),
                      to->v.data(),     rises_.position.data(), rises_.acceleration.data(),
                      part.input.value, end_input.value};
    if (!open.none() && !settled(b, flown, open, before, at.reach.data())) {
      if (n + 1 < flight.flights->size()) {
        halve(part, *start, at.reach.data());
      } else {
        const Index quantities = watch_.quantities(b);
        part.at = claim(quantities + 2 * block.room);
        std::copy_n(at.reach.data(), quantities, kept_.data() + part.at);
        keep(part.at + quantities, start->q.data() + block.begin, start->v.data() + block.begin, block.room);
        parts_.push_back(part);
      }
    }
    start = to;
    part.input = end_input;
  }
}

void PeakSearch::expand(const OpenFlight& flight, Series& series, Expansion& motion) {
  const auto& block = system_->blocks[flight.block];
  recall(flight.at + watch_.quantities(flight.block), block.begin, block.room);
  series.expand_block(flight.block, state_, flight.input, (*flight.flights)[flight.halvings].length(), motion);
}

void PeakSearch::expand(const OpenStep& step, Series& series, Expansion& motion) {
  recall(step.start, 0, system_->size);
  const auto inputs = kept_inputs_.begin() + static_cast<std::ptrdiff_t>(step.inputs);
  inputs_.assign(inputs, inputs + static_cast<std::ptrdiff_t>(system_->blocks.size()));
  if (step.forces == step.forces_end) {
    series.expand_block(step.block, state_, inputs_[step.block], step.length, motion);
  } else {
    recall_forces(step);
    series.expand(state_, inputs_, step.length, forces_, motion);
  }
}

void PeakSearch::keep_forces(const ContactForces& forces, long changes) {
  if (kept_changes_ == changes) return;
  kept_changes_ = changes;
  last_forces_ = kept_forces_.size();
  for (const std::size_t i : forces.pressing) kept_forces_.push_back({i, false, forces.linear[i]});
  for (const std::size_t i : forces.resting) kept_forces_.push_back({i, true, {}});
}

void PeakSearch::recall_forces(const OpenStep& step) {
  forces_.pressing.clear();
  forces_.resting.clear();
  forces_.linear.resize(system_->points.size());
  for (std::size_t n = step.forces; n < step.forces_end; ++n) {
    const KeptForce& force = kept_forces_[n];
    (force.rests ? forces_.resting : forces_.pressing).push_back(force.point);
    forces_.linear[force.point] = force.linear;
  }
}

/// By bounds and samples first, which raise all peaks nearly to where they belong; what is then still open is searched.
void PeakSearch::settle(Series& series, Expansion& motion) {
  const auto look = [&](auto& open, bool search) {
    std::erase_if(open, [&](const auto& interval) {
      const std::size_t b = interval.block;
      const auto reach = [&] { return kept_.data() + interval.at; };
      const Index open_quantities = watch_.open(b, reach());
      if (open_quantities == 0) return true;
      expand(interval, series, motion);
      if (open_quantities <= few_quantities) {
        watch_.scan(b, motion, reach());
        return true;
      }
      (void)motion.bound();
      if (watch_.settled_by_samples(b, motion, 1.0, many_parts, reach(), reach())) return true;
      if (search) watch_.scan(b, motion, reach());
      return false;
    });
  };
  look(steps_, false);
  for (const OpenFlight& flight : flights_) {
    const Index quantities = watch_.quantities(flight.block);
    const auto& block = system_->blocks[flight.block];
    if (watch_.open(flight.block, kept_.data() + flight.at) == 0) continue;
    if (flight.halvings + 1 == flight.flights->size()) {
      parts_.push_back(flight);
      continue;
    }
    while (halvings_.size() < flight.flights->size()) {
      halvings_.push_back({state_of(system_->size), state_of(system_->size), {}});
    }
    for (Halving& halving : halvings_) halving.reach.resize(std::max(halving.reach.size(), quantities));
    // The whole is halving 0: its state and reach are out of the way of kept_, which may grow.
    Halving& whole = halvings_.front();
    std::copy_n(kept_.data() + flight.at, quantities, whole.reach.data());
    std::copy_n(kept_.data() + flight.at + quantities, block.room, whole.end.q.data() + block.begin);
    std::copy_n(kept_.data() + flight.at + quantities + block.room, block.room, whole.end.v.data() + block.begin);
    halve(flight, whole.end, whole.reach.data());
  }
  look(parts_, false);
  look(steps_, true);
  look(parts_, true);
  flights_.clear();
  parts_.clear();
  steps_.clear();
  kept_count_ = 0;
  kept_inputs_.clear();
  kept_forces_.clear();
  kept_changes_ = -1;
}

}  // namespace bentur::engine
