#pragma once

#include <Eigen/Core>
#include <cmath>
#include <cstddef>
#include <memory>
#include <string_view>
#include <vector>

#include "bentur/elements/law.h"

namespace bentur {

/// Where an element of several deformations stands in its law. A law reads and writes it, a solver carries it.
struct CoupledState {
  double since = 0;        ///< when its branch began [s]
  Eigen::MatrixXd memory;  ///< the law's own, a row per deformation
  /// What the law has worked out of them, and need not anew; null: nothing.
  std::shared_ptr<const void> known = nullptr;
};

/// The deformations δ of an element at an instant, how fast they change, and how fast that does.
struct CoupledMotion {
  Eigen::VectorXd deformation, speed, acceleration;
  double soon = 0;  ///< a time [s] so short that nothing vibrates in it
};

/// What all branches of a law have in common in which the same deformations move.
struct CoupledSet {
  std::vector<Eigen::Index> moving;    ///< those whose force is not constant: K and C are of these
  Eigen::MatrixXd stiffness, damping;  ///< K, C; C empty: none
  /// What guards look at, sums of deformations, a row each: δ of `own` (−1: none) + `over` · δ of those that move.
  std::vector<Eigen::Index> own;
  Eigen::MatrixXd over;

  /// A row as factors of all `size` deformations.
  [[nodiscard]] Eigen::VectorXd row(Eigen::Index of, Eigen::Index size) const {
    Eigen::VectorXd result = Eigen::VectorXd::Zero(size);
    if (own[of] >= 0) result(own[of]) = 1.0;
    for (std::size_t n = 0; n < moving.size(); ++n) result(moving[n]) += over(of, static_cast<Eigen::Index>(n));
    return result;
  }
};

/// A branch lasts while  constant + sense · (δ + δ̇ + δ̈ of a row each) ≥ 0, with the tolerance of Guard. All terms have
/// one dimension [X].
struct CoupledGuard {
  Eigen::Index of = 0;  ///< which deformation it is about, for the law
  double constant = 0;  ///< [X]
  double size = 0;      ///< of what `constant` is a sum of [X]
  double sense = 1;     ///< 1 or −1
  /// Rows of the branch's CoupledSet; −1: none. δ̈ may jump where another force does.
  Eigen::Index deformation = -1, speed = -1, acceleration = -1;
  int zeros = 0;  ///< it begins the branch at zero, and so do that many less one of its derivatives
};

/// Guards  least ≤ row ≤ most  of the rows of a branch's CoupledSet, row by row, each about the deformation of that
/// number; infinite: none. All empty: no row has any.
struct CoupledBounds {
  Eigen::VectorXd least, most;            ///< [X]
  Eigen::VectorXd least_size, most_size;  ///< as CoupledGuard::size
};

/// Between two events an element is in one branch of its law: F = base + K δ + C δ̇.
struct CoupledBranch {
  std::shared_ptr<const CoupledSet> set;  ///< what of it is the same in others
  Eigen::VectorXd base;                   ///< [force] of each deformation
  std::vector<CoupledGuard> guards;       ///< what ends it: the first to fail; if several at once, the first listed
  CoupledBounds bounds = {};              ///< and after them these, of each row `most` and then `least`

  [[nodiscard]] std::size_t guard_count() const {
    return guards.size() + 2 * static_cast<std::size_t>(bounds.most.size());
  }
  /// Number of the guard that says how high, or else how low, a row may be; −1: none among the bounds.
  [[nodiscard]] int bound(Eigen::Index row, bool high) const {
    if (row >= bounds.most.size() || std::isinf(high ? bounds.most(row) : bounds.least(row))) return -1;
    return static_cast<int>(guards.size()) + 2 * static_cast<int>(row) + (high ? 0 : 1);
  }
  /// Number g of all. That of a row without bound has an infinite constant.
  [[nodiscard]] CoupledGuard guard(std::size_t g) const {
    if (g < guards.size()) return guards[g];
    const auto row = static_cast<Eigen::Index>((g - guards.size()) / 2);
    const bool high = (g - guards.size()) % 2 == 0;
    return {.of = row,
            .constant = high ? bounds.most(row) : -bounds.least(row),
            .size = (high ? bounds.most_size : bounds.least_size)(row),
            .sense = high ? -1.0 : 1.0,
            .deformation = row};
  }
};

/// A law whose deformations act on one another: a machine of branches like Law, with matrices in place of numbers. The
/// forces F work along their deformations: ∫ Σ F_i dδ_i is what the element takes in. Immutable, as Law.
/// (docs/theory/hinges.md)
class CoupledLaw {
 public:
  virtual ~CoupledLaw() = default;

  [[nodiscard]] virtual std::string_view name() const noexcept = 0;
  /// Number of deformations.
  [[nodiscard]] virtual Eigen::Index size() const noexcept = 0;
  /// Whether it is the same law with the same numbers.
  [[nodiscard]] virtual bool same_as(const CoupledLaw& other) const = 0;

  /// As it is when it has been brought from rest to δ in one go; nothing has happened before.
  [[nodiscard]] virtual CoupledState begin(const Eigen::VectorXd& deformation) const = 0;

  [[nodiscard]] virtual CoupledBranch branch(const CoupledState& state) const = 0;

  /// The state after guard number `guard` of its branch, which is given, has come down to zero at `time` [s].
  [[nodiscard]] virtual CoupledState next(const CoupledState& state, const CoupledBranch& branch, std::size_t guard,
                                          double time, const CoupledMotion& motion) const = 0;
  /// The state after speeds have jumped at `time` [s]: `motion` is that after it.
  [[nodiscard]] virtual CoupledState settle(const CoupledState& state, double time,
                                            const CoupledMotion& motion) const = 0;
  /// The state with what it remembers up to date, in the same branch.
  [[nodiscard]] virtual CoupledState at(const CoupledState& state, const Eigen::VectorXd& deformation) const = 0;

  /// Energy [force·length] that the element would give back if it were unloaded slowly from here, and that it has lost.
  [[nodiscard]] virtual double stored_energy(const CoupledState& state, const Eigen::VectorXd& deformation) const = 0;
  [[nodiscard]] virtual double lost_energy(const CoupledState& state, const Eigen::VectorXd& deformation) const = 0;

  /// Whether the opposite course of δ from rest gives the opposite forces.
  [[nodiscard]] virtual bool is_odd() const noexcept { return false; }
};

}  // namespace bentur
