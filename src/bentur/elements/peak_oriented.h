#pragma once

#include "bentur/elements/law_entry.h"

namespace bentur {

/// Peak-oriented hysteresis of a storey ([CloughJohnston1966] as mended by [MahinBertero1976]). Each side has an
/// extreme point, at first (±Δ_y, ±V_y), Δ_y = V_y/k: (L-2)
///   1. from the origin on, slope k until ±V_y;
///   2. backbone V = ±V_y + r k (Δ ∓ Δ_y) while moving outward; it takes the extreme point of its side along;
///   3. a reversal off an unloading line at (Δ_u, V_u) unloads with k_u = k (Δ_y/|Δ_extreme|)^a, Δ_extreme that of the
///      side that V_u is on, and k_u at least V_extreme/Δ_extreme;
///   4. where V = 0 it heads straight for the extreme point of the other side, and from there along that backbone;
///   5. back at (Δ_u, V_u) it goes on along the line that it left there.
/// k, V_y > 0, 0 ≤ r < 1 as in (L-1); a [-] unloading exponent, 0 … 1. It would give back V²/(2 k_u).
/// Branches: 0 from the origin | 1, 2 backbone up, down | 3, 4 unloading from above, below | 5, 6 heading for the
/// upper, lower extreme. memory: Δ of the upper and of the lower extreme, then Δ and V of the point the line goes
/// through.
class PeakOriented final : public HystereticLaw {
 public:
  /// @throws InvalidParameter unless stiffness > 0, yield_force > 0, 0 ≤ hardening < 1, 0 ≤ unloading_exponent ≤ 1.
  PeakOriented(double stiffness, double yield_force, double hardening, double unloading_exponent);

  [[nodiscard]] static LawEntryOf<HystereticLaw> entry();
  [[nodiscard]] std::string_view name() const noexcept override { return "peak-oriented"; }
  [[nodiscard]] LawParameters parameters() const override;
  [[nodiscard]] Branch branch(const LawState& state) const noexcept override;
  [[nodiscard]] LawState next(const LawState& state, std::size_t guard, double time, double deformation,
                              double speed) const noexcept override;
  [[nodiscard]] double stored_energy(const LawState& state, double deformation) const noexcept override;
  [[nodiscard]] bool is_odd() const noexcept override { return true; }
  [[nodiscard]] double initial_stiffness() const noexcept override { return stiffness_; }
  [[nodiscard]] double yield_deformation() const noexcept override { return yield_; }
  [[nodiscard]] double residual(const LawState& state, double deformation) const noexcept override;

 private:
  /// What is remembered.
  struct Past;
  [[nodiscard]] Past past(const LawState& state) const noexcept;
  [[nodiscard]] double backbone(double side, double deformation) const noexcept;
  [[nodiscard]] double unloading_stiffness(double side, double extreme) const noexcept;
  /// k_u of the side the force is on.
  [[nodiscard]] double stiffness_back(const LawState& state, double deformation, double force) const noexcept;

  double stiffness_{};    // k [force/length]
  double yield_force_{};  // V_y [force]
  double hardening_{};    // r [-]
  double exponent_{};     // a [-]
  double yield_{};        // Δ_y [length]
};

}  // namespace bentur
