// Searches with slopes against the same without, over random cases.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <random>
#include <set>

#include "bentur/io/temporary_folder.h"
#include "bentur/study/remedy/objective_slopes.h"
#include "bentur/study/remedy/optimiser.h"
#include "bentur/study/remedy/remedy.h"
#include "bentur/study/study_variables.h"

namespace bentur {
namespace {

struct RandomStudy {
  std::string case_text, study_text;
};

/// Two or three sticks with dampers between their floors, under noise or harmonic motion; up to six numbers to choose.
RandomStudy random_study(unsigned seed) {
  std::mt19937 random(seed);
  const auto between = [&](double low, double high) { return std::uniform_real_distribution(low, high)(random); };
  const auto count = [&](int low, int high) { return std::uniform_int_distribution(low, high)(random); };
  RandomStudy made;
  std::string& text = made.case_text;
  text = "[units]\nlength = \"m\"\nforce = \"kN\"\n";
  const int buildings = count(2, 3);
  std::vector<int> floors;
  for (int b = 0; b < buildings; ++b) {
    floors.push_back(count(1, 3));
    const double mass = between(30, 80), stiffness = mass * between(300, 1500);
    text += fmt::format("[[building]]\nname = \"{}\"\ndamping = {}\n", b, between(0.02, 0.06));
    std::string heights, masses, stiffnesses;
    for (int f = 0; f < floors.back(); ++f) {
      heights += "3,";
      masses += fmt::format("{},", mass * between(0.7, 1));
      stiffnesses += fmt::format("{},", stiffness);
    }
    text += fmt::format("stick = {{ storey_heights = [{}], masses = [{}], stiffnesses = [{}] }}\n", heights, masses,
                        stiffnesses);
  }
  const bool forces = count(0, 1) == 1;
  std::string& study = made.study_text;
  const double width = forces ? between(0.003, 0.02) : 0.02;
  int links = 0;
  for (int b = 0; b + 1 < buildings; ++b) {
    text +=
        fmt::format("[[gap]]\nbetween = [\"{}\", \"{}\"]\nwidth = {}\ncontact = {{ law = \"{}\", stiffness = {} }}\n",
                    b, b + 1, width, "linear", between(5e4, 5e5));
    for (int f = 0; f < std::min(floors[b], floors[b + 1]); ++f) {
      text += fmt::format(
          "[[link]]\nbetween = [\"{}\", \"{}\"]\nelevations = [{}]\nlaw = \"spring-dashpot\"\ndamping = {}\n", b, b + 1,
          3.0 * (f + 1), between(1, 20));
      study += fmt::format("[[vary]]\nparameter = \"link[{}].damping\"\nname = \"at{}\"\nfrom = 1\nto = {}\n", links,
                           links, between(500, 3000));
      ++links;
    }
  }
  study += fmt::format(
      "[[vary]]\nparameter = \"building[0].stick.stiffnesses\"\nname = \"stiffer\"\nfactor = true\nfrom = 1\nto = {}\n",
      between(1.3, 2.5));
  text += "[excitation]\n";
  if (count(0, 2) == 0) {
    text += fmt::format("kind = \"harmonic\"\nperiod = {}\ndisplacement_amplitude = 0.02\n", between(0.3, 0.8));
    study += "[[vary]]\nparameter = \"excitation.period\"\nname = \"period\"\nvalues = [0.35, 0.5, 0.7]\n";
  } else {
    text += "kind = \"record\"\ntime_step = 0.02\nunit = \"m/s2\"\nvalues = [";
    for (int n = 0; n < 200; ++n) text += fmt::format("{},", between(-5, 5));
    text += "]\n";
    study +=
        "[[vary]]\nparameter = \"excitation.polarity\"\nname = \"way\"\nvalues = [\"as-recorded\", \"reversed\"]\n";
  }
  text += "[analysis]\nduration = 4.0\n";
  const char* const objective = forces             ? "peak_force"
                                : count(0, 1) == 0 ? "gap_needed"
                                                   : "peak_displacement_no_contact";
  study = fmt::format("case = \"case.toml\"\n[remedy]\nobjective = \"{}\"\n", objective) + study;
  return made;
}

class RemedySlopes : public testing::Test {
 protected:
  void SetUp() override {
    if (!has_optimiser()) GTEST_SKIP() << "built without NLopt";
  }

  [[nodiscard]] std::filesystem::path study(const RandomStudy& made) const {
    std::ofstream(folder_.path() / "case.toml") << made.case_text;
    std::ofstream(folder_.path() / "study.toml") << made.study_text;
    return folder_.path() / "study.toml";
  }
  [[nodiscard]] RemedySearch found(const RandomStudy& made, bool slopes) const {
    Diagnostics diagnostics;
    RemedyOptions options;
    options.slopes = slopes;
    auto search = seek_remedy(study(made), options, diagnostics);
    for (const Diagnostic& one : diagnostics.errors()) ADD_FAILURE() << one.text();
    return std::move(search.value());
  }

  const TemporaryFolder folder_;
};

/// The same with another limit and number of evaluations; no limit where it is 0.
RandomStudy with(const RandomStudy& made, double limit, int evaluations) {
  RandomStudy other = made;
  const std::string head = fmt::format("evaluations = {}\n", evaluations);
  other.study_text.insert(made.study_text.find("[[vary]]"),
                          limit > 0 ? head + fmt::format("limit = {}\n", limit) : head);
  return other;
}

std::string replaced(std::string text, const std::string& what, const std::string& by) {
  for (auto at = text.find(what); at != std::string::npos; at = text.find(what, at + by.size())) {
    text.replace(at, what.size(), by);
  }
  return text;
}

TEST_F(RemedySlopes, NeedFewerChoicesAndFindNothingWorse) {
  // 8 cases; BENTUR_REMEDIES=60 tries as many, of which docs/studies.md tells.
  const char* const asked = std::getenv("BENTUR_REMEDIES");
  const unsigned cases = asked != nullptr ? static_cast<unsigned>(std::atoi(asked)) : 8;
  std::size_t without = 0, with_them = 0, compared = 0, better = 0;
  for (unsigned seed = 1; seed <= cases; ++seed) {
    SCOPED_TRACE(seed);
    RandomStudy made = random_study(seed);
    double limit = 0;
    if (seed % 2 == 0) {
      const RemedySearch first = found(with(made, 0, 60), true);
      limit = 0.6 * first.best()->objective + 0.4 * first.trials.front().objective;
    }
    made = with(made, limit, 200);
    const RemedySearch a = found(made, false), b = found(made, true);
    EXPECT_EQ(a.with_slopes, 0U);
    const double of_a = limit > 0 ? a.smallest()->size : a.best()->objective;
    const double of_b = limit > 0 ? b.smallest()->size : b.best()->objective;
    EXPECT_LE(of_b, 1.002 * of_a);
    if (b.with_slopes < 3) continue;  // at the best nothing touches: there is no slope
    ++compared;
    better += of_b < 0.999 * of_a ? 1 : 0;
    without += a.trials.size();
    with_them += b.trials.size();
    fmt::print("{:3}: {} axes, {:28} {:3} choices, with slopes {:3}, {:2} of them with, {:.5f} of the other\n", seed,
               a.axes, a.spec().objective, a.trials.size(), b.trials.size(), b.with_slopes, of_b / of_a);
  }
  EXPECT_GE(compared, cases / 2);
  EXPECT_LE(static_cast<double>(with_them), 0.6 * static_cast<double>(without));
  EXPECT_GE(better, compared / 4);
}

TEST_F(RemedySlopes, AreThoseOfTheObjectiveByDifferences) {
  // Of a range by its logarithm, a factor, a number alone: as they are chosen, u.
  RandomStudy made = random_study(4);
  made.study_text = replaced(made.study_text, "from = 1\nto", "spacing = \"log\"\nfrom = 1\nto");
  Diagnostics diagnostics;
  const std::optional<Study> read = read_study(study(with(made, 0, 20)), diagnostics);
  ASSERT_TRUE(read.has_value());
  const auto memo = std::make_shared<CaseMemo>();
  const std::optional<StudyFacts> facts = check_study(*read, *memo, diagnostics);
  ASSERT_TRUE(diagnostics.ok()) << diagnostics.errors().front().text();
  std::vector<RowPart> of;
  for (const RowPart& part : quantities_of(*facts)) {
    if (is_quantity(part.name, read->remedy->objective)) of.push_back(part);
  }
  std::set<std::size_t> axes;
  for (const Vary& vary : read->varies) {
    if (vary.sought) axes.insert(vary.axis);
  }
  const ObjectiveSlopes slopes(of, *read, {axes.begin(), axes.end()}, memo);
  ASSERT_TRUE(slopes.may_be());
  const std::vector<std::size_t> first = {0};
  const auto largest = [&](const std::vector<double>& places) {
    const auto parts = slopes.parts(StudyRuns(chosen_study(*read, places), *facts, memo, slopes.at(places))
                                        .solve(first, [] { return true; })[0]
                                        .values);
    return *std::max_element(parts.begin(), parts.end(),
                             [](const auto& a, const auto& b) { return a.value < b.value; });
  };
  const std::vector<double> middle(axes.size(), 0.6);
  ASSERT_FALSE(of.empty());
  const FunctionPart here = largest(middle);
  double most = 0;
  for (const double slope : here.slope) most = std::max(most, std::abs(slope));
  for (std::size_t i = 0; i < middle.size(); ++i) {
    constexpr double h = 1e-5;  // its square, of u
    std::vector<double> low = middle, high = middle;
    low[i] -= h;
    high[i] += h;
    EXPECT_NEAR(here.slope[i], (largest(high).value - largest(low).value) / (2 * h), 1e-5 * most) << i;
  }
}

TEST_F(RemedySlopes, AreLeftAloneWhereThereAreNone) {
  const RandomStudy made = with(random_study(5), 0, 40);
  const auto expect_none = [&](const RandomStudy& one) {
    const RemedySearch a = found(one, false), b = found(one, true);
    EXPECT_EQ(b.with_slopes, 0U);
    ASSERT_EQ(a.trials.size(), b.trials.size());
    for (std::size_t i = 0; i < a.trials.size(); ++i) EXPECT_EQ(a.trials[i].places, b.trials[i].places);
  };
  RandomStudy other = made;  // a curved force
  other.case_text = replaced(made.case_text, "law = \"linear\"", "law = \"hertz\"");
  expect_none(other);
  other = made;  // a solver that is not exact
  other.case_text += "solver = \"adaptive\"\n";
  expect_none(other);
  other = made;  // a count
  other.study_text = replaced(made.study_text, "peak_force", "impacts");
  expect_none(other);
}

}  // namespace
}  // namespace bentur
