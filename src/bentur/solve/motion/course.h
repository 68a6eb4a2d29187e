#pragma once

#include <vector>

#include "bentur/solve/motion/flight.h"

namespace bentur::engine {

/// What flights over the whole segments of a grid need: the same for all runs of one problem.
struct FlightPlan {
  FlightTable flights;                       ///< [kind][halvings]
  std::vector<kernels::FlightInput> inputs;  ///< segments × buildings
  long segments = 0;                         ///< whole ones of the analysis; none where there are no flights
  std::vector<long> jumps;                   ///< segments that begin with a jump of some ground acceleration

  /// `exact`: otherwise there are none.
  FlightPlan(const ModalSystem& system, const TimeGrid& grid, double duration, bool exact);
};

/// Whole segments flown one after the other, for those who look at many of them at a time. No ground acceleration jumps
/// on the way, so that accelerations at the end of one leg are those at the start of the next.
class Course {
 public:
  static constexpr Eigen::Index most = 128;  ///< legs

  Course(const ModalSystem& system, const FlightPlan& plan);

  /// Begins at a state and a segment.
  void begin(const State& state, long segment);
  /// Flies on while (T-4) proves that no two buildings touch, `count` legs at most.
  [[nodiscard]] long fly_on(long count, const kernels::Lumped& lumped);
  /// After fewer than that: the leg flown last counts although (T-4) does not settle it.
  void accept() { ++legs_; }

  [[nodiscard]] Eigen::Index legs() const { return legs_; }
  [[nodiscard]] long segment(Eigen::Index leg) const { return first_ + leg; }
  [[nodiscard]] const Flights& flights(Eigen::Index leg) const {
    return plan_->flights[static_cast<std::size_t>(segment(leg)) % plan_->flights.size()];
  }
  [[nodiscard]] const kernels::FlightInput& input(Eigen::Index leg, std::size_t block) const {
    return plan_->inputs[static_cast<std::size_t>(segment(leg)) * system_->blocks.size() + block];
  }
  // Columns of all coordinates. Leg n goes from column n of the first two to column n + 1.
  [[nodiscard]] const double* q(Eigen::Index n) const { return q_.col(n).data(); }
  [[nodiscard]] const double* v(Eigen::Index n) const { return v_.col(n).data(); }
  [[nodiscard]] const double* rise(Eigen::Index leg) const { return rise_.col(leg).data(); }
  [[nodiscard]] const double* acceleration_rise(Eigen::Index leg) const { return acceleration_rise_.col(leg).data(); }

 private:
  const ModalSystem* system_;
  const FlightPlan* plan_;
  std::vector<kernels::Room> rooms_;
  std::vector<const kernels::FlightMap*> maps_;  ///< of the kinds, twice over
  long first_ = 0;
  Eigen::Index legs_ = 0;
  Eigen::MatrixXd q_, v_, rise_, acceleration_rise_;
};

}  // namespace bentur::engine
