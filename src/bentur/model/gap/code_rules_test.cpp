#include "bentur/model/gap/code_rules.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "bentur/core/errors.h"
#include "bentur/core/units.h"
#include "bentur/model/gap/minimum_gap.h"
#include "tests/support/small_buildings.h"

namespace bentur {
namespace {

/// In metres: 3 cm and 4 cm at the roof of the lower one.
CodePair pair_in_metres() {
  return {.left = {.displacement = 0.03, .level = 12, .height = 12, .storeys = 4},
          .right = {.displacement = 0.04, .level = 12, .height = 24, .storeys = 8},
          .boundary = Boundary::one_owner};
}

/// Numbers a code could have, some for each building.
CodeRuleSpec spec(const std::string& rule) {
  CodeRuleSpec given{.rule = rule};
  given.numbers = {{"deflection_amplification", {5.5, 4.5}},
                   {"importance_factor", {1.25, 1.0}},
                   {"behaviour_factor", {3.0, 1.5}},
                   {"response_reduction", {5.0, 3.0}},
                   {"ductility_factor", {4.0, 2.0}},
                   {"overstrength_factor", {1.7, 1.4}},
                   {"intensity", {8}},
                   {"ground_acceleration", {0.2}},
                   {"soil_factor", {1.25}},
                   {"zone_factor", {0.45}}};
  given.words = {{"system", {"frame"}}, {"zone", {"II"}}, {"neighbour", {"coincides"}}, {"importance", {"ordinary"}}};
  return given;
}

double gap(const CodePair& pair, const CodeRuleSpec& given) { return code_separation(pair, given).gap; }

double gap(const std::string& rule, bool aligned, Boundary boundary = Boundary::one_owner) {
  CodePair pair = pair_in_metres();
  pair.floors_aligned = aligned;
  pair.boundary = boundary;
  return gap(pair, spec(rule));
}

constexpr Boundary boundaries[] = {Boundary::property_line, Boundary::one_owner, Boundary::public_way};

TEST(CodeRules, AsceAndSni) {
  for (const std::string rule : {"asce-7-16", "sni-1726-2019"}) {
    const double left = 5.5 * 0.03 / 1.25, right = 4.5 * 0.04;
    EXPECT_NEAR(gap(rule, false), std::sqrt(left * left + right * right), 1e-15);
    EXPECT_NEAR(gap(rule, true), gap(rule, false), 1e-15) << "alignment plays no part";
    EXPECT_NEAR(gap(rule, false, Boundary::property_line), left + right, 1e-15);
    const CodeSeparation found = code_separation(pair_in_metres(), spec(rule));
    EXPECT_NEAR(found.to_left.value(), left, 1e-15);
    EXPECT_NEAR(found.to_right.value(), right, 1e-15);
  }
}

TEST(CodeRules, Eurocode) {
  EXPECT_NEAR(gap("en-1998-1", false), std::hypot(0.09, 0.06), 1e-15);
  EXPECT_NEAR(gap("en-1998-1", true), 0.7 * std::hypot(0.09, 0.06), 1e-15);
  EXPECT_NEAR(gap("en-1998-1", false, Boundary::property_line), 0.15, 1e-15);
  EXPECT_NEAR(gap("en-1998-1", true, Boundary::property_line), 0.105, 1e-15);
}

TEST(CodeRules, Indian) {
  EXPECT_NEAR(gap("is-1893-1", false), 5 * (0.03 + 0.04), 1e-15) << "floors differ: one R, the larger";
  EXPECT_NEAR(gap("is-1893-1", true), 0.27, 1e-15) << "not halved unless that is asked for";
  CodeRuleSpec halved = spec("is-1893-1");
  halved.flags = {{"halved", true}};
  CodePair pair = pair_in_metres();
  EXPECT_NEAR(gap(pair, halved), 0.35, 1e-15);
  pair.floors_aligned = true;
  EXPECT_NEAR(gap(pair, halved), 0.135, 1e-15);
}

TEST(CodeRules, Canadian) { EXPECT_NEAR(gap("nbcc", false), std::hypot(4 * 1.7 * 0.03 / 1.25, 2 * 1.4 * 0.04), 1e-15); }

TEST(CodeRules, Turkish) {
  CodePair far = pair_in_metres();  // beyond the least, 50 mm at 12 m
  far.left.displacement = 0.06;
  const double combined = std::hypot(5 / 1.25 * 0.06, 3 * 0.04);
  EXPECT_NEAR(gap(far, spec("tbdy-2018")), 0.5 * combined, 1e-15);
  far.floors_aligned = true;
  EXPECT_NEAR(gap(far, spec("tbdy-2018")), 0.25 * combined, 1e-15);
  CodePair still = pair_in_metres();
  still.left.displacement = still.right.displacement = 0;
  for (const auto& [height, least] : std::vector<std::pair<double, double>>{
           {3, 0.030}, {6, 0.030}, {7, 0.040}, {9, 0.040}, {12, 0.050}, {14, 0.060}, {30, 0.110}}) {
    still.left.height = height;
    still.right.height = height + 10;
    EXPECT_NEAR(gap(still, spec("tbdy-2018")), least, 1e-15) << height;
    std::swap(still.left.height, still.right.height);
    EXPECT_NEAR(gap(still, spec("tbdy-2018")), least, 1e-15) << "the lower building decides";
  }
}

TEST(CodeRules, Chinese) {
  CodePair pair = pair_in_metres();
  pair.left.displacement = 1;  // does not matter
  CodeRuleSpec given = spec("gb-50011-2010");
  pair.left.height = pair.right.height = 15;
  for (const double intensity : {6.0, 7.0, 8.0, 9.0}) {
    given.numbers["intensity"] = {intensity};
    EXPECT_NEAR(gap(pair, given), 0.100, 1e-15);
  }
  pair.left.height = pair.right.height = 75;  // 60 m above: 12, 15, 20, 30 times 20 mm
  for (const auto& [intensity, width] :
       std::vector<std::pair<double, double>>{{6, 0.340}, {7, 0.400}, {8, 0.500}, {9, 0.700}}) {
    given.numbers["intensity"] = {intensity};
    given.words["system"] = {"frame"};
    EXPECT_NEAR(gap(pair, given), width, 1e-15);
    given.words["system"] = {"frame-wall"};
    EXPECT_NEAR(gap(pair, given), 0.7 * width, 1e-15);
    given.words["system"] = {"wall"};
    EXPECT_NEAR(gap(pair, given), 0.5 * width, 1e-15);
    given.words["system"] = {"wall", "frame-wall"};
    EXPECT_NEAR(gap(pair, given), 0.7 * width, 1e-15) << "the one that needs more decides";
  }
  pair.left.height = 20;  // 100 + 20·5/2 = 150 at intensity 9; half of it is below the least
  given.words["system"] = {"wall"};
  EXPECT_NEAR(gap(pair, given), 0.100, 1e-15);
  given.words["system"] = {"frame"};
  EXPECT_NEAR(gap(pair, given), 0.150, 1e-15);
}

TEST(CodeRules, Mexican) {
  CodePair pair = pair_in_metres();
  CodeRuleSpec given = spec("ntc-2004");
  for (const auto& [zone, slope] :
       std::vector<std::pair<std::string, double>>{{"I", 0.001}, {"II", 0.003}, {"III", 0.006}}) {
    given.words["zone"] = {zone};
    EXPECT_NEAR(gap(pair, given), 3 * 0.03 + slope * 12 + 1.5 * 0.04 + slope * 12, 1e-15) << zone;
  }
  given.words["zone"] = {"I"};
  pair.floors_aligned = true;
  const double whole = gap(pair, given);
  given.flags["structures_alike"] = true;
  EXPECT_NEAR(gap(pair, given), whole, 1e-15) << "half wants one height";
  pair.right.height = 12;
  EXPECT_NEAR(gap(pair, given), whole / 2, 1e-15);
  pair.floors_aligned = false;
  EXPECT_NEAR(gap(pair, given), whole, 1e-15) << "half needs both";
  given.words["method"] = {"simplified"};
  for (const auto& [zone, slope] :
       std::vector<std::pair<std::string, double>>{{"I", 0.007}, {"II", 0.009}, {"III", 0.012}}) {
    given.words["zone"] = {zone};
    EXPECT_NEAR(gap(pair, given), 2 * slope * 12, 1e-15) << zone << ": no displacement";
  }
  given.words.erase("method");
  given.words["zone"] = {"I"};
  pair.left.displacement = pair.right.displacement = 0.001;
  EXPECT_NEAR(gap(pair, given), 0.100, 1e-15) << "50 mm from each";
  EXPECT_NEAR(code_separation(pair, given).to_left.value(), 0.050, 1e-15);
}

TEST(CodeRules, ChineseSteel) {
  CodePair pair = pair_in_metres();
  pair.left.height = pair.right.height = 75;
  CodeRuleSpec given = spec("gb-50011-2010");
  given.words["material"] = {"concrete"};
  EXPECT_NEAR(gap(pair, given), 0.500, 1e-15);
  given.words["material"] = {"steel"};
  given.words["system"] = {"wall"};
  EXPECT_NEAR(gap(pair, given), 0.750, 1e-15) << "of the concrete frame, whatever its own system";
  given.words["material"] = {"concrete", "steel"};
  EXPECT_NEAR(gap(pair, given), 0.750, 1e-15) << "the one that needs more decides";
  pair.left.height = 12;
  EXPECT_NEAR(gap(pair, given), 0.150, 1e-15);
}

TEST(CodeRules, Italian) {  // a_g S = 0.25 g
  CodePair pair = pair_in_metres();
  EXPECT_NEAR(gap(pair, spec("ntc-2018")), 0.07, 1e-15) << "the sum of the displacements";
  pair.left.displacement = pair.right.displacement = 0.001;
  EXPECT_NEAR(gap(pair, spec("ntc-2018")), 0.060, 1e-15) << "12 m / 100 · 2 · 0.25";
  const auto alone = height_separation(pair, spec("ntc-2018"));
  ASSERT_TRUE(alone);
  EXPECT_NEAR(alone->asked.gap, 0.030 + 0.060, 1e-15) << "a hundredth of their own heights, 12 and 24 m";
  EXPECT_FALSE(alone->is_least);
  CodeRuleSpec strong = spec("ntc-2018");
  strong.numbers["ground_acceleration"] = {0.6};  // a_g S = 0.75 g: 2 a_g S/g counts as 1
  EXPECT_NEAR(gap(pair, strong), 0.120, 1e-15);
  EXPECT_NEAR(height_separation(pair, strong)->asked.gap, 0.090 + 0.180, 1e-15) << "the estimate has no such limit";
  pair.right.level = 10;  // whose ground is 2 m higher
  EXPECT_NEAR(gap(pair, strong), 0.120, 1e-15) << "the larger height";
}

TEST(CodeRules, Peruvian) {
  CodePair still = pair_in_metres();
  still.left.displacement = still.right.displacement = 0;
  EXPECT_NEAR(gap(still, spec("e-030-2018")), 0.072, 1e-15) << "0.006 · 12 m";
  EXPECT_NEAR(gap(still, spec("e-030-2026")), 0.02 * 0.45 * 1.25 * 12, 1e-15);
  EXPECT_NEAR(code_separation(still, spec("e-030-2018")).to_left.value(), 0.036, 1e-15);
  still.left.level = still.right.level = 3;
  EXPECT_NEAR(gap(still, spec("e-030-2018")), 0.030, 1e-15) << "never under 30 mm";
  CodePair far = pair_in_metres();
  far.left.displacement = 0.20;
  far.right.displacement = 0.04;
  EXPECT_NEAR(gap(far, spec("e-030-2018")), 0.16, 1e-15) << "two thirds of the sum";
  const CodeSeparation lined = code_separation(far, spec("e-030-2018"));
  EXPECT_NEAR(lined.to_left.value(), 0.4 / 3, 1e-15) << "two thirds of its own";
  EXPECT_NEAR(lined.to_right.value(), 0.08, 1e-15) << "half of s";
  far.boundary = Boundary::property_line;
  EXPECT_NEAR(gap(far, spec("e-030-2018")), 0.4 / 3 + 0.08, 1e-15);
  const auto alone = height_separation(far, spec("e-030-2018"));
  EXPECT_NEAR(alone->asked.gap, 0.072, 1e-15);
  EXPECT_TRUE(alone->is_least);
}

TEST(CodeRules, Colombian) {
  CodePair pair = pair_in_metres();
  CodeRuleSpec given = spec("nsr-10");
  EXPECT_NEAR(gap(pair, given), 0.07, 1e-15) << "of one construction the sum";
  EXPECT_FALSE(height_separation(pair, given));
  pair.boundary = Boundary::property_line;
  const std::vector<std::tuple<std::string, int, double>> rows = {
      {"coincides", 2, 0}, {"differs", 2, 0},       {"none", 1, 0},        {"coincides", 3, 0}, {"differs", 3, 0.120},
      {"none", 3, 0.120},  {"coincides", 4, 0.240}, {"differs", 4, 0.360}, {"none", 4, 0.120}};
  for (const auto& [neighbour, storeys, to_line] : rows) {
    SCOPED_TRACE(neighbour + ", storeys " + std::to_string(storeys));
    given.words["neighbour"] = {neighbour};
    pair.left.storeys = pair.right.storeys = storeys;
    const auto alone = height_separation(pair, given);
    ASSERT_TRUE(alone);
    EXPECT_FALSE(alone->is_least);
    EXPECT_NEAR(alone->asked.to_left.value(), to_line, 1e-15);
    EXPECT_NEAR(alone->asked.gap, (neighbour == "none" ? 2 : 1) * to_line, 1e-15);
    EXPECT_NEAR(gap(pair, given), alone->asked.gap, 1e-15) << "displacements play no part";
  }
  pair.left.level = pair.right.level = 6;
  EXPECT_NEAR(code_separation(pair, given).to_left.value(), 0.060, 1e-15) << "at other levels their height";
}

TEST(CodeRules, Algerian) {
  CodePair pair = pair_in_metres();
  EXPECT_NEAR(gap(pair, spec("rpa-2024")), 0.05, 1e-15);
  pair.left.displacement = 0.01;
  pair.right.displacement = 0.02;
  EXPECT_NEAR(gap(pair, spec("rpa-2024")), 0.040, 1e-15) << "never under 40 mm";
  EXPECT_NEAR(height_separation(pair, spec("rpa-2024"))->asked.gap, 0.040, 1e-15);
}

TEST(CodeRules, Ecuadorian) {
  EXPECT_NEAR(gap("nec-se-ds", false), 0.035, 1e-15) << "the mean";
  EXPECT_NEAR(gap("nec-se-ds", true), 0.020, 1e-15) << "half of the larger";
  EXPECT_TRUE(std::isnan(gap("nec-se-ds", true, Boundary::property_line))) << "not said of a property line";
  EXPECT_FALSE(height_separation(pair_in_metres(), spec("nec-se-ds")));
}

TEST(CodeRules, HeightsAloneAskNoMoreThanAnyDisplacements) {
  int with = 0;
  for (const CodeRule& rule : code_rules()) {
    for (const Boundary boundary : boundaries) {
      SCOPED_TRACE(rule.name);
      CodePair pair = pair_in_metres();
      pair.boundary = boundary;
      const CodeRuleSpec given = spec(std::string(rule.name));
      const auto alone = height_separation(pair, given);
      if (!alone) continue;
      ++with;
      for (double u = 0; alone->is_least && u < 0.2; u += 0.01) {
        pair.left.displacement = pair.right.displacement = u;
        EXPECT_LE(alone->asked.gap, gap(pair, given));
      }
      if (alone->is_least) continue;
      EXPECT_TRUE(rule.takes == CodeRule::Takes::height || rule.name == "ntc-2018" || rule.name == "nsr-10" ||
                  rule.name == "iran-2800");
    }
  }
  EXPECT_EQ(with, 37);  // eleven rules, one not of one owner, one not at a public way
}

/// Every rule, aligned or not, of one owner or two, or at a public way.
template <class Check>
void for_every_rule(const Check& check) {
  for (const CodeRule& rule : code_rules()) {
    for (const bool aligned : {false, true}) {
      for (const Boundary boundary : boundaries) {
        SCOPED_TRACE(std::string(rule.name) + (aligned ? ", aligned" : "") + ", boundary " +
                     std::to_string(static_cast<int>(boundary)));
        CodePair pair = pair_in_metres();
        pair.floors_aligned = aligned;
        pair.boundary = boundary;
        check(pair, spec(std::string(rule.name)));
      }
    }
  }
}

TEST(CodeRules, UnitsOfLengthDoNotMatter) {
  for_every_rule([](const CodePair& pair, const CodeRuleSpec& given) {
    for (const double height : {2.0, 10.0, 60.0}) {
      CodePair metres = pair;
      metres.left.height = height;
      metres.right.height = height + 5;
      CodePair feet = metres;
      feet.metre = 1 / 0.3048;
      for (CodeSide* side : {&feet.left, &feet.right}) {
        side->displacement *= feet.metre;
        side->level *= feet.metre;
        side->height *= feet.metre;
      }
      if (std::isnan(gap(metres, given))) continue;
      EXPECT_NEAR(gap(feet, given) * 0.3048, gap(metres, given), 1e-14);
    }
  });
}

TEST(CodeRules, LeftAndRightDoNotMatter) {
  for_every_rule([](const CodePair& pair, const CodeRuleSpec& given) {
    CodePair mirrored = pair;
    std::swap(mirrored.left, mirrored.right);
    CodeRuleSpec turned = given;
    for (auto& [key, values] : turned.numbers) {
      if (values.size() == 2) std::swap(values[0], values[1]);
    }
    if (std::isnan(gap(pair, given))) {
      EXPECT_TRUE(std::isnan(gap(mirrored, turned)));
      return;
    }
    EXPECT_NEAR(gap(mirrored, turned), gap(pair, given), 1e-15);
  });
}

TEST(CodeRules, MoreDisplacementNeverNeedsLess) {
  for_every_rule([](const CodePair& pair, const CodeRuleSpec& given) {
    double before = 0;
    for (double u = 0; u < 0.2; u += 0.01) {
      CodePair moved = pair;
      moved.left.displacement = u;
      if (std::isnan(gap(moved, given))) return;
      EXPECT_GE(gap(moved, given), before);
      before = gap(moved, given);
    }
  });
}

TEST(CodeRules, EachBuildingOfARowHasItsOwnNumbers) {
  CodePair pair = pair_in_metres();
  CodeRuleSpec given{.rule = "is-1893-1", .numbers = {{"response_reduction", {100.0, 5.0, 3.0}}}};
  pair.left_building = 1;
  pair.right_building = 2;
  pair.floors_aligned = true;
  EXPECT_NEAR(gap(pair, given), 5 * 0.03 + 3 * 0.04, 1e-15);
  given.numbers["response_reduction"] = {4};
  EXPECT_NEAR(gap(pair, given), 4 * 0.07, 1e-15);
}

TEST(CodeRules, AreNamedAndNothingIsMadeUp) {
  EXPECT_EQ(code_rules().size(), 21U);
  EXPECT_EQ(find_code_rule("no-such-code"), nullptr);
  for (const CodeRule& rule : code_rules()) {
    EXPECT_EQ(find_code_rule(rule.name), &rule);
    EXPECT_FALSE(rule.clause.empty());
    EXPECT_FALSE(rule.motion.empty());
    const bool is_read = rule.wording.starts_with("read");
    EXPECT_TRUE(is_read || rule.wording == "second hand, to check" || rule.wording == "by memory, to check")
        << rule.name;
    for (const Key& key : rule.keys) {
      if (!key.is_required()) continue;
      CodeRuleSpec given = spec(std::string(rule.name));
      given.numbers.erase(std::string(key.name));
      given.words.erase(std::string(key.name));
      try {
        (void)code_separation(pair_in_metres(), given);
        ADD_FAILURE() << rule.name << " does without " << key.name;
      } catch (const InvalidParameter& missing) {
        EXPECT_EQ(missing.parameter(), key.name);
      }
    }
  }
}

TEST(CodeRules, RefuseWhatCannotBe) {
  EXPECT_THROW((void)code_separation(pair_in_metres(), spec("no-such-code")), InvalidParameter);
  CodeRuleSpec given = spec("en-1998-1");
  given.numbers["behaviour_factor"] = {0};
  EXPECT_THROW((void)code_separation(pair_in_metres(), given), InvalidParameter);
  given = spec("gb-50011-2010");
  given.numbers["intensity"] = {7.5};
  EXPECT_THROW((void)code_separation(pair_in_metres(), given), InvalidParameter);
  CodePair pair = pair_in_metres();
  pair.left.displacement = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW((void)code_separation(pair, spec("nbcc")), InvalidParameter);
  EXPECT_THROW((void)height_separation(pair, spec("no-such-code")), InvalidParameter);
  EXPECT_TRUE(height_separation(pair, spec("rpa-2024"))) << "no displacement is asked for";
}

/// A building with floors at the given elevations above the datum.
Building with_floors(const std::vector<double>& elevations, double base = 0) {
  const auto floors = static_cast<Eigen::Index>(elevations.size());
  Building building =
      test::matrix_building(Eigen::MatrixXd::Identity(floors, floors), Eigen::MatrixXd::Identity(floors, floors) * 400,
                            Eigen::MatrixXd::Identity(floors, floors));
  building.model.elevations = elevations;
  building.model.storey_heights.clear();
  for (const double elevation : elevations) {
    building.model.storey_heights.push_back(elevation - base);
    base = elevation;
  }
  return building;
}

TEST(CodeRules, DependOnOwnersAndAlignmentWhereTheySayThatTheyDo) {
  for (const CodeRule& rule : code_rules()) {
    for (const bool flags : {false, true}) {
      CodeRuleSpec given = spec(std::string(rule.name));
      if (flags) given.flags = {{"halved", true}, {"structures_alike", true}};
      CodePair pair = pair_in_metres();
      pair.right.height = pair.left.height;
      pair.left.displacement = 0.3;
      pair.right.displacement = 0.4;
      const auto differs = [&](const CodePair& one, const CodePair& other) {
        const double a = gap(one, given), b = gap(other, given);
        return std::isnan(a) != std::isnan(b) || (!std::isnan(a) && std::abs(a - b) > 1e-12);
      };
      if (rule.name == "iran-2800") pair.left.storeys = pair.right.storeys = 9;
      CodePair at_line = pair, at_way = pair;
      at_line.boundary = Boundary::property_line;
      at_way.boundary = Boundary::public_way;
      EXPECT_EQ(differs(pair, at_line), depends_on_owner(given)) << rule.name;
      EXPECT_EQ(differs(at_line, at_way), rule.owner == CodeRule::Owner::not_at_public_way) << rule.name;
      EXPECT_EQ(std::isnan(gap(at_way, given)),
                rule.owner == CodeRule::Owner::not_at_public_way || rule.name == "nec-se-ds");
      CodePair aligned = pair;
      aligned.floors_aligned = true;
      EXPECT_EQ(differs(pair, aligned), depends_on_alignment(given)) << rule.name;
    }
  }
}

TEST(CodeRules, OfACaseTakeThePeaksWithoutContactAtEachLevel) {
  Problem problem = test::pair(with_floors({3, 6}), with_floors({3, 6, 9}), {}, 1);
  problem.points = {test::contact(0.1, 1.0, 0), test::contact(0.1, 1.0, 1)};
  Response response;
  response.points.resize(2);
  response.buildings.resize(2);
  response.buildings[0].displacement_no_contact = Eigen::Vector2d(0.01, 0.02);
  response.buildings[1].displacement_no_contact = Eigen::Vector3d(0.03, 0.04, 0.05);
  CodeSpec code;
  code.rules = {CodeRuleSpec{.rule = "is-1893-1", .numbers = {{"response_reduction", {2, 3}}}}, spec("ntc-2004")};
  const auto points = separations(problem, response, code, {.length = "m"});
  ASSERT_EQ(points.size(), 2U);
  ASSERT_EQ(points[0].codes.size(), 2U);
  EXPECT_EQ(points[0].codes[0].rule, "is-1893-1");
  EXPECT_NEAR(points[0].codes[0].gap, 3 * (0.01 + 0.03), 1e-15);
  EXPECT_NEAR(points[1].codes[0].gap, 3 * (0.02 + 0.04), 1e-15);
  EXPECT_NEAR(points[1].codes[1].to_left.value(), 3 * 0.02 + 0.003 * 6, 1e-15);
  code.rules[0].flags = {{"halved", true}};
  EXPECT_NEAR(separations(problem, response, code, {.length = "m"})[0].codes[0].gap, 3 * (0.01 + 0.03), 1e-15)
      << "floors are not said to be aligned";
  code.floors_aligned = std::vector<bool>{true};
  EXPECT_NEAR(separations(problem, response, code, {.length = "m"})[0].codes[0].gap, 0.5 * (2 * 0.01 + 3 * 0.03),
              1e-15);
  EXPECT_NEAR(separations(problem, response, code, {.length = "mm"})[0].codes[1].to_left.value(), 50, 1e-12);
  EXPECT_TRUE(separations(problem, response)[0].codes.empty());
}

}  // namespace
}  // namespace bentur
