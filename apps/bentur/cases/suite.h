#pragma once

#include <optional>
#include <string>

#include "bentur/study/gap/gap_study.h"
#include "bentur/study/suite/suite_run.h"
#include "session.h"

namespace bentur::cli {

/// The case with one record of its suite, counted from 1. @throws Failure where it has no suite, or none of that
/// number.
[[nodiscard]] Loaded record_of(Loaded loaded, int number, const std::string& language);

/// A case for a run or a report: `record` picks one of a suite. @throws Failure as load(), and where the case has a
/// spectrum; of a suite without `record` it has many motions.
[[nodiscard]] Loaded load_for_run(const std::string& file, std::optional<int> record, const std::string& language);

/// Runs all records of a suite, and finds the gaps over them; work of more than two seconds shows how far it is, and
/// Ctrl-C ends it with what is done. @throws Failure when nothing is done, or the numbers fail.
[[nodiscard]] SuiteRun run_records(const Loaded& loaded, bool progress, const std::string& language);
[[nodiscard]] GapStudy gaps_over_records(const Loaded& loaded, const std::string& file, const std::string& language);

/// The line on what shakes the buildings.
[[nodiscard]] std::string suite_line(const SuiteSpec& suite, const Words& say);

}  // namespace bentur::cli
