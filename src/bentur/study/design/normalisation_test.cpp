// Records as a set: normalised, and both ways round.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "bentur/io/temporary_folder.h"
#include "bentur/study/design/study_check.h"
#include "bentur/study/quantiles.h"

namespace bentur {
namespace {

namespace fs = std::filesystem;

/// A study of four records that are pulses: a constant acceleration of so many m/s² over a second.
class RecordSet : public ::testing::Test {
 protected:
  RecordSet() {
    int i = 0;
    for (const double acceleration : {1.0, 2.0, 4.0, 8.0}) {
      std::ofstream(folder_.path() / ("r" + std::to_string(++i) + ".txt"))
          << "0 " << acceleration << "\n1 " << acceleration << "\n";
    }
  }

  std::optional<Study> read(const std::string& normalisation, const std::string& rest = "",
                            const std::string& excitation = "") {
    std::ofstream(folder_.path() / "case.toml")
        << "title = \"four\"\n[units]\nlength = \"m\"\nforce = \"kN\"\n"
           "[[building]]\nname = \"A\"\ndamping = 0.05\nstick = { storey_heights = [3.0], masses = [30], stiffnesses = "
           "[40e3] }\n[[building]]\nname = \"B\"\ndamping = 0.05\nstick = { storey_heights = [3.0], masses = [20], "
           "stiffnesses = [60e3] }\n[[gap]]\nbetween = [\"A\", \"B\"]\nwidth = 0.02\ncontact = { law = \"linear\", "
           "stiffness = 3e5 }\n[excitation]\nkind = \"record\"\nfile = \"r1.txt\"\nunit = \"m/s2\"\n"
        << excitation;
    std::ofstream(folder_.path() / "study.toml")
        << "case = \"case.toml\"\n[[vary]]\nparameter = \"excitation.file\"\nfiles = \"r*.txt\"\n"
        << normalisation << rest;
    diagnostics_ = Diagnostics();
    return read_study(folder_.path() / "study.toml", diagnostics_);
  }

  std::string messages() {
    std::string all;
    for (const Diagnostic& one : diagnostics_.errors()) all += one.message() + "\n";
    return all;
  }

  /// The peak that each record of the study has as applied [m/s²], negative the other way round.
  std::vector<double> applied(const Study& study, double level = 0) {
    CaseMemo memo;
    Diagnostics diagnostics;
    const auto facts = check_study(study, memo, diagnostics);
    for (const Diagnostic& one : diagnostics.errors()) ADD_FAILURE() << one.text();
    std::vector<double> peaks;
    for (std::size_t polarity = 0; polarity < (study.ida && !study.ida->polarity.empty() ? 2 : 1); ++polarity) {
      for (std::size_t i = 0; i < 4; ++i) {
        std::vector<Choice> choices(study.axes.size());
        choices[0].level = i;
        if (polarity > 0) choices[1].level = polarity;
        TomlValue root = study.case_root;
        put_choices(study, choices, root);
        if (study.ida) {
          const double factor = record_factor(facts->intensities, facts->intensities.place(choices), level);
          TomlValue scale;
          scale.kind = TomlValue::Kind::real;
          scale.real = factor;
          put_value(root, {"excitation", "scale"}, scale);
        }
        const std::string name = "case.toml";
        const ReadCase read = read_case_parts(TomlView(root, "", name, diagnostics), folder_.path(), diagnostics);
        peaks.push_back(std::get<SampledMotion>(read.c.excitation.motion).acceleration.front());
      }
    }
    return peaks;
  }

  TemporaryFolder folder_;
  Diagnostics diagnostics_;
};

void expect_near(const std::vector<double>& found, const std::vector<double>& expected) {
  ASSERT_EQ(found.size(), expected.size());
  // Products and quotients of a few numbers: round-off alone.
  for (std::size_t i = 0; i < found.size(); ++i) EXPECT_NEAR(found[i], expected[i], 1e-13 * std::abs(expected[i])) << i;
}

TEST_F(RecordSet, NormalisedByPgvAllHaveTheMedian) {
  // PGV is the acceleration times 1 s: 1, 2, 4, 8, with the median 3.
  const auto study = read("normalisation = \"pgv\"\n");
  ASSERT_TRUE(study.has_value()) << messages();
  expect_near(study->varies[0].normalisation, {3, 1.5, 0.75, 0.375});
  expect_near(applied(*study), {3, 3, 3, 3});
}

TEST_F(RecordSet, PairsKeepTheProportionOfTheirComponents) {
  // √2, √2, √32, √32, with the median (√2 + √32)/2.
  const auto study = read("normalisation = \"pgv-pairs\"\n");
  ASSERT_TRUE(study.has_value()) << messages();
  const double median = (std::sqrt(2.0) + std::sqrt(32.0)) / 2;
  expect_near(applied(*study), {median / std::sqrt(2.0), 2 * median / std::sqrt(2.0), 4 * median / std::sqrt(32.0),
                                8 * median / std::sqrt(32.0)});
  std::ofstream(folder_.path() / "r5.txt") << "0 1\n1 1\n";
  EXPECT_FALSE(read("normalisation = \"pgv-pairs\"\n").has_value());
  EXPECT_NE(messages().find("takes files two by two, and there are 5"), std::string::npos) << messages();
}

TEST_F(RecordSet, FactorsByListAndByFileGoWithTheCasesScale) {
  const auto listed = read("normalisation = [2, 1, 0.5, 3]\n", "", "scale = -0.5\n");
  ASSERT_TRUE(listed.has_value()) << messages();
  expect_near(applied(*listed), {-1, -1, -1, -12});
  const auto varied = read("normalisation = [2, 1, 0.5, 3]\n",
                           "[[vary]]\nparameter = \"excitation.scale\"\nvalues = [10.0, 20.0]\n", "scale = -0.5\n");
  ASSERT_TRUE(varied.has_value()) << messages();
  expect_near(applied(*varied), {20, 20, 20, 240});

  std::ofstream(folder_.path() / "index.csv")
      << "set,file,event,normalisation_factor\n"
         "x,far/r4.txt,\"Kobe, Japan\",3\nx,r1.txt,,2\nx,r2.txt,,1\nx,r3.txt,,.5\n";
  const auto table = read("normalisation = { file = \"index.csv\" }\n");
  ASSERT_TRUE(table.has_value()) << messages();
  expect_near(applied(*table), {2, 2, 2, 24});
  CaseMemo memo;
  const auto facts = check_study(*table, memo, diagnostics_);
  EXPECT_EQ(facts->records.count("index.csv"), 1U);  // so that a sweep does not go on with another table
  EXPECT_EQ(facts->records.count("r4.txt"), 1U);
  std::ofstream(folder_.path() / "plain.csv") << "r1.txt,2\nr2.txt,1\nr3.txt,0.5\nr4.txt,3\n";
  expect_near(applied(read("normalisation = { file = \"plain.csv\" }\n").value()), {2, 2, 2, 24});
  for (const auto& [text, message] : std::vector<std::pair<std::string, std::string>>{
           {"r1.txt,2\n", "has no factor for \"r2.txt\""},
           {"file,pga\nr1.txt,2\n", "none called \"factor\" or \"normalisation_factor\""},
           {"r1.txt,2\nr2.txt,-1\n", "line 2 must have a file's name and its factor, a number > 0"}}) {
    std::ofstream(folder_.path() / "bad.csv") << text;
    EXPECT_FALSE(read("normalisation = { file = \"bad.csv\" }\n").has_value());
    EXPECT_NE(messages().find(message), std::string::npos) << messages();
  }
}

TEST_F(RecordSet, WithIdaTheMedianOfTheNormalisedRecordsIsTheLevel) {
  const std::string ida = "[ida]\nintensity = \"pga\"\nunit = \"m/s2\"\nlevels = [1.0, 2.0]\n";
  expect_near(applied(read("", ida).value(), 2), {2, 2, 2, 2});  // each to its own intensity
  // 2, 2, 2, 24 normalised, with the median 2.
  expect_near(applied(read("normalisation = [2, 1, 0.5, 3]\n", ida, "pga = 5.0\n").value(), 1), {1, 1, 1, 12});
}

TEST_F(RecordSet, BothWaysRound) {
  const std::string ida = "[ida]\nintensity = \"pga\"\nunit = \"m/s2\"\nlevels = [1.0, 2.0]\npolarity = \"both\"\n";
  const auto study = read("", ida);
  ASSERT_TRUE(study.has_value()) << messages();
  EXPECT_EQ(study->axes, (std::vector<std::string>{"file", "polarity", "intensity"}));
  expect_near(applied(*study, 2), {2, 2, 2, 2, -2, -2, -2, -2});
}

TEST_F(RecordSet, WhatDoesNotGoTogether) {
  EXPECT_FALSE(read("normalisation = \"pgv\"\n", "", "pga = 5.0\n").has_value());
  EXPECT_NE(messages().find("does not go with excitation.pga"), std::string::npos) << messages();
  EXPECT_FALSE(read("normalisation = \"pga\"\n").has_value());
  EXPECT_NE(messages().find("did you mean \"pgv\"?"), std::string::npos) << messages();
  EXPECT_FALSE(read("normalisation = [1, 2]\n").has_value());
  EXPECT_NE(messages().find("has 2 entries, expected 4 (one per file)"), std::string::npos) << messages();
  EXPECT_FALSE(
      read("", "[[vary]]\nparameter = \"gap[0].width\"\nvalues = [0.1]\nnormalisation = \"pgv\"\n").has_value());
  EXPECT_NE(messages().find("goes with files"), std::string::npos) << messages();
  const std::string ida = "[ida]\nintensity = \"pga\"\nunit = \"m/s2\"\nlevels = [1.0]\npolarity = \"both\"\n";
  EXPECT_FALSE(
      read("", ida + "[[vary]]\nparameter = \"excitation.polarity\"\nvalues = [\"as-recorded\", \"reversed\"]\n")
          .has_value());
  EXPECT_NE(messages().find("but excitation.polarity is varied in line"), std::string::npos) << messages();
  EXPECT_FALSE(read("", ida + "[[vary]]\nparameter = \"building[0].damping\"\nname = \"polarity\"\nvalues = [0.1]\n")
                   .has_value());
  EXPECT_NE(messages().find("has the name of what varies"), std::string::npos) << messages();
}

}  // namespace
}  // namespace bentur
