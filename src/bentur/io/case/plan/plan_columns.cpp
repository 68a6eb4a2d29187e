#include <fmt/format.h>

#include <algorithm>

#include "bentur/io/case/plan/plan_parts.h"
#include "bentur/io/schema/table_view.h"
#include "bentur/model/plan/struck_in_plan.h"

namespace bentur {
namespace {

/// The building that a name in `between` is of; nothing where none has it.
std::optional<std::size_t> building_of(const TomlView& name, const std::vector<ReadBuilding>& buildings) {
  for (std::size_t b = 0; b < buildings.size(); ++b) {
    if (name.is(TomlValue::Kind::text) && buildings[b].spec.name == name.value().text) return b;
  }
  return std::nullopt;
}

/// Whether the columns of all of these frames have mass in a storey.
bool have_mass(const ReadBuilding& struck, const std::vector<FrameAcross>& frames, std::size_t storey) {
  const Plan& plan = std::get<Plan>(struck.spec.structure);
  return std::all_of(frames.begin(), frames.end(), [&](const FrameAcross& one) {
    return plan.planes[one.plane].frame->columns.at(storey).mass_of(plan.storey_heights[storey]) > 0;
  });
}

/// The storey of its frames that an elevation between floors is in.
std::size_t storey_of(const ReadBuilding& struck, double elevation) {
  const Plan& plan = std::get<Plan>(struck.spec.structure);
  const auto above = std::upper_bound(struck.elevations.begin(), struck.elevations.end(), elevation);
  return static_cast<std::size_t>(above - struck.elevations.begin()) - (plan.isolation ? 1 : 0);
}

/// Why no column of `struck` can be struck at an elevation; nothing where one can.
std::optional<std::string> refusal(const ReadBuilding& struck, const Stretch& stretch, int side, double elevation) {
  const std::vector<FrameAcross> frames = frames_across(struck.spec, stretch, side);
  if (frames.empty()) {
    return fmt::format(
        "is between floors of {}, which has no frame across the joint there, whose columns could be struck: give it a "
        "[[building.plane]] with a frame, or leave this elevation out, where the gap that is needed is reported all "
        "the same",
        struck.path);
  }
  if (auto why = no_column_at(struck, elevation)) return why;
  if (have_mass(struck, frames, storey_of(struck, elevation))) return std::nullopt;
  return fmt::format(
      "is between floors of {}, whose columns have no mass there: a column that is struck needs one, give its section "
      "a density",
      struck.path);
}

void put_nodes(const TomlView& gap, const std::vector<ReadBuilding>& buildings, StruckNodes& nodes) {
  const std::vector<double> elevations = elevations_to_strike(gap);
  const auto between = elevations.empty() ? std::nullopt : gap.find("between");
  if (!between || !between->is(TomlValue::Kind::list) || between->size() != 2) return;
  const auto one = building_of(between->item(0), buildings), other = building_of(between->item(1), buildings);
  if (!one || !other || *one == *other || !buildings[*one].is_whole || !buildings[*other].is_whole) return;
  const auto stretch = joint_between(buildings[*one].spec.footprint(), buildings[*other].spec.footprint());
  if (!stretch) return;
  const std::size_t sides[] = {stretch->swapped ? *other : *one, stretch->swapped ? *one : *other};
  const FloorLevels levels[] = {floor_levels(buildings[sides[0]]), floor_levels(buildings[sides[1]])};
  const std::vector<LevelPair> pairs = level_floors(levels[0], levels[1], number_in(gap.find("level_tolerance")));
  for (const double elevation : elevations) {
    if (pair_at(elevation, pairs, levels[0], levels[1]) != nullptr) continue;
    const std::optional<Strike> strike = strike_at(levels[0], levels[1], elevation);
    if (!strike) continue;
    const std::size_t at = sides[strike->struck];
    const ReadBuilding& struck = buildings[at];
    if (refusal(struck, *stretch, strike->struck, elevation)) continue;
    for (const FrameAcross& frame : frames_across(struck.spec, *stretch, strike->struck)) {
      const ColumnNode node{.left = frame.left, .elevation = elevation - struck.spec.base_elevation};
      std::vector<ColumnNode>& all = nodes[{at, frame.plane}];
      const auto same = [&](const ColumnNode& other_node) {
        return other_node.left == node.left && other_node.elevation == node.elevation;
      };
      if (std::none_of(all.begin(), all.end(), same)) all.push_back(node);
    }
  }
}

}  // namespace

StruckNodes struck_nodes(const TomlView& root, const std::vector<ReadBuilding>& buildings) {
  StruckNodes nodes;
  const auto gaps = root.find("gap");
  if (!gaps || !gaps->is(TomlValue::Kind::list)) return nodes;
  for (const TomlView& gap : gaps->items()) put_nodes(gap, buildings, nodes);
  return nodes;
}

std::optional<LevelPair> read_struck_level(const TomlView& elevation, double wanted, const GapSpec& gap,
                                           const ReadBuilding& left, const ReadBuilding& right) {
  const FloorLevels a = floor_levels(left), b = floor_levels(right);
  if (const LevelPair* const pair = pair_at(wanted, level_floors(a, b, gap.level_tolerance), a, b)) return *pair;
  const std::optional<Strike> strike = strike_at(a, b, wanted);
  if (!strike) {
    elevation.error_value("neither building has a floor there");
    return std::nullopt;
  }
  const bool of_left = strike->struck == 0;
  if (const auto why = refusal(of_left ? left : right, gap.stretch, strike->struck, wanted)) {
    elevation.error_value(*why);
    return std::nullopt;
  }
  const std::vector<double>& floors = (of_left ? a : b).elevations;  // of the struck one the floor above
  const auto above = static_cast<int>(std::lower_bound(floors.begin(), floors.end(), wanted) - floors.begin());
  return LevelPair{.left_floor = of_left ? above : strike->floor,
                   .right_floor = of_left ? strike->floor : above,
                   .elevation = wanted,
                   .struck = strike->struck};
}

}  // namespace bentur
