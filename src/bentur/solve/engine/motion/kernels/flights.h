#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <span>
#include <vector>

/// Inner loops of free flights; see rows.h.
namespace bentur::engine::kernels {

using Eigen::Index;

/// Where the coordinates of a body are; `size` a multiple of four.
struct CoordinateRange {
  Index begin = 0, size = 0;
};

/// Coefficients of a free flight over one length (flight.h): for four coordinates after the other, column by column.
struct FlightMap {
  enum Column {
    qq,
    qv,
    vq,
    vv,  ///< end position and speed from start position, speed
    omega,
    second,
    fourth,
    omega_squared,
    two_sigma,
    cubic,
    acceleration_cubic,  ///< how far q and q̈ leave their cubics, of √(q⃛² + Ω²q̈²) at the start
    // What the ground does, from here on once for each component of its motion:
    qa,
    qb,
    va,
    vb,  ///< end position and speed from ground acceleration, slope
    p_value,
    p_slope,
    p_rate,
    slow,
    second_force,
    fourth_force,
    fourth_slope,
    gamma,
    columns,
    of_component = columns - qa
  };
  /// The same of a constant load: what it adds to the end position and speed, and to the bounds.
  enum LoadColumn { load_q, load_v, load_p, load_slow, load_second, load_fourth, load_columns };

  explicit FlightMap(Index coordinates, Index of_components = 1)
      : components(of_components),
        width(columns + (of_components - 1) * of_component),
        table(coordinates * width, 0.0) {}
  Index components, width;           ///< of the ground's motion; columns of the table
  std::vector<double> table, loads;  ///< `loads` is empty where no load ever acts

  [[nodiscard]] double& operator()(Index coordinate, Column column, Index component = 0) {
    return table[(coordinate / 4 * width + column + component * of_component) * 4 + coordinate % 4];
  }
  [[nodiscard]] double& operator()(Index coordinate, LoadColumn column) {
    return loads[(coordinate / 4 * load_columns + column) * 4 + coordinate % 4];
  }
};

/// A component of the ground acceleration of one body over a flight: at its start, its slope, bounds of both, and at
/// its end.
struct FlightInput {
  double value = 0, slope = 0, largest = 0, steepest = 0, end = 0;
};

/// A flight, by lists of all coordinates: from `q` and `v` to what is found at its end, and how far each coordinate and
/// its acceleration can be from the chord in between.
struct FlightArrays {
  const double *q, *v;
  double *q_end, *v_end, *acceleration_end, *rise, *acceleration_rise;
  const double* load = nullptr;  ///< constant, on every coordinate; null: none
};

/// The coordinates of one body over one flight; the inputs of further components follow the first.
void fly(const FlightMap& map, CoordinateRange range, const FlightInput& input, const FlightArrays& arrays);

/// What is known of a flight at both its ends, with how far q and q̈ can leave their chords in between; and what
/// follows.
struct CubicArrays {
  const double *q, *v, *acceleration;
  const double *q_end, *v_end, *acceleration_end;
  double *rise, *acceleration_rise;
  double *slope, *slope_end, *acceleration_slope, *acceleration_slope_end;
};

/// The slopes, times the length [s], of the cubics through both ends that q and q̈ of one body depart the least from,
/// and by how much: `rise` and `acceleration_rise` become less where these are no chords (T-8).
void fit_cubics(const FlightMap& map, CoordinateRange range, double length, const FlightInput& input,
                const CubicArrays& arrays);

/// Flights of all bodies one after the other. Columns of all coordinates: the FlightArrays of flight n is column n,
/// and of what is found at its end column n + 1.
struct FlightSequence {
  std::span<const CoordinateRange> ranges;
  std::span<const FlightMap* const> maps;  ///< taken in turn, from the first on
  const FlightInput* inputs;               ///< flights × bodies × components
  Index stride;                            ///< of the columns
  double *q, *v, *acceleration, *rise, *acceleration_rise;
  const double* load;  ///< as of FlightArrays
};

/// Flies `count` of them.
void fly_on(const FlightSequence& sequence, Index count);

}  // namespace bentur::engine::kernels
