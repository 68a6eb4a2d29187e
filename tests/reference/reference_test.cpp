// The cases of ../shared/reference whose law is linear, against the answers of an independent program.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "bentur/io/case_toml.h"
#include "bentur/io/results/result_json.h"
#include "bentur/solve/solver.h"

namespace bentur {
namespace {

namespace fs = std::filesystem;

const fs::path shared = fs::path(BENTUR_SOURCE_DIR) / ".." / "shared";

class Reference : public testing::TestWithParam<const char*> {};

TEST_P(Reference, AgreesWithTheIndependentProgram) {
  if (!fs::exists(shared)) GTEST_SKIP() << "the reference cases (../shared) are not here";
  const std::string name = GetParam();
  Diagnostics diagnostics;
  const auto c = read_case(shared / "reference" / (name + ".toml"), diagnostics);
  for (const Diagnostic& error : diagnostics.errors()) ADD_FAILURE() << error.text();
  ASSERT_TRUE(c);
  const Problem problem = make_problem(*c);
  const Response response = solve(problem);
  ASSERT_EQ(response.status, Status::done) << response.message;

  const fs::path actual = fs::path(BENTUR_BINARY_DIR) / ("reference-" + name + ".json");
  std::ofstream(actual) << summary_json(*c, problem, response, "test");
  const fs::path expected = shared / "reference" / (name + ".expected.json");
  const std::string command =
      "python3 '" + (shared / "tools/compare.py").string() + "' '" + expected.string() + "' '" + actual.string() + "'";
  EXPECT_EQ(std::system(command.c_str()), 0) << command;
}

INSTANTIATE_TEST_SUITE_P(Linear, Reference,
                         testing::Values("absolute-delay", "free-impact", "m12-el-centro-gap-02",
                                         "m12-el-centro-gap-04", "m12-el-centro-touching", "m12-harmonic-gap-02",
                                         "m12-uncondensed", "matrices-unequal-heights",
                                         "three-and-two-storeys-undamped"),
                         [](const auto& test) {
                           std::string name = test.param;
                           for (char& letter : name) {
                             if (letter == '-') letter = '_';
                           }
                           return name;
                         });

TEST(ReferenceCases, EveryLinearOneIsInTheListAbove) {
  if (!fs::exists(shared)) GTEST_SKIP() << "the reference cases (../shared) are not here";
  int linear = 0;
  for (const auto& entry : fs::directory_iterator(shared / "reference")) {
    if (entry.path().extension() != ".toml") continue;
    std::ifstream in(entry.path());
    const std::string text((std::istreambuf_iterator<char>(in)), std::istreambuf_iterator<char>());
    const auto count = [&text](const std::string& word) {
      int n = 0;
      for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) ++n;
      return n;
    };
    linear += count("law = ") == count("law = \"linear\"") ? 1 : 0;
  }
  EXPECT_EQ(linear, 9);
}

}  // namespace
}  // namespace bentur
