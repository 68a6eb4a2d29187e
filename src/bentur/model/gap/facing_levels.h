#pragma once

#include <optional>
#include <vector>

#include "bentur/pounding/problem.h"

namespace bentur {

/// A level at which two neighbours face one another: a contact point or a watched floor of a problem.
struct FacingLevel {
  Eigen::Index gap = 0;    ///< its number
  bool is_point = true;    ///< a contact point; else a watched floor
  Eigen::Index index = 0;  ///< into Problem::points or Problem::watched
  double elevation = 0;    ///< [length]
  double width = 0;        ///< given [length]
  double beyond = 0;       ///< of that, what edges that are not parallel add here [length] ≥ 0
  double opens = 1;        ///< how much it grows where the gap widens by 1 [-]
  bool beside = false;     ///< in plan: of other parts than the gap's joint is

  /// The width of the whole gap with which this place has so much [length]; beside a joint in plan the given one and
  /// what is more here.
  [[nodiscard]] double of_gap(double here) const { return here - beyond; }
  /// To what width the whole gap must be brought so that this place has so much [length]: infinite where it does not
  /// open with the gap and has less.
  [[nodiscard]] double to_have(double here) const;
};

/// The levels of one gap, from the lowest up. @throws InvalidParameter unless there are so many gaps.
[[nodiscard]] std::vector<FacingLevel> facing_levels(const Problem& problem, Eigen::Index gap);
/// Those of all gaps, left to right.
[[nodiscard]] std::vector<FacingLevel> facing_levels(const Problem& problem);

/// Index of the floor that the left (0) or right (1) face is; nothing of a column's.
[[nodiscard]] std::optional<Eigen::Index> face_floor(const Problem& problem, const FacingLevel& level, int side);

/// Height of the left (0) or right (1) face above its building's base [length]: of a floor its own, of a column that of
/// the level.
[[nodiscard]] double face_height(const Problem& problem, const FacingLevel& level, int side);

}  // namespace bentur
