#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "bentur/io/output/atomic_file.h"
#include "bentur/model/case.h"

namespace bentur::cli {

/// "-" and "/dev/stdout".
[[nodiscard]] bool is_standard_output(const std::string& name);

/// A result that is one file, or goes to standard output.
class OutputFile {
 public:
  /// Before the work, so that a place that cannot be written to costs none. @throws RefusedOutput by the rules.
  OutputFile(const std::string& name, ResultKind kind, OutputRules rules);
  [[nodiscard]] bool is_streamed() const { return !files_; }
  void write(const std::string& content);

 private:
  std::string name_;  ///< without folders
  ResultKind kind_;
  std::optional<AtomicFiles> files_;
};

/// The files that tell of a run, in one folder: summary.json, impacts.csv, histories.nc and case.toml.
class RunFolder {
 public:
  /// Before the work, so that a folder that cannot be written to costs none. Where the case itself lies there under the
  /// name of its copy, `source` learns that none is made. @throws as AtomicFiles.
  RunFolder(std::filesystem::path folder, OutputRules rules, CaseSource& source);
  [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }
  [[nodiscard]] const OutputRules& rules() const { return rules_; }
  void write(const CaseSource& source, const std::string& summary, const std::string& impacts,
             const std::string& histories);

 private:
  std::filesystem::path folder_;
  OutputRules rules_;
  AtomicFiles files_;
};

/// "Wrote summary.json, impacts.csv, histories.nc and case.toml into results".
[[nodiscard]] std::string written_line(const CaseSource& source, const std::string& folder);

}  // namespace bentur::cli
