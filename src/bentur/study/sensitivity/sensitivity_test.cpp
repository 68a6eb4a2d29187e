#include "bentur/study/sensitivity/sensitivity.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>

#include "bentur/io/case/case_toml.h"
#include "bentur/model/run_results.h"
#include "bentur/pounding/pounding.h"

namespace bentur {
namespace {

const std::string frames = R"(title = "A frame and a stick"
[units]
length = "m"
force = "kN"
[[building]]
name = "Frame"
damping = 0.05
[building.frame]
elastic_modulus = 2.5e7
storey_heights = [3.0, 3.0]
bay_widths = [4.0]
columns = [{ width = 0.3, depth = 0.3, mass = 0.5 }]
beams = [{ width = 0.3, depth = 0.4, mass = 3.0 }]
[[building]]
name = "Stick"
damping = { rayleigh = { periods = [0.3, 0.1], ratios = [0.05, 0.04] } }
[building.stick]
storey_heights = [3.0, 3.0]
masses = [20.0, 15.0]
stiffnesses = [20000.0, 16000.0]
[[gap]]
between = ["Frame", "Stick"]
width = 0.01
contact = { law = "kelvin-voigt", stiffness = 3e5, damping_ratio = 0.2 }
[excitation]
kind = "harmonic"
period = 0.45
displacement_amplitude = 0.03
[analysis]
duration = 3.0
)";

std::optional<Sensitivity> sensitivity_in(const std::string& text, const SensitivityOptions& options = {},
                                          std::string* errors = nullptr) {
  Diagnostics diagnostics;
  const auto root = parse_toml(text, "case.toml", diagnostics);
  EXPECT_TRUE(root);
  auto found = sensitivity_of(*root, "case.toml", options, diagnostics);
  for (const Diagnostic& error : diagnostics.errors()) {
    if (errors != nullptr) *errors += error.rule + "\n";
  }
  return found;
}

/// Peaks of a run of the case, in the order of Sensitivity::peaks.
std::vector<double> peaks_in(const std::string& text) {
  Diagnostics diagnostics;
  const auto c = read_case_text(text, "case.toml", diagnostics);
  EXPECT_TRUE(c);
  const Response response = solve(make_problem(*c), c->analysis.solver);
  std::vector<double> result;
  for (const PointSummary& point : response.points) result.push_back(point.gap_needed);
  for (const PointSummary& point : response.points) result.push_back(point.peak_force);
  for (const BuildingPeaks& peaks : response.buildings) {
    for (const double x : peaks.displacement) result.push_back(x);
    for (const double x : peaks.displacement_no_contact) result.push_back(x);
  }
  return result;
}

std::string with(const std::string& text, const std::string& old, double value) {
  const std::size_t at = text.find(old);
  EXPECT_NE(at, std::string::npos);
  std::string number(32, ' ');
  number.resize(static_cast<std::size_t>(std::snprintf(number.data(), number.size(), "%.17g", value)));
  const std::size_t end = old.find('=');
  return text.substr(0, at) + old.substr(0, end + 1) + ' ' + number + text.substr(at + old.size());
}

TEST(SensitivityOfACase, IsThatOfRunsWithALittleMoreAndALittleLess) {
  const auto found = sensitivity_in(frames);
  ASSERT_TRUE(found);
  const std::vector<double> values = peaks_in(frames);
  ASSERT_EQ(found->peaks.size(), values.size());
  struct One {
    const char *path, *text;
    double value;
  };
  // A number of each kind: of a section, of material, of damping, of contact, of the gap and of the motion.
  for (const One& one : {One{"building[0].frame.elastic_modulus", "elastic_modulus = 2.5e7", 2.5e7},
                         One{"building[0].frame.columns[0].depth", "depth = 0.3", 0.3},
                         One{"building[0].damping", "damping = 0.05", 0.05}, One{"gap[0].width", "width = 0.01", 0.01},
                         One{"gap[0].contact.stiffness", "stiffness = 3e5", 3e5},
                         One{"gap[0].contact.damping_ratio", "damping_ratio = 0.2", 0.2},
                         One{"excitation.period", "period = 0.45", 0.45},
                         One{"excitation.displacement_amplitude", "displacement_amplitude = 0.03", 0.03}}) {
    const auto at = std::find_if(found->numbers.begin(), found->numbers.end(),
                                 [&](const CaseNumber& number) { return number.path == one.path; });
    ASSERT_NE(at, found->numbers.end()) << one.path;
    const auto p = static_cast<Eigen::Index>(at - found->numbers.begin());
    const double step = 1e-6 * one.value;
    const std::vector<double> above = peaks_in(with(frames, one.text, one.value + step)),
                              below = peaks_in(with(frames, one.text, one.value - step));
    for (std::size_t i = 0; i < values.size(); ++i) {
      const Derivative& of = found->peaks[i].derivative;
      ASSERT_GT(of.by.size(), 0) << i;
      EXPECT_NEAR(of.value, values[i], 1e-9 * values[i]);
      // Differences of the run err by some 1e-6 of the largest elasticity, which is of the order of ten.
      const double elasticity = found->elasticity(found->peaks[i], static_cast<std::size_t>(p));
      EXPECT_NEAR(elasticity, (above[i] - below[i]) / (2 * step) * one.value / values[i], 1e-4)
          << one.path << " of " << i;
    }
  }
}

/// Twice the motion and twice the gap give twice of everything: elasticities by both add up to 1.
TEST(SensitivityOfACase, AddsUpForWhatScales) {
  const auto found = sensitivity_in(frames, {.numbers = {"gap[0].width", "excitation.displacement_amplitude"}});
  ASSERT_TRUE(found);
  ASSERT_EQ(found->numbers.size(), 2u);
  std::size_t peaks = 0;
  for (const SensitivePeak& peak : found->peaks) {
    EXPECT_NEAR(found->elasticity(peak, 0) + found->elasticity(peak, 1), 1, 1e-8) << key_of(peak.kind);
    if (peak.is_largest) ++peaks;
    const bool alone =
        peak.kind == SensitivePeak::Kind::gap_needed || peak.kind == SensitivePeak::Kind::displacement_no_contact;
    EXPECT_NEAR(alone ? found->elasticity(peak, 0) : 0, 0, 1e-12);
  }
  EXPECT_EQ(peaks, 6u);  // gap needed and force of the gap, both displacements of both buildings
}

TEST(SensitivityOfACase, IsToldAndWritten) {
  const auto found = sensitivity_in(frames);
  ASSERT_TRUE(found);
  const Story story = sensitivity_story(*found);
  EXPECT_EQ(story.tables.size(), 3u);
  EXPECT_TRUE(std::any_of(story.statements.begin(), story.statements.end(),
                          [](const Statement& one) { return one.kind == "sensitivity_peak_force"; }));
  const auto json = nlohmann::json::parse(sensitivity_json(*found, "0"));
  EXPECT_EQ(json["peaks"].size(), found->peaks.size());
  EXPECT_EQ(json["peaks"][0]["gradient"].size(), json["numbers"].size());
}

TEST(SensitivityOfACase, IsRefusedWhereThereIsNone) {
  const auto refused = [](std::string text, const std::string& old, const std::string& other) {
    text.replace(text.find(old), old.size(), other);
    std::string errors;
    EXPECT_FALSE(sensitivity_in(text, {}, &errors));
    return errors;
  };
  EXPECT_NE(refused(frames, "law = \"kelvin-voigt\", stiffness = 3e5, damping_ratio = 0.2",
                    "law = \"hertz\", stiffness = 3e5")
                .find("curved"),
            std::string::npos);
  EXPECT_NE(refused(frames, "stiffnesses = [20000.0, 16000.0]",
                    "stiffnesses = [20000.0, 16000.0]\nyield_forces = [100.0, 80.0]")
                .find("yields"),
            std::string::npos);
  EXPECT_NE(refused(frames, "duration = 3.0", "duration = 3.0\nsolver = \"adaptive\"").find("exact"),
            std::string::npos);
  std::string errors;
  EXPECT_FALSE(sensitivity_in(frames, {.numbers = {"gap[0].between"}}, &errors));
  EXPECT_NE(errors.find("is no number"), std::string::npos);
}

}  // namespace
}  // namespace bentur
