#pragma once

#include <string>

#include "bentur/pounding/pounding.h"
#include "session.h"

namespace bentur::cli {

/// What a run takes, in lines: what is fastest, steps, samples, memory, and the time where that is long.
[[nodiscard]] std::string effort_text(const Case& c, const Problem& problem, const Effort& effort, const Words& say);
[[nodiscard]] std::string effort_text(const Case& c, const PlanProblem& problem, const Effort& effort,
                                      const Words& say);

/// A warning before work that may take more than some seconds; else empty.
[[nodiscard]] std::string long_run_text(const Case& c, const Problem& problem, const Effort& effort, const Words& say);
[[nodiscard]] std::string long_run_text(const Case& c, const PlanProblem& problem, const Effort& effort,
                                        const Words& say);

}  // namespace bentur::cli
