#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "bentur/core/units.h"
#include "bentur/solve/problem.h"
#include "bentur/solve/response.h"

namespace bentur {

/// What the values of a quantity belong to.
enum class Owner { run, floors, points, gaps };

/// One quantity that a study keeps of each run.
struct Quantity {
  std::string name;          ///< "peak_force"; of floors with the building's number, "peak_displacement_1"
  std::string units;         ///< as UDUNITS reads it; "1" where there is none
  std::string long_name;     ///< for a legend
  Owner owner = Owner::run;  ///< one value for the run, or one each
  std::size_t building = 0;  ///< of floors
  std::size_t count = 1;     ///< how many values
  std::size_t first = 0;     ///< place of the first one in a row
};

/// Everything of `bentur run --json` that is a number, in the order of a row. The numbers of floors, points and gaps
/// are those of the problem; every problem of a study must have the same.
[[nodiscard]] std::vector<Quantity> sweep_quantities(const Problem& problem, const Units& units, bool energy_audit);

/// Values of a row: the sum of all counts.
[[nodiscard]] std::size_t row_size(const std::vector<Quantity>& quantities);

/// Whether the floors, points and gaps of two problems are as many, so that their rows are alike.
[[nodiscard]] bool same_places(const Problem& a, const Problem& b);

/// Fills `row` with the values of one run; what does not exist (the time of a force that never was) is NaN.
/// @throws InvalidParameter unless the row is as long as these quantities need.
void fill_row(const Problem& problem, const Response& response, std::span<double> row);

/// A length or force unit as UDUNITS reads it.
[[nodiscard]] std::string udunit(const std::string& unit);

}  // namespace bentur
