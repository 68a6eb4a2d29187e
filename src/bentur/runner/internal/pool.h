#pragma once

#include <atomic>
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

/// Threads of this process that solve runs, in portions that take about 50 ms each. One thread uses the object.
class Pool {
 public:
  /// @param stop asked by many threads whether to leave out the rest; may be empty.
  Pool(const StudyRuns& runs, int threads, std::function<bool()> stop);
  /// Waits for what is under way.
  ~Pool();
  Pool(const Pool&) = delete;
  Pool& operator=(const Pool&) = delete;

  [[nodiscard]] bool stopping() const { return told_ || (stop_ && stop_()); }
  void stop() { told_ = true; }

  /// How many runs it would take now.
  [[nodiscard]] std::size_t wanted() const;
  void give(const RunNumbers& runs);
  [[nodiscard]] bool idle() const { return under_way() == 0; }
  /// What has been solved since, after `patience` at most where there is nothing yet. @throws what solving has thrown.
  [[nodiscard]] std::vector<RunResult> take(std::chrono::microseconds patience);

 private:
  struct Threads;

  [[nodiscard]] std::size_t under_way() const;
  [[nodiscard]] std::size_t portion() const;
  void solve(const RunNumbers& portion);

  const StudyRuns& runs_;
  std::size_t count_;  // of the threads
  std::function<bool()> stop_;
  std::atomic<bool> told_ = false;
  std::size_t solved_ = 0;  // runs taken
  std::chrono::steady_clock::time_point began_ = std::chrono::steady_clock::now();
  mutable std::mutex mutex_;
  std::condition_variable change_;
  std::size_t under_way_ = 0;  // portions
  std::vector<RunResult> results_;
  std::exception_ptr failure_;
  std::unique_ptr<Threads> threads_;
};

}  // namespace bentur
