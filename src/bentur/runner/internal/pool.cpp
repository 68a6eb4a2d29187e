#include "bentur/runner/internal/pool.h"

#include <tbb/global_control.h>
#include <tbb/task_arena.h>
#include <tbb/task_group.h>

#include <algorithm>
#include <future>
#include <iterator>
#include <thread>
#include <utility>

namespace bentur {
namespace {

constexpr double portion_seconds = 0.05;       // of work given to a thread at a time
constexpr std::size_t largest_portion = 4096;  // runs
constexpr std::size_t portions_ahead = 2;      // given to each thread, so that none waits

/// As many of the threads wanted as the system can make, one at least: oneTBB ends the program where it is refused one.
/// Where not all can be had, half of those that can: the work needs room too.
int possible_threads(int wanted) {
  std::vector<std::thread> trial;
  std::promise<void> end;
  const std::shared_future<void> ended = end.get_future().share();
  try {
    trial.reserve(static_cast<std::size_t>(wanted));
    for (int i = 0; i < wanted; ++i) trial.emplace_back([ended] { ended.wait(); });
  } catch (const std::exception&) {  // std::system_error, std::bad_alloc
  }
  end.set_value();
  for (std::thread& thread : trial) thread.join();
  const int made = static_cast<int>(trial.size());
  return made == wanted ? wanted : std::max(1, made / 2);
}

}  // namespace

struct Pool::Threads {
  explicit Threads(int count)
      : limit(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(count) + 1), arena(count, 0) {}

  tbb::global_control limit;  // the thread that gives work waits and solves nothing, so one more
  tbb::task_arena arena;
  tbb::task_group group;
};

Pool::Pool(const StudyRuns& runs, int threads, std::function<bool()> stop)
    : runs_(runs),
      count_(static_cast<std::size_t>(possible_threads(threads))),
      stop_(std::move(stop)),
      threads_(std::make_unique<Threads>(static_cast<int>(count_))) {}

Pool::~Pool() {
  threads_->arena.execute([&] { threads_->group.wait(); });
}

std::size_t Pool::under_way() const {
  const std::lock_guard lock(mutex_);
  return under_way_;
}

/// Runs of one portion, by how fast they have been solved so far.
std::size_t Pool::portion() const {
  if (solved_ == 0) return 1;
  const double elapsed = std::chrono::duration<double>(std::chrono::steady_clock::now() - began_).count();
  const double rate = static_cast<double>(solved_) / elapsed / static_cast<double>(count_);
  return std::clamp(static_cast<std::size_t>(rate * portion_seconds), std::size_t{1}, largest_portion);
}

std::size_t Pool::wanted() const {
  const std::size_t all = portions_ahead * count_;
  const std::size_t given = under_way();
  return given >= all ? 0 : (all - given) * portion();
}

void Pool::give(const RunNumbers& runs) {
  const std::size_t each = std::min(portion(), (runs.size() + count_ - 1) / count_);
  for (auto begin = runs.begin(); begin != runs.end();) {
    const auto end = begin + std::min(static_cast<std::ptrdiff_t>(each), runs.end() - begin);
    {
      const std::lock_guard lock(mutex_);
      ++under_way_;
    }
    threads_->arena.enqueue(threads_->group.defer([this, portion = RunNumbers(begin, end)] { solve(portion); }));
    begin = end;
  }
}

void Pool::solve(const RunNumbers& portion) {
  std::vector<RunResult> results;
  std::exception_ptr failure;
  try {
    results = runs_.solve(portion, [this] { return !stopping(); });
  } catch (...) {
    failure = std::current_exception();
  }
  const std::lock_guard lock(mutex_);
  std::move(results.begin(), results.end(), std::back_inserter(results_));
  if (failure) failure_ = failure;
  --under_way_;
  change_.notify_one();
}

std::vector<RunResult> Pool::take(std::chrono::microseconds patience) {
  std::unique_lock lock(mutex_);
  change_.wait_for(lock, patience, [&] { return !results_.empty() || failure_ || under_way_ == 0; });
  if (failure_) std::rethrow_exception(failure_);
  solved_ += results_.size();
  return std::exchange(results_, {});
}

}  // namespace bentur
