#pragma once

#include <optional>
#include <vector>

#include "bentur/solve/solver.h"

namespace bentur {

/// Which contacts of the meetings of a system (MeetingPlace) would touch in its free response if nothing pushed there;
/// found where it is first asked for.
class FreeTouches {
 public:
  /// @param system lives as long as this, as `free` does, its free response but for widths
  FreeTouches(const System& system, const FreeSolution& free, const RunLimits& limits)
      : system_(&system), free_(&free), limits_(limits) {}

  /// Per contact, those that rub last; 1 of all where the free response does not get to its end.
  [[nodiscard]] const std::vector<char>& found();

 private:
  const System* system_;
  const FreeSolution* free_;
  RunLimits limits_;
  std::optional<std::vector<char>> found_;
};

}  // namespace bentur
