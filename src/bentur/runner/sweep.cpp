#include "bentur/runner/sweep.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <tbb/info.h>

#include <chrono>
#include <map>
#include <memory>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "bentur/files/netcdf.h"
#include "bentur/files/netcdf_kind.h"
#include "bentur/io/output/atomic_file.h"
#include "bentur/runner/internal/distribute.h"
#include "bentur/runner/internal/sweep_netcdf.h"
#include "bentur/study/plan/study_check.h"
#include "bentur/study/study_variables.h"

namespace bentur {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

double since(Clock::time_point begin) { return std::chrono::duration<double>(Clock::now() - begin).count(); }

std::unique_ptr<StudyRuns> checked_runs(const fs::path& file, StudyKind kind, Diagnostics& diagnostics) {
  std::optional<Study> study = read_study(file, diagnostics);
  if (!study) return nullptr;
  if (kind == StudyKind::sweep && study->ida) {
    diagnostics.error(study->ida->position, "[ida] makes this an incremental dynamic analysis: use bentur ida");
    return nullptr;
  }
  if (kind == StudyKind::ida && !study->ida) {
    diagnostics.error({file.string(), 0, 0},
                      "[ida] is missing, with intensity and levels; without it use bentur sweep");
    return nullptr;
  }
  check_names(*study, diagnostics);
  const auto memo = std::make_shared<CaseMemo>();
  std::optional<StudyFacts> facts = check_study(*study, *memo, diagnostics);
  if (!facts || !diagnostics.ok()) return nullptr;
  return std::make_unique<StudyRuns>(std::move(*study), std::move(*facts), memo);
}

JournalOrigin origin_of(const StudyRuns& runs, const SweepOptions& options) {
  return {.version = options.version,
          .study = runs.study().text,
          .case_text = runs.study().case_text,
          .records = runs.facts().records,
          .runs = runs.plan().runs(),
          .values = row_size(runs.quantities())};
}

Journal open_journal(const fs::path& file, const JournalOrigin& origin, bool resume) {
  std::error_code failed;
  const fs::file_status there = fs::status(file, failed);
  if (!fs::exists(there)) return Journal::begin(file, origin);
  if (!fs::is_regular_file(there)) throw RefusedOutput(file, "is not a file; remove it, or give another name");
  if (!resume) {
    throw std::runtime_error(file.string() +
                             ": results of an unfinished sweep are there: go on with --resume, or remove the file");
  }
  return Journal::resume(file, origin);
}

/// Names and hashes out of the attribute that SweepFile has made of them, a line each.
std::map<std::string, std::string> records_of(const std::string& attribute) {
  std::map<std::string, std::string> records;
  std::istringstream lines(attribute);
  for (std::string line; std::getline(lines, line);) {
    const std::size_t blank = line.find("  ");
    if (blank != std::string::npos) records[line.substr(blank + 2)] = line.substr(0, blank);
  }
  return records;
}

/// Whether the results are there already, all of them, of the same study. @throws std::runtime_error when they are of
/// another one: to go on with them would be to lose them.
bool is_finished(const fs::path& output, ResultKind kind, const JournalOrigin& origin) {
  std::error_code failed;
  if (!fs::is_regular_file(output, failed) || !is_netcdf_result(output, kind)) return false;
  const NetcdfReader results(output);
  JournalOrigin there = origin;
  there.version = results.attribute("bentur_version");
  there.study = results.attribute("study");
  there.case_text = results.attribute("case");
  there.records = records_of(results.attribute("records"));
  if (const auto differs = difference(there, origin)) {
    throw std::runtime_error(fmt::format("{}: these finished results were begun {}. Without --resume they are replaced",
                                         output.string(), *differs));
  }
  return true;
}

/// What must not be written over.
OutputRules rules_of(const StudyRuns& runs, bool force) {
  OutputRules rules{
      .inputs = {runs.study().file, runs.study().case_file}, .force = force, .is_netcdf = &is_netcdf_result};
  rules.inputs.insert(rules.inputs.end(), runs.facts().record_files.begin(), runs.facts().record_files.end());
  return rules;
}

/// The folder for the results.
void make_folder(const fs::path& folder) {
  std::error_code code;
  if (folder.empty() || fs::create_directories(folder, code) || !code) return;
  if (code == std::errc::not_a_directory)
    throw RefusedOutput(folder, "is not a folder, or below something that is none");
  throw std::runtime_error(folder.string() + ": cannot create the folder: " + code.message());
}

/// The results under their own name once they are whole.
SweepTotals write_results(const fs::path& output, ResultKind kind, const OutputRules& rules, const StudyRuns& runs,
                          const Journal& journal, const std::string& version) {
  const fs::path target = output_target(output, kind, rules);  // again: much may have happened since
  const fs::path unfinished = make_temporary(target);
  try {
    const SweepTotals totals = write_sweep_netcdf(unfinished, runs, journal, version);
    OpenFile(::open(unfinished.c_str(), O_RDONLY | O_CLOEXEC), output).sync();
    fs::rename(unfinished, target);
    return totals;
  } catch (...) {
    std::error_code ignored;
    fs::remove(unfinished, ignored);
    throw;
  }
}

int default_threads(const Ranks& ranks) { return ranks.size() > 1 ? 1 : tbb::info::default_concurrency(); }

}  // namespace

std::optional<SweepOutline> outline_sweep(const fs::path& study, StudyKind kind, Diagnostics& diagnostics) {
  const std::unique_ptr<StudyRuns> runs = checked_runs(study, kind, diagnostics);
  if (!runs) return std::nullopt;
  SweepOutline outline;
  for (std::size_t axis = 0; axis < runs->study().axes.size(); ++axis) {
    outline.axes.push_back({runs->study().axes[axis], runs->plan().axes()[axis].levels});
  }
  outline.is_grid = runs->plan().is_grid();
  outline.runs = runs->plan().runs();
  outline.values = row_size(runs->quantities());
  return outline;
}

std::optional<SweepReport> sweep(const fs::path& study, const SweepOptions& options, Ranks& ranks,
                                 Diagnostics& diagnostics) {
  const std::unique_ptr<StudyRuns> runs = checked_runs(study, options.kind, diagnostics);
  if (!runs) return std::nullopt;
  WorkOptions work_options;
  work_options.threads = options.threads > 0 ? options.threads : default_threads(ranks);
  work_options.stop = options.stop;
  SweepReport report;
  if (ranks.rank() != 0) {
    work(*runs, ranks, work_options);
    return report;
  }
  const ResultKind kind = options.kind == StudyKind::ida ? ResultKind::ida : ResultKind::sweep;
  const OutputRules rules = rules_of(*runs, options.force);
  const JournalOrigin origin = origin_of(*runs, options);
  const fs::path part = options.output.string() + ".part";
  static_cast<void>(output_target(options.output, kind, rules));
  std::error_code failed;
  if (options.resume && !fs::exists(part, failed) && is_finished(options.output, kind, origin)) {
    dismiss_workers(ranks);
    report.finished = report.before = true;
    report.runs = report.done = runs->plan().runs();
    return report;
  }
  make_folder(options.output.parent_path());
  Journal journal = open_journal(part, origin, options.resume);
  const auto began = Clock::now();
  const std::size_t before = journal.done();
  auto shown = began;
  work_options.finished = [&](std::size_t done) {
    if (!options.progress || Clock::now() - shown < std::chrono::milliseconds(200)) return;
    shown = Clock::now();
    options.progress({runs->plan().runs(), done, before, since(began)});
  };
  report.finished = coordinate(*runs, journal, ranks, work_options);
  report.runs = runs->plan().runs();
  report.done = journal.done();
  report.solved = report.done - before;
  report.seconds = since(began);
  if (!report.finished) return report;
  static_cast<SweepTotals&>(report) = write_results(options.output, kind, rules, *runs, journal, options.version);
  fs::remove(part);
  return report;
}

}  // namespace bentur
