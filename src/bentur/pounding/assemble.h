#pragma once

#include <vector>

#include "bentur/pounding/problem.h"
#include "bentur/solve/system.h"

namespace bentur {

/// A valid problem as the solver takes it. @param levels both faces of each level are watched in the free response too
[[nodiscard]] System system_of(const Problem& problem, bool levels = false);

/// Its contact points alone.
[[nodiscard]] std::vector<Contact> contacts_of(const Problem& problem);

}  // namespace bentur
