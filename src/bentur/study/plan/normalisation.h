#pragma once

#include <filesystem>
#include <vector>

#include "bentur/io/toml/toml_view.h"
#include "bentur/study/plan/study.h"

namespace bentur {

/// `normalisation` of a [[vary]] with files: a rule ("pgv", "pgv-pairs"), a list of factors, or a table with the file
/// that holds them, into `vary`. A file of factors is CSV: a heading with `file` and `factor` or
/// `normalisation_factor`, or two columns, name and factor; files are found by their names without folder.
/// @param paths of the vary's files, in their order
void read_normalisation(const TomlView& view, const std::filesystem::path& folder,
                        const std::vector<std::filesystem::path>& paths, Vary& vary);

/// Refuses normalisation beside excitation.pga, finds the factors that a rule gives, and tells [ida] of them. By "pgv"
/// the factor of a record is median(PGV)/PGV over all files; by "pgv-pairs" PGV is the geometric mean of two files that
/// follow one another, the two components of a station [FEMAP695, eq. A-1]. PGV is that of the record as read,
/// motion_measures(). A record that cannot be read has no factor: reading it again tells why.
void settle_normalisation(const TomlView& root, Study& study);

}  // namespace bentur
