#pragma once

#include <signal.h>

#include <chrono>
#include <condition_variable>
#include <filesystem>
#include <mutex>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "bentur/core/diagnostics.h"
#include "bentur/core/in_a_thread.h"
#include "bentur/model/gap/spectral_gap.h"
#include "bentur/model/plan/plan_run.h"
#include "bentur/model/run_results.h"
#include "bentur/report/story_text.h"

namespace bentur::cli {

/// Exit statuses of the program.
enum ExitStatus : int { exit_done = 0, exit_other = 1, exit_bad_input = 2, exit_numbers_failed = 3 };

/// Ends the command with a status and a message for standard error.
class Failure : public std::runtime_error {
 public:
  Failure(ExitStatus status, const std::string& message) : std::runtime_error(message), status_(status) {}
  /// Bad input, with every error found.
  explicit Failure(const Diagnostics& diagnostics, const std::string& language = "en");
  [[nodiscard]] ExitStatus status() const noexcept { return status_; }

 private:
  ExitStatus status_;
};

/// How far a long run is, after two seconds, on one line of a terminal that is cleared at the end.
class Progress {
 public:
  /// `what` follows the percentage.
  explicit Progress(std::string what);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void show(double fraction);

 private:
  std::string what_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  std::chrono::steady_clock::time_point shown_ = start_;
  bool terminal_ = false;
  bool visible_ = false;
};

/// What is being done, where it is not over within a second, on one line of a terminal that is cleared at the end.
class Notice {
 public:
  explicit Notice(const std::string& what);
  ~Notice();
  Notice(const Notice&) = delete;
  Notice& operator=(const Notice&) = delete;

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  bool over_ = false;
  std::thread teller_;
};

struct Loaded {
  Case c;
  Problem problem;                           ///< of a row; in plan under a spectrum row_of() it
  PlanProblem plan;                          ///< in its place, of buildings in plan
  std::vector<std::filesystem::path> files;  ///< that it was read from
};

/// Reads a case and makes its problem. @throws Failure with every error found, in that language (exit_bad_input).
[[nodiscard]] Loaded load(const std::filesystem::path& file, const std::string& language = "en");

/// The gaps under the spectrum of a case that has one.
[[nodiscard]] SpectralGaps spectral_gaps(const Loaded& loaded);

/// The same for an example built into the program. @throws Failure when there is none of that name.
[[nodiscard]] Loaded load_example(const std::string& name);

/// While it lives, Ctrl-C (or whoever ends the job) asks for a stop; a second one ends the program as ever.
class StopOnSignal {
 public:
  StopOnSignal();
  ~StopOnSignal();
  StopOnSignal(const StopOnSignal&) = delete;
  StopOnSignal& operator=(const StopOnSignal&) = delete;

  [[nodiscard]] static bool asked();

 private:
  struct sigaction interrupt_ = {}, terminate_ = {};  ///< as they were
};

/// @throws Failure as solve_shown().
void refuse_unless_done(Status status, const std::string& message, double done, const std::string& language);

/// Calls `solve` while Ctrl-C stops it and work of more than two seconds shows how far it is, with `progress` and where
/// standard error is a terminal. `options` get the progress that does both. @throws Failure when it is stopped
/// (exit_other) and when the numbers fail (exit_numbers_failed); a storey that collapsed is no failure.
template <class Options, class Solve>
auto solve_shown(Options options, bool progress, const std::string& language, const Solve& solve) {
  double done = 0;
  const StopOnSignal stop;
  auto response = [&] {
    Progress display("of the duration simulated");
    options.beside = in_a_thread;
    options.progress = [&](double fraction) {
      done = fraction;
      if (progress) display.show(fraction);
      return !StopOnSignal::asked();
    };
    return solve(options);
  }();
  refuse_unless_done(response.status, response.message, done, language);
  return response;
}

/// Solves with the solver of the case; with histories every `output_step` [s] unless 0. Says so beforehand where it may
/// take long. With `progress`, work of more than two seconds shows how far it is, if standard error is a terminal.
/// @throws Failure when it takes more than the case's limits (exit_bad_input), when the numbers fail
/// (exit_numbers_failed) and when it is stopped (exit_other).
[[nodiscard]] RunResults simulate(const Loaded& loaded, const Problem& problem, double output_step, bool progress,
                                  const std::string& language);
/// The same of buildings in plan.
[[nodiscard]] PlanRun simulate(const Loaded& loaded, const PlanProblem& problem, double output_step, bool progress,
                               const std::string& language);

/// What `use` makes of the problem of a case, of a row or in plan.
template <class Use>
auto with_problem(const Loaded& loaded, const Use& use) {
  return loaded.c.is_in_plan() ? use(loaded.plan) : use(loaded.problem);
}
/// What `use` makes of a run of a case without histories, of a row or in plan.
template <class Use>
auto with_run(const Loaded& loaded, const std::string& language, const Use& use) {
  return with_problem(loaded, [&](const auto& problem) { return use(simulate(loaded, problem, 0, true, language)); });
}

/// "exact", or another one with its number: "runge-kutta, step 0.006 s".
[[nodiscard]] std::string solver_name(const Solver& solver);

/// What shakes the buildings, in one line: the record as it was read, or the harmonic motion.
[[nodiscard]] std::string excitation_line(const ExcitationSpec& excitation, const Units& units, const Words& say);
/// The same of a case, in plan along x and y.
[[nodiscard]] std::string excitation_lines(const Case& c, const Words& say);
/// The title, where there is one, and excitation_lines().
[[nodiscard]] std::string heading(const Case& c, const Words& say);
/// The unit of a record's numbers: "m/s²".
[[nodiscard]] std::string unit_of(const RecordEcho& record);
/// What was read from a record file, and how.
[[nodiscard]] std::string record_line(const RecordEcho& record, const Words& say);

/// story_lines(), wrapped, and of an outcome the tables of the story.
[[nodiscard]] std::string story_text(const std::vector<std::string>& gaps, const Story& story, const Words& say,
                                     Told told);

/// "743 kgf, first period 0.164 s, 0.05467 s per storey".
[[nodiscard]] std::string proportions_text(const Building& building, const Proportions& found, const ShownUnits& shown,
                                           const Words& say);

/// Text as a terminal may get it: control characters but for line ends and tabs, which could do anything to it, are
/// written out as \u001b, and what is not UTF-8 as \ufffd.
[[nodiscard]] std::string harmless(const std::string& text);

void print(const std::string& text);    ///< harmless(), to standard output
void message(const std::string& text);  ///< harmless(), a line to standard error

}  // namespace bentur::cli
