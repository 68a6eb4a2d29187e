#include "bentur/model/gap/screening.h"

#include <gtest/gtest.h>

#include <map>

#include "bentur/model/case.h"

namespace bentur {
namespace {

using Verdict = ScreeningFinding::Verdict;

/// Sticks in a row, in a unit of length, given by the heights of their storeys and the mass of a floor.
Problem row_of_sticks(const std::vector<std::pair<std::vector<double>, double>>& buildings, double width) {
  Case c;
  for (const auto& [heights, mass] : buildings) {
    BuildingSpec spec;
    spec.name = std::string(1, static_cast<char>('A' + c.buildings.size()));
    spec.structure =
        Stick{heights, std::vector<double>(heights.size(), mass), std::vector<double>(heights.size(), 1e5)};
    spec.damping = ModalDamping{{0.05}};
    if (!c.buildings.empty()) {
      c.gaps.emplace_back();
      c.gaps.back().widths = {width};
    }
    c.buildings.push_back(spec);
    c.excitation.delays.push_back(0);
  }
  c.analysis.duration = 1;
  return make_problem(c);
}

std::map<std::string, ScreeningFinding> findings_of(const Problem& problem, Eigen::Index gap,
                                                    std::optional<Seismicity> level, const Units& units = {}) {
  std::map<std::string, ScreeningFinding> result;
  for (const ScreeningFinding& one : screening(problem, gap, {level}, units)) {
    result.emplace(std::string(one.rule->name), one);
  }
  return result;
}

std::vector<double> alike_storeys(int count, double height) {
  return std::vector<double>(static_cast<std::size_t>(count), height);
}

TEST(Screening, EachRuleByHand) {
  // Eight storeys of 3.2 m and five of 3.5 m: the fifth at 17.5 m is 1.5 m from 16.0 m and 1.7 m from 19.2 m.
  const Problem problem = row_of_sticks({{alike_storeys(8, 3.2), 100}, {alike_storeys(5, 3.5), 60}}, 0.1);
  const auto all = findings_of(problem, 0, Seismicity::high);
  ASSERT_EQ(all.size(), screening_rules().size() - 1);  // all but that of plans
  EXPECT_NEAR(all.at("floors-meet").value, 1.5, 1e-12);
  EXPECT_NEAR(*all.at("floors-meet").limit, 0.6096, 1e-12);
  EXPECT_EQ(all.at("floors-meet").verdict, Verdict::attention);
  EXPECT_EQ(all.at("storeys-apart").value, 3);
  EXPECT_EQ(all.at("storeys-apart").verdict, Verdict::attention);
  EXPECT_EQ(all.at("end-of-row").verdict, Verdict::not_applicable);  // two are no row
  EXPECT_NEAR(*all.at("gap-per-storey").limit, 5 * 1.5 * 0.0254, 1e-12);
  EXPECT_EQ(all.at("gap-per-storey").verdict, Verdict::attention);
  EXPECT_EQ(all.at("pounding").verdict, Verdict::attention);
  EXPECT_NEAR(all.at("gap-per-height").value, 100 * 0.1 / 17.5, 1e-12);
  EXPECT_EQ(*all.at("gap-per-height").limit, 1.5);
  EXPECT_EQ(all.at("gap-per-height").verdict, Verdict::attention);
  EXPECT_NEAR(all.at("mass-ratio").value, 800.0 / 300, 1e-12);
  EXPECT_EQ(all.at("mass-ratio").verdict, Verdict::attention);
  const auto low = findings_of(problem, 0, Seismicity::low);
  EXPECT_EQ(low.at("gap-per-storey").verdict, Verdict::fine);  // 5 · ½ in = 0.0635 m
  EXPECT_EQ(low.at("pounding").verdict, Verdict::fine);
  EXPECT_EQ(low.at("gap-per-height").verdict, Verdict::fine);  // 0.57 % of 0.25 %
}

TEST(Screening, AlikeNeighboursAreNoConcern) {
  for (const auto& [name, one] : findings_of(
           row_of_sticks({{alike_storeys(4, 3.2), 100}, {alike_storeys(4, 3.2), 90}}, 0.5), 0, Seismicity::very_high)) {
    EXPECT_NE(one.verdict, Verdict::attention) << name;
    EXPECT_NE(one.verdict, Verdict::needs_seismicity) << name;
  }
}

TEST(Screening, OnlyTheEndsOfARowOfThreeOrMore) {
  const std::pair<std::vector<double>, double> house{alike_storeys(3, 3.0), 50};
  const Problem four = row_of_sticks({house, house, house, house}, 0.1);
  EXPECT_EQ(findings_of(four, 0, {}).at("end-of-row").verdict, Verdict::attention);
  EXPECT_EQ(findings_of(four, 1, {}).at("end-of-row").verdict, Verdict::fine);
  EXPECT_EQ(findings_of(four, 2, {}).at("end-of-row").verdict, Verdict::attention);
}

TEST(Screening, WhatNeedsTheSeismicitySaysSo) {
  const auto all = findings_of(row_of_sticks({{alike_storeys(4, 3.2), 100}, {alike_storeys(4, 3.2), 90}}, 0.5), 0, {});
  for (const char* rule : {"gap-per-storey", "pounding", "gap-per-height"}) {
    EXPECT_EQ(all.at(rule).verdict, Verdict::needs_seismicity) << rule;
    EXPECT_FALSE(all.at(rule).limit) << rule;
  }
}

TEST(Screening, EveryUnitOfLengthGivesTheSameVerdicts) {
  const auto metre = findings_of(row_of_sticks({{alike_storeys(8, 3.2), 100}, {alike_storeys(5, 3.5), 60}}, 0.15), 0,
                                 Seismicity::high);
  const auto millimetre = findings_of(row_of_sticks({{alike_storeys(8, 3200), 100}, {alike_storeys(5, 3500), 60}}, 150),
                                      0, Seismicity::high, {.length = "mm"});
  for (const auto& [rule, one] : metre) {
    EXPECT_EQ(one.verdict, millimetre.at(rule).verdict) << rule;
    const double factor = one.rule->unit == "length" ? 1000 : 1;
    EXPECT_NEAR(millimetre.at(rule).value, factor * one.value, 1e-9) << rule;
  }
}

TEST(Screening, AWallIsNotScreened) {
  Case c;
  c.buildings.resize(2);
  c.buildings[0].structure = Stick{{3.0}, {10.0}, {1e4}};
  c.buildings[0].damping = ModalDamping{{0.05}};
  c.buildings[1].structure = RigidSpec{{3.0}};
  c.gaps.resize(1);
  c.gaps[0].widths = {0.1};
  c.excitation.delays = {0, 0};
  c.analysis.duration = 1;
  EXPECT_TRUE(screening(make_problem(c), 0, {}, {}).empty());
}

}  // namespace
}  // namespace bentur
