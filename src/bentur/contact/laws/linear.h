#pragma once

#include "bentur/contact/laws.h"

namespace bentur {

/// Linear spring across a gap.
///
///   F = k δ for δ > 0,   F = 0 for δ ≤ 0.                                                     (3-3)
///
/// k [force/length] contact stiffness, > 0. Stores and returns: e = 1, no energy is lost.
/// A free impact of masses m₁, m₂ lasts π √(m_e/k), m_e = m₁ m₂/(m₁ + m₂), and peaks at F = v₀ √(k m_e).
/// Branches: 0 apart | 1 pushing.
/// Source: monograph (3-3), with (3-4) for k (axial_stiffness.h).
class Linear final : public ContactLaw {
 public:
  /// @throws InvalidParameter unless stiffness is finite and > 0.
  explicit Linear(double stiffness);

  [[nodiscard]] static LawEntry entry();
  [[nodiscard]] std::string_view name() const noexcept override { return "linear"; }
  [[nodiscard]] LawParameters parameters() const override { return {{"stiffness", stiffness_}}; }
  [[nodiscard]] Branch branch(const LawState& state) const noexcept override;
  [[nodiscard]] double stored_energy(const LawState& state, double penetration) const noexcept override;
  [[nodiscard]] bool is_homogeneous() const noexcept override { return true; }

 private:
  double stiffness_{};  // k [force/length]
};

}  // namespace bentur
