#include <fmt/format.h>

#include <algorithm>

#include "bentur/io/case/plan/plan_parts.h"
#include "bentur/io/schema/case_keys.h"
#include "bentur/io/schema/table_view.h"

namespace bentur {
namespace {

/// The place of a link along its joint, and what it acts along.
void read_place(const TableView& link, PlanLinkSpec& spec) {
  const std::optional<double> at = link.number("at");
  if (!link.has("at")) link.error_missing("at", "the coordinate along the joint");
  const Stretch& joint = spec.stretch;
  const std::optional<double> along = at ? joint.along_at(*at) : std::nullopt;
  if (at && !along) {
    const auto [from, to] = std::minmax({joint.coordinate(joint.from), joint.coordinate(joint.to)});
    link.get("at")->error_value(
        fmt::format("must be where the buildings face each other, from {:.6g} to {:.6g}", from, to));
  }
  spec.at = along.value_or(joint.from);
  spec.direction = joint.is_oblique() ? joint.normal(spec.at) : PlanPoint::Unit(joint.across);
  if (link.has("along")) spec.direction = PlanPoint::Unit(link.word("along") == "y" ? 1 : 0);
}

}  // namespace

std::vector<PlanLinkSpec> read_plan_links(const TomlView& root, const std::vector<ReadPlanBuilding>& buildings) {
  std::vector<PlanLinkSpec> links;
  if (!root.has("link")) return links;
  const auto list = root.tables("link", "");
  if (!list) return links;
  std::vector<ReadBuilding> told;
  for (const ReadPlanBuilding& building : buildings) told.push_back(building.told);
  for (const TomlView& entry : list->items()) {
    const auto link = TableView::of(entry, link_keys());
    if (!link) continue;
    PlanLinkSpec spec;
    auto sides = read_between(*link, told, "two buildings");
    if (sides && sides->first == sides->second) {
      link->find("between")->error("must be two buildings");
      sides.reset();
    }
    const bool known = sides && buildings[sides->first].is_whole && buildings[sides->second].is_whole;
    if (known) {
      const auto [one, other] = *sides;
      const auto joint = facing(buildings[one].spec.footprint(), buildings[other].spec.footprint());
      if (joint) {
        spec.stretch = *joint;
        if (joint->swapped) sides = {other, one};
        read_place(*link, spec);
      } else if (!overlap(buildings[one].spec.footprint(), buildings[other].spec.footprint())) {
        link->find("between")->error(fmt::format("is between buildings of which no edge faces the other, {} and {}",
                                                 in_quotes(buildings[one].spec.name),
                                                 in_quotes(buildings[other].spec.name)));
      }
    }
    spec.link = read_link(*link, told, sides);
    links.push_back(std::move(spec));
  }
  return links;
}

}  // namespace bentur
