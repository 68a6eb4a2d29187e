#pragma once

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

/// The inner loops of the exact solver. Each runs over coordinates in fours (ModalSystem pads every building to a
/// multiple of four) and is compiled for processors with wider vectors too; which version runs is picked when the
/// program starts. All versions add and multiply in the same order and never contract, so that they give the same
/// numbers to the bit.
namespace bentur::engine::kernels {

using Eigen::Index;

/// Σ a_j b_j, n a multiple of four: four sums side by side, added in one fixed order.
[[nodiscard]] inline double dot(Index n, const double* a, const double* b) {
  std::array<double, 4> sum{};
  for (Index j = 0; j < n; j += 4) {
    for (Index l = 0; l < 4; ++l) sum[static_cast<std::size_t>(l)] += a[j + l] * b[j + l];
  }
  return (sum[0] + sum[1]) + (sum[2] + sum[3]);
}

/// A matrix for the functions below that go over its rows: four rows at a time, one column of these after the other, so
/// that memory is read as it lies. Rows of zeros fill the last four up.
class PackedRows {
 public:
  PackedRows() = default;
  /// `matrix` with columns of zeros up to `columns`.
  PackedRows(const Eigen::MatrixXd& matrix, Index columns);
  [[nodiscard]] Index rows() const { return rows_; }  ///< a multiple of four
  [[nodiscard]] Index columns() const { return columns_; }
  [[nodiscard]] double operator()(Index row, Index column) const {
    return weights_[static_cast<std::size_t>(row / 4 * 4 * columns_ + 4 * column + row % 4)];
  }
  /// Four rows from row r on.
  [[nodiscard]] const double* from(Index r) const { return weights_.data() + r * columns_; }

 private:
  Index rows_ = 0, columns_ = 0;
  std::vector<double> weights_;
};

/// Where the coordinates of a building are; `size` a multiple of four.
struct Room {
  Index begin = 0, size = 0;
};

/// Σ |a_j| |b_j|, likewise.
[[nodiscard]] inline double dot_of_sizes(Index n, const double* a, const double* b) {
  std::array<double, 4> sum{};
  for (Index j = 0; j < n; j += 4) {
    for (Index l = 0; l < 4; ++l) sum[static_cast<std::size_t>(l)] += std::abs(a[j + l] * b[j + l]);
  }
  return (sum[0] + sum[1]) + (sum[2] + sum[3]);
}

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

/// A contact point that presses with a linear force, as a power series over a step of h: F_k h² = −stiffness g_k −
/// (k + 1) damping g_{k+1}, and `base` more for k = 0.
struct Pressing {
  Index left_begin, left_size, right_begin, right_size;
  const double *sense_left, *sense_right, *push_left, *push_right;
  double width;                     ///< w [length]
  double base, stiffness, damping;  ///< times h², h², h
  double* opening;                  ///< g_k, filled on the way: degree + 1 of them
};

/// The ground acceleration of one building as a power series: a_{k+2} = −ν²h² a_k / ((k+2)(k+1)).
struct Ground {
  Index begin, size;
  double even, odd;   ///< a_0 h², a_1 h²; then those last asked for
  double nu_squared;  ///< ν² h²

  /// a_k h², to be asked for k = 0, 1, 2, …
  [[nodiscard]] double next(int k) {
    double& a = k % 2 == 0 ? even : odd;
    if (k >= 2) a *= -nu_squared / (k * (k - 1.0));
    return a;
  }
};

/// (T-2) for the coordinates of `grounds`: columns 0 and 1 of `c` are given, 2 to `degree` are filled. `stiff` h²Ω²,
/// `damp` h D, columns `stride` apart. `room` has `stride` entries.
void expand(const double* stiff, const double* damp, const double* gamma, std::span<Ground> grounds,
            std::span<const Pressing> pressing, int degree, Index stride, double* c, double* room);

/// Position, dq/ds and d²q/ds² at s, of n coordinates whose coefficients begin at `c`.
void evaluate(Index n, const double* c, Index stride, int degree, double s, double* q, double* first, double* second);

/// Σ k(k−1)|c_k| and Σ k(k−1)(k−2)(k−3)|c_k| of n coordinates; returns a sum that is finite only where all of them are.
double bound(Index n, const double* c, Index stride, int degree, double* second, double* fourth);

/// Position and d²q/ds² of n coordinates at s = 0, end/count, 2 end/count, … end, `n` apart.
void sample(Index n, const double* c, Index stride, int degree, int count, double end, double* q, double* second);

/// For every row r: the largest |Σ_j w_rj x_j| over `count` vectors x, one after the other, raises `peak`; and `reach`
/// is that plus what entries that rise `rise` above their chords between two of the vectors may add. Four rows whose
/// reaches were not above their peaks `before` are left alone. Returns whether no reach exceeds its peak.
bool reach_of_samples(const PackedRows& weights, int count, const double* x, const double* rise, double* peak,
                      const double* before, double* reach);

/// For every row r of a matrix of `rows` (a multiple of four) × columns: the lower of Σ_j w_rj x_j at two vectors, and
/// how far below that it can be between them when entry j falls at most `rise` below its chord.
void lowest_of_rows(const PackedRows& weights, const double* start, const double* end, const double* rise,
                    double* lowest, double* beyond);

/// Raises `peak` by |Σ_j w_rj x_j| for every row r and `count` vectors x, `apart` apart. `share` of a vector is then
/// the largest of |Σ_j w_rj x_j|/peak_r over the rows. `room` has rows × count entries.
void raise_peaks(const PackedRows& weights, Index count, const double* x, Index apart, double* peak, double* share,
                 double* room);

/// The polynomial of row r of coordinates whose coefficients begin at `c`. `room` has as many entries as columns.
void combine(const PackedRows& weights, Index r, const double* c, Index stride, int degree, double* room,
             double* polynomial);

/// Where |x|, |y| ≤ rest · peak for four numbers each, `open` becomes 0, elsewhere infinite; n is a multiple of four.
void open_groups(Index n, const double* x, const double* y, Index apart, const double* peak, double rest, double* open);

/// The largest |w_rj|/limit_r of `count` columns from `first` on; rows of zeros have no say.
void lump(const PackedRows& weights, Index first, Index count, const double* limits, double* largest);

/// A stage of a Runge-Kutta step of n coordinates from the slopes of `count` stages before it, `stride` apart:
///   q_at = q + after v + h² Σ positions_j slope_j,   v_at = v + h Σ speeds_j slope_j.
void stage(Index n, const double* slopes, Index stride, int count, const double* positions, const double* speeds,
           double after, double h, const double* q, const double* v, double* q_at, double* v_at);

/// A polynomial of `powers` coefficients from all stages: to_k = factors_k Σ_j weights_j,k slope_j, columns of `to`
/// being `stride` apart too; row j of the weights has `powers` entries.
inline constexpr int powers = 8;
void interpolate(Index n, const double* slopes, Index stride, int count, const double* weights, const double* factors,
                 double* to);

/// q̈ = γ a − Ω² q − D q̇ of n coordinates.
void accelerate(Index n, const double* omega_squared, const double* two_sigma, const double* gamma, double value,
                const double* q, const double* v, double* acceleration);

/// How far each row can be from zero between two vectors when entry j rises at most `rise` above its chord; raises
/// `peak` by the ends. Four rows whose reaches were not above their peaks `before` are left alone. Returns whether no
/// reach exceeds its peak.
bool reach_of_rows(const PackedRows& weights, const double* start, const double* end, const double* rise, double* peak,
                   const double* before, double* reach);

}  // namespace bentur::engine::kernels
