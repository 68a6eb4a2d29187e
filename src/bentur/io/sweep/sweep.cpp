#include "bentur/io/sweep/sweep.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <tbb/info.h>
#include <unistd.h>

#include <chrono>
#include <memory>
#include <stdexcept>
#include <utility>

#include "bentur/io/study/study_check.h"
#include "bentur/io/sweep/distribute.h"
#include "bentur/io/sweep/sweep_netcdf.h"

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

Journal open_journal(const fs::path& file, const StudyRuns& runs, const SweepOptions& options) {
  const JournalOrigin origin{.version = options.version,
                             .study = runs.study().text,
                             .case_text = runs.study().case_text,
                             .records = runs.facts().records,
                             .runs = runs.plan().runs(),
                             .values = row_size(runs.quantities())};
  std::error_code failed;
  if (!fs::exists(file, failed)) return Journal::begin(file, origin);
  if (!options.resume) {
    throw std::runtime_error(file.string() +
                             ": results of an unfinished sweep are there: go on with --resume, or remove the file");
  }
  return Journal::resume(file, origin);
}

/// What would only show when all the work is done.
void check_output(const fs::path& output, const StudyRuns& runs) {
  std::error_code failed;
  if (fs::is_directory(output, failed)) throw std::runtime_error(output.string() + ": is a folder");
  for (const fs::path& input : {runs.study().file, runs.study().case_file}) {
    if (fs::equivalent(output, input, failed)) throw std::runtime_error(output.string() + ": is the study or its case");
  }
}

/// The results under their own name once they are whole.
SweepTotals write_results(const fs::path& output, const StudyRuns& runs, const Journal& journal,
                          const std::string& version) {
  const fs::path unfinished = output.string() + ".new";
  try {
    const SweepTotals totals = write_sweep_netcdf(unfinished, runs, journal, version);
    const int descriptor = ::open(unfinished.c_str(), O_RDONLY | O_CLOEXEC);
    const bool synced = descriptor >= 0 && ::fsync(descriptor) == 0;
    if (descriptor >= 0) ::close(descriptor);
    if (!synced) throw std::runtime_error(unfinished.string() + ": cannot write");
    fs::rename(unfinished, output);
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
  WorkOptions work;
  work.threads = options.threads > 0 ? options.threads : default_threads(ranks);
  work.stop = options.stop;
  SweepReport report;
  if (ranks.rank() != 0) {
    follow_work(*runs, ranks, work);
    return report;
  }
  check_output(options.output, *runs);
  const fs::path part = options.output.string() + ".part";
  Journal journal = open_journal(part, *runs, options);
  const auto began = Clock::now();
  const std::size_t before = journal.done();
  auto shown = began;
  work.finished = [&](std::size_t done) {
    if (!options.progress || Clock::now() - shown < std::chrono::milliseconds(200)) return;
    shown = Clock::now();
    options.progress({runs->plan().runs(), done, before, since(began)});
  };
  report.finished = lead_work(*runs, journal, ranks, work);
  report.runs = runs->plan().runs();
  report.done = journal.done();
  report.solved = report.done - before;
  report.seconds = since(began);
  if (!report.finished) return report;
  const SweepTotals totals = write_results(options.output, *runs, journal, options.version);
  report.impacts = totals.impacts;
  report.unmodelled = totals.unmodelled;
  report.failed = totals.failed;
  report.first_failure = totals.first_failure;
  fs::remove(part);
  return report;
}

}  // namespace bentur
