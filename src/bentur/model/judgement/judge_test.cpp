// The table of truth: from every combination of facts what is said of a gap, and why first.
#include "bentur/model/judgement/judge.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "bentur/model/judgement/compare.h"

namespace bentur {
namespace {

/// One level, 0.05 wide, that needs 0.02 each way; both ways looked at.
GapFacts nothing_wrong() {
  GapFacts facts;
  facts.left = "A";
  facts.right = "B";
  facts.levels.emplace_back();
  facts.levels[0].at.elevation = 3;
  facts.levels[0].at.width = 0.05;
  facts.given.looked_at = facts.reversed.looked_at = true;
  for (const Way way : ways_of_motion) facts.levels[0].in(way).need = 0.02;
  facts.scale = 0.02;
  return facts;
}

WayFacts& in(GapFacts& facts, Way way) { return way == Way::given ? facts.given : facts.reversed; }

/// A thing that may be wrong in one way of the motion, and what follows from it.
struct Wrong {
  const char* name;
  void (*put)(GapFacts&, Way);
  Reason::Kind kind;
};

const std::vector<Wrong>& wrongs() {
  static const std::vector<Wrong> all = {
      {"contact",
       [](GapFacts& facts, Way way) {
         facts.levels[0].in(way).impacts = 3;
         facts.levels[0].in(way).peak_force = 12;
       },
       Reason::Kind::contact},
      {"contact without force", [](GapFacts& facts, Way way) { facts.levels[0].in(way).impacts = 1; },
       Reason::Kind::contact},
      {"unmodelled", [](GapFacts& facts, Way way) { facts.levels[0].in(way).depth = 0.01; }, Reason::Kind::unmodelled},
      {"need", [](GapFacts& facts, Way way) { facts.levels[0].in(way).need = 0.051; }, Reason::Kind::need},
      {"fall",
       [](GapFacts& facts, Way way) {
         in(facts, way).fall = Fall{"A", 2, 1.5};
         facts.levels[0].in(way).need.reset();
       },
       Reason::Kind::collapse},
      {"fall with contact",
       [](GapFacts& facts, Way way) {
         in(facts, way).fall_with_contact = Fall{"B", 1, 2.5};
       },
       Reason::Kind::collapse},
      {"drift",
       [](GapFacts& facts, Way way) {
         in(facts, way).drifts = {{"A", 1, 0.2}};
         facts.levels[0].in(way).need.reset();
       },
       Reason::Kind::drift},
      {"capacity",
       [](GapFacts& facts, Way way) {
         in(facts, way).capacities = {{"A", 1, 3.0}};
       },
       Reason::Kind::capacity},
      {"motion left", [](GapFacts& facts, Way way) { facts.levels[0].in(way).to_come = 0.06; },
       Reason::Kind::motion_left},
      {"not looked at",
       [](GapFacts& facts, Way way) {
         in(facts, way).looked_at = false;
         facts.levels[0].in(way).need.reset();
       },
       Reason::Kind::not_looked_at},
      {"contact not looked at", [](GapFacts& facts, Way way) { in(facts, way).contact_looked_at = false; },
       Reason::Kind::not_looked_at},
  };
  return all;
}

RuleFinding rule_that_is_short() {
  return {.rule = "asce-7-16", .title = "ASCE 7-16, IBC", .at = 0, .gap = 0.09, .is_short = true};
}
Remark doubt() { return {"pga_without_unit", "", 0.03, "g", {}, {}, true}; }

TEST(Judge, SaysEnoughWhereNothingSpeaksAgainstIt) {
  const Judgement made = judge(nothing_wrong());
  EXPECT_TRUE(made.is_enough());
  EXPECT_TRUE(made.reasons.empty());
  EXPECT_EQ(made.levels, std::vector{Sufficiency::enough});
  EXPECT_EQ(word_of(made.value), "enough");
  GapFacts still = nothing_wrong();  // no ground motion, which has no other way
  still.has_other_way = false;
  still.reversed = {};
  still.levels[0].reversed = {};
  EXPECT_TRUE(judge(still).is_enough());
}

TEST(Judge, EveryFactByItself) {
  for (const Wrong& wrong : wrongs()) {
    for (const Way way : ways_of_motion) {
      SCOPED_TRACE(wrong.name);
      GapFacts facts = nothing_wrong();
      wrong.put(facts, way);
      const Judgement made = judge(facts);
      ASSERT_FALSE(made.reasons.empty());
      EXPECT_EQ(made.reasons.front().kind, wrong.kind);
      EXPECT_EQ(made.reasons.front().way, way);
      EXPECT_EQ(made.value, says_too_small(wrong.kind) ? Sufficiency::too_small : Sufficiency::unknown);
      EXPECT_EQ(made.levels[0], made.value);
      EXPECT_EQ(word_of(made.reasons.front()).ends_with(" reversed"), way == Way::reversed);
    }
  }
}

// What is not known whatever the motion: contact with masses elsewhere, rules of a case that is not there.
TEST(Judge, WhatNobodyLookedAt) {
  for (const auto& [member, what] :
       {std::pair(&GapFacts::masses_moved, NotLookedAt::masses), {&GapFacts::lacks_rules, NotLookedAt::rules}}) {
    GapFacts facts = nothing_wrong();
    facts.*member = true;
    const Judgement made = judge(facts);
    EXPECT_EQ(made.value, Sufficiency::unknown);
    ASSERT_EQ(made.reasons.size(), 1U);
    EXPECT_EQ(made.reasons.front().kind, Reason::Kind::not_looked_at);
    EXPECT_EQ(made.reasons.front().count, static_cast<long>(what));
    facts.levels[0].given.impacts = 1;
    EXPECT_EQ(judge(facts).value, Sufficiency::too_small);
  }
}

TEST(Judge, EveryCombinationOfFacts) {
  const std::size_t count = 2 * wrongs().size();
  long seen = 0;
  for (std::size_t first = 0; first < count; ++first) {
    for (std::size_t second = first; second < count; ++second) {
      for (const bool has_rule : {false, true}) {
        for (const bool has_doubt : {false, true}) {
          GapFacts facts = nothing_wrong();
          std::vector<Reason::Kind> kinds;
          for (const std::size_t i : {first, second}) {
            const Wrong& wrong = wrongs()[i / 2];
            wrong.put(facts, i % 2 == 0 ? Way::given : Way::reversed);
            kinds.push_back(wrong.kind);
          }
          // What falls or is not looked at says nothing of what it needs, and what is needed nothing of what may come.
          for (const Way way : ways_of_motion) {
            const bool unknown = !in(facts, way).looked_at || in(facts, way).fall || !in(facts, way).drifts.empty();
            if (unknown) facts.levels[0].in(way).need.reset();
          }
          if (has_rule) facts.rules = {rule_that_is_short()};
          if (has_rule) kinds.push_back(Reason::Kind::rule);
          if (has_doubt) facts.doubts = {doubt()};
          if (has_doubt) kinds.push_back(Reason::Kind::doubt);
          const Judgement made = judge(facts);
          ++seen;
          EXPECT_FALSE(made.is_enough());
          ASSERT_FALSE(made.reasons.empty());
          EXPECT_TRUE(std::is_sorted(made.reasons.begin(), made.reasons.end(),
                                     [](const Reason& a, const Reason& b) { return a.kind < b.kind; }));
          const bool small = std::any_of(made.reasons.begin(), made.reasons.end(),
                                         [](const Reason& one) { return says_too_small(one.kind); });
          EXPECT_EQ(made.value, small ? Sufficiency::too_small : Sufficiency::unknown);
          // The worst of what was put in comes first, unless what hides it does.
          const Reason::Kind worst = *std::min_element(kinds.begin(), kinds.end());
          if (worst != Reason::Kind::need && worst != Reason::Kind::motion_left) {
            EXPECT_EQ(made.reasons.front().kind, worst)
                << wrongs()[first / 2].name << " and " << wrongs()[second / 2].name;
          }
        }
      }
    }
  }
  EXPECT_EQ(seen, static_cast<long>(4 * count * (count + 1) / 2));
}

TEST(Judge, OfSeveralLevelsTheWorst) {
  GapFacts facts = nothing_wrong();
  facts.levels.push_back(facts.levels[0]);
  facts.levels[1].at.elevation = 6;
  facts.levels[1].at.width = 0.04;
  facts.levels[0].given.need = 0.055;  // 0.005 more than is given
  facts.levels[1].given.need = 0.046;  // 0.006
  const Judgement made = judge(facts);
  ASSERT_EQ(made.reasons.size(), 1U);
  EXPECT_EQ(made.reasons[0].level, 1U);
  EXPECT_EQ(made.reasons[0].value, 0.046);
  EXPECT_EQ(made.levels, (std::vector{Sufficiency::too_small, Sufficiency::too_small}));
  const auto governing = governing_need(facts);
  ASSERT_TRUE(governing);
  EXPECT_EQ(governing->at.elevation, 6);
  EXPECT_TRUE(governing->given.is_short);
  EXPECT_FALSE(governing->reversed.is_short);
  facts.levels[0].reversed.need = 0.058;  // 0.008 more, by the motion reversed
  EXPECT_EQ(governing_need(facts)->at.elevation, facts.levels[0].at.elevation);
  EXPECT_TRUE(governing_need(facts)->reversed.is_short);
  facts.levels[0].reversed.need.reset();
  facts.levels[0].given.impacts = 2;
  facts.levels[0].given.peak_force = 5;
  facts.levels[1].given.impacts = 4;
  facts.levels[1].given.peak_force = 3;
  EXPECT_EQ(judge(facts).reasons[0].count, 6);
  EXPECT_EQ(judge(facts).reasons[0].value, 5);
  EXPECT_EQ(judge(facts).reasons[0].level, 0U);
}

/// A lower level is not enough by what a higher one lacks already: with more given there it would not be known.
TEST(Judge, NoLevelIsEnoughWhileMoreMayCome) {
  GapFacts facts = nothing_wrong();
  facts.levels.push_back(facts.levels[0]);
  facts.levels[1].given.need = facts.levels[1].at.width + 0.01;
  EXPECT_EQ(judge(facts).levels, (std::vector{Sufficiency::enough, Sufficiency::too_small}));
  for (const Way way : ways_of_motion) {
    GapFacts one = facts;
    one.levels[0].in(way).to_come = one.levels[0].at.width + 0.01;
    EXPECT_EQ(judge(one).levels, (std::vector{Sufficiency::unknown, Sufficiency::too_small}));
    EXPECT_EQ(judge(one).value, Sufficiency::too_small);
  }
}

TEST(Judge, RulesOfThumbDoNotDecide) {
  GapFacts facts = nothing_wrong();
  facts.rules = {{.rule = "abs", .title = "ABS", .at = 0, .gap = 0.09, .is_short = true}};
  EXPECT_TRUE(judge(facts).is_enough());
  facts.rules.push_back(rule_that_is_short());
  ASSERT_EQ(judge(facts).reasons.size(), 1U);
  EXPECT_EQ(judge(facts).reasons[0].subject, "ASCE 7-16, IBC");
}

TEST(Judge, RoundOffIsNotALack) {
  EXPECT_FALSE(is_below_target(0.05, 0.05 * (1 + 1e-12), 1));
  EXPECT_TRUE(is_below_target(0.05, 0.050001, 1));
  EXPECT_EQ(without_round_off(1e-12, 1), 0);
  GapFacts facts = nothing_wrong();
  facts.levels[0].given.need = 0.05 * (1 + 1e-12);
  EXPECT_TRUE(judge(facts).is_enough());
}

TEST(Judge, ManyRunsAreAUnion) {
  GapFacts struck = nothing_wrong(), fallen = nothing_wrong();
  struck.levels[0].given.impacts = 1;
  struck.levels[0].given.peak_force = 7;
  fallen.given.fall = Fall{"A", 1, 2.0};
  fallen.levels[0].given.need.reset();
  GapFacts by_rule = nothing_wrong();
  by_rule.rules = {rule_that_is_short()};
  GapFacts harder = struck;
  harder.levels[0].given.peak_force = 9;
  const std::vector<Judgement> runs = {judge(nothing_wrong()), judge(struck), judge(fallen), judge(by_rule),
                                       judge(harder)};
  const JudgementOfMany made = judge(runs, {});
  EXPECT_EQ(made.runs, 5);
  EXPECT_EQ(made.too_small, 2);
  EXPECT_EQ(made.not_known, 1);
  EXPECT_EQ(made.enough, 2) << "a rule is judged over all records";
  EXPECT_EQ(made.value, Sufficiency::too_small);
  ASSERT_EQ(made.reasons.size(), 2U);
  EXPECT_EQ(made.reasons[0].worst.kind, Reason::Kind::contact);
  EXPECT_EQ(made.reasons[0].worst.value, 9);
  EXPECT_EQ(made.reasons[0].run, 4U);
  EXPECT_EQ(made.reasons[0].runs, 2);
  EXPECT_EQ(made.reasons[1].worst.kind, Reason::Kind::collapse);
  EXPECT_EQ(judge({runs[0], runs[0]}, {}).value, Sufficiency::enough);
  EXPECT_EQ(judge({runs[0], runs[2]}, {}).value, Sufficiency::unknown);
  const Reason asked{.kind = Reason::Kind::rule, .value = 0.09, .width = 0.05, .subject = "EN 1998-1:2004"};
  EXPECT_EQ(judge({runs[0]}, {asked}).value, Sufficiency::too_small);
}

}  // namespace
}  // namespace bentur
