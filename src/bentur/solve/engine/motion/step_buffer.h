#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "bentur/solve/engine/motion/expansion.h"
#include "bentur/solve/engine/motion/flight.h"

namespace bentur::engine {

/// What flights over the whole segments of a grid need: the same for all runs of one problem.
struct FlightPlan {
  FlightTable flights;                       ///< [kind][halvings]
  std::vector<kernels::FlightInput> inputs;  ///< segments × bodies × components
  long segments = 0;                         ///< whole ones of the analysis; none where there are no flights
  std::vector<long> jumps;                   ///< segments that begin with a jump of some ground acceleration
  Flights rest;                              ///< of what the analysis has beyond them; none where that is nothing

  /// `exact`: otherwise there are none.
  FlightPlan(const ModalSystem& system, const TimeGrid& grid, double duration, bool exact);

  /// Whether some ground acceleration may jump where a segment begins.
  [[nodiscard]] bool may_jump(long segment) const {
    return segment >= segments || std::binary_search(jumps.begin(), jumps.end(), segment);
  }
};

/// The last steps of a run: the state and acceleration of every coordinate at successive instants, and how far
/// coordinates can have left the chords in between; peaks and gaps are looked for in many steps at a time. Step n goes
/// from instant n to instant n + 1. It is a flight, a step of a power series, or a jump, which takes no time.
class StepBuffer {
 public:
  static constexpr Eigen::Index most = 128;  ///< number of steps

  /// How a step was taken, so that it can be taken again.
  struct Step {
    long segment = 0;
    const Flights* flights = nullptr;  ///< a flight by flights[halvings]; none: a power series
    std::size_t halvings = 0;
    double length = 0;  ///< [s]; 0: a jump
    double offset = 0;  ///< of its start, from that of the segment [s]
    // Of a power series, and where its coefficients are kept:
    double h = 0, end = 0;
    int degree = 0;
    std::size_t kept = 0;
  };

  StepBuffer(const ModalSystem& system, const FlightPlan& plan);

  /// How many more steps it can hold; one that does not start where the last one ended counts twice.
  [[nodiscard]] Eigen::Index space() const { return most - size(); }
  void clear();

  /// The next step does not start with the state and acceleration with which the last one ended.
  void break_off() { joined_ = false; }
  /// The next step does, to round-off, but with this state. Whether there is a step that has ended.
  [[nodiscard]] bool go_on(const State& state);
  /// Where the next flight starts, unless that is where the last step ended; `load`: what constant forces of elements
  /// do to every coordinate until break_off() (null: nothing).
  void begin(const State& state, const std::vector<GroundInput>& inputs, const double* load);

  // Flights. They become steps when they are accepted; until then the instants and rises after the last step are
  // theirs.
  /// Over `count` whole segments from `segment` on; there must be space for them.
  void fly_on(long segment, Eigen::Index count);
  void accept(long segment, Eigen::Index count);
  /// By flights[halvings].
  void fly(const Flights& flights, std::size_t halvings, const std::vector<GroundInput>& inputs);
  void accept(long segment, double offset, const Flights& flights, std::size_t halvings,
              const std::vector<GroundInput>& inputs);

  /// A step of a power series.
  struct SeriesStep {
    Expansion& motion;  ///< gives its coefficients away
    double cut;         ///< where it ends
    const State &from, &to;
    const Eigen::VectorXd& acceleration;     ///< q̈ at its end
    const std::vector<GroundInput>& inputs;  ///< at its start
  };
  void add(long segment, double offset, const SeriesStep& taken);

  [[nodiscard]] Eigen::Index size() const { return std::max<Eigen::Index>(last_, 0); }
  [[nodiscard]] const Step& step(Eigen::Index n) const { return steps_[n]; }
  /// Of every body, one per component, at the start of a step.
  [[nodiscard]] const GroundInput* inputs(Eigen::Index step) const { return inputs_.data() + step * input_count_; }
  [[nodiscard]] std::vector<GroundInput> all_inputs(Eigen::Index step) const {
    return {inputs(step), inputs(step + 1)};
  }
  /// Of a power series.
  [[nodiscard]] Curves curves(const ModalSystem::Block& block, Eigen::Index n) const {
    const Step& at = step(n);
    return {kept_[at.kept].values.data() + block.begin, system_->size, at.degree, at.h, at.end};
  }
  // Columns of all coordinates, of instants and of steps; their stride is the `size` of the system.
  [[nodiscard]] const double* q(Eigen::Index n) const { return q_.col(n).data(); }
  [[nodiscard]] const double* v(Eigen::Index n) const { return v_.col(n).data(); }
  [[nodiscard]] const double* acceleration(Eigen::Index n) const { return acceleration_.col(n).data(); }
  [[nodiscard]] const double* rise(Eigen::Index step) const { return rise_.col(step).data(); }
  [[nodiscard]] const double* acceleration_rise(Eigen::Index step) const { return acceleration_rise_.col(step).data(); }

 private:
  [[nodiscard]] bool next_instant();
  void note_inputs(const std::vector<GroundInput>& inputs);

  const ModalSystem* system_;
  const FlightPlan* plan_;
  std::vector<kernels::CoordinateRange> ranges_;  ///< of the bodies
  std::vector<const kernels::FlightMap*> maps_;   ///< of the kinds, twice over
  Eigen::Index input_count_;                      ///< of all bodies
  Eigen::Index last_ = -1;                        ///< instant
  bool joined_ = false;
  std::vector<Step> steps_;
  std::vector<GroundInput> inputs_;
  std::vector<Coefficients> kept_;  ///< coefficients of power series
  std::size_t kept_count_ = 0;
  Eigen::MatrixXd q_, v_, acceleration_, rise_, acceleration_rise_;
  const double* load_ = nullptr;
  Eigen::VectorXd no_forces_, start_acceleration_;  ///< scratch
};

}  // namespace bentur::engine
