#include "bentur/solve/engine/motion/sets_over_modes.h"

namespace bentur::engine {

using Eigen::Index;
using Eigen::MatrixXd;

SetOverModes::SetOverModes(const ModalSystem& system, std::size_t element, const MatrixXd& rows_of,
                           const std::shared_ptr<const CoupledSet>& of)
    : set(of) {
  const MatrixXd moving = rows_of(Eigen::all, set->moving);
  rows.noalias() = moving * set->over.transpose();
  for (std::size_t r = 0; r < set->own.size(); ++r) {
    if (set->own[r] >= 0) rows.col(static_cast<Index>(r)) += rows_of.col(set->own[r]);
  }
  packed = kernels::PackedRows(rows.transpose(), rows.rows());
  if (set->moving.empty()) return;
  std::vector<Index> at;
  for (const Index n : set->moving) at.push_back(system.coupled[element].first + n);
  modal = std::make_shared<const ElementForces::Coupled::Modal>(system.modal_of(at, set->stiffness, set->damping));
}

std::shared_ptr<const SetOverModes> SetsOverModes::of(const ModalSystem& system, std::size_t element,
                                                      const MatrixXd& rows_of,
                                                      const std::shared_ptr<const CoupledSet>& set) {
  {
    const std::lock_guard lock(mutex_);
    if (known_.size() <= element) known_.resize(element + 1);
    if (const auto found = known_[element].find(set.get()); found != known_[element].end()) return found->second;
  }
  const auto made = std::make_shared<const SetOverModes>(system, element, rows_of, set);
  const Index size =
      2 * made->rows.size() + (made->modal ? 2 * made->modal->pull.size() + made->modal->tied.size() : 0);
  const std::lock_guard lock(mutex_);
  if (numbers_ + size > most_numbers) {
    for (auto& of_element : known_) of_element.clear();
    numbers_ = 0;
  }
  if (known_[element].emplace(set.get(), made).second) numbers_ += size;
  return made;
}

}  // namespace bentur::engine
