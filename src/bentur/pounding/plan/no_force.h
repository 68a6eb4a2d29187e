#pragma once

#include <memory>
#include <string_view>

#include "bentur/contact/law.h"

namespace bentur {

/// Notes when bodies would touch, and lets them through.
class NoForce final : public ContactLaw {
 public:
  [[nodiscard]] std::string_view name() const noexcept override { return "none"; }
  [[nodiscard]] LawParameters parameters() const override { return {}; }
  [[nodiscard]] bool is_homogeneous() const noexcept override { return true; }
  [[nodiscard]] Branch branch(const LawState& state) const noexcept override {
    return state.branch == apart ? Branch::apart()
                                 : Branch{.bodies = Bodies::touching}.guarded_by({{.deformation = 1}});
  }
  [[nodiscard]] double stored_energy(const LawState& /*state*/, double /*penetration*/) const noexcept override {
    return 0;
  }
};

[[nodiscard]] inline std::shared_ptr<const ContactLaw> no_force() {
  static const auto law = std::make_shared<const NoForce>();
  return law;
}

}  // namespace bentur
