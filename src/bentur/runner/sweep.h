#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "bentur/core/diagnostics.h"
#include "bentur/model/story/study_story.h"
#include "bentur/runner/ranks.h"
#include "bentur/study/study_output.h"

namespace bentur {

struct SweepProgress {
  std::size_t runs = 0;
  std::size_t done = 0;    ///< of all runs
  std::size_t before = 0;  ///< of those the ones done when this program began
  double seconds = 0;      ///< since then [s]
};

struct SweepOptions : StudyOutputOptions {
  int threads = 0;  ///< of this process; 0: one per processor it may use, under mpirun one
  std::function<void(const SweepProgress&)> progress;  ///< a few times a second
  std::function<bool()> stop;                          ///< asked often, by many threads; true: end as soon as possible
};

/// Sums over all runs of a study.
struct SweepTotals {
  double impacts = 0;
  std::size_t unmodelled = 0;                       ///< runs in which a watched floor closed
  std::size_t remarked = 0, doubted = 0;            ///< runs with a remark, with a doubt
  std::map<std::string, std::size_t> remarks = {};  ///< runs with a remark, by what it is about
  OpenNeeds open = {};                              ///< runs of which it is not known what gap they need
  std::size_t failed = 0;                           ///< runs whose numbers failed or whose values make no case
  std::string first_failure;                        ///< "run 17: REASON"
};

struct SweepReport : SweepTotals {
  bool finished = false;  ///< false: stopped; the journal is kept
  bool before = false;    ///< all was done before: nothing is written, and nothing but `runs` and `done` is known
  std::size_t runs = 0, done = 0;
  std::size_t solved = 0;  ///< by this program, not before
  double seconds = 0;      ///< that took [s]
};

/// What a study would run.
struct SweepOutline {
  struct Axis {
    std::string name;
    std::size_t levels = 0;  ///< 0: drawn from a distribution
  };
  std::vector<Axis> axes;
  bool is_grid = true;
  std::size_t runs = 0;
  std::size_t values = 0;  ///< kept of each run
};

/// Reads and checks a study without running it. @return nothing when there is an error, all of which are in
/// `diagnostics`; a study of the other kind is one.
[[nodiscard]] std::optional<SweepOutline> outline_sweep(const std::filesystem::path& study, StudyKind kind,
                                                        Diagnostics& diagnostics);

/// Runs a study and writes its results as NetCDF-4 (docs/studies.md), with all threads of all ranks of the job. Folders
/// that are missing are made. With `resume` results that are there already are left as they are, if they are of the
/// same study. The file does not depend on their number, on the order of work or on interruptions. Until all runs are
/// done their results are in the journal, which no kill can take back. Rank 0 writes and reports; on the others the
/// report is empty.
/// @return nothing when the study or its case has an error, all of which are in `diagnostics`.
/// @throws RefusedOutput where the output or its journal would harm something; std::runtime_error with file and reason
///   when a file cannot be written, a journal is there (or with `resume` it, or finished results, are another study's).
[[nodiscard]] std::optional<SweepReport> sweep(const std::filesystem::path& study, const SweepOptions& options,
                                               Ranks& ranks, Diagnostics& diagnostics);

}  // namespace bentur
