#include "bentur/study/suite/suite_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "bentur/core/errors.h"
#include "bentur/io/results/story_json.h"
#include "bentur/io/results/suite_json.h"
#include "bentur/model/limits.h"
#include "bentur/model/quantity_row.h"
#include "bentur/model/suite/suite_story.h"
#include "bentur/pounding/pounding.h"

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
                                                "peak_storey_shear",
                                                "base_shear_coefficient",
                                                "amplification",
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

/// What stands in the table, of buildings the largest of all.
constexpr std::string_view told_in_tables[] = {"impacts",          "peak_force", "gap_needed",
                                               "peak_drift_ratio", "ductility",  "column_demand_capacity"};

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
    for (std::size_t i = 0; i < run.records.size(); ++i) raise(column.numbers[i], run.records[i].values[q]);
    raise(column.numbers[run.records.size()], run.mean(q));
    raise(column.numbers.back(), run.largest(q));
  }
  return column;
}

const SuiteSpec& suite_of(const SuiteRun& run) { return *run.c.excitation.suite; }

bool ended_in_time(const SuiteRecordRun& one) { return one.status == Status::done; }

}  // namespace

double SuiteRun::mean(std::size_t quantity) const {
  if (!is_whole() || !std::all_of(records.begin(), records.end(), ended_in_time)) return NAN;
  double sum = 0;
  for (const SuiteRecordRun& one : records) sum += one.values[quantity];
  return sum / static_cast<double>(records.size());
}

double SuiteRun::largest(std::size_t quantity) const {
  double result = NAN;
  for (const SuiteRecordRun& one : records) {
    if (one.values.empty() || std::isnan(one.values[quantity])) continue;
    result = std::isnan(result) ? one.values[quantity] : std::max(result, one.values[quantity]);
  }
  return result;
}

SuiteRun run_suite(const Case& c, const std::function<bool(double)>& progress) {
  SuiteRun run{.c = c, .problem = make_still_problem(c), .quantities = {}, .records = {}};
  if (!c.excitation.suite) throw InvalidParameter("excitation.kind", "no suite", "must be \"suite\"");
  std::vector<RowPart> parts = row_parts(run.problem, c.units, false);
  const std::size_t size = row_size(parts);
  const std::vector<RowPart> all = parts;
  std::erase_if(parts, [](const RowPart& part) { return !is_told_of_records(part); });
  for (const RowPart& part : parts) run.quantities.push_back({part.name, part.units, part.long_name});
  const auto count = static_cast<double>(suite_of(run).records.size());
  for (std::size_t i = 0; i < suite_of(run).records.size(); ++i) {
    const Case one = case_of_record(c, i);
    const Problem problem = make_problem(one, run.problem.buildings);
    SolveOptions options = solve_options(one);
    options.levels = options.both_ways = options.energy_audit = false;
    options.progress = [&](double fraction) { return progress((static_cast<double>(i) + fraction) / count); };
    SuiteRecordRun result;
    const std::string refusal = beyond_limits(one, problem, effort(problem, one.analysis.solver, options));
    if (!refusal.empty()) {
      result.status = Status::failed;
      result.message = refusal;
    } else {
      const Response response = solve(problem, one.analysis.solver, options);
      if (response.status == Status::stopped) break;
      result.status = response.status;
      result.message = response.message;
      if (response.status != Status::failed) {
        std::vector<double> row(size);
        fill_row(all, {problem, response, one.units}, row);
        for (const RowPart& part : parts) result.values.push_back(reduced(part, row));
      }
    }
    if (result.values.empty()) result.values.assign(parts.size(), NAN);
    run.records.push_back(std::move(result));
    if (!progress(static_cast<double>(i + 1) / count) && !run.is_whole()) break;
  }
  return run;
}

Story suite_run_story(const SuiteRun& run) {
  const SuiteSpec& suite = suite_of(run);
  const auto number_of = [&](std::string_view name) {
    const auto found = std::find_if(run.quantities.begin(), run.quantities.end(),
                                    [&](const SuiteQuantity& one) { return one.name == name; });
    return static_cast<std::size_t>(found - run.quantities.begin());
  };
  const std::size_t impacts = number_of("impacts"), met = number_of("unmodelled_contacts");
  long pounding = 0, failed = 0, collapsed = 0;
  for (const SuiteRecordRun& one : run.records) {
    const auto any = [&](std::size_t q) { return q < one.values.size() && one.values[q] > 0; };
    pounding += any(impacts) || any(met) ? 1 : 0;
    failed += one.status == Status::failed ? 1 : 0;
    collapsed += one.status == Status::collapsed ? 1 : 0;
  }
  Story told;
  const long runs = std::ssize(run.records) - failed;
  if (runs > 0) {
    told.statements.push_back({.kind = pounding > 0 ? "suite_pounding" : "suite_no_pounding",
                               .severity = pounding > 0 ? Severity::warning : Severity::finding,
                               .values = {{"pounding", pounding}, {"records", runs}}});
  }
  if (collapsed > 0) {
    told.statements.push_back({.kind = "suite_collapsed",
                               .severity = Severity::danger,
                               .values = {{"collapsed", collapsed}, {"records", runs}}});
  }
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
  Story scaled = suite_story(suite, run.c.units);
  for (Statement& one : scaled.statements) told.statements.push_back(std::move(one));
  sort_by_severity(told.statements);
  StoryColumn name{.label = "column.record", .are_words = true};
  for (std::size_t i = 0; i < run.records.size(); ++i) name.texts.push_back(suite.records[i].echo.file);
  name.texts.emplace_back("story.mean_of_records");
  name.texts.emplace_back("story.largest_of_records");
  StoryTable table{.kind = "suite_runs", .columns = {std::move(name)}};
  for (const std::string_view key : told_in_tables) table.columns.push_back(column_of(run, key));
  std::erase_if(table.columns, [](const StoryColumn& one) { return one.texts.empty() && one.numbers.empty(); });
  told.tables.push_back(std::move(table));
  for (StoryTable& one : scaled.tables) told.tables.push_back(std::move(one));
  return told;
}

std::string suite_run_json(const SuiteRun& run, std::string_view version) {
  const SuiteSpec& suite = suite_of(run);
  const auto values = [&](const auto& value_of) {
    Json json = Json::object();
    for (std::size_t q = 0; q < run.quantities.size(); ++q) {
      const double value = value_of(q);
      json[run.quantities[q].name] = std::isnan(value) ? Json(nullptr) : Json(value);
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
                     {"statements", Json::parse(statements_json(run.problem, suite_run_story(run).statements))},
                     {"suite", Json::parse(suite_json(suite))},
                     {"asked", suite.records.size()},
                     {"quantities", quantities},
                     {"records", records},
                     {"mean", values([&](std::size_t q) { return run.mean(q); })},
                     {"largest", values([&](std::size_t q) { return run.largest(q); })}};
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace bentur
