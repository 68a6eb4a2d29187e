#pragma once

#include <vector>

#include "bentur/solve/motion/course.h"
#include "bentur/solve/motion/series.h"
#include "bentur/solve/walk/peak_watch.h"

namespace bentur::engine {

/// Finds the peaks of a whole run. What bounds do not settle of a flight or of a step of a power series is kept, and
/// looked into when the run is over: peaks only rise, so most of it is settled by then. A flight is then halved until
/// bounds settle its parts; only what is left of that is searched.
class PeakSearch {
 public:
  /// `lumped`: see PeakWatch.
  PeakSearch(const ModalSystem& system, kernels::Lumped& lumped);

  /// Takes the start of the run in.
  void start(const State& state) { watch_.start(state); }

  /// Between two states, with the ground input at both.
  struct Interval {
    const State &from, &to;
    const std::vector<GroundInput>&inputs, &end_inputs;
  };

  /// The legs of a course.
  void take_course(const Course& course);

  /// A flight by flights[halvings].
  void take_flight(const Flights& flights, std::size_t halvings, const Interval& interval, const kernels::Rises& rises,
                   const std::vector<kernels::Sums>& sums);

  /// [0, cut] of an expanded power series whose last evaluation was at `cut`. `forces` are the same as long as
  /// `changes` is.
  void take_step(const Expansion& motion, double cut, const Interval& interval, const ContactForces& forces,
                 long changes);

  /// The same of a step whose expansion is an approximation: q̈ at its ends is given.
  void take_approximate_step(const Expansion& motion, double cut, const Interval& interval,
                             const Eigen::VectorXd& start_acceleration, const Eigen::VectorXd& end_acceleration);

  /// Whether it is time for settle(): it bounds the memory of a long run.
  [[nodiscard]] bool much_is_open() const;
  /// Looks into all that is open.
  void settle(Series& series, Expansion& motion);

  [[nodiscard]] PeakWatch& watch() { return watch_; }
  [[nodiscard]] const PeakWatch& watch() const { return watch_; }

 private:
  /// A flight in which a building may have exceeded its peaks. kept_ has, from `at` on, its reach and q and v of the
  /// building at its start.
  struct OpenFlight {
    std::size_t block = 0;
    const Flights* flights = nullptr;
    std::size_t halvings = 0;
    GroundInput input;
    Eigen::Index at = 0;
  };
  /// A step in which a building may have exceeded its peaks: kept_ has its reach from `at` on, q and v of all buildings
  /// at its start from `start` on.
  struct OpenStep {
    std::size_t block = 0;
    double length = 0;  ///< [s]
    Eigen::Index start = 0, at = 0;
    std::size_t inputs = 0, forces = 0, forces_end = 0;
  };
  /// Room of one halving: state in the middle and at the end, reach of a half.
  struct Halving {
    State middle, end;
    Eigen::VectorXd reach;
  };

  [[nodiscard]] Eigen::Index claim(Eigen::Index count);
  void keep(Eigen::Index at, const double* q, const double* v, Eigen::Index count);
  void recall(Eigen::Index at, Eigen::Index first, Eigen::Index count);
  /// A flight, by all coordinates: q and v at both ends, how far they rise, ground acceleration at both ends.
  struct Flown {
    const double *q, *v, *q_end, *v_end, *rise, *acceleration_rise;
    double value, end_value;
  };
  [[nodiscard]] bool settled(std::size_t block, const Flown& flown, PeakWatch::Open open, const double* before,
                             double* reach);
  void take(std::size_t block, const Flown& flown, PeakWatch::Open open, const double* before,
            const OpenFlight& flight);
  void halve(const OpenFlight& flight, const State& from, const double* before);
  void expand(const OpenFlight& flight, Series& series, Expansion& motion);
  void expand(const OpenStep& step, Series& series, Expansion& motion);
  void keep_forces(const ContactForces& forces, long changes);
  void recall_forces(const OpenStep& step);

  const ModalSystem* system_;
  const kernels::Lumped* lumped_;
  PeakWatch watch_;
  std::vector<OpenFlight> flights_, parts_;  ///< whole ones, and parts that bounds cannot settle
  std::vector<OpenStep> steps_;
  Eigen::VectorXd kept_;
  Eigen::Index kept_count_ = 0;
  std::vector<GroundInput> kept_inputs_;
  /// A linear or resting force of a point.
  struct KeptForce {
    std::size_t point = 0;
    bool rests = false;
    ContactForces::Linear linear;
  };
  std::vector<KeptForce> kept_forces_;
  std::size_t last_forces_ = 0;                            ///< where the last ones begin
  long kept_changes_ = -1;                                 ///< of those
  std::vector<Halving> halvings_;                          ///< room
  State state_;                                            ///< room
  std::vector<GroundInput> inputs_;                        ///< room
  ContactForces forces_;                                   ///< room
  kernels::Rises rises_;                                   ///< room
  Eigen::VectorXd before_;                                 ///< room
  Eigen::VectorXd start_acceleration_, end_acceleration_;  ///< room
};

}  // namespace bentur::engine
