#include "bentur/files/ida_reading.h"

#include <fmt/format.h>

#include "bentur/files/netcdf.h"
#include "bentur/io/toml/toml_view.h"

namespace bentur {

std::optional<IdaResults> read_ida_results(const std::filesystem::path& file, const std::string& event,
                                           Diagnostics& diagnostics) {
  std::string error;
  try {
    if (const auto rule = parse_event(event, error)) return read_ida_results(NetcdfReader(file), *rule);
    error = fmt::format("--event {} {}", in_quotes(event), error);
  } catch (const NetcdfError& failure) {
    error = failure.reason;
  }
  diagnostics.error({file.string(), 0, 0}, error);
  return std::nullopt;
}

}  // namespace bentur
