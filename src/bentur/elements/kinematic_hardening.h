#pragma once

#include "bentur/elements/law_entry.h"

namespace bentur {

/// Bilinear hysteresis with kinematic hardening, of a storey, a bearing or a link:
///
///   V = k (Δ − p)  inside  |V − r k Δ| ≤ (1 − r) V_y,
///   V = r k Δ + (1 − r) V_y while Δ̇ ≥ 0 on the upper line,  V = r k Δ − (1 − r) V_y while Δ̇ ≤ 0 on the lower one.
///   (L-1)
///
/// k [force/length] stiffness, > 0. V_y [force] yield force, > 0. r [-] hardening, 0 ≤ r < 1; r = 0 is elastic and
/// perfectly plastic. Continuity fixes p where a line is left. Branches: 0 elastic, memory 0 = p [length] | 1 on the
/// upper line | 2 on the lower one. It would give back ½ r k Δ² + (V − r k Δ)²/(2 (1 − r) k).
class KinematicHardening final : public HystereticLaw {
 public:
  /// @throws InvalidParameter unless stiffness > 0, yield_force > 0, 0 ≤ hardening < 1, all finite.
  KinematicHardening(double stiffness, double yield_force, double hardening);

  [[nodiscard]] static LawEntryOf<HystereticLaw> entry();
  [[nodiscard]] std::string_view name() const noexcept override { return "bilinear"; }
  [[nodiscard]] LawParameters parameters() const override;
  [[nodiscard]] Branch branch(const LawState& state) const noexcept override;
  [[nodiscard]] LawState next(const LawState& state, std::size_t guard, double time, double deformation,
                              double speed) const noexcept override;
  [[nodiscard]] double stored_energy(const LawState& state, double deformation) const noexcept override;
  [[nodiscard]] bool is_odd() const noexcept override { return true; }
  [[nodiscard]] double initial_stiffness() const noexcept override { return stiffness_; }
  [[nodiscard]] double yield_deformation() const noexcept override { return yield_force_ / stiffness_; }
  [[nodiscard]] double residual(const LawState& state, double deformation) const noexcept override;

 private:
  enum : int { elastic, upper, lower };  // branches

  double stiffness_{};    // k [force/length]
  double yield_force_{};  // V_y [force]
  double hardening_{};    // r [-]
  double plastic_{};      // (1 − r) k [force/length]
  double limit_{};        // (1 − r) V_y [force]
};

}  // namespace bentur
