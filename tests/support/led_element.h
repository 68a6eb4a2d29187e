#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <vector>

#include "bentur/elements/law.h"

namespace bentur::test {

/// An element of a law with linear branches whose deformation is led to and fro along straight paths at the speed ±1.
/// It is what a solver does with a law, with nothing else around it: the first guard to fail ends the branch.
class LedElement {
 public:
  /// What happened where a branch ended.
  struct Change {
    int from = 0, to = 0;                        ///< branches
    double deformation = 0;                      ///< [length]
    double force_before = 0, force_after = 0;    ///< [force]
    double stored_before = 0, stored_after = 0;  ///< [force·length]
    double least_guard = 0;                      ///< the smallest guard just after; of speed, ±1
  };

  /// `length` [length]: the size of deformations, for round-off.
  LedElement(const Law& law, double length) : law_(law), round_off_(1e-13 * length) {}

  void lead_to(double target) {
    const double speed = target < deformation_ ? -1 : 1;
    for (int changes = 0;; ++changes) {
      if (changes > 100) throw std::runtime_error("branches without end");
      const Branch branch = law_.branch(state_);
      std::size_t failed = branch.guard_count;
      double way = std::abs(target - deformation_);
      for (std::size_t i = branch.guard_count; i-- > 0;) {  // backwards: of several at once the first listed
        const double until = way_until_failure(branch.guards[i], speed);
        if (until <= way) way = until, failed = i;
      }
      if (failed == branch.guard_count) return move_to(target, speed);
      move_to(deformation_ + speed * way, speed);
      change(failed, speed);
    }
  }

  [[nodiscard]] double deformation() const { return deformation_; }
  [[nodiscard]] double force() const { return law_.force(state_, deformation_, 0); }
  [[nodiscard]] double stored() const { return law_.stored_energy(state_, deformation_); }
  [[nodiscard]] double work() const { return work_; }                   ///< ∫ F dδ so far [force·length]
  [[nodiscard]] double hysteretic() const { return work_ - stored(); }  ///< [force·length]
  [[nodiscard]] const LawState& state() const { return state_; }
  [[nodiscard]] const std::vector<Change>& changes() const { return changes_; }

 private:
  [[nodiscard]] double value(const Guard& guard, double speed) const {
    return guard.constant + guard.deformation * deformation_ + guard.speed * speed;
  }

  /// How far it goes until the guard falls below zero by more than round-off; more than any way where it does not.
  [[nodiscard]] double way_until_failure(const Guard& guard, double speed) const {
    const double now = value(guard, speed), slope = guard.deformation * speed;
    if (now < -round_off_) return 0;
    return slope < 0 ? (std::max(now, 0.0) + round_off_) / -slope : HUGE_VAL;
  }

  void move_to(double target, double speed) {
    const double before = law_.force(state_, deformation_, speed), after = law_.force(state_, target, speed);
    work_ += 0.5 * (before + after) * (target - deformation_);
    deformation_ = target;
  }

  void change(std::size_t failed, double speed) {
    Change change = {
        .from = state_.branch, .deformation = deformation_, .force_before = force(), .stored_before = stored()};
    state_ = law_.next(state_, failed, 0, deformation_, speed);
    change.to = state_.branch;
    change.force_after = force();
    change.stored_after = stored();
    const Branch branch = law_.branch(state_);
    for (std::size_t i = 0; i < branch.guard_count; ++i) {
      change.least_guard = std::min(change.least_guard, value(branch.guards[i], speed));
    }
    changes_.push_back(change);
  }

  const Law& law_;
  double round_off_, deformation_ = 0, work_ = 0;
  LawState state_;
  std::vector<Change> changes_;
};

}  // namespace bentur::test
