#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "arguments.h"
#include "bentur/core/version.h"
#include "bentur/report/errors.h"
#include "bentur/report/story_text.h"
#include "bentur/study/sensitivity/sensitivity.h"
#include "commands.h"
#include "output/output.h"
#include "session.h"
#include "text/table.h"

namespace bentur::cli {
namespace {

struct SensitivityArguments {
  std::string file, output;
  std::vector<std::string> numbers;
  std::string language = "en";
  bool json = false, force = false;
};

void run(const SensitivityArguments& arguments) {
  const Loaded loaded = load(arguments.file, arguments.language);
  std::optional<OutputFile> output;
  const OutputRules rules{.inputs = {arguments.file}, .force = arguments.force};
  if (!arguments.output.empty()) output.emplace(arguments.output, ResultKind::sensitivity, rules);
  const StopOnSignal stop;
  Diagnostics diagnostics;
  Progress display("of the duration simulated");
  SensitivityOptions options{.numbers = arguments.numbers};
  options.progress = [&](double fraction) {
    display.show(fraction);
    return !StopOnSignal::asked();
  };
  const auto found = sensitivity_of(*loaded.c.given, arguments.file, options, diagnostics);
  if (!diagnostics.ok()) throw Failure(diagnostics, arguments.language);
  if (!found) throw Failure(exit_other, error_words("Stopped: nothing is written", arguments.language));
  const std::string json = sensitivity_json(*found, version());
  if (output) output->write(json);
  if (arguments.json) return print(json);
  std::string text = found->title.empty() ? "" : found->title + "\n";
  text += story_text(std::vector<std::string>(), sensitivity_story(*found), Words(arguments.language), Told::all);
  print(fitted(text));
}

}  // namespace

void add_sensitivity_command(CLI::App& app) {
  auto arguments = std::make_shared<SensitivityArguments>();
  CLI::App* command = app.add_subcommand("sensitivity", "How peaks change with every number of a case");
  command->add_option("CASE", arguments->file, "case file (TOML)")->required()->check(not_empty());
  command->add_option("--by", arguments->numbers, "a number as gap[0].width; default: all of the case")
      ->check(not_empty())
      ->type_name("NUMBER");
  command->add_option("-o,--output", arguments->output, "file for the result (JSON)")
      ->check(not_empty())
      ->type_name("FILE");
  command->add_flag("--json", arguments->json, "JSON instead of words");
  add_language(*command, arguments->language);
  add_force(*command, arguments->force);
  command->footer(
      "Example: bentur sensitivity my-case.toml\n"
      "Of two numbers alone: bentur sensitivity my-case.toml --by gap[0].width --by excitation.pga");
  command->callback([arguments] { run(*arguments); });
}

}  // namespace bentur::cli
