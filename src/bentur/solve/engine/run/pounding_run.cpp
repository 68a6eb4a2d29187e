#include "bentur/solve/engine/run/pounding_run.h"

#include <algorithm>

namespace bentur::engine {

PoundingRun::PoundingRun(const Setup& setup, const Contacts::Scales& scales, long first_contact,
                         const SolveOptions& options)
    : Run(setup),
      first_contact_(first_contact),
      monitor_(system_, gap_widths(problem_)),
      contacts_(system_, problem_, scales, stepper_.accuracy()),
      force_at_([this](const State& state, const std::vector<GroundInput>& inputs, Eigen::VectorXd& forces) {
        contacts_.forces_at(state, inputs, forces);
      }),
      sampler_(system_, problem_, options.output_step) {
  if (options.energy_audit) energy_.emplace(system_, problem_, options.output_step);
}

Eigen::Index PoundingRun::quiet(Eigen::Index count) {
  if (segment() + count <= first_contact_) return count;
  const Eigen::Index before = std::max<Eigen::Index>(first_contact_ - segment(), 0);
  return std::max(before, monitor_.stay_open(buffer_, count));
}

/// Takes the step again, but only `length` [s] of it.
void PoundingRun::retake(double length) {
  stepper_.retake(here(), length, motion_, next_);
  (void)motion_.find_rises();
  (void)monitor_.look(state_.q.data(), next_.q.data(), motion_.rise().data());
}

/// The first event of the step, which ends there if it is no power series.
void PoundingRun::find_event(double time) {
  contacts_.gauge(state_, next_, monitor_);
  if (!stepper_.is_fixed()) {
    event_ = contacts_.next_event(motion_, state_, monitor_, time);
    if (stepper_.is_series()) return;
    constexpr int attempts = 20;
    // A step by approximation is taken again up to its event, and ends a little elsewhere than the longer one was at
    // that place: where it has then gone through an event at another point, that one is the first.
    for (int attempt = 0; attempt < attempts && event_ && event_->s > 0.0 && event_->s < 1.0; ++attempt) {
      retake(event_->s * motion_.h());
      const auto again = contacts_.next_event(motion_, state_, monitor_, time);
      if (again && again->point != event_->point) {
        event_ = again;
      } else {
        event_->s = 1.0;
      }
    }
    return;
  }
  // As the monograph does it: by what is found at the end of a step, and bisection.
  const double whole = motion_.h();
  std::vector<GroundInput> inputs;
  const auto due = [&] {
    inputs = inputs_;
    system_.advance(inputs, motion_.h());
    return contacts_.due(next_, inputs, time + motion_.h());
  };
  event_ = due();
  if (!event_) return;
  constexpr int halvings = 50;
  double before = 0.0;
  double after = 1.0;
  for (int n = 0; n < halvings && before < after; ++n) {
    const double middle = 0.5 * (before + after);
    stepper_.retake(here(), middle * whole, motion_, next_);
    if (const auto found = due()) {
      event_ = found;
      after = middle;
    } else {
      before = middle;
    }
  }
  retake(after * whole);
}

double PoundingRun::look(double time) {
  time_ = time;
  (void)monitor_.look(state_.q.data(), next_.q.data(), motion_.rise().data());
  find_event(time);
  const double cut = event_ ? event_->s : 1.0;
  if (lasts(cut * motion_.h())) contacts_.accumulate(motion_, time, cut);
  sampler_.take(motion_, time, time + cut * motion_.h(), inputs_, contacts_);
  if (energy_) energy_->take(motion_, time, cut, inputs_, contacts_);
  return cut;
}

void PoundingRun::arrived(double time) {
  contacts_.note_touches(motion_, monitor_, time_, event_ ? event_->s : 1.0, state_);
  if (!event_) return;
  buffer_.break_off();
  contacts_.change(*event_, time, state_);
  if (contacts_.failed()) return fail("no impulses part the points that collide", time);
  if (energy_) energy_->take_jumps(contacts_, state_);
  if (contacts_.began()) stepper_.contact_begins();
}

bool PoundingRun::notes_flights() const { return sampler_.due(problem_.duration) || energy_; }

void PoundingRun::pass(double start, const Flights& flights, std::size_t halvings) {
  const double length = flights[halvings].length();
  if (!sampler_.due(start + length) && !energy_) return;
  replay(
      {&flights, halvings, start, length, state_, inputs_},
      [this](const Part& part) { return energy_ || sampler_.due(part.start + part.length); },
      [this](double time, const State&, const std::vector<GroundInput>& inputs, const State&) {
        sampler_.take(motion_, time, time + motion_.h(), inputs, contacts_);
        if (energy_) energy_->take(motion_, time, 1.0, inputs, contacts_);
      });
}

}  // namespace bentur::engine
