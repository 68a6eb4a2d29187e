#include "bentur/io/schema/parameter_units.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "bentur/io/toml/parameter_path.h"
#include "tests/reference/shared_folder.h"

namespace bentur {
namespace {

const char* const units_case = R"(
[[building]]
name = "Model 1"
damping = 0.05
frame = { beams = [{ mass = 0.2 }, { mass = 0.3 }] }
[[gap]]
width = 0.2
contact = { law = "linear", stiffness = [1, 2] }
[[gap]]
contact = { law = "hertz", stiffness = 3.0 }
[initial]
displacements = { "Model 1" = [1, 2] }
)";

TEST(ParameterUnits, KnowTheUnitOfANumber) {
  Diagnostics diagnostics;
  const TomlValue root = parse_toml(units_case, "case.toml", diagnostics).value();
  const Units units{.length = "cm", .force = "tf"};
  const auto unit = [&](const char* name) {
    std::string error;
    return parameter_units(*parse_path(name, error), root, units);
  };
  EXPECT_EQ(unit("gap[0].width"), "cm");
  EXPECT_EQ(unit("building[0].frame.beams[0].mass"), "1000 kgf s2 cm-1");
  EXPECT_EQ(unit("building[0].frame.beams[0].width"), "cm");
  EXPECT_EQ(unit("building[0].damping"), "1");
  EXPECT_EQ(unit("building[0].frame.elastic_modulus"), "1000 kgf cm-2");
  EXPECT_EQ(unit("excitation.pga"), "cm s-2");
  EXPECT_EQ(unit("initial.displacements[\"Model 1\"][0]"), "cm");
  EXPECT_EQ(unit("gap[0].contact.stiffness[1]"), "1000 kgf cm-1");
  EXPECT_EQ(unit("gap[1].contact.stiffness"), "");  // force/length^1.5, which UDUNITS does not have
  EXPECT_EQ(unit("building[0].stick.yield_forces[1]"), "1000 kgf");
  EXPECT_EQ(unit("building[0].stick.hardening"), "1");
  EXPECT_EQ(unit("building[0].stick.unloading_exponent"), "1");
  EXPECT_EQ(unit("building[0].damping.stiffness_proportional"), "1");
  EXPECT_EQ(unit("building[0].generic.storey_height"), "cm");
  EXPECT_EQ(unit("building[0].soil.rocking.damping"), "1000 kgf s cm");
  EXPECT_EQ(unit("building[0].soil.foundation.inertia"), "1000 kgf s2 cm");
  EXPECT_EQ(unit("building[0].isolation.friction_pendulum.radius"), "cm");
  EXPECT_EQ(unit("link[0].stiffness"), "1000 kgf cm-1");
  EXPECT_EQ(unit("link[0].damping[1]"), "1000 kgf s cm-1");
  EXPECT_EQ(unit("link[1].yield_force"), "1000 kgf");
  EXPECT_EQ(unit("link[1].slack"), "cm");
  EXPECT_EQ(unit("initial.velocities.A[0][1]"), "cm s-1");
  EXPECT_EQ(unit("initial.velocities.A[0][2]"), "s-1");  // a rotation
  EXPECT_EQ(unit("initial.velocities.A[2]"), "cm s-1");
  EXPECT_EQ(unit("building[0].plan.inertias[1]"), "1000 kgf s2 cm");
  EXPECT_EQ(unit("building[0].rigidity.torsion"), "1000 kgf cm");
  EXPECT_EQ(unit("building[0].plane[0].angle"), "");
  EXPECT_EQ(unit("excitation.file"), "");
}

std::string in_units(const std::string& text, const char* length, const char* force) {
  Diagnostics diagnostics;
  const auto made = text_in_units(text, "case.toml", length, force, diagnostics);
  EXPECT_TRUE(diagnostics.ok());
  return made.value_or("");
}

TEST(TextInUnits, ChangesNumbersAndUnitsAlone) {
  const std::string text =
      "\xEF\xBB\xBFtitle = \"Süd 3\" # 3 m\r\n[units]\nlength = 'cm' # of all\nforce = \"kgf\"\ngravity = 980.0\n"
      "[[gap]]\nwidth = [0.2, 3]# 3\ncontact = { \"law\" = \"hertz\", stiffness = +2e6 }\n[excitation]\nperiod = 0.3\n"
      "delays = [0, 1]\nunit = \"g\"\npga = 341.7";
  EXPECT_EQ(in_units(text, "m", "kgf"),
            "\xEF\xBB\xBFtitle = \"Süd 3\" # 3 m\r\n[units]\nlength = \"m\" # of all\nforce = \"kgf\"\ngravity = 9.8\n"
            "[[gap]]\nwidth = [0.002, 0.03]# 3\ncontact = { \"law\" = \"hertz\", stiffness = 2000000000.0 }\n"
            "[excitation]\nperiod = 0.3\ndelays = [0, 1]\nunit = \"g\"\npga = 3.417");
  EXPECT_EQ(in_units("x = [[1]]\ny = { \"ä\" = 1 }\n", "m", "N"), "x = [[1]]\ny = { \"ä\" = 1 }\n");
}

TEST(TextInUnits, SaysTheUnitsWhereTheTextDoesNot) {
  for (const char* const text :
       {"title = \"A\"\n\n[[gap]]\nwidth = 1.0\n", "gap = [{ width = 1.0 }]", "[units]\n[[gap]]\nwidth = 1.0\n",
        "[units]\nlength = \"m\"\n[[gap]]\nwidth = 1.0", "units = { force = \"N\" }\ngap = [{ width = 1.0 }]",
        "units.length = \"m\"\n[[gap]]\nwidth = 1.0", "[units]\ngravity = 9.81\n[[gap]]\nwidth = 1.0"}) {
    const std::string made = in_units(text, "mm", "kip");
    Diagnostics diagnostics;
    const auto root = parse_toml(made, "case.toml", diagnostics);
    ASSERT_TRUE(root) << made;
    const TomlValue* units = root->find("units");
    ASSERT_NE(units, nullptr) << made;
    EXPECT_EQ(units->find("length")->text, "mm") << made;
    EXPECT_EQ(units->find("force")->text, "kip") << made;
    EXPECT_EQ(root->find("gap")->items[0].find("width")->real, 1000) << made;
    EXPECT_EQ(root->find("title") != nullptr, std::string(text).starts_with("title")) << made;
  }
}

TEST(TextInUnits, IsTheSameFromThereAndBack) {
  const std::string text =
      "[units]\nlength = \"m\"\nforce = \"kN\"\n[[gap]]\nwidth = [3.2, 1e-7, -0.04, 12]\n"
      "contact = { law = \"jankowski\", stiffness = 7.25e9 }\n[initial.velocities]\n\"A\" = 0.3\n";
  for (const std::string& length : length_units()) {
    for (const std::string& force : force_units()) {
      Diagnostics diagnostics;
      const std::string back = in_units(in_units(text, length.c_str(), force.c_str()), "m", "kN");
      const TomlValue first = parse_toml(text, "", diagnostics).value(),
                      second = parse_toml(back, "", diagnostics).value();
      std::string error;
      for (const char* const name : {"gap[0].width[0]", "gap[0].width[1]", "gap[0].width[2]", "gap[0].width[3]",
                                     "gap[0].contact.stiffness", "initial.velocities.A"}) {
        EXPECT_EQ(find_value(first, *parse_path(name, error))->real, find_value(second, *parse_path(name, error))->real)
            << name << " by way of " << length << ", " << force;
      }
    }
  }
}

/// Every number of a value, in its order.
void numbers_of(const TomlValue& value, std::vector<double>& numbers) {
  if (value.is_number()) numbers.push_back(value.real);
  for (const TomlMember& member : value.members) {
    if (member.key != "units") numbers_of(member.value, numbers);
  }
  for (const TomlValue& item : value.items) numbers_of(item, numbers);
}

TEST(TextInUnits, EveryExampleAndReferenceCaseComesBackAsItWas) {
  namespace fs = std::filesystem;
  const fs::path root = BENTUR_SOURCE_DIR;
  std::size_t cases = 0;
  for (const fs::path& folder : {root / "examples", root / "examples" / "gaps", root / "examples" / "monograph",
                                 test::shared_folder() / "reference", root / "tests" / "reference"}) {
    if (!fs::is_directory(folder)) continue;
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
      if (entry.path().extension() != ".toml") continue;
      SCOPED_TRACE(entry.path().string());
      std::ifstream stream(entry.path(), std::ios::binary);
      const std::string text{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
      Diagnostics diagnostics;
      const TomlValue first = parse_toml(text, "", diagnostics).value();
      if (first.find("building") == nullptr) continue;  // a study
      ++cases;
      const TomlValue* const units = first.find("units");
      const auto stated = [&](const char* key, const char* otherwise) {
        const TomlValue* const given = units == nullptr ? nullptr : units->find(key);
        return given == nullptr ? std::string(otherwise) : given->text;
      };
      const std::string back =
          in_units(in_units(text, "ft", "kip"), stated("length", "m").c_str(), stated("force", "N").c_str());
      std::vector<double> before, after;
      numbers_of(first, before);
      numbers_of(parse_toml(back, "", diagnostics).value(), after);
      EXPECT_EQ(before, after);
    }
  }
  EXPECT_GE(cases, 16U);
}

TEST(TextInUnits, RefusesWhatHasNoUnits) {
  for (const char* const text : {"x = ", "[units]\nlength = \"mile\"", "[units]\nforce = 3"}) {
    Diagnostics diagnostics;
    EXPECT_FALSE(text_in_units(text, "case.toml", "m", "N", diagnostics)) << text;
    EXPECT_FALSE(diagnostics.ok()) << text;
  }
}

}  // namespace
}  // namespace bentur
