#include "bentur/io/case/case_toml.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "bentur/io/case/case_memo.h"
#include "bentur/io/case/case_parts.h"
#include "bentur/io/temporary_folder.h"
#include "bentur/io/toml/toml_value.h"
#include "bentur/model/plan/plan_run.h"
#include "bentur/model/quantity_row.h"
#include "bentur/model/run_results.h"
#include "tests/support/mutated_text.h"

namespace bentur {
namespace {

namespace fs = std::filesystem;

const fs::path bad_input = fs::path(BENTUR_BINARY_DIR) / "tests" / "bad_input";  // by tests/bad_input/expand.py

std::string content(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

std::vector<std::string> lines(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> result;
  for (std::string line; std::getline(stream, line);) result.push_back(line);
  return result;
}

/// Equal, or equal up to the dots where the expected line ends in "...".
bool agrees(const std::string& line, const std::string& expected) {
  if (!expected.ends_with("...")) return line == expected;
  return line.starts_with(expected.substr(0, expected.size() - 3));
}

/// Below 2.2e-308 a number is none for the stream that toml++ reads with where there is no from_chars.
bool is_tried_here(const std::string& file) {
#ifdef __EMSCRIPTEN__
  return file != "harmonic-period-tiny.toml";
#else
  return !file.empty();
#endif
}

/// Counts are refused before any work that grows with them.
TEST(CaseToml, TooManyBuildingsAndStoreysAreCountedFirst) {
  std::string buildings, numbers;
  for (int i = 0; i < 100000; ++i) buildings += fmt::format("[[building]]\nname = \"{}\"\n", i);
  for (int i = 0; i < 1001; ++i) numbers += "3, ";
  const auto errors = [](const std::string& text) {
    Diagnostics diagnostics;
    EXPECT_FALSE(read_case_text(text, bad_input / "many.toml", diagnostics));
    std::string all;
    for (const Diagnostic& one : diagnostics.errors()) all += one.text() + "\n";
    return all;
  };
  const std::string many = errors(buildings);
  EXPECT_NE(many.find("building has 100000 entries, must have at most 1000"), std::string::npos) << many;
  EXPECT_EQ(many.find("damping"), std::string::npos) << "none of them is read";
  const std::string tall = errors("[[building]]\nname = \"A\"\nstick = { storey_heights = [" + numbers + "] }\n");
  EXPECT_NE(tall.find("storey_heights has 1001 entries, must have at most 1000"), std::string::npos) << tall;
}

TEST(CaseToml, EachBadInputGivesItsMessages) {
  int cases = 0;
  for (const auto& entry : fs::directory_iterator(bad_input)) {
    if (entry.path().extension() != ".toml") continue;
    if (!is_tried_here(entry.path().filename().string())) continue;
    ++cases;
    SCOPED_TRACE(entry.path().filename().string());
    Diagnostics diagnostics;
    EXPECT_FALSE(read_case(entry.path(), diagnostics));
    const std::string folder = entry.path().parent_path().string() + "/";
    const auto expected = lines(content(fs::path(entry.path()).replace_extension(".expected")));
    const auto errors = diagnostics.errors();
    EXPECT_FALSE(expected.empty());
    EXPECT_EQ(errors.size(), expected.size());
    for (std::size_t i = 0; i < std::max(errors.size(), expected.size()); ++i) {
      std::string line = i < errors.size() ? errors[i].text() : "(nothing)";
      if (line.starts_with(folder)) line.erase(0, folder.size());
      const std::string wanted = i < expected.size() ? expected[i] : "(nothing)";
      EXPECT_TRUE(agrees(line, wanted)) << "  read:     " << line << "\n  expected: " << wanted;
    }
  }
  EXPECT_GE(cases, 50);
}

TEST(CaseToml, EachMessageOfBadInputHasItsKey) {
  std::set<std::string> files;
  for (const auto& entry : fs::directory_iterator(bad_input)) {
    if (entry.path().extension() == ".toml") files.insert(entry.path().filename().string());
  }
  std::vector<std::string> keys;
  for (const std::string& file : files) {
    if (!is_tried_here(file)) continue;
    Diagnostics diagnostics;
    (void)read_case(bad_input / file, diagnostics);
    for (const Diagnostic& one : diagnostics.errors()) {
      keys.push_back(file + ":" + (one.key.empty() ? "" : " " + one.key));
      EXPECT_TRUE(one.message().starts_with(one.key)) << one.text();
    }
  }
  std::vector<std::string> expected = lines(content(bad_input / "keys.txt"));
  std::erase_if(expected, [](const std::string& line) { return !is_tried_here(line.substr(0, line.find(':'))); });
  EXPECT_EQ(keys, expected);
}

TEST(CaseToml, EachExpectedFileHasItsCase) {
  for (const auto& entry : fs::directory_iterator(bad_input)) {
    if (entry.path().extension() != ".expected") continue;
    EXPECT_TRUE(fs::exists(fs::path(entry.path()).replace_extension(".toml"))) << entry.path();
  }
}

TEST(CaseToml, AFileThatIsNotThere) {
  Diagnostics diagnostics;
  EXPECT_FALSE(read_case("no-such-case.toml", diagnostics).has_value());
  ASSERT_EQ(diagnostics.errors().size(), 1U);
  EXPECT_EQ(diagnostics.errors()[0].text(), "no-such-case.toml: error: there is no such file");
}

const char* const plain_case = R"(title = "Two sticks"
[units]
length = "m"
force = "kN"
[[building]]
name = "A"
damping = { rayleigh = { ratios = [0.05, 0.05], periods = [0.4, 0.1] } }
stick = { storey_heights = [3.0, 3], masses = [30.0, 25.0], stiffnesses = [40e3, 30e3] }
[[building]]
name = "B"
damping = 0.05
[building.frame]
elastic_modulus = 2.1e8
storey_heights = [3.0, 3.0]
bay_widths = [4.0]
columns = [{ width = 0.3, depth = 0.4, density = 2.4 }]
beams = [{ area = 0.1, inertia = 0.002, unit_weight = 25.0 }]
[[gap]]
between = ["A", "B"]
width = 0.02
contact = { law = "kelvin-voigt", stiffness = [3e5, 2e5], restitution = 0.65, release = "creep", calibration = "exact" }
[excitation]
kind = "harmonic"
period = 0.4
acceleration_amplitude = 2.0
[analysis]
duration = 5
solver = "adaptive"
tolerance = 1e-9
)";

TEST(CaseToml, HarmonicMotionsAreReversedAndKnowWhetherTheyHaveAUnit) {
  const auto read = [](const std::string& amplitude) {
    Diagnostics diagnostics;
    std::string text = plain_case;
    text.replace(text.find("acceleration_amplitude = 2.0"), 28, amplitude);
    return read_case_text(text, "plain.toml", diagnostics).value().excitation;
  };
  const auto of = [](const ExcitationSpec& spec) {
    return std::get<HarmonicMotion>(spec.motion).displacement_amplitude;
  };
  const ExcitationSpec plain = read("acceleration_amplitude = 2.0");
  EXPECT_EQ(plain.amplitude_without_unit, 2.0);
  EXPECT_FALSE(read("acceleration_amplitude = \"2.0 m/s2\"").amplitude_without_unit.has_value());
  EXPECT_FALSE(read("displacement_amplitude = 0.3").amplitude_without_unit.has_value());
  EXPECT_EQ(of(read("acceleration_amplitude = 2.0\npolarity = \"reversed\"")), -of(plain));
}

TEST(CaseToml, ErrorsOfTheCallerDoNotSpoilACase) {
  Diagnostics diagnostics;
  diagnostics.error({"other", 1, 1}, "of another file");
  EXPECT_TRUE(read_case_text(plain_case, "plain.toml", diagnostics).has_value());
  EXPECT_EQ(diagnostics.errors().size(), 1U);
}

// The library that parses TOML has unreachable code on some of these characters, and assertions on some malformed
// texts: every character is either refused or read as it is, and nothing ends the program.
TEST(CaseToml, EveryCharacterBeyondAsciiIsReadInAStringAndRefusedOutside) {
  for (unsigned c = 0x80; c < 0x10000; ++c) {
    const std::string bytes = test::utf8(c);
    Diagnostics in_string;
    const auto value = parse_toml("x = \"" + bytes + "\" # " + bytes + "\n", "x", in_string);
    const bool surrogate = c >= 0xD800 && c <= 0xDFFF;
    ASSERT_EQ(value.has_value(), !surrogate) << std::hex << c;
    if (value) {
      ASSERT_EQ(value->members.at(0).value.text, bytes) << std::hex << c;
    }
    Diagnostics outside;
    ASSERT_FALSE(parse_toml("x = 1 " + bytes, "x", outside).has_value()) << std::hex << c;
    ASSERT_EQ(outside.errors().at(0).position.column, 7) << std::hex << c;
  }
}

TEST(CaseToml, InvalidUtf8IsRefused) {
  // Overlong, truncated, a lone continuation, beyond U+10FFFF, a surrogate, and bytes that never occur.
  for (const char* const bytes : {"\xC0\x80", "\xC3", "\xE2\x82", "\x80", "\xF4\x90\x80\x80", "\xED\xA0\x80",
                                  "\xE0\x80\x80", "\xF0\x80\x80\x80", "\xFF", "\xFE"}) {
    Diagnostics diagnostics;
    EXPECT_FALSE(parse_toml(std::string("\nx = \"") + bytes + "\"", "x", diagnostics).has_value());
    ASSERT_EQ(diagnostics.errors().size(), 1U);
    EXPECT_EQ(diagnostics.errors()[0].text(), "x:2:6: error: not valid UTF-8 (save the file as UTF-8)");
  }
}

TEST(CaseToml, StringsMayHoldWhatOtherPlacesMayNot) {
  Diagnostics diagnostics;
  const auto root =
      parse_toml("a = '''é ''' # ü\nb = \"\"\"\\\"é\"\"\"\"\"\nc = 'é\\'\nd = \"é\\\\ü\" # [[[[ ....\ne = \"" +
                     std::string(100, '.') + "\"\n",
                 "x", diagnostics);
  ASSERT_TRUE(root.has_value()) << diagnostics.errors().at(0).text();
  EXPECT_EQ(root->members.at(0).value.text, "é ");
  EXPECT_EQ(root->members.at(1).value.text, "\"é\"\"");
  EXPECT_EQ(root->members.at(2).value.text, "é\\");
  EXPECT_EQ(root->members.at(3).value.text, "é\\ü");
}

// A crash fails the test by ending it; a text must be read or refused with a message.
TEST(CaseToml, MutatedCasesAreReadOrRefusedButNeverSilent) {
  std::mt19937 random(20190531);
  int read = 0;
  for (int round = 0; round < 20000; ++round) {
    const std::string text = test::mutated(plain_case, random);
    Diagnostics diagnostics;
    const bool good = read_case_text(text, "mutated.toml", diagnostics).has_value();
    ASSERT_EQ(good, diagnostics.ok()) << text;
    read += good ? 1 : 0;
  }
  EXPECT_GT(read, 100);  // some mutations leave a case right, so that both outcomes are tried
}

/// What there is to be said of a text that is read with a memo, or without: its errors, or else its row of quantities.
struct Outcome {
  std::vector<std::string> errors = {};
  std::vector<double> row = {};
};

Outcome outcome_of(const std::string& text, const fs::path& folder, CaseMemo* memo) {
  Diagnostics diagnostics;
  Outcome outcome;
  const auto root = parse_toml(text, "case.toml", diagnostics);
  const ReadCase read =
      read_case_parts(TomlView(root.value(), "", "case.toml", diagnostics), folder, diagnostics, memo);
  for (const Diagnostic& one : diagnostics.errors()) outcome.errors.push_back(one.text());
  if (!outcome.errors.empty()) return outcome;
  const auto fill = [&](const auto& problem, const auto& view_of) {
    const std::vector<RowPart> parts = row_parts(problem, read.c.units, false);
    outcome.row.resize(row_size(parts));
    fill_row(parts, view_of(run_results(read.c, problem, solve(problem))), outcome.row);
  };
  if (read.plan) {
    fill(*read.plan, [](PlanRun run) { return run; });
  } else {
    fill(read.problem(), [](const RunResults& run) { return run.view(); });
  }
  return outcome;
}

/// One of these texts.
const std::string& one_of(const std::vector<std::string>& texts, std::mt19937& random) {
  return texts[std::uniform_int_distribution<std::size_t>(0, texts.size() - 1)(random)];
}

/// Two buildings so far from one another, in a row or in plan, and no motion.
std::string two_buildings(bool in_plan, double gap) {
  if (!in_plan) {
    return fmt::format(R"(
[[building]]
name = 'A'
damping = 0.05
width = 9
stick = {{ storey_heights = [3, 3], masses = [30, 25], stiffnesses = [4e4, 3e4] }}
[[building]]
name = 'B'
damping = 0.02
width = 8
stick = {{ storey_heights = [3, 3], masses = [20, 20], stiffnesses = [6e4, 5e4] }}
[[gap]]
between = ['A', 'B']
width = {}
contact = {{ law = 'linear', stiffness = 3e5 }}
)",
                       gap);
  }
  return fmt::format(R"(
[plan]
clearance = 0.1
contact = {{ law = 'linear', stiffness = 4e5 }}
[[building]]
name = 'A'
damping = 0.05
plan = {{ corner = [0, 0], size = [9, 8], storey_heights = [3], masses = [200] }}
rigidity = {{ centre = [4, 4.5], x = 4e4, y = 5e4, torsion = 3e6 }}
[[building]]
name = 'B'
damping = 0.02
plan = {{ corner = [{}, 0], size = [9, 8], storey_heights = [3], masses = [100] }}
rigidity = {{ centre = [4, 4], x = 6e4, y = 6e4, torsion = 3e6 }}
)",
                     9 + gap);
}

/// A case whose ground moves in one of many ways, some of them wrong.
std::string drawn_case(bool in_plan, std::mt19937& random) {
  const auto number = [&](double from, double to) { return std::uniform_real_distribution(from, to)(random); };
  std::string text = two_buildings(in_plan, number(0, 1) < 0.5 ? 0.01 : 0.02);
  const auto motion = [&] {
    const std::string kind = one_of({"record", "record", "record", "harmonic"}, random);
    if (kind == "harmonic")
      return fmt::format("kind = 'harmonic'\nperiod = {}\ndisplacement_amplitude = 0.02\n", number(0.1, 1));
    return fmt::format("kind = 'record'\nfile = '{}'\nunit = 'm/s2'\n{} = {}\npolarity = '{}'\n",
                       one_of({"short.csv", "long.csv"}, random), one_of({"scale", "pga"}, random),
                       number(number(0, 1) < 0.1 ? -1 : 0.5, 4), one_of({"as-recorded", "reversed"}, random));
  };
  text += "[excitation]\n" + motion() +
          one_of({"", "delays = [0, 0.1]\n", "wave_velocity = 300\n", "delays = [0]\n"}, random);
  if (in_plan) text += one_of({"", "angle = 30\n"}, random);
  if (in_plan && number(0, 1) < 0.5) text += "[excitation.y]\n" + motion();
  return text + one_of({"", "[analysis]\nduration = 1.5\n", "[analysis]\ncollapse_drift = 0.2\n"}, random);
}

TEST(CaseToml, WhatReadingsShareChangesNothing) {
  const TemporaryFolder folder;
  for (const auto& [name, count] : {std::pair("short.csv", 50), {"long.csv", 90}}) {
    std::ofstream file(folder.path() / name);
    for (int n = 0; n < count; ++n) file << 0.02 * n << "," << 3 * std::sin(0.3 * n) << "\n";
  }
  std::mt19937 random(7);
  CaseMemo memo;
  int wrong = 0, right[] = {0, 0};
  for (int round = 0; round < 400; ++round) {
    const bool in_plan = round % 2 == 0;
    const std::string text = drawn_case(in_plan, random);
    const Outcome shared = outcome_of(text, folder.path(), &memo), alone = outcome_of(text, folder.path(), nullptr);
    ASSERT_EQ(shared.errors, alone.errors) << text;
    ASSERT_EQ(shared.row.size(), alone.row.size()) << text;
    ASSERT_EQ(std::memcmp(shared.row.data(), alone.row.data(), alone.row.size() * sizeof(double)), 0) << text;
    ++(alone.errors.empty() ? right[in_plan ? 1 : 0] : wrong);
  }
  for (const int count : right) EXPECT_GT(count, 50);
  EXPECT_GT(wrong, 50);
}

TEST(CaseToml, ReadingsShareAllButTheMotion) {
  const std::string analysis = "[analysis]\nduration = 2\n", building = two_buildings(true, 0.02) + analysis;
  const std::string motion = "[excitation]\nkind = 'harmonic'\ndisplacement_amplitude = 0.02\nperiod = ";
  Diagnostics diagnostics;
  const auto is_known = [&](const std::string& text, const fs::path& folder, CaseMemo& memo) {
    diagnostics = {};
    const auto root = parse_toml(text, "case.toml", diagnostics);
    const TomlView view(root.value(), "", "case.toml", diagnostics);
    const bool known = memo.but_motion(view, folder) != nullptr;
    (void)read_case_parts(view, folder, diagnostics, &memo);
    return known;
  };
  CaseMemo memo;
  EXPECT_FALSE(is_known(building + motion + "-1\n", "", memo));
  EXPECT_FALSE(diagnostics.ok());
  EXPECT_FALSE(is_known(building + motion + "0.5\n", "", memo)) << "the one before is wrong";
  for (const Diagnostic& one : diagnostics.errors()) ADD_FAILURE() << one.text();
  EXPECT_TRUE(is_known(building + motion + "0.6\n", "", memo));
  EXPECT_FALSE(is_known(building + motion + "0.6\n", "elsewhere", memo));
  EXPECT_FALSE(is_known(two_buildings(true, 0.03) + analysis + motion + "0.6\n", "", memo));
  const auto of_files = CaseMemo::of_files_that_change();
  EXPECT_FALSE(is_known(building + motion + "0.5\n", "", *of_files));
  EXPECT_FALSE(is_known(building + motion + "0.6\n", "", *of_files));
}

}  // namespace
}  // namespace bentur
