#pragma once

#include "bentur/contact/laws.h"

namespace bentur {

/// An impact that takes no time: the stereomechanical law.
///
///   δ̇⁺ = −e δ̇⁻, momentum kept.                                                              (C-24)
///
/// e [-] coefficient of restitution, 0 < e ≤ 1. The law has no force of its own. A solver changes the velocities when a
/// contact closes; the force of a contact that stays closed is what keeps its opening at zero.
/// Branches: 0 apart | 1 resting: touching, without guards; the solver finds the force, and takes next() when it would
/// have to pull. From branch 0 next() leads to rest; a solver that lets the bodies rebound leaves the state as it is.
/// Source: [Goldsmith1960].
class Restitution final : public ContactLaw {
 public:
  /// @throws InvalidParameter unless 0 < restitution ≤ 1.
  explicit Restitution(double restitution);

  [[nodiscard]] static LawEntry entry();
  [[nodiscard]] std::string_view name() const noexcept override { return "restitution"; }
  [[nodiscard]] LawParameters parameters() const override { return {{"restitution", restitution_}}; }
  [[nodiscard]] Branch branch(const LawState& state) const noexcept override;
  [[nodiscard]] double stored_energy(const LawState& state, double penetration) const noexcept override;
  [[nodiscard]] bool is_homogeneous() const noexcept override { return true; }
  [[nodiscard]] std::optional<double> restitution() const noexcept override { return restitution_; }

 private:
  double restitution_{};  // e [-]
};

}  // namespace bentur
