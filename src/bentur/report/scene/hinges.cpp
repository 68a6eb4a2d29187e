#include "bentur/report/scene/internal/hinges.h"
#include "bentur/core/not_known.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace bentur {

int SceneHinge::level(double time) const {
  return static_cast<int>(std::count_if(reached.begin(), reached.end(), [&](double at) { return at <= time; }));
}

Tone hinge_tone(const HingeBounds& bounds, int level) {
  if (!bounds.are_limits) return Tone::black;
  constexpr Tone tones[] = {Tone::black, Tone::teal, Tone::amber, Tone::red};
  return tones[std::clamp(level, 1, SceneHinge::levels) - 1];
}

Mark hinge_mark(int level) {
  constexpr Mark marks[] = {Mark::circle, Mark::disc, Mark::square, Mark::diamond};
  return marks[std::clamp(level, 1, SceneHinge::levels) - 1];
}

namespace scene {
namespace {

using Eigen::Index;

constexpr double never = std::numeric_limits<double>::infinity();
constexpr double clear_of_joint = 0.15;  // of the storey height, or of a shorter bay

/// IO, LS and CP of a hinge [rad]; NaN where it has none.
Eigen::Vector3d limits_of(const Hinges& hinges, Index hinge) {
  if (hinge >= hinges.rotation_limits.rows()) return Eigen::Vector3d::Constant(not_known);
  return hinges.rotation_limits.row(hinge).transpose();
}

/// Where rotations of a building are followed, and when; the exact course where it is kept.
struct Rotations {
  const Eigen::MatrixXd* all = nullptr;
  const std::vector<double>* time = nullptr;

  Rotations(const Response& response, Index building) {
    for (const Histories* histories : {&response.course, &response.histories}) {
      if (std::ssize(histories->hinge_rotation) <= building) continue;
      const Eigen::MatrixXd& found = histories->hinge_rotation[building];
      if (found.cols() == 0 || found.cols() != std::ssize(histories->time)) continue;
      all = &found;
      time = &histories->time;
      return;
    }
  }

  /// When a hinge first passes a bound; of one that does so between samples, the sample at which it has turned
  /// furthest.
  [[nodiscard]] double passes(Index hinge, double bound) const {
    if (all == nullptr || hinge >= all->rows()) return 0;
    Index furthest = 0;
    for (Index k = 0; k < all->cols(); ++k) {
      if (std::abs((*all)(hinge, k)) > bound) return (*time)[k];
      if (std::abs((*all)(hinge, k)) > std::abs((*all)(hinge, furthest))) furthest = k;
    }
    return (*time)[furthest];
  }
};

/// Which points of a line of columns are at the level below and at the one above.
std::array<std::ptrdiff_t, 2> ends_on(const SceneLine& line, double below, double above) {
  const auto point_at = [&](double height) {
    const double from = height - 1e-6 * (above - below);
    const auto found =
        std::find_if(line.begin(), line.end(), [&](const ScenePoint& one) { return one.height >= from; });
    return std::min<std::ptrdiff_t>(found - line.begin(), std::ssize(line) - 1);
  };
  return {point_at(below), point_at(above)};
}

}  // namespace

HingeBounds hinge_bounds(const Problem& problem, const Response& response) {
  HingeBounds bounds;
  for (std::size_t b = 0; b < problem.buildings.size() && b < response.buildings.size(); ++b) {
    const Hinges& hinges = problem.buildings[b].model.hinges;
    for (Index h = 0; h < std::ssize(response.buildings[b].hinges); ++h) {
      bounds.largest = std::max(bounds.largest, response.buildings[b].hinges[h].peak_rotation);
      bounds.are_limits = bounds.are_limits || !std::isnan(limits_of(hinges, h)(0));
    }
  }
  return bounds;
}

std::vector<SceneHinge> hinges_of(const Problem& problem, const Response& response, Index building,
                                  const HingeBounds& bounds) {
  std::vector<SceneHinge> all;
  if (building >= std::ssize(response.buildings)) return all;
  const Hinges& hinges = problem.buildings[building].model.hinges;
  const BuildingPeaks& peaks = response.buildings[building];
  const Rotations rotations(response, building);
  for (Index h = 0; h < std::min(std::ssize(peaks.hinges), std::ssize(hinges.places)); ++h) {
    const BuildingPeaks::Hinge& hinge = peaks.hinges[h];
    SceneHinge& one = all.emplace_back(SceneHinge{.building = building, .hinge = h, .at = {}});
    one.reached.fill(never);
    if (!hinge.first_yield) continue;
    one.reached[0] = *hinge.first_yield;
    const Eigen::Vector3d limits = limits_of(hinges, h);
    for (int k = 0; k < 3; ++k) {
      const double bound = bounds.are_limits ? limits(k) : HingeBounds::parts[k] * bounds.largest;
      if (hinge.peak_rotation > bound) one.reached[k + 1] = std::max(one.reached[k], rotations.passes(h, bound));
    }
  }
  const std::vector<std::vector<Index>> groups = hinge_order(peaks, problem.duration);
  for (std::size_t group = 0; group < groups.size(); ++group) {
    for (const Index h : groups[group]) {
      if (h < std::ssize(all)) all[h].order = static_cast<int>(group) + 1;
    }
  }
  return all;
}

std::size_t nodes_before(const std::vector<HingePlace>& places, Index hinge) {
  const HingePlace& own = places[hinge];
  return static_cast<std::size_t>(std::count_if(places.begin(), places.begin() + hinge, [&](const HingePlace& other) {
    return other.end == HingePlace::End::node && other.level == own.level && other.number == own.number;
  }));
}

std::vector<SceneBreak> breaks_of(const Problem& problem, const Response& response, Index building) {
  std::vector<SceneBreak> all;
  if (building >= std::ssize(response.buildings)) return all;
  const std::vector<BuildingPeaks::Breaking>& columns = response.buildings[building].columns;
  const Index known = std::ssize(problem.buildings[building].model.hinges.columns);
  for (Index k = 0; k < std::min(std::ssize(columns), known); ++k) {
    if (!columns[k].break_time) continue;
    all.push_back({.building = building, .column = k, .at = {}, .time = *columns[k].break_time});
  }
  return all;
}

ScenePoint amid_column(const SceneLine& line, Index piece, double below, double above) {
  auto [foot, head] = ends_on(line, below, above);
  if (piece > 0) {
    foot = std::min(foot + piece - 1, std::max(head - 1, foot));
    head = std::min(foot + 1, head);
  }
  return between(line[foot], line[head], 0.5);
}

ScenePoint on_column(const SceneLine& line, HingePlace::End end, double below, double above, std::size_t node) {
  const double tall = above - below;
  const auto [foot, head] = ends_on(line, below, above);
  if (end == HingePlace::End::node) {
    return line[std::min(foot + 1 + static_cast<std::ptrdiff_t>(node), std::max(head - 1, foot))];
  }
  const bool is_foot = end == HingePlace::End::bottom;
  const ScenePoint& joint = line[is_foot ? foot : head];
  const ScenePoint& next = line[is_foot ? std::min(foot + 1, head) : std::max(head - 1, foot)];
  const double length = std::abs(next.height - joint.height);
  return between(joint, next, length > 0 ? std::min(0.5, clear_of_joint * tall / length) : 0);
}

ScenePoint on_beam(const SceneLine& floor, HingePlace::End end, double from, double to, double breadth, double storey) {
  const double clear = std::min(clear_of_joint * storey / breadth, 0.25 * (to - from));
  return between(floor.front(), floor.back(), end == HingePlace::End::left ? from + clear : to - clear);
}

}  // namespace scene
}  // namespace bentur
