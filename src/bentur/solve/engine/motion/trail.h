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
  std::vector<kernels::FlightInput> inputs;  ///< segments × buildings
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

/// Where a run has been: the state and acceleration of every coordinate at instants one after the other, and how far
/// coordinates can have left the chords in between. For those who look at many instants at a time. Leg n goes from
/// instant n to instant n + 1; it is a flight or a step of a power series, or nothing but a jump.
class Trail {
 public:
  static constexpr Eigen::Index most = 128;  ///< legs

  /// How a leg was taken, so that it can be gone over again.
  struct Leg {
    long segment = 0;
    const Flights* flights = nullptr;  ///< a flight by flights[halvings]; none: a step
    std::size_t halvings = 0;
    double length = 0;  ///< [s]; 0: a jump
    double offset = 0;  ///< of its start, from that of the segment [s]
    // Of a step, and where its coefficients are kept:
    double h = 0, end = 0;
    int degree = 0;
    Eigen::Index kept = 0;
  };

  Trail(const ModalSystem& system, const FlightPlan& plan);

  /// Legs for which there is room; a leg that does not start where the last one ended takes up two.
  [[nodiscard]] Eigen::Index room() const { return most - legs(); }
  void clear();

  /// The next leg does not start with the state and acceleration with which the last one ended.
  void break_off() { joined_ = false; }
  /// Where the next flight starts, unless that is where the last leg ended.
  void begin(const State& state, const std::vector<GroundInput>& inputs);

  // Flights; they are no legs before they are accepted, but instants and rises after the last leg are theirs.
  /// Over `count` whole segments from `segment` on; there must be room.
  void fly_on(long segment, Eigen::Index count);
  void accept(long segment, Eigen::Index count);
  /// By flights[halvings].
  void fly(const Flights& flights, std::size_t halvings, const std::vector<GroundInput>& inputs);
  void accept(long segment, double offset, const Flights& flights, std::size_t halvings,
              const std::vector<GroundInput>& inputs);

  /// A step.
  struct Step {
    const Expansion& motion;  ///< a power series, last evaluated at `cut`
    double cut;               ///< where it ends
    const State &from, &to;
    const std::vector<GroundInput>& inputs;  ///< at its start
  };
  void add(long segment, double offset, const Step& step);

  [[nodiscard]] Eigen::Index legs() const { return std::max<Eigen::Index>(last_, 0); }
  [[nodiscard]] const Leg& leg(Eigen::Index n) const { return legs_[static_cast<std::size_t>(n)]; }
  /// Of every building at the start of a leg.
  [[nodiscard]] const GroundInput* inputs(Eigen::Index leg) const {
    return inputs_.data() + static_cast<std::size_t>(leg) * system_->blocks.size();
  }
  /// Of a step.
  [[nodiscard]] Curves curves(const ModalSystem::Block& block, Eigen::Index n) const {
    const Leg& step = leg(n);
    return {kept_.data() + step.kept + block.begin, system_->size, step.degree, step.h, step.end};
  }
  // Columns of all coordinates, of instants and of legs, each `size` of the system after the one before.
  [[nodiscard]] const double* q(Eigen::Index n) const { return q_.col(n).data(); }
  [[nodiscard]] const double* v(Eigen::Index n) const { return v_.col(n).data(); }
  [[nodiscard]] const double* acceleration(Eigen::Index n) const { return acceleration_.col(n).data(); }
  [[nodiscard]] const double* rise(Eigen::Index leg) const { return rise_.col(leg).data(); }
  [[nodiscard]] const double* acceleration_rise(Eigen::Index leg) const { return acceleration_rise_.col(leg).data(); }

 private:
  [[nodiscard]] bool next_instant();
  void note_inputs(const std::vector<GroundInput>& inputs);

  const ModalSystem* system_;
  const FlightPlan* plan_;
  std::vector<kernels::Room> rooms_;             ///< of the buildings
  std::vector<const kernels::FlightMap*> maps_;  ///< of the kinds, twice over
  Eigen::Index last_ = -1;                       ///< instant
  bool joined_ = false;
  std::vector<Leg> legs_;
  std::vector<GroundInput> inputs_;
  Eigen::VectorXd kept_;  ///< coefficients of steps
  Eigen::Index kept_count_ = 0;
  Eigen::MatrixXd q_, v_, acceleration_, rise_, acceleration_rise_;
  Eigen::VectorXd no_forces_, start_acceleration_;  ///< room
};

}  // namespace bentur::engine
