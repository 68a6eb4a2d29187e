#pragma once

#include <filesystem>
#include <functional>
#include <stdexcept>
#include <vector>

#include "bentur/io/output/result_kind.h"

namespace bentur {

/// Writing there would harm something; the message names the place, says why, and what to do. Nothing was written.
class RefusedOutput : public std::runtime_error {
 public:
  RefusedOutput(const std::filesystem::path& place, const std::string& why)
      : std::runtime_error(place.string() + ": not written: " + why) {}
};

/// What the outputs of one call must not touch (docs/result-files.md, "What is never overwritten").
struct OutputRules {
  std::vector<std::filesystem::path> inputs = {};  ///< files that this call reads
  bool force = false;                              ///< files that are not results of the same kind may be replaced
  /// Knows results of NetCDF; without it none is known (files/netcdf_kind.h).
  std::function<bool(const std::filesystem::path&, ResultKind)> is_netcdf = {};
  const char* forced_by = "--force";  ///< what a user says for `force`

  /// Whether `file` is one of the inputs: by device and inode, so that links of either sort are seen through.
  [[nodiscard]] bool is_input(const std::filesystem::path& file) const;
};

/// The regular file that a result written to `path` makes or replaces: `path`, or what it links to.
/// @throws RefusedOutput when that is a folder, a device, a pipe or a socket; an input; a file that is neither empty
/// nor a result of the same kind, or write-protected, unless forced.
[[nodiscard]] std::filesystem::path output_target(const std::filesystem::path& path, ResultKind kind,
                                                  const OutputRules& rules);

}  // namespace bentur
