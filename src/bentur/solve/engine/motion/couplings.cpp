#include "bentur/solve/engine/motion/couplings.h"

#include <algorithm>

namespace bentur::engine {

using Eigen::Index;

Couplings::Couplings(Index count) {
  if (count <= most_whole) {
    whole_.setZero(count, count);
  } else {
    rows_.resize(static_cast<std::size_t>(count));
  }
}

void Couplings::set_row(Index row, const std::vector<std::pair<Index, double>>& entries) {
  if (rows_.empty()) {
    for (const auto& [column, value] : entries) whole_(row, column) = value;
    return;
  }
  auto& kept = rows_[static_cast<std::size_t>(row)];
  kept = entries;
  std::sort(kept.begin(), kept.end());
}

double Couplings::entry(Index row, Index column) const {
  const auto& kept = rows_[static_cast<std::size_t>(row)];
  const auto found = std::lower_bound(kept.begin(), kept.end(), column,
                                      [](const auto& one, Index sought) { return one.first < sought; });
  return found != kept.end() && found->first == column ? found->second : 0.0;
}

Eigen::MatrixXd Couplings::among(const std::vector<Index>& elements) const {
  Eigen::MatrixXd result(std::ssize(elements), std::ssize(elements));
  for (Index i = 0; i < result.rows(); ++i) {
    for (Index j = 0; j < result.cols(); ++j) result(i, j) = (*this)(elements[i], elements[j]);
  }
  return result;
}

}  // namespace bentur::engine
