#include "bentur/study/suite/suite_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <nlohmann/json.hpp>

#include "bentur/core/errors.h"
#include "bentur/core/number_text.h"
#include "bentur/io/results/story_json.h"
#include "bentur/io/results/suite_json.h"
#include "bentur/model/limits.h"
#include "bentur/model/plan/plan_row.h"
#include "bentur/model/quantity_row.h"
#include "bentur/model/suite/suite_story.h"
#include "bentur/pounding/pounding.h"
#include "bentur/study/gap/gap_study_story.h"
#include "bentur/study/suite/internal/suite_gaps.h"

namespace bentur {
namespace {

using Json = nlohmann::ordered_json;

/// What is told of each record, where the case has it.
constexpr std::string_view told_of_records[] = {"impacts",
                                                "peak_force",
                                                "gap_needed",
                                                "unmodelled_contacts",
                                                "peak_drift_ratio",
                                                "peak_acceleration",
                                                "peak_acceleration_x",
                                                "peak_acceleration_y",
                                                "peak_storey_shear",
                                                "peak_storey_shear_x",
                                                "peak_storey_shear_y",
                                                "base_shear_coefficient",
                                                "base_shear_coefficient_x",
                                                "base_shear_coefficient_y",
                                                "amplification",
                                                "amplification_x",
                                                "amplification_y",
                                                "amplification_rotation",
                                                "ductility",
                                                "column_demand_capacity",
                                                "peak_compression",
                                                "link_peak_tension"};

bool is_told_of_records(const RowPart& part) {
  const auto is_it = [&](std::string_view name) {
    return name == file_name(*part.quantity) || name == part.quantity->key;
  };
  const bool is_link = part.owner == Owner::link;
  const bool is_point_tension = part.quantity->key == "peak_tension" && !is_link;
  return part.count > 0 && !is_point_tension &&
         std::any_of(std::begin(told_of_records), std::end(told_of_records), is_it);
}

/// One number of all places of a part.
double reduced(const RowPart& part, const std::vector<double>& row) {
  const bool is_count = is_whole(*part.quantity);
  double result = NAN;
  for (std::size_t i = part.first; i < part.first + static_cast<std::size_t>(part.count); ++i) {
    const double value = part.quantity->by_size ? std::abs(row[i]) : row[i];
    if (std::isnan(value)) continue;
    if (std::isnan(result)) {
      result = value;
    } else {
      result = is_count ? result + value : std::max(result, value);
    }
  }
  return result;
}

/// The gap that a run needs at these levels, the larger of both ways of the motion.
struct NeedOfRun {
  double gap = 0;            ///< [length]; infinite where a building falls without contact
  bool is_reversed = false;  ///< under the motion times −1
};

/// @param row the run, of buildings in plan row_of() it
NeedOfRun need_of(const RunResults& row, const std::vector<LevelSeparation>& levels) {
  constexpr double falls = std::numeric_limits<double>::infinity();
  if (falls_without_contact(row.problem, row.response)) return {falls, false};
  if (falls_without_contact_reversed(row.problem, row.response)) return {falls, true};
  const LevelSeparation largest = largest_of(levels);
  const double reversed = largest.gap_needed_reversed.value_or(0);
  return reversed > largest.gap_needed ? NeedOfRun{reversed, true} : NeedOfRun{largest.gap_needed, false};
}

/// What stands in the table, of buildings the largest of all.
constexpr std::string_view told_in_tables[] = {"impacts",          "peak_force", "gap_needed",
                                               "peak_drift_ratio", "ductility",  "column_demand_capacity"};

bool is_of_unmodelled(const Statement& said) { return said.kind == "unmodelled"; }

bool any_is_not_modelled(const SuiteRun& run) {
  return std::any_of(run.records.begin(), run.records.end(), std::mem_fn(&SuiteRecordRun::is_not_modelled));
}

/// Counts as such; where some contact is not modelled no mean, and no less than the largest of other records.
void tell_in_words(const SuiteRun& run, bool are_counts, StoryColumn& column) {
  const std::size_t count = run.records.size();
  const bool lacks = any_is_not_modelled(run);
  if (!are_counts && !lacks) return;
  if (lacks) column.label += "_modelled";
  for (std::size_t i = 0; i < column.numbers.size(); ++i) {
    const double value = column.numbers[i];
    if (std::isnan(value) || (i == count && lacks) || (i > count && lacks && value == 0)) {
      column.texts.emplace_back("–");
    } else {
      const bool is_whole = are_counts && i != count;
      column.texts.push_back((i > count && lacks ? "≥ " : "") +
                             (is_whole ? fmt::format("{:.0f}", value) : number(value)));
    }
  }
  column.are_words = column.are_counts = true;
}

/// A column of a quantity; without numbers where the case has none of it.
StoryColumn column_of(const SuiteRun& run, std::string_view key) {
  StoryColumn column{.label = "column.suite." + std::string(key)};
  const auto raise = [](double& value, double other) {
    if (std::isnan(value) || other > value) value = other;
  };
  for (std::size_t q = 0; q < run.quantities.size(); ++q) {
    const std::string& name = run.quantities[q].name;
    if (!name.starts_with(key) || name.find_first_not_of("_0123456789", key.size()) != std::string::npos) continue;
    if (column.numbers.empty()) column.numbers.assign(run.records.size() + 2, NAN);
    const std::string unit = unit_text(run.quantities[q].units);
    column.unit = unit == "–" ? "" : unit;
    for (std::size_t i = 0; i < run.records.size(); ++i) {
      const SuiteRecordRun& one = run.records[i];
      raise(column.numbers[i], one.modelled.empty() ? one.values[q] : one.modelled[q]);
    }
    raise(column.numbers[run.records.size()], run.mean(q));
    raise(column.numbers.back(), run.largest(q));
  }
  const auto& all = quantities();
  const auto of = std::find_if(all.begin(), all.end(), [&](const Quantity& one) { return one.key == key; });
  if (of != all.end() && !of->shown_unit.empty()) {
    column.unit = of->shown_unit;
    for (double& value : column.numbers) value *= of->shown_factor;
  }
  if (!column.numbers.empty() && (key == "impacts" || key == "peak_force"))
    tell_in_words(run, key == "impacts", column);
  return column;
}

const SuiteSpec& suite_of(const SuiteRun& run) { return *run.c.excitation.suite; }

/// How the only gap is judged under each record.
StoryColumn verdicts_of(const SuiteRun& run) {
  StoryColumn column{.label = "gap.given_is", .are_words = true};
  for (const char* const word : record_words(run, 0)) column.texts.emplace_back(word);
  column.texts.resize(run.records.size() + 2);
  return column;
}

/// Building and level of the floor that each record's verdict first names as not modelled; without texts: there is
/// none.
StoryColumn not_modelled_in(const SuiteRun& run) {
  StoryColumn column{.label = "column.suite.not_modelled"};
  if (!any_is_not_modelled(run)) return column;
  for (const SuiteRecordRun& one : run.records) {
    std::string& text = column.texts.emplace_back("–");
    const auto said = std::find_if(one.statements.begin(), one.statements.end(), is_of_unmodelled);
    if (said == one.statements.end()) continue;
    for (const StoryValue& value : said->values)
      if (value.name == "building") text = std::get<std::string>(value.value);
    text += ", " + number(said->level.value_or(0)) + " " + run.c.units.length;
  }
  column.texts.resize(run.records.size() + 2);
  return column;
}

bool ended_in_time(const SuiteRecordRun& one) { return one.status == Status::done; }

const RunResults& as_row(const RunResults& run) { return run; }
const RunResults& as_row(const PlanRun& run) { return *run.row; }

/// What is kept of a run. @param parts of `all`, a row of so many numbers, those that are told of records
template <class AnyRun>
void take_run(const AnyRun& run, const std::vector<RowPart>& parts, const std::vector<RowPart>& all, std::size_t size,
              SuiteRecordRun& result) {
  std::vector<double> row(size);
  fill_row(all, run.view(), row);
  const RunResults& as_one_row = as_row(run);
  const std::vector<LevelSeparation> levels = separations(as_one_row.problem, as_one_row.response);
  for (Eigen::Index gap = 0; gap < gap_count(as_one_row.problem); ++gap) {
    const NeedOfRun need = need_of(as_one_row, of_gap(levels, gap));
    result.needed.push_back(need.gap);
    result.is_of_reversed.push_back(need.is_reversed);
  }
  for (const RowPart& part : parts) {
    result.values.push_back(part.name == "gap_needed" ? need_of(as_one_row, levels).gap : reduced(part, row));
  }
  result.statements = run_story(run).statements;
  result.judged = told_judgements(run);
  if (!result.is_not_modelled()) return;
  result.modelled = result.values;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const std::string_view key = parts[i].quantity->key;
    if (key == "impacts" || key == "peak_force") result.values[i] = NAN;
  }
}

}  // namespace

bool SuiteRecordRun::is_not_modelled() const {
  return std::any_of(statements.begin(), statements.end(), is_of_unmodelled);
}

bool SuiteRun::all_ran() const {
  return is_whole() && std::none_of(records.begin(), records.end(),
                                    [](const SuiteRecordRun& one) { return one.status == Status::failed; });
}

double SuiteRun::mean(std::size_t quantity) const {
  if (!is_whole() || !std::all_of(records.begin(), records.end(), ended_in_time)) return NAN;
  double sum = 0;
  for (const SuiteRecordRun& one : records) sum += one.values[quantity];
  return std::isinf(sum) ? NAN : sum / static_cast<double>(records.size());
}

double SuiteRun::largest(std::size_t quantity) const {
  double result = NAN;
  for (const SuiteRecordRun& one : records) {
    if (one.values.empty() || std::isnan(one.values[quantity])) continue;
    result = std::isnan(result) ? one.values[quantity] : std::max(result, one.values[quantity]);
  }
  return result;
}

namespace {

/// Runs the records of a suite one after the other, of a row as in plan.
/// @param problem without a motion @param with_motion the same of a case that has one
template <class AnyProblem, class WithMotion>
void run_records(const AnyProblem& problem, const WithMotion& with_motion, const std::function<bool(double)>& progress,
                 SuiteRun& run) {
  std::vector<RowPart> parts = row_parts(problem, run.c.units, false);
  const std::size_t size = row_size(parts);
  const std::vector<RowPart> all = parts;
  std::erase_if(parts, [](const RowPart& part) { return !is_told_of_records(part); });
  for (const RowPart& part : parts) run.quantities.push_back({part.name, part.units, part.long_name});
  const auto count = static_cast<double>(suite_of(run).records.size());
  for (std::size_t i = 0; i < suite_of(run).records.size(); ++i) {
    const Case one = case_of_record(run.c, i);
    const AnyProblem moved = with_motion(one);
    SolveOptions options = solve_options(one);
    options.progress = [&](double fraction) { return progress((static_cast<double>(i) + fraction) / count); };
    SuiteRecordRun result;
    const std::string refusal = beyond_limits(one, moved, effort(moved, one.analysis.solver, options));
    if (!refusal.empty()) {
      result.status = Status::failed;
      result.message = refusal;
    } else {
      auto response = solve(moved, one.analysis.solver, options);
      if (response.status == Status::stopped) break;
      result.status = response.status;
      result.message = response.message;
      if (response.status != Status::failed)
        take_run(run_results(one, moved, std::move(response)), parts, all, size, result);
    }
    if (result.values.empty()) result.values.assign(parts.size(), NAN);
    run.records.push_back(std::move(result));
    if (!progress(static_cast<double>(i + 1) / count) && !run.is_whole()) break;
  }
}

}  // namespace

SuiteRun run_suite(const Case& c, const std::function<bool(double)>& progress) {
  if (!c.excitation.suite) throw InvalidParameter("excitation.kind", "no suite", "must be \"suite\"");
  SuiteRun run{.c = c, .problem = {}, .quantities = {}, .records = {}};
  if (c.is_in_plan()) {
    run.plan = make_plan_problem(c);
    run.problem = row_of(*run.plan);
    run_records(
        *run.plan, [&](const Case& one) { return make_plan_problem(one, run.plan->buildings); }, progress, run);
  } else {
    run.problem = make_still_problem(c);
    run_records(
        run.problem, [&](const Case& one) { return make_problem(one, run.problem.buildings); }, progress, run);
  }
  return run;
}

Story suite_story(const SuiteRun& run, const GapStudy& gaps) {
  const SuiteSpec& suite = suite_of(run);
  const bool are_many = suite.records.size() > 1;
  std::vector<SaidOfRun> said;
  for (std::size_t i = 0; i < run.records.size(); ++i) {
    if (run.records[i].status == Status::failed) continue;
    said.push_back({suite.records[i].name(), run.records[i].statements});
  }
  const std::vector<SuiteJudgement> judged = judged_gaps(run, gaps);
  Story told;
  const auto put = [&](std::vector<Statement> statements) {
    for (Statement& one : statements) told.statements.push_back(std::move(one));
  };
  if (are_many && judged.size() > 1) told.statements.push_back(counted_over_records(judged));
  put(union_of(said));
  const auto failed = std::ssize(run.records) - std::ssize(said);
  if (failed > 0) {
    told.statements.push_back({.kind = "suite_failed",
                               .severity = Severity::danger,
                               .values = {{"failed", failed}, {"records", std::ssize(run.records)}}});
  }
  if (!run.is_whole()) {
    told.statements.push_back({.kind = "suite_stopped",
                               .severity = Severity::warning,
                               .values = {{"done", std::ssize(run.records)}, {"records", std::ssize(suite.records)}}});
  }
  std::vector<JudgedOverRecords> in_short;
  for (std::size_t gap = 0; gap < judged.size(); ++gap) {
    in_short.push_back({judged[gap].many.is_enough(), judged[gap].alone});
    if (are_many) put(told_of(run, static_cast<Eigen::Index>(gap), judged[gap]));
  }
  Story of_gaps = gap_study_story(gaps, in_short);
  std::erase_if(of_gaps.statements, [](const Statement& one) { return !one.gap; });
  std::erase_if(of_gaps.tables, [](const StoryTable& one) { return !one.gap; });
  // Of one record what it needs is said already.
  if (!are_many)
    std::erase_if(of_gaps.statements, [](const Statement& one) { return !one.kind.starts_with("suite_"); });
  put(std::move(of_gaps.statements));
  Story scaled = bentur::suite_story(suite, run.c.units);
  put(std::move(scaled.statements));
  if (are_many) say_once(told.statements);
  sort_by_severity(told.statements);
  StoryColumn name{.label = "column.record", .are_words = true};
  for (std::size_t i = 0; i < run.records.size(); ++i) name.texts.push_back(suite.records[i].name());
  name.texts.emplace_back("story.mean_of_records");
  name.texts.emplace_back("story.largest_of_records");
  StoryTable table{.kind = "suite_runs", .columns = {std::move(name)}};
  for (const std::string_view key : told_in_tables) table.columns.push_back(column_of(run, key));
  std::erase_if(table.columns, [](const StoryColumn& one) { return one.texts.empty() && one.numbers.empty(); });
  if (StoryColumn column = not_modelled_in(run); !column.texts.empty()) table.columns.push_back(std::move(column));
  if (gap_count(run.problem) == 1) table.columns.push_back(verdicts_of(run));
  told.tables.push_back(std::move(table));
  if (are_many && judged.size() > 1) told.tables.push_back(table_over_records(run, judged, gaps));
  for (StoryTable& one : screening_tables(run.c, run.problem, run.plan ? &*run.plan : nullptr)) {
    of_gaps.tables.push_back(std::move(one));
  }
  for (Story* const other : {&of_gaps, &scaled}) {
    for (StoryTable& one : other->tables) told.tables.push_back(std::move(one));
  }
  return told;
}

std::string suite_said_json(const SuiteRun& run, const GapStudy& gaps) {
  Json json = {{"statements", Json::parse(statements_json(run.problem, suite_story(run, gaps).statements))}};
  json["judgements"] = Json::array();
  const std::vector<SuiteJudgement> judged = judged_gaps(run, gaps);
  for (std::size_t gap = 0; gap < judged.size(); ++gap) {
    const JudgementOfMany& many = judged[gap].many;
    Json reasons = Json::array();
    for (const JudgementOfMany::Found& one : many.reasons) {
      const bool is_rule = one.worst.kind == Reason::Kind::rule;
      reasons.push_back({{"kind", word_of(one.worst)},
                         {"records", one.runs},
                         {"worst", is_rule ? Json(nullptr) : Json(suite_of(run).records[one.run].files())}});
      if (is_rule) reasons.back()["rule"] = one.worst.subject;
    }
    json["judgements"].push_back(
        {{"between", names_across(run.problem, static_cast<Eigen::Index>(gap))},
         {"value", word_of(many.value)},
         {"records", {{"too_small", many.too_small}, {"not_known", many.not_known}, {"enough", many.enough}}},
         {"reasons", reasons}});
  }
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::string suite_run_json(const SuiteRun& run, const GapStudy& gaps, std::string_view version) {
  const SuiteSpec& suite = suite_of(run);
  const Json said = Json::parse(suite_said_json(run, gaps));
  const auto values = [&](const auto& value_of) {
    Json json = Json::object();
    for (std::size_t q = 0; q < run.quantities.size(); ++q) {
      const double value = value_of(q);
      json[run.quantities[q].name] = std::isfinite(value) ? Json(value) : Json(nullptr);
    }
    return json;
  };
  const auto status = [](Status one) {
    return one == Status::done ? "done" : one == Status::collapsed ? "collapsed" : "failed";
  };
  Json quantities = Json::object(), records = Json::array();
  for (const SuiteQuantity& one : run.quantities) {
    quantities[one.name] = {{"units", one.units}, {"long_name", one.long_name}};
  }
  for (std::size_t i = 0; i < run.records.size(); ++i) {
    const SuiteRecordRun& one = run.records[i];
    records.push_back({{"record", i + 1},
                       {"file", suite.records[i].echo.file},
                       {"factor", suite.records[i].factor},
                       {"misfit", suite.records[i].misfit},
                       {"status", status(one.status)},
                       {"message", one.message},
                       {"values", values([&](std::size_t q) { return one.values[q]; })}});
  }
  const Json json = {{"title", run.c.title},
                     {"units", {{"length", run.c.units.length}, {"force", run.c.units.force}}},
                     {"version", version},
                     {"statements", said.at("statements")},
                     {"judgements", said.at("judgements")},
                     {"suite", Json::parse(suite_json(suite))},
                     {"asked", suite.records.size()},
                     {"quantities", quantities},
                     {"records", records},
                     {"mean", values([&](std::size_t q) { return run.mean(q); })},
                     {"largest", values([&](std::size_t q) { return run.largest(q); })}};
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace bentur
