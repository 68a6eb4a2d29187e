#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <functional>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

#include "bentur/study/design/study_check.h"

namespace bentur {

/// By so many threads at most, that which calls among them; it comes back when all have come to an end, and throws what
/// one of them has thrown. Needs no library, so that Python has it too.
[[nodiscard]] inline ForEachNumber for_each_in_threads(int threads) {
  return [threads](std::size_t count, const std::function<void(std::size_t)>& work) {
    std::atomic<std::size_t> next = 0;
    std::exception_ptr failure;
    std::mutex mutex;
    const auto take = [&] {
      try {
        for (std::size_t i = next++; i < count; i = next++) work(i);
      } catch (...) {
        const std::lock_guard lock(mutex);
        if (!failure) failure = std::current_exception();
        next = count;
      }
    };
    std::vector<std::thread> others;
    try {
      for (std::size_t i = 1; i < std::min(static_cast<std::size_t>(threads), count); ++i) others.emplace_back(take);
    } catch (const std::system_error&) {  // the system gives no more of them: those there are go on
    }
    take();
    for (std::thread& one : others) one.join();
    if (failure) std::rethrow_exception(failure);
  };
}

}  // namespace bentur
