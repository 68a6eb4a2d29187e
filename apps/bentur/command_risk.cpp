#include <fmt/format.h>

#include <memory>
#include <string>

#include "arguments.h"
#include "bentur/core/units.h"
#include "bentur/core/version.h"
#include "bentur/files/ida_reading.h"
#include "bentur/report/story_text.h"
#include "bentur/study/risk/risk_report.h"
#include "commands.h"
#include "session.h"
#include "text/table.h"

namespace bentur::cli {
namespace {

struct RiskArguments {
  std::string file, hazard;
  RiskRequest request;
  HazardOptions options;
  std::string method = fragility_methods().front();
  std::string language = "en";
  bool json = false;
};

void run(const RiskArguments& arguments) {
  RiskRequest request = arguments.request;
  request.method = fragility_method(arguments.method);
  if (request.target && !(*request.target > 0 && *request.target < 1)) {
    throw Failure(exit_bad_input, fmt::format("bentur risk: --target {}: must be in (0, 1)", *request.target));
  }
  if (!(request.years > 0)) {
    throw Failure(exit_bad_input, fmt::format("bentur risk: --years {}: must be > 0", request.years));
  }
  Diagnostics diagnostics;
  auto hazard = read_hazard(arguments.hazard, arguments.options, diagnostics);
  auto results = read_ida_results(arguments.file, request.event, diagnostics);
  std::optional<IdaResults> needed;
  if (request.target) needed = read_ida_results(arguments.file, gap_needed_event, diagnostics);
  if (!diagnostics.ok() || !hazard || !results) throw Failure(diagnostics, arguments.language);
  std::string error;
  const auto report = risk_report(std::move(*results), needed, std::move(*hazard), request, error);
  if (!report) diagnostics.error({arguments.hazard, 0, 0}, error);
  if (!report) throw Failure(diagnostics, arguments.language);
  if (arguments.json) return print(risk_json(*report, request, version()));
  std::string text = report->results.title.empty() ? "" : report->results.title + "\n";
  text += story_text(std::vector<std::string>(), risk_story(*report, request), Words(arguments.language), Told::all);
  print(fitted(text));
}

}  // namespace

void add_risk_command(CLI::App& app) {
  auto arguments = std::make_shared<RiskArguments>();
  RiskRequest& request = arguments->request;
  CLI::App* command = app.add_subcommand("risk", "How often a year: fragility and a hazard curve");
  command->add_option("FILE", arguments->file, "results of bentur ida (NetCDF-4)")->required()->check(not_empty());
  command
      ->add_option("--hazard", arguments->hazard,
                   "the hazard curve: a table of intensity and mean annual frequency, or a file of OpenQuake")
      ->required()
      ->check(not_empty())
      ->type_name("FILE");
  command->add_option("--unit", arguments->options.unit, "of the table's intensities; default that of the levels")
      ->check(CLI::IsMember(acceleration_units()));
  command->add_option("--site", arguments->options.site, "which of several sites in the file, from 1")
      ->check(CLI::Range(1L, 1000000000L));
  command->add_option("--event", request.event,
                      "a quantity of the results compared with a number in its unit there; default \"impacts > 0\"");
  command->add_option("--method", arguments->method, "of the fragility: likelihood (default), cloud or stripes")
      ->check(CLI::IsMember(fragility_methods()));
  command->add_option("--years", request.years, "for which a probability is given; default 50")->check(finite());
  command->add_option("--target", request.target, "the gap for this probability of pounding in --years")
      ->check(finite());
  command->add_option("--resamples", request.bootstrap.resamples, "of the bootstrap; default 1000")
      ->check(CLI::Range(1, 1000000));
  command->add_option("--confidence", request.bootstrap.confidence, "of the bounds; default 0.95")
      ->check(CLI::Range(0.01, 0.999));
  command->add_option("--seed", request.bootstrap.seed, "of the bootstrap; default 1")->check(whole_number());
  command->add_flag("--json", arguments->json, "JSON instead of words");
  add_language(*command, arguments->language);
  command->footer(
      "Example: bentur risk ida.nc --hazard hazard_curve-mean-PGA.csv --target 0.1\n"
      "How often a force is exceeded: bentur risk ida.nc --hazard curve.csv --event \"peak_force > 500\"");
  command->callback([arguments] { run(*arguments); });
}

}  // namespace bentur::cli
