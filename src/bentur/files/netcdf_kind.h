#pragma once

#include <filesystem>

#include "bentur/io/output/result_kind.h"

namespace bentur {

/// Whether a file is one of NetCDF that bentur has written, of this kind: for OutputRules::is_netcdf.
[[nodiscard]] bool is_netcdf_result(const std::filesystem::path& file, ResultKind kind);

}  // namespace bentur
