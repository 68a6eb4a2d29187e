#include "bentur/study/study_output.h"

#include <fcntl.h>
#include <fmt/format.h>

#include <map>
#include <sstream>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "bentur/io/output/atomic_file.h"
#include "bentur/study/build_identity.h"
#include "bentur/study/design/study_check.h"
#include "bentur/study/study_variables.h"

namespace bentur {
namespace {

namespace fs = std::filesystem;

/// Names and hashes out of the attribute that study_file() has made of them, a line each.
std::map<std::string, std::string> records_of(const std::string& attribute) {
  std::map<std::string, std::string> records;
  std::istringstream lines(attribute);
  for (std::string line; std::getline(lines, line);) {
    const std::size_t blank = line.find("  ");
    if (blank != std::string::npos) records[line.substr(blank + 2)] = line.substr(0, blank);
  }
  return records;
}

/// The folder for the results.
void make_folder(const fs::path& folder) {
  std::error_code code;
  if (folder.empty() || fs::create_directories(folder, code) || !code) return;
  if (code == std::errc::not_a_directory)
    throw RefusedOutput(folder, "is not a folder, or below something that is none");
  throw std::runtime_error(folder.string() + ": cannot create the folder: " + code.message());
}

}  // namespace

std::unique_ptr<StudyRuns> checked_runs(Study study, Diagnostics& diagnostics, const ForEachNumber& for_each) {
  check_names(study, diagnostics);
  const auto memo = std::make_shared<CaseMemo>();
  std::optional<StudyFacts> facts = check_study(study, *memo, diagnostics, for_each);
  if (!facts || !diagnostics.ok()) return nullptr;
  return std::make_unique<StudyRuns>(std::move(study), std::move(*facts), memo);
}

std::unique_ptr<StudyRuns> checked_runs(const fs::path& file, StudyKind kind, const std::string& door,
                                        Diagnostics& diagnostics, const ForEachNumber& for_each) {
  std::optional<Study> study = read_study(file, diagnostics);
  if (!study) return nullptr;
  if (study->remedy) {
    diagnostics.error(study->remedy->position, "[remedy] seeks the best of its ranges: use " + door + "remedy");
    return nullptr;
  }
  if (kind == StudyKind::sweep && study->ida) {
    diagnostics.error(study->ida->position, "[ida] makes this an incremental dynamic analysis: use " + door + "ida");
    return nullptr;
  }
  if (kind == StudyKind::ida && !study->ida) {
    diagnostics.error({file.string(), 0, 0},
                      "[ida] is missing, with intensity and levels; without it use " + door + "sweep");
    return nullptr;
  }
  return checked_runs(std::move(*study), diagnostics, for_each);
}

StudyOutput::StudyOutput(const StudyRuns& runs, StudyOutputOptions options)
    : options_(std::move(options)),
      rules_{.inputs = {runs.study().file, runs.study().case_file},
             .force = options_.force,
             .is_netcdf = options_.is_netcdf,
             .forced_by = options_.forced_by},
      origin_{.version = options_.version,
              .build = std::string(build_identity()),
              .study = runs.study().text,
              .case_text = runs.study().case_text,
              .records = runs.facts().records,
              .runs = runs.design().runs(),
              .values = row_size(runs.quantities())} {
  rules_.inputs.insert(rules_.inputs.end(), runs.facts().record_files.begin(), runs.facts().record_files.end());
  static_cast<void>(target());
}

fs::path StudyOutput::target() const { return output_target(options_.output, kind(), rules_); }

bool StudyOutput::is_finished() const {
  std::error_code failed;
  const fs::path& file = options_.output;
  if (!options_.resume || fs::exists(part(), failed) || !fs::is_regular_file(file, failed) ||
      !options_.is_netcdf(file, kind())) {
    return false;
  }
  JournalOrigin there = origin_;
  there.version = options_.attribute(file, "bentur_version");
  if (there.version != origin_.version) there.build.clear();  // which it had is not known
  there.study = options_.attribute(file, "study");
  there.case_text = options_.attribute(file, "case");
  there.records = records_of(options_.attribute(file, "records"));
  if (const auto differs = difference(there, origin_)) {
    throw std::runtime_error(fmt::format("{}: these finished results were begun {}. Without {} they are replaced",
                                         file.string(), *differs, options_.resumed_by));
  }
  return true;
}

Journal StudyOutput::begin() const {
  make_folder(options_.output.parent_path());
  const fs::path file = part();
  std::error_code failed;
  const fs::file_status there = fs::status(file, failed);
  if (!fs::exists(there)) return Journal::begin(file, origin_);
  if (!fs::is_regular_file(there)) throw RefusedOutput(file, "is not a file; remove it, or give another name");
  if (!options_.resume) {
    throw std::runtime_error(
        fmt::format("{}: results of an unfinished sweep are there: go on with {}, or remove the file", file.string(),
                    options_.resumed_by));
  }
  return Journal::resume(file, origin_);
}

void StudyOutput::finish(const std::function<void(const fs::path&)>& write) const {
  const fs::path whole = target();  // again: much may have happened since
  const fs::path unfinished = make_temporary(whole);
  try {
    write(unfinished);
    OpenFile(::open(unfinished.c_str(), O_RDONLY | O_CLOEXEC), options_.output).sync();
    fs::rename(unfinished, whole);
  } catch (...) {
    std::error_code ignored;
    fs::remove(unfinished, ignored);
    throw;
  }
  fs::remove(part());
}

}  // namespace bentur
