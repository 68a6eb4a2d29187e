// Of a case with a suite: all of its records in short, or one of them.
#include <emscripten/val.h>

#include <algorithm>
#include <filesystem>
#include <limits>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "bentur/core/diagnostics.h"
#include "bentur/model/limits.h"
#include "bentur/model/story/story.h"
#include "bentur/model/suite/suite.h"
#include "bentur/pounding/pounding.h"
#include "bentur/report/html/page_parts.h"
#include "bentur/report/html/suite_report.h"
#include "bentur/report/kinds/kinds.h"
#include "shell.h"
#include "shell_answers.h"

namespace bentur::web {
namespace {

/// Where one of the records alone is more than a page takes, what is. Their sum is the user's to wait for.
/// @param with_motion the problem of a case of one record
template <class WithMotion>
std::optional<Json> too_large_record(const Case& c, const WithMotion& with_motion) {
  for (std::size_t i = 0; i < c.excitation.suite->records.size(); ++i) {
    const Case one = case_of_record(c, i);
    const auto problem = with_motion(one);
    SolveOptions options = solve_options(one);
    options.levels = options.both_ways = options.energy_audit = false;  // as run_suite()
    if (std::optional<Json> answer = beyond_page(effort(problem, one.analysis.solver, options))) return answer;
  }
  return std::nullopt;
}

/// The record to look at first, from 1: the one of the hardest impact that is told, else the one that comes closest.
/// @param gaps with their widths
std::size_t hardest_record(const SuiteRun& run, const Story& story, const Json& gaps) {
  const std::vector<SuiteRecord>& records = run.c.excitation.suite->records;
  if (const Statement* const hardest = hardest_impact_of(story.statements); hardest != nullptr && hardest->many) {
    const auto named = [&](const SuiteRecord& one) { return one.name() == hardest->many->worst; };
    const auto found = std::find_if(records.begin(), records.end(), named);
    if (found != records.end()) return static_cast<std::size_t>(found - records.begin()) + 1;
  }
  std::size_t closest = 1;
  double most = -std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < run.records.size(); ++i) {
    const std::vector<double>& needed = run.records[i].needed;
    for (std::size_t g = 0; g < needed.size(); ++g) {
      const double beyond = needed[g] - gaps.at(g).at("width").get<double>();
      if (beyond > most) std::tie(most, closest) = std::pair(beyond, i + 1);
    }
  }
  return closest;
}

}  // namespace

Json suite_choice(const SuiteSpec& suite, std::size_t record) {
  Json names = Json::array();
  for (const SuiteRecord& one : suite.records) names.push_back(one.name());
  return {{"records", std::move(names)}, {"record", record}};
}

std::string Studio::choose_record(int number) {
  return guarded([&]() -> Json {
    const std::size_t count = suite_ ? suite_->records.size() : 0;
    if (case_ && case_->excitation.suite && number > 0 && static_cast<std::size_t>(number) <= count) {
      Case one = case_of_record(*case_, static_cast<std::size_t>(number - 1));
      if (plan_) {
        plan_ = make_plan_problem(one, std::move(plan_->buildings));
      } else {
        problem_ = make_problem(one, std::move(problem_->buildings));
      }
      case_ = std::move(one);
      record_ = static_cast<std::size_t>(number);
    }
    return {{"ok", true}, {"errors", Json::array()}, {"record", record_}, {"records", count}};
  });
}

Json Studio::solve_suite(const emscripten::val& progress) {
  const std::optional<Json> too_large =
      plan_ ? too_large_record(*case_, [&](const Case& one) { return make_plan_problem(one, plan_->buildings); })
            : too_large_record(*case_, [&](const Case& one) { return make_problem(one, problem_->buildings); });
  if (too_large) return *too_large;
  const auto told = [&](double done) { return progress.isNull() || progress(done).template as<bool>(); };
  SuiteRun run = run_suite(*case_, [&](double done) { return told(done / 2); });
  if (!run.is_whole()) return failure("stopped");
  const std::filesystem::path file = std::filesystem::path(case_folder) / "cases" / case_->source->file;
  Diagnostics diagnostics;
  std::optional<GapStudy> gaps;
  try {
    gaps = gap_study(
        *case_, file, [&](double done) { return told((1 + done) / 2); }, diagnostics);
  } catch (const std::runtime_error& error) {
    return failure(std::string("the numbers failed: ") + error.what());
  }
  if (!gaps) {
    Json errors = Json::array();
    for (const Diagnostic& one : diagnostics.errors()) errors.push_back(error_of(one));
    return {{"ok", false}, {"errors", errors}};
  }
  if (!gaps->is_whole()) return failure("stopped");
  suite_run_ = std::move(run);
  suite_gaps_ = std::move(gaps);
  return {{"ok", true}, {"errors", Json::array()}, {"seconds", 0}};
}

Json Studio::suite_overview(const Words& say) const {
  const RecordNeeds& needs = suite_gaps_->needs.front();
  const bool collapses =
      std::any_of(needs.records.begin(), needs.records.end(), [](const RecordNeed& one) { return one.falls; });
  Json gaps = Json::array();
  std::vector<std::string> names;
  for (std::size_t g = 0; g < suite_gaps_->gaps.size(); ++g) {
    const GapOverRecords& over = needs.gaps[g];
    names.push_back(suite_gaps_->gaps[g].name);
    Json marks = Json::array();
    if (over.demand && over.demand->is_known() && over.demand->measure.kind == SuiteMeasure::Kind::mean) {
      marks.push_back({{"at", over.demand->mean}, {"name", say("slider.needed_mean")}});
    }
    gaps.push_back({{"name", names.back()},
                    {"width", over.given.front().narrowest().value_or(0)},
                    {"needed", collapses ? Json() : number_or_null(over.largest.gap_needed)},
                    {"needed_name", say("slider.needed_largest")},
                    {"marks", std::move(marks)}});
  }
  double longest = 0;
  for (const SuiteRecord& one : suite_->records) {
    longest = std::max(longest, suite_->duration.value_or(one.echo.duration));
  }
  const Story story = suite_story(*suite_run_, *suite_gaps_);
  Json all = overview_of(case_->title, case_->units, longest, gaps, names, story, say);
  all["spectral"] = false;
  all["suite"] = suite_choice(*suite_, 0);
  all["suite"]["hardest"] = hardest_record(*suite_run_, story, gaps);
  Json& figures = all["figures"] = Json::array();
  for (const FigureKind& one : figure_kinds(*suite_run_)) {
    figures.push_back(
        {{"kind", one.name}, {"caption", say(caption_key(one.name, false))}, {"tells", true}, {"overTime", false}});
  }
  return all;
}

}  // namespace bentur::web
