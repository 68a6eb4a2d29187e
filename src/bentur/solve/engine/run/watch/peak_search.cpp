#include "bentur/solve/engine/run/watch/peak_search.h"

#include <algorithm>

namespace bentur::engine {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

constexpr Index most_kept = 1 << 21;  // numbers: when there are more, it is time to look into what is unsettled
constexpr int parts_of_step = 8;      // at whose ends a step is looked at
constexpr Index few_quantities = 4;   // that are searched at once

VectorXd zeros(Index size) { return VectorXd::Zero(size); }

}  // namespace

PeakSearch::PeakSearch(const ModalSystem& system)
    : system_(&system),
      watch_(system),
      state_{zeros(system.size), zeros(system.size)},
      rise_(zeros(system.size)),
      acceleration_rise_(zeros(system.size)),
      slopes_(system.size, 4) {}

/// Reserves `count` numbers in kept_; returns where they begin.
Index PeakSearch::claim(Index count) {
  const Index at = kept_count_;
  kept_count_ += count;
  if (kept_count_ > kept_.size()) kept_.conservativeResize(2 * kept_count_);
  return at;
}

void PeakSearch::keep(const double* x, Index count) {
  const Index at = claim(count);
  std::copy_n(x, count, kept_.data() + at);
}

void PeakSearch::take(const StepBuffer& buffer) {
  if (buffer.size() == 0) return;
  for (std::size_t b = 0; b < system_->blocks.size(); ++b) {
    const Index begin = system_->blocks[b].begin;
    watch_.raise(b, buffer);
    before_.resize(watch_.quantities(b));
    for (Index n = watch_.next_unsettled(b, 0, before_.data()); n < buffer.size();
         n = watch_.next_unsettled(b, n + 1, before_.data())) {
      const Index at = claim(watch_.quantities(b));
      const PeakWatch::Interval interval{buffer.q(n) + begin,
                                         buffer.q(n + 1) + begin,
                                         buffer.acceleration(n) + begin,
                                         buffer.acceleration(n + 1) + begin,
                                         buffer.rise(n) + begin,
                                         buffer.acceleration_rise(n) + begin};
      if (watch_.settled_by_bound(b, interval, before_.data(), kept_.data() + at)) {
        kept_count_ = at;
      } else if (const StepBuffer::Step& step = buffer.step(n); step.flights != nullptr) {
        UnsettledFlight flight{b, step.flights, step.halvings, {}, at};
        const Index components = system_->components();
        std::copy_n(buffer.inputs(n) + static_cast<Index>(b) * components, components, flight.inputs.begin());
        keep_flight(flight, buffer.q(n), buffer.v(n), buffer.acceleration(n), flights_);
      } else {
        keep_step(b, buffer.curves(system_->blocks[b], n), at);
      }
    }
  }
}

/// Whose reach has been kept.
void PeakSearch::keep_flight(const UnsettledFlight& flight, const double* q, const double* v,
                             const double* acceleration, std::vector<UnsettledFlight>& flights) {
  const auto& block = system_->blocks[flight.block];
  for (const double* x : {q, v, acceleration}) keep(x + block.begin, block.padded_size);
  flights.push_back(flight);
}

void PeakSearch::keep_step(std::size_t b, const Curves& curves, Index at) {
  const auto& block = system_->blocks[b];
  const Index kept = claim((curves.degree + 1) * block.padded_size);
  double* to = kept_.data() + kept;
  for (int k = 0; k <= curves.degree; ++k, to += block.padded_size) {
    std::copy_n(curves.c + k * curves.stride, block.padded_size, to);
  }
  steps_.push_back({b, curves.h, curves.end, curves.degree, at});
}

void PeakSearch::take(std::size_t b, const PeakWatch::Interval& ends, const Curves& step) {
  const Index at = claim(watch_.quantities(b));
  if (watch_.settled_by_bound(b, ends, watch_.unknown(), kept_.data() + at)) {
    kept_count_ = at;
  } else {
    keep_step(b, step, at);
  }
}

void PeakSearch::take(const Approximate& step) {
  for (std::size_t b = 0; b < system_->blocks.size(); ++b) {
    const auto at = [begin = system_->blocks[b].begin](const VectorXd& x) { return x.data() + begin; };
    const PeakWatch::Interval ends{
        at(step.from.q),           at(step.to.q),          at(step.start_acceleration),
        at(step.end_acceleration), at(step.motion.rise()), at(step.motion.acceleration_rise())};
    const Index reach = claim(watch_.quantities(b));
    if (!watch_.settled_by_bound(b, ends, watch_.unknown(), kept_.data() + reach)) {
      watch_.scan(b, step.motion.curves(system_->blocks[b], step.end), kept_.data() + reach);
    }
    kept_count_ = reach;
  }
}

bool PeakSearch::much_is_unsettled() const { return kept_count_ >= most_kept; }

/// Goes over a flight, and returns whether cubics show that its reach stays below the peaks.
bool PeakSearch::settled_by_cubics(const UnsettledFlight& flight, const Place& from, const double* before, Place& to,
                                   double* reach, const Tools& tools) {
  const Flight& by = (*flight.flights)[flight.halvings];
  by.advance(flight.block, flight.inputs.data(),
             {from.q.data(), from.v.data(), to.q.data(), to.v.data(), to.acceleration.data(), rise_.data(),
              acceleration_rise_.data(), tools.load});
  const auto slope = [this](Index n) { return slopes_.col(n).data(); };
  by.fit_cubics(
      flight.block, flight.inputs.data(),
      {from.q.data(), from.v.data(), from.acceleration.data(), to.q.data(), to.v.data(), to.acceleration.data(),
       rise_.data(), acceleration_rise_.data(), slope(0), slope(1), slope(2), slope(3)});
  const auto curves = [&, begin = system_->blocks[flight.block].begin](const VectorXd& start, const VectorXd& end,
                                                                       Index n, const VectorXd& rise) {
    return kernels::CubicCurves{start.data() + begin, end.data() + begin, slope(n) + begin, slope(n + 1) + begin,
                                rise.data() + begin};
  };
  return watch_.settled_by_cubics(flight.block, curves(from.q, to.q, 0, rise_),
                                  curves(from.acceleration, to.acceleration, 2, acceleration_rise_), before, reach);
}

/// Halves a flight, whose reach is known, until bounds settle its parts, or it cannot be halved any more.
void PeakSearch::halve(const UnsettledFlight& flight, const Place& from, const double* before, Tools& tools) {
  const std::size_t n = flight.halvings + 1;
  const std::size_t b = flight.block;
  const double length = (*flight.flights)[n].length();
  Halving& at = halvings_[n];
  UnsettledFlight part{b, flight.flights, n, flight.inputs, 0};
  const Place* start = &from;
  for (Place* end : {&at.middle, &at.end}) {
    if (!tools.go_on(1)) return;
    if (!settled_by_cubics(part, *start, before, *end, at.reach.data(), tools)) {
      if (n + 1 < flight.flights->size()) {
        halve(part, *start, at.reach.data(), tools);
      } else {
        part.at = claim(watch_.quantities(b));
        std::copy_n(at.reach.data(), watch_.quantities(b), kept_.data() + part.at);
        keep_flight(part, start->q.data(), start->v.data(), start->acceleration.data(), parts_);
        if (kept_count_ - tools.mark >= most_kept) {  // of a mode so fast that one flight has so many parts
          look_into_parts(tools, false);
          look_into_parts(tools, true);
          kept_count_ = tools.mark;
        }
      }
    }
    start = end;
    system_->advance(part.inputs.data(), length);
  }
}

/// What cubics leave of a whole flight; where it cannot be halved, it is kept.
void PeakSearch::halve_whole(const UnsettledFlight& flight, Tools& tools) {
  const auto& block = system_->blocks[flight.block];
  const Index quantities = watch_.quantities(flight.block);
  while (halvings_.size() < flight.flights->size()) {
    const Place place{zeros(system_->size), zeros(system_->size), zeros(system_->size)};
    halvings_.push_back({place, place, {}});
  }
  for (Halving& halving : halvings_) halving.reach.resize(std::max(halving.reach.size(), quantities));
  // The whole is halving 0: its start and reach are out of the way of kept_, which may grow.
  Halving& whole = halvings_.front();
  double* kept = kept_.data() + flight.at;
  std::copy_n(kept, quantities, whole.reach.data());
  kept += quantities;
  for (VectorXd* x : {&whole.end.q, &whole.end.v, &whole.end.acceleration}) {
    std::copy_n(kept, block.padded_size, x->data() + block.begin);
    kept += block.padded_size;
  }
  tools.load = system_->load_of(flight.block, whole.end.q.data(), load_);
  if (settled_by_cubics(flight, whole.end, whole.reach.data(), whole.middle, whole.reach.data(), tools)) return;
  if (flight.halvings + 1 < flight.flights->size()) return halve(flight, whole.end, whole.reach.data(), tools);
  std::copy_n(whole.reach.data(), quantities, kept_.data() + flight.at);
  parts_.push_back(flight);
}

Curves PeakSearch::curves(const UnsettledFlight& flight, Series& series, Expansion& motion) {
  const auto& block = system_->blocks[flight.block];
  const double* kept = kept_.data() + flight.at + watch_.quantities(flight.block);
  std::copy_n(kept, block.padded_size, state_.q.data() + block.begin);
  std::copy_n(kept + block.padded_size, block.padded_size, state_.v.data() + block.begin);
  series.expand_block(flight.block, state_, flight.inputs.data(), (*flight.flights)[flight.halvings].length(),
                      std::max(block.rate(), system_->fastest_input()), motion);
  return motion.curves(block);
}

Curves PeakSearch::curves(const UnsettledStep& step) const {
  return {kept_.data() + step.at + watch_.quantities(step.block), system_->blocks[step.block].padded_size, step.degree,
          step.h, step.end};
}

/// By samples, which raise all peaks nearly to where they belong, or by a search of what is unsettled even then.
template <class Unsettled, class CurvesOf>
void PeakSearch::look_into(std::vector<Unsettled>& intervals, const CurvesOf& curves_of, bool search) {
  std::erase_if(intervals, [&](const auto& interval) {
    const std::size_t b = interval.block;
    double* reach = kept_.data() + interval.at;
    const Index unsettled = watch_.count_unsettled(b, reach);
    if (unsettled == 0) return true;
    const Curves step = curves_of(interval);
    if (!search && unsettled > few_quantities) {
      return watch_.settled_by_samples(b, step, parts_of_step, reach, reach);
    }
    watch_.scan(b, step, reach);
    return true;
  });
}

void PeakSearch::look_into_parts(Tools& tools, bool search) {
  look_into(
      parts_, [&](const UnsettledFlight& part) { return curves(part, tools.series, tools.motion); }, search);
}

void PeakSearch::settle(Series& series, Expansion& motion, const GoOn& go_on) {
  const auto step_curves = [&](const UnsettledStep& step) { return curves(step); };
  Tools tools{series, motion, go_on, kept_count_, nullptr};
  look_into(steps_, step_curves, false);
  for (const UnsettledFlight& flight : flights_) {
    if (watch_.count_unsettled(flight.block, kept_.data() + flight.at) > 0) halve_whole(flight, tools);
  }
  look_into_parts(tools, false);
  look_into(steps_, step_curves, true);
  look_into_parts(tools, true);
  flights_.clear();
  parts_.clear();
  steps_.clear();
  kept_count_ = 0;
}

}  // namespace bentur::engine
