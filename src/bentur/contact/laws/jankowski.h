#pragma once

#include <optional>

#include "bentur/contact/laws.h"

namespace bentur {

/// Nonlinear viscoelastic contact: Hertz, with a dashpot while the bodies close.
///
///   F = β δ^1.5 + c̄ δ̇ while δ̇ > 0,   F = β δ^1.5 after,   c̄ = 2 ξ √(β √δ m_e).               (C-8)
///
/// β [force/length^1.5] stiffness, > 0. ξ [-] damping ratio, ≥ 0. m_e [mass] of the two floors, > 0.
/// e of a free impact follows from ξ alone: (C-9) with n = 3/2. Calibrations, given e: exact (C-9), published (C-18).
/// The force has no jump, but it leaves zero as δ^¼, with a vertical tangent.
/// Branches: 0 apart | 1 closing, nonlinear | 2 rebound, nonlinear. 1 and 2 follow one another within one impact as the
/// bodies are driven. Beyond its guards force() goes on by the same formula, and as 0 where δ < 0.
/// Source: [Jankowski2005], [Jankowski2006].
class Jankowski final : public ContactLaw {
 public:
  /// restitution: what was asked for, shown in parameters() alone.
  /// @throws InvalidParameter unless stiffness > 0, damping_ratio ≥ 0, effective_mass > 0, all finite.
  Jankowski(double stiffness, double damping_ratio, double effective_mass,
            std::optional<double> restitution = std::nullopt);

  [[nodiscard]] static LawEntry entry();
  [[nodiscard]] std::string_view name() const noexcept override { return "jankowski"; }
  [[nodiscard]] LawParameters parameters() const override;
  [[nodiscard]] Branch branch(const LawState& state) const noexcept override;
  [[nodiscard]] double force(const LawState& state, double penetration, double closing_speed) const noexcept override;
  [[nodiscard]] double stored_energy(const LawState& state, double penetration) const noexcept override;

 private:
  enum : int { closing = 1, rebound };  // branches after `apart`

  double stiffness_{};                 // β [force/length^1.5]
  double damping_ratio_{};             // ξ [-]
  double damping_{};                   // 2 ξ √(β m_e) [force·s/length^1.25]
  std::optional<double> restitution_;  // e asked for [-]
};

}  // namespace bentur
