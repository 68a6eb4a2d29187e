#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <utility>
#include <vector>

namespace bentur::engine {

/// How elements push one another through bodies that they share, elements × elements [1/mass]. Elements of a block of
/// houses share none with nearly all others: of many of them only what is not zero is kept.
class Couplings {
 public:
  /// Of so many elements as are held whole.
  static constexpr Eigen::Index most_whole = 512;

  Couplings() = default;
  explicit Couplings(Eigen::Index count);

  /// Of one row, in any order, each column once.
  void set_row(Eigen::Index row, const std::vector<std::pair<Eigen::Index, double>>& entries);
  [[nodiscard]] double operator()(Eigen::Index row, Eigen::Index column) const {
    return whole_.size() > 0 ? whole_(row, column) : entry(row, column);
  }
  /// Hands on what is not zero of a row, of some columns in ascending order.
  template <class Take>
  void in_row(Eigen::Index row, const std::vector<Eigen::Index>& columns, const Take& take) const {
    if (rows_.empty() || rows_[static_cast<std::size_t>(row)].size() > columns.size()) {
      for (const Eigen::Index column : columns) take(column, (*this)(row, column));
      return;
    }
    for (const auto& [column, value] : rows_[static_cast<std::size_t>(row)]) {
      if (std::binary_search(columns.begin(), columns.end(), column)) take(column, value);
    }
  }
  /// Rows and columns of these elements alone.
  [[nodiscard]] Eigen::MatrixXd among(const std::vector<Eigen::Index>& elements) const;

 private:
  [[nodiscard]] double entry(Eigen::Index row, Eigen::Index column) const;

  Eigen::MatrixXd whole_;
  std::vector<std::vector<std::pair<Eigen::Index, double>>> rows_;  // in place of it, by ascending columns
};

}  // namespace bentur::engine
