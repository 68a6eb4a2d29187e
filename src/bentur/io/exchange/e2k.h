#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "bentur/core/diagnostics.h"
#include "bentur/io/exchange/imported_case.h"

namespace bentur {

/// Of a section.
struct E2kProperties {
  double area = 0;   ///< [length²]
  double major = 0;  ///< I33: of a beam that of bending in the vertical plane [length⁴]
  double minor = 0;  ///< I22; 0: not known [length⁴]
};

/// Which of a model's frames is read: the columns that stand on the line x = at, or y = at.
struct E2kFrame {
  bool along_x = true;            ///< its bays run along X, so that it stands at a Y
  std::optional<double> at = {};  ///< [length]; nothing: the only one there is
  /// By name: of sections of a library, of which the text has the names alone, and in place of what it says of others.
  std::map<std::string, E2kProperties> sections = {};
};

/// One plane frame of a model that ETABS has written as text (.e2k, "Export ETABS .e2k Text File"): units, storeys,
/// materials (E, weight per volume), frame sections (rectangles, circles, I, tubes and pipes by their sides, others by
/// area, I33 and I22), points, lines and the sections assigned to them, all with their modifiers of area and I. Columns
/// of frames along X bend about axis 3, of those along Y about 2, and reversed where ANG is 90; beams about
/// 3. A member whose ends are released is an error, for a frame here is rigid at its nodes. It has one section for all
/// columns of a storey and all beams of a floor, and one modulus: where they differ areas and E·I are the means, which
/// is said in `taken`. Weights of slabs, loads, walls and all else are listed as unread.
/// @param name of the file, for messages
/// @return a case with one building.frame, to be completed by its user; nothing when there is an error, all of which
/// are in `diagnostics`
[[nodiscard]] std::optional<ImportedCase> read_e2k(const std::string& text, const std::string& name,
                                                   const E2kFrame& frame, Diagnostics& diagnostics);

}  // namespace bentur
