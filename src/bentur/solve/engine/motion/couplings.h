#pragma once

#include <Eigen/Core>
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
  /// Rows and columns of these elements alone.
  [[nodiscard]] Eigen::MatrixXd among(const std::vector<Eigen::Index>& elements) const;

 private:
  [[nodiscard]] double entry(Eigen::Index row, Eigen::Index column) const;

  Eigen::MatrixXd whole_;
  std::vector<std::vector<std::pair<Eigen::Index, double>>> rows_;  // in place of it, by ascending columns
};

}  // namespace bentur::engine
