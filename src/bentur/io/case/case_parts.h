#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "bentur/io/toml/toml_view.h"
#include "bentur/model/case.h"

// The parts a case file is read in. Each reader reports what is wrong and fills in what it can, so that the later parts
// can still be checked against it; only the sum of all diagnostics says whether the case may be used.
namespace bentur {

class CaseMemo;

/// A building as read, and what gaps and excitation need to know of it.
struct ReadBuilding {
  BuildingSpec spec;
  std::string path;  ///< building["Model 1"], or building[0] where there is no usable name
  bool is_frame = false;
  std::size_t modes = 0;                 ///< how many; 0: not known
  std::vector<double> elevations;        ///< [length] of the floors above the ground datum; empty: not known
  std::optional<StructuralModel> model;  ///< assembled; nothing where what was read makes none
  std::shared_ptr<const Building> made;  ///< with modes and damping, once the whole case is found right
};

/// Elevations of floors above their building's base, from the heights of its storeys [length].
[[nodiscard]] std::vector<double> floor_elevations(const std::vector<double>& storey_heights);

[[nodiscard]] Units read_units(const TomlView& root);

/// case_buildings.cpp. What `memo` holds is not read again.
[[nodiscard]] std::vector<ReadBuilding> read_buildings(const TomlView& root, const Units& units,
                                                       const CaseMemo* memo = nullptr);

/// case_frame.cpp: [building.frame] into `building`. Gravity [length/s²] turns a unit weight into a density.
void read_frame(const TomlView& frame, double gravity, ReadBuilding& building);

/// case_matrices.cpp: [building.matrices] into `building`, its damping too where it is given.
void read_matrices(const TomlView& matrices, ReadBuilding& building);

/// case_gaps.cpp
[[nodiscard]] std::vector<GapSpec> read_gaps(const TomlView& root, const std::vector<ReadBuilding>& buildings);

/// case_excitation.cpp. `folder` is the one that record files are relative to.
[[nodiscard]] ExcitationSpec read_excitation(const TomlView& root, const Units& units,
                                             const std::vector<ReadBuilding>& buildings,
                                             const std::vector<GapSpec>& gaps, const std::filesystem::path& folder,
                                             Diagnostics& diagnostics, CaseMemo* memo = nullptr);

/// The ways round that a record can be applied: as-recorded reversed.
[[nodiscard]] const std::vector<std::string>& polarities();

/// case_code.cpp
[[nodiscard]] CodeSpec read_code(const TomlView& root, const std::vector<ReadBuilding>& buildings);

/// A case together with what was learnt in reading it.
struct ReadCase {
  Case c;
  std::vector<ReadBuilding> buildings;

  /// The buildings of a case that is right, as make_problem() takes them.
  [[nodiscard]] std::vector<Building> made_buildings() const;
  /// make_problem() of a case that is right. @throws InvalidParameter
  [[nodiscard]] Problem problem() const { return make_problem(c, made_buildings()); }
};

/// case_toml.cpp: a whole case; its parts are usable only when `diagnostics` has no error. `memo` is for many readings
/// of nearly the same case, which then share buildings and records.
[[nodiscard]] ReadCase read_case_parts(const TomlView& root, const std::filesystem::path& folder,
                                       Diagnostics& diagnostics, CaseMemo* memo = nullptr);

}  // namespace bentur
