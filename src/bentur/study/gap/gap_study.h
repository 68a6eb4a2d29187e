#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "bentur/core/diagnostics.h"
#include "bentur/model/case.h"
#include "bentur/model/gap/minimum_gap.h"

namespace bentur {

/// The gap between two neighbours: each number the largest of all levels at which they face one another, or over
/// records the largest or the median of those. NaN where a rule has nothing to go by.
struct GapNeed {
  double gap_needed = 0, abs = 0, srss = 0, ddc = 0;  ///< [length]
  std::vector<double> codes;                          ///< [length], one per rule of [code]
};

struct RecordNeed {
  std::string record;                        ///< what the study calls it
  std::vector<LevelSeparation> separations;  ///< per facing level
  std::vector<GapNeed> gaps;                 ///< per gap
};

/// The gap that a fraction of the records does not exceed.
struct GapQuantile {
  double probability = 0;  ///< that fraction [-]
  GapNeed need;            ///< each number by itself, quantile_of()
};

/// A gap as the case or the study gives it.
struct GivenGap {
  std::vector<std::pair<std::string, std::string>> others;  ///< name and value of what varies the widths
  std::vector<double> widths;  ///< [length], of its contact points, or of its watched floors where it has none
  std::size_t beyond = 0;      ///< records that need more somewhere
};

/// One gap over all records.
struct GapOverRecords {
  GapNeed largest, median;
  std::vector<GapQuantile> quantiles;  ///< ascending
  std::vector<GivenGap> given;         ///< one per choice of widths
};

/// All records of a study with one choice of whatever else varies.
struct RecordNeeds {
  std::vector<std::pair<std::string, std::string>> others;  ///< name and value of what else varies
  std::vector<RecordNeed> records;
  std::vector<GapOverRecords> gaps;
};

struct GapStudy {
  std::string title;
  Units units;
  CodeSpec code;
  Problem problem;           ///< of the first record: places and names
  std::optional<double> at;  ///< with [ida]: intensity that every record is scaled to
  std::string intensity, intensity_unit;
  std::vector<RecordNeeds> needs;
  /// All of them together, each record with each choice of whatever else varies as likely as any other: what is not
  /// known of a building adds to what is not known of the earthquake. Nothing where nothing else varies.
  std::optional<RecordNeeds> together = {};
};

/// Whether a file is a study, which names a case, rather than a case.
[[nodiscard]] bool is_study(const std::filesystem::path& file);

/// The gaps that keep the buildings apart under every record of a study, simulated and by the rules. Widths and
/// contacts that vary do not matter. `at` is for a study with [ida]; by default its highest level. `progress` is called
/// with the fraction done.
/// @return nothing when there is an error, all of which are in `diagnostics`.
/// @throws std::runtime_error with record and reason when the numbers fail.
[[nodiscard]] std::optional<GapStudy> gap_study(const std::filesystem::path& file, std::optional<double> at,
                                                const std::function<void(double)>& progress, Diagnostics& diagnostics);

/// docs/result-files.md
[[nodiscard]] std::string gap_study_json(const GapStudy& study, std::string_view version);

}  // namespace bentur
