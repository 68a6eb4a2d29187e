#pragma once

#include "bentur/contact/laws.h"

namespace bentur {

/// One line: what the law is of.
///
///   F = k δ + h δ³ for δ > 0,   F = 0 for δ ≤ 0.                                              (equation of the source)
///
/// Every symbol with dimension and range: k [force/length] stiffness, > 0. h [force/length³] hardening, ≥ 0.
/// What a free impact does: e, duration, peak, where there is a closed form.
/// Branches: 0 apart | 1 pushing, nonlinear.
/// What force() does beyond its guards: the same polynomial.
/// Source: [Key of docs/references.bib]; what deviates from it.
class HardeningSpring final : public ContactLaw {
 public:
  /// @throws InvalidParameter unless stiffness > 0 and hardening ≥ 0, both finite.
  HardeningSpring(double stiffness, double hardening);

  [[nodiscard]] static LawEntry entry();
  [[nodiscard]] std::string_view name() const noexcept override { return "hardening-spring"; }
  [[nodiscard]] LawParameters parameters() const override;
  [[nodiscard]] Branch branch(const LawState& state) const noexcept override;
  // Only where a branch is nonlinear:
  [[nodiscard]] double force(const LawState& state, double penetration, double closing_speed) const noexcept override;
  [[nodiscard]] double stored_energy(const LawState& state, double penetration) const noexcept override;

 private:
  double stiffness_{};  // k [force/length]
  double hardening_{};  // h [force/length³]
};

}  // namespace bentur
