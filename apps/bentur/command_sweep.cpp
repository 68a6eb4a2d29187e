#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <string>

#include "arguments.h"
#include "bentur/core/version.h"
#include "bentur/model/story/study_story.h"
#include "bentur/report/story_text.h"
#include "bentur/runner/sweep.h"
#include "commands.h"
#include "output/output.h"
#include "session.h"
#include "text/table.h"

namespace bentur::cli {
namespace {

struct SweepArguments {
  StudyKind kind = StudyKind::sweep;
  std::string study, output;
  bool resume = false;
  bool check = false;
  bool quiet = false;
  bool force = false;
  int threads = 0;
};

const char* name(StudyKind kind) { return kind == StudyKind::ida ? "ida" : "sweep"; }

std::string duration_text(double seconds) {
  const auto whole = std::lround(seconds);
  if (whole < 60) return fmt::format("{} s", whole);
  if (whole < 3600) return fmt::format("{} min {:02d} s", whole / 60, whole % 60);
  return fmt::format("{} h {:02d} min", whole / 3600, whole / 60 % 60);
}

/// Of a log [s]; a test has not the time to wait for a minute.
double seconds_between_lines() {
  const char* const given = std::getenv("BENTUR_LOG_SECONDS");
  const double seconds = given != nullptr ? std::atof(given) : 0;
  return seconds > 0 ? seconds : 60;
}

/// How far a study is: one line of a terminal, written over and over; in a log one more line every minute.
class Line {
 public:
  void show(const SweepProgress& p) {
    if (!terminal_ && p.seconds - told_ < every_) return;
    told_ = p.seconds;
    const double rate = static_cast<double>(p.done - p.before) / std::max(p.seconds, 1e-9);
    std::string text = fmt::format("{} of {} runs, {} runs/s", p.done, p.runs, number(rate));
    if (rate > 0) text += fmt::format(", {} left", duration_text(static_cast<double>(p.runs - p.done) / rate));
    std::fputs((terminal_ ? "\r\033[K" + text : text + "\n").c_str(), stderr);
    std::fflush(stderr);
    visible_ = terminal_;
  }
  void clear() {
    if (visible_) std::fputs("\r\033[K", stderr);
    visible_ = false;
  }

 private:
  const bool terminal_ = ::isatty(STDERR_FILENO) == 1;
  const double every_ = seconds_between_lines();
  double told_ = 0;  // [s]
  bool visible_ = false;
};

void outline(const SweepArguments& arguments) {
  Diagnostics diagnostics;
  const auto found = outline_sweep(arguments.study, arguments.kind, diagnostics);
  if (!found) throw Failure(diagnostics);
  std::string text;
  for (const SweepOutline::Axis& axis : found->axes) {
    const std::string what = axis.levels == 0 ? "drawn from a distribution" : fmt::format("{} values", axis.levels);
    text += fmt::format("  {}: {}\n", axis.name, what);
  }
  print(fmt::format("{}: {} runs{}\n{}{} numbers are kept of each run\n", arguments.study, found->runs,
                    found->is_grid ? "" : " sampled", text, found->values));
}

long count(std::size_t runs) { return static_cast<long>(runs); }

void report_end(const SweepArguments& arguments, const SweepReport& report) {
  if (!report.finished) {
    throw Failure(exit_other, fmt::format("Stopped: {} of {} runs are done and kept in {}.part; the same command with "
                                          "--resume goes on",
                                          report.done, report.runs, arguments.output));
  }
  if (report.failed > 0) message("warning: " + report.first_failure);
  // What else is to be said of the runs a report says; this must not be missed.
  StudyOutcome outcome{.runs = count(report.runs),
                       .failed = count(report.failed),
                       .unmodelled = count(report.unmodelled),
                       .remarked = count(report.remarked),
                       .doubted = count(report.doubted),
                       .open = report.open};
  for (const auto& [key, runs] : report.remarks) outcome.remarks.emplace_back(key, count(runs));
  for (const SaidStatement& one : said(study_story(outcome).statements, Words("en"))) {
    if (one.severity == Severity::danger) message("warning: " + one.text);
  }
  if (arguments.quiet) return;
  if (report.before) {
    print(fmt::format("{} runs were done before, nothing to do: {}\n", report.runs, arguments.output));
    return;
  }
  const double rate = static_cast<double>(report.solved) / std::max(report.seconds, 1e-9);
  print(fmt::format(
      "{} runs, {:.0f} impacts, {} failed, {} with remarks, {} in doubt, {} runs/s ({} runs in {:.3g} s): {}\n",
      report.runs, report.impacts, report.failed, report.remarked, report.doubted, number(rate), report.solved,
      report.seconds, arguments.output));
}

void run(const SweepArguments& arguments) {
  if (arguments.check) return outline(arguments);
  if (arguments.output.empty())
    throw Failure(exit_bad_input, fmt::format("bentur {}: --output is required", name(arguments.kind)));
  if (is_standard_output(arguments.output)) {
    throw Failure(exit_bad_input, fmt::format("bentur {}: --output {}: results in NetCDF cannot be streamed; give the "
                                              "name of a file",
                                              name(arguments.kind), arguments.output));
  }
  Ranks ranks;
  try {
    const bool leads = ranks.rank() == 0;
    SweepOptions options;
    options.kind = arguments.kind;
    options.output = arguments.output;
    options.resume = arguments.resume;
    options.force = arguments.force;
    options.threads = arguments.threads;
    options.version = std::string(version());
    options.stop = StopOnSignal::asked;
    Line line;
    if (leads && !arguments.quiet) {
      options.progress = [&line](const SweepProgress& progress) { line.show(progress); };
    }
    if (leads && arguments.resume && !std::filesystem::exists(arguments.output + ".part") &&
        !std::filesystem::exists(arguments.output)) {
      message(arguments.output + ".part: not there, nothing to go on with: beginning anew");
    }
    const StopOnSignal stop;
    Diagnostics diagnostics;
    const auto report = sweep(arguments.study, options, ranks, diagnostics);
    line.clear();
    if (!leads) {
      if (!report) throw Failure(exit_bad_input, "");  // rank 0 says why
      return;
    }
    if (!report) throw Failure(diagnostics);
    report_end(arguments, *report);
  } catch (const Failure& failure) {
    // Said before the ranks part: the first that ends with an error makes mpirun end the others.
    if (*failure.what() != '\0') message(failure.what());
    throw Failure(failure.status(), "");
  } catch (const RefusedOutput& error) {
    message(error.what());
    ranks.end_job(exit_bad_input);
    throw Failure(exit_bad_input, "");
  } catch (const std::exception& error) {
    message(std::string("bentur: ") + error.what());
    ranks.end_job(exit_other);  // the others would wait for ever
    throw Failure(exit_other, "");
  }
}

void add_options(CLI::App& command, const std::shared_ptr<SweepArguments>& arguments) {
  command.add_option("STUDY", arguments->study, "the study file (TOML): a case and what varies in it")
      ->required()
      ->check(not_empty());
  command.add_option("-o,--output", arguments->output, "file for the results (NetCDF-4)")
      ->check(not_empty())
      ->type_name("FILE");
  command.add_flag("--resume", arguments->resume, "go on with unfinished work; leave finished work as it is");
  command.add_flag("--check", arguments->check, "read and validate only, and say how many runs there are");
  command.add_option("--threads", arguments->threads, "threads of each process; default: all, under mpirun one")
      ->check(CLI::Range(1, 4096));
  command.add_flag("-q,--quiet", arguments->quiet, "no progress, no last line");
  add_force(command, arguments->force);
  command.callback([arguments] { run(*arguments); });
}

}  // namespace

void add_sweep_command(CLI::App& app) {
  CLI::App* command = app.add_subcommand("sweep", "Run a case many times with varied values");
  add_options(*command, std::make_shared<SweepArguments>());
  command->footer(
      "Example: bentur sweep study.toml -o results.nc\n"
      "On a cluster: mpirun -n 64 bentur sweep study.toml -o results.nc --resume");
}

void add_ida_command(CLI::App& app) {
  const auto arguments = std::make_shared<SweepArguments>();
  arguments->kind = StudyKind::ida;
  CLI::App* command = app.add_subcommand("ida", "Incremental dynamic analysis: a sweep with every record scaled");
  add_options(*command, arguments);
  command->footer(
      "The study has [ida] with intensity = \"pga\" or \"sa\" and levels; bentur fragility takes the results.\n"
      "Example: bentur ida study.toml -o ida.nc\n"
      "On a cluster: mpirun -n 64 bentur ida study.toml -o ida.nc --resume");
}

}  // namespace bentur::cli
