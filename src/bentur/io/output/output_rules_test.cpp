#include "bentur/io/output/output_rules.h"

#include <gtest/gtest.h>

#include <fstream>

#include "bentur/io/output/atomic_file.h"
#include "bentur/io/temporary_folder.h"

namespace bentur {
namespace {

namespace fs = std::filesystem;

// What commands do with all of this: tests/faults/outputs_test.py.
class OutputRulesTest : public testing::Test {
 protected:
  void write(const std::string& name, const std::string& text) const { std::ofstream(folder_.path() / name) << text; }
  [[nodiscard]] fs::path target(const std::string& name, ResultKind kind, const OutputRules& rules = {}) const {
    return output_target(folder_.path() / name, kind, rules);
  }

  TemporaryFolder folder_;
};

TEST_F(OutputRulesTest, WhatIsThereMustBeOfTheSameKindOrEmpty) {
  EXPECT_EQ(target("new", ResultKind::report), folder_.path() / "new");
  write("mine", "text");
  EXPECT_THROW(static_cast<void>(target("mine", ResultKind::report)), RefusedOutput);
  EXPECT_EQ(target("mine", ResultKind::report, {.force = true}), folder_.path() / "mine");
  write("empty", "");
  EXPECT_EQ(target("empty", ResultKind::report), folder_.path() / "empty");
  write("impacts", "left,right,elevation [m],start [s]\n");
  EXPECT_EQ(target("impacts", ResultKind::impacts), folder_.path() / "impacts");
  EXPECT_THROW(static_cast<void>(target("impacts", ResultKind::spectrum)), RefusedOutput);
  write("summary", R"({"version": "1", "solver": {}, "excitation": {}, "buildings": []})");
  EXPECT_THROW(static_cast<void>(target("summary", ResultKind::summary)), RefusedOutput) << "no gaps";
}

TEST_F(OutputRulesTest, InputsAreKnownUnderEveryName) {
  write("input", "");
  fs::create_symlink("input", folder_.path() / "symbolic");
  fs::create_hard_link(folder_.path() / "input", folder_.path() / "hard");
  const OutputRules rules{.inputs = {folder_.path() / "gone", folder_.path() / "symbolic"}, .force = true};
  for (const char* name : {"input", "symbolic", "hard"}) {
    EXPECT_THROW(static_cast<void>(target(name, ResultKind::report, rules)), RefusedOutput) << name;
  }
  EXPECT_FALSE(rules.is_input(folder_.path() / "gone"));
}

TEST_F(OutputRulesTest, ALinkIsFollowedToItsEnd) {
  fs::create_directory(folder_.path() / "far");
  fs::create_symlink("far/there", folder_.path() / "one");
  fs::create_symlink(folder_.path() / "one", folder_.path() / "two");
  EXPECT_TRUE(fs::equivalent(target("two", ResultKind::report).parent_path(), folder_.path() / "far"));
  AtomicFiles files(folder_.path());
  files.add("two", "text", ResultKind::report);
  files.commit();
  EXPECT_TRUE(fs::is_symlink(folder_.path() / "two"));
  EXPECT_EQ(fs::file_size(folder_.path() / "far" / "there"), 4U);
}

TEST_F(OutputRulesTest, WhatStandsBesideAScriptIsAFigure) {
  write("a.py", std::string(figure_script_mark) + ", by matplotlib\n");
  write("a-data.csv", "1 2\n");
  write("b.py", "print()\n");
  write("b-data.csv", "1 2\n");
  EXPECT_NO_THROW(static_cast<void>(target("a-data.csv", ResultKind::figure_data)));
  EXPECT_NO_THROW(static_cast<void>(target("a.py", ResultKind::figure_script)));
  EXPECT_THROW(static_cast<void>(target("b-data.csv", ResultKind::figure_data)), RefusedOutput);
  EXPECT_THROW(static_cast<void>(target("b.py", ResultKind::figure_script)), RefusedOutput);
}

}  // namespace
}  // namespace bentur
