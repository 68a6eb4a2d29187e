#pragma once

#include <optional>
#include <vector>

#include "bentur/structure/plan/plan.h"

// Who touches whom in plan (docs/theory/plan.md).
namespace bentur {

/// Where two footprints face one another: the part [from, to] that they have in common of the coordinate along the
/// joint, and the edges on both sides of it. L is the one with the lower coordinate across, R the other.
struct Stretch {
  bool swapped = false;                  ///< L is the second of the two
  int across = 0;                        ///< coordinate of the normal n, from L to R: 0 x, 1 y
  double from = 0, to = 0;               ///< [length]
  double left_edge = 0, right_edge = 0;  ///< their coordinates across [length]
  double width = 0;                      ///< w between them ≥ 0 [length]

  [[nodiscard]] PlanPoint normal() const { return PlanPoint::Unit(across); }
  /// t = e_z × n, along the joint.
  [[nodiscard]] PlanPoint tangent() const { return {across == 0 ? 0.0 : -1.0, across == 0 ? 1.0 : 0.0}; }
  /// On the left (0) or right (1) edge, at `along`.
  [[nodiscard]] PlanPoint on_edge(int side, double along) const;
  /// Between the two edges.
  [[nodiscard]] PlanPoint middle(double along) const { return 0.5 * (on_edge(0, along) + on_edge(1, along)); }
};

/// Whether two footprints have in common more than 10⁻⁹ of the largest side both ways.
[[nodiscard]] bool overlap(const Footprint& one, const Footprint& other);

/// The stretch along which they face each other; nothing where they do not, as corner to corner, or where they overlap.
[[nodiscard]] std::optional<Stretch> facing(const Footprint& one, const Footprint& other);

/// A contact point of a stretch, and its share of what acts on all of it.
struct StretchPoint {
  double along = 0;  ///< [length]
  double share = 0;  ///< σ [-] (P-7)
};

/// Evenly spaced, both ends among them. @param points ≥ 2
[[nodiscard]] std::vector<StretchPoint> points_of(const Stretch& stretch, int points);

}  // namespace bentur
