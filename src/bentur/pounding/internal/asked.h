#pragma once

#include <optional>
#include <vector>

#include "bentur/pounding/pounding.h"

// What SolveOptions ask of runs of rows and of plans alike.
namespace bentur {

[[nodiscard]] RunOptions run_options(const SolveOptions& options);

/// What the reversed motion needs and can still come to need, of points and watched floors alike; nothing where `from`
/// is empty.
template <typename Summary>
void take_reversed(const std::vector<Summary>& from, std::vector<Summary>& to) {
  for (std::size_t i = 0; i < to.size(); ++i) {
    to[i].gap_needed_reversed = from.empty() ? std::nullopt : std::optional(from[i].gap_needed);
    to[i].to_come_reversed = from.empty() ? std::nullopt : from[i].to_come;
  }
}

/// Whether bodies touch at some point, or would in the reversed motion. @param widths of the points [length]
[[nodiscard]] bool some_point_closes(const std::vector<PointSummary>& points, const std::vector<double>& widths);

/// Whether some point needs more than its width, as the motion is given or reversed. @param widths as above
[[nodiscard]] bool some_need_exceeds(const std::vector<PointSummary>& points, const std::vector<double>& widths);

}  // namespace bentur
