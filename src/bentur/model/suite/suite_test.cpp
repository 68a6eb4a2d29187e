#include "bentur/model/suite/suite.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

#include "bentur/core/errors.h"
#include "bentur/model/suite/suite_story.h"
#include "bentur/solve/spectrum/response_spectrum.h"
#include "bentur/structure/stick.h"

namespace bentur {
namespace {

/// One floor on a spring with a period [s].
Building oscillator(const std::string& name, double period) {
  const double omega = 2 * std::numbers::pi / period;
  BuildingSpec spec;
  spec.name = name;
  spec.structure = MatricesSpec{.elevations = {3},
                                .mass = Eigen::MatrixXd::Identity(1, 1),
                                .stiffness = omega * omega * Eigen::MatrixXd::Identity(1, 1)};
  spec.damping = ModalDamping{{0.05}};
  return make_building(spec);
}

/// A swell of sines about a frequency [Hz].
SampledMotion swell(double frequency) {
  SampledMotion motion{0.01, {}};
  for (int i = 0; i < 400; ++i) {
    const double t = 0.01 * i;
    motion.acceleration.push_back(std::sin(std::numbers::pi * t / 4) * std::sin(2 * std::numbers::pi * frequency * t));
  }
  return motion;
}

const std::vector<double> frequencies = {1.5, 0.7, 2.5, 1.4, 4.0};

/// Records about several frequencies; the target is k times the spectrum of the first one's.
SuiteSpec suite_about(double k) {
  SuiteSpec suite;
  suite.request.scale = "asce-7-16";
  for (const double frequency : frequencies) {
    SuiteRecord record;
    record.motion = swell(frequency);
    record.file = suite.records.size();
    record.echo.file = std::to_string(record.file);
    suite.records.push_back(std::move(record));
  }
  // As settle() has them: 0.2 · 0.5 s to 2 · 1 s.
  TableSpectrum table;
  table.periods = logarithmic_periods(0.1, 2, static_cast<int>(std::ceil(std::log(20.0) / std::log(1.01))) + 1);
  for (const OscillatorPeaks& one : response_spectrum(suite.records[0].motion, table.periods, 0.05)) {
    table.accelerations.push_back(k * one.pseudo_acceleration);
  }
  table.periods.back() *= 1 + 1e-12;
  suite.target.spectrum.shape = std::move(table);
  return suite;
}

class Suites : public testing::Test {
 protected:
  std::vector<SuiteFault> settled(SuiteSpec& suite) {
    return settle(suite, suite_periods(std::vector<const Building*>{&left_, &right_}));
  }

 private:
  Building left_ = oscillator("left", 0.5), right_ = oscillator("right", 1);
};

TEST_F(Suites, TheRecordThatTheTargetIsMadeOf) {
  SuiteSpec suite = suite_about(2.5);
  suite.request.select = 1;
  ASSERT_TRUE(settled(suite).empty());
  ASSERT_EQ(suite.records.size(), 1U);
  EXPECT_EQ(suite.records[0].file, 0U);
  // The target is straight between its periods, which are those of the band to round-off.
  EXPECT_NEAR(suite.records[0].factor, 2.5, 1e-9);
  EXPECT_NEAR(suite.records[0].misfit, 0, 1e-9);
  EXPECT_EQ(suite.common_factor, 1);
  EXPECT_EQ(suite.files, frequencies.size());
  EXPECT_NEAR(suite.target.periods.front(), 0.1, 1e-12);
  EXPECT_NEAR(suite.target.periods.back(), 2, 1e-12);
  EXPECT_NEAR(suite.buildings.at(1).first, 1, 1e-12);
  EXPECT_FALSE(suite.buildings.at(1).second.has_value());
}

/// Factors that are alike are one.
TEST_F(Suites, SaysItsFactorsOrTheOneFactor) {
  SuiteSpec one = suite_about(2.5), all = suite_about(2.5);
  one.request.select = 1;
  ASSERT_TRUE(settled(one).empty() && settled(all).empty());
  const auto names = [](const Statement& statement) {
    std::vector<std::string> found;
    for (const StoryValue& value : statement.values) found.push_back(value.name);
    return found;
  };
  const Statement alike = suite_story(one, {}).statements.front(), apart = suite_story(all, {}).statements.front();
  EXPECT_EQ(alike.kind, "suite_alike");
  EXPECT_EQ(names(alike), (std::vector<std::string>{"records", "files", "factor", "misfit"}));
  EXPECT_EQ(apart.kind, "suite");
  EXPECT_EQ(names(apart), (std::vector<std::string>{"records", "files", "least", "most", "misfit"}));
}

TEST_F(Suites, PairsAreMeasuredAsAskedFor) {
  for (const char* const scale : {"period", "asce-7-16"}) {
    SuiteSpec suite = suite_about(1);
    suite.request.scale = scale;
    suite.request.period = 0.5;
    // A component four times the other is along one line with it: √17 times, or by the geometric mean twice.
    for (SuiteRecord& record : suite.records) {
      record.along_y = SuiteComponent{record.echo, record.motion};
      for (double& value : record.along_y->motion.acceleration) value *= 4;
    }
    SuiteSpec single = suite_about(1);
    single.request = suite.request;
    ASSERT_TRUE(settled(suite).empty());
    ASSERT_TRUE(settled(single).empty());
    const double times = pair_measure(suite.request) == PairMeasure::geometric_mean ? 2 : std::sqrt(17);
    // What maximum_direction() misses is in each spectrum and in the common factor.
    const double missed = 2 * 3.2e-4;
    for (std::size_t i = 0; i < suite.records.size(); ++i) {
      EXPECT_NEAR(suite.records[i].factor * times / single.records[i].factor, 1, missed) << scale;
      EXPECT_NEAR(suite.records[i].spectrum[7] / single.records[i].spectrum[7], 1, missed);
      EXPECT_NEAR(suite.records[i].along_y->echo.pga, 4 * suite.records[i].echo.pga, 1e-12);
    }
  }
}

TEST_F(Suites, OneOfAnEventAndThoseWithinTheBounds) {
  SuiteSpec suite = suite_about(1);
  suite.request.select = 2;
  ASSERT_TRUE(settled(suite).empty());
  EXPECT_EQ(suite.records[0].file, 0U);
  EXPECT_EQ(suite.records[1].file, 3U);  // 1.4 Hz is next to 1.5 Hz

  SuiteSpec events = suite_about(1);
  events.request.select = 2;
  events.request.per_event = 1;
  events.records[0].event = events.records[3].event = "A";
  ASSERT_TRUE(settled(events).empty());
  EXPECT_NE(events.records[1].file, 3U);

  SuiteSpec bounded = suite_about(1);
  bounded.records[3].motion.acceleration.assign(400, 0.0);
  for (std::size_t i = 0; i < 400; ++i) {
    bounded.records[3].motion.acceleration[i] = 1e-3 * suite.records[1].motion.acceleration[i];
  }
  bounded.request.select = 2;
  bounded.request.factor_bounds = std::pair(0.01, 100.0);
  ASSERT_TRUE(settled(bounded).empty());
  for (const SuiteRecord& one : bounded.records) {
    EXPECT_NE(one.file, 3U);  // its factor is a thousandfold
    EXPECT_LE(one.factor, 100);
  }
}

TEST_F(Suites, LiftsTheMeanToTheClauseAndNoFurther) {
  SuiteSpec suite = suite_about(1);
  ASSERT_TRUE(settled(suite).empty());
  ASSERT_EQ(suite.records.size(), frequencies.size());
  EXPECT_GT(suite.common_factor, 1);
  double least = INFINITY;
  for (std::size_t i = 0; i < suite.mean.size(); ++i) {
    double mean = 0;
    for (const SuiteRecord& one : suite.records) mean += one.spectrum[i] / static_cast<double>(suite.records.size());
    EXPECT_NEAR(suite.mean[i], mean, 1e-12 * mean);
    least = std::min(least, suite.mean[i] / suite.target.ordinates[i]);
  }
  EXPECT_NEAR(least, 0.9, 1e-12);
  EXPECT_EQ(suite.least_share(), least);
  EXPECT_FALSE(suite.is_below_target());
  const auto says_so = [](const SuiteSpec& of) {
    const Story story = suite_story(of, Units());
    return std::any_of(story.statements.begin(), story.statements.end(),
                       [](const Statement& one) { return one.kind == "suite_target_not_known"; });
  };
  EXPECT_FALSE(says_so(suite));
  SuiteSpec weak = suite;
  for (double& one : weak.mean) one *= 0.999;
  EXPECT_TRUE(weak.is_below_target() && says_so(weak));

  // At one period all spectra are the target.
  SuiteSpec period = suite_about(1);
  period.request.scale = "period";
  period.request.period = 0.8;
  ASSERT_TRUE(settled(period).empty());
  const double wanted = spectral_acceleration(period.target.spectrum, 0.8, 0.05);
  for (const SuiteRecord& one : period.records) {
    SampledMotion applied = one.motion;
    for (double& value : applied.acceleration) value *= one.factor;
    EXPECT_NEAR(oscillator_peaks(applied, 0.8, 0.05).pseudo_acceleration, wanted, 1e-9 * wanted);
  }
}

TEST_F(Suites, SaysWhatCannotBeHad) {
  using Kind = SuiteFault::Kind;
  const auto fault = [&](const std::function<void(SuiteSpec&)>& change) {
    SuiteSpec suite = suite_about(1);
    change(suite);
    const std::vector<SuiteFault> found = settled(suite);
    return found.empty() ? SuiteFault{.kind = Kind::no_target, .count = 99} : found.front();
  };
  const SuiteFault few = fault([](SuiteSpec& suite) { suite.request.select = 6; });
  EXPECT_EQ(few.kind, Kind::too_few);
  EXPECT_EQ(few.count, 5U);
  const SuiteFault narrow = fault([](SuiteSpec& suite) {
    suite.request.select = 4;
    suite.request.factor_bounds = std::pair(0.999, 1.001);
  });
  EXPECT_EQ(narrow.kind, Kind::too_few);
  EXPECT_GE(narrow.beyond.factor, 2U);
  EXPECT_GT(narrow.value, 0);
  const SuiteFault bound = fault([](SuiteSpec& suite) { suite.request.factor_bounds = std::pair(0.999, 1.001); });
  EXPECT_EQ(bound.kind, Kind::factor);
  const SuiteFault misfit = fault([](SuiteSpec& suite) {
    suite.records.erase(suite.records.begin());
    suite.request.largest_misfit = 0.001;
  });
  EXPECT_EQ(misfit.kind, Kind::misfit);
  EXPECT_GT(misfit.value, 0.001);
  const SuiteFault still = fault([](SuiteSpec& suite) { suite.records[2].motion.acceleration.assign(400, 0.0); });
  EXPECT_EQ(still.kind, Kind::no_amplitude);
  EXPECT_EQ(still.record, 2U);
  const SuiteFault table = fault([](SuiteSpec& suite) {
    suite.target.spectrum.shape = TableSpectrum{.periods = {0, 1.9}, .accelerations = {1, 1}};
  });
  EXPECT_EQ(table.kind, Kind::beyond_table);
  EXPECT_NEAR(table.value, 2, 1e-12);
}

TEST_F(Suites, WhatCodesTake) {
  using Measure = SuiteMeasure::Kind;
  const auto taken = [](const std::string& scale, std::size_t records) {
    SuiteSpec suite;
    suite.request.scale = scale;
    suite.records.resize(records);
    return suite_measure(suite).kind;
  };
  EXPECT_EQ(taken("en-1998-1", 7), Measure::mean);
  EXPECT_EQ(taken("en-1998-1", 6), Measure::largest);
  EXPECT_EQ(taken("en-1998-1", 3), Measure::largest);
  EXPECT_EQ(taken("en-1998-1", 2), Measure::too_few);
  EXPECT_EQ(taken("asce-7-16", 11), Measure::mean);
  EXPECT_EQ(taken("asce-7-16", 10), Measure::too_few);
}

/// By their files without folders and endings, unless two of these are alike.
TEST(Suite, RecordsAreCalledByTheirFiles) {
  std::vector<SuiteRecord> records(2);
  records[0].echo.file = "../records/A.north.AT2";
  EXPECT_EQ(records[0].name(), "../records/A.north.AT2") << "that nobody has called otherwise";
  records[0].along_y = SuiteComponent{};
  records[0].along_y->echo.file = "../records/A.east.AT2";
  records[1].echo.file = "C:lobes.csv";
  name_records(records);
  EXPECT_EQ(records[0].name(), "A.north + A.east");
  EXPECT_EQ(records[0].files(), "../records/A.north.AT2 + ../records/A.east.AT2");
  EXPECT_EQ(records[1].name(), "C:lobes");
  records[0].along_y.reset();
  records[1].echo.file = "others/A.north.csv";
  name_records(records);
  EXPECT_EQ(records[0].name(), "../records/A.north.AT2");
  EXPECT_EQ(records[1].name(), "others/A.north.csv");
}

}  // namespace
}  // namespace bentur
