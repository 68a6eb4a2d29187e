#pragma once

#include <filesystem>

#include "bentur/files/netcdf.h"
#include "bentur/model/plan/any_run.h"

namespace bentur {

/// Reads the folder that `bentur run -o` wrote: histories.nc, summary.json, and case.toml where it is there and is the
/// case that the others were made from. With the case's copy the case is whole but for the samples of a record, and so
/// is the problem made from it. Without, the case has title, units, excitation echo, gaps with what their laws worked
/// with, and solver, but no buildings and no code.
/// @throws std::runtime_error naming the file, when one is missing, is not what bentur writes, or is not of the same
/// run.
[[nodiscard]] RunResults read_results(const std::filesystem::path& folder);

/// The same of buildings in plan, whose case.toml must be there: it says where they stand.
[[nodiscard]] PlanRun read_plan_results(const std::filesystem::path& folder);

/// What histories.nc is of, a row or buildings in plan, with the other files that stand beside it; of a row they need
/// not. @throws std::runtime_error as read_results()
[[nodiscard]] AnyRun read_any_results(const NetcdfReader& histories);
/// Whether a file is histories.nc of either.
[[nodiscard]] bool is_any_run(const NetcdfReader& results);

}  // namespace bentur
