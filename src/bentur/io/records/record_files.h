#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "bentur/core/diagnostics.h"
#include "bentur/model/case.h"

namespace bentur {

/// Accelerations as a strong-motion file has them, before any unit or scaling.
struct StrongMotionRecord {
  std::string format;          ///< one of record_formats(), but for auto and csv
  std::string unit;            ///< as acceleration_units(), where the file says it; else empty
  double time_step = 0;        ///< [s]
  std::vector<double> values;  ///< [unit]
  int header_lines = 0;        ///< of the channel, before its first value; of plain columns without comments and blanks
  std::string channel;         ///< which one of several, as "channel 2 of 3 (Chan 2: 360 Deg)"; else empty
  double mean_removed = 0;     ///< [unit] taken off all values; 0 but for K-NET
  std::string event = {};      ///< the earthquake, in capitals, where a PEER file or one of ./dev records says it
  std::string component = {};  ///< its name, where a file of one says it, as "N-S"
  int unit_line = 0;           ///< of the file, where it says its unit; 0: not known
  int step_line = 0;           ///< where it says its step
};

struct RecordOptions {
  std::string format = "auto";           ///< one of record_formats()
  std::optional<double> time_step = {};  ///< [s], where the file does not say it
  std::optional<int> column = {};        ///< from 1: of the accelerations, where a file has several columns
  std::optional<int> channel = {};  ///< from 1: which of the file's channels of accelerations, where it has several
  std::optional<std::string> component = {};  ///< the channel or column by its name, as "N-S"
  std::string unit = {};    ///< one of acceleration_units(), where the user says it: held against the file
  int skip_lines = 0;       ///< lines to pass over at the beginning
  bool of_command = false;  ///< messages call these --time-step and so on, not excitation.time_step

  /// `excitation.format`, or `--format`.
  [[nodiscard]] std::string name(const std::string& key) const;
  /// `excitation.format = "values"`, or `--format values`.
  [[nodiscard]] std::string setting(const std::string& key, const std::string& value) const;
};

/// What a user says of a record otherwise than its file.
struct RecordContradiction {
  std::string key;    ///< time_step or unit
  std::string given;  ///< by the user, as "0.01 s"
  std::string said;   ///< by the file, as "0.005 s in line 12"
  int line = 0;       ///< of the file; 0: not known
};
/// Steps that differ by more than rounding, 1 %, and units.
[[nodiscard]] std::vector<RecordContradiction> contradictions(const StrongMotionRecord& record,
                                                              const RecordOptions& options);

/// auto peer-at2 two-column one-column values csv cosmos csmip bhrc geonet smc knet knet-csv esm afad asa
[[nodiscard]] const std::vector<std::string>& record_formats();

/// Reads a record (docs/record-files.md). What is wrong goes to `diagnostics` with the record file's line and column.
/// @return two values or more, or nothing where there was an error.
[[nodiscard]] std::optional<StrongMotionRecord> read_record(const std::filesystem::path& file,
                                                            const RecordOptions& options, Diagnostics& diagnostics);
/// The same of the bytes of one, which messages call `name`.
[[nodiscard]] std::optional<StrongMotionRecord> record_of(std::string bytes, const std::string& name,
                                                          const RecordOptions& options, Diagnostics& diagnostics);

/// What was read, as users see it; `unit` is the file's own or the one that the user gives. Not yet scaled: pga 0.
[[nodiscard]] RecordEcho echo_of(const StrongMotionRecord& record, const std::string& file, const std::string& unit);

/// What is worth saying beside format and unit, each after a comma: ", channel 2 of 3 (Chan 2: 360 Deg), 46 header
/// lines, mean 0.12 cm/s2 removed".
[[nodiscard]] std::string echo_notes(const RecordEcho& echo);

}  // namespace bentur
