#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "bentur/io/schema/table_view.h"
#include "bentur/study/design/study.h"

// The parts a study file is read in; read_study() puts them together.
namespace bentur {

/// What the readers of [[vary]] need to know of the rest.
struct VaryContext {
  std::filesystem::path folder;       ///< of the study: files are relative to it
  std::filesystem::path case_folder;  ///< that the case takes them relative to
  bool remedy = false;                ///< with [remedy] ranges are what may be chosen, and nothing is drawn
  bool samples = false;  ///< with [sampling] ranges and distributions are drawn from, else they are stepped through
};

/// vary_toml.cpp: one [[vary]] but for its place in the case and its axis. `together` receives the name it moves with,
/// if any.
[[nodiscard]] Vary read_vary(const TomlView& view, const VaryContext& context, std::string& together);

/// vary_toml.cpp: `count` numbers from `from` to `to`, spaced as `spacing` says; empty where there was an error.
[[nodiscard]] std::vector<double> read_steps(const TableView& view);

/// ida_toml.cpp: [ida] of a study; nothing where it has none. Its axis is for read_study() to set.
[[nodiscard]] std::optional<IdaSpec> read_ida(const TomlView& root);

/// ida_toml.cpp: what keeps records from being taken as their files have them, at the levels of [ida].
void check_cloud(const TomlView& root, const Study& study);

/// ida_toml.cpp: refuses levels without a unit, which are in the case's length/s², that are rather meant in g.
void expect_unit_of_levels(const TomlView& root, const Study& study);

/// ida_toml.cpp: with [ida] and [sampling] each draw is a record and a building: what [sampling] draws becomes lists
/// that move together along one axis, "draw". Without [sampling] nothing changes.
void draw_with_records(const TomlView& root, Study& study);

/// remedy_toml.cpp: [remedy] of a study; nothing where it has none.
[[nodiscard]] std::optional<RemedySpec> read_remedy(const TomlView& root);

/// normalisation.cpp: `normalisation` of a [[vary]] with files: a rule ("pgv", "pgv-pairs"), a list of factors, or a
/// table with the file that holds them, into `vary`. A file of factors is CSV: a heading with `file` and `factor` or
/// `normalisation_factor`, or two columns, name and factor; files are found by their names without folder.
/// @param paths of the vary's files, in their order
void read_normalisation(const TomlView& view, const std::filesystem::path& folder,
                        const std::vector<std::filesystem::path>& paths, Vary& vary);

/// Refuses normalisation beside excitation.pga, finds the factors that a rule gives, and tells [ida] of them. By "pgv"
/// the factor of a record is median(PGV)/PGV over all files; by "pgv-pairs" PGV is the geometric mean of two files that
/// follow one another, the two components of a station [FEMAP695, eq. A-1], which by "pgv" it is of both components
/// where the case has [excitation.y]. PGV is that of the record as read, motion_measures(). A record that cannot be
/// read has no factor: reading it again tells why.
void settle_normalisation(const TomlView& root, Study& study);

}  // namespace bentur
