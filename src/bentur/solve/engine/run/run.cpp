#include "bentur/solve/engine/run/run.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace bentur::engine {
namespace {

constexpr double end_slack = 1e-9;                 // of a segment: a remainder shorter than this is not run
constexpr long events_per_step_limit = 100000;     // more than this in one record step cannot be a pounding problem
constexpr long events_by_bisection_limit = 10000;  // where each takes fifty steps
constexpr long stalled_steps_limit = 1000;         // that are too short to tell one time from the next
constexpr double adapted_steps_limit = 100000;     // in one record step, and again in each time that a body needs
constexpr const char* no_step = "no step is short enough to follow the contact force";
constexpr long segments_between_reports = 256;
constexpr long steps_between_reports = 4096;  // where segments take long
constexpr Eigen::Index first_ahead = 1;       // flights that are looked at together, then twice as many, and so on
constexpr const char* not_finite = "the response is no longer a finite number";

}  // namespace

Run::Run(const Setup& setup, Eigen::Index idle, const Elements::Scales& scales,
         const std::vector<ModalSystem::Relation>& others)
    : system_(setup.system),
      given_(setup.given),
      stepper_(setup.system, setup.laws.offsets, setup.solver),
      motion_(setup.system, setup.laws.offsets),
      state_{system_.initial_q, system_.initial_v},
      inputs_(system_.blocks.size() * system_.nu.size()),
      elements_(system_, setup.laws, idle, scales, stepper_.accuracy(), state_),
      buffer_(system_, setup.plan),
      force_at_([this](const State& state, const std::vector<GroundInput>& inputs, Eigen::VectorXd& forces) {
        elements_.forces_at(state, inputs, forces);
      }),
      search_(system_),
      grid_(setup.grid),
      plan_(setup.plan),
      largest_ground_(Eigen::MatrixXd::Zero(system_.components(), std::ssize(system_.blocks))),
      limits_(setup.limits) {
  next_ = expanded_ = replayed_ = state_;
  end_acceleration_.setZero(system_.size);
  replayed_forces_.rate = system_.rate({});
  std::vector<ModalSystem::Relation> idle_ones;
  for (Eigen::Index i = 0; i < idle; ++i) idle_ones.push_back(system_.elements[i].relation);
  const bool rub = system_.rubbing == std::ssize(setup.laws.rubbing);
  for (Eigen::Index point = system_.switched; !rub && point < system_.points(); ++point) {
    idle_ones.push_back(system_.elements[system_.opening(point)].relation);
  }
  watches_.emplace_back(system_, system_.watched, setup.grid);
  watches_.emplace_back(system_, system_.spans, setup.grid);
  watches_.emplace_back(system_, idle_ones, setup.grid);
  watches_.emplace_back(system_, others, setup.grid);
}

void Run::resume(const Checkpoint& checkpoint) {
  segment_ = checkpoint.segment;
  steps_ = checkpoint.steps;
  state_ = checkpoint.state;
  elements_.resume(checkpoint.elements, state_);
  search_.watch().resume(checkpoint.peaks);
  watches_[0].resume(checkpoint.watched);
  watches_[1].resume(checkpoint.spans);
}

Status Run::to_end(const std::function<bool(double)>& progress) {
  progress_ = &progress;
  for (long reported = segment_ - segments_between_reports;;) {
    const double start = grid_.start(segment_);
    const std::size_t kind = segment_ % grid_.kinds();
    const double left = given_.duration - start;
    const double length = grid_.length(kind);
    if (left <= end_slack * length) break;
    if (plan_.may_jump(segment_)) buffer_.break_off();
    if (segment_ >= plan_.segments) {
      grid_.input(segment_, inputs_);
      if (plan_.rest.empty()) {
        take_steps(start, left >= length * (1.0 - end_slack) ? length : left);
      } else {
        advance(plan_.rest, 0, start, left);
      }
      ++segment_;
    } else if (!elements_.may_fly() || !cruise()) {
      grid_.input(segment_, inputs_);
      if (islands_) {
        pass_by_islands(plan_.flights[kind], start, length);
      } else {
        halve(plan_.flights[kind], 0, start, length);
      }
      ++segment_;
    }
    if (trouble_.empty() && !(state_.q.allFinite() && state_.v.allFinite())) fail(not_finite, start);
    if (passed_) break;
    if (status() != Status::done) return status();
    bound_memory();
    if (progress && segment_ - reported >= segments_between_reports) {
      reported = segment_;
      if (!progress(start / given_.duration)) return Status::stopped;
    }
  }
  flush_buffer();
  settle_peaks();
  for (SpanWatch& watch : watches_) settle(watch);
  return status();
}

Status Run::status() const {
  if (!trouble_.empty()) return Status::failed;
  if (stopped_) return Status::stopped;
  return passed_ ? Status::collapsed : Status::done;
}

void Run::keep_limits() {
  const auto end_at = [&](const std::string& limit) {
    fail(fmt::format("the limit of {} is reached", limit), grid_.start(segment_));
  };
  if (limits_.steps > 0 && taken_ > limits_.steps) return end_at(fmt::format("{} steps", limits_.steps));
  if (limits_.events > 0 && elements_.events() > limits_.events) {
    return end_at(fmt::format("{} events", limits_.events));
  }
  if (limits_.seconds > 0.0) {
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - began_;
    if (passed.count() > limits_.seconds) end_at(fmt::format("{} s of wall time", limits_.seconds));
  }
}

/// Counts steps to be taken; false when there are too many of them, or a stop is asked for.
bool Run::go_on(long steps) {
  const long before = taken_;
  taken_ += steps;
  if (trouble_.empty()) keep_limits();
  if (taken_ / steps_between_reports != before / steps_between_reports && *progress_ && !stopped_) {
    stopped_ = !(*progress_)(std::min(grid_.start(segment_) / given_.duration, 1.0));
  }
  return trouble_.empty() && !stopped_;
}

void Run::take_buffer(const StepBuffer& buffer) {
  search_.take(buffer);
  for (SpanWatch& watch : watches_) watch.take(buffer);
}

void Run::flush_buffer() {
  take_buffer(buffer_);
  buffer_.clear();
}

/// For a step that starts at a state of its own.
void Run::ensure_space() {
  if (buffer_.space() < 2) flush_buffer();
}

/// Flies over whole segments as long as nothing can happen; returns whether it came any further.
bool Run::cruise() {
  ensure_space();
  grid_.input(segment_, inputs_);
  buffer_.begin(state_, inputs_, elements_.forces().load_or_null());
  const Eigen::Index first = buffer_.size();
  long last = std::min<long>(plan_.segments, segment_ + buffer_.space());
  const auto jump = std::upper_bound(plan_.jumps.begin(), plan_.jumps.end(), segment_);
  if (jump != plan_.jumps.end()) last = std::min(last, *jump);
  for (Eigen::Index ahead = first_ahead; segment_ < last; ahead *= 2) {
    const Eigen::Index count = std::min<Eigen::Index>(ahead, last - segment_);
    buffer_.fly_on(segment_, count);
    const Eigen::Index passed = quiet(count);
    buffer_.accept(segment_, passed);
    segment_ += passed;
    if (passed < count) break;
  }
  const Eigen::Index steps = buffer_.size();
  if (steps == first) return false;
  elements_.go_on();
  const auto all = [this](const double* x) { return Eigen::Map<const Eigen::VectorXd>(x, system_.size); };
  const auto finite = [&](Eigen::Index n) { return all(buffer_.q(n)).allFinite() && all(buffer_.v(n)).allFinite(); };
  if (!finite(steps)) {
    Eigen::Index n = first;
    while (finite(n + 1)) ++n;
    fail(not_finite, grid_.start(buffer_.step(n).segment));
    return true;
  }
  if (notes_flights()) pass_flights(first);
  for (Eigen::Index n = first + 1; n <= steps; ++n) note_ground(buffer_.q(n));
  state_.q = all(buffer_.q(steps));
  state_.v = all(buffer_.v(steps));
  steps_ += steps - first;
  (void)go_on(steps - first);
  if (buffer_.space() == 0) {
    flush_buffer();
    if (settle_before(segment_)) {
      settle_peaks();
      for (SpanWatch* watch : {&watches_[0], &watches_[1]}) settle(*watch);  // a checkpoint has no need of the rest
      settled_before(segment_);
    }
  }
  return true;
}

/// Tells of whole segments.
void Run::pass_flights(Eigen::Index first) {
  for (Eigen::Index n = first; n < buffer_.size(); ++n) {
    std::copy_n(buffer_.q(n), system_.size, state_.q.data());
    std::copy_n(buffer_.v(n), system_.size, state_.v.data());
    inputs_.assign(buffer_.inputs(n), buffer_.inputs(n + 1));
    pass(grid_.start(buffer_.step(n).segment), *buffer_.step(n).flights, 0);
  }
}

/// Part of a segment, after so many halvings.
void Run::advance(const Flights& flights, std::size_t halvings, double start, double length) {
  if (passed_ || !go_on()) return;
  if (elements_.may_fly() && fly(flights, halvings, start, length)) return;
  halve(flights, halvings, start, length);
}

void Run::halve(const Flights& flights, std::size_t halvings, double start, double length) {
  if (halvings + 1 >= flights.size()) {
    take_steps(start, length);
    return;
  }
  const double half = 0.5 * length;
  advance(flights, halvings + 1, start, half);
  advance(flights, halvings + 1, start + half, half);
}

/// False, and nothing has changed, when something may happen.
bool Run::fly(const Flights& flights, std::size_t halvings, double start, double length) {
  ensure_space();
  buffer_.begin(state_, inputs_, elements_.forces().load_or_null());
  const Eigen::Index n = buffer_.size();
  buffer_.fly(flights, halvings, inputs_);
  if (quiet(1) == 0) return false;
  elements_.go_on();
  buffer_.accept(segment_, start - grid_.start(segment_), flights, halvings, inputs_);
  pass(start, flights, halvings);
  std::copy_n(buffer_.q(n + 1), system_.size, next_.q.data());
  std::copy_n(buffer_.v(n + 1), system_.size, next_.v.data());
  end_inputs_ = inputs_;
  system_.advance(end_inputs_, length);
  arrive();
  return true;
}

/// By steps, cut at events.
void Run::take_steps(double start, double length) {
  double elapsed = 0.0;
  long cuts = 0;
  long stalled = 0;
  double adapted = 0;
  while (elapsed < length && go_on()) {
    bound_memory();
    const double left = length - elapsed;
    const double time = start + elapsed;
    if (!step(time, left)) return;
    const double whole = motion_.h();
    const double cut = look(time);
    const double h = motion_.h();
    if (cut < 1.0) motion_.evaluate(cut, next_, &end_acceleration_);
    elements_.note_touches(motion_, time, cut, next_);
    end_inputs_ = inputs_;
    system_.advance(end_inputs_, cut * h);
    if (lasts(cut * h)) {
      watch_step(time, cut);
    } else {
      buffer_.break_off();
    }
    const bool at_end = whole == left && h == whole && cut == 1.0;
    const bool event = cut < 1.0 || h != whole;
    // A contact that begins at next to no speed makes the first steps so short; they grow again. Any number of contacts
    // may change at one instant.
    if (at_end || elapsed + cut * h > elapsed) {
      stalled = 0;
    } else if (!event) {
      ++stalled;
    }
    if (stalled > stalled_steps_limit) {
      fail("steps have become too short to tell one time from the next", time);
      return;
    }
    elapsed = at_end ? length : elapsed + cut * h;
    arrive();
    arrived(start + elapsed);
    if (!trouble_.empty() || passed_) return;
    elements_.forget_faded(start + elapsed, state_);
    // A force that jumps about, as one of a user's own may, leaves no step long enough to get anywhere.
    if (stepper_.is_adapted() && ++adapted > adapted_steps_limit * (1.0 + elapsed * replayed_forces_.rate)) {
      fail(no_step, time);
      return;
    }
    const long limit = stepper_.is_fixed() ? events_by_bisection_limit : events_per_step_limit;
    // A harmonic motion is one step, however many periods it lasts.
    const double periods = 1.0 + std::floor(elapsed * system_.fastest_input() / (2.0 * std::numbers::pi));
    if (event && static_cast<double>(++cuts) > static_cast<double>(limit) * periods) {
      fail(fmt::format("more than {} events within one {} of the ground motion", limit,
                       system_.fastest_input() > 0.0 ? "period" : "step"),
           time);
    }
  }
}

/// Takes the step again, but only `length` [s] of it.
void Run::retake(double length) {
  stepper_.retake(here(), length, motion_, next_);
  (void)motion_.find_end(expanded_, end_acceleration_);
  elements_.look(state_, next_, motion_.rise());
}

/// The first event of the step, which ends there if it is no power series.
void Run::find_event(double time) {
  elements_.gauge(next_);
  if (stepper_.is_fixed()) {
    find_event_by_bisection(time);
    return;
  }
  event_ = elements_.next_event(motion_, state_, next_, time, stepper_.is_series());
  if (stepper_.is_series()) return;
  constexpr int attempts = 20;
  // A step by approximation is taken again up to its event, and ends a little elsewhere than the longer one was at that
  // place: where it has then gone through an event of another element, that one is the first.
  for (int attempt = 0; attempt < attempts && event_ && event_->s > 0.0 && event_->s < 1.0; ++attempt) {
    retake(event_->s * motion_.h());
    const auto again = elements_.next_event(motion_, state_, next_, time, false);
    if (again && again->element != event_->element) {
      event_ = again;
    } else {
      event_->s = 1.0;
    }
  }
}

/// As the monograph does it: by what is found at the end of a step, and bisection.
void Run::find_event_by_bisection(double time) {
  const double whole = motion_.h();
  std::vector<GroundInput> inputs;
  const auto due = [&] {
    inputs = inputs_;
    system_.advance(inputs, motion_.h());
    return elements_.due(next_, inputs, time + motion_.h());
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

/// Looks at the step from state_ to next_ (motion_), which began at `time`; returns where it must be cut (1: nowhere).
double Run::look(double time) {
  elements_.look(state_, next_, motion_.rise());
  find_event(time);
  const double cut = event_ ? event_->s : 1.0;
  if (lasts(cut * motion_.h())) elements_.accumulate(motion_, time, cut);
  take_step(time, cut);
  return cut;
}

/// At the end of a step.
void Run::arrived(double time) {
  if (!event_) return;
  if (event_->element < elements_.count()) before_ = elements_.law_state(event_->element);
  elements_.change(*event_, time, inputs_, state_);
  if (!elements_.goes_on() || !buffer_.go_on(state_)) buffer_.break_off();
  if (elements_.failed()) return fail("no impulses part the points that collide", time);
  if (elements_.began()) stepper_.contact_begins();
  if (const auto element = elements_.limit_passed()) {
    passed_ = {*element - system_.joint(system_.joints), time};
  }
  changed(time);
}

bool Run::step(double time, double longest) {
  if (!stepper_.advance(here(), longest, elements_.any_touching(), motion_, next_)) {
    fail(no_step, time);
    return false;
  }
  if (!motion_.find_end(stepper_.is_series() ? next_ : expanded_, end_acceleration_)) {
    fail(not_finite, time);
    return false;
  }
  return true;
}

/// Of contacts that change at one instant one comes first, by round-off. The state between them, where the one pushes
/// and the other does not, is none of the motion. What the first of them finds at the start is.
bool Run::lasts(double length) const { return steps_ == 0 || length > instant * given_.duration; }

/// Takes [0, cut] of the expanded step into the peaks.
void Run::watch_step(double time, double cut) {
  if (stepper_.is_series()) {
    ensure_space();
    buffer_.add(segment_, time - grid_.start(segment_), {motion_, cut, state_, next_, end_acceleration_, inputs_});
    return;
  }
  force_at_(state_, inputs_, forces_);
  system_.acceleration(state_, inputs_, forces_, start_acceleration_);
  force_at_(next_, end_inputs_, forces_);
  system_.acceleration(next_, end_inputs_, forces_, end_acceleration_);
  search_.take({motion_, cut, state_, next_, start_acceleration_, end_acceleration_});
  for (SpanWatch& watch : watches_) watch.take(motion_, cut, state_, next_, time);
  approximated();
  buffer_.break_off();
}

void Run::replay(const Stretch& stretch, const Wanted& wanted, const EachStep& each) {
  replayed_forces_.loaded = system_.load_of(stretch.from.q.data(), replayed_forces_.load) != nullptr;
  replay_within(stretch, wanted, each);
}

void Run::replay_within(const Stretch& stretch, const Wanted& wanted, const EachStep& each) {
  if (!go_on()) return;
  if (stretch.flights == nullptr || stretch.halvings + 1 >= stretch.flights->size()) {
    stepper_.series().expand(stretch.from, stretch.inputs, stretch.length, replayed_forces_, motion_);
    (void)motion_.find_end(replayed_, end_acceleration_);
    each(stretch.start, stretch.from, stretch.inputs, replayed_);
    return;
  }
  const auto zeros = [this] { return Eigen::VectorXd::Zero(system_.size); };
  while (halvings_.size() < stretch.flights->size()) {
    halvings_.push_back({{zeros(), zeros()}, {zeros(), zeros()}, {}, zeros(), zeros(), zeros()});
  }
  const Flight& half = (*stretch.flights)[stretch.halvings + 1];
  Halving& at = halvings_[stretch.halvings];
  at.inputs = stretch.inputs;
  double start = stretch.start;
  const State* from = &stretch.from;
  for (State* to : {&at.middle, &at.end}) {
    for (std::size_t b = 0; b < system_.blocks.size(); ++b) {
      half.advance(b, system_.of_body(at.inputs, b),
                   {from->q.data(), from->v.data(), to->q.data(), to->v.data(), at.acceleration.data(), at.rise.data(),
                    at.acceleration_rise.data(), replayed_forces_.load_or_null()});
    }
    if (wanted({start, half.length(), *from, *to, at.rise})) {
      replay_within({stretch.flights, stretch.halvings + 1, start, half.length(), *from, at.inputs}, wanted, each);
    }
    from = to;
    start += half.length();
    system_.advance(at.inputs, half.length());
  }
}

/// Looks into what bounds left unsettled, so that what is nearest so far is known.
void Run::settle_peaks() {
  search_.settle(stepper_.series(), motion_, [this](long steps) { return go_on(steps); });
}

void Run::settle(SpanWatch& watch) {
  watch.settle(stepper_.series(), motion_, [this](long steps) { return go_on(steps); });
}

/// Of a long run.
void Run::bound_memory() {
  if (search_.much_is_unsettled()) settle_peaks();
  for (SpanWatch& watch : watches_) {
    if (watch.much_is_unsettled()) settle(watch);
  }
}

/// next_ becomes state_.
void Run::arrive() {
  ++steps_;
  inputs_.swap(end_inputs_);
  state_.q.swap(next_.q);
  state_.v.swap(next_.v);
  note_ground(state_.q.data());
}

void Run::note_ground(const double* q) {
  if (!system_.ground_counts) return;
  for (std::size_t b = 0; b < system_.blocks.size(); ++b) {
    for (Eigen::Index c = 0; c < system_.components(); ++c) {
      double& largest = largest_ground_(c, static_cast<Eigen::Index>(b));
      largest = std::max(largest, std::abs(q[system_.ground_of(b) + c]));
    }
  }
}

void Run::fail(const std::string& reason, double time) { trouble_ = fmt::format("{} at t = {:.6g} s", reason, time); }

}  // namespace bentur::engine
