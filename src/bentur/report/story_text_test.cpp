#include "bentur/report/story_text.h"

#include <gtest/gtest.h>

#include <string>

namespace bentur {
namespace {

/// What is in bold of a building's collapse, the building's name as given.
std::string bold(const std::string& building) {
  Statement statement{.kind = "collapse", .severity = Severity::danger};
  for (const char* name : {"building", "time", "storey", "limit"}) {
    statement.values.push_back({name, std::string(name) == "building" ? building : "1"});
  }
  const SaidStatement one = said({statement}, Words("en")).front();
  return one.text.substr(0, one.lead);
}

TEST(Bold, IsTheFirstSentence) {
  EXPECT_EQ(bold("A"), "A collapses at 1: the drift of storey 1 exceeds 1 of its height.");
}

TEST(Bold, OfALongSentenceIsItsFirstClausesNotWithinBrackets) {
  EXPECT_EQ(bold(std::string(120, 'x')), std::string(120, 'x') + " collapses at 1:");
  EXPECT_EQ(bold(std::string(80, 'x') + ", y (" + std::string(20, 'z') + ", z)" + std::string(80, 'x')),
            std::string(80, 'x') + ",");
  EXPECT_EQ(bold("A (" + std::string(200, 'x')), "A (" + std::string(200, 'x') +
                                                     " collapses at 1: the drift of "
                                                     "storey 1 exceeds 1 of its height.");
}

/// Quadratic work over such a name would last for hours.
TEST(Bold, OfTwoMillionLettersIsFoundAtOnce) {
  const std::string name(2'000'000, 'x');
  EXPECT_EQ(bold(name), name + " collapses at 1: the drift of storey 1 exceeds 1 of its height.");
}

/// A number of the table of what else is known is rounded once, to the decimals of the column: 0.088249 is 0.0882,
/// though with four digits it is 0.08825.
TEST(KnownTable, RoundsEachNumberOnce) {
  const auto pushed = [](double needed) {
    return Statement{
        .kind = "row_pushed", .values = {{"needed", needed, "m"}, {"level", 3.0, "m"}}, .shown = Shown::row};
  };
  const std::vector<SaidStatement> all = said({pushed(0.088249), pushed(0.1234)}, Words("en"));
  const SaidTable table = known_table({"A | B"}, all, Words("en")).value();
  EXPECT_EQ(table.columns[1].cells, (std::vector<std::string>{"0.0882\u00A0m", "0.1234\u00A0m"}));
  EXPECT_EQ(all.front().rows.front()[1], "0.08825\u00A0m");
}

/// The frame of a verdict, in every door.
TEST(VerdictTone, IsOfWhatIsJudged) {
  const SaidStatement fine{.kind = "a", .severity = Severity::finding},
      small{.kind = "b", .severity = Severity::warning};
  const SaidStatement open{.kind = "c", .severity = Severity::warning, .is_open = true};
  const SaidStatement row{.kind = "d", .severity = Severity::warning, .shown = Shown::row};
  EXPECT_STREQ(verdict_tone({fine}), "clear");
  EXPECT_STREQ(verdict_tone({fine, open}), "open");
  EXPECT_STREQ(verdict_tone({open, row}), "open");
  EXPECT_STREQ(verdict_tone({fine, open, small}), "pounds");
}

Statement silent(const std::vector<std::pair<std::string, std::string>>& rules, Eigen::Index gap = 0) {
  Statement one{.kind = "rules_silent", .gap = gap, .rank = 1};
  for (const auto& [rule, why] : rules) one.items.push_back({{"rule", rule}, {"why", why, {}, true}});
  return one;
}

/// Which of many runs is named: the one with the worst, whatever number comes first in its statement.
TEST(Union, NamesTheRunThatSaysTheWorst) {
  const auto of = [](const char* run, const char* kind, std::vector<StoryValue> values, Shown shown = Shown::sentence) {
    return SaidOfRun{run, {{.kind = kind, .gap = 0, .values = std::move(values), .shown = shown}}};
  };
  const auto worst = [](const std::vector<SaidOfRun>& runs) { return union_of(runs).front().many->worst; };
  EXPECT_EQ(worst({of("a", "infill_weakens", {{"left", 95.3, "%"}}), of("b", "infill_weakens", {{"left", 20.0, "%"}})}),
            "b");
  EXPECT_EQ(worst({of("a", "columns_break", {{"broken", 4L}, {"time", 4.21, "s"}}),
                   of("b", "columns_break", {{"broken", 7L}, {"time", 2.471, "s"}})}),
            "b");
  // Hinges beyond one level do not hide those that are beyond another.
  const std::vector<Statement> hinges =
      union_of({of("a", "hinges_beyond", {{"limit", "IO"}, {"count", 8L}, {"demand", 10.92}}),
                of("b", "hinges_beyond", {{"limit", "CP"}, {"count", 4L}, {"demand", 1.06}})});
  ASSERT_EQ(hinges.size(), 2U);
  EXPECT_EQ(hinges[0].many->count, 1);
  // Of a row of many gaps a run has its impacts in a table, which a suite has not.
  const std::vector<Statement> impacts =
      union_of({of("a", "pounding", {{"force", 1799.0, "kN"}}, Shown::table),
                of("b", "no_pounding", {}),
                {"c", {{.kind = "pounding", .gap = 1, .values = {{"force", 2299.0, "kN"}}, .shown = Shown::table}}}});
  ASSERT_EQ(impacts.size(), 2U);
  for (const Statement& one : impacts) EXPECT_EQ(one.shown, one.gap == 1 ? Shown::sentence : Shown::row);
}

/// What rules ask is told of all runs together; that a rule says nothing under any of them is told with its reason.
TEST(Union, HasTheRulesThatAreSilentUnderAllRuns) {
  const std::vector<Statement> all =
      union_of({{"a",
                 {silent({{"DDC", "story.silence.linked"}, {"SRSS", "story.silence.unknown"}}),
                  silent({{"ABS", "story.silence.no_level"}}, 1)}},
                {"b", {{.kind = "rules_less", .gap = 0}, silent({{"DDC", "story.silence.linked"}})}}});
  ASSERT_EQ(all.size(), 1U);
  EXPECT_EQ(all.front().kind, "rules_silent");
  EXPECT_EQ(all.front().gap, 0);
  EXPECT_FALSE(all.front().rank);
  ASSERT_EQ(all.front().items.size(), 1U);
  EXPECT_EQ(std::get<std::string>(all.front().items[0][0].value), "DDC");
  EXPECT_EQ(std::get<std::string>(all.front().items[0][1].value), "story.silence.linked");
}

/// "By NTC 2018" has no B and no C.
TEST(StoryText, ASentenceNamesItsGapByWholeWords) {
  EXPECT_EQ(of_gap("By NTC 2018 the gap given is too small.", "B | C"),
            "B | C: By NTC 2018 the gap given is too small.");
  EXPECT_EQ(of_gap("The gap of 2 m between B and C is too small.", "B | C"),
            "The gap of 2 m between B and C is too small.");
  EXPECT_EQ(of_gap("B\u00A0| C", "B | C"), "B\u00A0| C");
}

}  // namespace
}  // namespace bentur
