#include <gtest/gtest.h>

#include <cmath>

#include "bentur/files/netcdf.h"
#include "bentur/io/temporary_folder.h"
#include "bentur/report/figures/internal/layout.h"
#include "bentur/report/studies/file_kinds.h"

namespace bentur {
namespace {

constexpr std::size_t values = 6;

/// A study of two parameters: impacts below the diagonal alone, one of them far more than all others, and ratios from 1
/// to 6.
std::filesystem::path write_study(const std::filesystem::path& folder, const std::string& unit, double force) {
  const std::filesystem::path path = folder / "sweep.nc";
  NetcdfWriter file(path.string());
  const ResultDimension width{"width", values}, period{"period", values}, point{"point", 2}, floor{"elevation_1", 1};
  std::vector<double> widths, periods, impacts, ratios, forces, first, second;
  for (std::size_t i = 0; i < values; ++i) {
    widths.push_back(0.1 * static_cast<double>(i));
    periods.push_back(0.5 + 0.1 * static_cast<double>(i));
    for (std::size_t j = 0; j < values; ++j) {
      const double some = i == 0 && j == values - 1 ? 2000 : 3;
      impacts.insert(impacts.end(), {j > i ? some : 0, 0});
      forces.insert(forces.end(), {j > i ? force : 0, 0});
      ratios.push_back(j > i ? 6 : 1);
      first.push_back(static_cast<double>(1 + i + j));
      second.push_back(static_cast<double>(5 + 3 * i + j));
    }
  }
  file.add({"width", {width}, "m", "gap[0].width", {}, widths});
  file.add({"period", {period}, "s", "excitation.period", {}, periods});
  file.add({"elevation_1", {floor}, "mm", "elevation of the floors of building \"A\"", {}, std::vector{11000.0}});
  file.add({"point_elevation", {point}, "mm", "elevation of the contact points", {}, std::vector{11004.0, 11007.0}});
  file.add({"impacts", {width, period, point}, "1", "impacts", {}, impacts});
  file.add({"peak_force", {width, period, point}, unit, "largest force", {}, forces});
  file.add({"acceleration_ratio_1", {width, period, floor}, "1", "ratio", {}, ratios});
  file.add({"elevation_2",
            {{"elevation_2", 1}},
            "mm",
            "elevation of the floors of building \"B\"",
            {},
            std::vector{8000.0}});
  file.add({"peak_displacement_1", {width, period, floor}, "m", "displacement", {}, first});
  file.add({"peak_displacement_2", {width, period, {"elevation_2", 1}}, "m", "displacement", {}, second});
  file.add({"status", {width, period}, "", "how the run ended", {}, std::vector<signed char>(values * values)});
  file.finish();
  return path;
}

TEST(SweepPictures, CellsWithoutContactHaveATintOfTheirOwn) {
  const TemporaryFolder folder;
  const NetcdfReader results(write_study(folder.path(), "N", 5e5));
  const Figure figure = make_figure(results, "impacts");
  const Panel& panel = figure.panels.at(0);
  ASSERT_TRUE(panel.map.has_value());
  std::size_t known = 0;
  for (const double value : panel.map->values) known += std::isfinite(value) ? 1 : 0;
  EXPECT_EQ(known, values * (values - 1) / 2);
  ASSERT_EQ(panel.curves.size(), 1U);
  EXPECT_EQ(panel.curves[0].label, "no contact");
  EXPECT_EQ(panel.curves[0].x.size(), 3 * (values * values - known));
  const Layout placing = layout(figure);
  const Ticks& scale = placing.panels.at(0).scale;
  EXPECT_TRUE(scale.logarithmic) << "3 and 2000";
  EXPECT_DOUBLE_EQ(scale.to, 2000) << "nothing is clipped, and no colour is of no cell";
  EXPECT_DOUBLE_EQ(scale.from, 3);
  EXPECT_GE(scale.labels.size(), 2U);
}

/// The same colour is the same displacement in the maps of both buildings, which one compares.
TEST(SweepPictures, MapsOfTwoBuildingsHaveOneScale) {
  const TemporaryFolder folder;
  const NetcdfReader results(write_study(folder.path(), "N", 5e5));
  const Figure figure = make_figure(results, "displacement");
  const Layout placing = layout(figure);
  ASSERT_EQ(placing.panels.size(), 2U);
  for (const PlacedPanel& panel : placing.panels) {
    EXPECT_EQ(panel.scale.from, placing.panels.front().scale.from);
    EXPECT_EQ(panel.scale.to, placing.panels.front().scale.to);
    EXPECT_GE(panel.scale.to, 25) << "the largest of B; that of A is 11";
  }
}

TEST(SweepPictures, AMapOfRatiosUsesItsColours) {
  const TemporaryFolder folder;
  const NetcdfReader results(write_study(folder.path(), "N", 5e5));
  const Figure figure = make_figure(results, "acceleration-ratio");
  const Layout placing = layout(figure);
  const Ticks& scale = placing.panels.at(0).scale;
  EXPECT_EQ(scale.from, 1);
  EXPECT_EQ(scale.to, 6);
  const HeatMap& map = *figure.panels.at(0).map;
  EXPECT_DOUBLE_EQ(colour_at(map, scale, 0), 0.5) << "1 is in the middle of the colours";
  EXPECT_DOUBLE_EQ(colour_at(map, scale, 1), 1);
}

TEST(SweepPictures, ForcesInNewtonsAreInKilonewtonsFromFiveDigitsOn) {
  for (const auto& [unit, force, shown] : {std::tuple("N", 5e5, "Peak contact force F [kN]"),
                                           {"N", 5e3, "Peak contact force F [N]"},
                                           {"kgf", 5e5, "Peak contact force F [kgf]"}}) {
    const TemporaryFolder folder;
    const NetcdfReader results(write_study(folder.path(), unit, force));
    const Figure figure = make_figure(results, "peak-force");
    EXPECT_EQ(figure.panels[0].map->label, shown);
    EXPECT_NE(figure.finding.find(force == 5e5 && std::string(unit) == "N" ? "largest 500 kN" : "largest 5"),
              std::string::npos)
        << figure.finding;
  }
}

/// Three digits would make one level of two.
TEST(SweepPictures, LevelsHaveAllTheirDigits) {
  const TemporaryFolder folder;
  const NetcdfReader results(write_study(folder.path(), "N", 5e5));
  FigureOptions options;
  options.at = {{"period", "1"}};
  const Figure figure = make_figure(results, "peak-force", options);
  ASSERT_EQ(figure.panels[0].curves.size(), 2U);
  EXPECT_EQ(figure.panels[0].curves[0].label, "z = 11004 mm");
  EXPECT_EQ(figure.panels[0].curves[1].label, "z = 11007 mm");
}

}  // namespace
}  // namespace bentur
