#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bentur/core/diagnostics.h"

namespace bentur {

/// What a case says of its table of mode shapes.
struct ShapesAsked {
  std::vector<double> elevations;             ///< of the floors above the base [length], ascending
  std::size_t modes = 0;                      ///< how many
  std::vector<std::string> names = {};        ///< of the floors in the table, lowest first; empty: not given
  std::optional<std::string> component = {};  ///< of a program's table: UX, UY, U1 or U2
  std::vector<int> numbers = {};              ///< of a program's table: which modes; empty: all
  double metre = 1;                           ///< [length]
  bool in_plan = false;                       ///< of each floor u_x, u_y and rotation
};

/// One list a mode, floors bottom to top, of either table:
///
/// a row a floor, a column a mode, in plan three, UX, UY and RZ: the first column may hold elevations, and before it
/// names of floors. Rows run from the lowest floor up, or as elevations or names say: names that are given, or that end
/// in numbers which go up or down;
///
/// a row a storey and mode, as ETABS and SAP2000 write it ("Diaphragm Center Of Mass Displacements", "Joint
/// Displacements"): columns Story or Joint, Step Number, UX and UY or U1 and U2, and Z, with a line of units below.
/// Floors are those of Z, from the base or by their distances from the highest, or of names that are given. In plan
/// with UX, UY and RZ or U1, U2 and R3, the first two in the unit of their column.
/// @return nothing where something is wrong, which is in `diagnostics`
[[nodiscard]] std::optional<std::vector<std::vector<double>>> mode_shapes(const std::string& text,
                                                                          const std::string& file,
                                                                          const ShapesAsked& asked,
                                                                          Diagnostics& diagnostics);

}  // namespace bentur
