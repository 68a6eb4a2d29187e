#include "bentur/model/link.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bentur/core/errors.h"
#include "bentur/elements/kinematic_hardening.h"
#include "bentur/elements/link_laws.h"
#include "bentur/model/case.h"

namespace bentur {

const std::vector<LinkLaw>& link_laws() {
  using Range = LinkKey::Range;
  static const std::vector<LinkLaw> laws = {
      {"spring-dashpot", {{"stiffness", Range::not_negative, 0}, {"damping", Range::not_negative, 0}}},
      {"yielding", {{"stiffness"}, {"yield_force"}, {"hardening", Range::below_one, 0}}},
      {"cable", {{"stiffness"}, {"slack", Range::not_negative, 0}}}};
  return laws;
}

const LinkLaw* find_link_law(std::string_view name) {
  const std::vector<LinkLaw>& laws = link_laws();
  const auto found = std::find_if(laws.begin(), laws.end(), [&](const LinkLaw& law) { return law.name == name; });
  return found == laws.end() ? nullptr : &*found;
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
  const LinkLaw* const entry = find_link_law(law);
  if (entry != nullptr) {
    for (const LinkKey& known : entry->keys) {
      if (known.name == key && known.otherwise) return *known.otherwise;
    }
  }
  throw InvalidParameter(std::string(key), "nothing", fmt::format("must be given for law = \"{}\"", law));
}

std::shared_ptr<const Law> make_link_law(const LinkSpec& spec, std::size_t point) {
  const auto number = [&](std::string_view key) { return spec.number(key, point); };
  if (spec.law == "spring-dashpot") return std::make_shared<SpringDashpot>(number("stiffness"), number("damping"));
  if (spec.law == "yielding") {
    return std::make_shared<KinematicHardening>(number("stiffness"), number("yield_force"), number("hardening"));
  }
  if (spec.law == "cable") return std::make_shared<Cable>(number("stiffness"), number("slack"));
  throw InvalidParameter("law", spec.law, "there is no such law of a link");
}

std::vector<Link> links_of(const std::vector<LinkSpec>& specs, const std::vector<Building>& buildings) {
  std::vector<Link> links;
  for (const LinkSpec& spec : specs) {
    if (spec.left >= spec.right || spec.right >= buildings.size()) {
      throw InvalidParameter("link", fmt::format("between buildings {} and {}", spec.left, spec.right),
                             "must be between two buildings of the row, the left one first");
    }
    const FloorLevels left = levels_of(buildings[spec.left].model);
    const FloorLevels right = levels_of(buildings[spec.right].model);
    const std::vector<LevelPair> pairs = level_floors(left, right, spec.level_tolerance);
    const double round_off = round_off_of_levels(left, right);
    for (std::size_t i = 0; i < spec.elevations.size(); ++i) {
      const double wanted = spec.elevations[i];
      const LevelPair* const pair = pair_at(wanted, pairs, left, right);
      if (pair == nullptr) {
        throw InvalidParameter("elevations", std::to_string(wanted),
                               fmt::format("\"{}\" and \"{}\" do not both have a floor there",
                                           buildings[spec.left].name, buildings[spec.right].name));
      }
      links.push_back({.left = static_cast<Eigen::Index>(spec.left),
                       .right = static_cast<Eigen::Index>(spec.right),
                       .left_floor = pair->left_floor,
                       .right_floor = pair->right_floor,
                       .elevation = std::abs(wanted - pair->elevation) <= round_off ? wanted : pair->elevation,
                       .law = make_link_law(spec, i)});
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
