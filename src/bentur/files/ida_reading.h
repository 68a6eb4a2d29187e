#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "bentur/core/diagnostics.h"
#include "bentur/files/netcdf.h"
#include "bentur/study/fragility/ida_results.h"

namespace bentur {

/// Whether runs are compared by |value| of a variable, which can have either sign (Quantity::by_size).
[[nodiscard]] bool is_compared_by_size(const NetcdfReader& file, const std::string& variable);

/// Reads the results of an incremental dynamic analysis. The quantity of the event is a variable's name; of those with
/// a building's number also the name without it, for all buildings; `drift` is peak_drift_ratio.
/// @throws NetcdfError when there is no such quantity, or the file does not hold such results.
[[nodiscard]] IdaResults read_ida_results(const NetcdfReader& file, const EventRule& event);

/// The same of a file that is not open, with the event as its user wrote it (`--event`).
/// @return nothing when there is an error, which is in `diagnostics`.
[[nodiscard]] std::optional<IdaResults> read_ida_results(const std::filesystem::path& file, const std::string& event,
                                                         Diagnostics& diagnostics);

}  // namespace bentur
