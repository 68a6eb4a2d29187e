#include "bentur/pounding/plan/faces.h"

#include <algorithm>

namespace bentur {
namespace {

constexpr double nothing_in_common = 1e-9;  // of the largest side

double least_of(const Footprint& one, const Footprint& other) {
  return nothing_in_common * std::max(one.size.maxCoeff(), other.size.maxCoeff());
}

/// What they have in common of a coordinate; below zero their distance [length].
double common(const Footprint& one, const Footprint& other, int coordinate) {
  return std::min(one.far_corner()(coordinate), other.far_corner()(coordinate)) -
         std::max(one.corner(coordinate), other.corner(coordinate));
}

}  // namespace

PlanPoint Stretch::on_edge(int side, double along) const {
  PlanPoint at;
  at(across) = side == 0 ? left_edge : right_edge;
  at(1 - across) = along;
  return at;
}

bool overlap(const Footprint& one, const Footprint& other) {
  const double least = least_of(one, other);
  return common(one, other, 0) > least && common(one, other, 1) > least;
}

std::optional<Stretch> facing(const Footprint& one, const Footprint& other) {
  const double least = least_of(one, other);
  for (const int across : {0, 1}) {
    const int along = 1 - across;
    if (common(one, other, across) > least || !(common(one, other, along) > least)) continue;
    const bool swapped = other.corner(across) < one.corner(across);
    const Footprint& left = swapped ? other : one;
    const Footprint& right = swapped ? one : other;
    Stretch stretch{.swapped = swapped, .across = across};
    stretch.from = std::max(one.corner(along), other.corner(along));
    stretch.to = std::min(one.far_corner()(along), other.far_corner()(along));
    stretch.left_edge = left.far_corner()(across);
    stretch.right_edge = right.corner(across);
    stretch.width = stretch.right_edge - stretch.left_edge;
    if (stretch.width < least) stretch.width = 0;
    return stretch;
  }
  return std::nullopt;
}

std::vector<StretchPoint> points_of(const Stretch& stretch, int points) {
  std::vector<StretchPoint> all;
  const int last = points - 1;
  for (int i = 0; i <= last; ++i) {
    const double along = i == last ? stretch.to : stretch.from + i * (stretch.to - stretch.from) / last;
    all.push_back({along, (i == 0 || i == last ? 0.5 : 1.0) / last});
  }
  return all;
}

}  // namespace bentur
