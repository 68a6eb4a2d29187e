#pragma once

#include <vector>

namespace bentur {

/// Numbers x between bounds for which cost·x is least and no row of·x exceeds its bound.
struct LinearProgram {
  struct Row {
    std::vector<double> of;
    double bound = 0;
  };
  std::vector<double> cost, low, high;
  std::vector<double> start;  ///< that satisfies the rows
  std::vector<Row> rows;
};

/// By sequential least squares (SLSQP [Kraft1994], NLopt), which solves such a program in a few steps: near the least.
[[nodiscard]] std::vector<double> minimum(const LinearProgram& program);

}  // namespace bentur
