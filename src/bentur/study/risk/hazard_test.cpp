#include "bentur/study/risk/hazard.h"

#include <gtest/gtest.h>

#include <cmath>

namespace bentur {
namespace {

std::optional<HazardCurve> read(const std::string& text, std::string& errors, const HazardOptions& options = {}) {
  Diagnostics found;
  const auto curve = hazard_of(text, "hazard.csv", options, found);
  errors.clear();
  for (const Diagnostic& one : found.errors()) errors += one.text() + "\n";
  EXPECT_EQ(curve.has_value(), errors.empty());
  return curve;
}

TEST(Hazard, ATableOfTwoColumns) {
  std::string errors;
  for (const char* const text : {"# Padang\n0.1 0.02\n0.2 0.005\n0.4 0.0008\n", "0.1,0.02\n0.2,0.005\r\n\n0.4,0.0008",
                                 "Sa [g];lambda\n0.1;0.02\n0.2;0.005\n0.4;0.0008\n"}) {
    const auto curve = read(text, errors);
    ASSERT_TRUE(curve) << errors;
    EXPECT_EQ(curve->intensity, (std::vector<double>{0.1, 0.2, 0.4}));
    EXPECT_EQ(curve->rate, (std::vector<double>{0.02, 0.005, 0.0008}));
    EXPECT_EQ(curve->unit, std::string(text).starts_with("Sa") ? "g" : "");
    EXPECT_NEAR(curve->slope(0), 2, 1e-14);
    EXPECT_NEAR(curve->rate_at(std::sqrt(0.02)), 0.01, 1e-15);
    EXPECT_DOUBLE_EQ(curve->rate_at(0.2), 0.005);
    EXPECT_NEAR(curve->rate_at(0.05), 0.08, 1e-15);  // as the first segment goes on
    EXPECT_EQ(curve->segment_of(0.01), 0U);
    EXPECT_EQ(curve->segment_of(9), 1U);
  }
}

TEST(Hazard, ACurveOfOpenQuake) {
  const std::string head =
      "#,,,,,\"generated_by='OpenQuake engine 3.18.0', start_date='2024-01-01T00:00:00', checksum=1, kind='mean', "
      "investigation_time=50.0, "
      "imt='SA(0.5)'\"\nlon,lat,depth,poe-0.0050000,poe-0.1000000,poe-0.4000000,poe-2.0000000\n";
  const std::string one = "110.36,-7.80,0.0,1.000000E+00,5.000000E-01,1.000000E-01,0.000000E+00\n";
  const std::string other = "111.00,-7.80,0.0,9.000000E-01,4.000000E-01,1.000000E-02,0.000000E+00\n";
  std::string errors;
  const auto curve = read(head + one, errors);
  ASSERT_TRUE(curve) << errors;
  EXPECT_EQ(curve->intensity, (std::vector<double>{0.1, 0.4}));  // P = 1 has no frequency, P = 0 ends the curve
  EXPECT_NEAR(curve->rate[0], std::log(2.0) / 50, 1e-15);
  EXPECT_NEAR(curve->rate[1], -std::log(0.9) / 50, 1e-15);
  EXPECT_EQ(curve->measure, "SA(0.5)");
  EXPECT_EQ(curve->unit, "g");
  EXPECT_FALSE(read(head + one + other, errors));
  EXPECT_NE(errors.find("has 2 sites: choose one, from 1 to 2"), std::string::npos) << errors;
  const auto second = read(head + one + other, errors, {.site = 2});
  ASSERT_TRUE(second) << errors;
  EXPECT_NEAR(second->rate[0], -std::log(0.1) / 50, 1e-15);
  EXPECT_EQ(second->intensity.size(), 3U);
  EXPECT_FALSE(read(head + one, errors, {.site = 3}));
}

TEST(Hazard, WhatIsNoneIsRefusedWithItsLine) {
  const std::pair<const char*, const char*> bad[] = {
      {"0.1 0.02\n0.05 0.01\n", "hazard.csv:2: error: intensities must ascend"},
      {"0.1 0.02\n0.2 0.03\n", "hazard.csv:2: error: the frequency of a larger intensity must not be larger"},
      {"0.1 0\n0.2 0.03\n", "hazard.csv:2: error: the frequency of a larger intensity must not be larger"},
      {"0.1 0.02 3\n", "hazard.csv:1: error: has 3 numbers, must have 2"},
      {"0.1 0.02\n0.2 x\n", "hazard.csv:2: error: \"x\" is no number"},
      {"0.1 -0.02\n", "hazard.csv:1: error: frequency = -0.02, must be >= 0"},
      {"0 0.02\n", "hazard.csv:1: error: intensity = 0, must be > 0"},
      {"0.1 0.02\n", "hazard.csv: error: has no curve"},
      {"", "hazard.csv: error: has no curve"},
      {"lon,lat,poe-0.1,poe-0.2\n1,2,0.1,0.05\n", "hazard.csv:1: error: does not say investigation_time"},
      {"# investigation_time=50\nlon,lat,poe-0.1,poe-0.2\n1,2,0.1\n",
       "hazard.csv:3: error: has 3 columns, its heading 4"},
      {"# investigation_time=50\nlon,lat,poe-0.1,poe-0.2\n1,2,0.1,1.5\n",
       "hazard.csv:3: error: \"1.5\" is no probability"},
  };
  for (const auto& [text, told] : bad) {
    std::string errors;
    EXPECT_FALSE(read(text, errors)) << text;
    EXPECT_TRUE(errors.starts_with(told)) << errors;
  }
  std::string errors;
  EXPECT_FALSE(read("x [cm/s2] rate\n0.1 0.02\n0.2 0.01\n", errors, {.unit = "g"}));
  EXPECT_NE(errors.find("are in cm/s2, not in g"), std::string::npos) << errors;
}

TEST(Hazard, AHeadingSaysMeasureAndUnit) {
  struct Said {
    const char *heading, *measure, *unit;
    double factor = 1;
  };
  const Said all[] = {{"pga,rate", "PGA", ""},
                      {"pga;lambda", "PGA", ""},
                      {"# pga lambda", "PGA", ""},  // as numpy.savetxt writes it
                      {"PGA [g],rate [1/yr]", "PGA", "g"},
                      {"PGA (gal)\tlambda", "PGA", "cm/s2"},
                      {"Peak ground acceleration (cm/s/s), rate", "PGA", "cm/s2"},
                      {"pga_g,rate", "PGA", "g"},
                      {"PGA (mg), rate", "PGA", "g", 1e-3},
                      {"Sa [g];lambda", "SA", "g"},
                      {"S_a (g),lambda", "SA", "g"},
                      {"PSA lambda", "SA", ""},
                      {"Sa(T1) [g] lambda", "SA", "g"},
                      {"SA(0.5),afe", "SA(0.5)", ""},
                      {"Sa(T = 0.50 s) [m/s2], afe", "SA(0.5)", "m/s2"},
                      {"Sa_0.5s afe", "SA(0.5)", ""},
                      {"spectral acceleration 1.0 s [g] afe", "SA(1)", "g"},
                      {"pgv,rate", "PGV", ""},
                      {"x [cm/s2] rate", "", "cm/s2"},
                      {"pgas,rate", "", ""},
                      {"site,rate", "", ""}};
  for (const Said& one : all) {
    SCOPED_TRACE(one.heading);
    std::string errors;
    const auto curve = read(std::string(one.heading) + "\n0.1 0.02\n0.2 0.01\n", errors);
    ASSERT_TRUE(curve) << errors;
    EXPECT_EQ(curve->measure, one.measure);
    EXPECT_EQ(curve->unit, one.unit);
    EXPECT_DOUBLE_EQ(curve->intensity[0], 0.1 * one.factor);
  }
  std::string errors;
  const auto both = read("# SA at a site\nSa(0.5) [g],rate\n0.1,0.02\n0.2,0.01\n", errors);
  ASSERT_TRUE(both) << errors;
  EXPECT_EQ(both->measure, "SA(0.5)");
  const std::pair<const char*, const char*> bad[] = {
      {"# pga rate\nsa rate\n", "hazard.csv:2: error: is of SA, but said before to be of PGA"},
      {"pga [cm/s],rate\n", "hazard.csv:1: error: \"cm/s\" is no unit of accelerations that is known; one of g, "},
      {"rate,pga\n", "hazard.csv:1: error: \"pga\" must be the first column"}};
  for (const auto& [text, told] : bad) {
    EXPECT_FALSE(read(std::string(text) + "0.1,0.02\n0.2,0.01\n", errors)) << text;
    EXPECT_TRUE(errors.starts_with(told)) << errors;
  }
}

}  // namespace
}  // namespace bentur
