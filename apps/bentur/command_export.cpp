#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "arguments.h"
#include "bentur/core/version.h"
#include "bentur/files/ida_reading.h"
#include "bentur/files/netcdf.h"
#include "bentur/io/results/result_csv.h"
#include "bentur/model/judgement/judge.h"
#include "bentur/model/story/judgement_story.h"
#include "bentur/report/errors.h"
#include "bentur/study/exchange/demands.h"
#include "bentur/study/exchange/gem.h"
#include "bentur/study/exchange/nrml.h"
#include "bentur/study/suite/suite_run.h"
#include "cases/suite.h"
#include "commands.h"
#include "output/output.h"
#include "session.h"

namespace bentur::cli {
namespace {

struct ExportArguments {
  std::string file, output = "-", building, taxonomy, language = "en";
  std::vector<std::string> only, events;
  bool force = false, misfits = false;
};

OutputFile output_file(const ExportArguments& arguments, ResultKind kind) {
  return {arguments.output, kind, {.inputs = {arguments.file}, .force = arguments.force}};
}

void export_demands(const ExportArguments& arguments) {
  DemandRequest request{.building = arguments.building};
  for (const std::string& one : arguments.only) {
    const std::size_t equals = one.find('=');
    if (equals == std::string::npos || equals == 0) {
      throw Failure(exit_bad_input, "bentur export: " + error_words(fmt::format("--only {}: must be NAME=VALUE", one),
                                                                    arguments.language));
    }
    request.only.emplace_back(one.substr(0, equals), one.substr(equals + 1));
  }
  OutputFile output = output_file(arguments, ResultKind::demands);
  Demands demands;
  try {
    demands = demand_sample(NetcdfReader(arguments.file), request);
  } catch (const NetcdfError& error) {
    Diagnostics diagnostics;
    diagnostics.error({arguments.file, 0, 0}, error.reason);
    throw Failure(diagnostics, arguments.language);
  }
  output.write(demands.csv);
  std::vector<std::string> over;
  for (const auto& [name, size] : demands.over) over.push_back(fmt::format("{} ({})", name, size));
  const Words say(arguments.language);
  const auto count = [&](const char* key, std::size_t n) { return say(key, {{"n", fmt::format("{}", n)}}); };
  std::string told = count("cli.demands", demands.runs);
  if (!over.empty()) told += say("cli.demands_over", {{"names", fmt::format("{}", fmt::join(over, ", "))}});
  if (demands.errors > 0) told += count("cli.demands_errors", demands.errors);
  if (demands.left_out > 0) told += count("cli.demands_left_out", demands.left_out);
  message(told);
}

void export_fragility(const ExportArguments& arguments) {
  std::vector<std::string> events = arguments.events;
  if (events.empty()) events.emplace_back(pounding_event);
  OutputFile output = output_file(arguments, ResultKind::fragility_model);
  Diagnostics diagnostics;
  std::vector<std::pair<std::string, IdaResults>> read;
  for (const std::string& event : events) {
    if (auto results = read_ida_results(arguments.file, event, diagnostics))
      read.emplace_back(event, std::move(*results));
  }
  if (!diagnostics.ok()) throw Failure(diagnostics, arguments.language);
  std::string error;
  const auto made = nrml_of(read, arguments.taxonomy, arguments.misfits, error);
  if (!made) {
    diagnostics.error({arguments.file, 0, 0}, error);
    throw Failure(diagnostics, arguments.language);
  }
  output.write(nrml_fragility(made->model, version()));
  const Words say(arguments.language);
  const auto warn = [&](const char* key, const std::vector<std::string>& names) {
    if (!names.empty()) message(say(key, {{"names", fmt::format("{}", fmt::join(names, "; "))}}));
  };
  warn("cli.curves_left_out", made->left_out);
  warn(arguments.misfits ? "cli.curves_misfit" : "cli.curves_misfit_left_out", made->misfits);
  warn("cli.curves_extrapolated", made->extrapolated);
  if (made->model.period && made->damping != 0.05) {
    message(say("cli.curves_damping", {{"damping", fmt::format("{:.3g}", 100 * made->damping)}}));
  }
}

/// What is judged of the gaps of a case: by its motion, by its spectrum, or under each record of its suite.
std::vector<ToldJudgement> judgements_of(const Loaded& loaded, const std::string& language) {
  const Case& c = loaded.c;
  if (c.excitation.suite) {
    const SuiteRun run = run_records(loaded, true, language);
    if (!run.all_ran()) throw Failure(exit_other, error_words("Stopped: not all records are run", language));
    std::vector<ToldJudgement> all;
    for (const SuiteRecordRun& record : run.records) all.insert(all.end(), record.judged.begin(), record.judged.end());
    return all;
  }
  if (c.excitation.spectrum) return told_judgements(c, loaded.problem, spectral_gaps(loaded));
  return with_run(loaded, language, [](const auto& run) { return told_judgements(run); });
}

/// Of the buildings of a row or in plan.
template <class AnyProblem>
std::string taxonomy_table(const Case& c, const AnyProblem& problem, const std::vector<ToldJudgement>& gaps) {
  std::set<Eigen::Index> pounding;
  for (const ToldJudgement& gap : gaps) {
    if (may_close(gap.judgement)) pounding.insert({gap.left, gap.right});
  }
  std::string text = "building,taxonomy\n";
  for (Eigen::Index b = 0; b < std::ssize(problem.buildings); ++b) {
    if (problem.buildings[b].is_rigid()) continue;
    text +=
        fmt::format("{},{}\n", csv_field(problem.buildings[b].name), gem_taxonomy(c, problem, b, pounding.contains(b)));
  }
  return text;
}

void export_taxonomy(const ExportArguments& arguments) {
  OutputFile output = output_file(arguments, ResultKind::taxonomy);
  const Loaded loaded = load(arguments.file, arguments.language);
  const std::vector<ToldJudgement> gaps = judgements_of(loaded, arguments.language);
  output.write(with_problem(loaded, [&](const auto& problem) { return taxonomy_table(loaded.c, problem, gaps); }));
  std::set<std::pair<Eigen::Index, Eigen::Index>> open;
  for (const ToldJudgement& gap : gaps) {
    if (gap.judgement.is_open()) open.emplace(gap.left, gap.right);
  }
  std::vector<std::string> names;
  for (const auto& [left, right] : open) {
    names.push_back(loaded.c.buildings.at(static_cast<std::size_t>(left)).name + " | " +
                    loaded.c.buildings.at(static_cast<std::size_t>(right)).name);
  }
  if (names.empty()) return;
  message(Words(arguments.language)("cli.gem_not_known", {{"names", fmt::format("{}", fmt::join(names, ", "))}}));
}

CLI::App* format(CLI::App& app, const char* name, const char* what, const char* file, ExportArguments& arguments) {
  CLI::App* command = app.add_subcommand(name, what);
  command->add_option("FILE", arguments.file, file)->required()->check(not_empty());
  command->add_option("-o,--output", arguments.output, "file to write; default - for standard output")
      ->check(not_empty());
  add_language(*command, arguments.language);
  add_force(*command, arguments.force);
  return command;
}

}  // namespace

void add_export_command(CLI::App& app) {
  auto arguments = std::make_shared<ExportArguments>();
  CLI::App* command = app.add_subcommand("export", "Numbers for other programs: pelicun, OpenQuake, GEM taxonomy");
  command->require_subcommand(1);
  CLI::App* pelicun = format(*command, "pelicun", "A sample of demands of one building, as pelicun reads it",
                             "results of bentur sweep or bentur ida (NetCDF-4)", *arguments);
  pelicun->add_option("--building", arguments->building, "its name")->required()->check(not_empty());
  pelicun->add_option("--only", arguments->only,
                      "NAME=VALUE: runs that have this value of what varies, as intensity=0.5");
  pelicun->callback([arguments] { export_demands(*arguments); });
  CLI::App* openquake = format(*command, "openquake", "Fragility functions in NRML 0.5, as OpenQuake reads them",
                               "results of bentur ida (NetCDF-4)", *arguments);
  openquake->add_option("--taxonomy", arguments->taxonomy, "id of the functions: the taxonomy of the asset")
      ->required()
      ->check(not_empty());
  openquake->add_option("--event", arguments->events, "a limit state, as in bentur fragility; default \"impacts > 0\"");
  openquake->add_flag("--misfits", arguments->misfits,
                      "also those whose runs a lognormal does not describe (KS, see bentur fragility)");
  openquake->callback([arguments] { export_fragility(*arguments); });
  CLI::App* gem =
      format(*command, "gem", "Of each building its GEM taxonomy, with POP where it may pound", "a case", *arguments);
  gem->callback([arguments] { export_taxonomy(*arguments); });
  command->footer(
      "Example: bentur export pelicun ida.nc --building Tower --only intensity=0.5 -o demands.csv\n"
      "         bentur export openquake ida.nc --taxonomy CR/LFM/HEX:8 --event \"impacts > 0\" -o fragility.xml");
}

}  // namespace bentur::cli
