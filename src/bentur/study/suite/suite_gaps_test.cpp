#include "bentur/study/suite/internal/suite_gaps.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

#include "bentur/io/case/case_toml.h"
#include "bentur/study/gap/gap_study_story.h"
#include "bentur/study/suite/suite_hand_in.h"

namespace bentur {
namespace {

const std::string suite_folder = std::string(BENTUR_SOURCE_DIR) + "/data/";

/// Three buildings: the first two far apart, the last two close together; two records, of which EN 1998-1 takes
/// nothing.
constexpr const char* three_in_a_row = R"(
[units]
length = "m"
force = "kN"
[[building]]
name = "A"
damping = 0.05
stick = { storey_heights = [3.0, 3.0, 3.0], masses = [100, 100, 80], stiffnesses = [60e3, 55e3, 50e3] }
[[building]]
name = "B"
damping = 0.05
stick = { storey_heights = [3.0, 3.0], masses = [90, 80], stiffnesses = [200e3, 180e3] }
[[building]]
name = "C"
damping = 0.05
stick = { storey_heights = [3.0, 3.0, 3.0], masses = [60, 60, 50], stiffnesses = [20e3, 20e3, 15e3] }
[[gap]]
between = ["A", "B"]
width = 0.6
contact = { law = "kelvin-voigt", stiffness = 4e5, restitution = 0.65 }
[[gap]]
between = ["B", "C"]
width = 0.01
contact = { law = "kelvin-voigt", stiffness = 4e5, restitution = 0.65 }
[excitation]
kind = "suite"
scale = "en-1998-1"
target = { shape = "en-1998-1", ground_acceleration = "0.2 g", ground_type = "C", spectrum_type = 1 }
files = [{ file = "el-centro-1940-ns.csv", unit = "g", event = "1" },
         { file = "four-lobes.csv", unit = "m/s2", time_step = 0.4, event = "2" }]
[code]
same_owner = false
en-1998-1 = { behaviour_factor = 1.0 }
)";

class SuiteOfThree : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    Diagnostics diagnostics;
    auto c = read_case_text(three_in_a_row, suite_folder + "case.toml", diagnostics);
    if (!c) throw std::runtime_error(diagnostics.errors().front().text());
    const auto go_on = [](double) { return true; };
    run = new SuiteRun(run_suite(*c, go_on));
    gaps = new GapStudy(gap_study(*c, suite_folder + "case.toml", go_on, diagnostics).value());
  }
  static void TearDownTestSuite() {
    delete run;
    delete gaps;
    run = nullptr;
    gaps = nullptr;
  }
  static const Statement* find(const std::vector<Statement>& all, const std::string& kind, Eigen::Index gap) {
    const auto found =
        std::find_if(all.begin(), all.end(), [&](const Statement& one) { return one.kind == kind && one.gap == gap; });
    return found == all.end() ? nullptr : &*found;
  }
  static std::string word(const Statement& statement, const std::string& name) {
    const auto found = std::find_if(statement.values.begin(), statement.values.end(),
                                    [&](const StoryValue& one) { return one.name == name; });
    return found == statement.values.end() ? "none" : std::get<std::string>(found->value);
  }

  static SuiteRun* run;
  static GapStudy* gaps;
};
SuiteRun* SuiteOfThree::run = nullptr;
GapStudy* SuiteOfThree::gaps = nullptr;

TEST_F(SuiteOfThree, BeginsWithHowManyGapsAreTooSmall) {
  const Story told = suite_story(*run, *gaps);
  const auto grave = std::find_if(told.statements.begin(), told.statements.end(),
                                  [](const Statement& one) { return one.severity != Severity::danger; });
  ASSERT_NE(grave, told.statements.end());
  EXPECT_EQ(grave->kind, "row_some");
  const auto table =
      std::find_if(told.tables.begin(), told.tables.end(), [](const StoryTable& one) { return one.kind == "row"; });
  ASSERT_NE(table, told.tables.end());
  EXPECT_EQ(table->marked, std::vector<std::size_t>{1});
  EXPECT_EQ(table->columns.at(2).texts, (std::vector<std::string>{"0 / 2", "2 / 2"}));
}

TEST_F(SuiteOfThree, MarksNeedsOfBuildingsThatMeetNobodyWhereAnotherGapCloses) {
  const Story told = suite_story(*run, *gaps);
  const Statement* const first = find(told.statements, "records_short", 0);
  const Statement* const second = find(told.statements, "records_short", 1);
  ASSERT_TRUE(first != nullptr && second != nullptr);
  EXPECT_EQ(word(*first, "others_open"), "story.if_no_other_closed");
  EXPECT_EQ(word(*second, "others_open"), "");
  const std::vector<std::string> checks = suite_hand_in(*run, *gaps).checks.columns.at(0).texts;
  EXPECT_EQ(std::count(checks.begin(), checks.end(), "check.gap_records_alone"), 1);
  EXPECT_EQ(std::count(checks.begin(), checks.end(), "check.gap_records"), 1);
}

TEST_F(SuiteOfThree, NoRuleIsMetOfFewerRecordsThanItsCodeTakes) {
  const Story told = suite_story(*run, *gaps);
  EXPECT_NE(find(told.statements, "suite_too_few", 0), nullptr);
  EXPECT_NE(find(told.statements, "records_rules_few", 0), nullptr);
  EXPECT_EQ(find(told.statements, "records_rules", 0), nullptr);
  EXPECT_NE(find(told.statements, "records_rules_short", 1), nullptr);  // one record is enough for that
  const StoryTable checks = suite_hand_in(*run, *gaps).checks;
  for (std::size_t i = 0; i < checks.columns.at(0).texts.size(); ++i) {
    if (checks.columns[0].texts[i] != "EN 1998-1:2004") continue;
    EXPECT_EQ(checks.columns.at(5).texts.at(i),
              checks.columns.at(2).texts.at(i) == "A | B" ? "check.too_few" : "check.not_met");
  }
}

/// Under the first record it is too small and a storey collapses, under the second a storey collapses.
TEST(JudgementOfMany, CountsReasonsAmongItsOwnRecords) {
  const Reason contact{.kind = Reason::Kind::contact, .value = 1};
  const Reason collapse{.kind = Reason::Kind::collapse, .value = 2};
  const Reason left{.kind = Reason::Kind::motion_left, .value = std::numeric_limits<double>::infinity()};
  Reason left_reversed = left;
  left_reversed.way = Way::reversed;
  const auto told = [](std::vector<Reason> reasons, Sufficiency value) {
    ToldJudgement made{.right = 1, .width = 0.1, .judgement = {.value = value, .reasons = std::move(reasons)}};
    made.reasons.resize(made.judgement.reasons.size());
    return made;
  };
  ManyToTell many{.names = {"1", "2"},
                  .of_records = {told({contact, collapse}, Sufficiency::too_small),
                                 told({collapse, left, left_reversed}, Sufficiency::unknown)},
                  .many = {},
                  .left = "A",
                  .right = "B",
                  .length = "m"};
  std::vector<Judgement> judged;
  for (const ToldJudgement& one : many.of_records) judged.push_back(one.judgement);
  many.many = judge(judged, {});
  const std::vector<Statement> all = judgement_of_many(many, 0);
  ASSERT_EQ(all.size(), 2U);
  EXPECT_EQ(all[1].kind, "records_not_known");
  ASSERT_EQ(all[1].items.size(), 2U);  // that the motion goes on is said once
  EXPECT_EQ(std::get<long>(all[1].items[0].front().value), 1);
  EXPECT_EQ(std::get<std::string>(all[1].items[0].back().value), "2");
}

TEST(JudgementOfMany, DriftAsFarAsCollapseIsOneKind) {
  const auto says = [](const char* kind, double drift) {
    return Statement{.kind = kind, .gap = {}, .values = {{"drift", drift, "%"}}};
  };
  const std::vector<Statement> all =
      union_of({{"1", {says("drift_beyond", 20)}}, {"2", {says("drift_beyond_alone", 30)}}});
  ASSERT_EQ(all.size(), 1U);
  EXPECT_EQ(all[0].kind, "drift_beyond_alone");
  EXPECT_EQ(all[0].many->count, 2);
}

TEST(JudgementOfMany, OfNoGapItIsKnown) {
  EXPECT_EQ(counted_gaps(2, 0, 2).kind, "row_all_unknown");
  EXPECT_EQ(counted_gaps(2, 0, 1).kind, "row_unknown");
  EXPECT_EQ(counted_gaps(2, 1, 1).kind, "row_some");
  EXPECT_EQ(counted_gaps(2, 0, 0).kind, "row_none");
}

}  // namespace
}  // namespace bentur
