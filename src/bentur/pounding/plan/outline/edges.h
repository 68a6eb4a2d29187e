#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "bentur/structure/plan/footprint.h"

// Edges of outlines, as faces and parts look at them.
namespace bentur {

struct Edge {
  PlanPoint from, to, normal;  ///< normal outwards
  [[nodiscard]] double length() const { return (to - from).norm(); }
};

/// Lengths that differ by less are one: 1e-9 of the largest side [length].
[[nodiscard]] inline double least_of(const Footprint& one, const Footprint& other) {
  constexpr double nothing_in_common = 1e-9;
  return nothing_in_common * std::max(one.size.maxCoeff(), other.size.maxCoeff());
}

/// Of two of length 1.
[[nodiscard]] inline bool is_one_direction(const PlanPoint& one, const PlanPoint& other) {
  constexpr double sine = 1e-9;
  return one.dot(other) > 0 && std::abs(one.x() * other.y() - one.y() * other.x()) < sine;
}

/// The same but for so much that rotations of buildings are what decides which end of an edge touches first.
[[nodiscard]] inline bool is_nearly_one_direction(const PlanPoint& one, const PlanPoint& other) {
  constexpr double sine = 0.05;
  return one.dot(other) > 0 && std::abs(one.x() * other.y() - one.y() * other.x()) < sine;
}

/// Of a ring that has its inside on the left.
[[nodiscard]] inline std::vector<Edge> edges_of(const std::vector<PlanPoint>& corners) {
  std::vector<Edge> edges;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const PlanPoint &from = corners[i], &to = corners[(i + 1) % corners.size()];
    const PlanPoint way = to - from;
    edges.push_back({from, to, PlanPoint(way.y(), -way.x()) / way.norm()});
  }
  return edges;
}

[[nodiscard]] inline std::vector<Edge> edges_of(const Footprint& footprint) { return edges_of(footprint.corners()); }

/// The part of a convex polygon of which the normal's coordinate is at most `bound`.
[[nodiscard]] inline std::vector<PlanPoint> part_behind(const std::vector<PlanPoint>& polygon, const PlanPoint& normal,
                                                        double bound) {
  std::vector<PlanPoint> part;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const PlanPoint &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    const double outside_a = normal.dot(a) - bound, outside_b = normal.dot(b) - bound;
    if (outside_a <= 0) part.push_back(a);
    if ((outside_a < 0) != (outside_b < 0) && outside_a != 0 && outside_b != 0) {
      part.push_back(a + outside_a / (outside_a - outside_b) * (b - a));
    }
  }
  return part;
}

}  // namespace bentur
