#include "bentur/contact/laws/restitution.h"

#include <fmt/format.h>

#include "bentur/core/errors.h"

namespace bentur {

Restitution::Restitution(double restitution) : restitution_(restitution) {
  if (!(restitution > 0 && restitution <= 1)) {
    throw InvalidParameter("restitution", fmt::format("{}", restitution), "must be in (0, 1]");
  }
}

LawEntry Restitution::entry() {
  Key alone = asked_restitution();
  alone.one_of({}, Need::required);
  return {"restitution",
          "an impact takes no time: δ̇ becomes −e δ̇, momentum is kept",
          {alone},
          {},
          [](const LawInput& in) -> std::shared_ptr<const ContactLaw> {
            return std::make_shared<Restitution>(in.number("restitution"));
          }};
}

Branch Restitution::branch(const LawState& state) const noexcept {
  if (state.branch == apart) return Branch::apart();
  return Branch{.bodies = Bodies::touching};
}

double Restitution::stored_energy(const LawState& /*state*/, double /*penetration*/) const noexcept { return 0; }

}  // namespace bentur
