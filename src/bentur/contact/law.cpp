#include "bentur/contact/law.h"

namespace bentur {

LawState ContactLaw::next(const LawState& state, std::size_t guard, double time, double /*penetration*/,
                          double closing_speed) const noexcept {
  if (state.branch == apart) return {.branch = 1, .since = time, .closing_speed = closing_speed};
  if (guard == 0) return {.since = time};
  return {.branch = state.branch == 1 ? 2 : 1, .since = time, .closing_speed = state.closing_speed};
}

}  // namespace bentur
