#pragma once

#include <functional>
#include <string>
#include <vector>

#include "bentur/solve/motion/flight.h"
#include "bentur/solve/motion/stepper.h"
#include "bentur/solve/response.h"
#include "bentur/solve/walk/peak_search.h"

namespace bentur::engine {

/// The flights of every segment length of the grid down to a part short enough for one power series and for a tight
/// bound. Empty where a damping matrix is full.
using FlightTable = std::vector<Flights>;  // [kind][halvings]
[[nodiscard]] FlightTable make_flights(const ModalSystem& system, const TimeGrid& grid);

/// What the free response and the response with contact have in common: walking the time grid. A segment is flown over
/// where its bound proves that nothing can happen in it; otherwise it is halved, and the parts that cannot be halved
/// any more, or all of it where there are no flights, are taken by the solver's own steps.
class Walk {
 public:
  /// What all walks of one problem share.
  struct Ground {
    const ModalSystem& system;
    const Problem& problem;
    const Solver& solver;
    const TimeGrid& grid;
    const FlightTable& flights;
  };
  Walk(const Ground& ground, PeakWatch::Scope scope);
  virtual ~Walk() = default;
  Walk(const Walk&) = delete;
  Walk& operator=(const Walk&) = delete;

  /// Runs to the end of the analysis. `progress(fraction)`, where given, returning false stops.
  Status run(const std::function<bool(double)>& progress);

  [[nodiscard]] const PeakWatch& watch() const { return search_.watch(); }
  /// Why and when the numbers failed; empty while all is well.
  [[nodiscard]] const std::string& trouble() const { return trouble_; }
  [[nodiscard]] long steps() const { return steps_; }
  [[nodiscard]] double largest_ground_displacement(std::size_t block) const { return largest_ground_[block]; }

 protected:
  /// What the contact points do.
  [[nodiscard]] virtual const ContactForces& forces() const = 0;
  /// How often that has changed.
  [[nodiscard]] virtual long changes() const = 0;
  [[nodiscard]] virtual const ForceFunction& force_at() const = 0;
  /// Whether no contact is under way or remembered, so that every building is free.
  [[nodiscard]] virtual bool may_fly() const = 0;
  /// Whether what the walk looks for cannot have happened between state_ and next_.
  virtual bool quiet(const Flights& flights, std::size_t halvings, const Flight::Bounds& bounds) = 0;
  /// Looks at the step from state_ to next_ (motion_), which began at `time`; returns where it must be cut (1:
  /// nowhere).
  virtual double look(double time) = 0;
  /// After the state has been moved to the cut.
  virtual void arrived(double /*time*/) {}
  /// When the run is over.
  virtual void settle() {}
  /// A stretch from state_ over which nothing happened, for those who want samples of it.
  virtual void pass(double /*start*/, double /*length*/) {}

  /// What the next step starts from.
  [[nodiscard]] Stepper::Start here() const { return {state_, inputs_, forces(), force_at()}; }

  /// Expands a flight of `length` [s] from a state again, in steps (motion_); `each` is given where in it a step
  /// begins [s], and state and inputs there and the state at its end.
  using EachStep = std::function<void(double, const State&, const std::vector<GroundInput>&, const State&)>;
  void replay(State from, std::vector<GroundInput> inputs, double length, const EachStep& each);

  const ModalSystem& system_;
  const Problem& problem_;
  Stepper stepper_;
  Expansion motion_;
  State state_, next_;
  std::vector<GroundInput> inputs_;  ///< at state_

 private:
  void advance(std::size_t kind, std::size_t halvings, double start, double length);
  [[nodiscard]] bool fly(const Flights& flights, std::size_t halvings, double start, double length);
  void walk(double start, double length);
  [[nodiscard]] bool step(double time, double longest);
  void watch_step(double cut);
  void arrive();
  void fail(const std::string& reason, double time);

  const TimeGrid& grid_;
  const FlightTable& flights_;
  PeakSearch search_;
  Flight::Bounds bounds_;
  Eigen::VectorXd start_acceleration_, end_acceleration_, forces_;  ///< room
  std::vector<GroundInput> end_inputs_;                             ///< at next_
  std::vector<double> largest_ground_;
  std::string trouble_;
  long steps_ = 0;
};

}  // namespace bentur::engine
