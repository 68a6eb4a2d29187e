#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <span>
#include <vector>

/// Inner loops of free flights; see rows.h.
namespace bentur::engine::kernels {

using Eigen::Index;

/// Where the coordinates of a building are; `size` a multiple of four.
struct Room {
  Index begin = 0, size = 0;
};

/// Coefficients of a free flight over one length (flight.h): for four coordinates after the other, column by column.
struct FlightMap {
  enum Column {
    qq,
    qv,
    qa,
    qb,
    vq,
    vv,
    va,
    vb,  ///< end position and speed from start position, speed, ground acceleration, slope
    p_value,
    p_slope,
    p_rate,
    omega,
    slow,
    second,
    second_force,
    orbit,
    orbit_value,
    orbit_slope,
    orbit_floor,
    kappa,
    force,
    fourth,
    fourth_force,
    fourth_slope,
    columns
  };
  explicit FlightMap(Index coordinates) : table(static_cast<std::size_t>(coordinates * columns), 0.0) {}
  std::vector<double> table;

  [[nodiscard]] double& operator()(Index coordinate, Column column) {
    return table[static_cast<std::size_t>((coordinate / 4 * columns + column) * 4 + coordinate % 4)];
  }
};

/// Ground acceleration of one building over a flight: at its start, its slope, bounds of both, and at its end.
struct FlightInput {
  double value = 0, slope = 0, largest = 0, steepest = 0, end = 0;
};

/// How far each coordinate, and its acceleration, can be from the chord between its values at the ends of an interval.
struct Rises {
  Eigen::VectorXd position, acceleration;
};

/// Weights of one sum over bounds |q_j| or |q̈_j| of all coordinates of a building that settles many questions at
/// once: Σ c_j |q_j| < 1 with c_j = max_r |w_rj|/limit_r keeps every row r of weights w below its limit.      (T-4)
struct Lumped {
  Eigen::VectorXd positions, accelerations;  ///< limits: its own peaks
  Eigen::VectorXd as_left, as_right;         ///< limits: what opens its gap to the right, to the left
};
struct Sums {
  double positions = 0, accelerations = 0, as_left = 0, as_right = 0;
};

/// The coordinates of one building over one flight; all lists are of all coordinates.
Sums fly(const FlightMap& map, Room room, const FlightInput& input, const double* q, const double* v, double* q_end,
         double* v_end, const Lumped& lumped, Rises& rises);

/// Flights of all buildings one after the other. Columns of all coordinates: q and v have one more than there are
/// flights, the Rises have one for each.
struct Legs {
  std::span<const Room> rooms;
  std::span<const FlightMap* const> maps;  ///< taken in turn, from the first on
  const FlightInput* inputs;               ///< flights × buildings
  Index stride;                            ///< of the columns
  double *q, *v, *rise, *acceleration_rise;
};

/// Flies `count` of them, or fewer: the last one flown is the first of which the sums as_left and as_right of two
/// neighbours are not below 1 together. Returns how many come before it.
Index fly_on(const Legs& legs, Index count, const Lumped& lumped);

/// The same sums of one building over [0, end] of an expansion, s = time/h: `second` = |q''| and `fourth` = |q⁗| at
/// most, `curved` and `curved_end` = q'' at its ends, all with respect to s.
struct Stretch {
  const double *q, *q_end, *curved, *curved_end, *second, *fourth;
  double end, h;
};
Sums sum_up(Room room, const Stretch& stretch, const Lumped& lumped);

}  // namespace bentur::engine::kernels
