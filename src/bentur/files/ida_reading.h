#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "bentur/core/diagnostics.h"
#include "bentur/study/fragility/ida_results.h"

namespace bentur {

/// read_ida_results() of a file, for the event as its user wrote it (`--event`).
/// @return nothing when there is an error, which is in `diagnostics`.
[[nodiscard]] std::optional<IdaResults> read_ida_results(const std::filesystem::path& file, const std::string& event,
                                                         Diagnostics& diagnostics);

}  // namespace bentur
