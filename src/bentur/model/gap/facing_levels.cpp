#include "bentur/model/gap/facing_levels.h"

#include <algorithm>
#include <limits>

#include "bentur/structure/sway.h"

namespace bentur {

double FacingLevel::to_have(double here) const {
  constexpr double least = 1e-6;
  if (opens == 1) return of_gap(here);
  if (opens > least) return std::max(0.0, of_gap(width) + (here - width) / opens);
  return here > width ? std::numeric_limits<double>::infinity() : 0;
}

std::optional<Eigen::Index> face_floor(const Problem& problem, const FacingLevel& level, int side) {
  return level.is_point ? face_floor(problem, problem.points[level.index], side)
                        : face_floor(problem.watched[level.index], side);
}

std::vector<FacingLevel> facing_levels(const Problem& problem, Eigen::Index gap) {
  const Gap between = gap_at(problem, gap);
  std::vector<FacingLevel> levels;
  for (const Eigen::Index i : between.points) {
    levels.push_back({gap, true, i, problem.points[i].elevation, problem.points[i].width, problem.points[i].beyond,
                      problem.points[i].opens, problem.points[i].beside});
  }
  for (const Eigen::Index i : between.watched) {
    levels.push_back({gap, false, i, problem.watched[i].elevation, problem.watched[i].width, problem.watched[i].beyond,
                      problem.watched[i].opens, problem.watched[i].beside});
  }
  std::stable_sort(levels.begin(), levels.end(),
                   [](const FacingLevel& a, const FacingLevel& b) { return a.elevation < b.elevation; });
  return levels;
}

std::vector<FacingLevel> facing_levels(const Problem& problem) {
  std::vector<FacingLevel> all;
  for (Eigen::Index gap = 0; gap < gap_count(problem); ++gap) {
    for (const FacingLevel& level : facing_levels(problem, gap)) all.push_back(level);
  }
  return all;
}

double face_height(const Problem& problem, const FacingLevel& level, int side) {
  const GapPair sides = sides_of(problem, level.gap);
  const StructuralModel& model = problem.buildings[side == 0 ? sides.left : sides.right].model;
  const auto floor = face_floor(problem, level, side);
  return (floor ? model.elevations[*floor] : level.elevation) - base_of(model);
}

}  // namespace bentur
