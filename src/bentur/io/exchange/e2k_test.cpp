#include "bentur/io/exchange/e2k.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <cstdlib>
#include <numbers>

#include "bentur/io/case/case_toml.h"

namespace bentur {
namespace {

/// Two storeys of two bays at y = 0, another frame at y = 5; written for this test.
const std::string small_model = R"($ File small.e2k saved for a test
$ PROGRAM INFORMATION
  PROGRAM  "ETABS"  VERSION "18.0.0"

$ CONTROLS
  UNITS  "KN"  "M"  "C"
$ STORIES - IN SEQUENCE FROM TOP
  STORY "ROOF"  HEIGHT 3.0 MASTERSTORY "Yes"
  STORY "FIRST"  HEIGHT 3.6
  STORY "Base"  ELEV 0
$ DIAPHRAGM NAMES
  DIAPHRAGM "D1"    TYPE RIGID
$ MATERIAL PROPERTIES
  MATERIAL  "C30"    TYPE "Concrete"    WEIGHTPERVOLUME 25
  MATERIAL  "C30"    SYMTYPE "Isotropic"  E 3E7  U 0.2  A 9.9E-06
  MATERIAL  "C30"    FC 30000
$ FRAME SECTIONS
  FRAMESECTION  "C 40"  MATERIAL "C30"  SHAPE "Concrete Rectangular"  D 0.4 B 0.4
  FRAMESECTION  "C50"  MATERIAL "C30"  SHAPE "Concrete Rectangular"  D 0.5 B 0.5
  FRAMESECTION  "B30"  MATERIAL "C30"  SHAPE "Concrete Rectangular"  D 0.6 B 0.3
  FRAMESECTION  "B30"  I2MOD 1 I3MOD 0.35
  FRAMESECTION  "PIPE"  MATERIAL "C30"  SHAPE "Pipe"  D 0.3 T 0.01
$ POINT COORDINATES
  POINT "1"  0 0
  POINT "2"  6 0
  POINT "3"  11 0
  POINT "4"  0 5
$ LINE CONNECTIVITIES
  LINE  "C1"  COLUMN  "1"  "1"  1
  LINE  "C2"  COLUMN  "2"  "2"  1
  LINE  "C3"  COLUMN  "3"  "3"  1
  LINE  "C4"  COLUMN  "4"  "4"  1
  LINE  "B1"  BEAM  "1"  "2"  0
  LINE  "B2"  BEAM  "2"  "3"  0
  LINE  "B3"  BEAM  "1"  "4"  0
$ AREA CONNECTIVITIES
  AREA "F1"  FLOOR  4  "1"  "2"  "3"  "4"  0  0  0  0
  AREA "F2"  FLOOR  4  "1"  "2"  "3"  "4"  0  0  0  0
$ LINE ASSIGNS
  LINEASSIGN  "C1"  "ROOF"  SECTION "C 40"  MINNUMSTA 3
  LINEASSIGN  "C2"  "ROOF"  SECTION "C 40"
  LINEASSIGN  "C3"  "ROOF"  SECTION "C 40"
  LINEASSIGN  "B1"  "ROOF"  SECTION "B30"
  LINEASSIGN  "B2"  "ROOF"  SECTION "B30"
  LINEASSIGN  "C1"  "FIRST"  SECTION "C 40"
  LINEASSIGN  "C2"  "FIRST"  SECTION "C50"
  LINEASSIGN  "C3"  "FIRST"  SECTION "C 40"
  LINEASSIGN  "B1"  "FIRST"  SECTION "B30"
  LINEASSIGN  "B2"  "FIRST"  SECTION "B30"
$ LOAD PATTERNS
  LOADPATTERN "Dead"  TYPE  "Dead"  SELFWEIGHT  1
$ END OF MODEL FILE
  whatever stands behind
)";

std::string changed(const std::string& from, const std::string& to) {
  std::string text = small_model;
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

std::string import_errors(const std::string& text, const E2kFrame& frame = {.at = 0}) {
  Diagnostics diagnostics;
  EXPECT_FALSE(read_e2k(text, "small.e2k", frame, diagnostics));
  std::string all;
  for (const Diagnostic& one : diagnostics.errors()) all += one.text() + "\n";
  return all;
}

TEST(E2k, IsACaseOnceItIsCompleted) {
  Diagnostics diagnostics;
  const auto made = read_e2k(small_model, "small.e2k", {.at = 0}, diagnostics);
  ASSERT_TRUE(made) << import_errors(small_model);
  std::string text = made->text;
  const std::string marked = "# damping = 0.05";
  text.replace(text.find(marked), marked.size(), "damping = 0.05");
  text += R"(floor_masses = 60.0
[[building]]
name = "Wall"
rigid = true
elevations = [3.6]
[[gap]]
between = ["Imported", "Wall"]
width = 0.05
contact = { law = "linear", stiffness = 1e5 }
[excitation]
kind = "harmonic"
period = 0.4
displacement_amplitude = 0.05
[analysis]
duration = 1
)";
  const auto c = read_case_text(text, "case.toml", diagnostics);
  for (const Diagnostic& one : diagnostics.errors()) ADD_FAILURE() << one.text();
  ASSERT_TRUE(c);
  const auto& frame = std::get<PlaneFrame>(c->buildings[0].structure);
  EXPECT_EQ(c->units.length, "m");
  EXPECT_EQ(c->units.force, "kN");
  EXPECT_EQ(frame.storey_heights, (std::vector<double>{3.6, 3.0}));
  EXPECT_EQ(frame.bay_widths, (std::vector<double>{6, 5}));
  EXPECT_EQ(frame.elastic_modulus, 3e7);
  const double small = 0.4 * 0.4 * 0.4 * 0.4 / 12, large = 0.5 * 0.5 * 0.5 * 0.5 / 12;
  EXPECT_NEAR(frame.columns[0].inertia, (2 * small + large) / 3, 1e-12);
  EXPECT_NEAR(frame.columns[1].inertia, small, 1e-12);
  EXPECT_NEAR(frame.columns[0].area, (2 * 0.16 + 0.25) / 3, 1e-12);
  EXPECT_NEAR(frame.beams[1].inertia, 0.35 * 0.3 * 0.6 * 0.6 * 0.6 / 12, 1e-12) << "cracked as the model has it";
  EXPECT_NE(text.find("unit_weight = 25"), std::string::npos);
  ASSERT_EQ(made->taken.size(), 2U);
  EXPECT_NE(made->taken[0].find("no joint has a RESTRAINT"), std::string::npos);
  EXPECT_NE(made->taken[1].find("columns of storey \"FIRST\" are of sections C 40, C50"), std::string::npos);
}

std::string unread_of(const std::string& text) {
  Diagnostics diagnostics;
  const auto made = read_e2k(text, "small.e2k", {.at = 0}, diagnostics);
  if (!made) return "an error";
  std::string all;
  for (const UnreadLines& one : made->unread)
    all += std::to_string(one.first) + "-" + std::to_string(one.last) + " " + one.what + "\n";
  return all;
}

TEST(E2k, WhatIsNotReadIsListedWithItsLines) {
  EXPECT_EQ(unread_of(small_model),
            "12-12 DIAPHRAGM NAMES\n16-16 MATERIAL PROPERTIES\n22-22 section \"PIPE\" of shape \"Pipe\", none of "
            "this frame\n37-38 AREA CONNECTIVITIES\n51-51 LOAD PATTERNS\n");
}

TEST(E2k, BracesAreNamedAndAnEndSaysNothing) {
  const std::string column = "  LINE  \"C4\"  COLUMN  \"4\"  \"4\"  1\n";
  std::string text = changed(column, column + "  LINE  \"D1\"  BRACE  \"1\"  \"2\"  1\n");
  text.insert(text.find("$ END OF"), "  END\n");
  EXPECT_EQ(unread_of(text),
            "12-12 DIAPHRAGM NAMES\n16-16 MATERIAL PROPERTIES\n22-22 section \"PIPE\" of shape \"Pipe\", none of "
            "this frame\n33-33 BRACE of LINE CONNECTIVITIES\n38-39 AREA CONNECTIVITIES\n52-52 LOAD PATTERNS\n");
}

TEST(E2k, SectionsAreThoseOfTheirSidesOrAsGiven) {
  // The columns of the upper storey.
  const auto upper_column = [](const std::string& section, const E2kFrame& frame) {
    std::string text = changed("SHAPE \"Pipe\"  D 0.3 T 0.01", section);
    for (std::size_t at = text.find("\"C 40\""); at != std::string::npos; at = text.find("\"C 40\"", at + 1)) {
      if (text.rfind("SECTION", at) > text.rfind('\n', at)) text.replace(at, 6, "\"PIPE\"");
    }
    Diagnostics diagnostics;
    const auto made = read_e2k(text, "small.e2k", frame, diagnostics);
    for (const Diagnostic& one : diagnostics.errors()) ADD_FAILURE() << one.text();
    double area = 0, inertia = 0;
    const std::size_t second = made->text.find("},", made->text.find("columns"));
    EXPECT_EQ(std::sscanf(made->text.c_str() + second, "},\n  { area = %lf, inertia = %lf", &area, &inertia), 2);
    return std::pair(area, inertia);
  };
  const auto expect = [&](const std::string& section, double area, double inertia, const E2kFrame& frame = {.at = 0}) {
    const auto [found, about] = upper_column(section, frame);
    EXPECT_NEAR(found, area, 1e-12 * area) << section;
    EXPECT_NEAR(about, inertia, 1e-12 * inertia) << section;
  };
  // By hand: flanges 300 by 20 and a web of 360 by 10 mm; with Steiner's theorem.
  expect("SHAPE \"Steel I/Wide Flange\"  D 0.4 B 0.3 TF 0.02 TW 0.01", 2 * 0.006 + 0.0036,
         2 * (0.3 * 8e-6 / 12 + 0.006 * 0.19 * 0.19) + 0.01 * 0.36 * 0.36 * 0.36 / 12);
  expect("SHAPE \"Steel Tube\"  D 0.4 B 0.3 TF 0.02 TW 0.01", 2 * 0.006 + 2 * 0.0036,
         2 * (0.3 * 8e-6 / 12 + 0.006 * 0.19 * 0.19) + 2 * 0.01 * 0.36 * 0.36 * 0.36 / 12);
  constexpr double pi = std::numbers::pi;
  expect("SHAPE \"Steel Pipe\"  D 0.4 T 0.1", pi * 0.03, pi / 4 * (0.0016 - 0.0001));
  expect("SHAPE \"Concrete Circle\"  D 0.4", pi * 0.04, pi / 4 * 0.0016);
  expect("SHAPE \"W14X74\"", 0.014, 3.3e-4, {.at = 0, .sections = {{"PIPE", {0.014, 3.3e-4}}}});
}

TEST(E2k, ColumnsBendAboutTheAxisThatLiesAcrossTheFrame) {
  // 0.6 deep along X and 0.3 wide; the beam keeps its depth wherever it runs.
  const auto inertias = [](bool along_x, const std::string& assigned) {
    std::string text = small_model;
    const auto put = [&text](const std::string& from, const std::string& to) {
      for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size())) {
        text.replace(at, from.size(), to);
      }
    };
    put("SECTION \"C 40\"", "SECTION \"C50\"");
    put("D 0.5 B 0.5", "D 0.6 B 0.3");
    put("SECTION \"C50\"", "SECTION \"C50\" " + assigned);
    if (!along_x) {
      put("POINT \"2\"  6 0", "POINT \"2\"  0 6");
      put("POINT \"3\"  11 0", "POINT \"3\"  0 11");
      put("POINT \"4\"  0 5", "POINT \"4\"  5 0");
    }
    Diagnostics diagnostics;
    const auto made = read_e2k(text, "small.e2k", {.along_x = along_x, .at = 0}, diagnostics);
    for (const Diagnostic& one : diagnostics.errors()) ADD_FAILURE() << one.text();
    std::vector<double> found;
    for (std::size_t at = made->text.find("inertia = "); at != std::string::npos;
         at = made->text.find("inertia = ", at + 1)) {
      found.push_back(std::strtod(made->text.c_str() + at + 10, nullptr));
    }
    return found;
  };
  const double major = 0.3 * 0.216 / 12, minor = 0.6 * 0.027 / 12, beam = 0.35 * major;
  const auto expect = [&](bool along_x, const std::string& assigned, double column) {
    const std::vector<double> found = inertias(along_x, assigned);
    ASSERT_EQ(found.size(), 4U);
    for (const int storey : {0, 1}) {
      EXPECT_NEAR(found[storey], column, 1e-12 * column) << along_x << assigned;
      EXPECT_NEAR(found[2 + storey], beam, 1e-12 * beam) << along_x << assigned;
    }
  };
  expect(true, "", major);
  expect(true, "ANG 90", minor);
  expect(false, "", minor);
  expect(false, "ANG  -90", major);
  expect(true, "PROPMODI22 0.5 PROPMODI33 0.7", 0.7 * major);
  expect(false, "PROPMODI22 0.5 PROPMODI33 0.7", 0.5 * minor);
}

TEST(E2k, ReleasedAndTurnedMembersAreErrors) {
  const std::string beam = "\"B1\"  \"ROOF\"  SECTION \"B30\"";
  const std::string released = "line \"B1\" is released at its ends (RELEASE ";
  EXPECT_NE(import_errors(changed(beam, beam + "  RELEASE \"TJ M2I M2J M3I M3J\"CARDINALPT 8")).find(released),
            std::string::npos);
  EXPECT_NE(import_errors(changed(beam, beam + "  RELEASE \"PINNED\"")).find(released), std::string::npos);
  EXPECT_NE(import_errors(changed(beam, beam + "  ANG 90")).find("ANG = 90, must leave axis 3 of line \"B1\""),
            std::string::npos);
  const std::string column = "\"C2\"  \"FIRST\"  SECTION \"C50\"";
  EXPECT_NE(import_errors(changed(column, column + "  ANG 30")).find("ANG = 30"), std::string::npos);
  const std::string turned = changed(column, "\"C2\"  \"FIRST\"  SECTION \"PIPE\" ANG 90");
  EXPECT_NE(import_errors(turned, {.at = 0, .sections = {{"PIPE", {0.01, 1e-4}}}}).find("--section PIPE=AREA,I33,I22"),
            std::string::npos);
}

/// The small model with lines of joints.
std::string with_joints(const std::string& lines) {
  return changed("$ LINE ASSIGNS\n", "$ POINT ASSIGNS\n" + lines + "$ LINE ASSIGNS\n");
}

const std::string fixed_feet = R"(  POINTASSIGN  "1"  "Base"  RESTRAINT "UX UY UZ RX RY RZ"
  POINTASSIGN  "2"  "Base"  RESTRAINT "UX UY UZ RX RY RZ"
  POINTASSIGN  "3"  "Base"  RESTRAINT "UX UY UZ RX RY RZ"
  POINTASSIGN  "4"  "Base"  RESTRAINT "UX UY UZ"
)";

std::optional<ImportedCase> imported(const std::string& text, const E2kFrame& frame = {.at = 0}) {
  Diagnostics diagnostics;
  auto made = read_e2k(text, "small.e2k", frame, diagnostics);
  for (const Diagnostic& one : diagnostics.errors()) ADD_FAILURE() << one.text();
  return made;
}

TEST(E2k, LinesOfBlanksOfAnyKindSayNothing) {
  const auto made = imported(changed("$ STORIES", "\f\n\v\r\r\n$ STORIES"));
  ASSERT_TRUE(made);
  EXPECT_EQ(made->text, imported(small_model)->text);
}

TEST(E2k, ColumnsThatAreNotFixedAtTheirFeetAreErrors) {
  const auto made = imported(with_joints(fixed_feet));  // point 4 is of another frame
  ASSERT_TRUE(made);
  EXPECT_EQ(made->taken.size(), 1U) << "nothing is taken of the feet";
  const auto of_feet = [](const std::string& old, const std::string& now) {
    std::string lines = fixed_feet;
    return import_errors(with_joints(lines.replace(lines.find(old), old.size(), now)));
  };
  EXPECT_EQ(of_feet("\"2\"  \"Base\"  RESTRAINT \"UX UY UZ RX RY RZ\"", "\"2\"  \"Base\"  RESTRAINT \"UX UY UZ\""),
            "small.e2k:41:1: error: RESTRAINT of point \"2\" at \"Base\" leaves RY free: columns of a frame here are "
            "fixed at their feet, and one that is not moves more\n");
  EXPECT_NE(of_feet("RX RY RZ\"\n  POINTASSIGN  \"2\"", "RX RZ\"\n  POINTASSIGN  \"2\"").find("leaves RY free"),
            std::string::npos);
  EXPECT_NE(of_feet("  POINTASSIGN  \"3\"  \"Base\"  RESTRAINT \"UX UY UZ RX RY RZ\"\n", "")
                .find("point \"3\" at the foot of a column has no RESTRAINT"),
            std::string::npos);
}

TEST(E2k, WhatElseHoldsAJointOrGivesWayIsAnError) {
  EXPECT_NE(import_errors(with_joints(fixed_feet + "  POINTASSIGN  \"1\"  \"ROOF\"  RESTRAINT \"UX\"\n"))
                .find("holds a joint above the base"),
            std::string::npos);
  EXPECT_NE(import_errors(with_joints(fixed_feet + "  POINTASSIGN  \"2\"  \"Base\"  SPRINGPROP \"Soil\"\n"))
                .find("SPRINGPROP of point \"2\" at \"Base\" is not read, and may change what holds the frame"),
            std::string::npos);
  const auto other = imported(with_joints(fixed_feet + "  POINTASSIGN  \"4\"  \"Base\"  SPRINGPROP \"Soil\"\n" +
                                          "  POINTASSIGN  \"1\"  \"ROOF\"  DIAPH \"D1\"\n"));
  EXPECT_TRUE(other) << "of another frame; and diaphragms are those of a plane frame";
}

TEST(E2k, MassesAtJointsAreThoseOfTheFloors) {
  const auto made = imported(with_joints(fixed_feet + R"(  POINTASSIGN  "1"  "ROOF"  MASSUXUY 30
  POINTASSIGN  "2"  "ROOF"  MASSUX 5
  POINTASSIGN  "1"  "FIRST"  MASSUXUY 40
  POINTASSIGN  "4"  "FIRST"  MASSUXUY 1000
  POINTASSIGN  "2"  "FIRST"  MASSUY 7
  POINTASSIGN  "1"  "Base"  MASSUXUY 9
)"));
  ASSERT_TRUE(made);
  EXPECT_NE(made->text.find("floor_masses = [40, 35]"), std::string::npos) << made->text;
  std::string unread;
  for (const UnreadLines& one : made->unread) unread += one.what + "\n";
  EXPECT_NE(unread.find("MASSUY of POINT ASSIGNS"), std::string::npos) << unread;
  EXPECT_NE(unread.find("masses at the base"), std::string::npos) << unread;
}

TEST(E2k, ModifiersOfMassCount) {
  const auto made = imported(changed("I2MOD 1 I3MOD 0.35", "I2MOD 1 I3MOD 0.35 MMOD 0.5"));
  ASSERT_TRUE(made);
  EXPECT_NE(made->text.find("unit_weight = 12.5"), std::string::npos) << made->text;
  EXPECT_NE(made->taken.back().find("the mass of beams of storey \"ROOF\" times 0.5"), std::string::npos);
}

TEST(E2k, ModifiersHaveTwoNames) {
  const auto one = imported(small_model),
             other = imported(changed("I2MOD 1 I3MOD 0.35", "I22MODIFIER 1 I33MODIFIER 0.35"));
  ASSERT_TRUE(one && other);
  EXPECT_EQ(one->text, other->text);
}

TEST(E2k, ColumnsAreReleasedAboutTheAxisThatBends) {
  const std::string column = "\"C2\"  \"FIRST\"  SECTION \"C50\"";
  EXPECT_TRUE(imported(changed(column, column + " RELEASE \"M2I M2J\""))) << "not about the axis that bends";
  EXPECT_NE(import_errors(changed(column, column + " ANG 90 RELEASE \"M2I\"")).find("is released"), std::string::npos);
  EXPECT_NE(import_errors(changed(column, column + " RELEASE \"M3J\"")).find("is released"), std::string::npos);
  EXPECT_NE(import_errors(changed(column, column + " RELEASE \"PI\"")).find("is released"), std::string::npos);
}

TEST(E2k, ATeeIsFourNumbers) {
  const std::string beam = "SHAPE \"Concrete Rectangular\"  D 0.6 B 0.3";
  const auto made = imported(changed(beam, "SHAPE \"Concrete Tee\"  D 0.5 B 1.2 TF 0.15 TW 0.25"));
  ASSERT_TRUE(made);
  // By hand: 0.18 + 0.0875 m²; up (0.0875·0.175 + 0.18·0.425)/0.2675; Steiner's theorem.
  const double area = 0.18 + 0.0875, up = (0.0875 * 0.175 + 0.18 * 0.425) / area;
  const double inertia = 0.25 * 0.042875 / 12 + 0.0875 * (up - 0.175) * (up - 0.175) + 1.2 * 0.003375 / 12 +
                         0.18 * (0.425 - up) * (0.425 - up);
  double found_area = 0, found = 0;
  const std::size_t beams = made->text.find("beams = [");
  ASSERT_EQ(std::sscanf(made->text.c_str() + beams, "beams = [\n  { area = %lf, inertia = %lf", &found_area, &found),
            2);
  EXPECT_NEAR(found_area, area, 1e-12);
  EXPECT_NEAR(found, 0.35 * inertia, 1e-12);
}

TEST(E2k, CommasMayBeDecimal) {
  std::string text = small_model;
  for (std::size_t at = text.find('.'); at != std::string::npos; at = text.find('.', at + 1)) {
    const auto line = text.begin() + static_cast<std::ptrdiff_t>(text.rfind('\n', at) + 1);  // of the first npos
    const bool is_quoted = std::count(line, text.begin() + static_cast<std::ptrdiff_t>(at), '"') % 2 != 0;
    if (!is_quoted && std::isdigit(static_cast<unsigned char>(text[at + 1])) != 0) text[at] = ',';
  }
  const auto with_commas = imported(text), with_points = imported(small_model);
  ASSERT_TRUE(with_commas);
  EXPECT_NE(text, small_model);
  EXPECT_EQ(with_commas->text, with_points->text);
  EXPECT_NE(import_errors(changed("HEIGHT 3.6", "HEIGHT 3,6")).find("has a decimal comma, line "), std::string::npos);
}

TEST(E2k, ErrorsNameLineAndWhatThereIs) {
  EXPECT_EQ(import_errors(small_model, {}), "small.e2k:1:1: error: frames stand at y = 0, 5: say which with --at\n");
  EXPECT_EQ(import_errors(small_model, {.at = 3}), "small.e2k:1:1: error: no frame stands at y = 3, there are 0, 5\n");
  EXPECT_EQ(import_errors(small_model, {.at = 5}), "small.e2k:1:1: error: the frame at y = 5 has no bay\n");
  EXPECT_EQ(import_errors(changed("HEIGHT 3.6", "HEIGHT x")),
            "small.e2k:9:1: error: HEIGHT = \"x\", must be a number\n");
  EXPECT_EQ(import_errors(changed("D 0.5 B 0.5", "D -0.5 B 0.5")), "small.e2k:19:1: error: D = -0.5, must be > 0\n");
  EXPECT_EQ(import_errors(changed("\"FIRST\"  SECTION \"C50\"", "\"FIRST\"  SECTION \"PIPE\"")),
            "small.e2k:22:1: error: section \"PIPE\" has the shape \"Pipe\", which is not known here: give "
            "--section PIPE=AREA,I33\n");
  EXPECT_NE(import_errors(changed("  LINEASSIGN  \"B2\"  \"ROOF\"  SECTION \"B30\"\n", ""))
                .find("has 1 beams in storey \"ROOF\""),
            std::string::npos);
  EXPECT_NE(import_errors(changed("\"KN\"", "\"DYN\"")).find("UNITS \"DYN\", must be one of"), std::string::npos);
  EXPECT_NE(import_errors(changed("E 3E7", "U 0.3")).find("has no E"), std::string::npos);
  EXPECT_NE(import_errors("").find("has no UNITS"), std::string::npos);
}

}  // namespace
}  // namespace bentur
