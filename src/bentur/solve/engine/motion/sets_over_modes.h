#pragma once

#include <memory>
#include <mutex>
#include <unordered_map>
#include <vector>

#include "bentur/solve/engine/motion/modal_system.h"

namespace bentur::engine {

/// What a set of the law of an element of several deformations is over the coordinates of its bodies.
struct SetOverModes {
  std::shared_ptr<const CoupledSet> set;
  Eigen::MatrixXd rows;        ///< what guards look at, over what moves of the bodies: a column each
  kernels::PackedRows packed;  ///< the same
  std::shared_ptr<const ElementForces::Coupled::Modal> modal;  ///< of those that move; none where none does

  /// `rows_of`: δ of all deformations of the element, a column each.
  SetOverModes(const ModalSystem& system, std::size_t element, const Eigen::MatrixXd& rows_of,
               const std::shared_ptr<const CoupledSet>& of);
};

/// Those that runs of one system have met, which recur. Many threads may ask at a time.
class SetsOverModes {
 public:
  [[nodiscard]] std::shared_ptr<const SetOverModes> of(const ModalSystem& system, std::size_t element,
                                                       const Eigen::MatrixXd& rows_of,
                                                       const std::shared_ptr<const CoupledSet>& set);

 private:
  static constexpr Eigen::Index most_numbers = Eigen::Index{1} << 22;  // 32 MB; then it begins anew

  std::mutex mutex_;
  Eigen::Index numbers_ = 0;
  /// Per element, as two may share a law.
  std::vector<std::unordered_map<const CoupledSet*, std::shared_ptr<const SetOverModes>>> known_;
};

}  // namespace bentur::engine
