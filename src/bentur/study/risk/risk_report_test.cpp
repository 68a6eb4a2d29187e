#include "bentur/study/risk/risk_report.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "bentur/study/design/distribution.h"

namespace bentur {
namespace {

HazardCurve hazard(const std::string& unit, double per_g) {
  HazardCurve curve;
  for (int i = 0; i < 30; ++i) {
    const double x = 0.005 * std::pow(1.3, i);
    curve.intensity.push_back(x * per_g);
    curve.rate.push_back(1e-4 * std::pow(x, -2.0));
  }
  curve.unit = unit;
  return curve;
}

/// Records of which number r has the event from level 0.1 · 1.1^r g on, and needs a gap of 0.1 m per g of what it gets.
IdaResults results(std::size_t records, std::size_t cases = 1) {
  IdaResults made;
  made.intensity = "spectral acceleration, period 0.5 s, damping 5 %";
  made.study_unit = made.units = "g";
  made.quantity_units = "m";
  made.table.cases = cases;
  made.table.records = records;
  for (int i = 1; i <= 50; ++i) made.table.levels.push_back(0.02 * i);  // so close that shares follow the curve
  for (std::size_t c = 0; c < cases; ++c) {
    for (std::size_t r = 0; r < records; ++r) {
      for (const double level : made.table.levels) {
        const double own = level / std::pow(1.1, static_cast<double>(r));
        made.table.outcomes.push_back(own >= 0.1 * static_cast<double>(c + 1) ? Outcome::event : Outcome::no_event);
        made.table.demands.push_back(0.1 * own);
        made.table.collapsed.push_back(0);
      }
    }
  }
  for (std::size_t r = 0; r < records; ++r) made.records.push_back("record " + std::to_string(r + 1));
  return made;
}

RiskReport reported(const IdaResults& of, const RiskRequest& request, HazardCurve curve = hazard("g", 1)) {
  std::string error;
  const auto report = risk_report(of, of, std::move(curve), request, error);
  EXPECT_TRUE(report) << error;
  return report.value_or(RiskReport());
}

RiskRequest request(std::optional<double> target = {}) {
  RiskRequest made;
  made.bootstrap.resamples = 50;
  made.target = target;
  return made;
}

TEST(RiskReport, OfAFittedCurveIsItsLognormalOnTheHazard) {
  const RiskReport report = reported(results(10), request());
  ASSERT_EQ(report.cases.size(), 1U);
  const CaseRisk& risk = report.cases[0];
  ASSERT_TRUE(risk.is_lognormal());
  EXPECT_EQ(risk.told().rate,
            annual_rate(report.hazard, risk.fragility.fit.median, risk.fragility.fit.dispersion).rate);
  EXPECT_NEAR(risk.told().rate / *risk.closed_form, 1, 2e-3);  // k = 2 throughout, both ends far away
  EXPECT_NEAR(risk.told().rate / risk.observed.rate, 1, 0.15);
  ASSERT_TRUE(risk.bounds);
  EXPECT_LT(risk.bounds->lower, risk.told().rate);
  EXPECT_GT(risk.bounds->upper, risk.told().rate);
}

/// Where nothing was run the curve alone says what the rate is.
TEST(RiskReport, SaysHowMuchIsAboveAllThatWasRun) {
  const auto is_said = [](double last) {
    IdaResults of = results(10);
    const IdaResults all = of;
    const auto count = static_cast<std::size_t>(
        std::count_if(all.table.levels.begin(), all.table.levels.end(), [&](double level) { return level <= last; }));
    of.table.levels.resize(count);
    of.table.outcomes.clear();
    of.table.demands.clear();
    of.table.collapsed.assign(10 * count, 0);
    for (std::size_t record = 0; record < 10; ++record) {
      for (std::size_t level = 0; level < count; ++level) {
        of.table.outcomes.push_back(all.table.at(0, record, level));
        of.table.demands.push_back(all.table.demands[record * all.table.levels.size() + level]);
      }
    }
    const RiskReport report = reported(of, request());
    EXPECT_TRUE(report.cases.at(0).is_lognormal());
    const std::vector<Statement> told = risk_story(report, request()).statements;
    return std::any_of(told.begin(), told.end(), [](const Statement& one) { return one.kind == "risk_above"; });
  };
  EXPECT_TRUE(is_said(0.15));
  EXPECT_FALSE(is_said(1.0));  // where one in 40 of such motions is
}

TEST(RiskReport, RecordsSumUpToTheObservedRate) {
  const RiskReport report = reported(results(10), request());
  double sum = 0;
  for (const double one : report.cases[0].of_records) sum += one;
  EXPECT_NEAR(sum / report.cases[0].observed.rate, 1, 1e-12);
  for (std::size_t r = 1; r < 10; ++r) {  // the first needs the least
    EXPECT_LE(report.cases[0].of_records[r], report.cases[0].of_records[r - 1]);
  }
}

TEST(RiskReport, UnitsOfTheHazardAreThoseOfTheLevels) {
  const double expected = reported(results(10), request()).cases[0].told().rate;
  EXPECT_NEAR(reported(results(10), request(), hazard("cm/s2", 980.665)).cases[0].told().rate / expected, 1, 1e-12);
  EXPECT_NEAR(reported(results(10), request(), hazard("", 1)).cases[0].told().rate / expected, 1, 1e-12);
}

TEST(RiskReport, WhatDoesNotGoTogetherIsRefused) {
  std::string error;
  HazardCurve other = hazard("g", 1);
  other.measure = "PGA";
  EXPECT_FALSE(risk_report(results(3), {}, other, request(), error));
  EXPECT_EQ(error, "is of PGA, but the runs are by levels of SA(0.5)");
  other.measure = "SA(0.50)";
  EXPECT_TRUE(risk_report(results(3), {}, other, request(), error));
  other.measure = "SA";  // of a table whose heading says no period
  EXPECT_TRUE(risk_report(results(3), {}, other, request(), error));
  RiskRequest cloud = request();
  cloud.method = FragilityMethod::cloud;
  EXPECT_FALSE(risk_report(results(3), {}, hazard("g", 1), cloud, error));
}

/// Runs whose demand scatters about 0.1 m per g, and of which more and more collapse.
IdaResults collapsing(double half, bool is_separated) {
  IdaResults made = results(10);
  for (std::size_t r = 0; r < 10; ++r) {
    for (std::size_t i = 0; i < 50; ++i) {
      const std::size_t run = r * 50 + i;
      const double x = made.table.levels[i];
      // of neighbouring levels as many records collapse as a logistic curve says, others each time
      const double due = is_separated ? (x > half ? 10 : 0) : 10 / (1 + std::pow(x / half, -4.0));
      const bool gone = static_cast<double>((7 * r + 3 * i) % 10) + 0.5 < due;
      made.table.collapsed[run] = gone ? 1 : 0;
      made.table.outcomes[run] = gone || made.table.demands[run] > 0.05 ? Outcome::event : Outcome::no_event;
    }
  }
  made.table.threshold = 0.05;
  return made;
}

RiskRequest cloud_request() {
  RiskRequest made = request();
  made.event = "gap_needed > 0.05";
  made.method = FragilityMethod::cloud;
  return made;
}

TEST(RiskReport, OfACloudCountsCollapseApart) {
  const RiskReport report = reported(collapsing(0.8, false), cloud_request());
  const CaseRisk& risk = report.cases[0];
  const Fragility& fit = risk.fragility.fit;
  ASSERT_TRUE(fit.collapse);
  ASSERT_TRUE(risk.is_lognormal());
  EXPECT_NEAR(fit.collapse->intensity_of(0.5), 0.8, 0.05);
  EXPECT_NEAR(fit.collapse->slope, 4, 0.5);
  EXPECT_EQ(risk.told().rate, annual_rate(report.hazard, fit.median, fit.dispersion, *fit.collapse).rate);
  EXPECT_GT(risk.told().rate, annual_rate(report.hazard, fit.median, fit.dispersion).rate);
  EXPECT_NEAR(risk.told().rate / risk.observed.rate, 1, 0.15);
  EXPECT_FALSE(risk.closed_form);  // it is of one lognormal
  ASSERT_TRUE(risk.bounds);
  EXPECT_LT(risk.bounds->lower, risk.told().rate);
  EXPECT_GT(risk.bounds->upper, risk.told().rate);
  const Story story = risk_story(report, cloud_request());
  EXPECT_EQ(story.statements.at(1).kind, "risk_cloud");
  // With collapses that come later, the rate goes to that of the runs that stand.
  const CaseRisk later = reported(collapsing(3, false), cloud_request()).cases[0];
  EXPECT_LT(later.told().rate, risk.told().rate);
}

TEST(RiskReport, OfACloudWhoseCollapsesAreSeparatedIsTheObservedRate) {
  const RiskReport report = reported(collapsing(0.5, true), cloud_request());
  const CaseRisk& risk = report.cases[0];
  EXPECT_EQ(risk.fragility.fit.kind, Fragility::Kind::fitted);  // of the runs that stand
  EXPECT_FALSE(risk.lognormal);
  EXPECT_EQ(risk.told().rate, risk.observed.rate);
  EXPECT_EQ(risk_story(report, cloud_request()).statements.at(1).kind, "risk_collapse_separated");
  EXPECT_FALSE(risk.fragility.probability(0.3));
}

TEST(RiskReport, TheGapForATargetIsTheSmallestThatKeepsIt) {
  const IdaResults of = results(10);
  double before = std::numeric_limits<double>::infinity();
  for (const double target : {0.05, 0.1, 0.2, 0.4}) {
    const RiskReport report = reported(of, request(target));
    ASSERT_EQ(report.gaps.size(), 1U);
    const TargetGap& gap = report.gaps[0];
    ASSERT_TRUE(gap.width) << target;
    EXPECT_LE(gap.rate, rate_of_probability(50, target));
    EXPECT_LE(*gap.width, before);
    before = *gap.width;
    // Of the next smaller need of a run, the rate is larger than the target: found by trying all.
    double next = 0;
    for (const double need : of.table.demands) {
      if (need < *gap.width * (1 - 1e-12)) next = std::max(next, need);
    }
    IdaResults less = of;
    for (std::size_t run = 0; run < less.table.outcomes.size(); ++run) {
      less.table.outcomes[run] = less.table.demands[run] > next ? Outcome::event : Outcome::no_event;
    }
    EXPECT_GT(reported(less, request()).cases[0].told().rate, rate_of_probability(50, target));
  }
  const RiskReport none = reported(of, request(1e-4));
  EXPECT_FALSE(none.gaps[0].width);  // what is beyond the highest level alone is more often
}

TEST(RiskReport, AGapForATargetIsToldOnceForThoseWhoNeedTheSame) {
  IdaResults of = results(10, 6);
  of.axes = {{"law", 2, {{"law", "", "", {}, {"linear", "hertz"}}}},
             {"factor", 3, {{"factor", "", "", {1, 2, 3}, {}}}}};  // of a width, say
  const RiskReport once = reported(of, request(0.1));
  ASSERT_EQ(once.gaps.size(), 1U);
  EXPECT_EQ(risk_story(once, request(0.1)).statements.back().subject, "");
  const std::size_t runs = of.table.records * of.table.levels.size();
  for (std::size_t run = 3 * runs; run < 6 * runs; ++run) of.table.demands[run] *= 2;
  const RiskReport each = reported(of, request(0.1));
  ASSERT_EQ(each.gaps.size(), 2U);
  EXPECT_NEAR(*each.gaps[1].width, 2 * *each.gaps[0].width, 1e-12);
  EXPECT_EQ(risk_story(each, request(0.1)).statements.back().subject, "law = hertz");
  of.table.collapsed[4 * runs] = 1;
  EXPECT_EQ(reported(of, request(0.1)).gaps.size(), 6U);
}

TEST(RiskReport, WithoutEventsNothingIsBelowWhatIsBeyondTheLevels) {
  IdaResults of = results(4);
  for (Outcome& one : of.table.outcomes) one = Outcome::no_event;
  const RiskReport report = reported(of, request());
  EXPECT_FALSE(report.cases[0].is_lognormal());
  EXPECT_NEAR(report.cases[0].told().rate, 1e-4, 1e-12);  // λ of the highest level, 1 g
  EXPECT_NEAR(report.cases[0].told().beyond, 1e-4, 1e-12);
}

TEST(RiskReport, SaysHowWellTheCurveDescribesTheRuns) {
  const RiskRequest asked = request();
  const RiskReport report = reported(results(10), asked);
  const CaseRisk& risk = report.cases.at(0);
  // By hand: the largest distance of the shares at the levels from the lognormal.
  double largest = 0;
  for (const IntensityCount& one : risk.fragility.counts) {
    const double share = static_cast<double>(one.events) / static_cast<double>(one.runs);
    const Fragility& fit = risk.fragility.fit;
    const double p = normal_probability(std::log(one.intensity / fit.median) / fit.dispersion);
    largest = std::max(largest, std::abs(share - p));
  }
  const auto json = nlohmann::json::parse(risk_json(report, asked, "0"));
  EXPECT_NEAR(json.at("cases")[0].at("distance").get<double>(), largest, 1e-12);
  int told = 0;
  for (const Statement& one : risk_story(report, asked).statements) {
    for (const StoryValue& value : one.values) told += value.name == "distance" ? 1 : 0;
  }
  EXPECT_EQ(told, 1);
}

TEST(RiskReport, OfACloudItIsTheFittedCurveAndBesideItTheSharesThatRise) {
  IdaResults cloud;
  cloud.intensity = "spectral acceleration, period 0.5 s, damping 5 %";
  cloud.study_unit = cloud.units = "g";
  cloud.table = {.levels = {std::nan("")}, .cases = 1, .records = 400, .outcomes = {}};
  // Records as close as the shares are to follow the curve: at each intensity the event where a quantile is exceeded.
  for (std::size_t r = 0; r < 400; ++r) {
    const double x = 0.05 * std::pow(40.0, static_cast<double>(r) / 399);
    const double u = static_cast<double>((r * 157) % 400 + 1) / 401;  // every 401st part once, in no order
    cloud.table.own.push_back(x);
    const double capacity = 0.3 * std::exp(0.5 * normal_quantile(u));
    cloud.table.demands.push_back(x / capacity);
    cloud.table.collapsed.push_back(0);
    cloud.table.outcomes.push_back(x > capacity ? Outcome::event : Outcome::no_event);
    cloud.records.push_back("record " + std::to_string(r + 1));
  }
  cloud.table.threshold = 1;
  for (const FragilityMethod method : {FragilityMethod::likelihood, FragilityMethod::cloud}) {
    RiskRequest asked = request();
    asked.method = method;
    asked.event = "demand > 1";
    const CaseRisk risk = reported(cloud, asked).cases.at(0);
    ASSERT_TRUE(risk.is_lognormal());
    const Fragility& fit = risk.fragility.fit;
    EXPECT_EQ(risk.told().rate, annual_rate(hazard("g", 1), fit.median, fit.dispersion).rate);
    EXPECT_NEAR(fit.median, 0.3, 0.03);
    EXPECT_NEAR(risk.observed.rate, risk.told().rate, 0.2 * risk.told().rate);
    EXPECT_TRUE(risk.of_records.empty());  // no record has runs at other intensities
  }
}

std::vector<std::string> kinds_of(const RiskReport& report, const RiskRequest& asked) {
  std::vector<std::string> kinds;
  for (const Statement& one : risk_story(report, asked).statements) kinds.push_back(one.kind);
  return kinds;
}

bool says(const std::vector<std::string>& kinds, const std::string& kind) {
  return std::find(kinds.begin(), kinds.end(), kind) != kinds.end();
}

/// Of runs that make no case, or of which it is not known what they need, nothing is bounded.
TEST(RiskReport, RunsThatTellNothingBoundNothing) {
  const RiskRequest asked = request(0.1);
  IdaResults quiet = results(3);
  for (Outcome& one : quiet.table.outcomes) one = Outcome::no_event;
  for (double& one : quiet.table.demands) one *= 1e-3;
  const RiskReport known = reported(quiet, asked);
  EXPECT_TRUE(says(kinds_of(known, asked), "risk_no_pounding"));
  EXPECT_TRUE(known.gaps.at(0).is_known());

  IdaResults failed = quiet;
  for (Outcome& one : failed.table.outcomes) one = Outcome::failed;
  const RiskReport nothing = reported(failed, asked);
  EXPECT_TRUE(says(kinds_of(nothing, asked), "risk_nothing"));
  EXPECT_TRUE(says(kinds_of(nothing, asked), "risk_gap_nothing"));

  IdaResults part = quiet;
  part.table.outcomes.front() = Outcome::failed;
  IdaResults open = quiet;
  open.open.runs = 1;
  for (const IdaResults* const of : {&failed, &part, &open}) {
    const RiskReport report = reported(*of, asked);
    const std::vector<std::string> kinds = kinds_of(report, asked);
    EXPECT_FALSE(says(kinds, "risk_no_pounding"));
    EXPECT_FALSE(says(kinds, "risk_gap"));
    const auto json = nlohmann::json::parse(risk_json(report, asked, "0"));
    EXPECT_TRUE(json.at("cases")[0].at("rate").is_null());
    EXPECT_TRUE(json.at("cases")[0].at("probability").is_null());
    EXPECT_TRUE(json.at("gaps")[0].at("gap").is_null());
  }
  EXPECT_TRUE(says(kinds_of(reported(part, asked), asked), "risk_gap_open"));

  IdaResults some = results(10);  // a rate that is of the others alone
  some.table.outcomes.front() = Outcome::failed;
  const std::vector<std::string> kinds = kinds_of(reported(some, asked), asked);
  EXPECT_TRUE(says(kinds, "risk_of_others"));
  EXPECT_TRUE(says(kinds, "risk_pounding"));
}

}  // namespace
}  // namespace bentur
