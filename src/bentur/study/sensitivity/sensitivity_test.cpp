#include "bentur/study/sensitivity/sensitivity.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>

#include "bentur/io/case/case_parts.h"
#include "bentur/io/case/case_toml.h"
#include "bentur/io/toml/parameter_path.h"
#include "bentur/model/run_results.h"
#include "bentur/pounding/plan/plan_pounding.h"
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

/// Buildings in plan that twist, one beside the other and shifted along the joint. @param contact of all pairs
std::string twisting(const std::string& contact, const std::string& more_of_second = "") {
  return "[units]\nlength = \"m\"\nforce = \"kN\"\n[plan]\nclearance = 0.1\ncontact = " + contact + R"(
[[building]]
name = "Walled"
damping = 0.05
plan = { corner = [0.5, 1.0], size = [12.0, 18.0], storey_heights = [3.5, 3.2], masses = [200, 180], centres_of_mass = [6.2, 8.7] }
[[building.plane]]
along = "x"
at = 0.5
stiffnesses = [9e4, 9e4]
[[building.plane]]
along = "x"
at = 17.0
stiffnesses = [2e4, 2e4]
[[building.plane]]
angle = 80.0
through = [6.0, 1.0]
stiffnesses = 8e4
[[building]]
name = "Even"
damping = 0.04
plan = { corner = [12.53, 3.5], size = [15.0, 17.0], storey_heights = [3.5, 3.2], masses = [250, 220], inertias = [9e3, 8e3] }
rigidity = { centre = [7.5, 9.0], x = 1.2e5, y = 1.1e5, torsion = 1.2e7 }
)" + more_of_second +
         R"([excitation]
kind = "harmonic"
period = 0.5
displacement_amplitude = 0.03
angle = 10.0
wave_velocity = 800.0
wave_angle = 20.0
kinematics = "absolute"
[excitation.y]
kind = "harmonic"
period = 0.43
displacement_amplitude = 0.01
[analysis]
duration = 3.0
)";
}

TomlValue root_of(const std::string& text) {
  Diagnostics diagnostics;
  return parse_toml(text, "case.toml", diagnostics).value();
}

/// Peaks of a run in plan, in the order of Sensitivity::peaks. @param wider its first gap, by so much
std::vector<double> peaks_in_plan(const TomlValue& root, double wider = 0) {
  Diagnostics diagnostics;
  ReadCase read = read_case_parts(TomlView(root, "", "case.toml", diagnostics), ".", diagnostics);
  EXPECT_TRUE(diagnostics.ok() && read.plan);
  read.plan->gaps.front().stretch.width += wider;
  const PlanResponse response = solve(*read.plan);
  std::vector<double> result;
  std::size_t first = 0;
  for (const PlanGap& gap : read.plan->gaps) {
    const std::size_t end = first + gap.contacts.size();
    for (std::size_t i = first; i < end; ++i) result.push_back(response.points[i].gap_needed);
    for (std::size_t i = first; i < end; ++i) result.push_back(response.points[i].peak_force);
    first = end;
  }
  for (std::size_t b = 0; b < response.buildings.size(); ++b) {
    for (Eigen::VectorXd PlanPeaks::*const of : {&PlanPeaks::x, &PlanPeaks::y}) {
      for (const double x : response.buildings[b].*of) result.push_back(x);
      for (const double x : response.buildings_no_contact[b].*of) result.push_back(x);
    }
  }
  return result;
}

/// Every number of a case in plan, places and sizes of its buildings among them, by runs with a little more of it and a
/// little less. @param all peaks have derivatives
void expect_differences(const std::string& text, const std::vector<std::string>& known, bool all = true) {
  const TomlValue root = root_of(text);
  std::string errors;
  const auto found = sensitivity_in(text, {}, &errors);
  ASSERT_TRUE(found) << errors;
  const std::vector<double> values = peaks_in_plan(root);
  ASSERT_EQ(found->peaks.size(), values.size());
  for (const std::string& path : known) {
    EXPECT_TRUE(std::any_of(found->numbers.begin(), found->numbers.end(), [&](const CaseNumber& number) {
      return number.path == path;
    })) << path;
  }
  const auto part = [&](std::size_t i, std::size_t p) {  // of footprints too
    const Derivative& of = found->peaks[i].derivative;
    return of.by.size() > 0 ? of.by(static_cast<Eigen::Index>(p)) * found->numbers[p].value / values[i] : 0.0;
  };
  std::vector<double> largest(values.size(), 0);
  for (std::size_t i = 0; i < values.size(); ++i) {
    for (std::size_t p = 0; p < found->numbers.size(); ++p) largest[i] = std::max(largest[i], std::abs(part(i, p)));
  }
  int compared = 0;
  for (std::size_t p = 0; p < found->numbers.size(); ++p) {
    const CaseNumber& number = found->numbers[p];
    std::string error;
    const double step = 2e-7 * std::abs(number.value);
    const auto run_with = [&](double value) {
      TomlValue other = root;
      if (number.path == "Walled | Even: width") return peaks_in_plan(root, value - number.value);
      put_value(other, *parse_path(number.path, error), toml_number(value));
      return peaks_in_plan(other);
    };
    const std::vector<double> above = run_with(number.value + step), below = run_with(number.value - step);
    for (std::size_t i = 0; i < values.size(); ++i) {
      const Derivative& of = found->peaks[i].derivative;
      if (values[i] == 0) continue;
      EXPECT_NEAR(of.value, values[i], 1e-9 * values[i]);
      if (of.by.size() == 0 && !all) continue;
      ASSERT_GT(of.by.size(), 0) << i;
      // Differences of runs: their curvature, of which a place 12 m away has the most, and round-off over the step.
      EXPECT_EQ(number.is_of_footprint, std::isnan(found->elasticity(found->peaks[i], p)));
      EXPECT_NEAR(part(i, p), (above[i] - below[i]) / (2 * step) * number.value / values[i], 1e-5 * (1 + largest[i]))
          << number.path << " of " << key_of(found->peaks[i].kind) << ' ' << i;
      ++compared;
    }
  }
  EXPECT_GT(compared, 500);
}

const std::vector<std::string> numbers_of_plan = {"plan.contact.stiffness",
                                                  "Walled | Even: width",
                                                  "building[0].plan.corner[0]",
                                                  "building[1].plan.corner[1]",
                                                  "building[0].plan.size[0]",
                                                  "building[1].plan.size[1]",
                                                  "building[0].plan.centres_of_mass[0]",
                                                  "building[0].plan.storey_heights[0]",
                                                  "building[1].plan.inertias[1]",
                                                  "building[0].plane[1].at",
                                                  "building[0].plane[2].angle",
                                                  "building[1].rigidity.centre[0]",
                                                  "building[1].rigidity.torsion",
                                                  "excitation.angle",
                                                  "excitation.wave_velocity",
                                                  "excitation.y.period"};

TEST(SensitivityOfACase, InPlanIsThatOfRunsWithALittleMoreAndALittleLess) {
  expect_differences(twisting("{ law = \"linear\", stiffness = 4e5 }"), numbers_of_plan);
  expect_differences(twisting("{ law = \"kelvin-voigt\", stiffness = 4e5, damping_ratio = 0.1 }"), numbers_of_plan);
}

TEST(SensitivityOfACase, InPlanHasImpactsWithoutTimeAndLinks) {
  std::vector<std::string> known(numbers_of_plan.begin() + 1, numbers_of_plan.end());
  known.insert(known.end(), {"plan.contact.restitution", "link[0].stiffness", "link[0].at"});
  std::string text = twisting("{ law = \"restitution\", restitution = 0.8 }",
                              "[[link]]\nbetween = [\"Walled\", \"Even\"]\nlaw = \"spring-dashpot\"\nstiffness = 2e3\n"
                              "damping = 100.0\nelevations = [6.7]\nat = 9.0\n");
  text.replace(text.find("duration = 3.0"), 14, "duration = 1.5");  // later a contact comes to rest
  expect_differences(text, known);
}

/// Corner to corner bodies touch across the edge that closes last, and slip off where another one opens: a force that
/// is largest then has no derivative.
TEST(SensitivityOfACase, InPlanPassesCorners) {
  for (const auto& [corner, all] : {std::pair("corner = [12.505, 19.01]", true), {"corner = [12.51, 19.004]", false}}) {
    SCOPED_TRACE(corner);
    std::string text = twisting("{ law = \"kelvin-voigt-approach\", stiffness = 4e5, damping_ratio = 0.1 }");
    for (const auto& [from, to] : {std::pair("corner = [12.53, 3.5]", corner),
                                   std::pair("displacement_amplitude = 0.01", "displacement_amplitude = 0.03")}) {
      text.replace(text.find(from), std::string(from).size(), to);
    }
    expect_differences(text,
                       {"Walled | Even: width", "building[1].plan.corner[0]", "building[1].plan.corner[1]",
                        "building[0].plan.size[1]"},
                       all);
  }
}

/// Twice both motions need twice the gap.
TEST(SensitivityOfACase, InPlanIsToldAndWritten) {
  const auto found = sensitivity_in(twisting("{ law = \"linear\", stiffness = 4e5 }"));
  ASSERT_TRUE(found);
  const Story story = sensitivity_story(*found);
  EXPECT_EQ(story.tables.size(), 3u);
  EXPECT_EQ(story.tables.back().columns.size(), 6u);  // number, value, and along x and along y with contact and without
  const auto json = nlohmann::json::parse(sensitivity_json(*found, "0"));
  EXPECT_EQ(json["peaks"][0]["at"].size(), 2u);
  EXPECT_EQ(json["peaks"].back()["quantity"], "displacement_y_no_contact");
  const auto part = [&](const SensitivePeak& peak, const std::string& path) {
    for (std::size_t p = 0; p < found->numbers.size(); ++p) {
      if (found->numbers[p].path == path) return found->elasticity(peak, p);
    }
    ADD_FAILURE() << path;
    return 0.0;
  };
  for (const SensitivePeak& peak : found->peaks) {
    if (peak.kind != SensitivePeak::Kind::gap_needed) continue;
    EXPECT_NEAR(part(peak, "excitation.displacement_amplitude") + part(peak, "excitation.y.displacement_amplitude"), 1,
                1e-8);
  }
}

TEST(SensitivityOfACase, InPlanIsRefusedWhereThereIsNone) {
  const auto refused = [](const std::string& contact, const std::string& old, const std::string& other) {
    std::string text = twisting(contact), errors;
    if (!old.empty()) text.replace(text.find(old), old.size(), other);
    EXPECT_FALSE(sensitivity_in(text, {}, &errors));
    return errors;
  };
  EXPECT_NE(refused("{ law = \"linear\", stiffness = 4e5, friction = 0.3 }", "", "").find("rub"), std::string::npos);
  EXPECT_NE(
      refused("{ law = \"linear\", stiffness = 4e5 }", "centres_of_mass = [6.2, 8.7]", "accidental_eccentricity = 0.05")
          .find("accidental_eccentricity"),
      std::string::npos);
  // Flush edges: of two corners at one place one counts this way and the other that way.
  std::string text = twisting("{ law = \"linear\", stiffness = 4e5 }");
  const std::string placed = "corner = [12.53, 3.5], size = [15.0, 17.0]";
  text.replace(text.find(placed), placed.size(), "corner = [12.53, 1.0], size = [15.0, 18.0]");
  const auto flush = sensitivity_in(text);
  ASSERT_TRUE(flush);
  EXPECT_TRUE(std::any_of(flush->left_out.begin(), flush->left_out.end(),
                          [](const auto& one) { return one.first == "building[1].plan.size[1]"; }));
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
