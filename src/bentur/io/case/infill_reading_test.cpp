// Infill of frames, as a case says it.
#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <vector>

#include "bentur/io/case/case_toml.h"
#include "bentur/model/case.h"

namespace bentur::infill_reading {
namespace {

Case read(const std::string& text) {
  Diagnostics diagnostics;
  auto c = read_case_text(text, "infill.toml", diagnostics);
  for (const Diagnostic& error : diagnostics.errors()) ADD_FAILURE() << error.text();
  return c ? *c : Case{};
}

/// A frame of two storeys that has these keys besides, and a neighbour.
std::string filled_case(const std::string& keys) {
  return "[units]\nlength = \"m\"\nforce = \"kN\"\n[[building]]\nname = \"A\"\ndamping = 0.05\n[building.frame]\n"
         "elastic_modulus = 2.5e7\nstorey_heights = [3, 3]\nbay_widths = [5, 4]\nfloor_masses = 30\n"
         "columns = [{ width = 0.4, depth = 0.4, mass = 1 }]\nbeams = [{ width = 0.3, depth = 0.5, mass = 1 }]\n" +
         keys +
         "[[building]]\nname = \"B\"\ndamping = 0.05\n"
         "stick = { storey_heights = [3.0], masses = [20.0], stiffnesses = [60e3] }\n"
         "[[gap]]\nbetween = [\"A\", \"B\"]\nwidth = 0.02\ncontact = { law = \"linear\", stiffness = 3e5 }\n"
         "[excitation]\nkind = \"harmonic\"\nperiod = 0.4\ndisplacement_amplitude = 0.05\n[analysis]\nduration = 5.0\n";
}

TEST(InfillReading, GivesEachStoreyItsOwn) {
  const double infinity = std::numeric_limits<double>::infinity();
  const Case c = read(
      filled_case("infill = [{}, { thickness = 0.15, modulus = 3e6, strength = 3e3, sliding_strength = 200, cap = 1.1, "
                  "plastic_drift = 0.01, softening_drift = 0.03, residual = 0.2, ultimate_drift = 0.08 }]\n"));
  const auto& infills = std::get<PlaneFrame>(c.buildings[0].structure).infills;
  ASSERT_EQ(infills.size(), 2U);
  EXPECT_FALSE(infills[0]);
  EXPECT_EQ(infills[1]->thickness, 0.15);
  EXPECT_EQ(infills[1]->modulus, 3e6);
  EXPECT_EQ(infills[1]->strength, 3e3);
  EXPECT_EQ(infills[1]->sliding_strength, 200);
  EXPECT_EQ(infills[1]->backbone,
            (Backbone{.yield = 0, .cap = 1.1, .plastic = 0.01, .softening = 0.03, .residual = 0.2, .ultimate = 0.08}));
  const Building building = make_problem(c).buildings[0];
  ASSERT_EQ(building.elements.size(), 2U);
  EXPECT_EQ(building.elements[0].law->name(), "strut-pair");
  EXPECT_FALSE(building.can_lose_strength()) << "no storey has a law of its own";

  const Case all = read(filled_case("infill = [{ stiffness = 2e4, yield = inf }]\n"));
  const auto& same = std::get<PlaneFrame>(all.buildings[0].structure).infills;
  ASSERT_EQ(same.size(), 2U);
  EXPECT_EQ(same[1]->backbone.yield, infinity);
  EXPECT_EQ(same[0]->stiffness, 2e4);
  EXPECT_FALSE(make_problem(all).buildings[0].can_yield());
  EXPECT_TRUE(std::get<PlaneFrame>(read(filled_case("")).buildings[0].structure).infills.empty());
}

TEST(InfillReading, ScalesWithThePeriodButKeepsItsStrength) {
  const std::string panel = "infill = [{ stiffness = 2e4, yield = 40 }]\n";
  std::string text = filled_case(panel);
  text.replace(text.find("damping"), 0, "calibrate_period = 0.5\n");
  const Building building = make_problem(read(text)).buildings[0];
  EXPECT_NEAR(2 * 3.14159265358979323846 / building.first_omega(), 0.5, 1e-12);
  const double factor = *building.model.stiffness_factor;
  ASSERT_EQ(building.elements.size(), 4U);
  EXPECT_NEAR(building.elements[0].law->initial_stiffness(), 2e4 * factor, 1e-9 * 2e4 * factor);
  EXPECT_NEAR(building.elements[0].law->yield_deformation(), 40 / (2e4 * factor), 1e-12);
}

}  // namespace
}  // namespace bentur::infill_reading
