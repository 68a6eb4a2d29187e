#include "bentur/structure/plan/footprint.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "bentur/structure/plan/footprint_parts.h"

namespace bentur {
namespace {

constexpr double straight = 1e-9;  // sine of the angle between two edges that are one

double cross(const PlanPoint& a, const PlanPoint& b) { return a.x() * b.y() - a.y() * b.x(); }

/// The corner behind or before another one, round and back.
const PlanPoint& corner_at(const std::vector<PlanPoint>& corners, std::size_t i) { return corners[i % corners.size()]; }

PlanPoint low_of(const std::vector<PlanPoint>& corners) {
  PlanPoint low = corners.front();
  for (const PlanPoint& at : corners) low = low.cwiseMin(at);
  return low;
}

PlanPoint extent_of(const std::vector<PlanPoint>& corners) {
  PlanPoint high = corners.front();
  for (const PlanPoint& at : corners) high = high.cwiseMax(at);
  return high - low_of(corners);
}

/// Area times the sum that `moment` makes of the three corners of each triangle, over the area: integrals over it.
template <class Value, class Moment>
Value mean_over(const Footprint& footprint, Value sum, const Moment& moment) {
  const auto add = [&](const std::vector<PlanPoint>& corners) {
    for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
      const double part = cross(corners[i] - corners[0], corners[i + 1] - corners[0]) / 2;
      sum += part * moment(corners[0], corners[i], corners[i + 1]);
    }
  };
  add(footprint.polygon);
  for (const std::vector<PlanPoint>& ring : footprint.rings) add(ring);
  return sum / footprint.area();
}

bool edges_cross(const PlanPoint& a, const PlanPoint& b, const PlanPoint& c, const PlanPoint& d) {
  const auto apart = [](const PlanPoint& from, const PlanPoint& to, const PlanPoint& one, const PlanPoint& other) {
    return cross(to - from, one - from) * cross(to - from, other - from) < 0;
  };
  return apart(a, b, c, d) && apart(c, d, a, b);
}

/// Whether two edges have a place in common.
bool edges_meet(const PlanPoint& a, const PlanPoint& b, const PlanPoint& c, const PlanPoint& d) {
  const auto is_on = [](const PlanPoint& from, const PlanPoint& to, const PlanPoint& at) {
    const PlanPoint edge = to - from, way = at - from;
    if (std::abs(cross(edge, way)) > straight * edge.squaredNorm()) return false;
    const double along = edge.dot(way);
    return along >= 0 && along <= edge.squaredNorm();
  };
  return edges_cross(a, b, c, d) || is_on(a, b, c) || is_on(a, b, d) || is_on(c, d, a) || is_on(c, d, b);
}

bool rings_meet(const std::vector<PlanPoint>& one, const std::vector<PlanPoint>& other) {
  for (std::size_t i = 0; i < one.size(); ++i) {
    for (std::size_t j = 0; j < other.size(); ++j) {
      if (edges_meet(one[i], corner_at(one, i + 1), other[j], corner_at(other, j + 1))) return true;
    }
  }
  return false;
}

/// The rule that lists of corners break of whatever shape: too few, or one after the other the same.
std::optional<std::string> fault_of_corners(const std::vector<PlanPoint>& corners) {
  const std::size_t count = corners.size();
  if (count < 3) return fmt::format("must have three corners or more, not {}", count);
  const double extent = extent_of(corners).maxCoeff();
  for (std::size_t i = 0; i < count; ++i) {
    if ((corner_at(corners, i + 1) - corners[i]).norm() > straight * extent) continue;
    return fmt::format("must have different corners: {} and {} are one", i + 1, (i + 1) % count + 1);
  }
  return std::nullopt;
}

/// Two edges that are not beside one another and of which `share` says that they have something in common.
template <class Share>
std::optional<std::string> fault_of_edges(const std::vector<PlanPoint>& corners, const Share& share, const char* what) {
  const std::size_t count = corners.size();
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t j = i + 2; j < count; ++j) {
      if (i == 0 && j + 1 == count) continue;
      if (!share(corners[i], corners[i + 1], corners[j], corner_at(corners, j + 1))) continue;
      return fmt::format("must go round once: its edges behind corners {} and {} {}", i + 1, j + 1, what);
    }
  }
  return std::nullopt;
}

std::optional<std::string> fault_of_area(const std::vector<PlanPoint>& corners) {
  const double extent = extent_of(corners).maxCoeff();
  if (!(std::abs(area_of(corners)) > straight * extent * extent)) return "must have an area";
  return std::nullopt;
}

/// The sine of the turn at a corner; counter-clockwise above zero.
double turn_at(const std::vector<PlanPoint>& corners, std::size_t i) {
  const PlanPoint before = corner_at(corners, i + 1) - corner_at(corners, i);
  const PlanPoint after = corner_at(corners, i + 2) - corner_at(corners, i + 1);
  return cross(before, after) / (before.norm() * after.norm());
}

/// Without those on a straight edge.
std::vector<PlanPoint> without_straight_ones(const std::vector<PlanPoint>& corners) {
  std::vector<PlanPoint> kept;
  const std::size_t count = corners.size();
  for (std::size_t i = 0; i < count; ++i) {
    if (std::abs(turn_at(corners, i + count - 1)) > straight) kept.push_back(corners[i]);
  }
  return kept;
}

}  // namespace

bool goes_round(const std::vector<PlanPoint>& ring, const PlanPoint& at) {
  bool within = false;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const PlanPoint &from = ring[i], &to = corner_at(ring, i + 1);
    if ((from.y() > at.y()) == (to.y() > at.y())) continue;
    const double x = from.x() + (at.y() - from.y()) / (to.y() - from.y()) * (to.x() - from.x());
    within = within != (x > at.x());
  }
  return within;
}

double area_of(const std::vector<PlanPoint>& corners) {
  double twice = 0;
  for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
    twice += cross(corners[i] - corners[0], corners[i + 1] - corners[0]);
  }
  return twice / 2;
}

PlanPoint Footprint::lower() const {
  if (polygon.empty()) return corner;
  PlanPoint low = low_of(polygon);
  for (const std::vector<PlanPoint>& ring : rings) low = low.cwiseMin(low_of(ring));
  return corner + low;
}

std::vector<PlanPoint> Footprint::corners() const {
  if (polygon.empty()) return {corner, corner + PlanPoint(size.x(), 0), corner + size, corner + PlanPoint(0, size.y())};
  std::vector<PlanPoint> all = polygon;
  for (PlanPoint& at : all) at += corner;
  return all;
}

std::vector<std::vector<PlanPoint>> Footprint::all_rings() const {
  std::vector<std::vector<PlanPoint>> all = {corners()};
  for (const std::vector<PlanPoint>& ring : rings) {
    for (std::vector<PlanPoint>& moved = all.emplace_back(ring); PlanPoint & at : moved) at += corner;
  }
  return all;
}

bool Footprint::is_convex() const {
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    if (turn_at(polygon, i) < -straight) return false;
  }
  return rings.empty();
}

double Footprint::area() const {
  if (polygon.empty()) return size.prod();
  double sum = area_of(polygon);
  for (const std::vector<PlanPoint>& ring : rings) sum += area_of(ring);
  return sum;
}

PlanPoint Footprint::middle() const {
  if (polygon.empty()) return 0.5 * size;
  return mean_over(*this, PlanPoint(0, 0), [](const PlanPoint& a, const PlanPoint& b, const PlanPoint& c) {
    return PlanPoint((a + b + c) / 3);
  });
}

double Footprint::radius2() const {
  if (polygon.empty()) return size.squaredNorm() / 12;
  const PlanPoint about = middle();
  // Of a triangle ∫r² is its area times (Σ r_i² + |Σ r_i|²)/12, r_i from where it is taken about.
  return mean_over(*this, 0.0, [&](const PlanPoint& a, const PlanPoint& b, const PlanPoint& c) {
    const PlanPoint r = a - about, s = b - about, t = c - about;
    return (r.squaredNorm() + s.squaredNorm() + t.squaredNorm() + (r + s + t).squaredNorm()) / 12;
  });
}

bool Footprint::contains(const PlanPoint& at) const {
  if (polygon.empty()) return (at.array() >= 0).all() && (at.array() <= size.array()).all();
  const double round_off = 1e-12 * size.maxCoeff();
  std::vector<PlanPoint> around = polygon;
  if (!is_convex()) {
    for (const std::vector<PlanPoint>& ring : rings) around.insert(around.end(), ring.begin(), ring.end());
    around = convex_hull(around);
  }
  for (std::size_t i = 0; i < around.size(); ++i) {
    const PlanPoint edge = corner_at(around, i + 1) - around[i];
    if (!(cross(edge, at - around[i]) >= -round_off * edge.norm())) return false;
  }
  return true;
}

std::optional<std::string> fault_of_outline(const std::vector<PlanPoint>& corners) {
  if (auto fault = fault_of_corners(corners)) return fault;
  if (auto fault = fault_of_edges(corners, edges_meet, "meet")) return fault;
  return fault_of_area(corners);
}

std::vector<PlanPoint> convex_hull(std::vector<PlanPoint> corners) {
  std::sort(corners.begin(), corners.end(),
            [](const PlanPoint& a, const PlanPoint& b) { return std::pair(a.x(), a.y()) < std::pair(b.x(), b.y()); });
  std::vector<PlanPoint> hull;
  for (int half = 0; half < 2; ++half) {  // below from left to right, then above and back
    const std::size_t begin = hull.size();
    for (const PlanPoint& at : corners) {
      while (hull.size() >= begin + 2 && !(cross(hull.back() - hull[hull.size() - 2], at - hull.back()) > 0)) {
        hull.pop_back();
      }
      hull.push_back(at);
    }
    hull.pop_back();
    std::reverse(corners.begin(), corners.end());
  }
  return hull;
}

std::optional<std::string> fault_of_polygon(const std::vector<PlanPoint>& corners) {
  if (auto fault = fault_of_corners(corners)) return fault;
  if (auto fault = fault_of_edges(corners, edges_cross, "cross")) return fault;
  if (auto fault = fault_of_area(corners)) return fault;
  const std::size_t count = corners.size();
  const double area = area_of(corners);
  double angle = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const PlanPoint before = corner_at(corners, i + 1) - corners[i];
    const PlanPoint after = corner_at(corners, i + 2) - corner_at(corners, i + 1);
    const double turn = turn_at(corners, i) * (area > 0 ? 1 : -1);
    angle += std::atan2(std::max(turn, 0.0), before.dot(after) / (before.norm() * after.norm()));
    if (turn > -straight) continue;
    const PlanPoint& at = corner_at(corners, i + 1);
    return fmt::format("must be convex: it turns inwards at corner {}, ({:.6g}, {:.6g})", (i + 1) % count + 1, at.x(),
                       at.y());
  }
  constexpr double once_and_a_half = 9.4;  // [rad]; once round is 2π
  if (angle > once_and_a_half) return "must go round once: its edges cross";
  return std::nullopt;
}

Footprint polygon_footprint(const PlanPoint& corner, std::vector<PlanPoint> corners,
                            std::vector<std::vector<PlanPoint>> courts) {
  if (area_of(corners) < 0) std::reverse(corners.begin(), corners.end());
  const std::vector<PlanPoint> kept = without_straight_ones(corners);
  for (std::vector<PlanPoint>& court : courts) {
    if (area_of(court) > 0) std::reverse(court.begin(), court.end());
    court = without_straight_ones(court);
  }
  return {.corner = corner, .size = extent_of(kept), .polygon = kept, .rings = std::move(courts)};
}

Footprint with_parts(Footprint footprint, std::vector<std::vector<PlanPoint>> parts) {
  PlanPoint low = low_of(footprint.polygon), high = low + extent_of(footprint.polygon);
  for (std::vector<PlanPoint>& part : parts) {
    if (area_of(part) < 0) std::reverse(part.begin(), part.end());
    footprint.rings.push_back(without_straight_ones(part));
    low = low.cwiseMin(low_of(part));
    high = high.cwiseMax(low_of(part) + extent_of(part));
  }
  footprint.size = high - low;
  return footprint;
}

std::optional<std::string> fault_of_court(const Footprint& footprint, std::size_t ring) {
  const std::vector<PlanPoint>& court = footprint.rings[ring];
  bool within = goes_round(footprint.polygon, court.front()), is_cut = rings_meet(court, footprint.polygon);
  for (const std::vector<PlanPoint>& part : footprint.rings) {
    if (!(area_of(part) > 0)) continue;
    within = within || goes_round(part, court.front());
    is_cut = is_cut || rings_meet(court, part);
  }
  if (is_cut || !within) return "must lie in the outline";
  for (std::size_t other = 0; other < ring; ++other) {
    const std::vector<PlanPoint>& before = footprint.rings[other];
    if (area_of(before) > 0) continue;
    if (rings_meet(court, before) || goes_round(before, court.front()) || goes_round(court, before.front())) {
      return fmt::format("must not meet court {}", other + 1);
    }
  }
  return std::nullopt;
}

std::optional<std::string> fault_of_part(const Footprint& footprint, std::size_t ring) {
  const std::vector<PlanPoint>& part = footprint.rings[ring];
  bool within = false, meets = false;
  const auto look_at = [&](const std::vector<PlanPoint>& other) {
    within = within != goes_round(other, part.front());  // in a court of another part it is beside that
    meets = meets || rings_meet(part, other) || (area_of(other) > 0 && goes_round(part, other.front()));
  };
  look_at(footprint.polygon);
  for (std::size_t other = 0; other < footprint.rings.size(); ++other) {
    const std::vector<PlanPoint>& one = footprint.rings[other];
    const bool is_own_court = area_of(one) < 0 && goes_round(part, one.front());
    if (other != ring && !is_own_court) look_at(one);
  }
  if (within || meets) return "must stand beside the polygon and all other parts";
  return std::nullopt;
}

}  // namespace bentur
