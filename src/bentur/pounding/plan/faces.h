#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "bentur/structure/plan/plan.h"

// Who touches whom in plan (docs/theory/plan.md).
namespace bentur {

/// A corner of one footprint before an edge of the other.
struct StretchCorner {
  double along = 0;                                               ///< on the stretch [length]
  PlanPoint left = PlanPoint::Zero(), right = PlanPoint::Zero();  ///< corner and foot, of L and of R [length]
  PlanPoint normal = PlanPoint::UnitX();                          ///< of the edge, from L to R
  /// How much further they are apart than the nearest ones of the stretch [length]; beside it also below zero.
  double beyond = 0;
  double room = 0;  ///< from the foot to the nearer end of the edge [length]

  /// With L and R exchanged.
  [[nodiscard]] StretchCorner turned() const {
    StretchCorner other = *this;
    std::swap(other.left, other.right);
    other.normal = -normal;
    return other;
  }
};

/// Where two footprints face one another: seen along n they have the part [from, to] in common, in which corners of
/// either stand before edges of the other. Of parallel edges these are the ends. Of footprints that stand corner to
/// corner it is one place, from = to.
struct Stretch {
  bool swapped = false;                     ///< L is the second of the two
  PlanPoint n = PlanPoint::UnitX();         ///< from L to R: of the edge, of either, that separates them the most
  int across = 0;                           ///< coordinate that n is nearest to: 0 x, 1 y
  double from = 0, to = 0;                  ///< along the axis [length]: of edges parallel to x or y a coordinate
  double width = 0;                         ///< w between them where they are nearest ≥ 0 [length]
  double shorter = 0;                       ///< what the shorter of the two takes up along the axis [length]
  std::vector<StretchCorner> corners = {};  ///< in the order of `along`: from, to and what is between

  /// Of the edge that a corner there is before, and t = e_z × n.
  [[nodiscard]] PlanPoint normal(double along) const { return at(along).normal; }
  [[nodiscard]] PlanPoint tangent(double along) const;
  /// w there ≥ 0 [length].
  [[nodiscard]] double width_at(double along) const { return width + at(along).beyond; }
  /// On the left (0) or right (1) edge, at `along`.
  [[nodiscard]] PlanPoint on_edge(int side, double along) const;
  /// Between the two edges.
  [[nodiscard]] PlanPoint middle(double along) const { return 0.5 * (on_edge(0, along) + on_edge(1, along)); }
  /// Between the corners on straight lines. @throws std::out_of_range where it has none
  [[nodiscard]] StretchCorner at(double along) const;
  /// Of those that are of it.
  [[nodiscard]] std::vector<double> corners_along() const;
  /// Whether a place is before an edge that faces along n, within 15°; what faces elsewhere is a joint of its own.
  [[nodiscard]] bool includes(const StretchCorner& place) const;
  /// The plan's coordinate of that middle which runs along the joint, x or y: `along` itself of edges parallel to one.
  [[nodiscard]] double coordinate(double along) const;
  /// Where along the stretch that coordinate is; nothing outside it.
  [[nodiscard]] std::optional<double> along_at(double coordinate) const;
  /// Whether they stand corner to corner.
  [[nodiscard]] bool is_corner() const { return corners.size() == 1; }
  /// Whether two edges that are parallel to one another face each other and nothing else does.
  [[nodiscard]] bool is_parallel() const;
  /// These are not parallel to x or y, or it is of others.
  [[nodiscard]] bool is_oblique() const;
};

/// Where along a stretch its left (0) or right (1) edge crosses a line; nothing where it does not.
[[nodiscard]] std::optional<double> crossing(const Stretch& stretch, int side, const PlanPoint& through,
                                             const PlanPoint& direction);

/// How deep two footprints are in one another: the least way that would part them [length]; below zero they are apart.
[[nodiscard]] double overlap_depth(const Footprint& one, const Footprint& other);

/// Whether two footprints have in common more than 10⁻⁹ of the largest side both ways.
[[nodiscard]] bool overlap(const Footprint& one, const Footprint& other);

/// `cut` without what it has in common with `kept`: of convex ones by the line across the way out that overlap_depth()
/// tells, where `kept` ends; else the largest of what is left. Nothing where no area is left. As it is where they do
/// not overlap.
[[nodiscard]] std::optional<Footprint> cut_back(const Footprint& cut, const Footprint& kept);

/// The stretch along which they face each other; nothing where they do not, as corner to corner, or where they overlap.
[[nodiscard]] std::optional<Stretch> facing(const Footprint& one, const Footprint& other);

/// The same, or where they stand corner to corner the place where those are; nothing where they overlap. Of outlines
/// that are not convex that of the parts (parts.h) that are nearest to one another.
[[nodiscard]] std::optional<Stretch> joint_between(const Footprint& one, const Footprint& other);

/// Where two footprints may touch by other edges than those of their joint, of which one family of places each has one
/// normal: what is w of the nearest place of a family is so of all of it.
struct FamilyBeside {
  std::vector<StretchCorner> places;  ///< one, or both ends of what parallel edges have in common
};

/// Of convex ones the families whose places come to zero where the two move by `reach` [length] towards one another, in
/// any direction, or part. @param left L of the joint, `right` R
[[nodiscard]] std::vector<FamilyBeside> families_beside(const Footprint& left, const Footprint& right,
                                                        const Stretch& joint, double reach);

/// A contact point of a stretch, and its share of what acts on all of it.
struct StretchPoint {
  double along = 0;  ///< [length]
  double share = 0;  ///< σ [-] (P-7)
  /// Of which family it is: 0 that of the joint, further ones beside it; −1: there is no other.
  Eigen::Index family = -1;
  std::optional<StretchCorner> beside = {};  ///< where it is, of those beside the joint
  /// Of which pair of convex parts, whose families are their own (parts.h): 0 that of the joint.
  Eigen::Index pair = 0;
  bool seam = false;  ///< bodies never touch there: it says alone whether its family is closed
};

/// Of a corner alone [-] (P-7).
inline constexpr double share_of_corner = 0.5;

/// Evenly spaced between two corners each, these among them; of shares (P-7). @param points ≥ 2
/// @param spread the length that belongs to one corner > 0 [length]; nothing: a quarter of the shorter of the two
[[nodiscard]] std::vector<StretchPoint> points_of(const Stretch& stretch, int points,
                                                  std::optional<double> spread = {});

/// The same, and after them those of the families beside the joint; what is not of the joint's family is left to these.
/// Of outlines that are not convex those of all pairs of parts that touch where the two move by `reach` [length].
[[nodiscard]] std::vector<StretchPoint> points_between(const Footprint& left, const Footprint& right,
                                                       const Stretch& joint, int points, double reach,
                                                       std::optional<double> spread = {});

}  // namespace bentur
