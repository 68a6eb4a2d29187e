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
  return {"restitution",
          {{"restitution", LawKey::Range::restitution}},
          {},
          [](const LawInput& in) -> std::shared_ptr<const ContactLaw> {
            return std::make_shared<Restitution>(in.number("restitution"));
          }};
}

Branch Restitution::branch(const ContactState& state) const noexcept {
  if (state.branch == 0) return Branch::apart();
  return Branch{.touching = true};
}

ContactState Restitution::next(const ContactState& state, std::size_t /*guard*/, double time, double /*penetration*/,
                               double closing_speed) const noexcept {
  if (state.branch == 0) return {.branch = 1, .since = time, .closing_speed = closing_speed};
  return {.since = time};
}

double Restitution::stored_energy(const ContactState& /*state*/, double /*penetration*/) const noexcept { return 0; }

}  // namespace bentur
