#pragma once

#include <functional>
#include <future>
#include <system_error>
#include <utility>

namespace bentur {

/// Starts work in a thread of its own; a future that is not valid where the system gives no more of them. For doors to
/// hand on (SolveOptions::beside): no library starts a thread by itself, so that a browser has them all.
[[nodiscard]] inline std::future<void> in_a_thread(std::function<void()> work) {
  try {
    return std::async(std::launch::async, std::move(work));
  } catch (const std::system_error&) {
    return {};
  }
}

}  // namespace bentur
