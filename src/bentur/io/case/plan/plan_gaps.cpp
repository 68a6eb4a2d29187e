#include <fmt/format.h>

#include <algorithm>
#include <functional>

#include "bentur/core/number_text.h"
#include "bentur/io/case/plan/plan_parts.h"
#include "bentur/io/schema/case_keys.h"
#include "bentur/io/schema/table_view.h"
#include "bentur/model/plan/struck_in_plan.h"
#include "bentur/pounding/plan/outline/common_area.h"
#include "bentur/pounding/plan/outline/near.h"

namespace bentur {
namespace {

/// [plan], as far as it could be read.
struct PlanDefaults {
  std::optional<TableView> view = {};
  std::optional<double> clearance = {};
  int points = 2;
  std::optional<ContactSpec> contact = {};
};

PlanDefaults read_defaults(const TomlView& root) {
  PlanDefaults defaults;
  const auto given = root.find("plan");
  if (given) defaults.view = TableView::of(*given, plan_keys());
  if (!defaults.view) return defaults;
  defaults.clearance = defaults.view->number("clearance");
  defaults.points = static_cast<int>(defaults.view->whole("points").value_or(2));
  if (!defaults.view->has("contact")) return defaults;
  // As of one level: what differs from level to level is a gap's own.
  ReadBuilding none;
  none.path = "a building in plan";
  none.spec.structure = Plan();
  const TomlView contact = *defaults.view->find("contact");
  bool lists = false;
  for (const TomlMember& member : contact.value().members) {
    if (member.value.kind != TomlValue::Kind::list) continue;
    contact.find(member.key)->error_value("must be one for all pairs: a [[gap]] has lists, over its levels");
    lists = true;
  }
  if (lists) return defaults;
  const std::vector<double> one_level = {0.0};
  defaults.contact = read_contact(*defaults.view, {none, none, one_level}, Need::required);
  return defaults;
}

std::string names_of(const std::vector<ReadBuilding>& buildings, std::size_t one, std::size_t other) {
  return fmt::format("{} and {}", in_quotes(buildings[one].spec.name), in_quotes(buildings[other].spec.name));
}

using PairsOfBuildings = std::vector<std::pair<std::size_t, std::size_t>>;

/// As pairs_near() has them, of buildings whose footprints are known.
PairsOfBuildings pairs_within(const std::vector<ReadBuilding>& buildings, double reach) {
  std::vector<std::size_t> known;
  std::vector<Footprint> footprints;
  for (std::size_t b = 0; b < buildings.size(); ++b) {
    if (!buildings[b].is_whole) continue;
    known.push_back(b);
    footprints.push_back(buildings[b].spec.footprint());
  }
  PairsOfBuildings pairs = pairs_near(footprints, reach);
  for (auto& [one, other] : pairs) {
    one = known[one];
    other = known[other];
  }
  return pairs;
}

/// Footprints that overlap, at the second of the two.
bool overlaps_are_said(const TomlView& root, const std::vector<ReadBuilding>& buildings) {
  bool any = false;
  PairsOfBuildings pairs = pairs_within(buildings, 0);
  std::sort(pairs.begin(), pairs.end(),
            [](const auto& a, const auto& b) { return std::pair(a.second, a.first) < std::pair(b.second, b.first); });
  for (const auto& [a, b] : pairs) {
    const Footprint &one = buildings[a].spec.footprint(), &other = buildings[b].spec.footprint();
    if (!overlap(one, other)) continue;
    any = true;
    if (!one.polygon.empty() || !other.polygon.empty()) {
      view_of(root, buildings, b)
          .error(fmt::format("overlaps {}: their footprints have {:.6g} of area in common, {:.6g} deep",
                             in_quotes(buildings[a].spec.name), common_area(one, other), overlap_depth(one, other)));
      continue;
    }
    const PlanPoint low = one.corner.cwiseMax(other.corner);
    const PlanPoint common = one.far_corner().cwiseMin(other.far_corner()) - low;
    view_of(root, buildings, b)
        .error(fmt::format("overlaps {}: their footprints have {:.6g} by {:.6g} at ({:.6g}, {:.6g}) in common",
                           in_quotes(buildings[a].spec.name), common.x(), common.y(), low.x(), low.y()));
  }
  return any;
}

template <class Index>
std::pair<Index, Index> in_order(Index one, Index other) {
  return std::minmax(one, other);
}

/// The pair of two buildings along their stretch.
GapSpec pair_of(const Stretch& stretch, std::size_t one, std::size_t other) {
  const auto [left, right] = stretch.swapped ? std::pair(other, one) : std::pair(one, other);
  GapSpec gap;
  gap.left = static_cast<Eigen::Index>(left);
  gap.right = static_cast<Eigen::Index>(right);
  gap.stretch = stretch;
  return gap;
}

/// Every law of a pair is made once; errors go to where its contact stands.
void check_laws(const TomlView& contact, const GapSpec& gap, const std::vector<ReadBuilding>& buildings) {
  const BuildingSpec &left = buildings[gap.left].spec, &right = buildings[gap.right].spec;
  for (std::size_t level = 0; level < gap.levels.size(); ++level) {
    GapSpec one = gap;  // of this level alone, with its entry of every list
    one.levels = {gap.levels[level]};
    if (const auto& struck = one.levels.front().struck) {
      const bool is_known =
          !struck_columns(*struck == 0 ? left : right, gap.stretch, *struck, one.levels.front().elevation).empty();
      if (!is_known) continue;  // what is wrong has been said
      if (auto& capacity = one.column_capacity) {
        for (auto* const list : {&capacity->shear, &capacity->moment}) {
          if (list->size() > 1) *list = {list->at(level)};
        }
      }
    }
    for (auto& [key, list] : one.contact.numbers) list = {list.size() == 1 ? list.front() : list.at(level)};
    try {
      (void)gap_with_contacts(one, left, right);
    } catch (const InvalidParameter& fault) {
      if (say_of_law(contact, fault, level)) return;
    }
  }
}

class Pairs {
 public:
  Pairs(const TomlView& root, const std::vector<ReadBuilding>& buildings)
      : defaults_(read_defaults(root)), buildings_(buildings) {}

  void read_named(const TomlView& entry);
  void add_near(const TomlView& root);
  std::vector<GapSpec> take();

 private:
  [[nodiscard]] bool is_named(std::size_t one, std::size_t other) const {
    return std::find(named_.begin(), named_.end(), in_order(one, other)) != named_.end();
  }
  [[nodiscard]] std::vector<LevelPair> levels_of(const GapSpec& gap, std::optional<double> tolerance) const {
    return level_floors(floor_levels(buildings_[gap.left]), floor_levels(buildings_[gap.right]), tolerance);
  }
  /// What a pair without a contact of its own has; an error at `at` where there is none.
  void take_default_contact(const TomlView& at, GapSpec& gap);
  /// The levels at which both touch, none where no contact is modelled. @return whether they are right
  bool read_levels(const TableView& table, GapSpec& gap);
  /// One point per end alone where impacts take no time.
  void check_points(const TomlView& at, const GapSpec& gap);

  PlanDefaults defaults_;
  const std::vector<ReadBuilding>& buildings_;
  std::vector<std::pair<std::size_t, std::size_t>> named_;  ///< each the lower index first
  std::vector<GapSpec> gaps_;
};

void Pairs::take_default_contact(const TomlView& at, GapSpec& gap) {
  if (defaults_.contact) {
    gap.contact = *defaults_.contact;
    check_laws(*defaults_.view->find("contact"), gap, buildings_);
  } else if (!defaults_.view || !defaults_.view->has("contact")) {
    at.error(fmt::format("needs a contact for {}: give plan.contact, or a [[gap]] between them",
                         names_of(buildings_, gap.left, gap.right)));
  }
}

void Pairs::check_points(const TomlView& at, const GapSpec& gap) {
  if (gap.contact.law == "restitution" && gap.points != 2) {
    const auto points = at.find("points");
    (points ? *points : at).error(fmt::format("must be 2 with law = \"restitution\", not {}", gap.points));
  }
}

bool Pairs::read_levels(const TableView& table, GapSpec& gap) {
  const std::optional<double> tolerance = table.number("level_tolerance");
  gap.level_tolerance = tolerance;
  gap.levels = levels_of(gap, tolerance);
  const auto given = table.find("elevations");
  read_strikes_columns(table, gap);
  if (gap.strikes_columns && !given) return false;
  if (given && models_no_contact(*given)) {
    gap.levels.clear();
    if (gap.stretch.is_corner()) {
      given->error("must not be empty: where buildings stand corner to corner nothing is watched");
      return false;
    }
    return checked_to_face(table, buildings_[gap.left], buildings_[gap.right]);
  }
  const ReadBuilding &left = buildings_[gap.left], &right = buildings_[gap.right];
  if (gap.levels.empty() && !gap.strikes_columns) {
    table.error(fmt::format(
        "has no elevation at which both buildings have a floor: {} has floors at {}, {} at {}; let "
        "floors that nearly meet do so with level_tolerance, let floors strike columns of frames with "
        "strikes_columns = true, or model no contact with elevations = []: "
        "floors are then watched against the edges they face, for the gap they need",
        in_quotes(left.spec.name), written(left.elevations), in_quotes(right.spec.name), written(right.elevations)));
    return false;
  }
  if (!given) return true;
  const std::vector<double> wanted = given->as_numbers(table.key("elevations").range);
  if (wanted.empty()) return false;
  if (std::adjacent_find(wanted.begin(), wanted.end(), std::greater_equal<>()) != wanted.end()) {
    given->error("must ascend");
    return false;
  }
  if (gap.strikes_columns) {
    std::vector<LevelPair> all;
    for (std::size_t i = 0; i < wanted.size(); ++i) {
      if (auto level = read_struck_level(given->item(i), wanted[i], gap, left, right)) all.push_back(*level);
    }
    gap.levels = all.size() == wanted.size() ? std::move(all) : std::vector<LevelPair>();
    return !gap.levels.empty();
  }
  const std::vector<double> named =
      named_elevations(*given, wanted, gap.levels, floor_levels(left), floor_levels(right));
  std::vector<LevelPair> chosen;
  for (const double elevation : named) {
    LevelPair level = *pair_at(elevation, gap.levels, floor_levels(left), floor_levels(right));
    level.elevation = elevation;
    chosen.push_back(level);
  }
  gap.levels = std::move(chosen);
  return !gap.levels.empty();
}

void Pairs::read_named(const TomlView& entry) {
  const auto made = TableView::of(entry, gap_keys());
  if (!made) return;
  const TableView& table = *made;
  table.refuse({"width"}, "is not for buildings in plan: their footprints say how far they are apart");
  const auto between = read_between(table, buildings_, "two buildings");
  const std::optional<std::int64_t> points = table.whole("points");
  if (!between) return;
  const auto [one, other] = *between;
  if (one == other) {
    table.find("between")->error("must be two buildings");
    return;
  }
  if (is_named(one, other)) {
    table.find("between")->error(
        fmt::format("another [[gap]] is between {} already", names_of(buildings_, one, other)));
    return;
  }
  named_.push_back(in_order(one, other));
  if (!buildings_[one].is_whole || !buildings_[other].is_whole) return;
  if (buildings_[one].spec.is_rigid() && buildings_[other].spec.is_rigid()) {
    table.find("between")->error(fmt::format("is between two walls, {}", names_of(buildings_, one, other)));
    return;
  }
  const auto stretch = joint_between(buildings_[one].spec.footprint(), buildings_[other].spec.footprint());
  if (!stretch) return;  // they overlap, which is said
  GapSpec gap = pair_of(*stretch, one, other);
  gap.points = static_cast<int>(points.value_or(defaults_.points));
  if (!read_levels(table, gap)) return;
  std::vector<double> elevations;
  for (const LevelPair& level : gap.levels) elevations.push_back(level.elevation);
  const GapSides sides{buildings_[gap.left], buildings_[gap.right], elevations};
  read_column_capacity(table, sides, gap);
  if (!table.has("contact")) {
    if (!gap.levels.empty()) take_default_contact(table, gap);
  } else {
    const auto contact = read_contact(table, sides, Need::required);
    if (contact) {
      gap.contact = *contact;
      check_laws(*table.find("contact"), gap, buildings_);
    }
  }
  if (!gap.levels.empty()) check_points(table, gap);
  gaps_.push_back(std::move(gap));
}

void Pairs::add_near(const TomlView& root) {
  if (!defaults_.clearance) {
    if (gaps_.empty() && named_.empty()) {
      root.error_missing("gap", "without plan.clearance it says which buildings may touch");
    }
    return;
  }
  const TomlView clearance = *defaults_.view->find("clearance");
  bool brings_some = false;  // though no gap between them can be made
  for (const auto& [a, b] : pairs_within(buildings_, *defaults_.clearance)) {
    if (is_named(a, b)) continue;
    if (buildings_[a].spec.is_rigid() && buildings_[b].spec.is_rigid()) continue;
    const auto stretch = joint_between(buildings_[a].spec.footprint(), buildings_[b].spec.footprint());
    if (!stretch || stretch->width > *defaults_.clearance) continue;
    GapSpec gap = pair_of(*stretch, a, b);
    gap.points = defaults_.points;
    gap.levels = levels_of(gap, std::nullopt);
    if (gap.levels.empty() && stretch->is_corner()) continue;
    brings_some = true;
    if (gap.levels.empty()) {
      clearance.error(
          fmt::format("brings together {}, which have no floors at one elevation: give a [[gap]] between "
                      "them with level_tolerance, or with elevations = [] where no contact is modelled",
                      names_of(buildings_, a, b)));
      continue;
    }
    take_default_contact(*defaults_.view, gap);
    check_points(*defaults_.view, gap);
    gaps_.push_back(std::move(gap));
  }
  const bool all_known =
      std::all_of(buildings_.begin(), buildings_.end(), [](const auto& one) { return one.is_whole; });
  if (all_known && !brings_some && gaps_.empty() && named_.empty()) {
    clearance.error_value("brings no two buildings together: make it larger, or give a [[gap]] between two");
  }
}

std::vector<GapSpec> Pairs::take() {
  std::sort(gaps_.begin(), gaps_.end(),
            [](const GapSpec& a, const GapSpec& b) { return in_order(a.left, a.right) < in_order(b.left, b.right); });
  return std::move(gaps_);
}

}  // namespace

std::vector<GapSpec> read_plan_gaps(const TomlView& root, const std::vector<ReadBuilding>& buildings) {
  Pairs pairs(root, buildings);
  const bool overlapping = overlaps_are_said(root, buildings);
  if (root.has("gap")) {
    if (const auto list = root.tables("gap", "")) {
      for (const TomlView& entry : list->items()) pairs.read_named(entry);
    }
  }
  if (!overlapping) pairs.add_near(root);
  return pairs.take();
}

}  // namespace bentur
