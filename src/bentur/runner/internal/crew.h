#pragma once

#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <exception>
#include <functional>
#include <memory>
#include <mutex>
#include <vector>

#include "bentur/study/study_runs.h"

namespace bentur {

using RunNumbers = std::vector<std::size_t>;

/// Threads of this process that solve runs, given to them some at a time.
class Crew {
 public:
  using Solve = std::function<std::vector<RunResult>(const RunNumbers&)>;

  /// @param solve called by many threads at once.
  Crew(int threads, Solve solve);
  /// Waits for what is under way.
  ~Crew();
  Crew(const Crew&) = delete;
  Crew& operator=(const Crew&) = delete;

  void give(RunNumbers runs);
  /// How many of the portions given are not solved yet.
  [[nodiscard]] std::size_t under_way() const;
  /// What has been solved since, after `patience` at most where there is nothing yet. @throws what `solve` has thrown.
  [[nodiscard]] std::vector<RunResult> take(std::chrono::microseconds patience);

 private:
  struct Threads;

  Solve solve_;
  mutable std::mutex mutex_;
  std::condition_variable solved_;
  std::size_t under_way_ = 0;
  std::vector<RunResult> results_;
  std::exception_ptr failure_;
  std::unique_ptr<Threads> threads_;
};

}  // namespace bentur
