#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bentur/model/plan/plan_run.h"
#include "bentur/model/story/story.h"

namespace bentur {

/// What a report that is handed in says beside its verdict.
struct HandIn {
  std::vector<Statement> assumptions;  ///< that the numbers rest on
  /// Every check with what is needed and what is given, in the order of ASCE 7-16 (12.8.7 stability, 12.12.1 drift,
  /// 12.12.3 separation), before them members, after them rules of thumb and what the program checks of itself.
  StoryTable checks;
  std::vector<Statement> unchecked;  ///< what nobody has looked at, each with what would be needed for it
};

/// A check of which someone else has the numbers, such as what a code takes of many records.
struct CheckRow {
  std::string check;                    ///< a word of the catalogue, or the name of a rule
  std::string by;                       ///< a key of the case, a clause or a publication; a word of the catalogue
  std::string where;                    ///< buildings or a gap
  std::optional<double> demand, limit;  ///< [unit]; nothing: not known, or there is none
  std::string unit;
  std::string result = {};  ///< a word of why it is not known; empty: it is met, or not
  bool is_met = false;
};

/// Of a run.
[[nodiscard]] HandIn hand_in(const RunResults& run);
/// Of buildings in plan.
[[nodiscard]] HandIn hand_in(const PlanRun& run);
/// Of gaps by a spectrum.
[[nodiscard]] HandIn hand_in(const Case& c, const Problem& problem, const SpectralGaps& spectral);
/// Of a case with a suite of records. @param of_records the checks over them, in the order above
[[nodiscard]] HandIn hand_in(const Case& c, const Problem& problem, const std::vector<CheckRow>& of_records);
[[nodiscard]] HandIn hand_in(const Case& c, const PlanProblem& problem, const std::vector<CheckRow>& of_records);

}  // namespace bentur
