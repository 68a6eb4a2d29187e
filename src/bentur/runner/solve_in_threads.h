#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "bentur/study/study_runs.h"

namespace bentur {

/// The runs of a study by `threads` of this process (0: one per processor that it may use), in the order of their
/// numbers: what StudyRuns::solve() gives. `goes_on` is asked a few times a second, by the thread that calls alone;
/// once it says false the rest is left out. @throws what solving has thrown
[[nodiscard]] std::vector<RunResult> solve_in_threads(const StudyRuns& study, std::span<const std::size_t> runs,
                                                      int threads, const std::function<bool()>& goes_on);

}  // namespace bentur
