#pragma once

#include <optional>

#include "bentur/contact/laws.h"

namespace bentur {

/// Hertz contact with a damping force that grows with the penetration.
///
///   F = β δ^1.5 (1 + d δ̇/v₀), cut at 0.                                                      (C-5)
///
/// β [force/length^1.5] stiffness, > 0. d [-] damping factor, ≥ 0. v₀ [length/s] closing speed at the start of this
/// contact, or the least that a solver tells of (needs_closing_speed()); where it gives no scale (v₀ ≤ 0, or d/v₀
/// beyond the largest number) the contact is the plain Hertz one. e of a free impact follows from d alone (C-6).
/// Calibrations, given e: exact (C-6), muthukumar-desroches (C-19), ye (C-20). Branches: 0 apart | 1 pushing, nonlinear
/// | 2 cut: parting faster than v₀/d, still touching, F = 0. A free impact never gets to 2. Beyond its guards force()
/// goes on by the same formula, and as 0 where δ < 0. Not bounded: a contact that begins at a crawl and is then driven
/// fast has d δ̇/v₀ ≫ 1, and a force to match. Source: [LankaraniNikravesh1990], [MuthukumarDesRoches2006]; the cut is
/// ours.
class HertzDamp final : public ContactLaw {
 public:
  /// restitution: what was asked for, shown in parameters() alone.
  /// @throws InvalidParameter unless stiffness > 0 and damping_factor ≥ 0, both finite.
  HertzDamp(double stiffness, double damping_factor, std::optional<double> restitution = std::nullopt);

  [[nodiscard]] static LawEntry entry();
  [[nodiscard]] std::string_view name() const noexcept override { return "hertz-damp"; }
  [[nodiscard]] LawParameters parameters() const override;
  [[nodiscard]] bool needs_closing_speed() const noexcept override { return true; }
  [[nodiscard]] Branch branch(const LawState& state) const noexcept override;
  [[nodiscard]] double force(const LawState& state, double penetration, double closing_speed) const noexcept override;
  [[nodiscard]] double stored_energy(const LawState& state, double penetration) const noexcept override;

 private:
  enum : int { pushing = 1, cut };  // branches after `apart`

  double slowness(const LawState& state) const noexcept;  // d/v₀ [s/length], 0 where v₀ gives no scale

  double stiffness_{};                 // β [force/length^1.5]
  double damping_factor_{};            // d [-]
  std::optional<double> restitution_;  // e asked for [-]
};

}  // namespace bentur
