#include "bentur/pounding/internal/levels.h"

#include <algorithm>

namespace bentur {
namespace {

Interface times(Interface interface, double factor) {
  for (BodyRow* side : {&interface.left, &interface.right}) {
    side->row *= factor;
    side->ground *= factor;
  }
  return interface;
}

}  // namespace

std::vector<Interface> level_interfaces(const std::vector<Interface>& levels,
                                        const std::function<bool(std::size_t level, int side)>& is_floor) {
  std::vector<Interface> interfaces;
  for (const Interface& both : levels) interfaces.push_back(times(both, -1.0));
  for (std::size_t level = 0; level < levels.size(); ++level) {
    for (const int side : {0, 1}) {
      if (is_floor(level, side)) continue;
      const BodyRow& face = side == 0 ? levels[level].left : levels[level].right;
      for (const double sign : {1.0, -1.0}) interfaces.push_back({{face.body, sign * face.row}});
    }
  }
  return interfaces;
}

void report_levels(const std::vector<Reach>& reaches, bool reversed,
                   const std::function<std::optional<double>(std::size_t level, int side)>& peak_of,
                   std::vector<PointSummary>& points, std::vector<WatchedSummary>& watched) {
  std::size_t level = 0;
  auto sway = reaches.begin() + std::ssize(points) + std::ssize(watched);
  const auto report = [&](auto& summaries) {
    for (auto& summary : summaries) {
      if (reversed) summary.gap_needed_reversed = reaches[level].reach;
      for (const int side : {0, 1}) {
        double& peak = side == 0 ? summary.peak_left : summary.peak_right;
        if (const std::optional<double> of_floor = peak_of(level, side)) {
          peak = *of_floor;
        } else {
          peak = std::max(sway[0].reach, sway[1].reach);
          sway += 2;
        }
      }
      ++level;
    }
  };
  report(points);
  report(watched);
}

}  // namespace bentur
