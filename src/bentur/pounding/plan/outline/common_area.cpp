#include "bentur/pounding/plan/outline/common_area.h"

#include <algorithm>
#include <boost/geometry.hpp>
#include <boost/geometry/geometries/multi_polygon.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/polygon.hpp>
#include <cmath>
#include <utility>
#include <vector>

#include "bentur/pounding/plan/outline/edges.h"

namespace bentur {
namespace {

using At = boost::geometry::model::d2::point_xy<double>;
using Polygon = boost::geometry::model::polygon<At, false>;  // counter-clockwise
using Polygons = boost::geometry::model::multi_polygon<Polygon>;

/// Its parts, each with its courts.
Polygons polygons_of(const Footprint& footprint) {
  Polygons polygons;
  const auto put = [](const std::vector<PlanPoint>& from, auto& ring) {
    for (const PlanPoint& at : from) ring.emplace_back(at.x(), at.y());
  };
  const std::vector<std::vector<PlanPoint>> rings = footprint.all_rings();
  for (const std::vector<PlanPoint>& ring : rings) {
    if (area_of(ring) > 0) put(ring, polygons.emplace_back().outer());
  }
  boost::geometry::correct(polygons);
  for (const std::vector<PlanPoint>& ring : rings) {
    if (area_of(ring) > 0) continue;
    const At corner(ring.front().x(), ring.front().y());
    const auto around = std::find_if(polygons.begin(), polygons.end(),
                                     [&](const Polygon& one) { return boost::geometry::within(corner, one.outer()); });
    put(ring, (around == polygons.end() ? polygons.front() : *around).inners().emplace_back());
  }
  boost::geometry::correct(polygons);
  return polygons;
}

template <class Ring>
std::vector<PlanPoint> corners_of(const Ring& ring) {
  std::vector<PlanPoint> corners;
  for (const At& at : ring) corners.emplace_back(at.x(), at.y());
  corners.pop_back();  // the first one again
  return corners;
}

/// Puts a place that is on the edges of an outline but for the grid of Boost's difference() onto them.
PlanPoint onto_edges(const PlanPoint& at, const std::vector<Edge>& edges, double near) {
  for (const Edge& edge : edges) {
    if ((edge.from - at).norm() <= near) return edge.from;
  }
  for (const Edge& edge : edges) {
    const PlanPoint way = edge.to - edge.from;
    const double part = way.dot(at - edge.from) / way.squaredNorm(), off = edge.normal.dot(at - edge.from);
    if (part >= 0 && part <= 1 && std::abs(off) <= near) return at - off * edge.normal;
  }
  return at;
}

}  // namespace

double common_area(const Footprint& one, const Footprint& other) {
  if (one.is_convex() && other.is_convex()) {  // to the round-off, which Boost's grid of whole numbers is not
    std::vector<PlanPoint> part = one.corners();
    for (const Edge& edge : edges_of(other)) part = part_behind(part, edge.normal, edge.normal.dot(edge.from));
    return area_of(part);
  }
  Polygons common;
  boost::geometry::intersection(polygons_of(one), polygons_of(other), common);
  return boost::geometry::area(common);
}

std::optional<Footprint> largest_rest(const Footprint& cut, const Footprint& kept) {
  Polygons rest;
  boost::geometry::difference(polygons_of(cut), polygons_of(kept), rest);
  const auto largest = std::max_element(rest.begin(), rest.end(), [](const Polygon& a, const Polygon& b) {
    return boost::geometry::area(a) < boost::geometry::area(b);
  });
  constexpr double round_off = 1e-6;
  const bool is_whole = std::abs(boost::geometry::area(rest) + common_area(cut, kept) - cut.area()) <=
                        round_off * cut.area();  // of Debian 12 it errs where a court touches
  if (largest == rest.end() || !is_whole) return std::nullopt;
  std::vector<Edge> edges;
  for (const std::vector<PlanPoint>& ring : kept.all_rings()) {
    for (const Edge& edge : edges_of(ring)) edges.push_back(edge);
  }
  const double near = round_off * std::max(cut.size.maxCoeff(), kept.size.maxCoeff());
  const auto along_kept = [&](std::vector<PlanPoint> ring) {
    for (PlanPoint& at : ring) at = onto_edges(at, edges, near);
    return ring;
  };
  std::vector<PlanPoint> corners = along_kept(corners_of(largest->outer()));
  if (fault_of_outline(corners)) return std::nullopt;
  std::vector<std::vector<PlanPoint>> courts;
  for (const auto& ring : largest->inners()) courts.push_back(along_kept(corners_of(ring)));
  for (PlanPoint& at : corners) at -= cut.corner;
  for (std::vector<PlanPoint>& court : courts) {
    for (PlanPoint& at : court) at -= cut.corner;
  }
  return polygon_footprint(cut.corner, std::move(corners), std::move(courts));
}

}  // namespace bentur
