#include "bentur/solve/motion/kernels/rows.h"

#include <algorithm>
#include <limits>

#include "bentur/solve/motion/kernels/four.h"

namespace bentur::engine::kernels {
namespace {

/// Four rows of a matrix at two vectors, and Σ |w_rj| rise_j.
struct Ends {
  Four start, end, beyond;
};
BENTUR_INLINE Ends ends_of_rows(Index columns, const double* weights, const double* start, const double* end,
                                const double* rise) {
  Ends at{all(0.0), all(0.0), all(0.0)};
  for (Index j = 0; j < columns; ++j) {
    const Four weight = load(weights + four * j);
    at.start += weight * all(start[j]);
    at.end += weight * all(end[j]);
    at.beyond += size(weight) * all(rise[j]);
  }
  return at;
}

}  // namespace

PackedRows::PackedRows(const Eigen::MatrixXd& matrix, Index columns)
    : rows_((matrix.rows() + four - 1) / four * four),
      columns_(columns),
      weights_(static_cast<std::size_t>(rows_ * columns), 0.0) {
  for (Index r = 0; r < matrix.rows(); ++r) {
    for (Index j = 0; j < matrix.cols(); ++j) {
      weights_[static_cast<std::size_t>(r / four * four * columns + four * j + r % four)] = matrix(r, j);
    }
  }
}

BENTUR_FOR_ALL_PROCESSORS
bool reach_of_rows(const PackedRows& rows, const double* start, const double* end, const double* rise, double* peak,
                   const double* reach_before, double* reach) {
  Bits beyond_peak{};
  for (Index r = 0; r < rows.rows(); r += four) {
    const Four before = load(peak + r);
    const Four so_far = load(reach_before + r);
    store(reach + r, so_far);
    if (!any(so_far > before)) continue;
    const Ends at = ends_of_rows(rows.columns(), rows.from(r), start, end, rise);
    const Four most = larger(size(at.start), size(at.end));
    const Four high = larger(before, most);
    store(peak + r, high);
    store(reach + r, most + at.beyond);
    beyond_peak |= most + at.beyond > high;
  }
  return !any(beyond_peak);
}

BENTUR_FOR_ALL_PROCESSORS
bool reach_of_samples(const PackedRows& rows, int count, const double* x, const double* rise, double* peak,
                      const double* reach_before, double* reach) {
  const Index columns = rows.columns();
  Bits beyond_peak{};
  for (Index r = 0; r < rows.rows(); r += four) {
    const Four before = load(peak + r);
    const Four so_far = load(reach_before + r);
    store(reach + r, so_far);
    if (!any(so_far > before)) continue;
    const double* weights = rows.from(r);
    Four most = all(0.0);
    Four beyond = all(0.0);
    for (Index j = 0; j < columns; ++j) beyond += size(load(weights + four * j)) * all(rise[j]);
    int i = 0;
    for (; i + 3 <= count; i += 3) {
      const double* at = x + i * columns;
      Four value[3] = {};  // NOLINT(modernize-avoid-c-arrays): registers
      for (Index j = 0; j < columns; ++j) {
        const Four weight = load(weights + four * j);
        value[0] += weight * all(at[j]);
        value[1] += weight * all(at[columns + j]);
        value[2] += weight * all(at[2 * columns + j]);
      }
      most = larger(most, larger(size(value[0]), larger(size(value[1]), size(value[2]))));
    }
    for (; i < count; ++i) {
      Four value = all(0.0);
      for (Index j = 0; j < columns; ++j) value += load(weights + four * j) * all(x[i * columns + j]);
      most = larger(most, size(value));
    }
    const Four high = larger(before, most);
    store(peak + r, high);
    store(reach + r, most + beyond);
    beyond_peak |= most + beyond > high;
  }
  return !any(beyond_peak);
}

BENTUR_FOR_ALL_PROCESSORS
void lowest_of_rows(const PackedRows& rows, const double* start, const double* end, const double* rise, double* lowest,
                    double* beyond) {
  for (Index r = 0; r < rows.rows(); r += four) {
    const Ends at = ends_of_rows(rows.columns(), rows.from(r), start, end, rise);
    store(lowest + r, smaller(at.start, at.end));
    store(beyond + r, at.beyond);
  }
}

BENTUR_FOR_ALL_PROCESSORS
void raise_peaks(const PackedRows& rows, Index count, const double* x, Index apart, double* peak, double* share,
                 double* room) {
  for (Index r = 0; r < rows.rows(); r += four) {
    const double* weights = rows.from(r);
    double* values = room + r * count;
    Four high = load(peak + r);
    Index i = 0;
    for (; i + four <= count; i += four) {
      const double* at = x + i * apart;
      Four value[four] = {};  // NOLINT(modernize-avoid-c-arrays): registers
      for (Index j = 0; j < rows.columns(); ++j) {
        const Four weight = load(weights + four * j);
        for (Index k = 0; k < four; ++k) value[k] += weight * all(at[k * apart + j]);
      }
      for (Index k = 0; k < four; ++k) {
        const Four most = size(value[k]);
        store(values + four * (i + k), most);
        high = larger(high, most);
      }
    }
    for (; i < count; ++i) {
      Four value = all(0.0);
      for (Index j = 0; j < rows.columns(); ++j) value += load(weights + four * j) * all(x[i * apart + j]);
      store(values + four * i, size(value));
      high = larger(high, size(value));
    }
    store(peak + r, high);
  }
  for (Index i = 0; i < count; ++i) {
    Four most = all(0.0);
    for (Index r = 0; r < rows.rows(); r += four) {
      const Four part = load(room + r * count + four * i) / load(peak + r);
      most = part > most ? part : most;  // 0/0 is no share
    }
    share[i] = std::max(std::max(most[0], most[1]), std::max(most[2], most[3]));
  }
}

BENTUR_FOR_ALL_PROCESSORS
void open_groups(Index n, const double* x, const double* y, Index apart, const double* peak, double rest,
                 double* open) {
  constexpr double unknown = std::numeric_limits<double>::infinity();
  for (Index r = 0; r < n; r += four) {
    const Four most = larger(load(x + r * apart), load(y + r * apart));
    const Bits near = ~(most <= all(rest) * load(peak + r));  // so is what cannot be compared
    store(open + r, all(any(near) ? unknown : 0.0));
  }
}

BENTUR_FOR_ALL_PROCESSORS
void lump(const PackedRows& rows, Index first, Index count, const double* limits, double* largest) {
  for (Index j = first; j < first + count; ++j) {
    Four most = all(0.0);
    for (Index r = 0; r < rows.rows(); r += four) {
      const Four share = size(load(rows.from(r) + four * j)) / load(limits + r);
      most = share > most ? share : most;  // 0/0 is no share
    }
    largest[j - first] = std::max(std::max(most[0], most[1]), std::max(most[2], most[3]));
  }
}

BENTUR_FOR_ALL_PROCESSORS
void combine(const PackedRows& rows, Index r, const double* c, Index stride, int degree, double* room,
             double* polynomial) {
  for (Index j = 0; j < rows.columns(); ++j) room[j] = rows(r, j);
  for (int k = 0; k <= degree; ++k) polynomial[k] = sum(product(rows.columns(), room, c + k * stride));
}

}  // namespace bentur::engine::kernels
