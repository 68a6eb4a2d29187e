#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "bentur/io/case_parts.h"

namespace bentur {
namespace {

constexpr double elevation_tolerance = 1e-6;  // of the taller building's height [-]

const std::vector<std::string>& available_laws() {
  static const std::vector<std::string> names = {"linear"};
  return names;
}

const std::vector<std::string>& all_laws() {
  static const std::vector<std::string> names = {"linear",    "kelvin-voigt", "kelvin-voigt-approach",
                                                 "darmawan",  "hertz",        "hertz-damp",
                                                 "jankowski", "bilinear",     "restitution"};
  return names;
}

/// Elevations at which both buildings have a floor [length], ascending; those of the left one where they differ
/// slightly.
std::vector<double> common_elevations(const ReadBuilding& left, const ReadBuilding& right) {
  const double tolerance = elevation_tolerance * std::max(height_of(left), height_of(right));
  std::vector<double> common;
  for (const double elevation : left.elevations) {
    const auto near = [&](double other) { return std::abs(other - elevation) <= tolerance; };
    if (std::any_of(right.elevations.begin(), right.elevations.end(), near)) common.push_back(elevation);
  }
  return common;
}

void read_between(const TomlView& gap, const ReadBuilding& left, const ReadBuilding& right,
                  const std::vector<ReadBuilding>& buildings) {
  const auto between = gap.get("between", Need::required);
  if (!between || !between->is_list_of("building names", {2, "the neighbours, left and right"})) return;
  std::vector<std::string> names;
  for (const ReadBuilding& building : buildings) {
    const std::string& name = building.spec.name;
    // Without a name of its own for each building there is nothing to compare with; that has been said.
    if (name.empty() || std::find(names.begin(), names.end(), name) != names.end()) return;
    names.push_back(name);
  }
  std::vector<std::string> given;
  for (std::size_t i = 0; i < 2; ++i) {
    const auto name = between->item(i).as_text();
    if (!name) return;
    if (std::find(names.begin(), names.end(), *name) == names.end()) {
      between->item(i).error_value("there is no such building, " + suggestion(*name, names, "the buildings are"));
      return;
    }
    given.push_back(*name);
  }
  if (given[0] != left.spec.name || given[1] != right.spec.name) {
    between->error(fmt::format("= [{}, {}], must be [{}, {}] (gaps and neighbours from left to right)",
                               in_quotes(given[0]), in_quotes(given[1]), in_quotes(left.spec.name),
                               in_quotes(right.spec.name)));
  }
}

/// The contact points' elevations [length]; empty when they are not known.
std::vector<double> read_elevations(const TomlView& gap, const ReadBuilding& left, const ReadBuilding& right) {
  const auto given = gap.find("elevations");
  const auto wanted = given ? given->as_numbers(Rule::finite) : std::nullopt;
  if (wanted && std::adjacent_find(wanted->begin(), wanted->end(), std::greater_equal<>()) != wanted->end()) {
    given->error("must ascend");
    return {};
  }
  if (left.elevations.empty() || right.elevations.empty() || (given && !wanted)) return {};
  const std::vector<double> common = common_elevations(left, right);
  if (common.empty()) {
    gap.error(fmt::format("has no elevation at which both buildings have a floor: {} has floors at {}, {} at {}",
                          in_quotes(left.spec.name), fmt::join(left.elevations, ", "), in_quotes(right.spec.name),
                          fmt::join(right.elevations, ", ")));
    return {};
  }
  if (!given) return common;
  const double tolerance = elevation_tolerance * std::max(height_of(left), height_of(right));
  bool good = true;
  for (std::size_t i = 0; i < wanted->size(); ++i) {
    const auto near = [&](double floor) { return std::abs(floor - (*wanted)[i]) <= tolerance; };
    if (std::any_of(common.begin(), common.end(), near)) continue;
    good = false;
    given->item(i).error_value(
        fmt::format("the buildings do not both have a floor there, they have at {}", fmt::join(common, ", ")));
  }
  return good ? *wanted : std::vector<double>{};
}

/// The keys of every law, so that one for another law is told from a misspelt one.
const std::vector<std::string>& all_contact_keys() {
  static const std::vector<std::string> keys = {
      "law",   "stiffness",      "restitution",      "damping_ratio",     "damping",    "release",
      "alpha", "damping_factor", "second_stiffness", "yield_penetration", "calibration"};
  return keys;
}

ContactSpec read_contact(const TomlView& gap, std::size_t points, const ReadBuilding& left, const ReadBuilding& right) {
  ContactSpec contact;
  const auto view = gap.get("contact", Need::required);
  if (!view) return contact;
  if (!view->is(TomlValue::Kind::table)) {
    view->error_value("must be a table with law and stiffness");
    return contact;
  }
  const auto law = view->word("law", all_laws());
  const bool available =
      law && std::find(available_laws().begin(), available_laws().end(), *law) != available_laws().end();
  if (!available) {
    (void)view->is_table_of(all_contact_keys());
    if (law) {
      view->find("law")->error_value(
          fmt::format("this law is not available in this version; available: {}", fmt::join(available_laws(), ", ")));
    }
    return contact;
  }
  contact.law = *law;
  (void)view->is_table_of(all_contact_keys());
  for (const std::string& key : all_contact_keys()) {
    if (key == "law" || key == "stiffness") continue;
    if (const auto other = view->find(key)) other->error("is not for law = \"linear\"");
  }
  const auto stiffness = view->get("stiffness", Need::required);
  if (!stiffness) return contact;
  if (stiffness->is(TomlValue::Kind::text)) {
    contact.axial = stiffness->value().text == "axial";
    if (!contact.axial) {
      stiffness->error_value("must be a number, a list of numbers or \"axial\"");
    } else if (!left.is_frame || !right.is_frame) {
      stiffness->error_value(fmt::format("needs two frames, but {} is none", (left.is_frame ? right : left).path));
    }
    return contact;
  }
  contact.stiffness = stiffness->as_number_or_numbers(Rule::positive, {points, "one per contact point"})
                          .value_or(std::vector<double>{});
  return contact;
}

GapSpec read_gap(const TomlView& gap, const ReadBuilding& left, const ReadBuilding& right,
                 const std::vector<ReadBuilding>& buildings) {
  GapSpec spec;
  if (!gap.is_table_of({"between", "width", "elevations", "contact"})) return spec;
  read_between(gap, left, right, buildings);
  spec.elevations = read_elevations(gap, left, right);
  const std::size_t points = spec.elevations.size();
  if (const auto width = gap.get("width", Need::required)) {
    spec.widths = width->as_number_or_numbers(Rule::not_negative, {points, "one per contact point"})
                      .value_or(std::vector<double>{});
    if (spec.widths.size() == 1 && points > 1) spec.widths.assign(points, spec.widths.front());
  }
  spec.contact = read_contact(gap, points, left, right);
  return spec;
}

}  // namespace

std::vector<GapSpec> read_gaps(const TomlView& root, const std::vector<ReadBuilding>& buildings) {
  std::vector<GapSpec> gaps;
  const auto list = root.find("gap");
  if (!list) {
    root.error_missing("gap", "one [[gap]] table between each pair of neighbours");
    return gaps;
  }
  if (!list->is(TomlValue::Kind::list)) {
    list->error_value("must be a list of tables, each headed [[gap]]");
    return gaps;
  }
  const std::size_t expected = buildings.empty() ? 0 : buildings.size() - 1;
  if (list->size() != expected && buildings.size() > 1) {
    list->error(fmt::format("has {} {}, expected {} (one between each pair of neighbours)", list->size(),
                            list->size() == 1 ? "entry" : "entries", expected));
  }
  for (std::size_t i = 0; i < std::min(list->size(), expected); ++i) {
    gaps.push_back(read_gap(list->item(i), buildings[i], buildings[i + 1], buildings));
  }
  return gaps;
}

}  // namespace bentur
