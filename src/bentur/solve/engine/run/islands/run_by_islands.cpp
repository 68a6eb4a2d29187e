// How a run goes over segments island by island.
#include "bentur/solve/engine/run/islands/islands.h"
#include "bentur/solve/engine/run/run.h"

namespace bentur::engine {

void Run::go_by_islands(const Elements::Laws& laws) {
  islands_ = std::make_unique<Islands>(
      system_, laws,
      Islands::Parts{elements_, search_, watches_[0], instant * given_.duration,
                     [this](double time) { before_change(time, *islands_); }, [this] { return go_on(); }});
}

/// A segment in which something may happen.
void Run::pass_by_islands(const Flights& flights, double start, double length) {
  buffer_.break_off();
  const long before = islands_->steps();
  const double reached = islands_->pass(start, length, inputs_, state_);
  steps_ += islands_->steps() - before;
  if (reached < 0.0 && trouble_.empty() && !stopped_) {
    fail("the response is no longer a finite number, or its events have no end", start);
  }
  if (reached < 0.0) return;
  note_ground(state_.q.data());
  if (reached == 0.0) {
    halve(flights, 0, start, length);
  } else if (reached < length) {
    system_.advance(inputs_, reached);
    take_steps(start + reached, length - reached);
  }
}

}  // namespace bentur::engine
