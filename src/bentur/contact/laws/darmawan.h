#pragma once

#include "bentur/contact/laws.h"

namespace bentur {

/// Linear spring whose stiffness grows with the closing speed.
///
///   F = k δ (1 + α δ̇), cut at 0.                                                             (3.19)
///
/// k [force/length] stiffness, > 0. α [s/length] ≥ 0. The force has no jump at either end of an impact.
/// e of a free impact depends on its closing speed: (C-6) with d = α v₀.
/// Branches: 0 apart | 1 pushing | 2 cut: parting faster than 1/α, still touching, F = 0. A free impact never gets
/// to 2. 1 is nonlinear unless α = 0. Beyond its guards force() goes on as the same polynomial. Source: monograph
/// (3.19); the cut is ours.
class Darmawan final : public ContactLaw {
 public:
  /// @throws InvalidParameter unless stiffness > 0 and alpha ≥ 0, both finite.
  Darmawan(double stiffness, double alpha);

  [[nodiscard]] static LawEntry entry();
  [[nodiscard]] std::string_view name() const noexcept override { return "darmawan"; }
  [[nodiscard]] LawParameters parameters() const override { return {{"stiffness", stiffness_}, {"alpha", alpha_}}; }
  [[nodiscard]] Branch branch(const LawState& state) const noexcept override;
  [[nodiscard]] double force(const LawState& state, double penetration, double closing_speed) const noexcept override;
  [[nodiscard]] double stored_energy(const LawState& state, double penetration) const noexcept override;

 private:
  enum : int { pushing = 1, cut };  // branches after `apart`

  double stiffness_{};  // k [force/length]
  double alpha_{};      // α [s/length]
};

}  // namespace bentur
