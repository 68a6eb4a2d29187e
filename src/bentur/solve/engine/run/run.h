#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "bentur/solve/engine/motion/step_buffer.h"
#include "bentur/solve/engine/motion/stepper.h"
#include "bentur/solve/engine/run/elements.h"
#include "bentur/solve/engine/run/islands/islands.h"
#include "bentur/solve/engine/run/watch/peak_search.h"
#include "bentur/solve/engine/run/watch/span_watch.h"
#include "bentur/solve/solver.h"

namespace bentur::engine {

/// What the free response and the response with contact have in common: the way along the time grid, and what happens
/// to elements on it. A segment is one flight where its bound proves that nothing can happen in it; otherwise it is
/// halved, and the parts that cannot be halved any more, or all of it where there are no flights, are taken by the
/// solver's own steps, cut at events.
class Run {
 public:
  /// What all runs of one system share, and the laws of this one.
  struct Setup {
    const ModalSystem& system;
    const System& given;
    const Elements::Laws& laws;
    const Solver& solver;
    const TimeGrid& grid;
    const FlightPlan& plan;
    RunLimits limits = {};
  };
  /// The first `idle` elements do nothing, nor do contacts that rub which `setup` has no laws of; `scales` as Elements
  /// takes them. `others` are watched besides what every run watches.
  Run(const Setup& setup, Eigen::Index idle, const Elements::Scales& scales,
      const std::vector<ModalSystem::Relation>& others = {});
  virtual ~Run() = default;
  Run(const Run&) = delete;
  Run& operator=(const Run&) = delete;

  /// What there is to go on with from the start of a segment; no contact is under way.
  struct Checkpoint {
    long segment = 0, steps = 0;
    State state;
    Elements::Memory elements;
    Eigen::VectorXd peaks;              ///< so far
    std::vector<Reach> watched, spans;  ///< so far
  };
  /// Goes on from there, before to_end().
  void resume(const Checkpoint& checkpoint);

  /// Runs to the end of the analysis. `progress(fraction)`, where given, returning false stops.
  Status to_end(const std::function<bool(double)>& progress);

  [[nodiscard]] const PeakWatch& watch() const { return search_.watch(); }
  /// How far ModalSystem::watched and spans went, idle elements, and the others.
  [[nodiscard]] const SpanWatch& watched() const { return watches_[0]; }
  [[nodiscard]] const SpanWatch& spans() const { return watches_[1]; }
  [[nodiscard]] const SpanWatch& idle() const { return watches_[2]; }
  [[nodiscard]] const SpanWatch& others() const { return watches_[3]; }
  [[nodiscard]] Elements& elements() { return elements_; }
  /// What ended the run before its time.
  [[nodiscard]] const std::optional<Solution::Passed>& passed() const { return passed_; }
  [[nodiscard]] const State& state() const { return state_; }
  [[nodiscard]] const std::vector<GroundInput>& inputs() const { return inputs_; }
  /// Why and when the numbers failed; empty while all is well.
  [[nodiscard]] const std::string& trouble() const { return trouble_; }
  [[nodiscard]] long steps() const { return steps_; }
  /// Of a coordinate of the ground; 0 where none counts [length].
  [[nodiscard]] double largest_ground_displacement(std::size_t block, Eigen::Index component) const {
    return largest_ground_(component, static_cast<Eigen::Index>(block));
  }

 protected:
  /// In how many of `count` flights from segment() on, which follow the last step of buffer_, nothing can have
  /// happened.
  [[nodiscard]] virtual Eigen::Index quiet(Eigen::Index count) {
    return elements_.quiet(buffer_, count, system_.switched, system_.rubs);
  }
  /// Takes in the steps of the buffer, which is emptied after that.
  virtual void take_buffer(const StepBuffer& buffer);
  /// Whether to find all peaks so far where a segment begins that only flights have come before.
  [[nodiscard]] virtual bool settle_before(long segment) = 0;
  /// Called when they have been found.
  virtual void settled_before(long /*segment*/) {}
  /// Whether pass() is called for every flight.
  [[nodiscard]] virtual bool notes_flights() const { return false; }
  /// Takes in [0, cut] of the expanded step (motion_), which began at `time` with state_ and inputs_.
  virtual void take_step(double /*time*/, double /*cut*/) {}
  /// After elements have changed at a time [s], by event().
  virtual void changed(double /*time*/) {}
  /// After a step from state_ to next_ that is an approximation.
  virtual void approximated() {}
  /// A flight from state_ over which nothing happened, by flights[halvings], for those who want samples of it.
  virtual void pass(double /*start*/, const Flights& /*flights*/, std::size_t /*halvings*/) {}

  /// Goes over segments that cannot be flown island by island from now on.
  void go_by_islands(const Elements::Laws& laws);
  /// Before elements change at a time [s] of a segment that is gone over by islands, or it ends.
  virtual void before_change(double /*time*/, Islands& /*islands*/) {}

  /// The event that ends the step under way.
  [[nodiscard]] const std::optional<Elements::Event>& event() const { return event_; }
  /// Where its element stood in its law before the last change, of one deformation.
  [[nodiscard]] const LawState& before() const { return before_; }
  /// The segment under way, and when it began [s].
  [[nodiscard]] long segment() const { return segment_; }
  [[nodiscard]] double segment_start() const { return grid_.start(segment_); }
  [[nodiscard]] Checkpoint checkpoint() const {
    return {segment_,         steps_, state_, elements_.memory(), search_.watch().peaks(), watched().nearest(),
            spans().nearest()};
  }

  /// A stretch without events, by flights[halvings]; without flights it is no longer than one power series.
  struct Stretch {
    const Flights* flights;
    std::size_t halvings;
    double start, length;  ///< [s]
    const State& from;
    const std::vector<GroundInput>& inputs;  ///< at its start
  };
  /// A part of it: both ends, and how far coordinates leave their chords in between.
  struct Part {
    double start, length;  ///< [s]
    const State &from, &to;
    const Eigen::VectorXd& rise;
  };
  /// Goes over a stretch again: it is halved until one power series spans a part, and what is not wanted is left out on
  /// the way, so that a fast mode costs no more than the logarithm of its frequency. The series is in motion_; `each`
  /// is given when it begins [s], state and inputs there, and the state at its end.
  using Wanted = std::function<bool(const Part&)>;
  using EachStep = std::function<void(double, const State&, const std::vector<GroundInput>&, const State&)>;
  void replay(const Stretch& stretch, const Wanted& wanted, const EachStep& each);

  const ModalSystem& system_;
  const System& given_;
  Stepper stepper_;
  Expansion motion_;
  State state_, next_;
  std::vector<GroundInput> inputs_;  ///< at state_
  Elements elements_;
  StepBuffer buffer_;

 private:
  void ensure_space();
  void flush_buffer();
  [[nodiscard]] bool cruise();
  void pass_by_islands(const Flights& flights, double start, double length);
  void advance(const Flights& flights, std::size_t halvings, double start, double length);
  void halve(const Flights& flights, std::size_t halvings, double start, double length);
  [[nodiscard]] bool fly(const Flights& flights, std::size_t halvings, double start, double length);
  void take_steps(double start, double length);
  [[nodiscard]] Stepper::Start here() const { return {state_, inputs_, elements_.forces(), force_at_}; }
  [[nodiscard]] bool step(double time, double longest);
  [[nodiscard]] double look(double time);
  void find_event(double time);
  void find_event_by_bisection(double time);
  void retake(double length);
  void arrived(double time);
  static constexpr double instant = 0x1p-46;  ///< of the duration: what is over so soon has not been
  /// Whether a state that lasts so long [s] is one of the motion's.
  [[nodiscard]] bool lasts(double length) const;
  void watch_step(double time, double cut);
  void settle_peaks();
  void settle(SpanWatch& watch);
  void bound_memory();
  void fail(const std::string& reason, double time);
  void arrive();
  void note_ground(const double* q);
  void pass_flights(Eigen::Index first);
  void keep_limits();
  [[nodiscard]] bool go_on(long steps = 1);
  [[nodiscard]] Status status() const;

  /// Scratch of one halving: the instants at the middle and the end.
  struct Halving {
    State middle, end;
    std::vector<GroundInput> inputs;
    Eigen::VectorXd acceleration, rise, acceleration_rise;
  };

  void replay_within(const Stretch& stretch, const Wanted& wanted, const EachStep& each);

  const ForceFunction force_at_;
  std::optional<Elements::Event> event_;
  LawState before_;
  PeakSearch search_;
  std::vector<SpanWatch> watches_;
  std::unique_ptr<Islands> islands_;  ///< none where all bodies are stepped together
  const TimeGrid& grid_;
  const FlightPlan& plan_;
  Eigen::VectorXd start_acceleration_, end_acceleration_, forces_;  ///< scratch
  std::vector<GroundInput> end_inputs_;                             ///< at next_
  Eigen::MatrixXd largest_ground_;                                  ///< components × bodies
  std::string trouble_;
  long segment_ = 0;  ///< under way
  long steps_ = 0;
  long taken_ = 0;  ///< steps, those gone over again included
  const RunLimits limits_;
  const std::chrono::steady_clock::time_point began_ = std::chrono::steady_clock::now();
  bool stopped_ = false;
  std::optional<Solution::Passed> passed_;
  const std::function<bool(double)>* progress_ = nullptr;
  std::vector<Halving> halvings_;  ///< scratch
  State expanded_, replayed_;      ///< scratch
  ElementForces replayed_forces_;  ///< scratch: constant ones
};

}  // namespace bentur::engine
