#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "bentur/core/errors.h"
#include "bentur/io/input_file.h"
#include "bentur/io/toml/toml_view.h"
#include "bentur/model/case.h"
#include "bentur/pounding/plan/plan_problem.h"

// The parts a case file is read in. Each reader reports what is wrong and fills in what it can, so that the later parts
// can still be checked against it; only the sum of all diagnostics says whether the case may be used.
namespace bentur {

class CaseMemo;
class TableView;

/// A building as read, and what gaps and excitation need to know of it.
struct ReadBuilding {
  BuildingSpec spec;
  std::string path;  ///< building["Model 1"], or building[0] where there is no usable name
  bool is_frame = false;
  [[nodiscard]] bool has_displacements() const { return std::holds_alternative<DisplacementsSpec>(spec.structure); }
  std::size_t modes = 0;                 ///< how many; 0: not known
  std::vector<double> elevations;        ///< [length] of the floors above the ground datum; empty: not known
  std::optional<StructuralModel> model;  ///< assembled; nothing where what was read makes none
  std::shared_ptr<const Building> made;  ///< with modes and damping, once the whole case is found right
  bool is_whole = false;                 ///< of one in plan: its footprint and floors are known
};

/// The table of a building that has been read, by its path.
[[nodiscard]] TomlView view_of(const TomlView& root, const std::vector<ReadBuilding>& buildings, std::size_t building);

[[nodiscard]] Units read_units(const TomlView& root);

/// Where the files that a case names are, and where what is wrong in them goes.
struct CaseFiles {
  const std::filesystem::path& folder;
  Diagnostics& diagnostics;
  CaseMemo* memo = nullptr;
};

/// case_toml.cpp: the path of a file that the case names; nothing (and an error at `key`) where it cannot be read.
[[nodiscard]] std::optional<std::filesystem::path> input_path(const TomlView& key, const std::string& name,
                                                              const std::filesystem::path& folder,
                                                              const InputKind& kind);

/// case_buildings.cpp. What `memo` holds is not read again.
[[nodiscard]] std::vector<ReadBuilding> read_buildings(const TomlView& root, const Units& units, const CaseFiles& files,
                                                       const CaseMemo* memo = nullptr);

/// case_buildings.cpp: the name of a building, which none of those before has, and its path; false (and an error)
/// unless the entry is a table.
[[nodiscard]] bool read_name(const TomlView& entry, const std::vector<ReadBuilding>& before, ReadBuilding& building);

/// case_frame.cpp: [building.frame] into `building`. Gravity [length/s²] turns a unit weight into a density.
void read_frame(const TomlView& frame, double gravity, ReadBuilding& building);

/// Says of a load on a beam that it is too large, or of a backbone of hinges that it cannot be followed, at its key
/// among the sections of a frame; false where the error is about something else.
bool at_section(const std::optional<TomlView>& columns, const std::optional<TomlView>& beams,
                const InvalidParameter& error);
/// case_frame.cpp: what makes the stiffness of a plane's frame, with nodes in its columns, into `plane`. @return
/// whether it is known
bool read_frame_of_plane(const TableView& frame, const std::vector<double>& storey_heights,
                         const std::vector<ColumnNode>& nodes, PlanPlane& plane);

/// case_matrices.cpp: [building.matrices] into `building`, its damping too where it is given.
void read_matrices(const TomlView& matrices, ReadBuilding& building);

/// case_known.cpp: [building.modal], [building.generic], [building.displacements], rigid = true, into `building`.
void read_modal(const TomlView& modal, const Units& units, const CaseFiles& files, ReadBuilding& building);
void read_generic(const TomlView& generic, const Units& units, ReadBuilding& building);
void read_rigid(const TableView& table, ReadBuilding& building);
void read_displacements(const TomlView& displacements, ReadBuilding& building);

/// case_support.cpp: gravity loads of a building whose elevations are known; with [building.isolation] and
/// [building.soil].
void read_gravity(const TableView& table, ReadBuilding& building);
void read_support(const TableView& table, double gravity, ReadBuilding& building);

/// case_columns.cpp: `columns` of a stick or a generic building.
void read_storey_columns(const TableView& view, std::size_t storeys, BuildingSpec& spec);

/// case_columns.cpp: the buildings with nodes in the columns that gaps say are struck. No error is said of these.
[[nodiscard]] std::vector<ReadBuilding> with_struck_columns(const TomlView& root, std::vector<ReadBuilding> buildings);

/// The two sides of a gap, and the elevations of their contact points [length]; empty: not known.
struct GapSides {
  const ReadBuilding& left;
  const ReadBuilding& right;
  const std::vector<double>& elevations;

  /// Of a list for the contact points.
  [[nodiscard]] Length points() const;
};

/// case_gaps.cpp: what `contact` of a table says of a law; nothing (and an error where it is needed) unless it is
/// complete.
[[nodiscard]] std::optional<ContactSpec> read_contact(const TomlView& gap, const GapSides& sides, Need need);

/// case_gaps.cpp: an error where a law cannot be made, at its key and there at contact point `point`. @return whether
/// all other points would say the same
bool say_of_law(const TomlView& contact, const InvalidParameter& fault, std::size_t point);

/// case_gaps.cpp
[[nodiscard]] std::vector<GapSpec> read_gaps(const TomlView& root, const std::vector<ReadBuilding>& buildings);

/// case_columns.cpp: elevations of contact points of a gap with strikes_columns, at floors that meet or where a floor
/// of one building faces a column of the other; empty (and an error) unless all are.
[[nodiscard]] std::vector<double> read_struck_columns(const TomlView& elevations, const std::vector<double>& wanted,
                                                      const std::vector<LevelPair>& pairs, const ReadBuilding& left,
                                                      const ReadBuilding& right);

/// case_columns.cpp: the elevations of `striking`'s floors that face a column of `struck`; none unless that is a frame.
[[nodiscard]] std::vector<double> columns_in_reach(const ReadBuilding& struck, const ReadBuilding& striking);

/// case_buildings.cpp: the model of what has been read, its slab's floor among the others.
void make(ReadBuilding& building);

/// Of the names in `between` of a gap or a link the two buildings, as places in the row; nothing (and an error) unless
/// they are names of the case. @param what of the two names, "the neighbours, left and right"
[[nodiscard]] std::optional<std::pair<std::size_t, std::size_t>> read_between(
    const TomlView& table, const std::vector<ReadBuilding>& buildings, const std::string& what);

/// Floor levels of a building as read.
[[nodiscard]] FloorLevels floor_levels(const ReadBuilding& building);

/// Elevations of contact points or links that a list names, each at one of two floors that meet or between them; empty
/// (and an error) unless all are.
[[nodiscard]] std::vector<double> named_elevations(const TomlView& list, const std::vector<double>& wanted,
                                                   const std::vector<LevelPair>& pairs, const FloorLevels& left,
                                                   const FloorLevels& right);

/// case_links.cpp: of a link the law and the levels between two of the buildings, the left or lower one first; levels
/// alone are missing where these are not known.
[[nodiscard]] LinkSpec read_link(const TableView& link, const std::vector<ReadBuilding>& buildings,
                                 const std::optional<std::pair<std::size_t, std::size_t>>& sides);
/// case_links.cpp
[[nodiscard]] std::vector<LinkSpec> read_links(const TomlView& root, const std::vector<ReadBuilding>& buildings,
                                               bool in_plan);

/// case_stick.cpp: [building.stick] into `building`.
void read_stick(const TomlView& stick, ReadBuilding& building);
/// case_stick.cpp: what says how storeys yield, of a stick or a plane.
void read_yielding(const TableView& view, std::size_t storeys, Stick& stick);
/// case_stick.cpp: of one whose storeys lose strength, its stiffnesses known, likewise.
void read_backbone(const TableView& view, std::size_t storeys, Stick& stick);

/// case_damping.cpp: a number or a table with exactly one form. @param modes how many; 0: not known
[[nodiscard]] Damping read_damping(const TomlView& damping, std::size_t modes);

/// case_damping.cpp: damping_stiffness of a building, once its structure and damping are read.
void read_damping_stiffness(const TableView& building, ReadBuilding& read);

/// case_excitation.cpp: [initial], what moves at the start.
[[nodiscard]] InitialSpec read_initial(const TomlView& root, const std::vector<ReadBuilding>& buildings, bool in_plan);

/// case_excitation.cpp: [excitation], of a case in plan both components and the angle of their axes, into a case whose
/// gaps are known.
void read_excitation(const TomlView& root, const std::vector<ReadBuilding>& buildings, const CaseFiles& files,
                     bool in_plan, Case& c);

/// case_excitation.cpp: a record or a harmonic motion, by `kind`, with what is to be said of it.
void read_motion(const TableView& view, const Units& units, const std::filesystem::path& folder,
                 Diagnostics& diagnostics, ExcitationSpec& spec, CaseMemo* memo = nullptr);

/// case_toml.cpp: [analysis], of an excitation that may have a record's length.
[[nodiscard]] AnalysisSpec read_analysis(const TomlView& root, const ExcitationSpec& excitation);

/// case_toml.cpp: that no time is below what numbers can tell apart in the duration.
void check_motion_times(const TomlView& excitation, const GroundMotion& motion, double duration, const Units& units);
void check_mode_times(const TomlView& building, const Modes& modes, const Eigen::MatrixXd& modal_damping,
                      double duration);

/// case_toml.cpp: of a table with an entry per building each entry and the number of its building; an error at those
/// that name none. @param each what an entry is, for people @return false (and an error) unless it is a table
bool read_by_building(const TomlView& table, const std::string& each, const std::vector<std::string>& names,
                      const std::function<void(std::size_t, const TomlView&)>& take);

/// Whether the buildings of a case stand in plan, by a key that says so; nothing: in a row.
[[nodiscard]] std::optional<TomlView> plan_of(const TomlView& root);

/// case_excitation.cpp: an acceleration > 0 [length/s²]: a number times `of_number`, by default in the case's own unit,
/// or a text with its unit, "0.35 g".
[[nodiscard]] std::optional<double> read_acceleration(const TomlView& value, const Units& units, double of_number = 1);

/// case_suite.cpp: excitation.kind = "suite": what is asked for and every record that its files name, none of them
/// chosen yet. @param along_y of buildings in plan what names the other components, where there are any
[[nodiscard]] std::shared_ptr<const SuiteSpec> read_suite(const TableView& view,
                                                          const std::optional<TableView>& along_y, const Units& units,
                                                          const std::filesystem::path& folder,
                                                          Diagnostics& diagnostics);
struct ReadCase;
/// Chooses and scales them, once the periods of the buildings are known; what cannot be done is an error at its key.
void settle_suite(const TomlView& root, ReadCase& read, const std::function<void(double)>& progress);
/// case_spectrum.cpp: what of a spectrum or a suite hangs on the periods of the buildings.
void settle_excitation(const TomlView& root, ReadCase& read, const Diagnostics& diagnostics,
                       const std::function<void(double)>& progress);

/// case_spectrum.cpp: the ordinates of a spectrum, by its shape and the keys of that; `file` and `path` where a table
/// comes from a file.
struct ShapeRead {
  std::string word;  ///< as the case names it; empty where it is wrong
  decltype(DesignSpectrum::shape) shape = {};
  std::string file = {}, path = {};
};
[[nodiscard]] ShapeRead read_shape(const TableView& view, const Units& units, const std::filesystem::path& folder,
                                   Diagnostics& diagnostics);

/// case_spectrum.cpp: excitation.kind = "spectrum", its keys, and what only shows once the whole case is right.
[[nodiscard]] SpectrumSpec read_spectrum(const TableView& view, const Units& units, std::size_t buildings,
                                         const std::filesystem::path& folder, Diagnostics& diagnostics);
[[nodiscard]] ScreeningSpec read_screening(const TomlView& root);

/// case_code.cpp. @param gaps how many; 0: not known, and lists over them are not looked at
[[nodiscard]] CodeSpec read_code(const TomlView& root, const Units& units, std::size_t buildings, std::size_t gaps);

/// case_project.cpp
[[nodiscard]] std::optional<ProjectSpec> read_project(const TomlView& root, const std::filesystem::path& folder,
                                                      Diagnostics& diagnostics);

/// A case and what was learnt in reading it.
struct ReadCase {
  Case c;
  std::vector<ReadBuilding> buildings;
  std::optional<PlanProblem> plan = {};  ///< what a case in plan that is right is solved as

  /// The buildings of a row that is right, as make_problem() takes them.
  [[nodiscard]] std::vector<Building> made_buildings() const;
  /// make_problem() of a row that is right. @throws InvalidParameter
  [[nodiscard]] Problem problem() const { return make_problem(c, made_buildings()); }
};

/// case_toml.cpp: a whole case; its parts are usable only when `diagnostics` has no error. `memo` is for many readings
/// of nearly the same case, which then share buildings and records.
/// @param progress of what may take long, the spectra of a suite of records: the fraction done
[[nodiscard]] ReadCase read_case_parts(const TomlView& root, const std::filesystem::path& folder,
                                       Diagnostics& diagnostics, CaseMemo* memo = nullptr,
                                       const std::function<void(double)>& progress = {});

}  // namespace bentur
