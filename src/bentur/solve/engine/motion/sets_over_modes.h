#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <utility>

#include "bentur/solve/engine/motion/modal_system.h"

namespace bentur::engine {

/// What a set of the law of an element of several deformations is over the coordinates of its bodies.
struct SetOverModes {
  std::shared_ptr<const CoupledSet> set;
  Eigen::MatrixXd rows;          ///< what guards look at, over what moves of the bodies: a column each
  kernels::PackedRows packed;    ///< the same
  std::vector<Eigen::Index> at;  ///< of ModalSystem::elements, those that move
  std::shared_ptr<const ElementForces::Coupled::Modal> modal;  ///< of these; none where none moves

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
  /// Two elements may share a law.
  std::map<std::pair<std::size_t, const CoupledSet*>, std::shared_ptr<const SetOverModes>> known_;
};

}  // namespace bentur::engine
