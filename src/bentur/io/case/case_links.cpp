#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <tuple>

#include "bentur/core/errors.h"
#include "bentur/io/case/case_parts.h"

namespace bentur {
namespace {

const std::vector<std::string> keys_of_every_link = {"between", "elevations", "level_tolerance", "law"};

Rule rule_of_link(LinkKey::Range range) {
  switch (range) {
    case LinkKey::Range::positive:
      return Rule::positive;
    case LinkKey::Range::not_negative:
      return Rule::not_negative;
    case LinkKey::Range::below_one:
      break;
  }
  return Rule::ratio;
}

/// The law if it is known, after a look at all keys of the table.
const LinkLaw* read_link_law(const TomlView& link) {
  std::vector<std::string> names, known = keys_of_every_link, others;
  for (const LinkLaw& law : link_laws()) {
    names.emplace_back(law.name);
    for (const LinkKey& key : law.keys) {
      if (std::find(known.begin(), known.end(), key.name) == known.end()) known.emplace_back(key.name);
    }
  }
  (void)link.is_table_of(known);
  const auto name = link.word("law", names);
  const LinkLaw* const law = name ? find_link_law(*name) : nullptr;
  if (law == nullptr) return nullptr;
  for (const std::string& key : known) {
    const bool own = std::any_of(law->keys.begin(), law->keys.end(), [&](const LinkKey& k) { return k.name == key; });
    const bool every = std::find(keys_of_every_link.begin(), keys_of_every_link.end(), key) != keys_of_every_link.end();
    if (!own && !every) others.push_back(key);
  }
  link.refuse(others, fmt::format("is not for law = \"{}\"", law->name));
  return law;
}

/// The places of the buildings, if they are two in the order of the row.
std::optional<std::pair<std::size_t, std::size_t>> read_sides(const TomlView& link,
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
std::vector<double> read_link_elevations(const TomlView& link, const ReadBuilding& left, const ReadBuilding& right,
                                         std::optional<double> tolerance) {
  const auto given = link.find("elevations");
  const std::vector<double> wanted = given ? given->as_numbers(Rule::finite) : std::vector<double>();
  if (std::adjacent_find(wanted.begin(), wanted.end(), std::greater_equal<>()) != wanted.end()) {
    given->error("must ascend");
    return {};
  }
  if (wanted.empty() || left.elevations.empty() || right.elevations.empty()) return {};
  const FloorLevels a = floor_levels(left), b = floor_levels(right);
  return named_elevations(*given, wanted, level_floors(a, b, tolerance), a, b);
}

/// Every key of the law; false unless all are usable.
bool read_link_numbers(const TomlView& link, const LinkLaw& law, LinkSpec& spec) {
  const Length each = {spec.elevations.size(), "one per elevation"};
  bool good = true, any = false;
  for (const LinkKey& key : law.keys) {
    const std::string name(key.name);
    const auto value = link.get(name, key.otherwise ? Need::optional : Need::required);
    any = any || value;
    if (!value) {
      good = good && key.otherwise;
      continue;
    }
    std::vector<double> numbers = value->as_number_or_numbers(rule_of_link(key.range), each);
    good = good && !numbers.empty();
    if (!numbers.empty()) spec.numbers[name] = std::move(numbers);
  }
  if (!any && law.keys.front().otherwise) {  // nothing of it must be given, but something
    std::string keys;
    for (const LinkKey& key : law.keys) keys += (keys.empty() ? "" : " or ") + std::string(key.name);
    link.error(fmt::format("needs {} for law = \"{}\"", keys, law.name));
  }
  return good && any;
}

LinkSpec read_link(const TomlView& link, const std::vector<ReadBuilding>& buildings) {
  LinkSpec spec;
  if (!link.is(TomlValue::Kind::table)) {
    link.error_value("must be a table");
    return spec;
  }
  const LinkLaw* const law = read_link_law(link);
  spec.level_tolerance = link.number("level_tolerance", Rule::distance, Need::optional);
  const auto sides = read_sides(link, buildings);
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
        link.error(fmt::format("cannot be computed with at elevation {}: {}", spec.elevations[i], fault.what()));
      } else {
        (value->is(TomlValue::Kind::list) ? value->item(i) : *value).error_value(fault.rule());
      }
      break;  // the other points might say the same
    }
  }
  return spec;
}

}  // namespace

std::vector<LinkSpec> read_links(const TomlView& root, const std::vector<ReadBuilding>& buildings) {
  std::vector<LinkSpec> links;
  if (!root.has("link")) return links;
  const auto list = root.tables("link", "");
  if (!list) return links;
  for (const TomlView& link : list->items()) links.push_back(read_link(link, buildings));
  return links;
}

}  // namespace bentur
