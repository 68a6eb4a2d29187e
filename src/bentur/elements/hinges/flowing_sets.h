#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <memory>
#include <mutex>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

#include "bentur/elements/coupled_law.h"
#include "bentur/elements/hinges/hinge_backbone.h"

namespace bentur {

/// What the hinges of a building are, as HingeLaw has them.
struct HingeParameters {
  Eigen::MatrixXd stiffness;  ///< K_hh [force·length/rad], symmetric positive semidefinite
  Eigen::VectorXd hardening;  ///< H [force·length/rad] ≥ 0
  /// What M − H θ may rise to, and −(M − H θ) [force·length] > 0; infinite: not reached.
  Eigen::VectorXd upper, lower;
  Eigen::MatrixXd rows;  ///< G, whose rows tell what of a moment does not depend on x
  /// Of what breaks, such as the shear of a column: the part of (upper + lower)/2 that it keeps once it has been
  /// reached on either side [-], 0 … 1; 1: all, it yields. Empty: nothing breaks. (H-14)
  Eigen::VectorXd kept = {};
  /// Of each; empty: none loses strength. One of an infinite `plastic` does not.
  std::vector<HingeBackbone> backbones = {};
  /// K and G of the frame alone, which say when it can move without bending (H-12); empty: nobody asks.
  Eigen::MatrixXd frame_stiffness = {}, frame_rows = {};
};

/// How fast hinges turn that flow: by Q⁻¹ of (H-4) times the rates of their δ.
struct FlowingPaces {
  Eigen::MatrixXd inverse;  ///< Q⁻¹
  bool apart = true;        ///< no pivot of Q is next to zero: each has a pace of its own
};

/// What follows from which hinges flow, whatever the sides on which they do and however far all have turned. The rows
/// of `seen`, one per hinge: of one at rest y = M − H θ as far as it depends on δ, of one that flows θ.
struct FlowingSet {
  static constexpr double bends = 1e-9;  ///< least part of a frame's stiffness with which it does (H-12)
  CoupledSet seen;
  Eigen::MatrixXd inverse;  ///< Q⁻¹ of (H-4)
  std::vector<char> still;  ///< per hinge: its row is zero whatever x is
  bool movable = false;     ///< the frame moves without bending (H-12)
};

/// The sets that hinges have flowed in: few recur again and again, within a run and in all runs of a study. Many
/// threads may ask at a time, and what they get is the same to the bit whether it was kept or not.
class FlowingSets {
 public:
  static constexpr Eigen::Index most_kept = Eigen::Index{1} << 23;  // numbers: 64 MB

  /// Keeps so many numbers; then it begins anew.
  explicit FlowingSets(Eigen::Index kept) : kept_(kept) {}

  /// `flowing`: hinges, ascending; `slopes`: what their lines rise by as they turn [force·length/rad], empty: H.
  [[nodiscard]] std::shared_ptr<const FlowingSet> of(const HingeParameters& hinges,
                                                     const std::vector<Eigen::Index>& flowing,
                                                     const std::vector<double>& slopes = {}) const;
  /// The paces alone of hinges with H, which are had sooner.
  [[nodiscard]] std::shared_ptr<const FlowingPaces> paces_of(const HingeParameters& hinges,
                                                             const std::vector<Eigen::Index>& flowing) const;

 private:
  using Key = std::pair<std::vector<Eigen::Index>, std::vector<double>>;
  using Sought = std::pair<const std::vector<Eigen::Index>&, const std::vector<double>&>;  // one that is not copied
  struct Hash {
    using is_transparent = void;
    [[nodiscard]] std::size_t operator()(const Sought& key) const;
    [[nodiscard]] std::size_t operator()(const Key& key) const { return (*this)(Sought(key.first, key.second)); }
  };
  struct Same {
    using is_transparent = void;
    [[nodiscard]] bool operator()(const auto& one, const auto& other) const {
      return one.first == other.first && one.second == other.second;
    }
  };
  struct Known {
    std::shared_ptr<const FlowingPaces> paces;
    std::shared_ptr<const FlowingSet> set;
  };
  [[nodiscard]] Known found(const Sought& key) const;
  void keep(const Sought& key, const Known& known) const;

  Eigen::Index kept_;
  mutable Eigen::Index numbers_ = 0;
  mutable std::unordered_map<Key, Known, Hash, Same> sets_;
  mutable std::mutex mutex_;
};

/// How a frame with K and hinges G, K_hh moves if these flow without hardening, x of its dofs: the shape of the least
/// eigenvalue of K − G_Aᵀ K_AA⁺ G_A against K, where that is below 10⁻⁹; nothing where it bends. (H-12)
[[nodiscard]] std::optional<Eigen::VectorXd> free_shape(const Eigen::MatrixXd& frame_stiffness,
                                                        const Eigen::MatrixXd& frame_rows,
                                                        const Eigen::MatrixXd& hinge_stiffness,
                                                        const std::vector<Eigen::Index>& flowing);

}  // namespace bentur
