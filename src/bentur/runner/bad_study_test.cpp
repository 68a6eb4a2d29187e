#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "bentur/runner/sweep.h"

namespace bentur {
namespace {

namespace fs = std::filesystem;

const fs::path bad_study = fs::path(BENTUR_SOURCE_DIR) / "tests" / "bad_study";

std::vector<std::string> lines_of_file(const fs::path& file) {
  std::ifstream stream(file);
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

TEST(BadStudy, EachBadStudyGivesItsMessages) {
  int studies = 0;
  for (const auto& entry : fs::directory_iterator(bad_study)) {
    if (entry.path().extension() != ".toml" || entry.path().filename() == "plain-case.toml") continue;
    ++studies;
    SCOPED_TRACE(entry.path().filename().string());
    Diagnostics diagnostics;
    const bool ida = entry.path().filename().string().starts_with("ida-");
    EXPECT_FALSE(outline_sweep(entry.path(), ida ? StudyKind::ida : StudyKind::sweep, diagnostics).has_value());
    std::vector<std::string> found;
    for (const Diagnostic& one : diagnostics.errors()) {
      found.push_back(one.text());
      const std::string folder = bad_study.string() + "/";
      if (found.back().starts_with(folder)) found.back().erase(0, folder.size());
    }
    const auto expected = lines_of_file(fs::path(entry.path()).replace_extension(".expected"));
    EXPECT_FALSE(expected.empty());
    EXPECT_EQ(found, expected);
  }
  EXPECT_GE(studies, 50);
}

}  // namespace
}  // namespace bentur
