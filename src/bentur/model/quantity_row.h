#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "bentur/model/quantities.h"

namespace bentur {

/// The values of one quantity in the row of numbers that a study keeps of each run.
struct RowPart {
  std::string name;   ///< file_name(), "peak_force"; of buildings and floors with their number, "peak_displacement_1"
  std::string units;  ///< as UDUNITS reads it; "1" where there is none
  std::string long_name;  ///< for a legend
  Owner owner =
      Owner::run;  ///< one value, or one for each floor, storey of a plane, hinge, bearing, point, gap or link
  Eigen::Index building = 0;  ///< where it is of one
  Eigen::Index count = 1;     ///< how many values
  std::size_t first = 0;      ///< place of the first one in the row
  const Quantity* quantity = nullptr;

  [[nodiscard]] bool is_of_building() const {
    return owner == Owner::floor || owner == Owner::plane || owner == Owner::building || owner == Owner::hinge ||
           owner == Owner::column || owner == Owner::bearing;
  }
};

/// The parts of a row, in its order: every quantity but those of impacts and of single runs alone, buildings first, in
/// plan their planes after their floors. There are as many floors, points, gaps and links as the problem has: the same
/// in every problem of a study.
[[nodiscard]] std::vector<RowPart> row_parts(const Problem& problem, const Units& units, bool energy_audit);
[[nodiscard]] std::vector<RowPart> row_parts(const PlanProblem& problem, const Units& units, bool energy_audit);

/// Values of a row: the sum of all counts.
[[nodiscard]] std::size_t row_size(const std::vector<RowPart>& parts);

/// Whether the floors, hinges, points, gaps and links of two problems are as many, the same buildings can yield or
/// stand on soil, and the same points strike columns, so that their rows are alike.
[[nodiscard]] bool same_places(const Problem& a, const Problem& b);
/// The same of planes, bearings and contacts that rub; the same buildings are walls.
[[nodiscard]] bool same_places(const PlanProblem& a, const PlanProblem& b);

/// Fills `row` with the values of one run; what does not exist (the time of a force that never was) is NaN.
/// @throws InvalidParameter unless the row is as long as these parts need.
void fill_row(const std::vector<RowPart>& parts, const RunView& run, std::span<double> row);
void fill_row(const std::vector<RowPart>& parts, const PlanRun& run, std::span<double> row);

}  // namespace bentur
