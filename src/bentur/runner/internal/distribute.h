#pragma once

#include <cstddef>
#include <functional>

#include "bentur/runner/ranks.h"
#include "bentur/study/journal.h"
#include "bentur/study/study_runs.h"

namespace bentur {

struct WorkOptions {
  int threads = 1;
  std::function<bool()> stop;                 ///< asked by many threads
  std::function<void(std::size_t)> finished;  ///< how many runs have reached the journal, now and then
};

/// Rank 0: has every run that the journal lacks solved, by the threads of this process and by the other ranks, which
/// ask for work whenever theirs runs low, and writes results as they come. @return false when stopped.
[[nodiscard]] bool coordinate(const StudyRuns& runs, Journal& journal, Ranks& ranks, const WorkOptions& options);

/// Rank 0: lets the others go, for whom there is nothing to do.
void dismiss_workers(Ranks& ranks);

/// Any other rank: asks for work, solves it and sends the results, until there is no more.
void work(const StudyRuns& runs, Ranks& ranks, const WorkOptions& options);

}  // namespace bentur
