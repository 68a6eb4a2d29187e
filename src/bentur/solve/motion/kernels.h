#pragma once

#include <Eigen/Core>
#include <array>
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

/// Coefficients of a free flight over one length (flight.h): a column per coefficient, a row per coordinate.
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
  Eigen::MatrixXd table;

  [[nodiscard]] double& operator()(Index coordinate, Column column) { return table(coordinate, column); }
  [[nodiscard]] double operator()(Index coordinate, Column column) const { return table(coordinate, column); }
};

/// Ground acceleration of one building over a flight: at its start, its slope, and bounds of both.
struct FlightInput {
  double value = 0, slope = 0, largest = 0, steepest = 0;
};

/// What is known of a flight between its ends (flight.h), one entry per coordinate.
struct FlightBounds {
  Eigen::VectorXd rise, acceleration_rise, position, acceleration;
};

/// Coordinates [begin, begin + n) over one flight.
void fly(const FlightMap& map, Index begin, Index n, const FlightInput& input, const double* q, const double* v,
         double* q_end, double* v_end, FlightBounds& bounds);

/// A contact point that presses with a linear force, as a power series over a step of h: F_k h² = −stiffness g_k −
/// (k + 1) damping g_{k+1}, and `base` more for k = 0.
struct Pressing {
  Index left_begin, left_size, right_begin, right_size;
  const double *sense_left, *sense_right, *push_left, *push_right;
  double width;                     ///< w [length]
  double base, stiffness, damping;  ///< times h², h², h
  double* opening;                  ///< g_k, filled on the way: degree + 1 of them
};

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

/// Position, and speed times h, at s, of n coordinates whose coefficients begin at `c`.
void evaluate(Index n, const double* c, Index stride, int degree, double s, double* q, double* hv);

/// Σ k(k−1)|c_k| and Σ k(k−1)(k−2)(k−3)|c_k| of n coordinates; returns a sum that is finite only where all of them are.
double bound(Index n, const double* c, Index stride, int degree, double* second, double* fourth);

/// Position and d²q/ds² of n coordinates at s = 0, end/count, 2 end/count, … end, `n` apart.
void sample(Index n, const double* c, Index stride, int degree, int count, double end, double* q, double* second);

/// For every row r: the largest |Σ_j w_rj x_j| over `count` vectors x, one after the other, raises `peak`; and `reach`
/// is that plus what entries that rise `rise` above their chords between two of the vectors may add. Four rows whose
/// reaches are not above their peaks on entry are left alone. Returns whether no reach exceeds its peak.
bool reach_of_samples(const PackedRows& weights, int count, const double* x, const double* rise, double* peak,
                      double* reach);

/// For every row r of a matrix of `rows` (a multiple of four) × columns: the lower of Σ_j w_rj x_j at two vectors, and
/// how far below that it can be between them when entry j falls at most `rise` below its chord.
void lowest_of_rows(const PackedRows& weights, const double* start, const double* end, const double* rise,
                    double* lowest, double* beyond);

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
/// `peak` by the ends. Four rows whose reaches are not above their peaks on entry are left alone. Returns whether no
/// reach exceeds its peak.
bool reach_of_rows(const PackedRows& weights, const double* start, const double* end, const double* rise, double* peak,
                   double* reach);

}  // namespace bentur::engine::kernels
