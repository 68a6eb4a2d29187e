#include "bentur/runner/solve_in_threads.h"

#include <tbb/info.h>

#include <algorithm>
#include <chrono>
#include <iterator>

#include "bentur/runner/internal/pool.h"

namespace bentur {

std::vector<RunResult> solve_in_threads(const StudyRuns& study, std::span<const std::size_t> runs, int threads,
                                        const std::function<bool()>& goes_on) {
  const int count = std::min(threads > 0 ? threads : tbb::info::default_concurrency(), static_cast<int>(runs.size()));
  if (count < 2) return study.solve(runs, goes_on);
  std::vector<RunResult> all;
  const auto take = [&all](std::vector<RunResult> some) {
    std::move(some.begin(), some.end(), std::back_inserter(all));
  };
  Pool pool(study, count, {});
  if (goes_on()) pool.give({runs.begin(), runs.end()});
  while (!pool.idle()) {
    take(pool.take(std::chrono::milliseconds(50)));
    if (!goes_on()) pool.stop();
  }
  take(pool.take({}));
  std::sort(all.begin(), all.end(), [](const RunResult& a, const RunResult& b) { return a.run < b.run; });
  return all;
}

}  // namespace bentur
