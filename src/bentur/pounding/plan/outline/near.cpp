#include "bentur/pounding/plan/outline/near.h"

#include <algorithm>
#include <boost/geometry.hpp>  // whole: what the tree needs of it differs from version to version
#include <boost/geometry/geometries/box.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <cmath>
#include <iterator>

namespace bentur {
namespace {

using At = boost::geometry::model::d2::point_xy<double>;
using Box = boost::geometry::model::box<At>;

Box box_of(const Footprint& footprint, double beyond) {
  const PlanPoint low = footprint.lower().array() - beyond, high = footprint.far_corner().array() + beyond;
  return {At(low.x(), low.y()), At(high.x(), high.y())};
}

/// How many times the width between a footprint and another one their distance is at most: the way between the two
/// places that are nearest is less than (π − α)/2 from the normal of an edge that meets there, α the sharpest corner.
double distance_over_width(const Footprint& footprint) {
  const std::vector<PlanPoint> corners = footprint.corners();
  double cosine = -1;  // of α
  for (std::size_t i = 0, count = corners.size(); i < count; ++i) {
    const PlanPoint before = corners[i] - corners[(i + 1) % count];
    const PlanPoint after = corners[(i + 2) % count] - corners[(i + 1) % count];
    cosine = std::max(cosine, before.dot(after) / (before.norm() * after.norm()));
  }
  return 1 / std::sqrt(std::max((1 - cosine) / 2, 1e-12));  // 1/sin(α/2)
}

}  // namespace

std::vector<std::pair<std::size_t, std::size_t>> pairs_near(const std::vector<Footprint>& footprints, double reach) {
  using Entry = std::pair<Box, std::size_t>;
  constexpr std::size_t most_of_a_node = 16;
  constexpr double round_off = 1e-9;  // of the larger side, as footprints that overlap by less are apart
  std::vector<Entry> entries;
  for (std::size_t i = 0; i < footprints.size(); ++i) entries.emplace_back(box_of(footprints[i], 0), i);
  const boost::geometry::index::rtree<Entry, boost::geometry::index::quadratic<most_of_a_node>> tree(entries);
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  for (std::size_t i = 0; i < footprints.size(); ++i) {
    const double beyond =
        1.001 * reach * distance_over_width(footprints[i]) + round_off * footprints[i].size.maxCoeff();
    std::vector<Entry> found;
    tree.query(boost::geometry::index::intersects(box_of(footprints[i], beyond)), std::back_inserter(found));
    for (const Entry& one : found) {
      if (one.second > i) pairs.emplace_back(i, one.second);
    }
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

}  // namespace bentur
