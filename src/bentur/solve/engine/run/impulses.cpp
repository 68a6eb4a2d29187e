#include "bentur/solve/engine/run/impulses.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <vector>

namespace bentur::engine {

using Eigen::Index;
using Eigen::VectorXd;

namespace {

constexpr int most_pivots = 10000;  // far more than any set of floors has been seen to take

}  // namespace

std::optional<VectorXd> impulses(const Eigen::MatrixXd& a, const VectorXd& b) {
  const Index count = b.size();
  const double round_off = 0x1p-48 * b.cwiseAbs().maxCoeff();
  std::vector<Index> pushed;
  for (Index i = 0; i < count; ++i) {
    if (b(i) > 0.0) pushed.push_back(i);
  }
  // Least-index pivoting visits no set twice, of which there are 2^count; in practice a few.
  for (int pivots = 0; pivots < most_pivots; ++pivots) {
    VectorXd p = VectorXd::Zero(count);
    if (!pushed.empty()) p(pushed) = a(pushed, pushed).ldlt().solve(b(pushed)).eval();
    if (!p.allFinite()) break;
    const VectorXd y = a * p - b;
    Index wrong = 0;
    while (wrong < count) {
      const bool is_pushed = p(wrong) != 0.0;
      if (is_pushed ? p(wrong) < 0.0 : y(wrong) < -round_off) break;
      ++wrong;
    }
    if (wrong == count) return p;
    const auto place = std::find(pushed.begin(), pushed.end(), wrong);
    if (place != pushed.end()) {
      pushed.erase(place);
    } else {
      pushed.insert(std::lower_bound(pushed.begin(), pushed.end(), wrong), wrong);
    }
  }
  return std::nullopt;
}

}  // namespace bentur::engine
