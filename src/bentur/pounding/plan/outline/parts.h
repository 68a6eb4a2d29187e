#pragma once

#include <array>
#include <vector>

#include "bentur/pounding/plan/faces.h"

// Outlines that turn inwards, have courts or stand in several parts, as convex ones (docs/theory/plan.md).
namespace bentur {

/// A convex part of an outline. Its edges are whole edges of the outline, or lie within it or along others. Parts lie
/// over one another; every edge of the outline is one part's own, as a whole.
struct OutlinePart {
  /// An edge of the outline that meets another one in a corner.
  struct Side {
    PlanPoint normal = PlanPoint::Zero();  ///< outwards; zero where the corner is none of the outline
    bool own = false;
  };
  Footprint footprint;                          ///< a polygon, its corners in the common plan
  std::vector<char> own = {};                   ///< the edge behind each corner is this part's own
  std::vector<std::array<Side, 2>> sides = {};  ///< of each corner those that end and begin there
};

/// Of an outline that breaks no rule; one that is convex is one part, whose own all its edges are.
[[nodiscard]] std::vector<OutlinePart> parts_of(const Footprint& outline);

/// Two parts of two outlines that may touch. What they touch by, of all places of such pairs, is of one of them alone.
struct PartPair {
  OutlinePart left, right;  ///< of the first and of the second outline
  Stretch joint;            ///< of `left` and `right`, in this order

  /// L and R of their joint.
  [[nodiscard]] const Footprint& of_l() const { return (joint.swapped ? right : left).footprint; }
  [[nodiscard]] const Footprint& of_r() const { return (joint.swapped ? left : right).footprint; }
};

/// The pairs of which a place is of the outlines and that are within `reach` [length] of one another, or as near as any
/// are; first the one whose joint is that of the outlines: the narrowest, and of those the longest. None where they
/// overlap.
[[nodiscard]] std::vector<PartPair> pairs_of_parts(const Footprint& left, const Footprint& right, double reach);

/// Whether bodies touch at a place of the joint of a pair or beside it: not where it is of a seam, or another pair's.
[[nodiscard]] bool is_of_outlines(const PartPair& pair, const StretchCorner& place);

}  // namespace bentur
