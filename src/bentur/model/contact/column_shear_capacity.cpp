#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <utility>

#include "bentur/core/errors.h"
#include "bentur/model/case.h"

namespace bentur {

double column_shear_capacity(const GapSpec& gap, std::size_t point, double of_section, std::size_t storey,
                             const std::string& building) {
  const bool has_own = gap.column_capacity && !gap.column_capacity->shear.empty();
  const double own = has_own ? gap.column_capacity->shear.at(point) : 0;
  if (!std::isfinite(of_section)) return own;
  if (has_own && own != of_section) {
    throw InvalidParameter("shear", fmt::format("{}", own),
                           fmt::format("must be {} as shear_capacity of columns[{}] of \"{}\" has it, or not given",
                                       of_section, storey, building));
  }
  return of_section;
}

double column_shear_capacity(const GapSpec& gap, std::size_t point, const SpecAndModel& left, const SpecAndModel& right,
                             const LevelPair& floors) {
  constexpr double not_given = std::numeric_limits<double>::infinity();
  for (const auto& [building, node] : {std::pair(&left, floors.left_floor), std::pair(&right, floors.right_floor)}) {
    const auto* frame = std::get_if<PlaneFrame>(&building->spec.structure);
    if (frame == nullptr || node < building->model.floors()) continue;
    const Eigen::Index storey = building->model.floor_at_or_above(node) - building->model.first_storey();
    const Eigen::Index line = building == &left ? std::ssize(frame->bay_widths) : 0;
    const double of_section = frame->columns.at(static_cast<std::size_t>(storey)).shear_capacity_of(line);
    return column_shear_capacity(gap, point, of_section, static_cast<std::size_t>(storey), building->spec.name);
  }
  return column_shear_capacity(gap, point, not_given, 0, "");
}

}  // namespace bentur
