#include "bentur/model/close_up.h"

#include <algorithm>
#include <cstddef>

namespace bentur {
namespace {

/// Index of the impact with the largest force among those of the gap, if one is asked for, that take time; −1 without
/// one.
int hardest(const Problem& problem, const std::vector<Impact>& impacts, std::optional<Eigen::Index> gap) {
  int found = -1;
  for (std::size_t i = 0; i < impacts.size(); ++i) {
    const bool is_asked = !gap || problem.points[static_cast<std::size_t>(impacts[i].point)].gap == *gap;
    const bool counts = is_asked && impacts[i].end > impacts[i].start && impacts[i].peak_force > 0;
    if (counts && (found < 0 || impacts[i].peak_force > impacts[static_cast<std::size_t>(found)].peak_force)) {
      found = static_cast<int>(i);
    }
  }
  return found;
}

}  // namespace

std::optional<CloseUp> close_up(const Problem& problem, const Response& response, const Solver& solver, double budget,
                                std::optional<Eigen::Index> gap) {
  CloseUp result;
  result.impact = hardest(problem, response.impacts, gap);
  if (result.impact < 0) return std::nullopt;
  const Impact& impact = response.impacts[static_cast<std::size_t>(result.impact)];
  const double duration = impact.end - impact.start;
  const double from = std::max(0.0, impact.start - duration / 2);
  Problem shortened = problem;
  shortened.duration = std::min(response.duration, impact.end + duration / 2);
  shortened.goes_on = false;

  double numbers = 2 + 2 * static_cast<double>(problem.points.size());  // of one sample
  for (const Building& building : problem.buildings) numbers += 3 * static_cast<double>(building.model.floors());
  SolveOptions options;
  options.output_step = std::max(duration / 200, shortened.duration * numbers / budget);
  if (duration / options.output_step < 40) return std::nullopt;

  const Response dense = solve(shortened, solver, options);
  if (dense.status != Status::done && dense.status != Status::collapsed) return std::nullopt;
  const std::vector<double>& time = dense.histories.time;
  for (std::size_t i = 0; i < time.size(); ++i) {
    if (time[i] < from) continue;
    const auto column = static_cast<Eigen::Index>(i);
    result.time.push_back(time[i]);
    result.opening.push_back(dense.histories.opening(impact.point, column));
    result.force.push_back(dense.histories.force(impact.point, column));
  }
  return result;
}

}  // namespace bentur
