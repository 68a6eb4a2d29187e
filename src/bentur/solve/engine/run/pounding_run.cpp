#include "bentur/solve/engine/run/pounding_run.h"

#include <algorithm>

namespace bentur::engine {
namespace {

constexpr long most_followed = 1 << 17;  // some seconds

}  // namespace

PoundingRun::PoundingRun(const Setup& setup, const Elements::Scales& scales, long first_contact,
                         const RunOptions& options)
    : Run(setup, 0, scales),
      first_contact_(first_contact),
      sampler_(system_, given_, setup.laws.offsets, options.output_step),
      momentum_(system_),
      keeps_changes_(options.changes) {
  const bool flies = std::holds_alternative<ExactSolver>(setup.solver) && !setup.plan.flights.front().empty();
  if (flies && !options.course && !options.energy_audit && !options.changes && Islands::serve(system_, setup.laws)) {
    go_by_islands(setup.laws);
  }
  if (!options.energy_audit) return;
  const double step =
      options.output_step > 0.0 && options.energy_step > 0.0 ? options.energy_step : options.output_step;
  energy_.emplace(system_, given_.duration, step, state_, elements_);
}

Eigen::Index PoundingRun::quiet(Eigen::Index count) {
  const Eigen::Index others = Run::quiet(count);
  if (segment() + others <= first_contact_) return others;
  const Eigen::Index before = std::max<Eigen::Index>(first_contact_ - segment(), 0);
  Eigen::Index apart = elements_.quiet(buffer_, count, 0, system_.switched);
  if (system_.rubbing > 0) {
    apart = std::min(apart, elements_.quiet(buffer_, count, system_.rubs, std::ssize(system_.elements)));
  }
  return std::min(others, std::max(before, apart));
}

void PoundingRun::take_step(double time, double cut) {
  sampler_.take(motion_, time, time + cut * motion_.h(), inputs_, elements_);
  follow(time, cut, inputs_);
  momentum_.take(motion_, cut, state_, elements_, event() && elements_.of_contact(*event()));
  if (energy_) energy_->take(motion_, time, cut, inputs_, elements_);
}

/// Takes [0, cut] of the expanded step, which began at `time`, into the course.
void PoundingRun::follow(double time, double cut, const std::vector<GroundInput>& inputs) {
  if (!tracer_) return;
  tracer_->take(motion_, time, cut, inputs, elements_);
  if (++followed_ > most_followed) tracer_.reset();
}

void PoundingRun::changed(double time) {
  if (keeps_changes_) {
    Change& change = changes_.emplace_back();
    change.element = event()->element;
    change.guard = event()->guard;
    change.time = time;
    if (change.element < elements_.count()) {
      change.before = before();
      change.after = elements_.law_state(change.element);
      const Meetings& meetings = elements_.meetings();
      change.passes = meetings.settles();
      change.shares = change.element < system_.switched && meetings.shares(change.element);
      for (const Eigen::Index one : meetings.slipped()) change.slipped.emplace_back(one, elements_.law_state(one));
    }
    for (const Elements::Jump& jump : elements_.jumps()) change.impulses.emplace_back(jump.element, jump.impulse);
    change.q = state_.q;
    change.v = state_.v;
  }
  if (tracer_) tracer_->changed();
  if (energy_) energy_->take_jumps(elements_, state_);
  momentum_.changed(state_, elements_);
}

void PoundingRun::before_change(double time, Islands& islands) {
  while (sampler_.due(time)) {
    sampled_ = state_;
    islands.evaluate(sampler_.next_time(), sampled_);
    std::vector<GroundInput> now = inputs_;
    system_.advance(now, sampler_.next_time() - segment_start());
    sampler_.take(sampled_, now, elements_);
  }
}

bool PoundingRun::notes_flights() const { return sampler_.due(given_.duration) || tracer_ || energy_; }

void PoundingRun::pass(double start, const Flights& flights, std::size_t halvings) {
  const double length = flights[halvings].length();
  if (!sampler_.due(start + length) && !tracer_ && !energy_) return;
  replay(
      {&flights, halvings, start, length, state_, inputs_},
      [this](const Part& part) { return tracer_ || energy_ || sampler_.due(part.start + part.length); },
      [this](double time, const State&, const std::vector<GroundInput>& inputs, const State&) {
        sampler_.take(motion_, time, time + motion_.h(), inputs, elements_);
        follow(time, 1.0, inputs);
        if (energy_) energy_->take(motion_, time, 1.0, inputs, elements_);
      });
}

}  // namespace bentur::engine
