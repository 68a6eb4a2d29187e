#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include "arguments.h"
#include "bentur/core/version.h"
#include "bentur/files/netcdf.h"
#include "bentur/files/result_reading.h"
#include "bentur/io/results/result_variable.h"
#include "bentur/model/plan/plan_dense_run.h"
#include "bentur/report/errors.h"
#include "bentur/report/html/report.h"
#include "bentur/report/html/spectral_report.h"
#include "bentur/report/html/suite_report.h"
#include "bentur/report/studies/sweep_report.h"
#include "bentur/report/words.h"
#include "cases/suite.h"
#include "commands.h"
#include "output/output.h"
#include "session.h"

namespace bentur::cli {
namespace {

struct ReportArguments {
  std::string input;
  std::string output;
  std::string language = "en";
  std::string hazard;
  std::string event = pounding_event;
  std::string method = fragility_methods().front();
  HazardOptions hazard_options;
  std::optional<int> record;
  bool force = false;
};

/// For the report of results that another bentur has written, which then names both.
ReportOptions of_results(ReportOptions options, const NetcdfReader& results) {
  const std::string history = results.attribute("history");
  const std::string by = history.substr(std::min(history.size(), result_history.size() + 1));
  if (!by.empty() && by != options.version) {
    options.version = Words(options.language)("report.drawn_by", {{"version", by}, {"now", options.version}});
  }
  return options;
}

/// Records are looked for where they were from the results, from beside them, and from here.
ReportOptions with_sensitivity(ReportOptions options, const Case& c, const std::filesystem::path& folder) {
  options.sensitivity = sensitivity_of_results(c, {folder, folder / "..", "."});
  return options;
}

/// The report of a folder of results.
std::string from_results(const std::filesystem::path& folder, const ReportOptions& options) {
  const auto report_of = [&](const AnyRun& results, const ReportOptions& of) {
    return std::visit([&](const auto& run) { return report_html(run, with_sensitivity(of, run.c, folder)); }, results);
  };
  try {
    if (std::filesystem::exists(folder / "histories.nc") && std::filesystem::exists(folder / "summary.json")) {
      const NetcdfReader histories(folder / "histories.nc");
      return report_of(read_any_results(histories), of_results(options, histories));
    }
    return report_of(read_results(folder), options);
  } catch (const Failure&) {
    throw;
  } catch (const std::exception& error) {
    throw Failure(exit_bad_input, std::string("bentur report: ") + error.what());
  }
}

/// The report of one file of results: of a sweep, or histories.nc of a run, beside which the others stand.
std::string from_netcdf(const std::filesystem::path& file, const ReportOptions& options) {
  try {
    const NetcdfReader results(file);
    if (results.find("status") == nullptr) return from_results(file.parent_path(), options);
    return sweep_report_html(results, of_results(options, results));
  } catch (const Failure&) {
    throw;
  } catch (const std::exception& error) {
    throw Failure(exit_bad_input, std::string("bentur report: ") + error.what());
  }
}

std::string from_case(const Loaded& loaded, const std::string& file, const ReportOptions& options) {
  if (loaded.c.excitation.suite) {
    const SuiteRun run = run_records(loaded, true, options.language);
    const GapStudy gaps = run.is_whole() ? gaps_over_records(loaded, file, options.language) : GapStudy();
    if (!run.is_whole() || !gaps.is_whole()) throw Failure(exit_other, "Stopped: no report is written");
    return suite_report_html(run, gaps, options);
  }
  if (loaded.c.excitation.spectrum) {
    const SpectralGaps gaps = spectral_gaps(loaded);
    return spectral_report_html(loaded.c, loaded.problem, gaps, options);
  }
  ReportOptions all = options;
  all.sensitivity = sensitivity_of_report(loaded.c, file);
  return with_problem(loaded, [&](const auto& problem) {
    auto run = simulate(loaded, problem, report_output_step(problem), true, options.language);
    find_figures(run);
    return report_html(run, all);
  });
}

/// The result files that a report is made from.
std::vector<std::filesystem::path> files_of_results(const std::filesystem::path& input, bool is_folder) {
  std::vector<std::filesystem::path> files = {input};
  const std::filesystem::path folder = is_folder ? input : input.parent_path();
  for (const char* name : {"summary.json", "impacts.csv", "histories.nc", "case.toml"}) files.push_back(folder / name);
  return files;
}

/// The hazard of the site; nothing where none is given. @throws Failure with what is wrong in it.
std::optional<HazardCurve> read_site(const ReportArguments& arguments) {
  if (arguments.hazard.empty()) return std::nullopt;
  Diagnostics diagnostics;
  auto hazard = read_hazard(arguments.hazard, arguments.hazard_options, diagnostics);
  if (!hazard) throw Failure(diagnostics, arguments.language);
  return hazard;
}

void run(const ReportArguments& arguments) {
  const std::filesystem::path input = arguments.input;
  const bool is_folder = std::filesystem::is_directory(input);
  const bool is_netcdf = !is_folder && input.extension() == ".nc";
  const bool from_files = is_folder || is_netcdf;
  if (!arguments.hazard.empty() && !is_netcdf) {
    throw Failure(exit_bad_input, error_words("--hazard is for the results of bentur ida", arguments.language));
  }
  if (from_files && arguments.record) {
    throw Failure(exit_bad_input,
                  error_words("--record is for a case with excitation.kind = \"suite\"", arguments.language));
  }
  const bool asks = arguments.event != pounding_event || arguments.method != fragility_methods().front();
  if (asks && !is_netcdf) {
    throw Failure(exit_bad_input,
                  error_words("--event and --method are for the results of bentur ida", arguments.language));
  }
  Loaded loaded = from_files ? Loaded{} : load(input, arguments.language);
  if (arguments.record) loaded = record_of(std::move(loaded), *arguments.record, arguments.language);
  // Before the work, so that a place that cannot be written to costs none.
  std::vector<std::filesystem::path> files = from_files ? files_of_results(input, is_folder) : loaded.files;
  if (!arguments.hazard.empty()) files.emplace_back(arguments.hazard);
  OutputFile output(arguments.output, ResultKind::report, {files, arguments.force});
  ReportOptions options{.language = arguments.language, .version = std::string(version())};
  options.hazard = read_site(arguments);
  options.event = arguments.event;
  options.method = fragility_method(arguments.method);
  const std::string page = is_folder   ? from_results(input, options)
                           : is_netcdf ? from_netcdf(input, options)
                                       : from_case(loaded, input.string(), options);
  output.write(page);
  if (!output.is_streamed()) message(fmt::format("Wrote {} ({} kB)", arguments.output, (page.size() + 999) / 1000));
}

}  // namespace

void add_report_command(CLI::App& app) {
  auto arguments = std::make_shared<ReportArguments>();
  CLI::App* command = app.add_subcommand("report", "Write a report of a case, or of results, to read, print and send");
  command
      ->add_option("CASE", arguments->input,
                   "the case file (TOML), a folder that bentur run -o wrote, or the results of bentur sweep (.nc)")
      ->required()
      ->check(not_empty());
  command->add_option("-o,--output", arguments->output, "the HTML file, complete in itself; - for standard output")
      ->required()
      ->check(not_empty())
      ->type_name("FILE");
  command->add_option("--lang", arguments->language, "en (default) or id: English or Indonesian")
      ->check(CLI::IsMember(report_languages()));
  command
      ->add_option("--hazard", arguments->hazard,
                   "of results of bentur ida: the site's hazard curve, for rates a year, as bentur risk takes it")
      ->check(not_empty())
      ->type_name("FILE");
  command->add_option("--site", arguments->hazard_options.site, "which of several sites of --hazard, from 1")
      ->check(CLI::Range(1L, 1000000000L));
  command->add_option("--event", arguments->event,
                      "of results of bentur ida: the fragility of this event too, as in bentur fragility");
  command
      ->add_option("--method", arguments->method,
                   "of that fragility and the rates a year: likelihood (default), cloud or stripes")
      ->check(CLI::IsMember(fragility_methods()));
  add_record(*command, arguments->record);
  add_force(*command, arguments->force);
  command->footer("Example: bentur report case.toml -o report.html");
  command->callback([arguments] { run(*arguments); });
}

}  // namespace bentur::cli
