#pragma once

#include <filesystem>

#include "bentur/files/netcdf.h"
#include "bentur/model/run_results.h"

namespace bentur {

/// Whether a file is histories.nc of a run, of this version.
[[nodiscard]] bool is_histories(const NetcdfReader& file);

/// What histories.nc alone tells of a run: of the case its title, units and duration; buildings with names, elevations,
/// periods and shapes; contact points and links without laws; every kept quantity of floors, points, links and impacts;
/// displacements, openings, forces and energies; data for figures.
/// @throws NetcdfError when the file is not what bentur writes.
[[nodiscard]] RunResults read_histories(const NetcdfReader& file);

/// Reads the folder that `bentur run -o` wrote: histories.nc, summary.json, and case.toml where it is there and is the
/// case that the others were made from. With the case's copy the case is whole but for the samples of a record, and so
/// is the problem made from it. Without, the case has title, units, excitation echo, gaps with what their laws worked
/// with, and solver, but no buildings and no code.
/// @throws std::runtime_error naming the file, when one is missing, is not what bentur writes, or is not of the same
/// run.
[[nodiscard]] RunResults read_results(const std::filesystem::path& folder);

}  // namespace bentur
