#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bentur/io/case/case_parts.h"

namespace bentur {
namespace {

constexpr double least_part = 0.01;  // of a storey height, between a node and a floor

/// Whether a building has a floor at an elevation, to within a part of its height.
bool has_floor(const FloorLevels& levels, double elevation) {
  constexpr double round_off = 1e-6;
  const double height = levels.elevations.back() - levels.base;
  return std::any_of(levels.elevations.begin(), levels.elevations.end(),
                     [&](double floor) { return std::abs(floor - elevation) <= round_off * height; });
}

/// The storey that an elevation is in: its foot and its top; nothing outside the building.
struct Storey {
  double below = 0, above = 0;
  [[nodiscard]] bool has_node_at(double elevation) const {
    return std::min(elevation - below, above - elevation) > least_part * (above - below);
  }
};

std::optional<Storey> storey_at(const FloorLevels& levels, double elevation) {
  const auto above = std::upper_bound(levels.elevations.begin(), levels.elevations.end(), elevation);
  if (elevation <= levels.base || above == levels.elevations.end()) return std::nullopt;
  return Storey{above == levels.elevations.begin() ? levels.base : *std::prev(above), *above};
}

/// Puts a node into the column of `struck` that faces the gap; false (and an error) where there can be none.
bool put_node(const TomlView& at, double elevation, bool left_of_gap, ReadBuilding& struck) {
  auto* frame = std::get_if<PlaneFrame>(&struck.spec.structure);
  if (frame == nullptr) {
    at.error_value(
        fmt::format("is between floors of {}, whose columns only a frame has: give it as one, or leave this "
                    "elevation out",
                    struck.path));
    return false;
  }
  const FloorLevels levels = floor_levels(struck);
  const std::optional<Storey> storey = storey_at(levels, elevation);
  if (!storey) {
    at.error_value(fmt::format("is beside no column of {}, which reaches from {} to {}", struck.path, levels.base,
                               levels.elevations.back()));
    return false;
  }
  if (!storey->has_node_at(elevation)) {
    at.error_value(
        fmt::format("is less than 1 % of the storey height from a floor of {}: there the floor itself is "
                    "struck, let the floors meet with level_tolerance",
                    struck.path));
    return false;
  }
  const double height = elevation - struck.spec.base_elevation;
  const bool there = std::any_of(frame->nodes.begin(), frame->nodes.end(), [&](const ColumnNode& node) {
    return node.left != left_of_gap && node.elevation == height;
  });
  if (there) return true;  // buildings that were read before
  frame->nodes.push_back({.left = !left_of_gap, .elevation = height});
  struck.modes = 0;
  make(struck);
  return true;
}

}  // namespace

std::vector<double> columns_in_reach(const ReadBuilding& struck, const ReadBuilding& striking) {
  std::vector<double> elevations;
  if (!std::holds_alternative<PlaneFrame>(struck.spec.structure) || struck.elevations.empty()) return elevations;
  const FloorLevels levels = floor_levels(struck);
  for (const double elevation : striking.elevations) {
    const std::optional<Storey> storey = storey_at(levels, elevation);
    if (storey && storey->has_node_at(elevation)) elevations.push_back(elevation);
  }
  return elevations;
}

std::vector<double> read_struck_columns(const TomlView& list, const std::vector<double>& wanted,
                                        const std::vector<LevelPair>& pairs, ReadBuilding& left, ReadBuilding& right) {
  const FloorLevels a = floor_levels(left);
  const FloorLevels b = floor_levels(right);
  std::vector<double> named;
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    if (const LevelPair* const pair = pair_at(wanted[i], pairs, a, b)) {
      named.push_back(pair->elevation);
      continue;
    }
    const bool of_left = has_floor(a, wanted[i]);
    if (!of_left && !has_floor(b, wanted[i])) {
      list.item(i).error_value("neither building has a floor there");
      continue;
    }
    if (put_node(list.item(i), wanted[i], !of_left, of_left ? right : left)) named.push_back(wanted[i]);
  }
  return named.size() == wanted.size() ? named : std::vector<double>{};
}

}  // namespace bentur
