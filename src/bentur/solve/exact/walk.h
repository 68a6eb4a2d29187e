#pragma once

#include <functional>
#include <string>
#include <vector>

#include "bentur/solve/exact/flight.h"
#include "bentur/solve/exact/peak_watch.h"
#include "bentur/solve/exact/series.h"
#include "bentur/solve/response.h"

namespace bentur::exact {

/// The flights of every segment length of the grid, and of its halves, quarters, … down to a part short enough for one
/// power series and for a tight bound. Empty where a damping matrix is full.
using FlightTable = std::vector<std::vector<Flight>>;  // [kind][halvings]
[[nodiscard]] FlightTable make_flights(const ModalSystem& system, const TimeGrid& grid);

/// So many intervals are kept for the end of a run at most; it bounds the memory of a long one.
inline constexpr std::size_t unsettled_limit = 4096;

/// What the free response and the response with contact have in common: walking the time grid. A segment is flown over
/// where its bound proves that nothing can happen in it; otherwise it is halved, and the parts that cannot be halved
/// any more are taken by power series.
class Walk {
 public:
  Walk(const ModalSystem& system, const Problem& problem, const TimeGrid& grid, FlightTable& flights,
       PeakWatch::Scope scope);
  virtual ~Walk() = default;
  Walk(const Walk&) = delete;
  Walk& operator=(const Walk&) = delete;

  /// Runs to the end of the analysis. `progress(fraction)` returning false stops.
  Status run(const std::function<bool(double)>& progress);

  [[nodiscard]] const PeakWatch& watch() const { return watch_; }
  /// Why and when the numbers failed; empty while all is well.
  [[nodiscard]] const std::string& trouble() const { return trouble_; }
  [[nodiscard]] long steps() const { return steps_; }
  [[nodiscard]] double largest_ground_displacement(std::size_t block) const { return largest_ground_[block]; }

 protected:
  /// Points in contact.
  [[nodiscard]] virtual const std::vector<char>& closed() const = 0;
  /// Whether no point is in contact, so that every building is free.
  [[nodiscard]] virtual bool may_fly() const = 0;
  /// Whether what the walk looks for cannot have happened between state_ and next_.
  virtual bool quiet(const Flight& flight) = 0;
  /// Looks at the expanded step from state_ to next_, which began at `time`; returns where it must be cut (1: nowhere).
  virtual double look(double time) = 0;
  /// After the state has been moved to the cut.
  virtual void arrived(double /*time*/) {}
  /// When the run is over.
  virtual void settle() {}
  /// A stretch from state_ over which nothing happened, for those who want samples of it.
  virtual void pass(double /*start*/, double /*length*/) {}

  const ModalSystem& system_;
  const Problem& problem_;
  Series series_;
  State state_, next_;
  std::vector<GroundInput> inputs_;  ///< at state_

 private:
  void advance(std::size_t kind, std::size_t halvings, double start, double length);
  [[nodiscard]] bool fly(Flight& flight, double start, double length);
  void walk(double start, double length);
  void watch_interval(double length, const Eigen::VectorXd& rise, const Eigen::VectorXd& acceleration_rise);
  void scan_unsettled();
  void after_step(double time);
  void fail(const std::string& reason, double time);

  /// An interval without events in which one building may have exceeded its peaks.
  struct Unsettled {
    std::size_t block;
    double length;  ///< [s]
    State start;
    std::vector<GroundInput> inputs;
    std::vector<char> closed;  ///< empty: none
    PeakWatch::Reach reach;
  };

  const TimeGrid& grid_;
  FlightTable& flights_;
  PeakWatch watch_;
  std::vector<Unsettled> unsettled_;
  PeakWatch::Reach reach_;                                                            ///< room
  Eigen::VectorXd rise_, acceleration_rise_, start_acceleration_, end_acceleration_;  ///< room
  std::vector<GroundInput> end_inputs_;                                               ///< room
  std::vector<double> largest_ground_;
  std::string trouble_;
  long steps_ = 0;
};

}  // namespace bentur::exact
