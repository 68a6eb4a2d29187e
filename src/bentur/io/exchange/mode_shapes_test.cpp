#include "bentur/io/exchange/mode_shapes.h"

#include <gtest/gtest.h>

namespace bentur {
namespace {

using Shapes = std::vector<std::vector<double>>;

/// Three storeys, two modes of three, as ETABS has its table; written for this test.
const std::string storeys_and_modes = R"(TABLE:  Diaphragm Center Of Mass Displacements
Story,Diaphragm,Output Case,Case Type,Step Type,Step Number,UX,UY,RZ,Point,X,Y,Z
,,,,,,m,m,rad,,m,m,m
Story3,D1,Modal,LinModEigen,Mode,1,0.0012,0.1,0,1,5,5,10.5
Story3,D1,Modal,LinModEigen,Mode,2,0.0011,0.2,0,1,5,5,10.5
Story2,D1,Modal,LinModEigen,Mode,1,0.0009,0.3,0,2,5,5,7
Story2,D1,Modal,LinModEigen,Mode,2,-0.0005,0.4,0,2,5,5,7
Story1,D1,Modal,LinModEigen,Mode,1,0.0004,0.5,0,3,5,5,3.5
Story1,D1,Modal,LinModEigen,Mode,2,-0.0011,0.6,0,3,5,5,3.5
Story1,D1,Dead,LinStatic,,,0.5,0.6,0,3,5,5,3.5
)";

const ShapesAsked three_floors = {.elevations = {3.5, 7, 10.5}, .modes = 2};

Shapes shapes(const std::string& text, const ShapesAsked& asked) {
  Diagnostics diagnostics;
  const auto found = mode_shapes(text, "shapes.csv", asked, diagnostics);
  for (const Diagnostic& one : diagnostics.errors()) ADD_FAILURE() << one.text();
  return found.value_or(Shapes{});
}

std::string error_of(const std::string& text, const ShapesAsked& asked) {
  Diagnostics diagnostics;
  EXPECT_FALSE(mode_shapes(text, "shapes.csv", asked, diagnostics));
  EXPECT_EQ(diagnostics.errors().size(), 1U);
  return diagnostics.errors().empty() ? "" : diagnostics.errors()[0].text();
}

ShapesAsked along(const std::string& component, ShapesAsked asked = three_floors) {
  asked.component = component;
  return asked;
}

std::string changed(std::string text, const std::string& old, const std::string& made) {
  for (std::size_t at = text.find(old); at != std::string::npos; at = text.find(old, at + made.size())) {
    text.replace(at, old.size(), made);
  }
  return text;
}

TEST(ModeShapes, OfARowAStoreyAndMode) {
  EXPECT_EQ(shapes(storeys_and_modes, along("UX")), (Shapes{{0.0004, 0.0009, 0.0012}, {-0.0011, -0.0005, 0.0011}}));
  EXPECT_EQ(shapes(storeys_and_modes, along("UY")), (Shapes{{0.5, 0.3, 0.1}, {0.6, 0.4, 0.2}}));
  EXPECT_NE(error_of(storeys_and_modes, three_floors).find("say with shapes_column which"), std::string::npos);
}

TEST(ModeShapes, TabsAndDecimalCommasAreRead) {
  const std::string with_tabs = changed(changed(storeys_and_modes, ",", "\t"), ".", ",");
  EXPECT_EQ(shapes(with_tabs, along("UX")), shapes(storeys_and_modes, along("UX")));
}

TEST(ModeShapes, FloorsAreThoseOfTheirElevations) {
  ShapesAsked asked = along("UX");
  const Shapes expected = shapes(storeys_and_modes, asked);
  asked.elevations = {3500, 7000, 10500};  // a case in mm, the table in m
  asked.metre = 1000;
  EXPECT_EQ(shapes(storeys_and_modes, asked), expected);
  const std::string above_the_sea =
      changed(changed(changed(storeys_and_modes, ",10.5\n", ",112.5\n"), ",7\n", ",109\n"), ",3.5\n", ",105.5\n");
  EXPECT_EQ(shapes(above_the_sea, along("UX")), expected) << "by their distances from the highest";
  EXPECT_NE(error_of(changed(storeys_and_modes, ",7\n", ",6\n"), along("UX")).find("is of no floor of the case"),
            std::string::npos);
}

TEST(ModeShapes, ModesAreThoseThatAreNamed) {
  ShapesAsked asked = along("UX");
  asked.modes = 1;
  EXPECT_NE(error_of(storeys_and_modes, asked).find("has 2 modes, the case 1 period: say with shapes_modes"),
            std::string::npos);
  asked.numbers = {2};
  EXPECT_EQ(shapes(storeys_and_modes, asked), (Shapes{{-0.0011, -0.0005, 0.0011}}));
  asked.numbers = {5};
  EXPECT_NE(error_of(storeys_and_modes, asked).find("has no mode 5"), std::string::npos);
}

TEST(ModeShapes, RowsThatAreThereTwiceOrNotAtAllAreErrors) {
  const std::string row = "Story2,D1,Modal,LinModEigen,Mode,1,0.0009,0.3,0,2,5,5,7\n";
  EXPECT_NE(error_of(changed(storeys_and_modes, row, row + changed(row, "D1", "D2")), along("UX"))
                .find("\"Story2\" has mode 1 twice"),
            std::string::npos);
  EXPECT_NE(error_of(changed(storeys_and_modes, row, ""), along("UX")).find("has no row of mode 1 at the floor at 7"),
            std::string::npos);
  EXPECT_NE(error_of(changed(storeys_and_modes, "0.0009", "much"), along("UX")).find("UX = \"much\", must be a number"),
            std::string::npos);
  for (const std::string step : {"1.5", "-1", "4E780", "3E9", "nan"}) {
    const std::string odd = "Story2,D1,Modal,LinModEigen,Mode," + step + ",0.0009,0.3,0,2,5,5,7\n";
    EXPECT_NE(error_of(changed(storeys_and_modes, row, odd), along("UX"))
                  .find("has the step \"" + step + "\", must be the number of a mode"),
              std::string::npos)
        << step;
  }
}

TEST(ModeShapes, OfJointsAsSap2000HasThem) {
  const std::string table = R"(TABLE:  "Joint Displacements"
Joint,OutputCase,CaseType,StepType,StepNum,U1,U2,U3,R1,R2,R3
Text,Text,Text,Text,Unitless,m,m,m,Radians,Radians,Radians
12,MODAL,LinModal,Mode,1,0.9,0,0,0,0,0
24,MODAL,LinModal,Mode,1,0.4,0,0,0,0,0
99,MODAL,LinModal,Mode,1,7,0,0,0,0,0
)";
  ShapesAsked asked = {.elevations = {3, 6}, .modes = 1, .names = {"24", "12"}, .component = "U1"};
  EXPECT_EQ(shapes(table, asked), (Shapes{{0.4, 0.9}}));
  asked.names.clear();
  EXPECT_NE(error_of(table, asked).find("has no elevation (Z): give floor_names"), std::string::npos);
}

TEST(ModeShapes, NamesOfFloorsBeforeTheModes) {
  const std::string roof_first = "Story,Mode 1,Mode 2\nStory3,1.2,1.1\nStory2,0.9,-0.5\nStory1,0.4,-1.1\n";
  const Shapes expected = {{0.4, 0.9, 1.2}, {-1.1, -0.5, 1.1}};
  EXPECT_EQ(shapes(roof_first, three_floors), expected);
  EXPECT_EQ(shapes("Story,Mode 1,Mode 2\nL1,0.4,-1.1\nL2,0.9,-0.5\nL3,1.2,1.1\n", three_floors), expected);
  const std::string words = "Roof,1.2,1.1\nMezzanine,0.9,-0.5\nGround,0.4,-1.1\n";
  EXPECT_NE(error_of(words, three_floors).find("do not say which is the lower one: give floor_names"),
            std::string::npos);
  ShapesAsked named = three_floors;
  named.names = {"Ground", "Mezzanine", "Roof"};
  EXPECT_EQ(shapes(words, named), expected);
  EXPECT_EQ(shapes("Roof,10.5,1.2,1.1\nGround,3.5,0.4,-1.1\nMezzanine,7,0.9,-0.5\n", three_floors), expected)
      << "as elevations say";
  EXPECT_NE(error_of("Roof,1.2,1.1\nMezzanine,1,1\n0.9,-0.5\n", named).find("has no name"), std::string::npos);
  EXPECT_EQ(shapes("Elevation,1,2\n3.5,0.4,-1.1\n7,0.9,-0.5\n10.5,1.2,1.1\n", three_floors), expected)
      << "numbers of modes are a heading";
  EXPECT_EQ(shapes("mode 1\n0.4\n0.9\n1.2\n", {.elevations = {3.5, 7, 10.5}, .modes = 1}), (Shapes{{0.4, 0.9, 1.2}}));
}

TEST(ModeShapes, WhatIsOfOtherTablesIsRefused) {
  EXPECT_NE(error_of("0.4,-1.1\n0.9,-0.5\n1.2,1.1\n", along("UX")).find("is no table of a row a storey and mode"),
            std::string::npos);
}

ShapesAsked in_plan(std::size_t modes) {
  return {.elevations = {3.5, 7}, .modes = modes, .metre = 100, .in_plan = true};
}

/// In centimetres, of a table in metres or millimetres: rotations are radians in both.
TEST(ModeShapes, InPlanHaveRotationsAndTheUnitOfTheirDisplacements) {
  const std::string table = R"(Story,Step Number,UX,UY,RZ,Z
,,m,m,rad,m
Story2,1,0.2,0.01,0.03,7
Story1,1,0.1,0.02,0.04,3.5
)";
  const ShapesAsked asked = {.elevations = {350, 700}, .modes = 1, .metre = 100, .in_plan = true};
  const Shapes expected = {{10, 2, 0.04, 20, 1, 0.03}};
  EXPECT_EQ(shapes(table, asked), expected);
  const Shapes thousandth = shapes(changed(table, ",,m,m,rad,m\n", ",,mm,mm,rad,m\n"), asked);
  ASSERT_EQ(thousandth.size(), 1U);
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_DOUBLE_EQ(thousandth[0][i], expected[0][i] * (i % 3 == 2 ? 1 : 0.001)) << i;
  }
  const std::string joints = changed(
      changed(changed(changed(table, "Story2", "12"), "Story1", "7"), "UX,UY,RZ,Z", "U1,U2,R3,Z"), "Story,", "Joint,");
  ShapesAsked named = asked;
  named.names = {"7", "12"};
  EXPECT_EQ(shapes(joints, named), expected);
  EXPECT_NE(error_of(changed(table, "RZ", "RY"), asked).find("has no column RZ"), std::string::npos);
  EXPECT_NE(error_of(changed(table, "0.04", "x"), asked).find("RZ = \"x\", must be a number"), std::string::npos);
}

TEST(ModeShapes, InPlanOfARowAFloorHaveThreeColumnsAMode) {
  EXPECT_EQ(shapes("7,1,2,3,4,5,6\n3.5,7,8,9,10,11,12\n", in_plan(2)),
            (Shapes{{7, 8, 9, 1, 2, 3}, {10, 11, 12, 4, 5, 6}}));
  EXPECT_NE(error_of("1,2\n3,4\n", in_plan(2)).find("expected 6 (three, UX, UY and RZ, per period"), std::string::npos);
}

}  // namespace
}  // namespace bentur
