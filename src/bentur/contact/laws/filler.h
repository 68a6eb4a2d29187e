#pragma once

#include "bentur/contact/laws.h"

namespace bentur {

/// Layer of crushable foam in the gap: elastic, crushed at a constant force, locked once its cells are closed.
///
///   F = k (δ − p)              0 ≤ δ − p ≤ δ_c,   k = F_c/δ_c,  δ_c = ε_c t
///   F = F_c                    crushing: ṗ = δ̇ > 0,  up to δ = δ_L = ε_L t                             (C-25)
///   F = F_c + k_L (δ − δ_L)    δ > δ_L
///
/// F_c [force] crushing force, > 0: strength of the foam times the area that is pressed. t [length] thickness, > 0.
/// ε_c, ε_L [-] strains at which crushing begins and ends, 0 < ε_c < ε_L < 1. k_L [force/length] stiffness of the
/// locked foam, ≥ k. p [length] what has been crushed, 0 ≤ p ≤ δ_L − δ_c: it stays, and from then on contact is at δ =
/// p. δ is measured from the face of the foam as it was put in. Unloading is elastic, so that an impact loses F_c times
/// what it adds to p (C-26). Branches: 0 apart, p = 0 | 1 elastic | 2 crushing | 3 locked | 4 apart, p > 0.
/// memory [length]: p. Source: the three regimes of a foam [GibsonAshby1997]; straight lines for them are ours.
class Filler final : public ContactLaw {
 public:
  /// @throws InvalidParameter unless crushing_force, thickness > 0, 0 < crushing_strain < locking_strain < 1 and
  ///   locked_stiffness ≥ crushing_force/(crushing_strain thickness), all finite.
  Filler(double crushing_force, double thickness, double crushing_strain, double locking_strain,
         double locked_stiffness);

  [[nodiscard]] static LawEntry entry();
  [[nodiscard]] std::string_view name() const noexcept override { return "filler"; }
  [[nodiscard]] LawParameters parameters() const override;
  [[nodiscard]] Branch branch(const LawState& state) const noexcept override;
  [[nodiscard]] LawState next(const LawState& state, std::size_t guard, double time, double penetration,
                              double closing_speed) const noexcept override;
  [[nodiscard]] double stored_energy(const LawState& state, double penetration) const noexcept override;

 private:
  enum : int { elastic = 1, crushing, locked, crushed };  // branches after `apart`

  double crushing_force_{};    // F_c [force]
  double thickness_{};         // t [length]
  double crushing_strain_{};   // ε_c [-]
  double locking_strain_{};    // ε_L [-]
  double locked_stiffness_{};  // k_L [force/length]
  double elastic_part_{};      // δ_c [length]
  double locking_{};           // δ_L [length]
  double most_crushed_{};      // δ_L − δ_c [length]
  double stiffness_{};         // k [force/length]
};

}  // namespace bentur
