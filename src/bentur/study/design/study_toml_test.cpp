#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <random>
#include <string>
#include <vector>

#include "bentur/io/temporary_folder.h"
#include "bentur/study/design/study.h"
#include "tests/support/mutated_text.h"

namespace bentur {
namespace {

namespace fs = std::filesystem;

const fs::path bad_study = fs::path(BENTUR_SOURCE_DIR) / "tests" / "bad_study";

/// A study of the plain case with `text` for the rest.
Study study_of(const std::string& text) {
  const TemporaryFolder folder;
  const fs::path file = folder.path() / "study.toml";
  std::ofstream(file) << "case = '" << (bad_study / "plain-case.toml").string() << "'\n" << text;
  Diagnostics diagnostics;
  auto study = read_study(file, diagnostics);
  for (const Diagnostic& one : diagnostics.errors()) ADD_FAILURE() << one.text();
  return study.value();
}

std::vector<double> numbers(const Vary& vary) {
  std::vector<double> result;
  for (const TomlValue& value : vary.values) result.push_back(value.real);
  return result;
}

TEST(StudyToml, RangesHaveTheDecimalsAUserWillAskFor) {
  const Study study = study_of(R"(
[[vary]]
parameter = "gap[0].width"
from = 0
to = 0.3
count = 4
[[vary]]
parameter = "excitation.scale"
from = 0.01
to = 10
count = 4
spacing = "log"
)");
  EXPECT_EQ(numbers(study.varies[0]), (std::vector<double>{0, 0.1, 0.2, 0.3}));  // 0.3/3 is not 0.1
  EXPECT_EQ(numbers(study.varies[1]), (std::vector<double>{0.01, 0.1, 1, 10}));
  EXPECT_EQ(study.axes, (std::vector<std::string>{"width", "scale"}));
}

TEST(StudyToml, AFactorMultipliesANumberOrAWholeList) {
  const Study study = study_of(R"(
[[vary]]
parameter = 'building["West"].stick.masses'
factor = [0.5, 2]
together = "scale"
[[vary]]
parameter = 'gap[0].contact.stiffness'
factor = true
values = [1, 3]
together = "scale"
)");
  EXPECT_EQ(study.axes, std::vector<std::string>{"scale"});
  TomlValue root = study.case_root;
  put_choices(study, {{.level = 1}}, root);
  const TomlValue* const masses = find_value(root, study.varies[0].path);
  EXPECT_EQ(masses->items[0].real, 60);
  EXPECT_EQ(masses->items[1].real, 50);
  EXPECT_EQ(find_value(root, study.varies[1].path)->real, 9e5);
  put_choices(study, {{.level = 0}}, root);  // of the case's own value, not of the last one
  EXPECT_EQ(find_value(root, study.varies[0].path)->items[0].real, 15);
}

TEST(StudyToml, FilesComeSortedWithTheirUnits) {
  const Study study = study_of("[[vary]]\nparameter = \"excitation.file\"\nunit = \"g\"\nfiles = ['" +
                               (bad_study / "../bad_input/good-t*.txt").string() + "', '" +
                               (bad_study / "../bad_input/good.AT2").string() + "']\n");
  const Vary& vary = study.varies[0];
  EXPECT_EQ(vary.labels, (std::vector<std::string>{"good-three-columns.txt", "good-two-column.txt", "good.AT2"}));
  TomlValue root = study.case_root;
  put_choices(study, {{.level = 1}}, root);
  EXPECT_EQ(find_value(root, {"excitation", "unit"})->text, "g");
  EXPECT_EQ(find_value(root, {"excitation", "file"})->text, "../bad_input/good-two-column.txt");
}

TEST(StudyToml, SamplesAreDrawnFromRangesAndDistributions) {
  const Study study = study_of(R"(
[sampling]
method = "sobol"
count = 16
seed = 5
[[vary]]
parameter = "gap[0].width"
from = 0.01
to = 0.04
[[vary]]
parameter = "building[0].damping"
distribution = { lognormal = { median = 0.05, cov = 0.4, high = 0.2 } }
[[vary]]
parameter = "gap[0].contact.restitution"
values = [0.5, 0.65]
)");
  EXPECT_EQ(study.sampling.method, Sampling::Method::sobol);
  EXPECT_EQ(study.sampling.count, 16U);
  EXPECT_EQ(study.sampling.seed, 5U);
  EXPECT_DOUBLE_EQ(*chosen_number(study.varies[0], {.u = 0.5}), 0.025);
  EXPECT_LT(*chosen_number(study.varies[1], {.u = 1 - 1e-15}), 0.2);
  EXPECT_GT(*chosen_number(study.varies[1], {.u = 0.9}), 0.05);
  EXPECT_EQ(chosen_text(study.varies[2], {.level = 1}), "0.65");
}

// What is settled at the end, such as normalisation by PGV, looks at all that was read: a mistake elsewhere must not
// leave it with half of a study.
TEST(StudyToml, AMistakeBesideANormalisationIsAMistakeAlone) {
  const TemporaryFolder folder;
  const std::string begin = "case = '" + (bad_study / "plain-case.toml").string() + "'\n";
  const std::string files = "[[vary]]\nparameter = 'excitation.file'\nfiles = '" +
                            (bad_study / "../bad_input/good.AT2").string() + "'\nnormalisation = 'pgv'\n";
  for (const std::string wrong :
       {"[[vary]]\ncount = 3\n", "[[vary]]\nparameter = 'gap[0].width'\nvaleus = [0.1, 0.2]\n",
        "[[vary]]\nparameter = 'gap[0].width'\nvalues = []\n",
        "[[vary]]\nparameter = 'gap[0].width'\nfrom = 0.1\nto = 0.2\n"}) {
    std::ofstream(folder.path() / "study.toml") << begin << wrong << files;
    Diagnostics diagnostics;
    EXPECT_FALSE(read_study(folder.path() / "study.toml", diagnostics).has_value());
    EXPECT_FALSE(diagnostics.ok()) << wrong;
  }
}

// A crash fails the test by ending it; a text must be read or refused with a message.
TEST(StudyToml, MutatedStudiesAreReadOrRefusedButNeverSilent) {
  const TemporaryFolder folder;
  const std::string plain = "case = '" + (bad_study / "plain-case.toml").string() + R"('
[[vary]]
parameter = "excitation.file"
files = ["good-t*.txt", { file = "good.AT2", unit = "g" }]
unit = "g"
normalisation = "pgv"
[[vary]]
parameter = "gap[0].width"
from = 0.01
to = 0.1
count = 3
together = "pair"
[[vary]]
parameter = 'building["West"].damping'
values = [0.02, 0.03, 0.05]
together = "pair"
name = "damping"
[[vary]]
parameter = "gap[0].contact.stiffness"
factor = [0.5, 2.0]
[ida]
intensity = "pga"
unit = "g"
levels = [0.1, 0.2]
polarity = "both"
)";
  for (const char* const file : {"good-two-column.txt", "good-three-columns.txt", "good.AT2"}) {
    fs::copy_file(bad_study / "../bad_input" / file, folder.path() / file);
  }
  std::mt19937 random(20190531);
  int read = 0;
  for (int round = 0; round < 1000; ++round) {
    const std::string text = round == 0 ? plain : test::mutated(plain, random);
    const fs::path file = folder.path() / "study.toml";
    std::ofstream(file, std::ios::binary) << text;
    Diagnostics diagnostics;
    const bool good = read_study(file, diagnostics).has_value();
    ASSERT_EQ(good, diagnostics.ok()) << text;
    ASSERT_TRUE(good || round > 0) << diagnostics.errors().at(0).text();
    read += good ? 1 : 0;
  }
  EXPECT_GT(read, 3);
}

}  // namespace
}  // namespace bentur
