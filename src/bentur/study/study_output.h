#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>

#include "bentur/core/diagnostics.h"
#include "bentur/io/output/output_rules.h"
#include "bentur/study/journal.h"
#include "bentur/study/study_runs.h"

namespace bentur {

/// What a study is run as. One with [ida] is an incremental dynamic analysis, one without is a sweep.
enum class StudyKind { sweep, ida };

/// The runs of a study that has been read and checked, `for_each` value of many. @return null when it has an
/// error; all are in `diagnostics`.
[[nodiscard]] std::unique_ptr<StudyRuns> checked_runs(Study study, Diagnostics& diagnostics,
                                                      const ForEachNumber& for_each = one_after_the_other);
/// The same of a file; a study of the other kind is an error. @param door before the other one's name: "bentur "
[[nodiscard]] std::unique_ptr<StudyRuns> checked_runs(const std::filesystem::path& file, StudyKind kind,
                                                      const std::string& door, Diagnostics& diagnostics,
                                                      const ForEachNumber& for_each = one_after_the_other);

/// A file of results that is asked for, and what a user says to ask for it.
struct StudyOutputOptions {
  StudyKind kind = StudyKind::sweep;
  std::filesystem::path output;  ///< the results; the journal stands beside it with .part behind its name
  bool resume = false;           ///< goes on where a journal is left, instead of refusing to begin anew
  bool force = false;            ///< a file that is not results of the same kind may be replaced
  std::string version = {};      ///< of the program
  const char* resumed_by = "--resume";
  const char* forced_by = "--force";
  std::function<bool(const std::filesystem::path&, ResultKind)> is_netcdf = {};  ///< as OutputRules has it
  /// A text attribute of a file that `is_netcdf` knows; empty where there is none.
  std::function<std::string(const std::filesystem::path&, const std::string&)> attribute = {};
};

/// The file of results of a study: a journal until all runs are done, then the results under their own name
/// (docs/studies.md, "Interruptions"). Whoever uses it says how results are written and read.
class StudyOutput {
 public:
  /// `runs` must outlive it. @throws RefusedOutput where the output would harm something.
  StudyOutput(const StudyRuns& runs, StudyOutputOptions options);

  [[nodiscard]] ResultKind kind() const {
    return options_.kind == StudyKind::ida ? ResultKind::ida : ResultKind::sweep;
  }
  /// With `resume`: whether the results are there already, all of them, of the same study.
  /// @throws std::runtime_error when they are of another one: to go on with them would be to lose them.
  [[nodiscard]] bool is_finished() const;
  /// The journal, gone on with or begun; folders that are missing are made. @throws RefusedOutput, and
  /// std::runtime_error with file and reason when it cannot be written, is there, or with `resume` is another study's.
  [[nodiscard]] Journal begin() const;
  /// The results under their own name once `write` has made them whole under another; the journal is removed.
  void finish(const std::function<void(const std::filesystem::path&)>& write) const;

 private:
  [[nodiscard]] std::filesystem::path part() const { return options_.output.string() + ".part"; }
  [[nodiscard]] std::filesystem::path target() const;

  StudyOutputOptions options_;
  OutputRules rules_;
  JournalOrigin origin_;
};

}  // namespace bentur
