#include <gtest/gtest.h>

#include <map>
#include <string>
#include <vector>

#include "bentur/model/gap/code_rules.h"

// Numbers worked by hand from the clauses, in mm.
namespace bentur {
namespace {

/// Both at level h of buildings so high, of one owner.
CodePair two_in_mm(double left, double right, double h = 12000) {
  return {.left = {.displacement = left, .level = h, .height = h, .storeys = 4},
          .right = {.displacement = right, .level = h, .height = h, .storeys = 4},
          .boundary = Boundary::one_owner,
          .metre = 1000};
}

/// A rule with numbers of one for both buildings, or one each.
CodeRuleSpec rule_with(const std::string& rule, const std::map<std::string, std::vector<double>>& numbers,
                       const std::map<std::string, std::vector<std::string>>& words = {}) {
  CodeRuleSpec given{.rule = rule};
  given.numbers.insert(numbers.begin(), numbers.end());
  given.words.insert(words.begin(), words.end());
  return given;
}

double asked(const CodePair& pair, const CodeRuleSpec& given) { return code_separation(pair, given).gap; }

TEST(CodeRulesByHand, ItalianWithoutACalculationTakesTheHeightsOfTheBuildings) {
  CodePair pair = two_in_mm(0, 0, 14000);  // the contact, at the roof of the lower one
  pair.left.height = 21000;
  const CodeRuleSpec given = rule_with("ntc-2018", {{"ground_acceleration", {0.2}}, {"soil_factor", {1.25}}});
  const auto alone = height_separation(pair, given);
  EXPECT_NEAR(alone->asked.gap, 52.5 + 35, 1e-12) << "not 2 · 35 of the level";
  EXPECT_FALSE(alone->is_least);
  pair.left.is_isolated = true;
  const auto isolated = height_separation(pair, given);
  EXPECT_NEAR(isolated->asked.gap, 70, 1e-12) << "the estimate is not for it: 14 m / 100 · 2 · 0.25 remains";
  EXPECT_TRUE(isolated->is_least);
}

TEST(CodeRulesByHand, OfOlderRules) {
  const auto line = [](CodePair pair) {
    pair.boundary = Boundary::property_line;
    return pair;
  };
  const auto level = [](CodePair pair) {
    pair.floors_aligned = true;
    return pair;
  };
  const CodeRuleSpec indian = rule_with("is-1893-1", {{"response_reduction", {5, 3}}});
  EXPECT_NEAR(asked(level(two_in_mm(10, 15)), indian), 95, 1e-12);
  EXPECT_NEAR(asked(two_in_mm(10, 15), indian), 125, 1e-12);
  EXPECT_NEAR(asked(two_in_mm(60, 80), rule_with("rpa-2024", {})), 100, 1e-12);
  EXPECT_NEAR(asked(two_in_mm(24, 18), rule_with("rpa-2024", {})), 40, 1e-12);
  const CodeRuleSpec turkish = rule_with("tbdy-2018", {{"response_reduction", {8}}, {"importance_factor", {1}}});
  EXPECT_NEAR(asked(level(two_in_mm(18, 24)), turkish), 60, 1e-12);
  EXPECT_NEAR(asked(two_in_mm(18, 24), turkish), 120, 1e-12);
  EXPECT_NEAR(asked(two_in_mm(0, 0, 14000), turkish), 60, 1e-12) << "a begun step counts";
  EXPECT_NEAR(asked(two_in_mm(60, 90), rule_with("e-030-2018", {})), 100, 1e-12);
  const CodeSeparation peru = code_separation(line(two_in_mm(60, 90)), rule_with("e-030-2018", {}));
  EXPECT_NEAR(peru.to_left.value(), 50, 1e-12);
  EXPECT_NEAR(peru.to_right.value(), 60, 1e-12);
  EXPECT_NEAR(asked(two_in_mm(100, 60), rule_with("nec-se-ds", {})), 80, 1e-12);
  EXPECT_NEAR(asked(level(two_in_mm(100, 60)), rule_with("nec-se-ds", {})), 50, 1e-12);
  const CodeRuleSpec american =
      rule_with("asce-7-16", {{"deflection_amplification", {5.5, 4.5}}, {"importance_factor", {1}}});
  EXPECT_NEAR(asked(two_in_mm(20, 30), american), 174.1, 0.05);
  const CodeSeparation asce = code_separation(line(two_in_mm(20, 30)), american);
  EXPECT_NEAR(asce.to_left.value(), 110, 1e-12);
  EXPECT_NEAR(asce.to_right.value(), 135, 1e-12);
  const CodeRuleSpec canadian =
      rule_with("nbcc", {{"ductility_factor", {4}}, {"overstrength_factor", {1.7}}, {"importance_factor", {1}}});
  EXPECT_NEAR(asked(two_in_mm(10, 15), canadian), 122.6, 0.05);
  const CodeRuleSpec european = rule_with("en-1998-1", {{"behaviour_factor", {3.9}}});
  EXPECT_NEAR(asked(two_in_mm(20, 30), european), 140.6, 0.05);
  EXPECT_NEAR(asked(level(two_in_mm(20, 30)), european), 98.4, 0.05);
  EXPECT_NEAR(code_separation(two_in_mm(20, 30), european).to_left.value(), 78, 1e-12);
  EXPECT_NEAR(code_separation(two_in_mm(20, 30), european).to_right.value(), 117, 1e-12);
  EXPECT_NEAR(asked(two_in_mm(0, 0, 24000), rule_with("gb-50011-2010", {{"intensity", {8}}}, {{"system", {"frame"}}})),
              160, 1e-9);
  EXPECT_NEAR(asked(two_in_mm(0, 0, 24000),
                    rule_with("gb-50011-2010", {{"intensity", {8}}}, {{"system", {"frame"}}, {"material", {"steel"}}})),
              240, 1e-9);
}

TEST(CodeRulesByHand, Argentine) {
  CodeRuleSpec given = rule_with("inpres-cirsoc-103", {{"deflection_amplification", {5}}, {"importance_factor", {1}}});
  const CodeSeparation known = code_separation(two_in_mm(20, 5), given);
  EXPECT_NEAR(known.to_left.value(), 105, 1e-12);
  EXPECT_NEAR(known.to_right.value(), 26.25, 1e-12);
  EXPECT_NEAR(known.gap, 131.25, 1e-12);
  EXPECT_NEAR(asked(two_in_mm(20, 2), given), 105 + 25, 1e-12) << "never under 25 mm";
  given.words["displacements"] = {"calculated", "unknown"};
  EXPECT_NEAR(asked(two_in_mm(20, 5), given), 105 + 300, 1e-12) << "0.025 h";
  EXPECT_NEAR(height_separation(two_in_mm(20, 5), given)->asked.gap, 25 + 300, 1e-12);
  EXPECT_TRUE(height_separation(two_in_mm(20, 5), given)->is_least);
}

TEST(CodeRulesByHand, Uniform) {
  const CodeRuleSpec given = rule_with("ubc-97", {{"response_reduction", {8.5, 5.5}}});
  CodePair pair = two_in_mm(20, 30);
  EXPECT_NEAR(asked(pair, given), 165.8, 0.05);
  pair.boundary = Boundary::property_line;
  const CodeSeparation across = code_separation(pair, given);
  EXPECT_NEAR(across.to_left.value(), 119, 1e-12);
  EXPECT_NEAR(across.to_right.value(), 115.5, 1e-12);
  EXPECT_NEAR(across.gap, 234.5, 1e-12);
  EXPECT_NEAR(asked(pair, rule_with("ubc-97", {{"response_reduction", {1}}})), 50, 1e-12)
      << "a motion that is not reduced is not made less of";
}

TEST(CodeRulesByHand, MexicanOf2020) {
  CodeRuleSpec given =
      rule_with("ntc-2020", {{"behaviour_factor", {3}}, {"overstrength_factor", {2}}}, {{"zone", {"I"}}});
  const auto to_line = [&](const char* zone) {
    given.words["zone"] = {zone};
    return code_separation(two_in_mm(20, 1), given).to_left.value();
  };
  EXPECT_NEAR(to_line("I"), 120, 1e-12);
  EXPECT_NEAR(to_line("II"), 156, 1e-12);
  EXPECT_NEAR(to_line("III"), 192, 1e-12);
  EXPECT_NEAR(asked(two_in_mm(20, 1), given), 192 + 78, 1e-12);
  given.flags["base_modelled"] = true;
  EXPECT_NEAR(to_line("III"), 120, 1e-12);
  EXPECT_NEAR(asked(two_in_mm(20, 1), given), 120 + 50, 1e-12) << "never under 50 mm";
}

TEST(CodeRulesByHand, Iranian) {
  CodeRuleSpec given = rule_with("iran-2800", {{"deflection_amplification", {5}}}, {{"importance", {"ordinary"}}});
  CodePair pair = two_in_mm(20, 16);
  EXPECT_NEAR(asked(pair, given), 60 + 60, 1e-12) << "0.005 · 12 m of each, whatever they move";
  ASSERT_TRUE(height_separation(pair, given));
  EXPECT_FALSE(height_separation(pair, given)->is_least);
  given.words["importance"] = {"high"};
  EXPECT_NEAR(asked(pair, given), 128.1, 0.05) << "√(100² + 80²) on one lot";
  EXPECT_TRUE(height_separation(pair, given)->is_least);
  pair.boundary = Boundary::property_line;
  EXPECT_NEAR(asked(pair, given), 180, 1e-12);
  given.words["importance"] = {"high", "ordinary"};
  EXPECT_NEAR(asked(pair, given), 100 + 60, 1e-12);
  pair.right.storeys = 9;
  EXPECT_NEAR(asked(pair, given), 180, 1e-12) << "more than 8 storeys";
}

TEST(CodeRulesByHand, Chilean) {
  const CodeRuleSpec buildings = rule_with("nch-433", {{"response_reduction", {6}}});
  const CodeSeparation found = code_separation(two_in_mm(10, 1.7), buildings);
  EXPECT_NEAR(found.to_left.value(), 40, 1e-12);
  EXPECT_NEAR(found.to_right.value(), 24, 1e-12) << "0.002 · 12 m";
  EXPECT_NEAR(found.gap, 64, 1e-12);
  EXPECT_NEAR(asked(two_in_mm(1, 1, 3000), buildings), 30, 1e-12) << "15 mm each";
  EXPECT_NEAR(asked(two_in_mm(50, 40), rule_with("nch-433", {{"response_reduction", {1}}})), 90, 1e-12)
      << "a motion that is not reduced is not made less of";
  CodeRuleSpec plants = rule_with("nch-2369", {}, {{"importance", {"ordinary"}}});
  EXPECT_NEAR(asked(two_in_mm(60, 80), plants), 120, 1e-12);
  plants.flags["both_in_one_model"] = true;
  EXPECT_NEAR(asked(two_in_mm(60, 80), plants), 100, 1e-12);
  plants.words["importance"] = {"critical"};
  EXPECT_NEAR(asked(two_in_mm(60, 80), plants), 120, 1e-12);
  plants.flags.clear();
  EXPECT_NEAR(asked(two_in_mm(60, 80), plants), 150, 1e-12);
}

TEST(CodeRulesByHand, OfRigidBuildings) {
  const CodeRuleSpec given = rule_with("ufc-3-310-03a", {});
  EXPECT_NEAR(asked(two_in_mm(5, 5, 6096), given), 25.4, 1e-12) << "20 ft: 1 in";
  EXPECT_NEAR(asked(two_in_mm(5, 5, 12200), given), 50.8, 1e-12) << "40 ft: 2 in";
  EXPECT_NEAR(asked(two_in_mm(5, 5, 7000), given), 38.1, 1e-12) << "a begun step counts";
  EXPECT_NEAR(asked(two_in_mm(40, 30, 12200), given), 70, 1e-12) << "what they move, where that is more";
}

}  // namespace
}  // namespace bentur
