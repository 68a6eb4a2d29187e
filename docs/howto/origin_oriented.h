#pragma once

#include "bentur/elements/law.h"

namespace bentur {

/// Origin-oriented hysteresis of a storey: unloading and reloading aim at the origin and at the extreme points.
///
///   V = ±V_y + r k (Δ ∓ Δ_y) while moving outward beyond the extreme point of a side, which it takes along,
///   V = (V_e/Δ_e) Δ between the origin and that point, (Δ_e, V_e), at first (±Δ_y, ±V_y), Δ_y = V_y/k.
///
/// k [force/length] stiffness, > 0. V_y [force] yield force, > 0. r [-] hardening, 0 ≤ r < 1.
/// Branches: 0 never yielded | 1, 2 on the backbone above, below | 3, 4 between the origin and the upper, lower
/// extreme. memory: Δ_e above and below [length]. It would give back ½ V Δ, and come to rest at the origin.
class OriginOriented final : public HystereticLaw {
 public:
  /// @throws InvalidParameter unless stiffness > 0, yield_force > 0, 0 ≤ hardening < 1, all finite.
  OriginOriented(double stiffness, double yield_force, double hardening);

  [[nodiscard]] std::string_view name() const noexcept override { return "origin-oriented"; }
  [[nodiscard]] LawParameters parameters() const override;
  [[nodiscard]] Branch branch(const LawState& state) const noexcept override;
  [[nodiscard]] LawState next(const LawState& state, std::size_t guard, double time, double deformation,
                              double speed) const noexcept override;
  [[nodiscard]] double stored_energy(const LawState& state, double deformation) const noexcept override;
  [[nodiscard]] double initial_stiffness() const noexcept override { return stiffness_; }
  [[nodiscard]] double yield_deformation() const noexcept override { return yield_force_ / stiffness_; }
  [[nodiscard]] double residual(const LawState& state, double deformation) const noexcept override;

 private:
  enum : int { virgin, backbone_above, backbone_below, line_above, line_below };  // branches

  double stiffness_{};    // k [force/length]
  double yield_force_{};  // V_y [force]
  double hardening_{};    // r [-]
};

}  // namespace bentur
