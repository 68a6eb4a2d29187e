#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "bentur/model/gap/spectral_gap.h"
#include "bentur/model/plan/plan_run.h"
#include "bentur/model/run_results.h"
#include "bentur/model/story/story.h"
#include "bentur/study/gap/gap_study.h"
#include "bentur/study/suite/suite_run.h"

namespace bentur {

/// The least gap between two neighbours, one width at all levels [length].
struct LeastGap {
  std::string name;          ///< what people call the gap
  Eigen::Index left, right;  ///< its buildings
  bool is_facing = false;    ///< whether floors face one another there; else nothing below is known
  double needed = 0;         ///< by the free response or the spectrum, the largest of all levels
  double width = 0;          ///< the same rounded up to three figures: what is to be built
  double given = 0;          ///< the narrowest that the case gives
  bool is_short = false;     ///< the buildings meet in some run, or at some level less is given than is needed there
  bool is_known = true;      ///< what is needed is
  bool is_beside = false;    ///< in plan: it falls short where it does not grow with the gap, which no width mends
  bool is_doubted = false;   ///< something keeps it from being known to be enough
  Sufficiency judged = Sufficiency::enough;  ///< what is given, from all that is known
  bool by_peaks = false;                     ///< of displacements that are given: what both at once need
  std::optional<double> asked = {};          ///< the most that a rule of [code] asks for
  bool others_close = false;  ///< another gap of the row closes: what is needed holds where every gap has its own
};

/// What a case as it stands needs for its buildings to stay apart: the remedy that wants no search.
struct LeastGaps {
  enum class Basis { motion, records, spectrum };

  std::string title;
  Units units;
  std::vector<std::string> buildings;  ///< their names
  Basis basis = Basis::motion;
  long records = 0;                      ///< of a suite
  bool both_ways = false;                ///< of a motion or of records: reversed they need no more
  std::vector<LeastGap> gaps = {};       ///< one per gap
  std::vector<Statement> of_codes = {};  ///< of a suite: what its code takes of the records
};

/// @param run of the case, with what its levels need
[[nodiscard]] LeastGaps least_gaps(const RunResults& run);
[[nodiscard]] LeastGaps least_gaps(const PlanRun& run);
[[nodiscard]] LeastGaps least_gaps(const Case& c, const Problem& problem, const SpectralGaps& spectral);
/// Over all records of a suite. @throws InvalidParameter where some were left out
[[nodiscard]] LeastGaps least_gaps(const SuiteRun& run, const GapStudy& study);

/// What a statement says of each gap, and how other remedies are sought.
[[nodiscard]] Story least_gap_story(const LeastGaps& found);
/// docs/result-files.md, "bentur remedy --json"
[[nodiscard]] std::string least_gap_json(const LeastGaps& found, std::string_view version);

/// x ≥ 0 rounded up to three figures; never below x.
[[nodiscard]] double rounded_up(double x);

}  // namespace bentur
