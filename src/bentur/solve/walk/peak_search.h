#pragma once

#include <vector>

#include "bentur/solve/motion/flight.h"
#include "bentur/solve/motion/series.h"
#include "bentur/solve/walk/peak_watch.h"

namespace bentur::engine {

/// The flights of one segment length of the grid and of its halves, quarters, …: number n is of length/2ⁿ.
using Flights = std::vector<Flight>;

/// Finds the peaks of a whole run. What bounds do not settle of a flight or of a step of a power series is kept, and
/// looked into when the run is over: peaks only rise, so most of it is settled by then. A flight is then halved until
/// bounds settle its parts; only what is left of that is searched.
class PeakSearch {
 public:
  PeakSearch(const ModalSystem& system, PeakWatch::Scope scope);

  /// Takes the start of the run in.
  void start(const State& state) { watch_.start(state); }

  /// A flight by flights[halvings] from one state to the other.
  void take_flight(const Flights& flights, std::size_t halvings, const State& from,
                   const std::vector<GroundInput>& inputs, const State& to, const std::vector<GroundInput>& end_inputs,
                   const Flight::Bounds& bounds);

  /// [0, cut] of an expanded power series that began at `from`. `forces` are the same as long as `changes` is.
  void take_step(const Expansion& motion, double cut, const State& from, const std::vector<GroundInput>& inputs,
                 const ContactForces& forces, long changes);

  /// The same of a step whose expansion is an approximation: q̈ at its ends is given.
  void take_approximate_step(const Expansion& motion, double cut, const State& from, const State& to,
                             const Eigen::VectorXd& start_acceleration, const Eigen::VectorXd& end_acceleration);

  /// Whether it is time for settle(): it bounds the memory of a long run.
  [[nodiscard]] bool much_is_open() const;
  /// Looks into all that is open.
  void settle(Series& series, Expansion& motion);

  [[nodiscard]] const PeakWatch& watch() const { return watch_; }

 private:
  /// A flight of one building, or the last part of one; its q and v at the start are in kept_, and how far
  /// it may have gone.
  struct OpenFlight {
    std::size_t block = 0;
    const Flights* flights = nullptr;
    std::size_t halvings = 0;
    GroundInput input;
    std::size_t start = 0, reach = 0;
  };
  /// A step in which a building may have exceeded its peaks; q and v at its start are in kept_, and how far it
  /// may have gone.
  struct OpenStep {
    std::size_t block = 0;
    double length = 0;  ///< [s]
    std::size_t start = 0, inputs = 0, forces = 0, reach = 0;
  };

  [[nodiscard]] std::size_t keep(const double* q, const double* v, Eigen::Index count);
  [[nodiscard]] std::size_t keep_reach();
  [[nodiscard]] bool recall(std::size_t block, std::size_t reach);
  [[nodiscard]] bool settled(std::size_t block, const double* q, const double* v, const double* q_end,
                             const double* v_end, const GroundInput& input, const GroundInput& end_input,
                             const Flight::Bounds& bounds);
  void halve(const OpenFlight& flight, const double* q, const double* v);
  void expand(const OpenFlight& flight, Series& series, Expansion& motion);
  void expand(const OpenStep& step, Series& series, Expansion& motion);

  const ModalSystem* system_;
  PeakWatch watch_;
  std::vector<OpenFlight> flights_, parts_;  ///< whole ones, and parts that bounds cannot settle
  std::vector<OpenStep> steps_;
  std::vector<double> kept_;
  std::vector<GroundInput> kept_inputs_;
  std::vector<ContactForces> kept_forces_;
  long kept_changes_ = 0;                ///< of the last of them
  std::vector<double> start_;            ///< room: q and v of a flight
  std::vector<Eigen::VectorXd> at_;      ///< room: q and v in the middle and at the end of each halving
  std::vector<PeakWatch::Reach> whole_;  ///< room: reach of what each halving halves
  State state_;                          ///< room
  std::vector<GroundInput> inputs_;      ///< room
  Flight::Bounds bounds_;
  PeakWatch::Reach reach_;                                                            ///< of what is being looked at
  Eigen::VectorXd start_acceleration_, end_acceleration_, rise_, acceleration_rise_;  ///< room
};

}  // namespace bentur::engine
