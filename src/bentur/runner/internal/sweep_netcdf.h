#pragma once

#include <filesystem>
#include <string>

#include "bentur/runner/sweep.h"
#include "bentur/study/journal.h"
#include "bentur/study/study_runs.h"

namespace bentur {

/// Writes the results of all runs as NetCDF-4 (docs/studies.md), some at a time. The same results give the same bytes.
/// @throws std::runtime_error with the file and the reason.
SweepTotals write_sweep_netcdf(const std::filesystem::path& file, const StudyRuns& runs, const Journal& journal,
                               const std::string& version);

}  // namespace bentur
