// Columns that stay what they are are multiplied once: what comes of it is what every instant alone gives.
#include "bentur/solve/engine/run/watch/bounded_outputs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "tests/support/random_numbers.h"

namespace bentur::engine {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using test::random_numbers;

MatrixXd random_matrix(Index rows, Index columns, int seed) {
  const auto numbers = random_numbers(static_cast<std::size_t>(rows * columns), static_cast<unsigned>(seed));
  return Eigen::Map<const MatrixXd>(numbers.data(), rows, columns);
}

// Of rows with gaps in them, and instants of which some columns stay, none or all.
TEST(BoundedOutputs, TakeColumnsThatStayOnce) {
  constexpr double precision = std::numeric_limits<double>::epsilon();
  for (int seed = 1; seed <= 60; ++seed) {
    SCOPED_TRACE(seed);
    const Index rows = 5 + seed % 20, columns = 24 + 4 * (seed % 12), ends = 2 + 7 * (seed % 13);
    MatrixXd weights = random_matrix(rows, columns, seed);
    if (seed % 3 == 0) weights.topRows(4).rightCols(columns / 2).setZero();
    if (seed % 4 == 0) weights.middleCols(columns / 3, 9).setZero();
    MatrixXd x = random_matrix(columns, ends, 100 + seed);
    const Index one_in = seed % 5;  // 0: all stay
    for (Index j = 0; j < columns; ++j) {
      if (one_in == 0 || j % one_in != 0) x.row(j).setConstant(x(j, 0));
    }
    for (const auto of : {kernels::Peaks::of_abs, kernels::Peaks::of_values}) {
      BoundedOutputs outputs(weights, columns, of);
      outputs.offset.head(rows) = random_matrix(rows, 1, 200 + seed);
      outputs.take_ends(ends - 1, x.data(), columns);
      MatrixXd values = (weights * x).colwise() + outputs.offset.head(rows);
      if (of == kernels::Peaks::of_abs) values = values.cwiseAbs();
      const Eigen::VectorXd sizes = weights.cwiseAbs() * x.cwiseAbs().rowwise().maxCoeff();
      for (Index r = 0; r < rows; ++r) {
        const double near = static_cast<double>(columns) * precision * (1.0 + sizes(r));
        EXPECT_NEAR(outputs.peak(r), std::max(values.row(r).maxCoeff(), 0.0), near) << r;
        for (Index n = 0; n + 1 < ends; ++n) {
          EXPECT_NEAR(outputs.larger_value(r, n), std::max(values(r, n), values(r, n + 1)), near) << r << ' ' << n;
        }
      }
    }
  }
}

}  // namespace
}  // namespace bentur::engine
