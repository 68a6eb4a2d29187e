#pragma once

#include <optional>
#include <string>

#include "bentur/io/output/atomic_file.h"

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

}  // namespace bentur::cli
