#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>

#include "bentur/io/case/case_toml.h"
#include "bentur/io/results/result_json.h"
#include "bentur/model/gap/minimum_gap.h"
#include "bentur/pounding/pounding.h"

namespace bentur {
namespace {

const std::string three_buildings = R"(
[units]
length = "cm"
force = "kN"
[[building]]
name = "A"
damping = 0.05
stick = { storey_heights = [300.0, 300.0], masses = [0.3, 0.25], stiffnesses = [400, 300] }
[[building]]
name = "B"
damping = 0.05
stick = { storey_heights = [300.0, 300.0], masses = [0.2, 0.18], stiffnesses = [600, 500] }
[[building]]
name = "C"
damping = 0.05
stick = { storey_heights = [200.0, 400.0], masses = [0.2, 0.18], stiffnesses = [600, 500] }
[[gap]]
between = ["A", "B"]
width = 2
contact = { law = "linear", stiffness = 3e4 }
[[gap]]
between = ["B", "C"]
width = 2
contact = { law = "linear", stiffness = 3e4 }
[excitation]
kind = "harmonic"
period = 0.4
displacement_amplitude = 5
[analysis]
duration = 3.0
)";

Case read_with(const std::string& code) {
  Diagnostics diagnostics;
  const std::optional<Case> c = read_case_text(three_buildings + code, "case.toml", diagnostics);
  for (const Diagnostic& one : diagnostics.errors()) ADD_FAILURE() << one.text();
  return c.value_or(Case{});
}

TEST(CaseCode, WithoutTheTableThereAreNoRules) {
  const Case c = read_with("");
  EXPECT_TRUE(c.code.rules.empty());
  EXPECT_FALSE(c.code.floors_aligned.has_value());
}

TEST(CaseCode, EveryRuleAndKey) {
  const Case c = read_with(R"(
[code]
floors_aligned = [true, false]
same_owner = false
ntc-2004 = { behaviour_factor = 2, zone = "III", structures_alike = true }
gb-50011-2010 = { intensity = 8, system = ["frame", "wall", "frame-wall"] }
tbdy-2018 = { response_reduction = 8, importance_factor = 1.5 }
nbcc = { ductility_factor = 4, overstrength_factor = 1.7, importance_factor = 1 }
is-1893-1 = { response_reduction = [5, 3, 4] }
en-1998-1 = { behaviour_factor = 3.9 }
sni-1726-2019 = { deflection_amplification = 5.5, importance_factor = 1 }
asce-7-16 = { deflection_amplification = 5.5, importance_factor = [1, 1.25, 1.5] }
nec-se-ds = {}
rpa-2024 = {}
nsr-10 = { neighbour = "differs" }
e-030-2026 = { zone_factor = 0.45, soil_factor = 1.05 }
e-030-2018 = {}
ntc-2018 = { ground_acceleration = "0.2 g", soil_factor = 1.25 }
ubc-97 = { response_reduction = 8.5 }
ntc-2020 = { behaviour_factor = 3, overstrength_factor = 2, zone = "II", base_modelled = true }
inpres-cirsoc-103 = { deflection_amplification = 5, importance_factor = 1, displacements = ["calculated", "unknown", "calculated"] }
nch-433 = { response_reduction = 6 }
iran-2800 = { deflection_amplification = 5, importance = "ordinary" }
ufc-3-310-03a = {}
nch-2369 = { importance = "critical", both_in_one_model = true }
)");
  ASSERT_EQ(c.code.rules.size(), code_rules().size());
  for (std::size_t i = 0; i < code_rules().size(); ++i) EXPECT_EQ(c.code.rules[i].rule, code_rules()[i].name);
  EXPECT_EQ(c.code.floors_aligned, (std::vector<bool>{true, false}));
  EXPECT_EQ(c.code.boundaries, (std::vector<Boundary>{Boundary::property_line, Boundary::property_line}));
  const auto of = [&](const char* rule) -> const CodeRuleSpec& {
    return *std::find_if(c.code.rules.begin(), c.code.rules.end(), [&](const auto& one) { return one.rule == rule; });
  };
  EXPECT_EQ(of("asce-7-16").numbers.at("importance_factor"), (std::vector<double>{1, 1.25, 1.5}));
  EXPECT_EQ(of("gb-50011-2010").numbers.at("intensity"), std::vector<double>{8});
  EXPECT_EQ(of("gb-50011-2010").words.at("system"), (std::vector<std::string>{"frame", "wall", "frame-wall"}));
  EXPECT_EQ(of("ntc-2004").words.at("zone"), std::vector<std::string>{"III"});
  EXPECT_TRUE(of("ntc-2004").flags.at("structures_alike"));
  EXPECT_NEAR(of("ntc-2018").numbers.at("ground_acceleration").at(0), 0.2, 1e-15);
  EXPECT_EQ(of("inpres-cirsoc-103").words.at("displacements").at(1), "unknown");
  EXPECT_TRUE(of("ntc-2020").flags.at("base_modelled"));
  EXPECT_EQ(of("nsr-10").words.at("neighbour"), std::vector<std::string>{"differs"});
}

TEST(CaseCode, ALineAtAPublicWayAsksForNothingWhereTheClauseSaysSo) {
  const std::string rule = "asce-7-16 = { deflection_amplification = 1, importance_factor = 1 }\nrpa-2024 = {}\n";
  const Case c = read_with("\n[code]\nsame_owner = [\"public-way\", true]\n" + rule);
  EXPECT_EQ(c.code.boundaries, (std::vector<Boundary>{Boundary::public_way, Boundary::one_owner}));
  const Problem problem = make_problem(c);
  const Response response = solve(problem, ExactSolver{}, solve_options(c));
  const auto all = separations(problem, response, c.code, c.units);
  for (const LevelSeparation& one : all) {
    EXPECT_EQ(std::isnan(one.codes[0].gap), one.level.gap == 0);
    EXPECT_FALSE(std::isnan(one.codes[1].gap)) << "of a public way Algeria's says nothing apart";
  }
  const auto found = rule_findings(problem, of_gap(all, 0), c.code, 0, false, false);
  EXPECT_EQ(found.at(3).silence, RuleFinding::Silence::public_way);
  EXPECT_EQ(found.at(4).silence, RuleFinding::Silence::none);
  const auto json = nlohmann::json::parse(gap_json(run_results(c, problem, response), "1"));
  EXPECT_TRUE(json["gaps"][0]["codes"][0]["gap"].is_null());
  Diagnostics wrong;
  EXPECT_FALSE(read_case_text(three_buildings + "\n[code]\nsame_owner = \"street\"\n" + rule, "c.toml", wrong));
  ASSERT_EQ(wrong.errors().size(), 1U);
  EXPECT_NE(wrong.errors()[0].text().find("public-way"), std::string::npos);
  Diagnostics number;
  EXPECT_FALSE(read_case_text(three_buildings + "\n[code]\nsame_owner = [1, true]\n" + rule, "c.toml", number));
  ASSERT_EQ(number.errors().size(), 1U);
  EXPECT_NE(number.errors()[0].text().find("must be true, false or \"public-way\""), std::string::npos);
}

TEST(CaseCode, NothingIsHalvedUnlessTheCaseAsksForIt) {
  const auto asked = [](const std::string& code) {
    const Case c = read_with("\n[code]\n" + code);
    const Problem problem = make_problem(c);
    auto points = separations(problem, solve(problem, ExactSolver{}, solve_options(c)), c.code, c.units);
    std::erase_if(points, [](const LevelSeparation& one) { return !one.level.is_point; });
    std::vector<double> shares;
    for (const LevelSeparation& one : points) shares.push_back(one.codes[0].gap / one.abs);
    return shares;
  };
  const std::string whole = "is-1893-1 = { response_reduction = 1 }\n";
  const std::string half = "is-1893-1 = { response_reduction = 1, halved = true }\n";
  for (const std::string& code : {whole, half, "floors_aligned = true\n" + whole}) {
    const std::vector<double> shares = asked(code);
    ASSERT_EQ(shares.size(), 3U);  // two between A and B, the roofs of B and C
    for (const double share : shares) EXPECT_NEAR(share, 1, 1e-12) << code;
  }
  const std::vector<double> shares = asked("floors_aligned = [true, false]\n" + half);
  EXPECT_NEAR(shares.at(0), 0.5, 1e-12);
  EXPECT_NEAR(shares.at(1), 0.5, 1e-12);
  EXPECT_NEAR(shares.at(2), 1, 1e-12);
}

TEST(CaseCode, JsonHasEachRuleWithClauseAndWording) {
  const Case c = read_with(
      "\n[code]\nnbcc = { ductility_factor = 4, overstrength_factor = 1.7, importance_factor = 1 }\n"
      "ntc-2004 = { behaviour_factor = 2, zone = \"I\" }\n");
  const Problem problem = make_problem(c);
  const Response response = solve(problem, ExactSolver{}, solve_options(c));
  const auto json = nlohmann::json::parse(gap_json(run_results(c, problem, response), "1"));
  EXPECT_EQ(json["code_rules"][0]["rule"], "nbcc");
  EXPECT_EQ(json["code_rules"][0]["clause"], "4.1.8.14");
  EXPECT_EQ(json["code_rules"][0]["motion"], "design earthquake");
  EXPECT_EQ(json["code_rules"][1]["wording"], "read; Q to check");
  const auto& gap = json["gaps"][0];
  EXPECT_TRUE(gap["codes"][0]["to_property_line"][0].is_null());
  const double roof = gap["points"][1]["codes"][1]["gap"], first = gap["points"][0]["codes"][1]["gap"];
  EXPECT_EQ(gap["codes"][1]["gap"], std::max(roof, first));
  const double left = gap["codes"][1]["to_property_line"][0], right = gap["codes"][1]["to_property_line"][1];
  EXPECT_NEAR(left + right, roof, 1e-12);
}

}  // namespace
}  // namespace bentur
