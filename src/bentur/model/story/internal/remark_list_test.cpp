#include <gtest/gtest.h>

#include <cstdint>
#include <numbers>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "bentur/core/number_text.h"
#include "bentur/model/story/internal/remark_checks.h"
#include "bentur/model/story/remarks.h"
#include "bentur/model/story/story.h"

namespace bentur {
namespace {

// As studies write them, a double a run.
TEST(Remarks, HaveABitAKindThatADoubleKeeps) {
  std::vector<Remark> all;
  std::uint64_t some = 0;
  for (const std::string_view key : remark_keys()) {
    all.emplace_back();
    all.back().key = key;
    const std::uint64_t bit = remark_kinds({all.back()});
    EXPECT_EQ(some & bit, 0U) << key;
    some |= bit;
    EXPECT_EQ(static_cast<std::uint64_t>(static_cast<double>(some)), some) << key;
  }
  EXPECT_EQ(remark_kinds(all), some);
}

// Alike: one number. A few: one for each that is named. Many: the least and the largest of all.
TEST(Remarks, HaveTheNumbersOfAllThatTheyName) {
  const auto value_of = [](const std::vector<double>& values) {
    std::vector<Remark> all;
    for (const double value : values) {
      all.emplace_back();
      all.back().key = "drift";
      all.back().value = value;
      all.back().unit = "%";
    }
    const std::vector<Statement> told = remark_statements(all);
    EXPECT_EQ(told.size(), 1U);
    const StoryValue& value = told.front().values.at(values.size() > 4 ? 1 : 0);
    EXPECT_EQ(value.name, "value");
    return std::holds_alternative<double>(value.value) ? number(std::get<double>(value.value))
                                                       : std::get<std::string>(value.value);
  };
  EXPECT_EQ(value_of({1.5, 1.5, 1.5}), "1.5");
  EXPECT_EQ(value_of({1.5, 2, 1.5, 2}), "1.5, 2, 1.5, 2\u00A0%");
  EXPECT_EQ(value_of({1.5, 2, 1.25, 2, 3, 1.5}), "1.25–3\u00A0%");
}

// Of many runs that counts which has the number farthest from the usual, of however many buildings and either way.
TEST(Remarks, OfManyRunsAreOfTheFarthest) {
  const auto run = [](const std::string& name, const std::vector<double>& moduli) {
    std::vector<Remark> all;
    for (const double value : moduli) all.push_back({"elastic_modulus", "A", value, "", 1e10, 2e11, value < 1e9});
    return SaidOfRun{name, remark_statements(all)};
  };
  const std::vector<Statement> told = union_of({run("a", {4e11}), run("b", {8e8}), run("c", {3e11, 6e11})});
  ASSERT_EQ(told.size(), 1U);
  EXPECT_EQ(told.front().many->worst, "b");
  EXPECT_EQ(told.front().severity, Severity::danger);
  EXPECT_EQ(union_of({run("a", {4e11}), run("c", {3e11, 6e11})}).front().many->worst, "c");
}

/// What is remarked of a motion alone [m, kN], "pga?" where it is in doubt.
std::vector<std::string> remarks_of_motion(const GroundMotion& motion, const ExcitationSpec& excitation) {
  remarking::List list({.length = "m", .force = "kN", .gravity = 9.81});
  remarking::check_motion(motion, excitation, "", 100, list);
  std::vector<std::string> names;
  for (const Remark& one : list.take()) names.push_back(one.key + (one.is_doubt ? "?" : ""));
  return names;
}

// The amplitude of a harmonic motion has no record beside it by which it could be meant so weak.
TEST(Remarks, OfAnAmplitudeInTheWrongUnit) {
  const auto of = [](double peak, std::optional<double> without_unit) {
    const double omega = 2 * std::numbers::pi / 0.5;
    ExcitationSpec excitation;
    excitation.amplitude_without_unit = without_unit;
    return remarks_of_motion(HarmonicMotion{.period = 0.5, .displacement_amplitude = peak / (omega * omega)},
                             excitation);
  };
  EXPECT_EQ(of(0.3, 0.3), std::vector<std::string>{"pga_without_unit?"});
  EXPECT_EQ(of(0.3, {}), std::vector<std::string>{"pga"});  // with its unit, or by its displacement
  EXPECT_EQ(of(3, 3), std::vector<std::string>{});
  EXPECT_EQ(of(30, 30), std::vector<std::string>{"pga"});  // 3 g
  EXPECT_EQ(of(300, 300), std::vector<std::string>{"pga?"});
}

// Peaks that no earthquake has, or that damage nothing: by them no gap is judged.
TEST(Remarks, OfPeaksThatAreInDoubt) {
  const auto of = [](double in_g) {
    return remarks_of_motion(SampledMotion{.time_step = 0.01, .acceleration = {0, 9.81 * in_g, 0}}, {});
  };
  EXPECT_EQ(of(0.0005), std::vector<std::string>{"pga?"});
  EXPECT_EQ(of(0.0099), std::vector<std::string>{"pga?"});
  EXPECT_EQ(of(0.0101), std::vector<std::string>{"pga"});
  EXPECT_EQ(of(4.9), std::vector<std::string>{"pga"});
  EXPECT_EQ(of(5.1), std::vector<std::string>{"pga?"});
  EXPECT_EQ(of(30), std::vector<std::string>{"pga?"});
}

}  // namespace
}  // namespace bentur
