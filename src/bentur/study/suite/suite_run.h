#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "bentur/model/story/judgement_story.h"
#include "bentur/model/suite/suite.h"
#include "bentur/pounding/response.h"
#include "bentur/study/gap/gap_study.h"

namespace bentur {

/// A number that is reported of each record: the largest of all places, or of counts their sum.
struct SuiteQuantity {
  std::string name;              ///< as studies have it: "peak_force", "peak_drift_ratio_1"
  std::string units, long_name;  ///< as UDUNITS reads them; in words
};

/// The run of one record.
struct SuiteRecordRun {
  Status status = Status::done;
  std::string message = {};                ///< why it failed
  std::vector<double> values;              ///< one per quantity; NaN: not known. A gap needed is that of both ways
  std::vector<double> modelled = {};       ///< likewise, with counts and forces of what is modelled, where not all is
  std::vector<Statement> statements = {};  ///< run_story() of it
  std::vector<ToldJudgement> judged = {};  ///< per gap
  /// Per gap what it needs somewhere, the larger of both ways of the motion [length]; infinite where a building falls
  /// without contact.
  std::vector<double> needed = {};
  std::vector<bool> is_of_reversed = {};  ///< per gap whether that is what the motion times −1 needs

  /// Whether floors meet where no contact is modelled, so that impacts and forces are not known.
  [[nodiscard]] bool is_not_modelled() const;
};

/// The runs of a case's suite, in short; case_of_record() gives one of them in full.
struct SuiteRun {
  Case c;
  Problem problem;                       ///< without a motion; of buildings in plan row_of() theirs
  std::optional<PlanProblem> plan = {};  ///< of those
  std::vector<SuiteQuantity> quantities;
  std::vector<SuiteRecordRun> records;  ///< in the suite's order; fewer where it was stopped

  [[nodiscard]] bool is_whole() const { return records.size() == c.excitation.suite->records.size(); }
  /// Whether each record has been run to its end, or to a collapse.
  [[nodiscard]] bool all_ran() const;
  /// Of a quantity over all records; NaN unless each of them has it and ended in its time.
  [[nodiscard]] double mean(std::size_t quantity) const;
  /// Over those that have it; NaN where none has.
  [[nodiscard]] double largest(std::size_t quantity) const;
};

/// Runs a case with each record of its suite. @param progress gets the fraction done; where it answers false the rest
/// is left out. @throws InvalidParameter unless the case has a suite.
[[nodiscard]] SuiteRun run_suite(const Case& c, const std::function<bool(double)>& progress);

/// A gap under all records that were run, with what rules ask of them together.
struct SuiteJudgement {
  JudgementOfMany many;
  std::vector<Reason> of_rules;
  bool alone = false;  ///< what it needs is needed if no other gap closed, as one does under some record
};
/// One per gap. @param gaps of the same records
[[nodiscard]] std::vector<SuiteJudgement> judged_gaps(const SuiteRun& run, const GapStudy& gaps);

/// A word a record for how a gap does under it, but for what rules ask: "enough" is said where it is under all records,
/// by all that is known; else of such a record that it asks for less.
[[nodiscard]] std::vector<const char*> record_words(const SuiteRun& run, std::size_t gap);

/// What is said of a suite at every door: the union of what its records say, each gap as it is judged from all of them,
/// what the code and its rules take of them, the suite as it is scaled; a table with a row a record, their mean and
/// their largest, and tables of the gaps. @param gaps of the same records
[[nodiscard]] Story suite_story(const SuiteRun& run, const GapStudy& gaps);

/// docs/suites.md
[[nodiscard]] std::string suite_run_json(const SuiteRun& run, const GapStudy& gaps, std::string_view version);
/// "statements" and "judgements" of the gaps of a suite, one JSON object.
[[nodiscard]] std::string suite_said_json(const SuiteRun& run, const GapStudy& gaps);

}  // namespace bentur
