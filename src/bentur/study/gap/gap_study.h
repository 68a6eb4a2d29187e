#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "bentur/core/diagnostics.h"
#include "bentur/model/case.h"
#include "bentur/model/gap/minimum_gap.h"
#include "bentur/model/story/study_story.h"
#include "bentur/model/suite/suite.h"

namespace bentur {

/// The gap between two neighbours: each number the largest of all levels at which they face one another, or over
/// records the largest or the median of those. NaN where a rule has nothing to go by.
/// Infinite is what a record needs under which a building collapses without contact.
struct GapNeed {
  double gap_needed = 0, abs = 0, srss = 0, ddc = 0;  ///< [length]
  std::vector<double> codes;                          ///< [length], one per rule of [code]
};

struct RecordNeed {
  std::string record;                        ///< what the study calls it
  std::size_t motion = 0;                    ///< which record it is, whichever way it is applied
  std::optional<double> intensity = {};      ///< of a cloud [its unit]
  bool falls = false;                        ///< falls_without_contact()
  std::uint64_t open = 0;                    ///< open_needs(), of both ways where these are taken
  std::vector<LevelSeparation> separations;  ///< per facing level
  std::vector<double> to_come;               ///< likewise what may still come after the end [length]
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
  OpenNeeds open = {};         ///< other records, of which it is not known whether they do

  /// The smallest width [length]; nothing where no floors face one another.
  [[nodiscard]] std::optional<double> narrowest() const {
    return widths.empty() ? std::nullopt : std::optional(*std::min_element(widths.begin(), widths.end()));
  }
};

/// What a code takes of the records of a suite.
struct SuiteDemand {
  SuiteMeasure measure;
  long collapsed = 0;  ///< records under which a building collapses: then neither mean nor largest is known
  double mean = 0,
         largest = 0;    ///< over the records, the larger of both ways of each; the largest of all levels [length]
  double elevation = 0;  ///< of the level where what is taken is the largest [length]
  std::vector<double> codes = {};  ///< per rule of [code]: its mean or largest [length]
  bool is_short = false;           ///< what is taken is more than what is given at some level

  [[nodiscard]] bool is_known() const { return measure.kind != SuiteMeasure::Kind::too_few && collapsed == 0; }
  /// What the code takes [length].
  [[nodiscard]] double taken() const { return measure.kind == SuiteMeasure::Kind::mean ? mean : largest; }
};

/// What a rule of [code] asks of all records together: their mean where a code that scales them takes it, else the
/// largest. Of the level that it asks most for beyond what is given.
struct RuleOverRecords {
  std::string rule, title;  ///< as CodeRule has them
  double asked = 0;         ///< [length]; NaN: not known
  double elevation = 0;     ///< of the level [length]
  double width = 0;         ///< given there [length]
  bool takes_mean = false;
  bool is_short = false;  ///< more than is given
  bool too_few = false;   ///< a code scales the records that takes nothing of so few
};

/// One gap over all records.
struct GapOverRecords {
  GapNeed largest, median;
  GapNeed mean;                        ///< each number by itself; NaN where one is not known
  std::vector<GapQuantile> quantiles;  ///< ascending
  std::vector<GivenGap> given;         ///< one per choice of widths; none where what else varies changes them
  /// Of a suite that a code scales, where records are applied as it scales them and one width is given.
  std::optional<SuiteDemand> demand = {};
  std::vector<RuleOverRecords> rules = {};  ///< one per rule of [code]; none where several widths are given
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
  std::vector<std::string> buildings;  ///< their names
  /// A gap: what people call it, and which buildings it is between.
  struct Between {
    std::string name;
    Eigen::Index left = 0, right = 0;
  };
  std::vector<Between> gaps;
  bool in_plan = false;
  std::optional<double> at;               ///< with [ida]: intensity that every record is scaled to
  std::string intensity, intensity_unit;  ///< with [ida]
  std::vector<RecordNeeds> needs;
  /// All of them together, each record with each choice of whatever else varies as likely as any other: what is not
  /// known of a building adds to what is not known of the earthquake. Nothing where nothing else varies.
  std::optional<RecordNeeds> together = {};
  std::shared_ptr<const SuiteSpec> suite = {};  ///< of a case with a suite of records
  /// Whether each number of a record is the larger one of both directions: of a suite, unless analysis.both_ways is off
  /// or the study varies the polarity.
  bool of_either_way = false;
  /// Whether all motions act in one direction alone though the case looks at both: reversed they can need more.
  bool is_one_way = false;
  long asked = 0;  ///< records, with every choice of what else varies; fewer are done where it was stopped
  long done = 0;

  [[nodiscard]] bool is_whole() const { return done == asked; }
};

/// Whether a file is a study, which names a case, rather than a case.
[[nodiscard]] bool is_study(const std::filesystem::path& file);

/// The gaps that keep the buildings apart under every record of a study, simulated and by the rules. Widths and
/// contacts that vary do not matter. `at` is for a study with [ida] and levels; by default the highest. `progress` is
/// called with the fraction done; where it answers false the rest of the records is left out.
/// @return nothing when there is an error, all of which are in `diagnostics`.
/// @throws std::runtime_error with record and reason when the numbers fail.
[[nodiscard]] std::optional<GapStudy> gap_study(const std::filesystem::path& file, std::optional<double> at,
                                                const std::function<bool(double)>& progress, Diagnostics& diagnostics);

/// The same over the suite of a case, as it has been read from `file`.
[[nodiscard]] std::optional<GapStudy> gap_study(const Case& c, const std::filesystem::path& file,
                                                const std::function<bool(double)>& progress, Diagnostics& diagnostics);

/// docs/result-files.md @param said a JSON object of what is said in place of gap_study_story(); empty: that
[[nodiscard]] std::string gap_study_json(const GapStudy& study, std::string_view version, std::string_view said = {});

}  // namespace bentur
