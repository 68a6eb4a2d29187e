#pragma once

#include <filesystem>

#include "bentur/model/run_results.h"

namespace bentur {

/// Reads the folder that `bentur run -o` wrote: histories.nc, summary.json, and case.toml where it is there and is the
/// case that the others were made from. With the case's copy the case is whole but for the samples of a record, and so
/// is the problem made from it. Without, the case has title, units, excitation echo, gaps with what their laws worked
/// with, and solver, but no buildings and no code.
/// @throws std::runtime_error naming the file, when one is missing, is not what bentur writes, or is not of the same
/// run.
[[nodiscard]] RunResults read_results(const std::filesystem::path& folder);

}  // namespace bentur
