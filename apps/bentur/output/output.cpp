#include "output/output.h"

#include <cstdio>
#include <filesystem>
#include <utility>

namespace bentur::cli {

bool is_standard_output(const std::string& name) { return name == "-" || name == "/dev/stdout"; }

OutputFile::OutputFile(const std::string& name, ResultKind kind, OutputRules rules)
    : name_(std::filesystem::path(name).filename().string()), kind_(kind) {
  if (is_standard_output(name)) return;
  if (name_.empty() || name_ == "." || name_ == "..") {
    throw RefusedOutput(name, "is a folder; give the name of a file");
  }
  // Before its folder is asked, so that what the name means is said first.
  static_cast<void>(output_target(name, kind, rules));
  files_.emplace(std::filesystem::path(name).parent_path(), std::move(rules));
}

void OutputFile::write(const std::string& content) {
  if (is_streamed()) {
    std::fwrite(content.data(), 1, content.size(), stdout);
    return;
  }
  files_->add(name_, content, kind_);
  files_->commit();
}

}  // namespace bentur::cli
