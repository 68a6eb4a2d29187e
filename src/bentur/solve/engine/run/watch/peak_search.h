#pragma once

#include <array>
#include <functional>
#include <vector>

#include "bentur/solve/engine/motion/series.h"
#include "bentur/solve/engine/motion/step_buffer.h"
#include "bentur/solve/engine/run/watch/peak_watch.h"

namespace bentur::engine {

/// Finds the peaks of a whole run. What bounds do not settle of a flight or of a step of a power series is kept, and
/// looked into when the run is over: peaks only rise, so most of it is settled by then. A flight is then halved until
/// cubics with proven bounds settle its parts; only what is left of that is searched.
class PeakSearch {
 public:
  explicit PeakSearch(const ModalSystem& system);

  /// Takes in where a run has been.
  void take(const StepBuffer& buffer);

  /// Takes in a power series of one body, up to where it was cut, between whose ends it went so far.
  void take(std::size_t block, const PeakWatch::Interval& ends, const Curves& step);

  /// A step whose expansion is an approximation.
  struct Approximate {
    const Expansion& motion;
    double end;  ///< of the step
    const State &from, &to;
    const Eigen::VectorXd &start_acceleration, &end_acceleration;  ///< q̈
  };
  void take(const Approximate& step);

  /// Whether it is time for settle(): it bounds the memory of a long run.
  [[nodiscard]] bool much_is_unsettled() const;
  /// Learns how many steps the search takes next; false: it ends there.
  using GoOn = std::function<bool(long)>;
  /// Looks into all that is unsettled.
  void settle(Series& series, Expansion& motion, const GoOn& go_on);

  [[nodiscard]] PeakWatch& watch() { return watch_; }
  [[nodiscard]] const PeakWatch& watch() const { return watch_; }

 private:
  /// A flight in which a body may have exceeded its peaks. kept_ has, from `at` on, its reach and q, v and q̈ of the
  /// body at its start.
  struct UnsettledFlight {
    std::size_t block = 0;
    const Flights* flights = nullptr;
    std::size_t halvings = 0;
    std::array<GroundInput, most_components> inputs;  ///< at its start
    Eigen::Index at = 0;
  };
  /// A step in which a body may have exceeded its peaks. kept_ has, from `at` on, its reach and the coefficients of
  /// its coordinates.
  struct UnsettledStep {
    std::size_t block = 0;
    double h = 0, end = 0;
    int degree = 0;
    Eigen::Index at = 0;
  };
  /// All coordinates at one instant.
  struct Place {
    Eigen::VectorXd q, v, acceleration;
  };
  /// Scratch of one halving: the instants at the middle and the end, reach of a half.
  struct Halving {
    Place middle, end;
    Eigen::VectorXd reach;
  };

  [[nodiscard]] Eigen::Index claim(Eigen::Index count);
  void keep(const double* x, Eigen::Index count);
  void keep_flight(const UnsettledFlight& flight, const double* q, const double* v, const double* acceleration,
                   std::vector<UnsettledFlight>& flights);
  void keep_step(std::size_t block, const Curves& curves, Eigen::Index at);
  /// What a search works with.
  struct Tools {
    Series& series;
    Expansion& motion;
    const GoOn& go_on;
    Eigen::Index mark;   ///< in kept_: from there on stands what belongs to parts_
    const double* load;  ///< of the flight that is halved
  };
  [[nodiscard]] bool settled_by_cubics(const UnsettledFlight& flight, const Place& from, const double* before,
                                       Place& to, double* reach, const Tools& tools);
  void halve_whole(const UnsettledFlight& flight, Tools& tools);
  void halve(const UnsettledFlight& flight, const Place& from, const double* before, Tools& tools);
  template <class Unsettled, class CurvesOf>
  void look_into(std::vector<Unsettled>& intervals, const CurvesOf& curves_of, bool search);
  void look_into_parts(Tools& tools, bool search);
  [[nodiscard]] Curves curves(const UnsettledFlight& flight, Series& series, Expansion& motion);
  [[nodiscard]] Curves curves(const UnsettledStep& step) const;

  const ModalSystem* system_;
  PeakWatch watch_;
  std::vector<UnsettledFlight> flights_, parts_;  ///< whole ones, and parts that bounds cannot settle
  std::vector<UnsettledStep> steps_;
  Eigen::VectorXd kept_;
  Eigen::Index kept_count_ = 0;
  std::vector<Halving> halvings_;             ///< scratch
  State state_;                               ///< scratch
  Eigen::VectorXd before_, load_;             ///< scratch
  Eigen::VectorXd rise_, acceleration_rise_;  ///< scratch
  Eigen::MatrixXd slopes_;                    ///< scratch: coordinates × those of q and q̈ at both ends
};

}  // namespace bentur::engine
