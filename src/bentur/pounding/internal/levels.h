#pragma once

#include <vector>

#include "bentur/pounding/problem.h"
#include "bentur/pounding/response.h"
#include "bentur/solve/system.h"

namespace bentur {

/// What is watched in the free response where two neighbours face one another, for rules: −δ of every contact and every
/// watched interface of the system, and the sways of faces that are no floors, x and −x.
[[nodiscard]] std::vector<Interface> level_interfaces(const Problem& problem, const System& system);

/// Puts how far they went into the response, whose buildings have their peaks. @param reversed whether −δ is what the
/// reversed motion needs
void report_levels(const Problem& problem, const std::vector<Reach>& reaches, bool reversed, Response& response);

}  // namespace bentur
