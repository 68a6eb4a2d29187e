#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

// What a building covers in plan (docs/theory/plan.md).
namespace bentur {

/// A place or a vector in plan: x to the right, y up the page.
using PlanPoint = Eigen::Vector2d;

/// A rectangle parallel to the axes, or a polygon, which may turn inwards, have courts and stand in several parts.
struct Footprint {
  /// The lower left one of a rectangle, in the common plan; of a polygon the place that its corners are counted from
  /// [length].
  PlanPoint corner = PlanPoint::Zero();
  PlanPoint size = PlanPoint::Zero();   ///< along x, along y [length] > 0; of a polygon what it takes up
  std::vector<PlanPoint> polygon = {};  ///< its corners, counter-clockwise, from `corner` [length]; empty: a rectangle
  /// Further rings of corners, from `corner`: of courts clockwise, of parts beside the polygon counter-clockwise.
  std::vector<std::vector<PlanPoint>> rings = {};

  /// Lower left and upper right corner of the rectangle around it, in the common plan [length].
  [[nodiscard]] PlanPoint lower() const;
  [[nodiscard]] PlanPoint far_corner() const { return lower() + size; }
  /// Counter-clockwise, from the lower left one of a rectangle, in the common plan [length]; without further rings.
  [[nodiscard]] std::vector<PlanPoint> corners() const;
  /// The same, and those of all further rings.
  [[nodiscard]] std::vector<std::vector<PlanPoint>> all_rings() const;
  [[nodiscard]] bool is_convex() const;
  /// [length²]
  [[nodiscard]] double area() const;
  /// Centre of its area, from `corner` [length].
  [[nodiscard]] PlanPoint middle() const;
  /// Square of the radius of gyration of its area about its middle [length²]: of a rectangle (a² + b²)/12 (P-2).
  [[nodiscard]] double radius2() const;
  /// Whether a place, from `corner`, is in the least convex polygon around it or on its edges, to within 1e-12 of the
  /// longer side where it is a polygon.
  [[nodiscard]] bool contains(const PlanPoint& at) const;
};

/// Of corners in their order, none or more; below zero where they go round clockwise [length²].
[[nodiscard]] double area_of(const std::vector<PlanPoint>& corners);

/// The rule that the corners of an outline break, in words; nothing where it goes round an area once, in either order,
/// convex or not.
[[nodiscard]] std::optional<std::string> fault_of_outline(const std::vector<PlanPoint>& corners);

/// The least convex polygon around corners that are not on one line: some of them, counter-clockwise.
[[nodiscard]] std::vector<PlanPoint> convex_hull(std::vector<PlanPoint> corners);

/// The rule that the corners of a polygon break, in words; nothing where it is convex, in either order. Corners on a
/// straight edge are none.
[[nodiscard]] std::optional<std::string> fault_of_polygon(const std::vector<PlanPoint>& corners);

/// Of corners that break no rule, from `corner`: counter-clockwise, without those on a straight edge.
/// @param courts rings of corners within it, in either order
[[nodiscard]] Footprint polygon_footprint(const PlanPoint& corner, std::vector<PlanPoint> corners,
                                          std::vector<std::vector<PlanPoint>> courts = {});

/// Whether a place is within a ring of corners, the first of which may stand at its end again: a ray from it crosses an
/// odd number of edges.
[[nodiscard]] bool goes_round(const std::vector<PlanPoint>& ring, const PlanPoint& at);

/// The rule that a court of an outline breaks, beside the others; nothing where it is a ring within it that meets no
/// other. @param ring of those of the footprint
[[nodiscard]] std::optional<std::string> fault_of_court(const Footprint& footprint, std::size_t ring);

}  // namespace bentur
