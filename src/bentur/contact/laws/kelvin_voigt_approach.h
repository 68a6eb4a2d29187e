#pragma once

#include <optional>

#include "bentur/contact/laws.h"

namespace bentur {

/// Linear spring, with a dashpot while the bodies close.
///
///   F = k δ + c δ̇ while δ̇ > 0,   F = k δ after,   c = 2 ξ √(k m_e).                          (C-7)
///
/// k [force/length] stiffness, > 0. ξ [-] damping ratio, ≥ 0. m_e [mass] of the two floors, > 0.
/// e of a free impact follows from ξ alone: (C-9) with n = 1. Calibrations, given e: exact (C-9), published (C-17).
/// The force jumps to c v₀ when the bodies meet; it never pulls.
/// Branches: 0 apart | 1 closing | 2 rebound. 1 and 2 follow one another within one impact as the bodies are driven.
/// Source: [MahmoudJankowski2011].
class KelvinVoigtApproach final : public ContactLaw {
 public:
  /// restitution: what was asked for, shown in parameters() alone.
  /// @throws InvalidParameter unless stiffness > 0, damping_ratio ≥ 0, effective_mass > 0, all finite.
  KelvinVoigtApproach(double stiffness, double damping_ratio, double effective_mass,
                      std::optional<double> restitution = std::nullopt);

  [[nodiscard]] static LawEntry entry();
  [[nodiscard]] std::string_view name() const noexcept override { return "kelvin-voigt-approach"; }
  [[nodiscard]] LawParameters parameters() const override;
  [[nodiscard]] Branch branch(const LawState& state) const noexcept override;
  [[nodiscard]] double stored_energy(const LawState& state, double penetration) const noexcept override;
  [[nodiscard]] bool is_homogeneous() const noexcept override { return true; }

 private:
  enum : int { closing = 1, rebound };  // branches after `apart`

  double stiffness_{};                 // k [force/length]
  double damping_ratio_{};             // ξ [-]
  double damping_{};                   // c [force·s/length]
  std::optional<double> restitution_;  // e asked for [-]
};

}  // namespace bentur
