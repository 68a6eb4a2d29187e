// Pictures of more buildings than there are tones.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "bentur/core/number_text.h"
#include "bentur/model/judgement/judged_gaps.h"
#include "bentur/model/quantities.h"
#include "bentur/model/story/judgement_story.h"
#include "bentur/model/story/story.h"
#include "bentur/report/figures/internal/layout.h"
#include "bentur/report/figures/internal/text_width.h"
#include "bentur/report/html/internal/sections.h"
#include "bentur/report/html/report.h"
#include "bentur/report/kinds/figure_width.h"
#include "bentur/report/kinds/internal/run_figures.h"
#include "bentur/report/story_text.h"
#include "tests/support/drawn_run.h"
#include "tests/support/plan_run.h"

namespace bentur {
namespace {

/// Houses side by side, no two alike, under a motion that closes most gaps.
std::string row_of(int houses) {
  std::string text = R"(
units = { length = "m", force = "kN" }
excitation = { kind = "harmonic", period = 0.5, displacement_amplitude = 0.04 }
analysis = { duration = 4.0 }
)";
  for (int b = 0; b < houses; ++b) {
    text += fmt::format(
        "[[building]]\nname = \"House {}\"\ndamping = 0.05\ngeneric = {{ storeys = {}, storey_height = 3.0, "
        "floor_mass = 100.0, period = {}, stiffness_ratio = 30.0 }}\n",
        b + 1, 1 + b % 3, 0.3 + 0.1 * (b * 5 % 7));
  }
  for (int b = 1; b < houses; ++b) {
    text += fmt::format(
        "[[gap]]\nbetween = [\"House {}\", \"House {}\"]\nwidth = 0.02\ncontact = {{ law = \"linear\", stiffness = 1e5 "
        "}}\n",
        b, b + 1);
  }
  return text;
}

const RunResults& row() {
  static const RunResults run = test::drawn_run(row_of(9));
  return run;
}

TEST(ManyBuildings, HaveTheirNamesBelowThemAndNotInTheLegend) {
  for (const double width : {column_width, page_width}) {
    FigureOptions options;
    options.width = width;
    for (const std::string kind : {"scene", "overview"}) {
      const Figure figure = make_figure(row(), kind, options);
      const Layout placing = layout(figure);
      const PlacedPanel& placed = placing.panels.front();
      ASSERT_EQ(placed.x.labels.size(), row().problem.buildings.size()) << kind << width;
      for (const LegendEntry& entry : placed.legend) EXPECT_FALSE(entry.label.starts_with("House")) << kind;
      std::vector<double> ends(3, -INFINITY);  // of what stands already in each line, or beside it where it is upright
      for (std::size_t i = 0; i < placed.x.labels.size(); ++i) {
        const auto& [at, text] = placed.x.labels[i];
        const std::string& name = row().problem.buildings[i].name;
        const bool is_short = text == std::to_string(i + 1) && name.ends_with(text) && placed.x.lines == 1;
        EXPECT_TRUE(text == name || is_short) << text;
        const double middle = placed.left + along(placed.x, at) * (placed.right - placed.left);
        const double half = (placed.x.upright ? 0.85 * line_height : text_width(text)) / 2;
        double& end = ends.at(i % static_cast<std::size_t>(placed.x.lines));
        EXPECT_GT(middle - half, end) << kind << width << text;
        end = middle + half;
        const double deep = placed.x.upright ? 0.1 + text_width(text) : line_height * placed.x.lines;
        EXPECT_LT(deep, placed.bottom) << "below the figure";
      }
    }
  }
}

/// In a report the scene of a row is as broad as the page, so that its heights can be read, and no name stands upright.
TEST(ManyBuildings, HaveASceneAsBroadAsThePage) {
  FigureOptions options;
  options.width = page_width;
  const Layout placing = layout(make_figure(row(), "overview", options));
  ASSERT_EQ(placing.panels.size(), 4U);  // with the worst gap, which is not hit hardest
  const PlacedPanel& scene = placing.panels.front();
  EXPECT_GT(scene.right - scene.left, 0.9 * page_width);
  EXPECT_FALSE(scene.x.upright);
  for (std::size_t i = 1; i < 4; ++i) EXPECT_LT(placing.panels[i].top, scene.bottom);
}

/// Statements of a gap say which place it has among all, and those of the worst are those of the table's first line.
TEST(ManyBuildings, StatementsSayHowBadTheirGapIsAmongAll) {
  const Story story = run_story(row());
  const std::size_t gaps = row().problem.buildings.size() - 1;
  std::map<long, Eigen::Index> of_rank;
  for (const Statement& one : story.statements) {
    ASSERT_EQ(one.rank.has_value(), one.gap.has_value());
    if (!one.rank) continue;
    EXPECT_EQ(of_rank.emplace(*one.rank, *one.gap).first->second, *one.gap);
  }
  EXPECT_EQ(of_rank.size(), gaps);
  EXPECT_EQ(of_rank.begin()->first, 1);
  const std::vector<std::size_t> order = worst_first(judged_gaps(row()));
  for (const auto& [rank, gap] : of_rank) EXPECT_EQ(order.at(static_cast<std::size_t>(rank) - 1), gap);
  const Story pair = run_story(test::drawn_run(row_of(2)));
  for (const Statement& one : pair.statements) EXPECT_FALSE(one.rank);
}

/// The bars are of the gaps that the verdict's table puts first, whichever way of the motion they fall short in.
TEST(ManyBuildings, BarsAreOfTheWorstGapsOfBothWays) {
  RunResults run = row();
  const std::vector<std::size_t> before = worst_first(judged_gaps(run));
  for (PointSummary& point : run.response.points) {
    const bool is_last =
        run.problem.points[&point - run.response.points.data()].gap == static_cast<Eigen::Index>(before.back());
    if (is_last) point.gap_needed_reversed = 10;  // the least becomes the worst
  }
  std::vector<std::size_t> order = worst_first(judged_gaps(run));
  ASSERT_EQ(order.front(), before.back());
  order.resize(5);
  std::reverse(order.begin(), order.end());  // the worst uppermost
  std::vector<std::string> expected;
  for (const std::size_t gap : order) {  // with the level at which each falls short the most
    const auto need = governing_need(judged_gaps(run).at(gap).facts);
    const bool is_known = need && need->given.needed;
    expected.push_back(std::to_string(gap + 1) + " | " + std::to_string(gap + 2) +  // of House 1 | House 2
                       (is_known ? ", level " + number(need->at.elevation) + " m" : ""));
  }
  FigureOptions options;
  options.width = page_width;
  std::vector<std::string> named = make_figure(run, "overview", options).panels.back().y.names;
  for (std::string& name : named) name = name.substr(0, name.find(':'));  // ": not known"
  EXPECT_EQ(named, expected);
}

/// What is needed has the colour of what is judged of the gap: that of one which closes only as its buildings are
/// pushed is not the colour of one that is enough. The legend has each colour that is there.
TEST(ManyBuildings, BarsHaveTheColourOfWhatIsJudged) {
  RunResults run = row();
  for (PointSummary& point : run.response.points) point.gap_needed_reversed = point.gap_needed = 0.01;
  const std::vector<JudgedGap> judged = judged_gaps(run);
  std::vector<std::size_t> order = worst_first(judged);
  ASSERT_EQ(judged[order.front()].judgement.value, Sufficiency::too_small);
  order.resize(5);
  std::sort(order.begin(), order.end(), std::greater<>());
  const Panel bars = make_figure(run, "overview").panels.back();
  long filled = 0;
  for (const Curve& bar : bars.curves) {
    if (bar.tone == Tone::black || bar.top.empty()) continue;  // given, or reversed
    const Sufficiency value = judged[order.at(static_cast<std::size_t>(std::lround(bar.y[0])))].judgement.value;
    const Tone not_small = value == Sufficiency::unknown ? Tone::gold : Tone::pale_teal;
    EXPECT_EQ(bar.tone, value == Sufficiency::too_small ? Tone::red : not_small);
    ++filled;
  }
  EXPECT_GE(filled, 3);
  const auto is_red = [](const Curve& one) { return one.tone == Tone::red && one.label.ends_with(", gap too small"); };
  EXPECT_TRUE(std::any_of(bars.curves.begin(), bars.curves.end(), is_red));
}

/// Drawings of storeys have no marks at both ends of every step.
TEST(ManyBuildings, StepsHaveNoMarks) {
  for (const Panel& panel : make_figure(row(), "drift").panels) {
    for (const Curve& curve : panel.curves) EXPECT_EQ(curve.mark, Mark::none) << panel.title;
  }
}

/// A gap that is wide enough for what it needs, and too small since it closes all the same, says so in the table.
TEST(ManyBuildings, AGapThatIsNotShortSaysWhyItIsTooSmall) {
  RunResults run = row();
  for (PointSummary& point : run.response.points) point.gap_needed_reversed = point.gap_needed = 0.01;
  const Story story = run_story(run);
  const auto table =
      std::find_if(story.tables.begin(), story.tables.end(), [](const StoryTable& one) { return one.kind == "row"; });
  const auto column = [&](const char* label) {
    return *std::find_if(table->columns.begin(), table->columns.end(),
                         [&](const StoryColumn& one) { return one.label == label; });
  };
  const StoryColumn impacts = column("column.impacts"), lacks = column("column.short_by");
  int closed = 0;
  for (std::size_t i = 0; i < impacts.texts.size(); ++i) {
    if (impacts.texts[i] == "0") continue;
    ++closed;
    EXPECT_TRUE(std::isnan(lacks.numbers[i]));
    EXPECT_EQ(column("gap.given_is").texts[i], "gap.pushed");
    EXPECT_EQ(std::count(table->marked.begin(), table->marked.end(), i), 1);
    for (const Statement& one : story.statements) {
      EXPECT_TRUE(one.gap != static_cast<Eigen::Index>(i) || one.kind.find("enough") == std::string::npos) << one.kind;
    }
  }
  EXPECT_GT(closed, 0);
  // And what would do there, once no other gap closes.
  int told = 0;
  for (const Statement& one : story.statements) {
    if (one.kind != "row_pushed") continue;
    ++told;
    EXPECT_EQ(column("gap.given_is").texts.at(static_cast<std::size_t>(one.gap.value())), "gap.pushed");
    EXPECT_EQ(std::get<double>(one.values.front().value), 0.01);
    EXPECT_EQ(one.shown, Shown::row);
  }
  EXPECT_EQ(told, std::min(closed, 5));
}

/// The verdict begins with how many gaps are too small, how often they close, and the hardest impact of all.
TEST(ManyBuildings, TheVerdictBeginsWithTheHardestImpact) {
  const std::vector<Statement> all = run_story(row()).statements;
  const auto found =
      std::find_if(all.begin(), all.end(), [](const Statement& one) { return one.severity == Severity::warning; });
  ASSERT_NE(found, all.end());
  const Statement& first = *found;
  ASSERT_EQ(first.kind, "row_pounding");
  const auto value = [&](const char* name) {
    return std::find_if(first.values.begin(), first.values.end(), [&](const StoryValue& v) { return v.name == name; })
        ->value;
  };
  EXPECT_EQ(std::get<long>(value("times")), std::ssize(row().response.impacts));
  double hardest = 0;
  std::set<Eigen::Index> closed;
  for (std::size_t p = 0; p < row().problem.points.size(); ++p) {
    const PointSummary& point = row().response.points[p];
    hardest = std::max(hardest, point.peak_force);
    if (point.impacts > 0) closed.insert(row().problem.points[p].gap);
  }
  EXPECT_EQ(std::get<double>(value("force")), hardest);
  EXPECT_EQ(std::get<long>(value("closed")), std::ssize(closed));
  const Eigen::Index left = first.buildings.front();
  EXPECT_EQ(std::get<std::string>(value("left")), row().problem.buildings[left].name);
  const SaidStatement said_first = said({first}, Words("en")).front();
  EXPECT_EQ(said_first.badge, "Pounding");
  // What names both buildings needs no name of their gap before it.
  EXPECT_EQ(of_gap("House 1 and House 2 collide", "House 1 | House 2"), "House 1 and House 2 collide");
  EXPECT_EQ(of_gap("They need 1 m", "House 1 | House 2", "1 | 2"), "1 | 2: They need 1 m");
}

/// A run that ends before its motion does says so where it says what is not known, and of which part a need is.
TEST(ManyBuildings, ARunThatIsCutSaysSoFirst) {
  RunResults run = row();
  const auto sentences = [&] {
    std::string all;
    for (const SaidStatement& one : said(run_story(run).statements, Words("en"))) all += one.text + "\n";
    return all;
  };
  const Eigen::Index quiet = run.problem.points.back().gap;  // a gap that does not close
  for (std::size_t p = 0; p < run.problem.points.size(); ++p) {
    PointSummary& point = run.response.points[p];
    point.to_come = point.to_come_reversed = point.to_come_struck = 0;
    if (run.problem.points[p].gap != quiet) continue;
    point.impacts = 0;
    point.gap_needed = 0;
    point.gap_needed_reversed = 0;
  }
  run.response.reversed.reset();
  EXPECT_EQ(sentences().find("the first"), std::string::npos);
  EXPECT_EQ(sentences().find("goes on"), std::string::npos) << sentences();
  run.response.points.back().to_come_struck = INFINITY;  // some touch at the end
  EXPECT_NE(sentences().find("floors still touch at the end of the run"), std::string::npos);
  EXPECT_EQ(sentences().find("goes on"), std::string::npos);
  for (PointSummary& point : run.response.points) point.to_come = point.to_come_reversed = INFINITY;
  const std::string end = number(run.problem.duration) + "\u00A0s";
  EXPECT_NE(sentences().find("in the first " + end + " of this harmonic motion"), std::string::npos);
  EXPECT_NE(sentences().find("not known, since the run ends at " + end + " and the motion goes on"), std::string::npos)
      << sentences();
}

/// Where floors meet and no contact is modelled, the hardest impact is that of those that are modelled.
TEST(ManyBuildings, TheHardestImpactIsOfThoseThatAreModelled) {
  std::string text = row_of(2);  // the first with a floor halfway up the other's upper storey
  text.replace(text.find("storeys = 1, storey_height = 3.0"), 32, "storeys = 4, storey_height = 1.5");
  RunResults run = test::drawn_run(text);
  const auto first = [&] {
    std::string all;
    for (const SaidStatement& one : said(run_story(run).statements, Words("en"))) all += one.text + "\n";
    return all;
  };
  ASSERT_FALSE(run.problem.watched.empty());
  for (WatchedSummary& floor : run.response.watched) floor.closes = false;
  ASSERT_EQ(first().find("that is modelled"), std::string::npos);
  run.response.watched.front().closes = true;
  EXPECT_NE(first().find("The hardest impact that is modelled reaches"), std::string::npos) << first();
}

/// A key of numbers says what the names do not.
TEST(ManyBuildings, AreThoseThatTheVerdictNames) {
  const std::vector<Eigen::Index> shown = shown_buildings(row(), {});
  for (const Statement& one : run_story(row()).statements) {
    if (one.shown != Shown::sentence || one.severity == Severity::remark) continue;
    for (const Eigen::Index b : one.buildings) {
      EXPECT_NE(std::find(shown.begin(), shown.end(), b), shown.end()) << one.kind << ": " << b;
    }
  }
  // Then those beside the gaps that lack most, as long as there is room.
  const std::vector<JudgedGap> judged = judged_gaps(row());
  const auto worst = static_cast<Eigen::Index>(worst_first(judged).front());
  EXPECT_TRUE(std::count(shown.begin(), shown.end(), worst) == 1 &&
              std::count(shown.begin(), shown.end(), worst + 1) == 1);
  EXPECT_TRUE(shown.size() > 6 && shown.size() <= 8);
  const Figure of_all = make_figure(row(), "envelope");  // where each has a place of its own there is room for all
  EXPECT_EQ(of_all.panels.size(), row().problem.buildings.size());
  EXPECT_EQ(of_all.part, "");
  EXPECT_TRUE(of_all.columns == 3 && of_all.panels[6].x.label.empty() && !of_all.panels[7].x.label.empty());
  const Figure of_some = make_figure(test::drawn_run(row_of(13)), "amplification");
  const std::string part = fmt::format("Shown are {} of 13", of_some.panels.size());
  EXPECT_TRUE(of_some.part.starts_with(part) && of_some.finding.starts_with(part)) << of_some.part;
  // Of one place it says which, where that is not at the worst gap.
  const std::vector<Impact>& impacts = row().response.impacts;
  const auto hardest = std::max_element(impacts.begin(), impacts.end(),
                                        [](const Impact& a, const Impact& b) { return a.peak_force < b.peak_force; });
  const Eigen::Index struck = row().problem.points[hardest->point].gap;
  ASSERT_NE(struck, worst);
  const std::string hit = gap_name(row().problem, struck), least = gap_name(row().problem, worst);
  EXPECT_EQ(make_figure(row(), "force").part,
            "Shown is " + hit + ", with the hardest impact; the worst gap is " + least);
  for (const char* const kind : {"overview", "opening", "displacement"}) {  // which show both
    const Figure figure = make_figure(row(), kind);
    EXPECT_EQ(figure.part, "First " + hit + ", with the hardest impact, then the worst gap, " + least);
    const auto is_of_worst = [&](const Panel& one) { return one.title.starts_with(least); };
    EXPECT_EQ(std::count_if(figure.panels.begin(), figure.panels.end(), is_of_worst), 1) << kind;
  }
  FigureOptions of_worst;
  of_worst.gap = static_cast<std::size_t>(worst);
  EXPECT_EQ(make_figure(row(), "force", of_worst).part, "");
  // So what a figure finds largest is the largest of all.
  const std::string kind = "amplification";
  double largest = 0;
  for (Eigen::Index b = 0; b < std::ssize(row().problem.buildings); ++b) {
    for (const QuantityPlace& at : floors_of(row().problem, b)) {
      largest = std::fmax(largest, value_of(quantity_named(kind, Owner::floor), row().view(), at));
    }
  }
  double drawn = 0;
  for (const Panel& panel : make_figure(row(), kind).panels) {
    EXPECT_EQ(panel.curves.size(), 1U) << "more than can be followed in one frame";
    for (const double x : panel.curves.front().x) drawn = std::max(drawn, x);
  }
  EXPECT_EQ(drawn, largest);
  of_worst.gap = struck == 2 ? 3 : 2;
  const auto left = static_cast<Eigen::Index>(*of_worst.gap);
  EXPECT_EQ(shown_buildings(row(), of_worst), (std::vector<Eigen::Index>{left, left + 1}));
  EXPECT_TRUE(
      make_figure(row(), "floor-spectrum", of_worst).part.starts_with("Shown is " + gap_name(row().problem, struck)));
}

TEST(ManyBuildings, AreToldApartInGrey) {
  for (const FigureKind& kind : figure_kinds(row())) {
    test::expect_told_apart_in_grey(make_figure(row(), kind.name), kind.name);
  }
}

TEST(ManyBuildings, TheHeightOfAFigureIsThatOfWhatItShows) {
  FigureOptions options;
  options.gap = 0;  // one and two storeys
  const Panel panel = make_figure(row(), "amplification", options).panels.front();
  constexpr double name = 0.5;  // [cm], above the roof
  EXPECT_NEAR(*panel.y.to, 6 * panel.height / (panel.height - name), 1e-9);
}

/// The bars of all gaps are drawn at one scale: of equal lengths for what is given alike.
TEST(ManyBuildings, BarsOfAllGapsHaveOneScale) {
  const std::string page = report_html(row(), {.version = "0"});
  std::vector<std::pair<double, double>> bars;  // as drawn [%], as said
  for (std::size_t at = page.find("class=\"bar "); at != std::string::npos; at = page.find("class=\"bar ", at + 1)) {
    const std::string width = "width=\"";
    const std::size_t from = page.find(width, at) + width.size(), value = page.find("<td>", at) + 4;
    bars.emplace_back(std::stod(page.substr(from)), std::stod(page.substr(value)));
  }
  const double largest = std::max_element(bars.begin(), bars.end())->second;
  for (const auto& [drawn, value] : bars) EXPECT_NEAR(drawn, 100 * value / largest, 0.1) << value;
  EXPECT_GE(bars.size(), 2 * (row().problem.buildings.size() - 1));
}

TEST(ManyBuildings, OfAReportAreFoldedAway) {
  const std::string many = report_html(row(), {.version = "0"});
  const std::string few = report_html(test::drawn_run(row_of(3)), {.version = "0"});
  const auto count = [](const std::string& page, const std::string& what) {
    std::size_t found = 0;
    for (std::size_t at = page.find(what); at != std::string::npos; at = page.find(what, at + 1)) ++found;
    return found;
  };
  EXPECT_EQ(count(few, "class=\"appendix\""), 0U);
  EXPECT_EQ(count(few, "id=\"unfold\""), 0U);
  // Gaps of the verdict and of their own section, contacts, peaks, buildings and gaps of the case.
  EXPECT_EQ(count(many, "class=\"appendix\""), 6U);
  EXPECT_EQ(count(many, "id=\"unfold\""), 1U);
  EXPECT_EQ(count(many, "<summary>House 9</summary>"), 2U);  // its peaks and its keys
  EXPECT_EQ(count(few, "<h3>House 3</h3>"), 2U);
}

/// What is folded away stands on paper in tables of all: the needs of every gap, all that is struck, every floor.
TEST(ManyBuildings, ArePrintedInTablesOfAll) {
  const RunResults results = row();
  const std::string page = report_html(results, {.version = "0"});
  const auto table_after = [&](const std::string& heading) {
    const std::size_t from = page.find("<h3>" + heading + "</h3>");
    EXPECT_NE(from, std::string::npos) << heading;
    return from == std::string::npos ? "" : page.substr(from, page.find("</table>", from) - from);
  };
  const auto count = [](const std::string& text, const std::string& what) {
    std::size_t found = 0;
    for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++found;
    return found;
  };
  const std::size_t gaps = results.c.gaps.size();
  const std::string needs = table_after("The level that governs each of " + std::to_string(gaps) + " gaps");
  for (std::size_t gap = 1; gap <= gaps; ++gap) {
    const std::string name = "House " + std::to_string(gap) + " | House " + std::to_string(gap + 1);
    EXPECT_EQ(count(needs, ">" + name + "<"), 1U) << name;
  }
  const auto& points = results.response.points;
  const auto struck = std::count_if(points.begin(), points.end(), [](const auto& one) { return one.impacts > 0; });
  ASSERT_GT(struck, 0);
  const std::string contact = table_after("Contact where there is any, of " + std::to_string(gaps) + " pairs");
  EXPECT_EQ(count(contact, " | House "), static_cast<std::size_t>(struck));
  const std::string peaks = table_after("Peaks of " + std::to_string(gaps + 1) + " buildings");
  for (const Building& building : results.problem.buildings) {
    EXPECT_EQ(count(peaks, ">" + building.name + "<"), static_cast<std::size_t>(building.model.floors()));
  }
}

TEST(ManyBuildings, InPlanHaveTheirNamesWithinThemselves) {
  const PlanRun run = test::plan_run(test::twisting_pair());
  const Figure figure = make_figure(run, "scene");
  const Panel& panel = figure.panels.front();
  const Layout placing = layout(figure);
  ASSERT_EQ(panel.texts.size(), run.problem.buildings.size());
  for (std::size_t b = 0; b < panel.texts.size(); ++b) {
    EXPECT_EQ(panel.texts[b].text, run.problem.buildings[b].name);
    const std::vector<std::string> lines = text_lines(panel.texts[b], placing.panels.front());
    ASSERT_FALSE(lines.empty());
    std::string all;
    for (const std::string& line : lines) all += (all.empty() ? "" : " ") + line;
    EXPECT_EQ(all, panel.texts[b].text);
  }
  for (const LegendEntry& entry : placing.panels.front().legend) {
    for (const PlanBuilding& building : run.problem.buildings) EXPECT_NE(entry.label, building.name);
  }
  // Of a building too thin for its name that stands in the legend.
  const PlanRun thin = test::plan_run(test::twisting_pair() + test::wall_beside);
  const Figure with_wall = make_figure(thin, "scene");
  EXPECT_EQ(with_wall.panels.front().texts.size(), thin.problem.buildings.size() - 1);
  const std::vector<Curve>& drawn = with_wall.panels.front().curves;
  EXPECT_TRUE(
      std::any_of(drawn.begin(), drawn.end(), [](const Curve& one) { return one.label == "W" && one.in_legend; }));
  // A name that has no room is not there at all.
  PlaceText narrow = panel.texts.front();
  narrow.room /= 100;
  EXPECT_TRUE(text_lines(narrow, placing.panels.front()).empty());
}

/// However many panels one below another they have, in a column and over a page; and panels of the second and third
/// column have no numbers of levels, which the first has.
TEST(ManyBuildings, FiguresAreNoHigherThanAPage) {
  std::string tall = row_of(9);
  for (std::size_t at = 0; (at = tall.find("storeys = ", at)) != std::string::npos; ++at) tall.insert(at + 10, "1");
  std::string frames =  // of three buildings
      "units = { length = \"m\", force = \"kN\" }\nanalysis = { duration = 2.0 }\n"
      "excitation = { kind = \"harmonic\", period = 0.5, displacement_amplitude = 0.04 }\n";
  for (int b = 0; b < 3; ++b) {
    frames += fmt::format(
        "[[building]]\nname = \"F{}\"\ndamping = 0.05\n[building.frame]\nelastic_modulus = 2.5e7\n"
        "storey_heights = [3.0, 3.0, 3.0, 3.0, 3.0]\nbay_widths = [5.0, 5.0, 5.0, 5.0]\n"
        "columns = [{{ width = 0.{}, depth = 0.4, density = 2.5 }}]\n"
        "beams = [{{ width = 0.3, depth = 0.4, density = 2.5 }}]\nfloor_masses = [40.0, 40.0, 40.0, 40.0, 30.0]\n",
        b, 3 + b);
  }
  for (int b = 0; b < 2; ++b) {
    frames += fmt::format(
        "[[gap]]\nbetween = [\"F{}\", \"F{}\"]\nwidth = 0.02\ncontact = {{ law = \"linear\", stiffness = 1e5 }}\n", b,
        b + 1);
  }
  int high = 0;  // would be without that
  for (const std::string& text : {tall, frames}) {
    const RunResults run = test::drawn_run(text);
    for (const FigureKind& kind : figure_kinds(run)) {
      const auto make = [&](const FigureOptions& options) { return make_figure(run, kind.name, options); };
      EXPECT_LE(layout(make({})).height, page_height + 0.01) << kind.name;
      for (const double width : {column_width, page_width}) {
        const Figure figure = figure_of_width(make, {}, width);
        EXPECT_LE(layout(figure).height, page_height + 0.01) << kind.name << ", " << width;
        high += figure.panels.size() >= 6 && layout(figure).height > 0.8 * page_height ? 1 : 0;
        const Layout placing = layout(figure);
        const std::size_t of_one = figure.panels.size() / 2;  // a ratio of accelerations, then one of shears
        for (std::size_t i = 0; i < 2 * of_one && of_one > 1 && kind.name == "forces"; ++i) {
          const bool is_first = placing.panels[i].left == placing.panels.front().left;
          EXPECT_EQ(figure.panels[i].y.numbers, is_first) << width << ", panel " << i;
          EXPECT_TRUE(is_first || i % of_one > 0) << "stands in a row of the other ratio";
        }
      }
    }
  }
  EXPECT_GT(high, 3);
}

}  // namespace
}  // namespace bentur
