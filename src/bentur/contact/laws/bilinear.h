#pragma once

#include "bentur/contact/laws.h"

namespace bentur {

/// Spring that yields: k₁ up to a penetration δ_y, k₂ beyond; it unloads along k₁ down to the line k₂ δ.
///
///   F = k₂ δ + f,   ḟ = (k₁ − k₂) δ̇ inside, 0 at, the limits of   0 ≤ f ≤ (k₁ − k₂) δ_y.        (C-22)
///
/// k₁ [force/length] stiffness, > 0. k₂ [force/length] second stiffness, 0 < k₂ ≤ k₁. δ_y [length] yield penetration, >
/// 0. A free impact that gets to δ_max > δ_y loses (k₁ − k₂) δ_y (δ_max − δ_y) (C-23). f is forgotten when contact
/// ends. Branches: 0 apart | 1 elastic: f = memory + (k₁ − k₂) δ | 2 yielding: f at its upper limit | 3 on the line k₂
/// δ: f = 0. memory [force] ≤ 0. With k₂ = k₁ it is the linear spring, and 2 and 3 are never reached. Source:
/// [Muthukumar2003] for loading and unloading; the closed parallelogram, which also says what becomes of a
/// reversal part-way, is our reading.
class Bilinear final : public ContactLaw {
 public:
  /// @throws InvalidParameter unless 0 < second_stiffness ≤ stiffness and yield_penetration > 0, all finite.
  Bilinear(double stiffness, double second_stiffness, double yield_penetration);

  [[nodiscard]] static LawEntry entry();
  [[nodiscard]] std::string_view name() const noexcept override { return "bilinear"; }
  [[nodiscard]] LawParameters parameters() const override;
  [[nodiscard]] Branch branch(const LawState& state) const noexcept override;
  [[nodiscard]] LawState next(const LawState& state, std::size_t guard, double time, double penetration,
                              double closing_speed) const noexcept override;
  [[nodiscard]] double stored_energy(const LawState& state, double penetration) const noexcept override;

 private:
  enum : int { elastic = 1, yielding, on_the_line };  // branches after `apart`

  double stiffness_{};          // k₁ [force/length]
  double second_stiffness_{};   // k₂ [force/length]
  double yield_penetration_{};  // δ_y [length]
  double plastic_stiffness_{};  // k₁ − k₂ [force/length]
  double limit_{};              // (k₁ − k₂) δ_y [force]
};

}  // namespace bentur
