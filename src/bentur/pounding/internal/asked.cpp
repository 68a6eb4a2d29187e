#include "bentur/pounding/internal/asked.h"

#include <algorithm>

namespace bentur {

RunOptions run_options(const SolveOptions& options) {
  return {.output_step = options.output_step,
          .course = options.course,
          .limits = options.limits,
          .energy_audit = options.energy_audit,
          .energy_step = options.energy_step,
          .progress = options.progress};
}

bool some_point_closes(const std::vector<PointSummary>& points, const std::vector<double>& widths) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (points[i].impacts > 0 || points[i].gap_needed_reversed.value_or(0) > widths[i]) return true;
  }
  return false;
}

bool some_need_exceeds(const std::vector<PointSummary>& points, const std::vector<double>& widths) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (std::max(points[i].gap_needed, points[i].gap_needed_reversed.value_or(0)) > widths[i]) return true;
  }
  return false;
}

}  // namespace bentur
