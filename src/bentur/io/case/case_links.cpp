#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <tuple>

#include "bentur/core/errors.h"
#include "bentur/core/number_text.h"
#include "bentur/io/case/case_parts.h"
#include "bentur/io/case/plan/plan_parts.h"
#include "bentur/io/schema/case_keys.h"
#include "bentur/io/schema/table_view.h"

namespace bentur {
namespace {

/// The places of the buildings, if they are two in the order of the row.
std::optional<std::pair<std::size_t, std::size_t>> read_sides(const TableView& link,
                                                              const std::vector<ReadBuilding>& buildings) {
  const auto sides = read_between(link, buildings, "the left and the right building");
  if (!sides) return std::nullopt;
  const auto name = [&](std::size_t b) { return in_quotes(buildings[b].spec.name); };
  const TomlView between = *link.find("between");
  if (sides->first == sides->second) {
    return between.error_shown(fmt::format("[{0}, {0}]", name(sides->first)), "must be two different buildings");
  }
  if (sides->first > sides->second) {
    const std::string left = name(sides->second), right = name(sides->first);
    return between.error_shown(fmt::format("[{}, {}]", right, left),
                               fmt::format("must be [{}, {}] (buildings from left to right)", left, right));
  }
  return sides;
}

/// Elevations [length] at which both have a floor; empty where they are not known.
std::vector<double> read_link_elevations(const TableView& link, const ReadBuilding& left, const ReadBuilding& right,
                                         std::optional<double> tolerance) {
  const auto given = link.find("elevations");
  const std::vector<double> wanted = given ? link.numbers("elevations") : std::vector<double>();
  if (std::adjacent_find(wanted.begin(), wanted.end(), std::greater_equal<>()) != wanted.end()) {
    given->error("must ascend");
    return {};
  }
  if (wanted.empty() || left.elevations.empty() || right.elevations.empty()) return {};
  const FloorLevels a = floor_levels(left), b = floor_levels(right);
  return named_elevations(*given, wanted, level_floors(a, b, tolerance), a, b);
}

/// Every key of the law; false unless all are usable.
bool read_link_numbers(const TableView& link, const LawEntryOf<Law>& law, LinkSpec& spec) {
  bool good = true, any = false;
  for (const Key& key : law.keys) {
    const std::string name(key.name);
    const bool given = link.has(name);
    any = any || given;
    std::vector<double> numbers = link.numbers(name, spec.elevations.size());
    good = good && (given ? !numbers.empty() : !key.is_required());
    if (!numbers.empty()) spec.numbers[name] = std::move(numbers);
  }
  if (law.keys.empty()) return true;
  if (!any && !law.keys.front().is_required()) {  // nothing of it must be given, but something
    std::string keys;
    for (const Key& key : law.keys) keys += (keys.empty() ? "" : " or ") + std::string(key.name);
    link.error(fmt::format("needs {} for law = \"{}\"", keys, law.name));
  }
  return good && any;
}

}  // namespace

LinkSpec read_link(const TableView& link, const std::vector<ReadBuilding>& buildings,
                   const std::optional<std::pair<std::size_t, std::size_t>>& sides) {
  LinkSpec spec;
  const auto* const law = link.law("law", link_laws(), &OwnLaw::link, spec.own);
  spec.level_tolerance = link.number("level_tolerance");
  if (!link.has("elevations")) link.error_missing("elevations");
  if (sides) {
    std::tie(spec.left, spec.right) = *sides;
    spec.elevations = read_link_elevations(link, buildings[spec.left], buildings[spec.right], spec.level_tolerance);
  }
  if (law == nullptr) return spec;
  spec.law = law->name;
  if (!read_link_numbers(link, *law, spec)) return spec;
  for (std::size_t i = 0; i < spec.elevations.size(); ++i) {
    try {
      (void)make_link_law(spec, i);
    } catch (const InvalidParameter& fault) {  // right one by one, but not together
      const auto value = link.find(fault.parameter());
      if (!value) {
        link.error(
            fmt::format("cannot be computed with at elevation {}: {}", written(spec.elevations[i]), fault.what()));
      } else {
        (value->is(TomlValue::Kind::list) ? value->item(i) : *value).error_value(fault.rule());
      }
      break;  // the other points might say the same
    }
  }
  return spec;
}

std::vector<LinkSpec> read_links(const TomlView& root, const std::vector<ReadBuilding>& buildings, bool in_plan) {
  std::vector<LinkSpec> links;
  if (!root.has("link")) return links;
  const auto list = root.tables("link", "");
  if (!list) return links;
  for (const TomlView& entry : list->items()) {
    const auto link = TableView::of(entry, link_keys());
    if (!link) continue;
    LinkSpec place;
    auto sides = in_plan ? read_between(*link, buildings, "two buildings") : read_sides(*link, buildings);
    if (in_plan) read_place(*link, buildings, sides, place);
    if (!in_plan) link->refuse({"at", "along"}, "is for links of buildings in plan");
    LinkSpec& spec = links.emplace_back(read_link(*link, buildings, sides));
    spec.stretch = std::move(place.stretch);
    spec.at = place.at;
    spec.direction = place.direction;
  }
  return links;
}

}  // namespace bentur
