#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "bentur/elements/coupled_law.h"
#include "bentur/elements/hinges/flowing_sets.h"

namespace bentur {

/// All plastic hinges of a building as one law. Its deformations are δ = G x, the moments that its coordinates x make
/// at the hinges while none has turned [force·length]; the moments are M = δ − K_hh θ, θ [rad] what the hinges have
/// turned, and the forces that push along the rows of G are F = −θ, beside those of the elastic K x:
///   −lower ≤ M − H θ ≤ upper;  θ̇ ≥ 0 only on the upper line, ≤ 0 only on the lower one, else θ̇ = 0.  (H-2), (H-3)
/// A branch is the set A of hinges that flow and the side s = ±1 on which each does: θ_A follows from δ (H-4), all
/// other θ stay. After an event all hinges that are on a line are looked at together (H-7): by symmetry many yield at
/// once. Rigid-plastic: no stiffness of its own, no damping. (docs/theory/hinges.md)
class HingeLaw : public CoupledLaw {
 public:
  using Parameters = HingeParameters;
  /// `kept`: of numbers that FlowingSets keeps. @throws InvalidParameter when sizes disagree or a value is outside its
  /// range.
  explicit HingeLaw(Parameters parameters, Eigen::Index kept = FlowingSets::most_kept);

  [[nodiscard]] std::string_view name() const noexcept override { return "hinges"; }
  [[nodiscard]] Eigen::Index size() const noexcept override { return of_.hardening.size(); }
  [[nodiscard]] bool same_as(const CoupledLaw& other) const override;
  [[nodiscard]] CoupledState begin(const Eigen::VectorXd& deformation) const override;
  [[nodiscard]] CoupledBranch branch(const CoupledState& state) const override;
  [[nodiscard]] CoupledState next(const CoupledState& state, const CoupledBranch& branch, std::size_t guard,
                                  double time, const CoupledMotion& motion) const override;
  [[nodiscard]] CoupledState settle(const CoupledState& state, double time, const CoupledMotion& motion) const override;
  [[nodiscard]] CoupledState at(const CoupledState& state, const Eigen::VectorXd& deformation) const override;
  [[nodiscard]] double stored_energy(const CoupledState& state, const Eigen::VectorXd& deformation) const override;
  [[nodiscard]] double lost_energy(const CoupledState& state, const Eigen::VectorXd& deformation) const override;
  [[nodiscard]] bool is_odd() const noexcept override { return of_.upper == of_.lower; }
  [[nodiscard]] const Parameters& parameters() const { return of_; }

  /// What one hinge has done up to the last event, or to at().
  struct Record {
    double rotation = 0;                ///< θ [rad]
    double peak_rotation = 0;           ///< max |θ| [rad]
    double lost = 0;                    ///< ∫ (M − H θ) dθ [force·length] ≥ 0
    std::optional<double> first_yield;  ///< [s]
    int half_cycles = 0;                ///< stretches of flow in one direction; elastic excursions do not part them
    int flows = 0;                      ///< −1, 0 or 1: the side on which it flows now
    std::optional<double> broke;        ///< [s]
    double released = 0;                ///< energy lost when it did [force·length], that of what is at rest included
  };
  [[nodiscard]] Record record(const CoupledState& state, Eigen::Index hinge) const;

  /// Least part of a frame's stiffness with which it still bends (H-12).
  static constexpr double bends = FlowingSet::bends;
  /// When the hinges first made the frame movable without bending, and which of them flowed then.
  struct Mechanism {
    double time = 0;  ///< [s]
    std::vector<Eigen::Index> hinges;
  };
  [[nodiscard]] std::optional<Mechanism> mechanism(const CoupledState& state) const;
  /// Whether it has broken and nothing is left: it moves either way without resistance.
  [[nodiscard]] bool is_free(const CoupledState& state, Eigen::Index hinge) const;

 private:
  struct Flow;
  void note_mechanism(CoupledState& state, const FlowingSet& set, double time) const;
  [[nodiscard]] Flow flow(const CoupledState& state) const;
  [[nodiscard]] Eigen::VectorXd rotations(const CoupledState& state, const Eigen::VectorXd& deformation) const;
  [[nodiscard]] bool breaks(Eigen::Index hinge) const { return of_.kept.size() > 0 && of_.kept(hinge) < 1.0; }
  [[nodiscard]] bool whole(const CoupledState& state, Eigen::Index hinge) const;
  [[nodiscard]] double line(const CoupledState& state, Eigen::Index hinge, double side) const;
  [[nodiscard]] Eigen::VectorXd borne(const CoupledState& state, const Eigen::VectorXd& deformation) const;
  void load(CoupledState& state, const Eigen::VectorXd& deformation, double time,
            std::vector<Eigen::Index> broken) const;
  void break_at_lines(CoupledState& state, double time, const Eigen::VectorXd& deformation,
                      const CoupledGuard* ended) const;
  [[nodiscard]] double width(Eigen::Index hinge) const;
  [[nodiscard]] CoupledState settle(const CoupledState& state, double time, const CoupledMotion& motion,
                                    const CoupledGuard* ended) const;

  Parameters of_;
  Eigen::MatrixXd hardened_;  ///< K_hh + H
  FlowingSets sets_;
};

}  // namespace bentur
