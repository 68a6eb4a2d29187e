#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "bentur/model/quantities.h"

namespace bentur {

struct PlanQuantity;

/// The values of one quantity in the row of numbers that a study keeps of each run.
struct RowPart {
  std::string name;   ///< file_name(), "peak_force"; of buildings and floors with their number, "peak_displacement_1"
  std::string units;  ///< as UDUNITS reads it; "1" where there is none
  std::string long_name;      ///< for a legend
  Owner owner = Owner::run;   ///< one value, or one for each floor, hinge, bearing, point, gap or link
  bool of_planes = false;     ///< of floors: for each plane in plan one for each floor above a storey of it
  Eigen::Index building = 0;  ///< where it is of one
  Eigen::Index count = 1;     ///< how many values
  std::size_t first = 0;      ///< place of the first one in the row
  const Quantity* quantity = nullptr;
  const PlanQuantity* in_plan = nullptr;  ///< whose words `quantity` is, of buildings in plan

  [[nodiscard]] bool is_of_building() const {
    return owner == Owner::floor || owner == Owner::building || owner == Owner::hinge || owner == Owner::column ||
           owner == Owner::bearing;
  }
};

/// The parts of a row, in its order: every quantity but those of impacts and of single runs alone, buildings first.
/// There are as many floors, points, gaps and links as the problem has: the same in every problem of a study.
[[nodiscard]] std::vector<RowPart> row_parts(const Problem& problem, const Units& units, bool energy_audit);

/// Adds the part of a quantity to those of a row, of which there are `count` values.
RowPart& add_part(std::vector<RowPart>& parts, const Quantity& quantity, Eigen::Index count, const Units& units);
/// Says that it is of this building, from 0: its name ends in the number.
void name_building(RowPart& part, Eigen::Index building, const std::string& name);

/// Values of a row: the sum of all counts.
[[nodiscard]] std::size_t row_size(const std::vector<RowPart>& parts);

/// Whether the floors, hinges, points, gaps and links of two problems are as many, the same buildings can yield or
/// stand on soil, and the same points strike columns, so that their rows are alike.
[[nodiscard]] bool same_places(const Problem& a, const Problem& b);

/// @throws InvalidParameter unless the row is as long as these parts need.
void require_size(const std::vector<RowPart>& parts, std::span<const double> row);

/// Fills `row` with the values of one run; what does not exist (the time of a force that never was) is NaN.
/// @throws InvalidParameter unless the row is as long as these parts need.
void fill_row(const std::vector<RowPart>& parts, const RunView& run, std::span<double> row);

}  // namespace bentur
