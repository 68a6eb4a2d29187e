#include "bentur/solve/engine/motion/kernels/rows.h"

#include <algorithm>
#include <limits>

#include "bentur/solve/engine/motion/kernels/four.h"

namespace bentur::engine::kernels {
namespace {

using Run = PackedRows::Run;

/// Four rows of a matrix at two vectors, and Σ |w_rj| rise_j.
struct Ends {
  Four start, end, beyond;
};
BENTUR_INLINE Ends ends_of_rows(const PackedRows& rows, Index r, Four offset, const double* start, const double* end,
                                const double* rise) {
  Ends at{offset, offset, all(0.0)};
  for (const Run& run : rows.runs(r)) {
    const double* weights = rows.from(r, run);
    for (Index j = run.begin; j < run.end; ++j) {
      const Four weight = load(weights + four * j);
      at.start += weight * all(start[j]);
      at.end += weight * all(end[j]);
      at.beyond += abs(weight) * all(rise[j]);
    }
  }
  return at;
}

template <Peaks of>
BENTUR_INLINE Four measure(Four x) {
  if constexpr (of == Peaks::of_abs) return abs(x);
  return x;
}

template <Peaks of>
BENTUR_INLINE bool reach(const PackedRows& rows, const double* offset, const double* start, const double* end,
                         const double* rise, double* peak, const double* reach_before, double* reach) {
  Bits beyond_peak{};
  for (Index r = 0; r < rows.rows(); r += four) {
    const Four before = load(peak + r);
    const Four so_far = load(reach_before + r);
    store(reach + r, so_far);
    if (every(so_far <= before)) continue;
    const Ends at = ends_of_rows(rows, r, load(offset + r), start, end, rise);
    const Four most = max(measure<of>(at.start), measure<of>(at.end));
    const Four high = max(before, most);
    store(peak + r, high);
    store(reach + r, most + at.beyond);
    beyond_peak |= ~(most + at.beyond <= high);
  }
  return !any(beyond_peak);
}

/// The largest value (or size) of a cubic on [0, 1] by its values and slopes at both ends.
template <Peaks of>
BENTUR_INLINE Four largest_of_cubic(Four start, Four end, Four slope, Four slope_end) {
  // start + s (slope + s (b + s a)), whose slope is zero where s (2 b + 3 a s) = −slope.
  const Four a = all(2.0) * (start - end) + (slope + slope_end);
  const Four b = all(3.0) * (end - start) - (slope + slope) - slope_end;
  const Four spread = root(max(b * b - all(3.0) * a * slope, all(0.0)));
  const Four both = b < all(0.0) ? b - spread : b + spread;
  const auto at = [&](Four s) __attribute__((always_inline)) {
    s = s > all(0.0) ? s : all(0.0);  // what is no number too
    s = s < all(1.0) ? s : all(1.0);
    return measure<of>(start + s * (slope + s * (b + s * a)));
  };
  return max(max(measure<of>(start), measure<of>(end)), max(at(-both / (all(3.0) * a)), at(-slope / both)));
}

template <Peaks of>
BENTUR_INLINE bool reach(const PackedRows& rows, const double* offset, const CubicCurves& curves, double* peak,
                         const double* reach_before, double* reach) {
  Bits beyond_peak{};
  for (Index r = 0; r < rows.rows(); r += four) {
    const Four before = load(peak + r);
    const Four so_far = load(reach_before + r);
    store(reach + r, so_far);
    if (every(so_far <= before)) continue;
    Ends at{load(offset + r), load(offset + r), all(0.0)};
    Four slope = all(0.0);
    Four slope_end = all(0.0);
    for (const Run& run : rows.runs(r)) {
      const double* weights = rows.from(r, run);
      for (Index j = run.begin; j < run.end; ++j) {
        const Four weight = load(weights + four * j);
        at.start += weight * all(curves.start[j]);
        at.end += weight * all(curves.end[j]);
        slope += weight * all(curves.slope[j]);
        slope_end += weight * all(curves.slope_end[j]);
        at.beyond += abs(weight) * all(curves.rise[j]);
      }
    }
    const Four high = max(before, max(measure<of>(at.start), measure<of>(at.end)));
    const Four most = largest_of_cubic<of>(at.start, at.end, slope, slope_end) + at.beyond;
    store(peak + r, high);
    store(reach + r, most);
    beyond_peak |= ~(most <= high);
  }
  return !any(beyond_peak);
}

/// Rows r to r + 4 groups - 1 of raise_peaks().
template <Peaks of, int groups>
BENTUR_INLINE void raise_groups(const PackedRows& rows, std::span<const Run> runs, const double* offset, Index r,
                                Index count, const double* x, Index stride, double* peak, double* values) {
  // NOLINTBEGIN(modernize-avoid-c-arrays): registers
  const double* weights[groups];
  Four high[groups];
  Four rest[groups];
  for (int g = 0; g < groups; ++g) {
    weights[g] = rows.held(r + four * g);
    rest[g] = load(offset + r + four * g);
    high[g] = load(peak + r + four * g);
  }
  const auto take = [&](int g, Index i, Four value) __attribute__((always_inline)) {
    const Four most = measure<of>(value);
    store(values + (r + four * g) * count + four * i, most);
    high[g] = max(high[g], most);
  };
  Index i = 0;
  for (; i + four <= count; i += four) {
    const double* at[four];
    for (Index k = 0; k < four; ++k) at[k] = x + (i + k) * stride;
    Four value[groups][four];
    for (int g = 0; g < groups; ++g) {
      for (Index k = 0; k < four; ++k) value[g][k] = rest[g];
    }
    Index passed = 0;
    for (const Run& run : runs) {
      for (Index k = 0; k < four; ++k) at[k] += run.left_out - passed;
      passed = run.left_out;
      for (Index j = run.begin - passed; j < run.end - passed; ++j) {
        Four weight[groups];
        for (int g = 0; g < groups; ++g) weight[g] = load(weights[g] + four * j);
        for (Index k = 0; k < four; ++k) {
          const Four coordinate = all(at[k][j]);
          for (int g = 0; g < groups; ++g) value[g][k] += weight[g] * coordinate;
        }
      }
    }
    for (int g = 0; g < groups; ++g) {
      for (Index k = 0; k < four; ++k) take(g, i + k, value[g][k]);
    }
  }
  for (; i < count; ++i) {
    for (int g = 0; g < groups; ++g) {
      Four value = rest[g];
      for (const Run& run : runs) {
        const double* from = x + i * stride + run.left_out;
        for (Index j = run.begin - run.left_out; j < run.end - run.left_out; ++j) {
          value += load(weights[g] + four * j) * all(from[j]);
        }
      }
      take(g, i, value);
    }
  }
  for (int g = 0; g < groups; ++g) store(peak + r + four * g, high[g]);
  // NOLINTEND(modernize-avoid-c-arrays)
}

template <Peaks of>
BENTUR_INLINE void raise(const PackedRows& rows, const PackedRows::Columns* columns, const double* offset, Index count,
                         const double* x, Index stride, double* peak, double* values) {
  const auto runs = [&](Index r) { return columns != nullptr ? columns->runs(r) : rows.runs(r); };
  Index r = 0;
  for (; r + 2 * four <= rows.rows(); r += 2 * four) {
    raise_groups<of, 2>(rows, runs(r), offset, r, count, x, stride, peak, values);
  }
  if (r < rows.rows()) raise_groups<of, 1>(rows, runs(r), offset, r, count, x, stride, peak, values);
}

/// Of sums().
BENTUR_INLINE void sum_products(Index count, const double* x, Index stride, std::span<const Run> runs,
                                const double* weights, double* result) {
  const auto one = [&](Index i) __attribute__((always_inline)) {
    Four total = all(0.0);
    for (const Run& run : runs) {
      for (Index j = run.begin; j < run.end; j += four) total += load(weights + j) * load(x + i * stride + j);
    }
    return total;
  };
  Index i = 0;
  for (; i + four <= count; i += four) store(result + i, sums_of(one(i), one(i + 1), one(i + 2), one(i + 3)));
  for (; i < count; ++i) result[i] = sum(one(i));
}

/// Where `block` has columns that are not zero, a run for each stretch of them.
std::vector<Run> runs_of(const Eigen::Ref<const Eigen::MatrixXd>& block) {
  constexpr Index near = 4;  // columns of zeros that part no runs
  std::vector<Run> runs;
  for (Index j = 0; j < block.cols(); ++j) {
    if ((block.col(j).array() == 0.0).all()) continue;
    if (runs.empty() || j >= runs.back().end + near) runs.push_back({j, j});
    runs.back().end = j + 1;
  }
  return runs;
}

/// The same as multiples of four, of `columns` at most.
std::vector<Run> in_fours(const std::vector<Run>& runs, Index columns) {
  std::vector<Run> whole;
  for (const Run& run : runs) {
    const Run wider{run.begin / four * four, std::min(columns, (run.end + four - 1) / four * four)};
    if (!whole.empty() && wider.begin <= whole.back().end) {
      whole.back().end = wider.end;
    } else {
      whole.push_back(wider);
    }
  }
  return whole;
}

}  // namespace

PackedRows::PackedRows(const Eigen::MatrixXd& matrix, Index columns)
    : rows_((matrix.rows() + four - 1) / four * four),
      columns_(columns),
      all_runs_(in_fours(runs_of(matrix), columns)) {
  Index end = 0, left_out = 0;
  for (Run& run : all_runs_) {
    left_out += run.begin - end;
    run.left_out = left_out;
    held_ += run.end - run.begin;
    end = run.end;
  }
  weights_.assign(static_cast<std::size_t>(rows_ * held_), 0.0);
  for (const Run& run : all_runs_) {
    for (Index r = 0; r < matrix.rows(); ++r) {
      double* row = weights_.data() + r / four * four * held_ + r % four;
      for (Index j = run.begin; j < std::min(run.end, matrix.cols()); ++j)
        row[four * (j - run.left_out)] = matrix(r, j);
    }
  }
  for (Index r = 0; r < matrix.rows(); r += 8) {
    runs_.push_back(runs_of(matrix.middleRows(r, std::min<Index>(8, matrix.rows() - r))));
    for (Run& run : runs_.back()) {
      const auto around = std::find_if(all_runs_.begin(), all_runs_.end(),
                                       [&](const Run& one) { return run.begin >= one.begin && run.end <= one.end; });
      run.left_out = around->left_out;
    }
  }
}

PackedRows::Columns PackedRows::chosen(const std::vector<char>& wanted) const {
  Columns columns;
  for (const std::vector<Run>& runs : runs_) {
    std::vector<Run>& parts = columns.runs_.emplace_back();
    for (const Run& run : runs) {
      for (Index j = run.begin; j < run.end; ++j) {
        if (wanted[j] == 0) continue;
        if (parts.empty() || parts.back().end != j || j == run.begin) parts.push_back({j, j, run.left_out});
        parts.back().end = j + 1;
      }
    }
  }
  return columns;
}

double PackedRows::operator()(Index row, Index column) const {
  for (const Run& run : all_runs_) {
    if (column >= run.begin && column < run.end) return from(row / four * four, run)[four * column + row % four];
  }
  return 0.0;
}

BENTUR_FOR_ALL_PROCESSORS
bool reach_of_rows(Peaks of, const PackedRows& rows, const double* offset, const double* start, const double* end,
                   const double* rise, double* peak, const double* before, double* reach_now) {
  if (of == Peaks::of_abs) return reach<Peaks::of_abs>(rows, offset, start, end, rise, peak, before, reach_now);
  return reach<Peaks::of_values>(rows, offset, start, end, rise, peak, before, reach_now);
}

BENTUR_FOR_ALL_PROCESSORS
bool reach_of_cubics(Peaks of, const PackedRows& rows, const double* offset, const CubicCurves& curves, double* peak,
                     const double* before, double* reach_now) {
  if (of == Peaks::of_abs) return reach<Peaks::of_abs>(rows, offset, curves, peak, before, reach_now);
  return reach<Peaks::of_values>(rows, offset, curves, peak, before, reach_now);
}

BENTUR_FOR_ALL_PROCESSORS
Index fours_beyond(const PackedRows& rows, const double* start, const double* end, const double* rise,
                   const double* least, const double* most, double* low, double* high, Index* fours) {
  Index count = 0;
  for (Index r = 0; r < rows.rows(); r += four) {
    const Ends at = ends_of_rows(rows, r, all(0.0), start, end, rise);
    const Four lowest = -max(-at.start, -at.end) - at.beyond, highest = max(at.start, at.end) + at.beyond;
    if (every((lowest >= load(least + r)) & (highest <= load(most + r)))) continue;
    store(low + r, lowest);
    store(high + r, highest);
    fours[count++] = r;
  }
  return count;
}

BENTUR_FOR_ALL_PROCESSORS
bool reach_of_samples(const PackedRows& rows, const double* offset, int count, const double* x, const double* rise,
                      double* peak, const double* reach_before, double* reach) {
  const Index columns = rows.columns();
  Bits beyond_peak{};
  for (Index r = 0; r < rows.rows(); r += four) {
    const Four before = load(peak + r);
    const Four so_far = load(reach_before + r);
    store(reach + r, so_far);
    if (every(so_far <= before)) continue;
    Four most = all(0.0);
    Four beyond = all(0.0);
    for (const Run& run : rows.runs()) {
      const double* weights = rows.from(r, run);
      for (Index j = run.begin; j < run.end; ++j) beyond += abs(load(weights + four * j)) * all(rise[j]);
    }
    int i = 0;
    for (; i + 3 <= count; i += 3) {
      const double* at = x + i * columns;
      const Four start = load(offset + r);
      Four value[3] = {start, start, start};  // NOLINT(modernize-avoid-c-arrays): registers
      for (const Run& run : rows.runs()) {
        const double* weights = rows.from(r, run);
        for (Index j = run.begin; j < run.end; ++j) {
          const Four weight = load(weights + four * j);
          value[0] += weight * all(at[j]);
          value[1] += weight * all(at[columns + j]);
          value[2] += weight * all(at[2 * columns + j]);
        }
      }
      most = max(most, max(abs(value[0]), max(abs(value[1]), abs(value[2]))));
    }
    for (; i < count; ++i) {
      Four value = load(offset + r);
      for (const Run& run : rows.runs()) {
        const double* weights = rows.from(r, run);
        for (Index j = run.begin; j < run.end; ++j) value += load(weights + four * j) * all(x[i * columns + j]);
      }
      most = max(most, abs(value));
    }
    const Four high = max(before, most);
    store(peak + r, high);
    store(reach + r, most + beyond);
    beyond_peak |= ~(most + beyond <= high);
  }
  return !any(beyond_peak);
}

BENTUR_FOR_ALL_PROCESSORS
void raise_peaks(Peaks of, const PackedRows& rows, const double* offset, Index count, const double* x, Index stride,
                 double* peak, double* values, const PackedRows::Columns* columns) {
  if (of == Peaks::of_abs) return raise<Peaks::of_abs>(rows, columns, offset, count, x, stride, peak, values);
  raise<Peaks::of_values>(rows, columns, offset, count, x, stride, peak, values);
}

BENTUR_FOR_ALL_PROCESSORS
void raise_sums(Index count, const double* values, const double* others, double* largest) {
  Four high = load(largest);
  for (Index n = 0; n < four * count; n += four) high = max(load(values + n) + load(others + n), high);
  store(largest, high);
}

BENTUR_FOR_ALL_PROCESSORS
Index first_beyond(Index step, Index count, const double* values, const double* between, const double* of,
                   const double* known) {
  const Four part = load(of);
  const Four most = load(known);
  const auto below = [&](Index n, Four beyond) __attribute__((always_inline))->Bits {
    return load(values + four * n) + beyond <= most;  // not what cannot be compared
  };
  for (; step < count; ++step) {
    const Four beyond = all(between[step]) * part;
    if (!every(below(step, beyond) & below(step + 1, beyond))) break;
  }
  return step;
}

BENTUR_FOR_ALL_PROCESSORS
void largest_shares(Index n, Index count, const double* values, const double* inverse, double* share) {
  const auto most = [&](Index i) __attribute__((always_inline)) {
    Four result = all(0.0);
    for (Index r = 0; r < n; r += four) {
      const Four part = load(values + r * count + four * i) * load(inverse + r);
      result = part > result ? part : result;  // 0 of 0 is no share
    }
    return result;
  };
  Index i = 0;
  for (; i + four <= count; i += four) store(share + i, largest_of(most(i), most(i + 1), most(i + 2), most(i + 3)));
  for (; i < count; ++i) {
    const Four parts = most(i);
    share[i] = std::max(std::max(parts[0], parts[1]), std::max(parts[2], parts[3]));
  }
}

BENTUR_FOR_ALL_PROCESSORS
void sums(Index count, const double* x, Index stride, std::span<const Run> runs, const double* weights,
          double* result) {
  sum_products(count, x, stride, runs, weights, result);
}

BENTUR_FOR_ALL_PROCESSORS
Index count_above(Index n, const double* x, const double* y) {
  Bits count{};
  for (Index r = 0; r < n; r += four) count -= ~(load(x + r) <= load(y + r));  // true is −1
  return static_cast<Index>((count[0] + count[1]) + (count[2] + count[3]));
}

BENTUR_FOR_ALL_PROCESSORS
void mark_unsettled(Index n, const double* x, const double* y, Index stride, const double* peak, double rest,
                    double* before) {
  constexpr double unknown = std::numeric_limits<double>::infinity();
  for (Index r = 0; r < n; r += four) {
    const Four most = max(load(x + r * stride), load(y + r * stride));
    const bool below = every(most <= all(rest) * load(peak + r));  // not what cannot be compared
    store(before + r, all(below ? 0.0 : unknown));
  }
}

BENTUR_FOR_ALL_PROCESSORS
void lump(const PackedRows& rows, const double* limits, double* largest) {
  for (const Run& run : rows.runs()) {
    for (Index j = run.begin; j < run.end; ++j) {
      Four most = all(0.0);
      for (Index r = 0; r < rows.rows(); r += four) {
        const Four share = abs(load(rows.from(r, run) + four * j)) / load(limits + r);
        most = share > most ? share : most;  // 0/0 is no share
      }
      largest[j] = std::max(std::max(most[0], most[1]), std::max(most[2], most[3]));
    }
  }
}

BENTUR_FOR_ALL_PROCESSORS
void combine(const PackedRows& rows, Index r, const double* c, Index stride, int degree, double* scratch,
             double* polynomial) {
  for (const Run& run : rows.runs()) {
    const double* weights = rows.from(r / four * four, run) + r % four;
    for (Index j = run.begin; j < run.end; ++j) scratch[j] = weights[four * j];
  }
  const std::span<const Run> runs = rows.runs();
  if (runs.size() == 1) {  // of few bodies, which the compiler then knows
    const Run run = runs.front();
    sum_products(degree + 1, c, stride, {&run, 1}, scratch, polynomial);
  } else {
    sum_products(degree + 1, c, stride, runs, scratch, polynomial);
  }
}

}  // namespace bentur::engine::kernels
