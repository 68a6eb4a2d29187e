#pragma once

#include "bentur/elements/law.h"

namespace bentur {

/// No force; where |δ| exceeds a limit nothing can go on: the drift at which a storey counts as collapsed.
/// Branches: 0 within it | 1 beyond.
class DeformationLimit final : public Law {
 public:
  /// @throws InvalidParameter unless limit [length] is finite and > 0.
  explicit DeformationLimit(double limit);

  [[nodiscard]] std::string_view name() const noexcept override { return "limit"; }
  [[nodiscard]] LawParameters parameters() const override { return {{"limit", limit_}}; }
  [[nodiscard]] Branch branch(const LawState& state) const noexcept override;
  [[nodiscard]] LawState next(const LawState& state, std::size_t guard, double time, double deformation,
                              double speed) const noexcept override;
  [[nodiscard]] double stored_energy(const LawState& /*state*/, double /*deformation*/) const noexcept override {
    return 0;
  }
  [[nodiscard]] bool is_limit() const noexcept override { return true; }

 private:
  double limit_{};  // [length]
};

}  // namespace bentur
