#pragma once

#include <vector>

#include "bentur/solve/engine/run/watch/span_watch.h"
#include "bentur/solve/response.h"

namespace bentur::engine {

/// What is watched in the free response where two neighbours face one another, for rules: −δ of every contact point,
/// then of every watched floor, and the sways of faces that are no floors, x and −x.
[[nodiscard]] std::vector<ModalSystem::Relation> level_relations(const Problem& problem, const ModalSystem& system);

/// Puts it into the response, whose buildings have their peaks. @param reversed whether −δ is what the reversed motion
/// needs
void report_levels(const Problem& problem, const std::vector<SpanWatch::Nearest>& nearest, bool reversed,
                   Response& response);

}  // namespace bentur::engine
