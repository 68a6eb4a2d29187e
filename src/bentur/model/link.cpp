#include "bentur/model/link.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "bentur/core/errors.h"
#include "bentur/elements/link_laws.h"
#include "bentur/model/case.h"

namespace bentur {

const std::vector<LawEntryOf<Law>>& link_laws() {
  static const std::vector<LawEntryOf<Law>> laws = {SpringDashpot::entry(), yielding_link_entry(), Cable::entry()};
  return laws;
}

double LinkSpec::number(std::string_view key, std::size_t point) const {
  const auto found = numbers.find(key);
  if (found != numbers.end()) {
    const std::vector<double>& values = found->second;
    if (values.size() != 1 && point >= values.size()) {
      throw InvalidParameter(found->first, fmt::format("{} values", values.size()),
                             "must be one value or one per elevation");
    }
    return values.size() == 1 ? values.front() : values[point];
  }
  if (const auto* const entry = find_entry(link_laws(), law)) {
    for (const Key& known : entry->keys) {
      if (known.name == key && known.default_value) return *known.default_value;
    }
  }
  throw InvalidParameter(std::string(key), "nothing", fmt::format("must be given for law = \"{}\"", law));
}

std::shared_ptr<const Law> make_link_law(const LinkSpec& spec, std::size_t point) {
  const auto* const entry = find_entry(link_laws(), spec.law, spec.own);
  if (entry == nullptr) throw InvalidParameter("law", spec.law, "there is no such law of a link");
  LawInput input;
  for (const Key& key : entry->keys) input.numbers.emplace(key.name, spec.number(key.name, point));
  return entry->make(input);
}

namespace {

/// Of a spring and a dashpot side by side one may be missing.
std::string kind_of(const Law& law) {
  if (law.name() != "spring-dashpot") return std::string(law.name());
  std::string kind;
  for (const auto& [quantity, value] : law.parameters()) {
    if (value > 0) kind += (kind.empty() ? "" : "-") + std::string(quantity == "stiffness" ? "spring" : "dashpot");
  }
  return kind;
}

}  // namespace

std::vector<Link> links_of(const LinkSpec& spec, const FloorLevels& left, const FloorLevels& right,
                           const std::array<std::string, 2>& names) {
  std::vector<Link> links;
  const std::vector<LevelPair> pairs = level_floors(left, right, spec.level_tolerance);
  const double round_off = round_off_of_levels(left, right);
  for (std::size_t i = 0; i < spec.elevations.size(); ++i) {
    const double wanted = spec.elevations[i];
    const LevelPair* const pair = pair_at(wanted, pairs, left, right);
    if (pair == nullptr) {
      throw InvalidParameter("elevations", std::to_string(wanted),
                             fmt::format("\"{}\" and \"{}\" do not both have a floor there", names[0], names[1]));
    }
    std::shared_ptr<const Law> law = make_link_law(spec, i);
    std::string kind = kind_of(*law);
    links.push_back({.left = static_cast<Eigen::Index>(spec.left),
                     .right = static_cast<Eigen::Index>(spec.right),
                     .left_floor = pair->left_floor,
                     .right_floor = pair->right_floor,
                     .elevation = std::abs(wanted - pair->elevation) <= round_off ? wanted : pair->elevation,
                     .law = std::move(law),
                     .kind = std::move(kind)});
  }
  return links;
}

std::vector<Link> links_of(const std::vector<LinkSpec>& specs, const std::vector<Building>& buildings) {
  std::vector<Link> links;
  for (const LinkSpec& spec : specs) {
    if (spec.left >= spec.right || spec.right >= buildings.size()) {
      throw InvalidParameter("link", fmt::format("between buildings {} and {}", spec.left, spec.right),
                             "must be between two buildings of the row, the left one first");
    }
    for (Link& link : links_of(spec, levels_of(buildings[spec.left].model), levels_of(buildings[spec.right].model),
                               {buildings[spec.left].name, buildings[spec.right].name})) {
      links.push_back(std::move(link));
    }
  }
  return links;
}

std::vector<std::vector<Eigen::Index>> links_by_spec(const std::vector<LinkSpec>& specs) {
  std::vector<std::vector<Eigen::Index>> all;
  Eigen::Index next = 0;
  for (const LinkSpec& spec : specs) {
    all.emplace_back();
    for (std::size_t i = 0; i < spec.elevations.size(); ++i) all.back().push_back(next++);
  }
  return all;
}

std::string link_name(const Problem& problem, const Link& link) {
  return problem.buildings.at(static_cast<std::size_t>(link.left)).name + " – " +
         problem.buildings.at(static_cast<std::size_t>(link.right)).name;
}

}  // namespace bentur
