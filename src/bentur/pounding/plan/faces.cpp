#include "bentur/pounding/plan/faces.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "bentur/pounding/plan/outline/common_area.h"
#include "bentur/pounding/plan/outline/edges.h"
#include "bentur/pounding/plan/outline/parts.h"

namespace bentur {
namespace {

double least_along(const Footprint& footprint, const PlanPoint& direction) {
  double least = std::numeric_limits<double>::infinity();
  for (const PlanPoint& at : footprint.corners()) least = std::min(least, direction.dot(at));
  return least;
}

/// A direction and how far apart footprints are along it.
struct Separation {
  PlanPoint normal = PlanPoint::Zero();  ///< from the first to the second
  double width = -std::numeric_limits<double>::infinity();
};

/// Of convex ones, along the normal of the edge that separates them the most; one has to be moved by −width where it is
/// below zero.
Separation separation_of(const Footprint& one, const Footprint& other) {
  Separation most;
  for (const Edge& edge : edges_of(one)) {
    const double width = least_along(other, edge.normal) - edge.normal.dot(edge.from);
    if (width > most.width) most = {edge.normal, width};
  }
  for (const Edge& edge : edges_of(other)) {
    const double width = least_along(one, edge.normal) - edge.normal.dot(edge.from);
    if (width > most.width) most = {-edge.normal, width};
  }
  return most;
}

/// The part of a footprint that is seen from outside along a direction: edges that face it, and their ends, along an
/// axis across.
struct Contour {
  std::vector<Edge> edges;
  std::vector<PlanPoint> corners;
  double from = std::numeric_limits<double>::infinity(), to = -from;
};

Contour contour_of(const Footprint& footprint, const PlanPoint& outwards, const PlanPoint& axis, double least) {
  Contour contour;
  for (const Edge& edge : edges_of(footprint)) {
    const bool is_seen = edge.normal.dot(outwards) > 0 && std::abs(axis.dot(edge.to - edge.from)) > least;
    if (!is_seen) continue;
    contour.edges.push_back(edge);
    for (const PlanPoint& at : {edge.from, edge.to}) {
      contour.corners.push_back(at);
      contour.from = std::min(contour.from, axis.dot(at));
      contour.to = std::max(contour.to, axis.dot(at));
    }
  }
  return contour;
}

/// The edge of a contour that is before a place along the axis: of two the one that faces `outwards` more.
const Edge* edge_at(const Contour& contour, double along, const PlanPoint& outwards, const PlanPoint& axis,
                    double least) {
  const Edge* found = nullptr;
  for (const Edge& edge : contour.edges) {
    const auto [low, high] = std::minmax({axis.dot(edge.from), axis.dot(edge.to)});
    if (along < low - least || along > high + least) continue;
    if (found == nullptr || edge.normal.dot(outwards) > found->normal.dot(outwards)) found = &edge;
  }
  return found;
}

std::optional<PlanPoint> corner_at(const Contour& contour, double along, const PlanPoint& axis, double least) {
  for (const PlanPoint& at : contour.corners) {
    if (std::abs(axis.dot(at) - along) <= least) return at;
  }
  return std::nullopt;
}

/// @param of_left whether the corner is of L; `beyond` is then the whole width
StretchCorner before(const PlanPoint& corner, const Edge& edge, bool of_left, const PlanPoint& axis) {
  const double width = edge.normal.dot(corner - edge.from);
  const PlanPoint foot = corner - width * edge.normal;
  const double room = std::min((foot - edge.from).norm(), (foot - edge.to).norm());
  StretchCorner made{.along = axis.dot(corner), .beyond = width, .room = room};
  made.left = of_left ? corner : foot;
  made.right = of_left ? foot : corner;
  made.normal = of_left ? PlanPoint(-edge.normal) : edge.normal;
  return made;
}

/// Of the corners at a place of the axis the one before the edge that faces n the most.
std::optional<StretchCorner> corner_before_edge(const Contour& left, const Contour& right, double along,
                                                const PlanPoint& n, const PlanPoint& axis, double least) {
  const auto of_left = corner_at(left, along, axis, least), of_right = corner_at(right, along, axis, least);
  const Edge* const before_left = of_left ? edge_at(right, along, -n, axis, least) : nullptr;
  const Edge* const before_right = of_right ? edge_at(left, along, n, axis, least) : nullptr;
  if (before_left == nullptr && before_right == nullptr) return std::nullopt;
  const bool is_left =
      before_right == nullptr || (before_left != nullptr && -before_left->normal.dot(n) >= before_right->normal.dot(n));
  return is_left ? before(*of_left, *before_left, true, axis) : before(*of_right, *before_right, false, axis);
}

/// Of a direction from the first of two to the second, without places.
Stretch seen_along(PlanPoint n) {
  constexpr double none = 1e-12;
  const bool swapped = n.x() < -none || (n.x() <= none && n.y() < 0);
  if (swapped) n = -n;
  n += PlanPoint::Zero();  // no −0
  return {.swapped = swapped, .n = n, .across = std::abs(n.x()) >= std::abs(n.y()) ? 0 : 1};
}

/// Along the joint.
PlanPoint axis_of(const Stretch& stretch) {
  const PlanPoint axis(-stretch.n.y(), stretch.n.x());
  return axis[1 - stretch.across] < 0 ? PlanPoint(-axis) : axis;
}

/// An edge of L or R as what the other may touch.
struct EdgeOfTwo {
  Edge edge;
  bool of_left = false;
  PlanPoint n;  ///< from L to R
  double width = 0;
};

std::vector<EdgeOfTwo> edges_between(const Footprint& left, const Footprint& right) {
  std::vector<EdgeOfTwo> all;
  for (const Edge& edge : edges_of(left)) {
    all.push_back({edge, true, edge.normal, least_along(right, edge.normal) - edge.normal.dot(edge.from)});
  }
  for (const Edge& edge : edges_of(right)) {
    all.push_back({edge, false, -edge.normal, least_along(left, edge.normal) - edge.normal.dot(edge.from)});
  }
  return all;
}

/// The part that two parallel edges have in common along t; from > to where they stand past each other.
std::pair<double, double> common_part(const Edge& one, const Edge& other, const PlanPoint& t) {
  const auto [low, high] = std::minmax({t.dot(one.from), t.dot(one.to)});
  const auto [other_low, other_high] = std::minmax({t.dot(other.from), t.dot(other.to)});
  return {std::max(low, other_low), std::min(high, other_high)};
}

/// Of two parallel edges, or nearly so, at a place along t.
StretchCorner on_both(const Edge& of_left, const Edge& of_right, const PlanPoint& n, const PlanPoint& t, double along) {
  const auto on = [&](const Edge& edge) -> PlanPoint {
    const PlanPoint own(-edge.normal.y(), edge.normal.x());
    return edge.from + (along - t.dot(edge.from)) / t.dot(own) * own;
  };
  StretchCorner made{.left = on(of_left), .right = on(of_right), .normal = n};
  made.beyond = n.dot(made.right - made.left);
  return made;
}

/// Of two edges that are nearly parallel, where one of them ends before the other.
StretchCorner at_end(const Edge& of_left, const Edge& of_right, const PlanPoint& t, double along) {
  const auto end_there = [&](const Edge& edge) {
    return std::abs(t.dot(edge.from) - along) < std::abs(t.dot(edge.to) - along) ? edge.from : edge.to;
  };
  const PlanPoint left = end_there(of_left), right = end_there(of_right);
  const bool ends_left = std::abs(t.dot(left) - along) <= std::abs(t.dot(right) - along);
  return ends_left ? before(left, of_right, true, t) : before(right, of_left, false, t);
}

/// The edge of the other one that faces it most, where both are parallel or nearly so; nullptr where there is none.
const EdgeOfTwo* opposite_of(const EdgeOfTwo& edge, const std::vector<EdgeOfTwo>& all) {
  const EdgeOfTwo* most = nullptr;
  for (const EdgeOfTwo& one : all) {
    if (one.of_left == edge.of_left || !is_nearly_one_direction(one.n, edge.n)) continue;
    if (most == nullptr || one.n.dot(edge.n) > most->n.dot(edge.n)) most = &one;
  }
  return most;
}

/// Where one touches an edge of the other first, in one place or two; `beyond` is the whole width.
std::vector<StretchCorner> first_touches(const Footprint& left, const Footprint& right, const EdgeOfTwo& edge,
                                         const std::vector<EdgeOfTwo>& all, double least) {
  const PlanPoint& n = edge.n;
  const PlanPoint t(-n.y(), n.x());
  if (const EdgeOfTwo* const opposite = opposite_of(edge, all)) {
    const Edge &of_left = edge.of_left ? edge.edge : opposite->edge,
               &of_right = edge.of_left ? opposite->edge : edge.edge;
    const auto [from, to] = common_part(of_left, of_right, t);
    if (!(to - from > least)) return {on_both(of_left, of_right, n, t, 0.5 * (from + to))};
    if (is_one_direction(opposite->n, n)) {
      return {on_both(of_left, of_right, n, t, from), on_both(of_left, of_right, n, t, to)};
    }
    return {at_end(of_left, of_right, t, from), at_end(of_left, of_right, t, to)};
  }
  const Footprint& other = edge.of_left ? right : left;
  PlanPoint nearest = other.corners().front();
  for (const PlanPoint& at : other.corners()) {
    if (edge.edge.normal.dot(at - nearest) < 0) nearest = at;
  }
  return {before(nearest, edge.edge, !edge.of_left, t)};
}

/// One edge of each direction that is not the joint's, in their order: of those that are nearly parallel the one that
/// separates the two the most, whichever of them has it.
std::vector<const EdgeOfTwo*> edges_beside(const std::vector<EdgeOfTwo>& all, const Stretch& joint, double reach) {
  std::vector<std::pair<const EdgeOfTwo*, const EdgeOfTwo*>> found;  // by the first of two that are parallel
  for (const EdgeOfTwo& edge : all) {
    if (edge.width > -reach && !joint.includes({.normal = edge.n})) found.emplace_back(&edge, &edge);
  }
  std::stable_sort(found.begin(), found.end(), [](auto& a, auto& b) { return a.second->width > b.second->width; });
  std::vector<PlanPoint> known;
  std::erase_if(found, [&](auto& one) {
    const PlanPoint n = one.second->n;
    if (std::any_of(known.begin(), known.end(), [&](auto& at) { return is_one_direction(at, n); })) return true;
    known.push_back(n);
    const EdgeOfTwo* const opposite = opposite_of(*one.second, all);
    if (opposite == nullptr) return false;
    known.push_back(opposite->n);
    one.first = std::min(one.first, opposite);
    if (is_one_direction(opposite->n, n)) one.second = one.first;
    return false;
  });
  std::sort(found.begin(), found.end());
  std::vector<const EdgeOfTwo*> edges;
  for (const auto& one : found) edges.push_back(one.second);
  return edges;
}

}  // namespace

PlanPoint Stretch::tangent(double along) const {
  const PlanPoint n = normal(along);
  return {-n.y(), n.x()};
}

StretchCorner Stretch::at(double along) const {
  if (corners.empty()) throw std::out_of_range("a stretch without corners");
  auto after =
      std::find_if(corners.begin(), corners.end(), [&](const StretchCorner& one) { return one.along >= along; });
  if (after == corners.end()) return corners.back();
  if (after == corners.begin() || after->along == along) return *after;
  const StretchCorner &low = *(after - 1), &high = *after;
  const double part = (along - low.along) / (high.along - low.along);
  const auto between = [&](const auto& one, const auto& other) { return (1 - part) * one + part * other; };
  StretchCorner made{.along = along, .beyond = between(low.beyond, high.beyond), .room = std::min(low.room, high.room)};
  made.left = between(low.left, high.left);
  made.right = between(low.right, high.right);
  made.normal = low.normal == high.normal ? low.normal : PlanPoint(between(low.normal, high.normal).normalized());
  return made;
}

PlanPoint Stretch::on_edge(int side, double along) const {
  const StretchCorner found = at(along);
  return side == 0 ? found.left : found.right;
}

std::optional<double> crossing(const Stretch& stretch, int side, const PlanPoint& through, const PlanPoint& direction) {
  const double round_off = 1e-9 * (stretch.to - stretch.from);
  const auto off = [&](double along) {
    const PlanPoint arm = stretch.on_edge(side, along) - through;
    return direction.x() * arm.y() - direction.y() * arm.x();
  };
  const std::vector<double> corners = stretch.corners_along();
  for (std::size_t i = 1; i < corners.size(); ++i) {
    const double from = corners[i - 1], to = corners[i], a = off(from), b = off(to);
    if (std::abs(b - a) <= round_off) continue;  // it runs along the edge
    const double at = from - a / (b - a) * (to - from);
    if (at >= from - round_off && at <= to + round_off) return std::clamp(at, from, to);
  }
  return std::nullopt;
}

std::vector<double> Stretch::corners_along() const {
  std::vector<double> all;
  for (const StretchCorner& one : corners) {
    if (includes(one)) all.push_back(one.along);
  }
  return all;
}

bool Stretch::includes(const StretchCorner& place) const {
  constexpr double cosine = 0.9659;  // of 15°
  return place.normal.dot(n) >= cosine;
}

double Stretch::coordinate(double along) const { return is_oblique() ? middle(along)[1 - across] : along; }

std::optional<double> Stretch::along_at(double coordinate) const {
  if (!is_oblique()) return coordinate >= from && coordinate <= to ? std::optional(coordinate) : std::nullopt;
  for (std::size_t i = 1; i < corners.size(); ++i) {
    const double low = corners[i - 1].along, high = corners[i].along;
    const double at_low = this->coordinate(low), at_high = this->coordinate(high);
    const double part = (coordinate - at_low) / (at_high - at_low);
    if (part >= 0 && part <= 1) return low + part * (high - low);
  }
  return std::nullopt;
}

bool Stretch::is_parallel() const { return corners.size() == 2 && corners[0].beyond == 0 && corners[1].beyond == 0; }

bool Stretch::is_oblique() const { return !is_parallel() || n[across] != 1; }

double overlap_depth(const Footprint& one, const Footprint& other) {
  if (one.is_convex() && other.is_convex()) return -separation_of(one, other).width;
  double deepest = -std::numeric_limits<double>::infinity();
  const std::vector<OutlinePart> others = parts_of(other);
  for (const OutlinePart& a : parts_of(one)) {
    for (const OutlinePart& b : others) {
      deepest = std::max(deepest, -separation_of(a.footprint, b.footprint).width);
    }
  }
  return deepest;
}

bool overlap(const Footprint& one, const Footprint& other) { return overlap_depth(one, other) > least_of(one, other); }

std::optional<Footprint> cut_back(const Footprint& cut, const Footprint& kept) {
  if (!overlap(cut, kept)) return cut;
  if (!cut.is_convex() || !kept.is_convex()) return largest_rest(cut, kept);
  const PlanPoint out = separation_of(cut, kept).normal;  // from what is cut
  std::vector<PlanPoint> left;
  const double near = least_of(cut, kept);
  for (const PlanPoint& at : part_behind(cut.corners(), out, least_along(kept, out))) {
    if (left.empty() || (at - left.back()).norm() > near) left.push_back(at);
  }
  while (left.size() > 1 && (left.back() - left.front()).norm() <= near) left.pop_back();
  if (fault_of_polygon(left)) return std::nullopt;
  for (PlanPoint& at : left) at -= cut.corner;
  return polygon_footprint(cut.corner, std::move(left));
}

std::optional<Stretch> facing(const Footprint& one, const Footprint& other) {
  if (!one.is_convex() || !other.is_convex()) {
    const auto joint = joint_between(one, other);
    return joint && !joint->is_corner() ? joint : std::nullopt;
  }
  const double least = least_of(one, other);
  const Separation apart = separation_of(one, other);
  if (apart.width < -least) return std::nullopt;
  Stretch stretch = seen_along(apart.normal);
  const PlanPoint n = stretch.n, axis = axis_of(stretch);
  const bool swapped = stretch.swapped;
  const Contour left = contour_of(swapped ? other : one, n, axis, least);
  const Contour right = contour_of(swapped ? one : other, -n, axis, least);
  stretch.shorter = std::min(left.to - left.from, right.to - right.from);
  stretch.from = std::max(left.from, right.from);
  stretch.to = std::min(left.to, right.to);
  if (!(stretch.to - stretch.from > least)) return std::nullopt;
  std::vector<double> places = {stretch.from, stretch.to};
  for (const Contour* const contour : {&left, &right}) {
    for (const PlanPoint& at : contour->corners) places.push_back(axis.dot(at));
  }
  std::sort(places.begin(), places.end());
  for (const double along : places) {
    if (along < stretch.from || along > stretch.to) continue;
    const bool is_told = !stretch.corners.empty() && along - stretch.corners.back().along <= least;
    if (is_told) continue;
    if (auto corner = corner_before_edge(left, right, along, n, axis, least)) stretch.corners.push_back(*corner);
  }
  if (stretch.corners.size() < 2) return std::nullopt;
  stretch.corners.front().along = stretch.from;
  stretch.corners.back().along = stretch.to;
  stretch.width = std::numeric_limits<double>::infinity();
  for (const StretchCorner& corner : stretch.corners) {
    if (stretch.includes(corner)) stretch.width = std::min(stretch.width, corner.beyond);
  }
  // Of what is slightly turned and stands corner to corner a far corner may be before an edge in a common part of
  // millimetres: edges of a stretch are at most 15° from parallel, and no further apart than that brings about.
  constexpr double sine_of_15 = 0.2588;
  if (std::isinf(stretch.width) || stretch.width - apart.width > sine_of_15 * stretch.shorter) return std::nullopt;
  if (stretch.width < least) stretch.width = 0;
  for (StretchCorner& corner : stretch.corners) {
    corner.beyond -= stretch.width;
    if (std::abs(corner.beyond) < least) corner.beyond = 0;
  }
  return stretch;
}

std::optional<Stretch> joint_between(const Footprint& one, const Footprint& other) {
  if (!one.is_convex() || !other.is_convex()) {
    const std::vector<PartPair> pairs = pairs_of_parts(one, other, 0);
    return pairs.empty() ? std::nullopt : std::optional(pairs.front().joint);
  }
  if (auto stretch = facing(one, other)) return stretch;
  const double least = least_of(one, other);
  const Separation apart = separation_of(one, other);
  if (apart.width < -least) return std::nullopt;
  Stretch joint = seen_along(apart.normal);
  const Footprint &left = joint.swapped ? other : one, &right = joint.swapped ? one : other;
  const std::vector<EdgeOfTwo> all = edges_between(left, right);
  const auto edge = std::find_if(all.begin(), all.end(), [&](const EdgeOfTwo& at) {
    return is_one_direction(at.n, joint.n) && at.width >= apart.width;
  });
  StretchCorner place = first_touches(left, right, *edge, all, least).front();
  joint.width = std::max(place.beyond, 0.0);
  if (joint.width < least) joint.width = 0;
  place.beyond = 0;
  const PlanPoint axis = axis_of(joint);
  place.along = joint.from = joint.to = axis.dot(0.5 * (place.left + place.right));
  joint.corners = {place};
  return joint;
}

std::vector<FamilyBeside> families_beside(const Footprint& left, const Footprint& right, const Stretch& joint,
                                          double reach) {
  const double least = least_of(left, right);
  const PlanPoint axis = axis_of(joint);
  const std::vector<EdgeOfTwo> all = edges_between(left, right);
  std::vector<FamilyBeside> families;
  for (const EdgeOfTwo* const edge : edges_beside(all, joint, reach)) {
    FamilyBeside& family = families.emplace_back(FamilyBeside{first_touches(left, right, *edge, all, least)});
    for (StretchCorner& place : family.places) {
      place.beyond -= joint.width;
      place.along = axis.dot(0.5 * (place.left + place.right));
    }
  }
  return families;
}

}  // namespace bentur
