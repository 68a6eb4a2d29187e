// What is fed by libFuzzer (./dev fuzz), and by standalone.cpp with fewer inputs in the tests. A target must come back
// from any bytes: whatever is wrong is a message. BENTUR_FUZZ_TARGET names the function that a program calls.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <string>

#include "bentur/core/errors.h"
#include "bentur/io/case/case_toml.h"
#include "bentur/io/records/record_files.h"
#include "bentur/io/temporary_folder.h"
#include "bentur/model/limits.h"
#include "bentur/pounding/pounding.h"
#include "bentur/study/plan/study.h"

namespace bentur {
namespace {

namespace fs = std::filesystem;

void demand(bool holds, const char* what) {
  if (holds) return;
  std::cerr << "fuzz: " << what << '\n';
  std::abort();
}

/// Where files that inputs name are looked for, and inputs that must be files are put: a copy of the examples.
const fs::path& folder() {
  static const TemporaryFolder made;
  static const bool copied = [] {
    const fs::path source = fs::path(BENTUR_SOURCE_DIR) / "examples";
    fs::copy(source, made.path() / "examples", fs::copy_options::recursive);
    return true;
  }();
  static const fs::path examples = copied ? made.path() / "examples" : fs::path();
  return examples;
}

fs::path as_file(const std::string& input, const char* name) {
  const fs::path file = folder() / name;
  std::ofstream(file, std::ios::binary) << input;
  return file;
}

/// A short run of a case that was read. The checks that every run makes of itself end it with a message of their own.
void run_shortly(Case c) {
  c.analysis.duration = std::min(c.analysis.duration, 2.0);
  c.analysis.limits = {.steps = 2e4, .memory = 200};
  if (is_without_motion(c) || c.buildings.size() > 6) return;
  try {
    const Problem problem = make_problem(c);
    for (const Building& building : problem.buildings) {
      if (building.model.floors() > 20) return;
    }
    const Response response = solve(problem, c.analysis.solver, solve_options(c));
    demand(response.status != Status::failed || !response.message.empty(), "a run has failed without a word");
    demand(response.message.find("contradicts itself") == std::string::npos, response.message.c_str());
    for (const Impact& impact : response.impacts) demand(std::isfinite(impact.peak_force), "a force is no number");
  } catch (const InvalidParameter&) {
    // told as any error of a case
  }
}

[[maybe_unused]] void case_file(const std::string& input) {
  Diagnostics diagnostics;
  auto c = read_case_text(input, folder() / "fuzzed.toml", diagnostics);
  demand(c.has_value() == diagnostics.ok(), "a case is refused without a message, or read with one");
  if (c) run_shortly(*std::move(c));
}

[[maybe_unused]] void study_file(const std::string& input) {
  Diagnostics diagnostics;
  const bool good = read_study(as_file(input, "studies/fuzzed.toml"), diagnostics).has_value();
  demand(good == diagnostics.ok(), "a study is refused without a message, or read with one");
}

[[maybe_unused]] void record_file(const std::string& input) {
  Diagnostics diagnostics;
  const auto record = read_record(as_file(input, "fuzzed.txt"), RecordOptions{}, diagnostics);
  demand(record.has_value() == diagnostics.ok(), "a record is refused without a message, or read with one");
  if (!record) return;
  const auto finite = [](double x) { return std::isfinite(x); };
  demand(std::all_of(record->values.begin(), record->values.end(), finite), "a value of a record is no number");
  demand(record->values.size() > 1, "a record has one value");
}

}  // namespace
}  // namespace bentur

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  bentur::BENTUR_FUZZ_TARGET(std::string(data, data + size));
  return 0;
}
