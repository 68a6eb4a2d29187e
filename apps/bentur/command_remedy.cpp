#include <fmt/format.h>

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "arguments.h"
#include "bentur/core/version.h"
#include "bentur/model/gap/spectral_gap.h"
#include "bentur/report/errors.h"
#include "bentur/report/studies/remedy_figure.h"
#include "bentur/runner/solve_in_threads.h"
#include "bentur/study/gap/gap_study.h"
#include "bentur/study/remedy/least_gap.h"
#include "bentur/study/remedy/remedy.h"
#include "bentur/study/remedy/remedy_story.h"
#include "cases/suite.h"
#include "commands.h"
#include "output/output.h"
#include "output/picture.h"
#include "session.h"
#include "text/table.h"

namespace bentur::cli {
namespace {

struct RemedyArguments {
  std::string study, output, figure;
  std::string language = "en";
  int threads = 0;
  bool resume = false, json = false, force = false;
};

/// Of what is written, what must not be touched.
OutputRules rules_of(const RemedyArguments& arguments) {
  return {.inputs = {arguments.study}, .force = arguments.force};
}

std::optional<RemedySearch> seek(const RemedyArguments& arguments, const std::filesystem::path& journal) {
  const StopOnSignal stop;
  Progress progress("of the evaluations");
  RemedyOptions options{.journal = journal, .resume = arguments.resume, .version = std::string(version())};
  options.goes_on = [&progress](double fraction) {
    progress.show(fraction);
    return !StopOnSignal::asked();
  };
  options.solve = [&arguments](const StudyRuns& study, std::span<const std::size_t> runs,
                               const std::function<bool()>& goes_on) {
    return solve_in_threads(study, runs, arguments.threads, goes_on);
  };
  Diagnostics diagnostics;
  auto found = seek_remedy(arguments.study, options, diagnostics);
  if (!found) throw Failure(diagnostics, arguments.language);
  return found;
}

/// Of a case as it stands: the least gap, which wants no search.
LeastGaps gaps_of(const RemedyArguments& arguments) {
  const Loaded loaded = load(arguments.study, arguments.language);
  const Case& c = loaded.c;
  if (c.excitation.suite) {
    const SuiteRun run = run_records(loaded, true, arguments.language);
    const GapStudy study = run.is_whole() ? gaps_over_records(loaded, arguments.study, arguments.language) : GapStudy();
    if (!run.is_whole() || !study.is_whole())
      throw Failure(exit_other, error_words("Stopped: not all records are run", arguments.language));
    return least_gaps(run, study);
  }
  if (c.excitation.spectrum) {
    return least_gaps(c, loaded.problem, spectral_gaps(loaded));
  }
  return with_run(loaded, arguments.language, [](const auto& run) { return least_gaps(run); });
}

void run_case(const RemedyArguments& arguments) {
  const auto refuse = [&](const char* why) {
    throw Failure(exit_bad_input, "bentur remedy: " + error_words(why, arguments.language));
  };
  if (arguments.resume || !arguments.output.empty() || !arguments.figure.empty()) {
    refuse("--output, --resume and --figure are for a study with [remedy]; of a case --json has the least gap");
  }
  const LeastGaps found = gaps_of(arguments);
  if (arguments.json) return print(least_gap_json(found, version()));
  const Words say(arguments.language);
  std::vector<std::string> gaps;
  for (const LeastGap& one : found.gaps) gaps.push_back(one.name);
  std::string text = found.title.empty() ? "" : found.title + "\n";
  text += story_text(gaps, least_gap_story(found), say, Told::outcome);
  print(fitted(text));
}

void run(const RemedyArguments& arguments) {
  if (!is_study(arguments.study)) return run_case(arguments);
  if (arguments.resume && arguments.output.empty()) {
    throw Failure(exit_bad_input, "bentur remedy: --resume needs --output: evaluations are kept beside it");
  }
  if (!arguments.output.empty() && is_standard_output(arguments.output)) {
    throw Failure(exit_bad_input, "bentur remedy: --output must be a file; --json writes to standard output");
  }
  std::optional<OutputFile> output;
  std::filesystem::path journal;
  if (!arguments.output.empty()) {
    output.emplace(arguments.output, ResultKind::remedy, rules_of(arguments));
    journal = arguments.output + ".part";
  }
  if (!arguments.figure.empty()) expect_picture(arguments.figure, rules_of(arguments));
  const RemedySearch found = *seek(arguments, journal);
  const Words say(arguments.language);
  const std::string json = remedy_json(found, version());
  if (output && !found.stopped) {
    output->write(json);
    std::filesystem::remove(journal);
  }
  std::string text = found.title.empty() ? "" : found.title + "\n";
  text += story_text(std::vector<std::string>(), remedy_story(found), say, Told::outcome);
  print(arguments.json ? json : fitted(text));
  if (!arguments.figure.empty() && found.best() != nullptr) {
    FigureOptions options;
    options.say = figure_words(arguments.language);
    options.language = arguments.language;
    write_picture(arguments.figure, remedy_figure(found, options), rules_of(arguments));
  }
  if (!found.stopped) return;
  throw Failure(exit_other, output
                                ? fmt::format("Stopped: what was tried is kept in {}; the same command with --resume "
                                              "goes on",
                                              journal.string())
                                : "");
}

}  // namespace

void add_remedy_command(CLI::App& app) {
  auto arguments = std::make_shared<RemedyArguments>();
  CLI::App* command = app.add_subcommand("remedy", "Gap, damper, filler or stiffness that keeps a limit");
  command
      ->add_option("FILE", arguments->study,
                   "a study with [remedy]: a case, what may be chosen, what is sought; or a case: its least gap")
      ->required()
      ->check(not_empty());
  command->add_option("-o,--output", arguments->output, "file for the result (JSON)")
      ->check(not_empty())
      ->type_name("FILE");
  command->add_option("--figure", arguments->figure, "the trade-off as a picture, .svg, .pdf or .png")
      ->check(not_empty())
      ->type_name("FILE");
  command->add_option("--threads", arguments->threads, "threads for the runs of a choice; default: all")
      ->check(CLI::Range(1, 4096));
  command->add_flag("--resume", arguments->resume, "go on with an unfinished search");
  command->add_flag("--json", arguments->json, "JSON instead of words");
  add_language(*command, arguments->language);
  add_force(*command, arguments->force);
  command->footer(
      "Example: bentur remedy study.toml -o remedy.json --figure remedy.svg\n"
      "The least gap of a case as it stands: bentur remedy case.toml");
  command->callback([arguments] { run(*arguments); });
}

}  // namespace bentur::cli
