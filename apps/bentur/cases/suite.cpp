#include "cases/suite.h"

#include <fmt/format.h>

#include <utility>

#include "bentur/core/errors.h"
#include "bentur/core/number_text.h"
#include "bentur/report/errors.h"

namespace bentur::cli {

Loaded record_of(Loaded loaded, int number, const std::string& language) {
  const auto refuse = [&](const std::string& why) { throw Failure(exit_bad_input, error_words(why, language)); };
  const auto& suite = loaded.c.excitation.suite;
  if (!suite) refuse("--record is for a case with excitation.kind = \"suite\"");
  const auto count = static_cast<int>(suite->records.size());
  if (number > count) refuse(fmt::format("--record {}: the suite has {} records", number, count));
  loaded.c = case_of_record(loaded.c, static_cast<std::size_t>(number - 1));
  if (loaded.c.is_in_plan()) {
    loaded.plan = make_plan_problem(loaded.c, std::move(loaded.plan.buildings));
  } else {
    loaded.problem = make_problem(loaded.c, std::move(loaded.problem.buildings));
  }
  return loaded;
}

Loaded load_for_run(const std::string& file, std::optional<int> record, const std::string& language) {
  Loaded loaded = load(file, language);
  if (record) return record_of(std::move(loaded), *record, language);
  Diagnostics found;
  if (loaded.c.excitation.spectrum && refuse_without_motion(loaded.c, found)) throw Failure(found, language);
  return loaded;
}

SuiteRun run_records(const Loaded& loaded, bool progress, const std::string& language) {
  const StopOnSignal stop;
  Progress display("of the records simulated");
  SuiteRun run = run_suite(loaded.c, [&](double fraction) {
    if (progress) display.show(fraction);
    return !StopOnSignal::asked();
  });
  if (run.records.empty()) throw Failure(exit_other, error_words("Stopped before the first record was done", language));
  return run;
}

GapStudy gaps_over_records(const Loaded& loaded, const std::string& file, const std::string& language) {
  const StopOnSignal stop;
  Diagnostics diagnostics;
  Progress display("of the records");
  const auto goes_on = [&](double fraction) {
    display.show(fraction);
    return !StopOnSignal::asked();
  };
  std::optional<GapStudy> study;
  try {
    study = gap_study(loaded.c, file, goes_on, diagnostics);
  } catch (const std::runtime_error& error) {
    throw Failure(exit_numbers_failed, error_words(std::string("the numbers failed: ") + error.what(), language));
  }
  if (!study) throw Failure(diagnostics, language);
  return *std::move(study);
}

std::string suite_line(const SuiteSpec& suite, const Words& say) {
  const auto [first, last] = suite.target.band();
  return say("suite.line", {{"records", say.count("story.count.records", std::ssize(suite.records))},
                            {"scale", suite.request.scale},
                            {"target", suite.target.file.empty() ? suite.target.shape : suite.target.file},
                            {"from", number(first)},
                            {"to", number(last)}});
}

}  // namespace bentur::cli
