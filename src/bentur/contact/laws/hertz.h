#pragma once

#include "bentur/contact/laws.h"

namespace bentur {

/// Elastic contact of curved surfaces.
///
///   F = β δ^1.5 for δ > 0,   F = 0 for δ ≤ 0.                                                 (C-3)
///
/// β [force/length^1.5] stiffness, > 0. Stores and returns: e = 1, no energy is lost.
/// A free impact reaches δ_max = (5 m_e v₀²/(4 β))^(2/5) and lasts 2.94328 δ_max/v₀ (C-4).
/// Branches: 0 apart | 1 pushing, nonlinear.
/// Source: [Hertz1882]; as a law of pounding [MuthukumarDesRoches2006].
class Hertz final : public ContactLaw {
 public:
  /// @throws InvalidParameter unless stiffness is finite and > 0.
  explicit Hertz(double stiffness);

  [[nodiscard]] static LawEntry entry();
  [[nodiscard]] std::string_view name() const noexcept override { return "hertz"; }
  [[nodiscard]] LawParameters parameters() const override { return {{"stiffness", stiffness_}}; }
  [[nodiscard]] Branch branch(const LawState& state) const noexcept override;
  [[nodiscard]] double force(const LawState& state, double penetration, double closing_speed) const noexcept override;
  [[nodiscard]] double stored_energy(const LawState& state, double penetration) const noexcept override;

 private:
  double stiffness_{};  // β [force/length^1.5]
};

/// β δ^1.5, and its energy 2/5 β δ^2.5; both go on as 0 where δ < 0, as a step a little outside a contact may ask.
[[nodiscard]] double hertz_force(double stiffness, double penetration) noexcept;
[[nodiscard]] double hertz_energy(double stiffness, double penetration) noexcept;

}  // namespace bentur
