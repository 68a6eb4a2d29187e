// How peaks change, in the report of a run.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "bentur/io/case/case_toml.h"
#include "bentur/io/toml/toml_value.h"
#include "bentur/report/html/internal/sections.h"
#include "bentur/report/kinds/sensitivity_figure.h"

namespace bentur {
namespace {

const std::filesystem::path sensitive = std::filesystem::path(BENTUR_SOURCE_DIR) / "examples" / "m12-el-centro.toml";

Sensitivity sensitivity_of_example() {
  std::ostringstream text;
  text << std::ifstream(sensitive).rdbuf();
  Diagnostics diagnostics;
  const auto root = parse_toml(text.str(), sensitive.string(), diagnostics);
  auto found = sensitivity_of(*root, sensitive, {}, diagnostics);
  EXPECT_TRUE(diagnostics.ok());
  return std::move(found.value());
}

Case case_of_example() {
  Diagnostics diagnostics;
  return read_case(sensitive, diagnostics).value();
}

TEST(SensitivitySection, HasAllThatTheCommandSaysAndAPicture) {
  const Sensitivity found = sensitivity_of_example();
  for (const std::string language : {"en", "id"}) {
    const Words say(language);
    const std::string page = html::sensitivity_section(found, case_of_example(), say, language).content.str();
    // In the words of the keys, of which a pointer shows the way to the number.
    EXPECT_NE(
        page.find(
            language == "en"
                ? "title=\"building[0].frame.columns[0].depth\" data-head=\"Number\">Model 1, Frame: Columns 1: Depth"
                : "title=\"building[0].frame.columns[0].depth\" data-head=\"Angka\">Model 1, Portal: Kolom 1:"),
        std::string::npos)
        << page;
    EXPECT_EQ(page.find(">building["), std::string::npos);
    EXPECT_EQ(page.find("excitation.delays[1]<"), std::string::npos);
    EXPECT_NE(page.find("<svg"), std::string::npos);
    EXPECT_EQ(page.find("Peak force") == std::string::npos, language == "id");
  }
}

/// A table by buildings has no keys of their names.
TEST(SensitivitySection, NamesTheBuildingOfAnInitialVelocity) {
  Sensitivity found = sensitivity_of_example();
  Case c = case_of_example();
  c.buildings.front().name = "Left";
  for (CaseNumber& number : found.numbers) {
    if (number.path == "building[0].frame.columns[0].depth") number.path = "initial.velocities.Left[0]";
  }
  const std::string page = html::sensitivity_section(found, c, Words("en"), "en").content.str();
  EXPECT_NE(page.find(">Initial state: Velocities, Left 1<"), std::string::npos) << page;
}

TEST(SensitivitySection, ItsPictureHasTheNumbersThatAGapChangesMostWith) {
  const Sensitivity found = sensitivity_of_example();
  const Figure figure = sensitivity_figure(found);
  ASSERT_EQ(figure.panels.size(), 1U);
  const Panel& panel = figure.panels.front();
  ASSERT_EQ(panel.texts.size(), 8U);
  EXPECT_EQ(panel.texts.back().text, "excitation.delays[1]");  // uppermost: as the words have it
  // Of both peaks a bar from zero to the elasticity.
  std::vector<double> ends, expected;
  for (const Curve& bar : panel.curves) {
    if (bar.top.empty()) continue;  // the axis
    EXPECT_TRUE(bar.x.front() == 0 || bar.x.back() == 0);
    ends.push_back(bar.x.front() + bar.x.back());
  }
  for (const SensitivePeak& peak : found.peaks) {
    if (!peak.is_largest || peak.name != panel.title) continue;
    for (const PlaceText& text : panel.texts) {
      const auto number = std::find_if(found.numbers.begin(), found.numbers.end(),
                                       [&](const CaseNumber& one) { return one.path == text.text; });
      expected.push_back(found.elasticity(peak, static_cast<std::size_t>(number - found.numbers.begin())));
    }
  }
  // The axis is beside bars alone, so that it strikes through no name.
  const auto axis =
      std::find_if(panel.curves.begin(), panel.curves.end(), [](const Curve& one) { return one.top.empty(); });
  ASSERT_NE(axis, panel.curves.end());
  EXPECT_TRUE(panel.rules.empty());
  const PanelPlace place = placed_figure(figure, "").panels.front();
  const double high = 0.15 * (96 / 2.54) * (place.y.second - place.y.first) / place.height;  // half a name
  for (std::size_t i = 0; i + 1 < axis->y.size(); i += 3) {
    for (const PlaceText& text : panel.texts) {
      EXPECT_TRUE(text.y - high >= axis->y[i + 1] || text.y + high <= axis->y[i]) << text.text;
    }
  }
  std::sort(ends.begin(), ends.end());
  std::sort(expected.begin(), expected.end());
  EXPECT_EQ(ends, expected);
}

}  // namespace
}  // namespace bentur
