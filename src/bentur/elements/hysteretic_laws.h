#pragma once

#include <vector>

#include "bentur/elements/law_entry.h"

namespace bentur {

/// Laws that a storey can yield by, chosen by word. Each is made with `stiffness`, `yield_force`, `hardening` and the
/// numbers that its entry names beside these.
[[nodiscard]] const std::vector<LawEntryOf<HystereticLaw>>& hysteretic_laws();

}  // namespace bentur
