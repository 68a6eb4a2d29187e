#pragma once

#include <functional>
#include <optional>
#include <vector>

namespace bentur {

/// Where the floors of a building are.
struct FloorLevels {
  std::vector<double> elevations;  ///< [length] above the common datum, ascending
  double base = 0;                 ///< [length] likewise
};

/// Two floors of neighbours that are near enough in height to meet.
struct LevelPair {
  int left_floor = 0;
  int right_floor = 0;
  double elevation = 0;  ///< [length] the mean of both; the left one's where they differ by round-off alone
  /// In plan the side, 0 or 1, of which a floor of the other one strikes columns there: its floor is the one above.
  std::optional<int> struck = {};
};

/// Floors that differ by no more than this are at one level whatever the tolerance: a millionth of the taller
/// building's height [length].
[[nodiscard]] double round_off_of_levels(const FloorLevels& left, const FloorLevels& right);

/// The height of the storey below a floor [length], or of the one above where that is smaller or nothing is below;
/// infinite where nothing is.
[[nodiscard]] double smallest_storey_at(const FloorLevels& building, int floor);

/// The floors that meet, from the lowest up: pairs of which each is the other's nearest, and which differ by no more
/// than `tolerance` [length] and round_off_of_levels(), by default a tenth of the smallest storey height at those
/// floors.
[[nodiscard]] std::vector<LevelPair> level_floors(const FloorLevels& left, const FloorLevels& right,
                                                  std::optional<double> tolerance = std::nullopt);

/// A floor that faces its neighbour between that one's base and top and touches it nowhere.
struct FacingFloor {
  int side = 0;                    ///< 0 of the left building, 1 of the right one
  int floor = 0;                   ///< index of it
  std::optional<int> facing = {};  ///< of the other building's floor at its level; nothing: a column between two
  double elevation = 0;            ///< [length]
};

/// All of them, from the lowest up, those of the left building first where they are at one elevation. Two that meet are
/// one, of the left building. @param touches whether a floor of a side (0, 1) has contact there
[[nodiscard]] std::vector<FacingFloor> facing_floors(const FloorLevels& left, const FloorLevels& right,
                                                     std::optional<double> tolerance,
                                                     const std::function<bool(int side, int floor)>& touches);

/// The pair that an elevation names: it is at one of the floors or between them. Null where there is none.
[[nodiscard]] const LevelPair* pair_at(double elevation, const std::vector<LevelPair>& pairs, const FloorLevels& left,
                                       const FloorLevels& right);

}  // namespace bentur
