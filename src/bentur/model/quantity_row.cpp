#include "bentur/model/quantity_row.h"

#include <fmt/format.h>

#include <algorithm>

#include "bentur/core/errors.h"
#include "bentur/structure/frame/infill.h"

namespace bentur {

namespace {

bool any_column_has(const Quantity& quantity, const Problem& problem) {
  return std::any_of(problem.points.begin(), problem.points.end(),
                     [&](const ContactPoint& point) { return column_has(quantity, problem, point); });
}

}  // namespace

RowPart& add_part(std::vector<RowPart>& parts, const Quantity& quantity, Eigen::Index count, const Units& units) {
  parts.push_back({.name = file_name(quantity),
                   .units = udunits(quantity.units, units),
                   .long_name = std::string(quantity.long_name),
                   .owner = quantity.owner,
                   .count = count,
                   .first = row_size(parts),
                   .quantity = &quantity});
  return parts.back();
}

void name_building(RowPart& part, Eigen::Index building, const std::string& name) {
  part.name += fmt::format("_{}", building + 1);
  part.long_name += fmt::format(", building \"{}\"", name);
  part.building = building;
}

void require_size(const std::vector<RowPart>& parts, std::span<const double> row) {
  if (row.size() == row_size(parts)) return;
  throw InvalidParameter("row", fmt::format("{} values", row.size()), fmt::format("must have {}", row_size(parts)));
}

std::vector<RowPart> row_parts(const Problem& problem, const Units& units, bool energy_audit) {
  std::vector<RowPart> parts;
  const auto add = [&](const Quantity& quantity, Eigen::Index count) -> RowPart& {
    return add_part(parts, quantity, count, units);
  };
  for (Eigen::Index b = 0; b < std::ssize(problem.buildings); ++b) {
    const Building& building = problem.buildings[b];
    const Eigen::Index hinges = std::ssize(building.model.hinges.places);
    const Eigen::Index columns = std::ssize(building.model.hinges.columns);
    for (const Owner owner : {Owner::floor, Owner::building, Owner::hinge, Owner::column}) {
      for (const Quantity* quantity : quantities_of(owner)) {
        if (is_of_yielding(*quantity) && !is_of_yielding(*quantity, building)) continue;
        if (is_of_infill(*quantity) && !is_of_infill(*quantity, building)) continue;
        if (is_of_foundation(*quantity) && !building.model.foundation) continue;
        if ((is_of_hinges(*quantity) && hinges == 0) || (is_of_breaking(*quantity) && columns == 0)) continue;
        if (is_of_weakening(*quantity) && building.model.hinges.backbones.empty()) continue;
        RowPart& part = add(*quantity, owner == Owner::floor    ? building.model.floors()
                                       : owner == Owner::hinge  ? hinges
                                       : owner == Owner::column ? columns
                                                                : 1);
        name_building(part, b, building.name);
      }
    }
  }
  for (const Owner owner : {Owner::point, Owner::gap, Owner::link, Owner::run}) {
    for (const Quantity* quantity : quantities_of(owner)) {
      if (quantity->single_run || (quantity->audit_only && !energy_audit)) continue;
      if (is_of_columns(*quantity) && !any_column_has(*quantity, problem)) continue;
      add(*quantity, owner == Owner::point  ? std::ssize(problem.points)
                     : owner == Owner::gap  ? std::ssize(problem.buildings) - 1
                     : owner == Owner::link ? std::ssize(problem.links)
                                            : 1);
    }
  }
  return parts;
}

std::size_t row_size(const std::vector<RowPart>& parts) {
  return parts.empty() ? 0 : parts.back().first + parts.back().count;
}

bool same_places(const Problem& a, const Problem& b) {
  const auto floors = [](const Building& x, const Building& y) {
    return x.model.floors() == y.model.floors() && x.storeys_yield() == y.storeys_yield() &&
           x.model.foundation.has_value() == y.model.foundation.has_value() &&
           x.model.hinges.places.size() == y.model.hinges.places.size() &&
           x.model.hinges.columns.size() == y.model.hinges.columns.size() &&
           x.model.infills.empty() == y.model.infills.empty() &&
           struts_on_columns(x.model).empty() == struts_on_columns(y.model).empty();
  };
  const auto left = [&](const ContactPoint& x, const ContactPoint& y) {
    return x.left == y.left && struck_column(a, x).has_value() == struck_column(b, y).has_value();
  };
  const auto sides = [](const Link& x, const Link& y) { return x.left == y.left && x.right == y.right; };
  const auto columns = [&](const Quantity& quantity) {
    return !is_of_columns(quantity) || any_column_has(quantity, a) == any_column_has(quantity, b);
  };
  return std::equal(a.buildings.begin(), a.buildings.end(), b.buildings.begin(), b.buildings.end(), floors) &&
         std::equal(a.points.begin(), a.points.end(), b.points.begin(), b.points.end(), left) &&
         std::equal(a.links.begin(), a.links.end(), b.links.begin(), b.links.end(), sides) &&
         std::all_of(quantities().begin(), quantities().end(), columns);
}

void fill_row(const std::vector<RowPart>& parts, const RunView& run, std::span<double> row) {
  require_size(parts, row);
  for (const RowPart& part : parts) {
    for (Eigen::Index i = 0; i < part.count; ++i) {
      const QuantityPlace at = part.is_of_building() ? QuantityPlace{part.building, i} : QuantityPlace{i, 0};
      row[part.first + i] = value_of(*part.quantity, run, at);
    }
  }
}

}  // namespace bentur
