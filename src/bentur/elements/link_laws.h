#pragma once

#include "bentur/elements/law.h"
#include "bentur/elements/law_entry.h"

namespace bentur {

/// Spring and dashpot side by side: F = k δ + c δ̇. k [force/length], c [force·s/length] ≥ 0, not both zero. One branch,
/// which nothing ends.
class SpringDashpot final : public Law {
 public:
  /// @throws InvalidParameter unless both are finite and ≥ 0 and one is > 0.
  SpringDashpot(double stiffness, double damping);

  [[nodiscard]] static LawEntryOf<Law> entry();
  [[nodiscard]] std::string_view name() const noexcept override { return "spring-dashpot"; }
  [[nodiscard]] LawParameters parameters() const override { return {{"stiffness", stiffness_}, {"damping", damping_}}; }
  [[nodiscard]] Branch branch(const LawState& state) const noexcept override;
  [[nodiscard]] LawState next(const LawState& state, std::size_t guard, double time, double deformation,
                              double speed) const noexcept override;
  [[nodiscard]] double stored_energy(const LawState& state, double deformation) const noexcept override;
  [[nodiscard]] bool is_odd() const noexcept override { return true; }
  [[nodiscard]] bool is_homogeneous() const noexcept override { return true; }

 private:
  double stiffness_{};  // k [force/length]
  double damping_{};    // c [force·s/length]
};

/// Cable: it pulls once the buildings are further apart than at rest by its slack, F = k (δ + slack) ≤ 0.
/// k [force/length] > 0, slack [length] ≥ 0. Branches: 0 slack | 1 taut.
class Cable final : public Law {
 public:
  /// @throws InvalidParameter unless stiffness > 0 and slack ≥ 0, both finite.
  Cable(double stiffness, double slack);

  [[nodiscard]] static LawEntryOf<Law> entry();
  [[nodiscard]] std::string_view name() const noexcept override { return "cable"; }
  [[nodiscard]] LawParameters parameters() const override { return {{"stiffness", stiffness_}, {"slack", slack_}}; }
  [[nodiscard]] Branch branch(const LawState& state) const noexcept override;
  [[nodiscard]] LawState next(const LawState& state, std::size_t guard, double time, double deformation,
                              double speed) const noexcept override;
  [[nodiscard]] double stored_energy(const LawState& state, double deformation) const noexcept override;
  [[nodiscard]] bool is_homogeneous() const noexcept override { return slack_ == 0.0; }

 private:
  double stiffness_{};  // k [force/length]
  double slack_{};      // [length]
};

/// A link that yields: KinematicHardening by the keys of a link.
[[nodiscard]] LawEntryOf<Law> yielding_link_entry();

}  // namespace bentur
