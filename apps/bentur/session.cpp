#include "session.h"

#include <fmt/format.h>
#ifdef __GLIBC__
#include <malloc.h>
#endif
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <numbers>
#include <string_view>
#include <system_error>
#include <utility>
#include <variant>

#include "bentur/files/example_files.h"
#include "bentur/io/case/case_toml.h"
#include "bentur/io/records/record_files.h"
#include "bentur/io/temporary_folder.h"
#include "bentur/model/gap/spectral_gap.h"
#include "bentur/model/limits.h"
#include "bentur/model/plan/plan_row.h"
#include "bentur/pounding/pounding.h"
#include "bentur/report/errors.h"
#include "bentur/report/story_text.h"
#include "bentur/report/utf8.h"
#include "cases/suite.h"
#include "text/effort_text.h"
#include "text/table.h"

namespace bentur::cli {
namespace {

constexpr std::size_t most_errors_shown = 20;

std::string all_of(const Diagnostics& diagnostics, const std::string& language) {
  const std::vector<Diagnostic> errors = diagnostics.errors();
  std::string text;
  for (std::size_t i = 0; i < std::min(errors.size(), most_errors_shown); ++i) {
    text += (text.empty() ? "" : "\n") + error_text(errors[i], language);
  }
  if (errors.size() <= most_errors_shown) return text;
  return text + "\n" + error_words(fmt::format("and {} more errors", errors.size() - most_errors_shown), language);
}

std::atomic<bool> stop_asked = false;
static_assert(std::atomic<bool>::is_always_lock_free);

extern "C" void ask_stop(int) { stop_asked = true; }

}  // namespace

StopOnSignal::StopOnSignal() {
  struct sigaction action {};
  action.sa_handler = ask_stop;
  action.sa_flags = static_cast<int>(SA_RESTART | SA_RESETHAND);
  sigaction(SIGINT, &action, &interrupt_);
  sigaction(SIGTERM, &action, &terminate_);
}

StopOnSignal::~StopOnSignal() {
  sigaction(SIGINT, &interrupt_, nullptr);
  sigaction(SIGTERM, &terminate_, nullptr);
}

bool StopOnSignal::asked() { return stop_asked.load(std::memory_order_relaxed); }

void Progress::show(double fraction) {
  const auto now = std::chrono::steady_clock::now();
  if (!terminal_ || now - start_ < std::chrono::seconds(2) || now - shown_ < std::chrono::milliseconds(200)) return;
  shown_ = now;
  std::fputs(fmt::format("\r{:3.0f} % {}", 100 * fraction, what_).c_str(), stderr);
  std::fflush(stderr);
  visible_ = true;
}

Progress::Progress(std::string what) : what_(std::move(what)), terminal_(::isatty(STDERR_FILENO) == 1) {}

Progress::~Progress() {
  if (visible_) std::fputs("\r\033[K", stderr);
}

Notice::Notice(const std::string& what) {
  if (::isatty(STDERR_FILENO) != 1) return;
  const auto tell = [this, what] {
    std::unique_lock lock(mutex_);
    if (changed_.wait_for(lock, std::chrono::seconds(1), [this] { return over_; })) return;
    std::fputs(what.c_str(), stderr);
    changed_.wait(lock, [this] { return over_; });
    std::fputs("\r\033[K", stderr);
  };
  try {
    teller_ = std::thread(tell);
  } catch (const std::system_error&) {  // no thread can be had: nothing is told
  }
}

Notice::~Notice() {
  {
    const std::lock_guard lock(mutex_);
    over_ = true;
  }
  changed_.notify_one();
  if (teller_.joinable()) teller_.join();
}

Failure::Failure(const Diagnostics& diagnostics, const std::string& language)
    : Failure(exit_bad_input, all_of(diagnostics, language)) {}

Loaded load(const std::filesystem::path& file, const std::string& language) {
  Diagnostics diagnostics;
  MadeParts made;
  std::optional<Case> c;
  {
    const Notice notice("reading the case and computing the modes of its buildings");
    Progress display("of the spectra of the records");
    c = read_case(file, diagnostics, &made, [&](double fraction) { display.show(fraction); });
  }
  if (!c) throw Failure(diagnostics, language);
  std::vector<std::filesystem::path> files = files_read(*c);
  files.push_back(file);
  if (c->is_in_plan()) {
    Problem row = c->excitation.spectrum ? row_of(made.plan) : Problem();
    return {std::move(*c), std::move(row), std::move(made.plan), std::move(files)};
  }
  try {
    Problem problem = make_still_problem(*c, std::move(made.buildings));
    return {std::move(*c), std::move(problem), {}, std::move(files)};
  } catch (const std::exception& error) {
    throw Failure(exit_bad_input, error_text({.position = {.file = file.string()}, .rule = error.what()}, language));
  }
}

SpectralGaps spectral_gaps(const Loaded& loaded) {
  const Case& c = loaded.c;
  const SpectrumSpec& spectrum = *c.excitation.spectrum;
  return c.is_in_plan() ? bentur::spectral_gaps(loaded.plan, spectrum, c.code, c.units)
                        : bentur::spectral_gaps(loaded.problem, spectrum, c.code, c.units);
}

Loaded load_example(const std::string& name) {
  std::string known;
  for (const Example& example : examples()) {
    if (example.name == name) {
      const TemporaryFolder folder;
      return load(write_example(example, folder.path()));
    }
    known += fmt::format(" {}", example.name);
  }
  throw Failure(exit_bad_input, "no example \"" + name + "\"; there are:" + known);
}

void refuse_unless_done(Status status, const std::string& message, double done, const std::string& language) {
  if (status == Status::stopped) {
    const std::string stopped = fmt::format(
        "Stopped at {:.0f} % of the work. Nothing is written; results written before are as they were", 100 * done);
    throw Failure(exit_other, error_words(stopped, language));
  }
  if (status != Status::done && status != Status::collapsed) {
    throw Failure(exit_numbers_failed, error_words("the numbers failed: " + message, language));
  }
}

namespace {

void refuse_beyond_limits(const Loaded& loaded, const std::string& refusal, const std::string& language) {
  if (refusal.empty()) return;
  const std::string file = loaded.files.back().string();
  throw Failure(exit_bad_input, error_text({.position = {.file = file}, .rule = refusal}, language));
}

}  // namespace

namespace {

/// What the solver has freed, to the system: of a block it is most of what there is, in pieces that what is written
/// afterwards does not fit into.
void give_back_memory() {
#ifdef __GLIBC__
  ::malloc_trim(0);
#endif
}

template <class AnyProblem>
auto simulated(const Loaded& loaded, const AnyProblem& problem, double output_step, bool progress,
               const std::string& language) {
  SolveOptions options = solve_options(loaded.c);
  options.output_step = output_step;
  options.energy_step = loaded.c.analysis.output_step;
  options.course = output_step > 0;
  const Effort needed = effort(problem, loaded.c.analysis.solver, options);
  refuse_beyond_limits(loaded, beyond_limits(loaded.c, problem, needed), language);
  const std::string warning = long_run_text(loaded.c, problem, needed, Words(language));
  if (progress && !warning.empty()) message(warning);
  auto response = solve_shown(options, progress, language, [&](const SolveOptions& shown) {
    return solve(problem, loaded.c.analysis.solver, shown);
  });
  give_back_memory();
  return run_results(loaded.c, problem, std::move(response));
}

}  // namespace

RunResults simulate(const Loaded& loaded, const Problem& problem, double output_step, bool progress,
                    const std::string& language) {
  return simulated(loaded, problem, output_step, progress, language);
}

PlanRun simulate(const Loaded& loaded, const PlanProblem& problem, double output_step, bool progress,
                 const std::string& language) {
  return simulated(loaded, problem, output_step, progress, language);
}

std::string solver_name(const Solver& solver) {
  std::string text(name(solver));
  if (const auto* adaptive = std::get_if<AdaptiveSolver>(&solver)) {
    text += fmt::format(", tolerance {}", adaptive->tolerance);
  }
  if (const auto* stepwise = std::get_if<RungeKuttaSolver>(&solver)) {
    text += fmt::format(", step {} s", number(stepwise->step));
  }
  return text;
}

std::string unit_of(const RecordEcho& record) {
  return record.unit.ends_with("/s2") ? record.unit.substr(0, record.unit.size() - 1) + "²" : record.unit;
}

std::string record_line(const RecordEcho& record, const Words& say) {
  return say("cli.record", {{"file", record.file},
                            {"format", record.format},
                            {"unit", unit_of(record)},
                            {"notes", echo_notes(record)},
                            {"count", std::to_string(record.count)},
                            {"step", number(record.time_step)},
                            {"duration", number(record.duration)}});
}

std::string excitation_line(const ExcitationSpec& excitation, const Units& units, const Words& say) {
  std::string line;
  const std::string acceleration = units.length + "/s²";
  if (excitation.record) {
    const RecordEcho& record = *excitation.record;
    line = record_line(record, say) + "\n       " +
           say("cli.record_peak", {{"read", number(record.pga_read)},
                                   {"unit", unit_of(record)},
                                   {"applied", number(record.pga)},
                                   {"acceleration", acceleration}});
  } else if (const auto* harmonic = std::get_if<HarmonicMotion>(&excitation.motion)) {
    line =
        say("cli.harmonic", {{"phase", say(harmonic->phase == HarmonicMotion::Phase::sine ? "cli.sine" : "cli.cosine")},
                             {"period", number(harmonic->period)},
                             {"amplitude", number(std::abs(harmonic->displacement_amplitude))},
                             {"length", units.length},
                             {"peak", number(peak_acceleration(excitation.motion))},
                             {"acceleration", acceleration}});
    if (harmonic->is_reversed()) line += say("cli.reversed");
  } else if (excitation.suite) {
    line = suite_line(*excitation.suite, say);
  } else if (excitation.spectrum) {
    const SpectrumSpec& spectrum = *excitation.spectrum;
    if (spectrum.of_displacements) return say("cli.displacements");
    return say("cli.spectrum", {{"name", spectrum.file.empty() ? spectrum.shape : spectrum.file},
                                {"parameters", spectrum_parameters(spectrum, units)},
                                {"damping", number(spectrum.spectrum.damping_ratio)},
                                {"corrected", spectrum.spectrum.corrects_damping ? say("cli.corrected") : ""},
                                {"combination", spectrum.combination == ModalCombination::cqc ? "CQC" : "SRSS"}});
  } else {
    return say("cli.free");
  }
  const std::vector<double>& delays = excitation.delays;
  if (std::any_of(delays.begin(), delays.end(), [](double delay) { return delay != 0; })) {
    std::string all;
    for (const double delay : delays) all += (all.empty() ? "" : ", ") + number(delay);
    line += say("cli.delays", {{"delays", all}});
  }
  return line;
}

std::string excitation_lines(const Case& c, const Words& say) {
  const std::string text = excitation_line(c.excitation, c.units, say) + "\n";
  if (std::holds_alternative<NoMotion>(c.excitation_y.motion)) return text;
  return text + say("cli.along_y", {{"motion", excitation_line(c.excitation_y, c.units, say)}}) + "\n";
}

std::string heading(const Case& c, const Words& say) {
  return (c.title.empty() ? "" : c.title + "\n") + excitation_lines(c, say);
}

std::string story_text(const std::vector<std::string>& gaps, const Story& story, const Words& say, Told told) {
  const std::vector<SaidStatement> all = said(story.statements, say);
  std::string text;
  for (const std::string& line : story_lines(gaps, all, say, told)) text += with_spaces(wrapped(line)) + "\n";
  if (told == Told::remarks) return text;
  const auto known = known_table(gaps, all, say);
  for (const bool of_gaps : {true, false}) {
    for (const StoryTable& table : story.tables) {
      if (table.kind.starts_with("row") == of_gaps) text += "\n" + table_text(said(table, say));
    }
    if (of_gaps && known) text += "\n" + table_text(*known);
  }
  return text;
}

std::string proportions_text(const Building& building, const Proportions& found, const ShownUnits& shown,
                             const Words& say) {
  if (building.given) return say("cli.given_peaks");
  if (building.is_rigid()) return say("cli.moves");
  const auto& factor = building.model.stiffness_factor;
  return say("cli.proportions", {{"weight", number(shown.force * found.weight)},
                                 {"force", shown.units.force},
                                 {"period", number(2 * std::numbers::pi / building.first_omega())},
                                 {"per_storey", number(found.period_per_storey)},
                                 {"scaled", factor ? say("cli.scaled", {{"factor", number(*factor)}}) : ""}});
}

std::string harmless(const std::string& text) {
  std::string shown;
  for (const auto& [bytes, code] : characters(text)) {
    const bool is_control = code < 0x20 ? code != '\n' && code != '\t' : code >= 0x7F && code < 0xA0;
    shown += is_control ? fmt::format("\\u{:04x}", code < 0 ? 0xFFFD : code) : std::string(bytes);
  }
  return shown;
}

namespace {

/// Whether colours may be used: on a terminal, unless NO_COLOR says otherwise (no-color.org).
bool has_colours() {
  const char* const none = std::getenv("NO_COLOR");
  const char* const terminal = std::getenv("TERM");
  return (none == nullptr || *none == '\0') && ::isatty(STDOUT_FILENO) == 1 &&
         (terminal == nullptr || std::string_view(terminal) != "dumb");
}

/// Verdicts, which begin a line or follow a gap's name in capitals, in bold and red, or green where nothing collides.
std::string with_colours(std::string text) {
  for (const std::string& language : report_languages()) {
    const Words say(language);
    for (const std::string& key : text_keys("story.")) {
      if (!key.ends_with(".badge")) continue;
      const std::string words = upper_case(say(key)) + ":";
      const bool good = key == "story.no_pounding.badge" || key == "story.spectral_enough.badge";
      for (std::size_t at = text.find(words); at != std::string::npos; at = text.find(words, at)) {
        const bool begins = at == 0 || text[at - 1] == '\n' || (at > 1 && text.compare(at - 2, 2, ": ") == 0);
        const std::string shown =
            begins ? fmt::format("{}{}\x1b[0m", good ? "\x1b[1;32m" : "\x1b[1;31m", words) : words;
        text.replace(at, words.size(), shown);
        at += shown.size();
      }
    }
  }
  return text;
}

}  // namespace

void print(const std::string& text) {
  const std::string shown = has_colours() ? with_colours(harmless(text)) : harmless(text);
  std::fwrite(shown.data(), 1, shown.size(), stdout);
}

void message(const std::string& text) {
  std::fflush(stdout);  // what was printed before stands before it, also where both go to one place
  // Where nobody can be told, the exit status still says it: fmt::print would throw.
  std::fputs((harmless(text) + "\n").c_str(), stderr);
}

}  // namespace bentur::cli
