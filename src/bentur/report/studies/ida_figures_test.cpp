#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "bentur/files/netcdf.h"
#include "bentur/io/temporary_folder.h"
#include "bentur/report/figures/internal/layout.h"
#include "bentur/report/kinds/internal/run_figures.h"
#include "bentur/report/studies/file_kinds.h"

namespace bentur {
namespace {

constexpr int records = 3;
constexpr int levels = 4;
constexpr int widths = 2;

/// Peak force of a made-up run: none below a level that grows with record and width, then a line.
double force(int record, int level, int width) { return std::max(0, (record + 1) * (level - width) * 10); }

/// Results as docs/studies.md has them: record × width × intensity × point.
/// @param step at the first width all records pound from the second level on
/// @param collapses whether the last record collapses at the highest level
std::filesystem::path write_results(const std::filesystem::path& folder, bool step = false, int records = 3,
                                    bool collapses = false) {
  const std::filesystem::path path = folder / "ida.nc";
  NetcdfWriter file(path.string());
  const ResultDimension record{"record", static_cast<std::size_t>(records)}, width{"width", widths},
      intensity{"intensity", levels}, point{"point", 1};
  const std::string measure = "spectral acceleration, period 1.2 s, damping 5 %";
  std::vector<std::string> names;
  for (int r = 0; r < records; ++r) names.push_back(std::string(1, static_cast<char>('a' + r)));
  file.add({"record", {record}, "", "excitation.file", {}, names});
  file.add({"width", {width}, "m", "gap[0].width", {}, std::vector{0.1, 0.2}});
  file.add({"intensity", {intensity}, "gravity", measure, {}, std::vector{0.5, 1.0, 1.5, 2.0}});
  file.add({"record_intensity", {record}, "gravity", measure, {}, std::vector<double>(names.size(), 1.0)});
  std::vector<double> forces, impacts;
  for (int r = 0; r < records; ++r) {
    for (int w = 0; w < widths; ++w) {
      for (int level = 0; level < levels; ++level) {
        forces.push_back(force(r, level, w));
        // The higher the level the more records pound: 0, 1, 2, 3 at width 0, one less at the other.
        impacts.push_back(r < (step && w == 0 ? records * level : level - w) ? 2 : 0);
      }
    }
  }
  file.add({"peak_force", {record, width, intensity, point}, "kN", "largest force", {}, forces});
  file.add({"impacts", {record, width, intensity, point}, "1", "impacts", {}, impacts});
  const ResultDimension floor{"elevation_1", 1};
  std::vector<double> drifts(forces.size(), 0.015);
  file.add({"peak_drift_ratio_1", {record, width, intensity, floor}, "1", "largest drift", {}, drifts});
  file.add(
      {"status", {record, width, intensity}, "", "how the run ended", {}, std::vector<signed char>(forces.size())});
  if (collapses) {
    std::vector<signed char> collapsed(forces.size(), 0);
    for (int w = 0; w < widths; ++w) collapsed[collapsed.size() - 1 - static_cast<std::size_t>(w * levels)] = 1;
    file.add({"collapsed", {record, width, intensity}, "", "whether a storey collapsed", {}, collapsed});
  }
  file.finish();
  return path;
}

const Curve& labelled(const Figure& figure, const std::string& label) {
  for (const Curve& curve : figure.panels.at(0).curves) {
    if (curve.label == label) return curve;
  }
  throw std::runtime_error("no curve " + label);
}

TEST(IdaFigure, FractilesOfTheRecords) {
  const TemporaryFolder folder;
  constexpr int count = 7;
  const NetcdfReader results(write_results(folder.path(), false, count));
  FigureOptions options;
  options.at = {{"width", "0.1"}};
  const Figure figure = make_figure(results, "ida", options);
  EXPECT_EQ(figure.panels[0].y.label, "Intensity Sa (1.2 s, 5 %) [g]");
  EXPECT_EQ(figure.panels[0].curves.size(), count + 3U);
  EXPECT_EQ(figure.lacks, "");
  const Curve& median = labelled(figure, "50 %");
  const Curve& low = labelled(figure, "16 %");
  EXPECT_EQ(median.y, (std::vector<double>{0.5, 1, 1.5, 2}));
  for (int level = 0; level < levels; ++level) {
    const auto i = static_cast<std::size_t>(level);
    EXPECT_EQ(median.x[i], force(3, level, 0));
    EXPECT_NEAR(low.x[i], force(0, level, 0) + 0.96 * (force(1, level, 0) - force(0, level, 0)), 1e-12);
  }
  EXPECT_THROW(static_cast<void>(make_figure(results, "ida")), NoFigure);  // which width?
}

/// The 16 % fractile of three records would be below all of them.
TEST(IdaFigure, HasNoFractilesOfFewRecords) {
  const TemporaryFolder folder;
  FigureOptions options;
  options.at = {{"width", "0.1"}};
  const Figure figure = make_figure(NetcdfReader(write_results(folder.path())), "ida", options);
  EXPECT_EQ(figure.panels[0].curves.size(), 3U);
  EXPECT_EQ(figure.panels[0].curves[0].label, "3 records");
  EXPECT_EQ(figure.lacks, "fractiles");  // which the caption of a page then does not name
}

/// Of the records the median and what lies between 16 and 84 %, in place of those of one of them.
TEST(IdaFigure, OtherQuantitiesAreToldOverTheRecords) {
  const TemporaryFolder folder;
  const NetcdfReader results(write_results(folder.path()));
  FigureOptions options;
  options.at = {{"width", "0.1"}};
  const Figure figure = make_figure(results, "peak-force", options);
  const Curve& median = labelled(figure, "median of 3 records");
  const Curve& band = labelled(figure, "16 to 84 %");
  EXPECT_EQ(median.x, (std::vector<double>{0.5, 1, 1.5, 2}));
  for (int level = 0; level < levels; ++level) {
    const auto i = static_cast<std::size_t>(level);
    EXPECT_EQ(median.y[i], force(1, level, 0));
    EXPECT_NEAR(band.y[i], force(0, level, 0) + 0.32 * (force(1, level, 0) - force(0, level, 0)), 1e-12);
    EXPECT_NEAR(band.top[i], force(1, level, 0) + 0.68 * (force(2, level, 0) - force(1, level, 0)), 1e-12);
  }
  EXPECT_EQ(figure.finding,
            "median of 3 records: largest 60 kN at Sa (1.2 s, 5 %) 2 g, smallest 0 kN at Sa (1.2 s, 5 "
            "%) 0.5 g");
  const Figure of_widths = make_figure(results, "peak-force");
  EXPECT_EQ(of_widths.panels[0].title, "medians of 3 records");
  EXPECT_EQ(labelled(of_widths, "gap 0.1 m").y, median.y);
  options.against = "record";
  options.at.emplace_back("intensity", "2");
  EXPECT_EQ(make_figure(results, "peak-force", options).panels[0].x.names, (std::vector<std::string>{"a", "b", "c"}));
}

/// What a pale tone draws cannot be seen as a line.
TEST(IdaFigure, LinesAreDarkEnough) {
  const TemporaryFolder folder;
  const NetcdfReader results(write_results(folder.path()));
  FigureOptions options;
  options.choose = true;
  for (const FigureKind& kind : figure_kinds(results)) {
    for (const Panel& panel : make_figure(results, kind.name, options).panels) {
      for (const Curve& curve : panel.curves) {
        const bool is_pale = curve.tone >= Tone::pale && curve.tone <= Tone::pale_orange;
        EXPECT_TRUE(!is_pale || !curve.top.empty()) << kind.name << ": " << curve.label;
      }
    }
  }
}

/// Its curve ends there, with a cross at the last level that it has; no other is marked.
TEST(IdaFigure, MarksWhereRunsCollapse) {
  const TemporaryFolder folder;
  const NetcdfReader results(write_results(folder.path(), false, 3, true));
  FigureOptions options;
  options.at = {{"width", "0.1"}};
  const Figure figure = make_figure(results, "ida", options);
  const Curve& collapse = labelled(figure, "last level before collapse");
  EXPECT_EQ(collapse.mark, Mark::cross);
  EXPECT_EQ(collapse.x, std::vector<double>{force(2, 2, 0)});
  EXPECT_EQ(collapse.y, std::vector<double>{1.5});
  const TemporaryFolder other;
  const NetcdfReader without(write_results(other.path()));
  EXPECT_ANY_THROW((void)labelled(make_figure(without, "ida", options), "last level before collapse"));
}

TEST(IdaFigure, FragilityOfEachWidth) {
  const TemporaryFolder folder;
  const NetcdfReader results(write_results(folder.path()));
  const Figure figure = make_figure(results, "fragility");
  const Curve& observed = labelled(figure, "observed, n = 3");
  EXPECT_EQ(observed.mark, Mark::circle) << "open";
  EXPECT_EQ(observed.x, (std::vector<double>{0.5, 1, 1.5, 2}));
  for (std::size_t i = 0; i < 4; ++i) EXPECT_DOUBLE_EQ(observed.y[i], static_cast<double>(i) / 3);
  const Curve& fit = labelled(figure, "gap 0.1 m");
  EXPECT_TRUE(std::is_sorted(fit.y.begin(), fit.y.end()));
  EXPECT_GT(fit.y.back(), 0.9);
  labelled(figure, "0.2 m");
  const Curve& band = labelled(figure, "95 % bounds");
  ASSERT_EQ(band.x.size(), band.top.size());
  for (std::size_t i = 0; i < band.x.size(); ++i) EXPECT_LE(band.y[i], band.top[i]);
  for (const std::vector<double>* const y : {&band.y, &band.top}) {  // of several cases bands have edges
    EXPECT_TRUE(std::any_of(figure.panels[0].curves.begin(), figure.panels[0].curves.end(),
                            [&](const Curve& one) { return one.line == Line::dotted && one.y == *y; }));
  }
  FigureOptions options;
  options.at = {{"width", "0.1"}};
  const Figure alone = make_figure(results, "fragility", options);
  const Curve& area = labelled(alone, "95 % bounds");
  ASSERT_EQ(area.x.size(), area.top.size());
  for (std::size_t i = 0; i < area.x.size(); ++i) EXPECT_LE(area.y[i], area.top[i]);
}

/// Each curve is named where it ends, or where it comes to 1, and none has the dashes of another.
TEST(IdaFigure, CurvesOfAFragilityAreNamedAtTheirEnds) {
  const TemporaryFolder folder;
  const NetcdfReader results(write_results(folder.path()));
  const Figure figure = make_figure(results, "fragility");
  EXPECT_NE(labelled(figure, "gap 0.1 m").line, labelled(figure, "0.2 m").line);
  const Layout placing = layout(figure);
  std::vector<std::string> named;
  for (const CurveName& name : placing.panels.front().names) named.push_back(name.label);
  EXPECT_EQ(named, (std::vector<std::string>{"gap 0.1 m", "0.2 m"}));
  for (const auto& [at, text] : placing.panels.front().y.labels) EXPECT_LE(at, 1) << "no probability";
  for (std::size_t one = 0; one < 6; ++one) {
    for (std::size_t other = 0; other < one; ++other) {
      Curve a, b;
      tell_apart(a, one);
      tell_apart(b, other);
      EXPECT_NE(a.line, b.line) << one << " and " << other;
      EXPECT_NE(a.mark, b.mark) << one << " and " << other;
    }
  }
}

TEST(IdaFigure, FragilityNamesBoundsAndMarksWhereTheFirstWidthHasNoFit) {
  const TemporaryFolder folder;
  const NetcdfReader results(write_results(folder.path(), true));
  const Figure figure = make_figure(results, "fragility");
  const Curve& unfitted = labelled(figure, "gap 0.1 m, no fit");
  EXPECT_EQ(unfitted.line, Line::none);
  EXPECT_EQ(unfitted.tone, Tone::grey) << "a colour would be that of a curve";
  EXPECT_TRUE(figure.panels[0].title.starts_with("no fit: ")) << figure.panels[0].title;
  EXPECT_NE(figure.finding.find("gap 0.1 m: " + figure.panels[0].title), std::string::npos) << figure.finding;
  EXPECT_FALSE(labelled(figure, "95 % bounds").x.empty());
  EXPECT_EQ(labelled(figure, "observed, n = 3").mark, labelled(figure, "0.2 m").legend_mark);
}

TEST(IdaFigure, APanelForEachWidthWhereNoneIsChosen) {
  const TemporaryFolder folder;
  const NetcdfReader results(write_results(folder.path()));
  FigureOptions options;
  options.choose = true;
  const Figure figure = make_figure(results, "ida", options);
  ASSERT_EQ(figure.panels.size(), 2U);
  EXPECT_EQ(figure.panels[0].x.to, figure.panels[1].x.to) << "so that they can be compared";
  EXPECT_NE(figure.panels[0].title, figure.panels[1].title);
}

TEST(IdaFigure, FragilityOfAnotherEvent) {
  const TemporaryFolder folder;
  const NetcdfReader results(write_results(folder.path()));
  FigureOptions options;
  options.event = "peak_force > 25";
  const Figure figure = make_figure(results, "fragility", options);
  EXPECT_EQ(figure.panels[0].y.label, "P(peak force > 25 kN) [–]");
  options.event = "drift > 0.0125";
  EXPECT_EQ(make_figure(results, "fragility", options).panels[0].y.label, "P(drift > 1.25 %) [–]");
  const Curve& observed = labelled(figure, "observed, n = 3");
  for (int level = 0; level < levels; ++level) {
    double events = 0;
    for (int record = 0; record < records; ++record) events += force(record, level, 0) > 25 ? 1 : 0;
    EXPECT_DOUBLE_EQ(observed.y[static_cast<std::size_t>(level)], events / records) << level;
  }
  for (const char* wrong : {"peak_force", "peak_farce > 1"}) {
    options.event = wrong;
    EXPECT_THROW(static_cast<void>(make_figure(results, "fragility", options)), NoFigure) << wrong;
  }
}

TEST(IdaFigure, SpeaksTheLanguageThatIsAskedFor) {
  const TemporaryFolder folder;
  const NetcdfReader results(write_results(folder.path()));
  FigureOptions options;
  options.choose = true;
  options.say = [](std::string_view english) { return "§" + std::string(english); };
  const Figure ida = make_figure(results, "ida", options);
  EXPECT_EQ(ida.panels.at(0).title, "§gap 0.1 m");
  EXPECT_EQ(ida.panels.at(0).x.label, "§Peak contact force F [kN]");
  const Figure forces = make_figure(results, "peak-force", options);
  EXPECT_EQ(forces.panels.at(0).y.label, "§Peak contact force F [kN]");
  options.at = {{"width", "0.1"}, {"intensity", "1"}};
  const Figure records = make_figure(results, "peak-force", options);
  EXPECT_EQ(records.panels.at(0).x.label, "§Record");
  EXPECT_EQ(records.panels.at(0).x.number, "§number");
}

TEST(IdaFigure, ListsItsKinds) {
  const TemporaryFolder folder;
  const NetcdfReader results(write_results(folder.path()));
  const std::vector<FigureKind> kinds = figure_kinds(results);
  ASSERT_GE(kinds.size(), 3U);
  EXPECT_EQ(kinds[0].name, "ida");
  EXPECT_EQ(kinds[1].name, "fragility");
  EXPECT_EQ(kinds[2].name, "peak-force");
}

/// Records that are not scaled, each needing 0.2 m per g to the power 1.5, times or over e^0.1 in turn.
std::filesystem::path write_cloud(const std::filesystem::path& folder) {
  const std::filesystem::path path = folder / "cloud.nc";
  NetcdfWriter file(path.string());
  const ResultDimension record{"record", 6}, width{"width", widths}, gap{"gap", 1};
  const std::vector<double> intensities = {0.9, 0.3, 0.1, 0.1, 0.3, 0.9};
  file.add({"record", {record}, "", "excitation.file", {}, std::vector<std::string>{"a", "b", "c", "d", "e", "f"}});
  file.add({"width", {width}, "m", "gap[0].width", {}, std::vector{0.1, 0.2}});
  for (const std::string name : {"intensity", "record_intensity"}) {
    file.add({name, {record}, "gravity", "peak ground acceleration", {}, intensities});
  }
  std::vector<double> needs, impacts;
  for (std::size_t r = 0; r < intensities.size(); ++r) {
    for (int w = 0; w < widths; ++w) {
      needs.push_back(0.2 * std::pow(intensities[r], 1.5) * std::exp(r < 3 ? 0.1 : -0.1));
      impacts.push_back(needs.back() > 0.1 * (w + 1) ? 1 : 0);
    }
  }
  file.add({"gap_needed", {record, width, gap}, "m", "gap needed", {}, needs});
  file.add({"impacts", {record, width, gap}, "1", "impacts", {}, impacts});
  file.add({"status", {record, width}, "", "how the run ended", {}, std::vector<signed char>(needs.size())});
  file.finish();
  return path;
}

TEST(CloudFigure, ShowsEachRecordOnceAndTheLineOfAll) {
  const TemporaryFolder folder;
  const NetcdfReader results(write_cloud(folder.path()));
  const std::vector<FigureKind> kinds = figure_kinds(results);
  EXPECT_EQ(kinds[0].name, "cloud");
  EXPECT_EQ(kinds[1].name, "fragility");
  EXPECT_TRUE(std::none_of(kinds.begin(), kinds.end(), [](const FigureKind& kind) { return kind.name == "ida"; }));
  EXPECT_THROW((void)make_figure(results, "ida"), NoFigure);
  const Figure figure = make_figure(results, "cloud");
  const Panel& panel = figure.panels.at(0);
  EXPECT_TRUE(panel.x.logarithmic && panel.y.logarithmic);
  ASSERT_EQ(panel.curves.size(), 4U);  // a line between two, and the records, alike at both widths
  const Curve& records = labelled(figure, "each record");
  EXPECT_EQ(records.line, Line::none);
  EXPECT_EQ(records.x, (std::vector<double>{0.9, 0.3, 0.1, 0.1, 0.3, 0.9}));
  const Curve& line = labelled(figure, "line of the cloud");
  ASSERT_EQ(line.x, (std::vector<double>{0.1, 0.9}));
  EXPECT_NEAR(line.y[1], 0.2 * std::pow(0.9, 1.5), 1e-12);
  EXPECT_NEAR(labelled(figure, "± σ").y[0], line.y[0] * std::exp(std::sqrt(6 * 0.01 / 4)), 1e-12);
  FigureOptions options;
  options.event = "gap_needed > 0.05";
  options.method = FragilityMethod::cloud;
  const Figure fragility = make_figure(results, "fragility", options);
  EXPECT_NE(fragility.finding.find("median intensity 0.3969 g"), std::string::npos) << fragility.finding;  // 0.25^(2/3)
  options.method = FragilityMethod::stripes;
  EXPECT_THROW((void)make_figure(results, "fragility", options), NoFigure);
}

}  // namespace
}  // namespace bentur
