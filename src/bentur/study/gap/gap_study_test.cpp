#include "bentur/study/gap/gap_study.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <variant>
#include <vector>

#include "bentur/io/temporary_folder.h"
#include "bentur/model/judgement/open_needs.h"
#include "bentur/study/gap/gap_study_story.h"
#include "bentur/study/quantiles.h"

namespace bentur {
namespace {

namespace fs = std::filesystem;

const std::string gap_tests = (fs::path(BENTUR_SOURCE_DIR) / "tests").string();

std::optional<GapStudy> needs_of(const std::string& text, std::optional<double> at = std::nullopt) {
  const TemporaryFolder folder;
  const fs::path file = folder.path() / "study.toml";
  std::ofstream(file) << "case = '" << gap_tests << "/bad_study/plain-case.toml'\n" << text;
  Diagnostics diagnostics;
  auto result = gap_study(
      file, at, [](double) { return true; }, diagnostics);
  for (const Diagnostic& one : diagnostics.errors()) ADD_FAILURE() << one.text();
  return result;
}

std::vector<double> gap_needed(const RecordNeeds& needs) {
  std::vector<double> result;
  for (const RecordNeed& record : needs.records) result.push_back(record.gaps[0].gap_needed);
  return result;
}

TEST(GapStudies, NoGapIsWideEnoughWhereABuildingDriftsAsFarAsCollapse) {
  const GapStudy of =
      needs_of("[[vary]]\nparameter = 'analysis.collapse_drift'\nname = 'limit'\nvalues = [10, 1e-12]\n").value();
  ASSERT_EQ(of.needs.size(), 2U);
  EXPECT_FALSE(of.needs[0].records.at(0).falls);
  EXPECT_TRUE(std::isfinite(gap_needed(of.needs[0])[0]));
  EXPECT_TRUE(of.needs[1].records.at(0).falls);
  EXPECT_TRUE(std::isinf(gap_needed(of.needs[1])[0]));
  EXPECT_EQ(of.needs[1].gaps.at(0).given.at(0).beyond, 1U);
}

/// The buildings are in doubt by themselves; cut before its peak the record could need more, if not more than is given.
TEST(GapStudies, CountWhatKeepsNeedsFromBeingKnown) {
  const GapStudy of =
      needs_of("[[vary]]\nparameter = 'analysis.duration'\nname = 'duration'\nvalues = [0.05]\n").value();
  const GivenGap& cut = of.needs.at(0).gaps.at(0).given.at(0);
  EXPECT_EQ(cut.beyond, 0U);
  EXPECT_EQ(cut.open.runs, 1);
  EXPECT_EQ(needs_of("[[vary]]\nparameter = 'building[0].damping'\nvalues = [0.05]\n")->needs.at(0).records.at(0).open,
            static_cast<std::uint64_t>(OpenNeed::doubt));
  const std::vector<Statement> told = gap_study_story(of).statements;
  const auto said =
      std::find_if(told.begin(), told.end(), [](const Statement& one) { return one.kind.ends_with("s_short_open"); });
  ASSERT_NE(said, told.end());
  ASSERT_EQ(said->items.size(), 1U);
  EXPECT_EQ(std::get<std::string>(said->items[0].at(0).value), "story.open_need.doubt");
  const auto json = nlohmann::json::parse(gap_study_json(of, "0")).at("studied");
  EXPECT_EQ(json[0].at("gaps")[0].at("given")[0].at("records_open"), 1);
  EXPECT_EQ(json[0].at("gaps")[0].at("records")[0].at("open_needs"), nlohmann::json::array({"doubt"}));
}

/// What may still come is bounded: a width below the bound leaves it open, one above it does not.
TEST(GapStudies, HoldWhatIsToComeAgainstEachWidth) {
  const GapStudy of = needs_of(
                          "[[vary]]\nparameter = 'analysis.duration'\nname = 'duration'\nvalues = [0.05]\n"
                          "[[vary]]\nparameter = 'gap[0].width'\nvalues = [1e-5, 0.02]\n")
                          .value();
  const RecordNeed& record = of.needs.at(0).records.at(0);
  for (std::size_t i = 0; i < record.to_come.size(); ++i) {
    EXPECT_LT(record.separations.at(i).gap_needed, 1e-5);
    EXPECT_GT(record.to_come[i], 1e-5);
    EXPECT_LT(record.to_come[i], 0.02);
  }
  const std::vector<GivenGap>& given = of.needs[0].gaps.at(0).given;
  ASSERT_EQ(given.size(), 2U);
  const auto keys = open_need_keys();
  const auto motion_left = static_cast<std::size_t>(std::find(keys.begin(), keys.end(), "motion_left") - keys.begin());
  EXPECT_EQ(given[0].open.in.at(motion_left), 1);
  EXPECT_EQ(given[1].open.in.at(motion_left), 0);
}

TEST(GapStudies, QuantilesAndTheShareThatNeedsMoreThanGiven) {
  // The need is in proportion to the factor on the record: 1 to 5 times the first one's.
  const std::string scales =
      "[[vary]]\nparameter = 'excitation'\nname = 'record'\nlabels = ['a', 'b', 'c', 'd', 'e']\nvalues = [";
  std::string values;
  for (int i = 1; i <= 5; ++i) {
    values += "{ kind = 'record', file = '../bad_input/good.AT2', scale = " + std::to_string(i) + ".0 },";
  }
  const GapStudy one = needs_of(scales + values + "]\n").value();
  const std::vector<double> all = gap_needed(one.needs.at(0));
  ASSERT_EQ(all.size(), 5U);
  ASSERT_GT(all[0], 0);
  for (std::size_t i = 0; i < 5; ++i) EXPECT_NEAR(all[i] / all[0], static_cast<double>(i + 1), 1e-9);
  const GapOverRecords& over = one.needs[0].gaps.at(0);
  EXPECT_EQ(over.largest.gap_needed, all[4]);
  EXPECT_EQ(over.median.gap_needed, all[2]);
  std::vector<double> told;
  for (const GapQuantile& quantile : over.quantiles) {
    told.push_back(quantile.probability);
    EXPECT_DOUBLE_EQ(quantile.need.gap_needed, quantile_of(all, quantile.probability));
    EXPECT_GT(quantile.need.abs, 0);
  }
  EXPECT_EQ(told, (std::vector<double>{0.16, 0.5, 0.84, 0.9, 0.95}));
  ASSERT_EQ(over.given.size(), 1U);
  EXPECT_EQ(over.given[0].widths, (std::vector<double>{0.02, 0.02}));
  EXPECT_EQ(over.given[0].beyond,
            static_cast<std::size_t>(std::count_if(all.begin(), all.end(), [](double x) { return x > 0.02; })));

  // Widths between the second need and the third, and between the fourth and the fifth.
  const std::string widths = "[[vary]]\nparameter = 'gap[0].width'\nvalues = [" + std::to_string(2.5 * all[0]) + ", " +
                             std::to_string(4.5 * all[0]) + "]\n";
  const GapStudy two = needs_of(scales + values + "]\n" + widths).value();
  EXPECT_EQ(gap_needed(two.needs.at(0)), all);
  const std::vector<GivenGap>& given = two.needs[0].gaps[0].given;
  ASSERT_EQ(given.size(), 2U);
  EXPECT_EQ(given[0].beyond, 3U);
  EXPECT_EQ(given[1].beyond, 1U);
  EXPECT_EQ(given[0].others.at(0).first, "width");

  const auto json = nlohmann::json::parse(gap_study_json(two, "0")).at("studied")[0].at("gaps")[0];
  EXPECT_EQ(json.at("given")[0].at("records_beyond"), 3);
  EXPECT_DOUBLE_EQ(json.at("given")[0].at("share_beyond"), 0.6);
  EXPECT_EQ(json.at("quantiles")[2].at("probability"), 0.84);
  EXPECT_DOUBLE_EQ(json.at("quantiles")[2].at("gap_needed"), quantile_of(all, 0.84));
}

/// What varies is one record with two choices: they are runs, not records.
TEST(GapStudies, ChoicesAreNotCalledRecords) {
  const auto kind_of = [](const std::string& varied) {
    const GapStudy study = needs_of(varied).value();
    for (const Statement& one : gap_study_story(study).statements) {
      if (one.kind.starts_with("gaps_over")) return one.kind + " of " + one.values.front().name;
    }
    return std::string();
  };
  EXPECT_EQ(kind_of("[[vary]]\nparameter = 'building[0].damping'\nvalues = [0.02, 0.05]\n"),
            "gaps_over_few_runs of runs");
  const std::string record = "{ kind = 'record', file = '../bad_input/good.AT2', scale = ";
  EXPECT_EQ(kind_of("[[vary]]\nparameter = 'excitation'\nname = 'record'\nlabels = ['a', 'b']\nvalues = [" + record +
                    "1.0 }, " + record + "2.0 }]\n"),
            "gaps_over_few of records");
}

TEST(GapStudies, TheMirroredRecordIsARecordOfItsOwn) {
  const std::string records = "[[vary]]\nparameter = 'excitation.file'\nfiles = ['" + gap_tests +
                              "/bad_input/good.AT2', {file = '" + gap_tests +
                              "/bad_input/good-two-column.txt', unit = 'm/s2'}]\n";
  const std::string ida = "[ida]\nintensity = 'pga'\nunit = 'm/s2'\nlevels = [1.0]\n";
  const std::vector<double> one_way = gap_needed(needs_of(records + ida).value().needs.at(0));
  const GapStudy study = needs_of(records + ida + "polarity = 'both'\n").value();
  EXPECT_TRUE(needs_of(records + ida).value().is_one_way);
  EXPECT_TRUE(needs_of(records + ida + "polarity = 'reversed'\n").value().is_one_way);
  EXPECT_FALSE(study.is_one_way);
  ASSERT_EQ(study.needs.size(), 1U);
  const std::vector<double> both = gap_needed(study.needs[0]);
  ASSERT_EQ(both.size(), 4U);
  EXPECT_EQ(study.needs[0].records[1].record, "good.AT2, reversed");
  EXPECT_EQ(both[0], one_way[0]);
  EXPECT_EQ(both[2], one_way[1]);
  EXPECT_GT(std::abs(both[1] / both[0] - 1), 1e-3);  // the other way round the needs are others
  // A reversed record is the same as a negative factor.
  const GapStudy reversed = needs_of(
                                "[[vary]]\nparameter = 'excitation'\nname = 'record'\nlabels = ['a', 'b']\n"
                                "values = [{ kind = 'record', file = '../bad_input/good.AT2', scale = -1 }, "
                                "{ kind = 'record', file = '../bad_input/good.AT2', polarity = 'reversed' }]\n")
                                .value();
  const std::vector<double> turned = gap_needed(reversed.needs.at(0));
  EXPECT_EQ(turned.at(0), turned.at(1));
}

TEST(GapStudies, ACloudSaysTheIntensityOfEachRecord) {
  const std::string records = "[[vary]]\nparameter = 'excitation.file'\nfiles = ['" + gap_tests +
                              "/bad_input/good.AT2', {file = '" + gap_tests +
                              "/bad_input/good-two-column.txt', unit = 'm/s2'}]\n";
  const GapStudy plain = needs_of(records).value();
  const GapStudy cloud = needs_of(records + "[ida]\nintensity = 'pga'\nunit = 'g'\nlevels = 'unscaled'\n").value();
  EXPECT_EQ(gap_needed(cloud.needs.at(0)), gap_needed(plain.needs.at(0)));
  EXPECT_FALSE(cloud.at.has_value());
  EXPECT_FALSE(plain.needs[0].records[0].intensity.has_value());
  EXPECT_NEAR(cloud.needs[0].records[0].intensity.value(), 0.06, 1e-15);
  EXPECT_NEAR(cloud.needs[0].records[1].intensity.value(), 0.03 / 9.80665, 1e-15);
  const auto json = nlohmann::json::parse(gap_study_json(cloud, "0"));
  EXPECT_TRUE(json.at("intensity").at("value").is_null());
  EXPECT_EQ(json.at("intensity").at("unit"), "g");
  EXPECT_EQ(json.at("studied")[0].at("gaps")[0].at("records")[0].at("intensity"), cloud.needs[0].records[0].intensity);
  const StoryTable table = gap_study_story(cloud).tables.at(0);
  ASSERT_EQ(table.columns.at(1).label, "column.intensity");
  EXPECT_EQ(table.columns[1].numbers.at(0), *cloud.needs[0].records[0].intensity);
  EXPECT_EQ(table.columns[1].numbers.size(), table.columns[0].texts.size());
}

TEST(GapStudies, SamplesAreRecordsEachWithABuildingOfItsOwn) {
  const std::string records = "[[vary]]\nparameter = 'excitation.file'\nname = 'record'\nfiles = ['" + gap_tests +
                              "/bad_input/good.AT2', {file = '" + gap_tests +
                              "/bad_input/good-two-column.txt', unit = 'm/s2'}]\n";
  const std::string softer =
      "[[vary]]\nparameter = 'excitation.scale'\ndistribution = { lognormal = { median = 1.0, "
      "cov = 0.3 } }\n";
  const GapStudy plain = needs_of(records).value();
  ASSERT_EQ(plain.needs.at(0).records.size(), 2U);
  const GapStudy drawn = needs_of("[sampling]\nmethod = 'latin-hypercube'\ncount = 20\n" + records + softer).value();
  const std::vector<double> two = gap_needed(plain.needs[0]), all = gap_needed(drawn.needs.at(0));
  ASSERT_EQ(all.size(), 20U);
  // Ten of each record, scaled by numbers of their own about the median 1.
  std::vector<double> factors;
  for (std::size_t n = 0; n < all.size(); ++n) {
    const bool is_first = drawn.needs[0].records[n].record.find("AT2") != std::string::npos;
    factors.push_back(all[n] / two[is_first ? 0 : 1]);
  }
  EXPECT_EQ(std::count_if(drawn.needs[0].records.begin(), drawn.needs[0].records.end(),
                          [](const RecordNeed& one) { return one.record.find("AT2") != std::string::npos; }),
            10);
  std::sort(factors.begin(), factors.end());
  EXPECT_EQ(std::unique(factors.begin(), factors.end()), factors.end());
  EXPECT_LT(factors.front(), 0.8);
  EXPECT_GT(factors.back(), 1.25);
  EXPECT_NEAR(0.5 * (factors[9] + factors[10]), 1, 0.1);
}

}  // namespace
}  // namespace bentur
