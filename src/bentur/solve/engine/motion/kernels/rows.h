#pragma once

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <span>
#include <vector>

/// Inner loops of the exact solver: sums over coordinates, many at a time. Each runs over coordinates in fours
/// (ModalSystem pads every body to a multiple of four) and is compiled for processors with wider vectors too; which
/// version runs is picked when the program starts. All versions add and multiply in the same order and never contract,
/// so that they give the same numbers to the bit.
namespace bentur::engine::kernels {

using Eigen::Index;

/// Σ a_j b_j, n a multiple of four: four sums side by side, added in one fixed order.
[[nodiscard]] inline double dot(Index n, const double* a, const double* b) {
  std::array<double, 4> sum{};
  for (Index j = 0; j < n; j += 4) {
    for (Index l = 0; l < 4; ++l) sum[l] += a[j + l] * b[j + l];
  }
  return (sum[0] + sum[1]) + (sum[2] + sum[3]);
}

/// Σ |a_j| |b_j|, likewise.
[[nodiscard]] inline double dot_abs(Index n, const double* a, const double* b) {
  std::array<double, 4> sum{};
  for (Index j = 0; j < n; j += 4) {
    for (Index l = 0; l < 4; ++l) sum[l] += std::abs(a[j + l] * b[j + l]);
  }
  return (sum[0] + sum[1]) + (sum[2] + sum[3]);
}

/// A matrix for the functions below that go over its rows: four rows at a time, one column of these after the other, so
/// that memory is read as it lies; columns of zeros alone are not held. Rows of zeros fill the last four up.
class PackedRows {
 public:
  PackedRows() = default;
  /// `matrix` with columns of zeros up to `columns`.
  PackedRows(const Eigen::MatrixXd& matrix, Index columns);
  [[nodiscard]] Index rows() const { return rows_; }  ///< a multiple of four
  [[nodiscard]] Index columns() const { return columns_; }
  [[nodiscard]] double operator()(Index row, Index column) const;

  /// Columns from `begin` up to `end`, of which so many before them are not held.
  struct Run {
    Index begin = 0, end = 0, left_out = 0;
  };
  /// Four rows from row r on, of the columns that are held.
  [[nodiscard]] const double* held(Index r) const { return weights_.data() + r * held_; }
  /// The same so that column j of a run stands at entry 4 j.
  [[nodiscard]] const double* from(Index r, const Run& run) const { return held(r) - 4 * run.left_out; }
  /// Those that the eight rows around row r depend on, or any row (multiples of four).
  [[nodiscard]] std::span<const Run> runs(Index r) const { return runs_[r / 8]; }
  [[nodiscard]] std::span<const Run> runs() const { return all_runs_; }

  /// Some of the columns, for raise_peaks().
  class Columns {
   public:
    [[nodiscard]] std::span<const Run> runs(Index r) const { return runs_[r / 8]; }

   private:
    friend class PackedRows;
    std::vector<std::vector<Run>> runs_;  ///< of eight rows each
  };
  /// Those that are wanted (per column, not 0).
  [[nodiscard]] Columns chosen(const std::vector<char>& wanted) const;

 private:
  Index rows_ = 0, columns_ = 0, held_ = 0;
  std::vector<double> weights_;
  std::vector<std::vector<Run>> runs_;  ///< of eight rows each
  std::vector<Run> all_runs_;
};

/// Peaks are of sizes |Σ_j w_rj x_j + offset_r|, or of the sums themselves.
enum class Peaks { of_abs, of_values };

// A reach, rise or peak that is not a number is below nothing.

/// How far each row can come between two vectors when entry j rises at most `rise` above its chord; raises
/// `peak` by the ends. Four rows whose reaches were not above their peaks `before` are left alone. Returns whether no
/// reach exceeds its peak.
bool reach_of_rows(Peaks of, const PackedRows& weights, const double* offset, const double* start, const double* end,
                   const double* rise, double* peak, const double* before, double* reach);

/// How far coordinates or accelerations come that follow cubics: values at both ends, slopes there times the length,
/// and how far each can depart from its cubic.
struct CubicCurves {
  const double *start, *end, *slope, *slope_end, *rise;
};
/// The same by these.
bool reach_of_cubics(Peaks of, const PackedRows& weights, const double* offset, const CubicCurves& curves, double* peak,
                     const double* before, double* reach);

/// The first rows of all fours of which one can come below its `least` or above its `most` so, in `fours`; how low and
/// how high each of these rows can come. Returns how many fours these are.
[[nodiscard]] Index fours_beyond(const PackedRows& weights, const double* start, const double* end, const double* rise,
                                 const double* least, const double* most, double* low, double* high, Index* fours);

/// For every row r: the largest |Σ_j w_rj x_j + offset_r| over `count` vectors x, one after the other, raises `peak`;
/// and `reach` is that plus what entries that rise `rise` above their chords between two of the vectors may add. Four
/// rows whose reaches were not above their peaks `before` are left alone. Returns whether no reach exceeds its peak.
bool reach_of_samples(const PackedRows& weights, const double* offset, int count, const double* x, const double* rise,
                      double* peak, const double* before, double* reach);

/// Raises `peak` for every row r by `count` vectors x, `stride` apart; `values` has what rows r to r + 3 (r a multiple
/// of four) are at vector n from entry r count + 4 n on. `columns`: those that count; null: all.
void raise_peaks(Peaks of, const PackedRows& weights, const double* offset, Index count, const double* x, Index stride,
                 double* peak, double* values, const PackedRows::Columns* columns = nullptr);

/// Raises `largest` of four rows by the sums of such values of four rows and of four others, at `count` vectors.
void raise_sums(Index count, const double* values, const double* others, double* largest);

/// The first of `count` steps between two vectors of such values of four rows, from `step` on, in which one of them may
/// come further than `known`: than at either end by so many times `of` as `between` has for that step. `count` where
/// none may.
[[nodiscard]] Index first_beyond(Index step, Index count, const double* values, const double* between, const double* of,
                                 const double* known);

/// For each of the vectors of such values of n rows, the largest value as a part of a limit, the limits given by what
/// is inverse to them; rows of zeros have no say.
void largest_shares(Index n, Index count, const double* values, const double* inverse, double* share);

/// Σ_j w_j x_j of `count` vectors x, `stride` apart, over runs of columns (multiples of four).
void sums(Index count, const double* x, Index stride, std::span<const PackedRows::Run> runs, const double* weights,
          double* result);

/// How many of n numbers x, a multiple of four, are not at most y.
[[nodiscard]] Index count_above(Index n, const double* x, const double* y);

/// Where |x|, |y| ≤ rest · peak for four numbers each, `before` becomes 0, elsewhere infinite; n is a multiple of four.
void mark_unsettled(Index n, const double* x, const double* y, Index stride, const double* peak, double rest,
                    double* before);

/// The largest |w_rj|/limit_r of every column j that any row depends on; rows of zeros have no say.
void lump(const PackedRows& weights, const double* limits, double* largest);

/// The polynomial of row r of coordinates whose coefficients begin at `c`. `scratch` has as many entries as columns.
void combine(const PackedRows& weights, Index r, const double* c, Index stride, int degree, double* scratch,
             double* polynomial);

}  // namespace bentur::engine::kernels
