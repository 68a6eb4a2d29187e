#pragma once

#include <optional>

#include "bentur/contact/laws.h"

namespace bentur {

/// Linear spring and dashpot in parallel.
///
///   F = k δ + c δ̇,   c = 2 ξ √(k m_e).                                                       (C-11)
///
/// k [force/length] stiffness, > 0. ξ [-] damping ratio, ≥ 0. m_e [mass] of the two floors, > 0. c [force·s/length].
/// The force jumps to c v₀ when the bodies meet. Since the dashpot would pull in the end, a contact ends in one of
/// three ways:
///   zero_force  F = max(0, k δ + c δ̇), without memory.
///     0 apart | 1 pushing | 2 released: δ > 0, F = 0, not touching; a new push begins where k δ + c δ̇ > 0.
///   separation  at δ = 0; F < 0 before. Needs ξ < 1: with more damping free bodies never come apart (C-15).
///     0 apart | 1 touching
///   creep       at F = 0; the dented surface then recovers, δ_s = δ_s0 exp(−k t/c) (3.16), and contact begins again
///               where the bodies meet it.
///     0 apart | 1 touching | 2 receding | 3 nearing the surface. 2 and 3 are both apart from it: while k δ + c δ̇ ≤ 0
///     (2) the bodies cannot catch up with it (C-14), so it is watched in 3 alone. memory = δ_s at the start of 2 or 3
///     [length]; once the dent is less than the round-off of its start, 0 follows 2.
///   Without damping all three are the linear spring, and 2 and 3 are never reached.
/// e of a free impact follows from ξ alone: (C-13) for zero_force and creep, (C-15) for separation. Calibrations, given
/// e: exact, and published (C-16). Source: [Anagnostopoulos1988]; monograph (3.8)-(3.18); max(0, ·) is ours.
class KelvinVoigt final : public ContactLaw {
 public:
  enum class Release { zero_force, separation, creep };

  /// restitution: what was asked for, shown in parameters() alone.
  /// @throws InvalidParameter unless stiffness > 0, damping_ratio ≥ 0, effective_mass > 0, all finite; for separation
  ///   unless damping_ratio < 1.
  KelvinVoigt(double stiffness, double damping_ratio, double effective_mass, Release release,
              std::optional<double> restitution = std::nullopt);

  [[nodiscard]] static LawEntry entry();
  [[nodiscard]] std::string_view name() const noexcept override { return "kelvin-voigt"; }
  [[nodiscard]] LawParameters parameters() const override;
  [[nodiscard]] Branch branch(const LawState& state) const noexcept override;
  [[nodiscard]] LawState next(const LawState& state, std::size_t guard, double time, double penetration,
                              double closing_speed) const noexcept override;
  [[nodiscard]] double stored_energy(const LawState& state, double penetration) const noexcept override;
  [[nodiscard]] bool is_homogeneous() const noexcept override { return true; }

 private:
  enum : int { in_contact = 1, released, nearing };  // branches after `apart`

  [[nodiscard]] Branch touching() const noexcept;
  [[nodiscard]] LawState off_the_surface(const LawState& state, std::size_t guard, double time,
                                         double closing_speed) const noexcept;

  double stiffness_{};      // k [force/length]
  double damping_ratio_{};  // ξ [-]
  double damping_{};        // c [force·s/length]
  Release release_{};
  std::optional<double> restitution_;  // e asked for [-]
};

}  // namespace bentur
