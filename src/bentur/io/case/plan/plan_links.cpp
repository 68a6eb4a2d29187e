#include <fmt/format.h>

#include <algorithm>

#include "bentur/io/case/plan/plan_parts.h"
#include "bentur/io/schema/table_view.h"

namespace bentur {
namespace {

/// Where along its joint.
void read_along(const TableView& link, LinkSpec& spec) {
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

void read_place(const TableView& link, const std::vector<ReadBuilding>& buildings,
                std::optional<std::pair<std::size_t, std::size_t>>& sides, LinkSpec& spec) {
  if (sides && sides->first == sides->second) {
    link.find("between")->error("must be two buildings");
    sides.reset();
  }
  if (!sides || !buildings[sides->first].is_whole || !buildings[sides->second].is_whole) return;
  const auto [one, other] = *sides;
  const BuildingSpec &first = buildings[one].spec, &second = buildings[other].spec;
  if (const auto joint = facing(first.footprint(), second.footprint())) {
    spec.stretch = *joint;
    if (joint->swapped) sides = {other, one};
    read_along(link, spec);
  } else if (!overlap(first.footprint(), second.footprint())) {
    link.find("between")->error(fmt::format("is between buildings of which no edge faces the other, {} and {}",
                                            in_quotes(first.name), in_quotes(second.name)));
  }
}

}  // namespace bentur
