// Storeys that lose strength, as a case says them.
#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <vector>

#include "bentur/io/case/case_toml.h"
#include "bentur/model/case.h"

namespace bentur::backbone_reading {
namespace {

Case read(const std::string& text) {
  Diagnostics diagnostics;
  auto c = read_case_text(text, "backbone.toml", diagnostics);
  for (const Diagnostic& error : diagnostics.errors()) ADD_FAILURE() << error.text();
  return c ? *c : Case{};
}

/// A stick of three storeys that has these keys besides, and a neighbour.
std::string losing_case(const std::string& keys) {
  return "[units]\nlength = \"m\"\nforce = \"kN\"\n[[building]]\nname = \"A\"\ndamping = 0.05\n[building.stick]\n"
         "storey_heights = [3, 3, 3]\nmasses = [30, 30, 25]\nstiffnesses = [40e3, 40e3, 30e3]\n" +
         keys +
         "[[building]]\nname = \"B\"\ndamping = 0.05\n"
         "stick = { storey_heights = [3.0], masses = [20.0], stiffnesses = [60e3] }\n"
         "[[gap]]\nbetween = [\"A\", \"B\"]\nwidth = 0.02\ncontact = { law = \"linear\", stiffness = 3e5 }\n"
         "[excitation]\nkind = \"harmonic\"\nperiod = 0.4\ndisplacement_amplitude = 0.05\n[analysis]\nduration = 5.0\n";
}

TEST(BackboneReading, GivesStoreysThatLoseStrength) {
  const double infinity = std::numeric_limits<double>::infinity();
  const Case c = read(losing_case(
      "backbone = { yield = [400, inf, 200], cap = 1.2, plastic_drift = 0.03, softening_drift = [0.1, 0.2, 0.3], "
      "residual = 0.1, ultimate_drift = 0.4, hysteresis = \"pinching\", pinching_force = 0.3, cap_wear = 40, "
      "negative = { yield = [350, inf, 180], plastic_drift = 0.02 } }\n"));
  const auto& stick = std::get<Stick>(c.buildings[0].structure);
  ASSERT_TRUE(stick.backbone);
  EXPECT_EQ(stick.backbone->positive.yield, (std::vector<double>{400, infinity, 200}));
  EXPECT_EQ(stick.backbone->positive.softening, (std::vector<double>{0.1, 0.2, 0.3}));
  EXPECT_EQ(stick.backbone->negative->plastic, std::vector<double>{0.02});
  EXPECT_EQ(stick.backbone->reloading, Reloading::pinching);
  EXPECT_EQ(stick.backbone->pinching_force, 0.3);
  EXPECT_EQ(stick.backbone->pinching_deformation, 0.5);
  EXPECT_EQ(stick.backbone->deterioration.cap, 40);
  EXPECT_EQ(stick.backbone->deterioration.strength, infinity);
  const Building building = make_problem(c).buildings[0];
  EXPECT_TRUE(building.can_lose_strength());
  EXPECT_EQ(building.storey_law(0)->name(), "pinching");
  EXPECT_EQ(building.storey_law(1), nullptr);
  EXPECT_EQ(building.storey_law(2)->yield_deformation(), 200 / 30e3);
  EXPECT_FALSE(make_problem(read(losing_case("yield_forces = 300\n"))).buildings[0].can_lose_strength());
}

}  // namespace
}  // namespace bentur::backbone_reading
