#include "bentur/runner/sweep.h"

#include <tbb/info.h>

#include <chrono>
#include <memory>
#include <utility>

#include "bentur/files/netcdf.h"
#include "bentur/files/netcdf_kind.h"
#include "bentur/runner/for_each_in_threads.h"
#include "bentur/runner/internal/distribute.h"
#include "bentur/runner/internal/sweep_netcdf.h"

namespace bentur {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

double since(Clock::time_point begin) { return std::chrono::duration<double>(Clock::now() - begin).count(); }

int default_threads(const Ranks& ranks) { return ranks.size() > 1 ? 1 : tbb::info::default_concurrency(); }

}  // namespace

std::optional<SweepOutline> outline_sweep(const fs::path& study, StudyKind kind, Diagnostics& diagnostics) {
  const std::unique_ptr<StudyRuns> runs =
      checked_runs(study, kind, "bentur ", diagnostics, for_each_in_threads(tbb::info::default_concurrency()));
  if (!runs) return std::nullopt;
  SweepOutline outline;
  for (std::size_t axis = 0; axis < runs->study().axes.size(); ++axis) {
    outline.axes.push_back({runs->study().axes[axis], runs->design().axes()[axis].levels});
  }
  outline.is_grid = runs->design().is_grid();
  outline.runs = runs->design().runs();
  outline.values = row_size(runs->quantities());
  return outline;
}

std::optional<SweepReport> sweep(const fs::path& study, const SweepOptions& options, Ranks& ranks,
                                 Diagnostics& diagnostics) {
  WorkOptions work_options;
  work_options.threads = options.threads > 0 ? options.threads : default_threads(ranks);
  const std::unique_ptr<StudyRuns> runs =
      checked_runs(study, options.kind, "bentur ", diagnostics, for_each_in_threads(work_options.threads));
  if (!runs) return std::nullopt;
  work_options.stop = options.stop;
  SweepReport report;
  if (ranks.rank() != 0) {
    work(*runs, ranks, work_options);
    return report;
  }
  require_netcdf();
  StudyOutputOptions output_options = static_cast<const StudyOutputOptions&>(options);
  output_options.is_netcdf = &is_netcdf_result;
  output_options.attribute = [](const fs::path& file, const std::string& name) {
    return NetcdfReader(file).attribute(name);
  };
  const StudyOutput output(*runs, output_options);
  if (output.is_finished()) {
    dismiss_workers(ranks);
    report.finished = report.before = true;
    report.runs = report.done = runs->design().runs();
    return report;
  }
  Journal journal = output.begin();
  const auto began = Clock::now();
  const std::size_t before = journal.done();
  auto shown = began;
  work_options.finished = [&](std::size_t done) {
    if (!options.progress || Clock::now() - shown < std::chrono::milliseconds(200)) return;
    shown = Clock::now();
    options.progress({runs->design().runs(), done, before, since(began)});
  };
  report.finished = coordinate(*runs, journal, ranks, work_options);
  report.runs = runs->design().runs();
  report.done = journal.done();
  report.solved = report.done - before;
  report.seconds = since(began);
  if (!report.finished) return report;
  output.finish([&](const fs::path& file) {
    static_cast<SweepTotals&>(report) = write_sweep_netcdf(file, *runs, journal, options.version);
  });
  return report;
}

}  // namespace bentur
