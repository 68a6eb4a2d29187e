#include "output/output.h"

#include <fmt/format.h>

#include <cstdio>
#include <utility>

#include "bentur/report/files/figure_files.h"

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

RunFolder::RunFolder(std::filesystem::path folder, OutputRules rules, CaseSource& source)
    : folder_(std::move(folder)), rules_(std::move(rules)), files_(folder_, rules_) {
  source.copied = !rules_.is_input(folder_ / "case.toml");
  files_.expect("summary.json", ResultKind::summary);
  files_.expect("impacts.csv", ResultKind::impacts);
  files_.expect("histories.nc", ResultKind::histories);
  if (source.copied) files_.expect("case.toml", ResultKind::case_copy);
}

void RunFolder::write(const CaseSource& source, const std::string& summary, const std::string& impacts,
                      const std::string& histories) {
  if (source.copied) files_.add("case.toml", source.text, ResultKind::case_copy);
  files_.add("summary.json", summary, ResultKind::summary);
  files_.add("impacts.csv", impacts, ResultKind::impacts);
  files_.add("histories.nc", histories, ResultKind::histories);
  remove_run_figures(folder_ / "figures", rules_);  // never figures of one run beside the results of another
  files_.commit();
}

std::string written_line(const CaseSource& source, const std::string& folder) {
  return fmt::format("Wrote summary.json, impacts.csv, histories.nc{} into {}", source.copied ? " and case.toml" : "",
                     folder);
}

}  // namespace bentur::cli
