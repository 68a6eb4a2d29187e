#include "bentur/model/gap/levels.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace bentur {
namespace {

constexpr double part_of_storey = 0.1;   // floors this close in height meet, unless a case says otherwise
constexpr double part_of_height = 1e-6;  // of the taller building: less is round-off

double height_of(const FloorLevels& building) {
  return building.elevations.empty() ? 0 : building.elevations.back() - building.base;
}

double level(const FloorLevels& building, int floor) { return building.elevations[static_cast<std::size_t>(floor)]; }

/// The lower one of two that are as near but for round-off.
int nearest_floor(const FloorLevels& building, double elevation, double round_off) {
  int nearest = 0;
  for (int floor = 1; floor < static_cast<int>(building.elevations.size()); ++floor) {
    const double nearer = std::abs(level(building, nearest) - elevation) - std::abs(level(building, floor) - elevation);
    if (nearer > round_off) nearest = floor;
  }
  return nearest;
}

}  // namespace

double round_off_of_levels(const FloorLevels& left, const FloorLevels& right) {
  return part_of_height * std::max(height_of(left), height_of(right));
}

double smallest_storey_at(const FloorLevels& building, int floor) {
  double below = level(building, floor) - (floor > 0 ? level(building, floor - 1) : building.base);
  if (!(below > 0)) below = std::numeric_limits<double>::infinity();  // of a wall, and of a slab on bearings
  const bool top = static_cast<std::size_t>(floor) + 1 == building.elevations.size();
  return top ? below : std::min(below, level(building, floor + 1) - level(building, floor));
}

std::vector<LevelPair> level_floors(const FloorLevels& left, const FloorLevels& right,
                                    std::optional<double> tolerance) {
  std::vector<LevelPair> pairs;
  if (left.elevations.empty() || right.elevations.empty()) return pairs;
  const double round_off = round_off_of_levels(left, right);
  for (int i = 0; i < static_cast<int>(left.elevations.size()); ++i) {
    const int j = nearest_floor(right, level(left, i), round_off);
    if (nearest_floor(left, level(right, j), round_off) != i) continue;
    const double apart = std::abs(level(left, i) - level(right, j));
    const double storey = std::min(smallest_storey_at(left, i), smallest_storey_at(right, j));
    if (apart > tolerance.value_or(part_of_storey * storey) + round_off) continue;
    pairs.push_back({i, j, apart <= round_off ? level(left, i) : 0.5 * (level(left, i) + level(right, j))});
  }
  return pairs;
}

std::vector<FacingFloor> facing_floors(const FloorLevels& left, const FloorLevels& right,
                                       std::optional<double> tolerance,
                                       const std::function<bool(int side, int floor)>& touches) {
  const double round_off = round_off_of_levels(left, right);
  const std::vector<LevelPair> pairs = level_floors(left, right, tolerance);
  std::vector<FacingFloor> all;
  for (const int side : {0, 1}) {
    const FloorLevels& own = side == 0 ? left : right;
    const FloorLevels& neighbour = side == 0 ? right : left;
    for (int floor = 0; floor < static_cast<int>(own.elevations.size()); ++floor) {
      if (touches(side, floor)) continue;
      const auto pair = std::find_if(pairs.begin(), pairs.end(), [&](const LevelPair& one) {
        return (side == 0 ? one.left_floor : one.right_floor) == floor;
      });
      const double elevation = level(own, floor);
      if (pair != pairs.end()) {
        if (side == 0) all.push_back({0, floor, pair->right_floor, pair->elevation});  // once
      } else if (elevation >= neighbour.base - round_off && elevation <= neighbour.elevations.back() + round_off) {
        all.push_back({side, floor, std::nullopt, elevation});
      }
    }
  }
  std::stable_sort(all.begin(), all.end(),
                   [](const FacingFloor& a, const FacingFloor& b) { return a.elevation < b.elevation; });
  return all;
}

const LevelPair* pair_at(double elevation, const std::vector<LevelPair>& pairs, const FloorLevels& left,
                         const FloorLevels& right) {
  const double round_off = round_off_of_levels(left, right);
  const auto names = [&](const LevelPair& pair) {
    const double a = level(left, pair.left_floor);
    const double b = level(right, pair.right_floor);
    return elevation >= std::min(a, b) - round_off && elevation <= std::max(a, b) + round_off;
  };
  const auto found = std::find_if(pairs.begin(), pairs.end(), names);
  return found == pairs.end() ? nullptr : &*found;
}

}  // namespace bentur
