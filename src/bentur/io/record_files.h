#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "bentur/core/diagnostics.h"

namespace bentur {

/// Numbers as they stand in a strong-motion file, before any unit or scaling.
struct Record {
  std::string format;    ///< peer-at2 two-column one-column
  std::string unit;      ///< "g" where the file says so (peer-at2), else empty
  double time_step = 0;  ///< [s]
  std::vector<double> values;
};

struct RecordOptions {
  std::string format = "auto";      ///< auto peer-at2 two-column one-column
  std::optional<double> time_step;  ///< [s], where the file does not say (one-column)
  std::optional<int> column;        ///< 1-based column of the accelerations; needed where a file has more than two
  /// What messages call these.
  std::string time_step_name = "excitation.time_step", column_name = "excitation.column";
};

/// Reads a record (docs/record-files.md). What is wrong goes to `diagnostics` with the record file's line and column.
[[nodiscard]] std::optional<Record> read_record(const std::filesystem::path& file, const RecordOptions& options,
                                                Diagnostics& diagnostics);

}  // namespace bentur
