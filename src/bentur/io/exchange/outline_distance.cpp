#include <algorithm>
#include <limits>

#include "bentur/io/exchange/internal/outline_distance.h"

namespace bentur {
namespace {

double turn(const PlanPoint& from, const PlanPoint& to, const PlanPoint& at) {
  const PlanPoint edge = to - from, way = at - from;
  return edge.x() * way.y() - edge.y() * way.x();
}

bool edges_cross(const PlanPoint& a, const PlanPoint& b, const PlanPoint& c, const PlanPoint& d) {
  return turn(a, b, c) * turn(a, b, d) < 0 && turn(c, d, a) * turn(c, d, b) < 0;
}

double distance_from_edge(const PlanPoint& at, const PlanPoint& from, const PlanPoint& to) {
  const PlanPoint edge = to - from;
  const double length2 = edge.squaredNorm();
  const double part = length2 > 0 ? std::clamp((at - from).dot(edge) / length2, 0.0, 1.0) : 0.0;
  return (from + part * edge - at).norm();
}

struct CornerBox {
  PlanPoint low, high;
  explicit CornerBox(const std::vector<PlanPoint>& corners) : low(corners.front()), high(corners.front()) {
    for (const PlanPoint& at : corners) {
      low = low.cwiseMin(at);
      high = high.cwiseMax(at);
    }
  }
};

}  // namespace

double outline_distance(const std::vector<PlanPoint>& one, const std::vector<PlanPoint>& other) {
  if (one.empty() || other.empty()) return std::numeric_limits<double>::infinity();
  if (goes_round(one, other.front()) || goes_round(other, one.front())) return 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < one.size(); ++i) {
    const PlanPoint &a = one[i], &b = one[(i + 1) % one.size()];
    for (std::size_t k = 0; k < other.size(); ++k) {
      const PlanPoint &c = other[k], &d = other[(k + 1) % other.size()];
      if (edges_cross(a, b, c, d)) return 0;
      least = std::min({least, distance_from_edge(a, c, d), distance_from_edge(c, a, b)});
    }
  }
  return least;
}

double distance_of_boxes(const std::vector<PlanPoint>& one, const std::vector<PlanPoint>& other) {
  if (one.empty() || other.empty()) return std::numeric_limits<double>::infinity();
  const CornerBox a(one), b(other);
  const PlanPoint apart = (a.low - b.high).cwiseMax(b.low - a.high).cwiseMax(0.0);
  return apart.norm();
}

}  // namespace bentur
