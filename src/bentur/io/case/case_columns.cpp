#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bentur/core/number_text.h"
#include "bentur/io/case/case_parts.h"
#include "bentur/io/case/plan/plan_parts.h"
#include "bentur/io/schema/table_view.h"

namespace bentur {
namespace {

constexpr double least_part = 0.01;  // of a storey height, between a node and a floor

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

/// Why no column of `struck` can be struck at an elevation [length]; nothing where one can.
std::optional<std::string> refusal(const ReadBuilding& struck, double elevation) {
  if (column_nodes(struck.spec) == nullptr) {
    return fmt::format(
        "is between floors of {}, whose columns are not known: give columns of its stick or generic, or it as a frame, "
        "or leave this elevation out, where the gap that is needed is told all the same",
        struck.path);
  }
  return no_column_at(struck, elevation);
}

/// Puts nodes into the columns that face a gap, where floors of the other building strike them.
void put_nodes(const TomlView& gap, ReadBuilding& left, ReadBuilding& right) {
  const std::vector<double> elevations = elevations_to_strike(gap);
  const FloorLevels a = floor_levels(left), b = floor_levels(right);
  if (elevations.empty() || a.elevations.empty() || b.elevations.empty()) return;
  const std::vector<LevelPair> pairs = level_floors(a, b, number_in(gap.find("level_tolerance")));
  for (const double elevation : elevations) {
    const std::optional<Strike> strike = strike_at(a, b, elevation);
    if (pair_at(elevation, pairs, a, b) != nullptr || !strike) continue;
    ReadBuilding& struck = strike->struck == 0 ? left : right;
    if (refusal(struck, elevation)) continue;
    column_nodes(struck.spec)
        ->push_back({.left = strike->struck == 1, .elevation = elevation - struck.spec.base_elevation});
    struck.modes = 0;
    struck.made = nullptr;
  }
}

}  // namespace

std::optional<double> number_in(const std::optional<TomlView>& view) {
  if (view && view->is(TomlValue::Kind::integer)) return static_cast<double>(view->value().integer);
  if (view && view->is(TomlValue::Kind::real)) return view->value().real;
  return std::nullopt;
}

std::optional<Strike> strike_at(const FloorLevels& left, const FloorLevels& right, double elevation) {
  constexpr double round_off = 1e-6;
  for (const int side : {0, 1}) {
    const FloorLevels& levels = side == 0 ? left : right;
    const double height = levels.elevations.back() - levels.base;
    const auto floor = std::find_if(levels.elevations.begin(), levels.elevations.end(),
                                    [&](double one) { return std::abs(one - elevation) <= round_off * height; });
    if (floor == levels.elevations.end()) continue;
    return Strike{.struck = 1 - side, .floor = static_cast<int>(floor - levels.elevations.begin())};
  }
  return std::nullopt;
}

std::optional<std::string> no_column_at(const ReadBuilding& struck, double elevation) {
  const FloorLevels levels = floor_levels(struck);
  const std::optional<Storey> storey = storey_at(levels, elevation);
  if (!storey) {
    return fmt::format("is beside no column of {}, which reaches from {} to {}", struck.path, written(levels.base),
                       written(levels.elevations.back()));
  }
  if (storey->has_node_at(elevation)) return std::nullopt;
  return fmt::format(
      "is less than 1 % of the storey height from a floor of {}: there the floor itself is struck, let the floors meet "
      "with level_tolerance",
      struck.path);
}

std::vector<double> elevations_to_strike(const TomlView& gap) {
  std::vector<double> elevations;
  if (!gap.is(TomlValue::Kind::table)) return elevations;
  const auto strikes = gap.find("strikes_columns"), list = gap.find("elevations");
  if (!strikes || !strikes->value().boolean || !list || !list->is(TomlValue::Kind::list)) return elevations;
  for (const TomlView& item : list->items()) {
    if (const auto elevation = number_in(item)) elevations.push_back(*elevation);
  }
  return elevations;
}

void read_storey_columns(const TableView& view, std::size_t storeys, BuildingSpec& spec) {
  const auto table = view.table("columns");
  if (!table) return;
  StoreyColumns columns;
  columns.elastic_modulus = table->number("elastic_modulus").value_or(1);
  columns.inertia = table->numbers_for_each("inertia", storeys);
  columns.mass = table->numbers_for_each("mass", storeys);
  columns.number = static_cast<int>(table->whole("number").value_or(1));
  spec.columns = std::move(columns);
}

std::vector<double> columns_in_reach(const ReadBuilding& struck, const ReadBuilding& striking) {
  std::vector<double> elevations;
  if (column_nodes(struck.spec) == nullptr || struck.elevations.empty()) return elevations;
  const FloorLevels levels = floor_levels(struck);
  for (const double elevation : striking.elevations) {
    const std::optional<Storey> storey = storey_at(levels, elevation);
    if (storey && storey->has_node_at(elevation)) elevations.push_back(elevation);
  }
  return elevations;
}

std::vector<ReadBuilding> with_struck_columns(const TomlView& root, std::vector<ReadBuilding> buildings) {
  const auto gaps = root.find("gap");
  if (!gaps || !gaps->is(TomlValue::Kind::list)) return buildings;
  for (std::size_t i = 0; i < gaps->size() && i + 1 < buildings.size(); ++i) {
    put_nodes(gaps->item(i), buildings[i], buildings[i + 1]);
  }
  for (ReadBuilding& building : buildings) {
    if (has_column_nodes(building.spec)) make(building);
  }
  return buildings;
}

std::vector<double> read_struck_columns(const TomlView& list, const std::vector<double>& wanted,
                                        const std::vector<LevelPair>& pairs, const ReadBuilding& left,
                                        const ReadBuilding& right) {
  const FloorLevels a = floor_levels(left);
  const FloorLevels b = floor_levels(right);
  std::vector<double> named;
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    const LevelPair* const pair = pair_at(wanted[i], pairs, a, b);
    const std::optional<Strike> strike = strike_at(a, b, wanted[i]);
    if (pair == nullptr && !strike) {
      list.item(i).error_value("neither building has a floor there");
    } else if (const auto why = pair ? std::nullopt : refusal(strike->struck == 0 ? left : right, wanted[i])) {
      list.item(i).error_value(*why);
    } else {
      named.push_back(pair ? pair->elevation : wanted[i]);
    }
  }
  return named.size() == wanted.size() ? named : std::vector<double>{};
}

}  // namespace bentur
