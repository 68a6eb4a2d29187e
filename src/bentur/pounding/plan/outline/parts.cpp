#include "bentur/pounding/plan/outline/parts.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <stdexcept>
#include <utility>

#include "bentur/pounding/plan/outline/edges.h"

namespace bentur {
namespace {

constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

/// Two places of two segments.
struct Between {
  PlanPoint of_one, of_other;
  [[nodiscard]] double distance() const { return (of_other - of_one).norm(); }
};

PlanPoint nearest_of(const PlanPoint& from, const PlanPoint& to, const PlanPoint& at) {
  const PlanPoint way = to - from;
  return from + std::clamp(way.dot(at - from) / way.squaredNorm(), 0.0, 1.0) * way;
}

/// The nearest two places of segments that do not cross.
Between between(const Edge& one, const Edge& other) {
  Between nearest{one.from, nearest_of(other.from, other.to, one.from)};
  for (const Between& next : {Between{one.to, nearest_of(other.from, other.to, one.to)},
                              Between{nearest_of(one.from, one.to, other.from), other.from},
                              Between{nearest_of(one.from, one.to, other.to), other.to}}) {
    if (next.distance() < nearest.distance()) nearest = next;
  }
  return nearest;
}

/// Takes an outline apart: behind each edge lies the largest part that it finds by cutting off, nearest first, what
/// else of the outline is in the way.
class Parting {
 public:
  explicit Parting(const Footprint& outline) {
    const PlanPoint low = outline.lower(), high = outline.far_corner();
    box_ = {low, {high.x(), low.y()}, high, {low.x(), high.y()}};
    least_ = 1e-10 * outline.size.maxCoeff();
    near_ = 1e-6 * outline.size.maxCoeff();
    for (const std::vector<PlanPoint>& ring : outline.all_rings()) {
      const std::size_t first = edges_.size(), count = ring.size();
      for (const Edge& edge : edges_of(ring)) {
        const std::size_t i = edges_.size() - first;
        near_ = std::min(near_, 0.25 * (edge.to - edge.from).norm());
        edges_.push_back(edge);
        before_.push_back(first + (i + count - 1) % count);
        after_.push_back(first + (i + 1) % count);
      }
    }
    owner_.assign(edges_.size(), none);
  }

  std::vector<OutlinePart> all() {
    std::vector<OutlinePart> parts;
    std::vector<std::vector<std::size_t>> behind;  // of each corner of each part the edge of the outline that is there
    std::vector<std::size_t> longest_first(edges_.size());
    std::iota(longest_first.begin(), longest_first.end(), 0U);
    std::stable_sort(longest_first.begin(), longest_first.end(),
                     [&](std::size_t a, std::size_t b) { return edges_[a].length() > edges_[b].length(); });
    for (const std::size_t e : longest_first) {
      if (owner_[e] != none) continue;
      const std::vector<PlanPoint> region = region_behind(e);
      std::vector<std::size_t>& edges = behind.emplace_back(region.size(), none);
      for (std::size_t i = 0; i < region.size(); ++i) {
        edges[i] = edge_between(region[i], region[(i + 1) % region.size()]);
        if (edges[i] != none && owner_[edges[i]] == none) owner_[edges[i]] = parts.size();
      }
      if (owner_[e] == none) throw std::logic_error("an edge of an outline has no part behind it");
      OutlinePart& part = parts.emplace_back();
      part.footprint = polygon_footprint({0, 0}, region);
      part.footprint.polygon = region;
    }
    for (std::size_t p = 0; p < parts.size(); ++p) {
      const std::vector<PlanPoint>& corners = parts[p].footprint.polygon;
      for (std::size_t i = 0; i < corners.size(); ++i) {
        parts[p].own.push_back(behind[p][i] != none && owner_[behind[p][i]] == p);
        parts[p].sides.push_back(sides_at(corners[i], p));
      }
    }
    return parts;
  }

 private:
  /// Of a corner of part `part`.
  [[nodiscard]] std::array<OutlinePart::Side, 2> sides_at(const PlanPoint& at, std::size_t part) const {
    for (std::size_t e = 0; e < edges_.size(); ++e) {
      if (edges_[e].from != at) continue;
      return {{{edges_[before_[e]].normal, owner_[before_[e]] == part}, {edges_[e].normal, owner_[e] == part}}};
    }
    return {};
  }

  [[nodiscard]] std::size_t edge_between(const PlanPoint& from, const PlanPoint& to) const {
    for (std::size_t e = 0; e < edges_.size(); ++e) {
      if (edges_[e].from == from && edges_[e].to == to) return e;
    }
    return none;
  }

  /// Whether the outline turns inwards where an edge of it begins.
  [[nodiscard]] bool turns_inwards(std::size_t e) const {
    const Edge& before = edges_[before_[e]];
    return before.normal.dot(edges_[e].to - edges_[e].from) > 0;
  }

  /// What of an edge is within a convex region.
  [[nodiscard]] std::optional<Edge> within(const std::vector<PlanPoint>& region, const Edge& edge) const {
    double from = 0, to = 1;
    for (const Edge& side : edges_of(region)) {
      const double at_from = side.normal.dot(edge.from - side.from) + least_;
      const double at_to = side.normal.dot(edge.to - side.from) + least_;
      if (at_from >= 0 && at_to >= 0) return std::nullopt;
      if (at_from > 0) from = std::max(from, at_from / (at_from - at_to));
      if (at_to > 0) to = std::min(to, at_from / (at_from - at_to));
    }
    const PlanPoint way = edge.to - edge.from;
    if (!((to - from) * way.norm() > least_)) return std::nullopt;
    return Edge{edge.from + from * way, edge.from + to * way, edge.normal};
  }

  /// Without an edge that is in it, by the line that leaves the most and all of `kept`.
  [[nodiscard]] std::vector<PlanPoint> without(const std::vector<PlanPoint>& region, const Edge& edge,
                                               const Edge& kept) const {
    std::vector<std::pair<PlanPoint, double>> lines;  // what is behind them is left
    const double bound = edge.normal.dot(edge.from);
    if (std::max(edge.normal.dot(kept.from), edge.normal.dot(kept.to)) <= bound + least_) {
      lines.emplace_back(edge.normal, bound);
    }
    const double depth = -std::max(kept.normal.dot(edge.from - kept.from), kept.normal.dot(edge.to - kept.from));
    if (depth > least_) lines.emplace_back(-kept.normal, depth - kept.normal.dot(kept.from));
    const Between nearest = between(kept, edge);
    if (nearest.distance() > least_) {
      const PlanPoint way = (nearest.of_other - nearest.of_one).normalized();
      lines.emplace_back(way, way.dot(nearest.of_other));
    }
    std::vector<PlanPoint> most;
    for (const auto& [normal, at] : lines) {
      std::vector<PlanPoint> left = part_behind(region, normal, at);
      if (most.empty() || area_of(left) > area_of(most)) most = std::move(left);
    }
    if (most.empty()) throw std::logic_error("an edge of an outline meets another one");
    return most;
  }

  [[nodiscard]] std::vector<PlanPoint> region_behind(std::size_t e) const {
    const Edge& own = edges_[e];
    const PlanPoint along = (own.to - own.from).normalized();
    std::vector<PlanPoint> region = part_behind(box_, own.normal, own.normal.dot(own.from));
    if (turns_inwards(e)) region = part_behind(region, -along, -along.dot(own.from));
    if (turns_inwards(after_[e])) region = part_behind(region, along, along.dot(own.to));
    for (std::size_t cuts = 0; cuts <= 2 * edges_.size(); ++cuts) {
      std::optional<Edge> nearest;
      double distance = std::numeric_limits<double>::infinity();
      for (std::size_t other = 0; other < edges_.size(); ++other) {
        const std::optional<Edge> piece = other == e ? std::nullopt : within(region, edges_[other]);
        if (!piece || between(own, *piece).distance() >= distance) continue;
        nearest = piece;
        distance = between(own, *piece).distance();
      }
      if (!nearest) return tidy(region);
      region = without(region, *nearest, own);
    }
    throw std::logic_error("an outline cannot be taken apart");
  }

  /// With the outline's own corners in place of those that are they but for round-off.
  [[nodiscard]] std::vector<PlanPoint> tidy(const std::vector<PlanPoint>& region) const {
    std::vector<PlanPoint> all;
    for (const PlanPoint& at : region) {
      const auto own = std::find_if(edges_.begin(), edges_.end(),
                                    [&](const Edge& edge) { return (edge.from - at).norm() <= near_; });
      const PlanPoint& place = own == edges_.end() ? at : own->from;
      if (all.empty() || (all.back() - place).norm() > near_) all.push_back(place);
    }
    while (all.size() > 1 && (all.back() - all.front()).norm() <= near_) all.pop_back();
    return all;
  }

  std::vector<PlanPoint> box_;
  std::vector<Edge> edges_;
  std::vector<std::size_t> before_, after_;  ///< on the ring of each
  std::vector<std::size_t> owner_;           ///< number of the part whose own it is
  double least_, near_;                      ///< [length]
};

OutlinePart whole(const Footprint& outline) {
  OutlinePart part{.footprint = outline};
  const std::vector<Edge> edges = edges_of(outline);
  part.own.assign(edges.size(), 1);
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const Edge& before = edges[(i + edges.size() - 1) % edges.size()];
    part.sides.push_back({{{before.normal, true}, {edges[i].normal, true}}});
  }
  return part;
}

double extent_along(const Footprint& outline, const PlanPoint& axis) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const std::vector<PlanPoint>& ring : outline.all_rings()) {
    for (const PlanPoint& at : ring) {
      low = std::min(low, axis.dot(at));
      high = std::max(high, axis.dot(at));
    }
  }
  return high - low;
}

/// The edge of a part that has that normal, or nearly so; −1: it has none.
int edge_along(const OutlinePart& part, const PlanPoint& normal) {
  const std::vector<Edge> edges = edges_of(part.footprint);
  int most = -1;
  for (int i = 0; i < std::ssize(edges); ++i) {
    if (!is_nearly_one_direction(edges[i].normal, normal)) continue;
    if (most < 0 || edges[i].normal.dot(normal) > edges[most].normal.dot(normal)) most = i;
  }
  return most;
}

/// Whether the corner of a part at a place touches an edge with this normal: it does so in the part that has the edge
/// that meets there and faces it the most.
bool touches_edge(const OutlinePart& part, const PlanPoint& at, const PlanPoint& normal, double least) {
  const std::vector<PlanPoint> corners = part.footprint.corners();
  for (std::size_t i = 0; i < corners.size(); ++i) {
    if ((corners[i] - at).norm() > least) continue;
    const auto& [ends, begins] = part.sides[i];
    return -ends.normal.dot(normal) > -begins.normal.dot(normal) ? ends.own : begins.own;
  }
  return false;
}

}  // namespace

std::vector<OutlinePart> parts_of(const Footprint& outline) {
  if (outline.is_convex()) return {whole(outline)};
  return Parting(outline).all();
}

bool is_of_outlines(const PartPair& pair, const StretchCorner& place) {
  const OutlinePart &l = pair.joint.swapped ? pair.right : pair.left, &r = pair.joint.swapped ? pair.left : pair.right;
  const double least = least_of(l.footprint, r.footprint);
  const int of_l = edge_along(l, place.normal), of_r = edge_along(r, -place.normal);
  if (of_l >= 0 && of_r >= 0) return l.own[of_l] != 0 && r.own[of_r] != 0;
  if (of_l >= 0) return l.own[of_l] != 0 && touches_edge(r, place.right, place.normal, least);
  return of_r >= 0 && r.own[of_r] != 0 && touches_edge(l, place.left, -place.normal, least);
}

std::vector<PartPair> pairs_of_parts(const Footprint& left, const Footprint& right, double reach) {
  const std::vector<OutlinePart> lefts = parts_of(left), rights = parts_of(right);
  std::vector<PartPair> pairs;
  for (const OutlinePart& one : lefts) {
    for (const OutlinePart& other : rights) {
      std::optional<Stretch> joint = joint_between(one.footprint, other.footprint);
      if (!joint) return {};
      const PlanPoint axis(-joint->n.y(), joint->n.x());
      joint->shorter = std::min(extent_along(left, axis), extent_along(right, axis));
      pairs.push_back({one, other, *std::move(joint)});
    }
  }
  constexpr double any_reach = std::numeric_limits<double>::infinity();  // the same pair is first whatever the reach is
  const double least = least_of(left, right);
  std::vector<char> of_joint;  // whether a place of their joint is of the outlines, pair after pair
  std::erase_if(pairs, [&](const PartPair& pair) {
    const bool by_joint = std::any_of(pair.joint.corners.begin(), pair.joint.corners.end(), [&](const auto& place) {
      return pair.joint.includes(place) && is_of_outlines(pair, place);
    });
    bool touches = by_joint;
    if (!touches) {
      for (const FamilyBeside& one : families_beside(pair.of_l(), pair.of_r(), pair.joint, any_reach)) {
        touches = touches || std::any_of(one.places.begin(), one.places.end(),
                                         [&](const auto& place) { return is_of_outlines(pair, place); });
      }
    }
    if (touches) of_joint.push_back(by_joint ? 1 : 0);
    return !touches;
  });
  if (pairs.empty()) return pairs;
  std::size_t main = 0;
  for (std::size_t i = 1; i < pairs.size(); ++i) {
    const Stretch &best = pairs[main].joint, &joint = pairs[i].joint;
    const bool longer = joint.to - joint.from > best.to - best.from + least;
    const bool narrower = joint.width < best.width - least || (joint.width <= best.width + least && longer);
    if (of_joint[i] > of_joint[main] || (of_joint[i] == of_joint[main] && narrower)) main = i;
  }
  std::rotate(pairs.begin(), pairs.begin() + static_cast<std::ptrdiff_t>(main),
              pairs.begin() + static_cast<std::ptrdiff_t>(main) + 1);
  const double most = std::max(pairs.front().joint.width, reach);
  std::erase_if(pairs, [&](const PartPair& pair) { return pair.joint.width > most; });
  return pairs;
}

}  // namespace bentur
