#pragma once

#include <string>
#include <vector>

#include "bentur/study/suite/suite_run.h"

// What is said of the gaps of a suite.
namespace bentur {

/// The buildings of a gap.
[[nodiscard]] std::vector<std::string> names_across(const Problem& problem, Eigen::Index gap);

/// What is said of a gap under all records.
[[nodiscard]] std::vector<Statement> told_of(const SuiteRun& run, Eigen::Index gap, const SuiteJudgement& judged);

/// Of several gaps how many are too small.
[[nodiscard]] Statement counted_over_records(const std::vector<SuiteJudgement>& judged);
/// A row a gap: how it is judged, under how many records it is too small, what it needs.
[[nodiscard]] StoryTable table_over_records(const SuiteRun& run, const std::vector<SuiteJudgement>& judged,
                                            const GapStudy& gaps);

/// What many records say of a gap, without what sentences of its own have said already, and what a table says as well.
void say_once(std::vector<Statement>& statements);

}  // namespace bentur
