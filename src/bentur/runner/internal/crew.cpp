#include "bentur/runner/internal/crew.h"

#include <tbb/global_control.h>
#include <tbb/task_arena.h>
#include <tbb/task_group.h>

#include <iterator>
#include <utility>

namespace bentur {

struct Crew::Threads {
  explicit Threads(int count)
      : limit(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(count) + 1), arena(count, 0) {}

  tbb::global_control limit;  // the thread that gives work waits and solves nothing, so one more
  tbb::task_arena arena;
  tbb::task_group group;
};

Crew::Crew(int threads, Solve solve) : solve_(std::move(solve)), threads_(std::make_unique<Threads>(threads)) {}

Crew::~Crew() {
  threads_->arena.execute([&] { threads_->group.wait(); });
}

void Crew::give(RunNumbers runs) {
  {
    const std::lock_guard lock(mutex_);
    ++under_way_;
  }
  threads_->arena.enqueue(threads_->group.defer([this, portion = std::move(runs)] {
    std::vector<RunResult> results;
    std::exception_ptr failure;
    try {
      results = solve_(portion);
    } catch (...) {
      failure = std::current_exception();
    }
    const std::lock_guard lock(mutex_);
    results_.insert(results_.end(), std::make_move_iterator(results.begin()), std::make_move_iterator(results.end()));
    if (failure) failure_ = failure;
    --under_way_;
    solved_.notify_one();
  }));
}

std::size_t Crew::under_way() const {
  const std::lock_guard lock(mutex_);
  return under_way_;
}

std::vector<RunResult> Crew::take(std::chrono::microseconds patience) {
  std::unique_lock lock(mutex_);
  solved_.wait_for(lock, patience, [&] { return !results_.empty() || failure_ || under_way_ == 0; });
  if (failure_) std::rethrow_exception(failure_);
  return std::exchange(results_, {});
}

}  // namespace bentur
