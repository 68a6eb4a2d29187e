#include "bentur/report/html/report.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <nlohmann/json.hpp>
#include <numbers>
#include <optional>
#include <regex>
#include <string>
#include <utility>

#include "bentur/core/errors.h"
#include "bentur/core/number_text.h"
#include "bentur/files/result_netcdf.h"
#include "bentur/files/result_reading.h"
#include "bentur/io/output/atomic_file.h"
#include "bentur/io/results/result_csv.h"
#include "bentur/io/results/result_json.h"
#include "bentur/io/temporary_folder.h"
#include "bentur/model/gap/gap_outcome.h"
#include "bentur/model/plan/plan_places.h"
#include "bentur/model/plan/plan_row.h"
#include "bentur/model/story/hand_in.h"
#include "bentur/model/story/story.h"
#include "bentur/report/kinds/kinds.h"
#include "bentur/report/story_text.h"
#include "tests/support/plan_run.h"

namespace bentur {
namespace {

std::string page_of(const PlanRun& run, const std::string& language = "en") {
  return report_html(run, {.language = language, .version = "0"});
}

const PlanRun& twisting_pair() {
  static const PlanRun run = test::plan_run(test::twisting_pair());
  return run;
}

bool shows(const std::string& page, const std::string& text) { return page.find(text) != std::string::npos; }

/// The sections of a row's report that a plan has, in its order; nothing is fetched.
TEST(PlanReport, HasThePartsOfARowsReport) {
  const std::string page = page_of(twisting_pair());
  EXPECT_EQ(page, page_of(twisting_pair()));
  std::size_t last = 0;
  for (const char* const id : {"verdict", "remarks", "motion", "gaps", "peaks", "impacts", "figures", "input"}) {
    const std::size_t at = page.find("<section id=\"" + std::string(id) + "\"");
    ASSERT_NE(at, std::string::npos) << id;
    EXPECT_GT(at, last) << id;
    last = at;
  }
  EXPECT_TRUE(shows(page, "default-src 'none'"));
  EXPECT_FALSE(std::regex_search(page, std::regex(R"((src|href)="(?!#))")));
  EXPECT_TRUE(shows(page, "twisting-pair.toml, SHA-256") || shows(page, "case.toml, SHA-256"));
}

/// A millisecond of a pair; of so many that their histories would fill a page's memory coarser, and within it.
TEST(PlanReport, HistoriesOfManyFitIntoAPage) {
  PlanProblem problem = twisting_pair().problem;
  problem.duration = 10;
  problem.delays.clear();
  EXPECT_EQ(report_output_step(problem), 1e-3);
  const PlanGap gap = problem.gaps.front();
  const PlanBuilding building = problem.buildings.front();
  for (int n = 0; n < 100; ++n) problem.gaps.push_back(gap);
  for (int n = 0; n < 100; ++n) problem.buildings.push_back(building);
  const double step = report_output_step(problem);
  EXPECT_GT(step, 1e-3);
  EXPECT_LE(step, 1e-2);
  EXPECT_NEAR(std::remainder(1e-2, step), 0, 1e-9) << "samples at the output step are among them";
  SolveOptions options;
  options.output_step = step;
  EXPECT_LT(effort(problem, ExactSolver{}, options).memory, 300e6);
  options.output_step = 1e-3;
  EXPECT_GT(effort(problem, ExactSolver{}, options).memory, 300e6) << "as fine as of a pair";
}

/// Between what is needed as recorded and reversed nothing collides, and it is said why the gap is too small.
TEST(PlanReport, SaysWhyAGapIsTooSmallInWhichNothingCollides) {
  const PlanRun run = test::plan_run(test::twisting_pair("corner = [12.04, 0.0]", "corner = [12.088, 0.0]"));
  for (const PointSummary& point : run.response.points) ASSERT_EQ(point.impacts, 0);
  for (const std::string language : {"en", "id"}) {
    const Words say(language);
    const std::vector<SaidStatement> told = said(run_story(run).statements, say);
    const auto found = std::find_if(told.begin(), told.end(), [](const auto& one) { return one.kind == "too_small"; });
    ASSERT_NE(found, told.end());
    EXPECT_TRUE(shows(found->text, "0.08825") && shows(found->text, "Walled")) << found->text;
    EXPECT_FALSE(shows(found->text, "{") || shows(found->text, "reason.")) << found->text;
  }
  EXPECT_TRUE(shows(page_of(run), "under the motion reversed without contact they need"));
}

/// With [project] it is one to hand in: numbered sections in the order of a row's, checks that follow from the run.
TEST(PlanReport, IsOneToHandIn) {
  const PlanRun run = test::plan_run(
      test::twisting_pair() + "\n[project]\nname = \"Two towers\"\nnumber = \"26-7\"\nassumptions = [\"As built\"]\n");
  for (const std::string language : {"en", "id"}) {
    const std::string page = page_of(run, language);
    std::size_t last = 0;
    for (const char* const id :
         {"verdict", "assumptions", "input", "checks", "unchecked", "motion", "peaks", "impacts"}) {
      const std::size_t at = page.find("<section id=\"" + std::string(id) + "\"");
      ASSERT_NE(at, std::string::npos) << id;
      EXPECT_GT(at, last) << id;
      last = at;
    }
    for (const char* const said : {"Two towers", "26-7", "As built"}) EXPECT_TRUE(shows(page, said)) << said;
    EXPECT_FALSE(shows(page, "unchecked.") || shows(page, "assumption.") || shows(page, ">check."));
  }
  const std::string page = page_of(run);
  // The gap that is needed is a check that is not met; drifts have no limit to be held against without gravity.
  const HandIn told = hand_in(run);
  const std::vector<std::string>& checks = told.checks.columns.at(0).texts;
  const std::vector<std::string>& results = told.checks.columns.at(5).texts;
  const auto result_of = [&](const std::string& check) {
    const auto found = std::find(checks.begin(), checks.end(), check);
    return found == checks.end() ? "none" : results[static_cast<std::size_t>(found - checks.begin())];
  };
  EXPECT_EQ(result_of("check.gap"), "check.not_met");
  EXPECT_EQ(result_of("check.drift"), "none");
  EXPECT_EQ(result_of("check.contact"), "check.not_met");
  EXPECT_EQ(result_of("check.solution"), "check.met");
  EXPECT_EQ(result_of("screening.eccentricity"), "screening.attention");
  EXPECT_TRUE(shows(page, "NOT met"));
}

/// Of a building without planes the drift of its edges is told.
TEST(PlanReport, TellsDriftsOfEdgesWhereThereAreNoPlanes) {
  PlanRun run = twisting_pair();
  const PlanPeaks& peaks = run.response.buildings[1];
  ASSERT_TRUE(run.problem.buildings[1].model.planes.empty());
  ASSERT_EQ(peaks.edge_drift_ratio().size(), 2);
  // Of the lowest storey they are the movements of its edges, which are told too.
  const double height = run.problem.buildings[1].model.storey_heights[0];
  EXPECT_NEAR(peaks.drift_south(0), peaks.south(0) / height, 1e-12 * peaks.drift_south(0));
  EXPECT_NEAR(peaks.drift_north(0), peaks.north(0) / height, 1e-12 * peaks.drift_north(0));
  EXPECT_NEAR(peaks.drift_west(0), peaks.west(0) / height, 1e-12 * peaks.drift_west(0));
  EXPECT_NEAR(peaks.drift_east(0), peaks.east(0) / height, 1e-12 * peaks.drift_east(0));
  EXPECT_EQ(run.response.buildings[0].edge_drift_ratio().size(), 0);  // its planes tell of theirs
  EXPECT_TRUE(shows(page_of(run), "Drift at an edge"));
  run.problem.collapse_drift = run.c.analysis.collapse_drift = 0.5 * peaks.edge_drift_ratio().maxCoeff();
  const StoryTable checks = hand_in(run).checks;
  const std::vector<std::string>& names = checks.columns.at(0).texts;
  const auto last = std::find(names.rbegin(), names.rend(), "check.drift");
  EXPECT_NE(checks.columns.at(3).texts.at(static_cast<std::size_t>(names.rend() - last) - 1), "–");
  const std::vector<Statement> told = run_story(run).statements;
  EXPECT_TRUE(std::any_of(told.begin(), told.end(), [](const Statement& one) {
    return one.kind == "drift_beyond" && one.buildings == std::vector<Eigen::Index>{1};
  }));
}

/// Where no drift is known no number is told; that a building falls is.
TEST(PlanReport, TellsNoDriftThatIsNotKnown) {
  PlanRun run = twisting_pair();
  run.response.buildings[0].planes.clear();
  run.response.collapse = Collapse{};
  run.response.collapse->building = 0;
  const StoryTable checks = hand_in(run).checks;
  const std::vector<std::string>& names = checks.columns.at(0).texts;
  const auto row = static_cast<std::size_t>(std::find(names.begin(), names.end(), "check.drift") - names.begin());
  EXPECT_EQ(checks.columns.at(5).texts.at(row), "check.not_met");
}

/// In both languages every sentence of the story stands there, and no key of the catalogue or word without its value.
TEST(PlanReport, TellsTheStory) {
  const PlanRun three = test::plan_run(test::twisting_pair() + test::wall_beside);
  for (const PlanRun* const run : {&twisting_pair(), &three}) {
    for (const std::string language : {"en", "id"}) {
      std::string page = page_of(*run, language);
      for (const char* const mark : {"<strong>", "</strong>"}) {  // of first sentences
        for (std::size_t at = 0; (at = page.find(mark, at)) != std::string::npos;) page.erase(at, std::strlen(mark));
      }
      const std::vector<SaidStatement> all = said(run_story(*run).statements, Words(language));
      const std::optional<SaidTable> known = known_table(gap_names(run->problem), all, Words(language));
      ASSERT_TRUE(known);
      for (const TableColumn& column : known->columns) {
        for (const std::string& cell : column.cells) EXPECT_TRUE(shows(page, cell)) << cell;
      }
      for (const SaidStatement& one : all) {
        const bool is_single = run->problem.gaps.size() == 1;
        if (one.shown == Shown::sentence || (one.shown == Shown::table && !is_single)) {
          EXPECT_TRUE(shows(page, one.text)) << one.text;
        }
      }
      std::string shown = page.substr(page.find("<body"));
      for (std::size_t at = 0; (at = shown.find("<script", at)) != std::string::npos;) {
        shown.erase(at, shown.find("</script>", at) - at);
      }
      EXPECT_FALSE(std::regex_search(shown, std::regex(R"(\{\w*\}|story\.\w|>plan\.)")));
      EXPECT_EQ(std::count(page.begin(), page.end(), '\0'), 0);
    }
    EXPECT_TRUE(shows(page_of(*run, "id"), "pusat kekakuan"));
  }
  EXPECT_TRUE(shows(page_of(three), ">Walled | Frame<"));  // bars of several gaps have their names
}

/// Links have a table in it with where they are, and a line in both pictures.
TEST(PlanReport, TellsOfLinks) {
  const PlanRun linked = test::plan_run(test::twisting_pair() +
                                        "\n[[link]]\nbetween = [\"Frame\", \"Walled\"]\nelevations = [3.5, 6.7]\n"
                                        "law = \"cable\"\nstiffness = 2e4\nat = 3\n");
  ASSERT_GT(linked.response.links.at(1).peak_tension, 0);
  for (const std::string language : {"en", "id"}) {
    const std::string page = page_of(linked, language), table = page.substr(page.find("Walled – Frame</h3>"), 4000);
    EXPECT_TRUE(shows(table, ">12.02</td>")) << table;
    EXPECT_TRUE(shows(table, ">" + number(linked.response.links[1].peak_tension) + "</td>")) << table;
    EXPECT_TRUE(shows(page, language == "en" ? ">link<" : ">penghubung<"));  // the legend of the still
    EXPECT_TRUE(shows(page, R"("links":[{"left":)"));
  }
  EXPECT_FALSE(shows(page_of(twisting_pair()), ">link<"));
}

/// A corner near the end of the edge before it is told of where both buildings may move further than that along it.
TEST(PlanReport, TellsOfCornersThatMayLeaveTheirEdge) {
  const auto tells = [](const std::string& polygon, const std::string& pga = "3.4") {
    const std::string text = test::twisting_pair("size = [15.0, 18.0]", "polygon = " + polygon);
    const PlanRun run = test::plan_run(test::with(text, "pga = 3.4", "pga = " + pga));
    EXPECT_GT(run.response.impacts.size(), 0U);
    for (const Statement& one : run_story(run).statements) {
      if (one.kind == "remark.end_of_edge") return true;
    }
    return false;
  };
  EXPECT_FALSE(tells("[[0, 0], [15, 0], [15, 18], [0, 18]]"));
  EXPECT_FALSE(tells("[[0, 9], [9, 0], [18, 9], [9, 18]]"));       // a corner before the middle of an edge
  EXPECT_FALSE(tells("[[0, 17.99], [9, 9], [18, 17], [9, 25]]"));  // before the end of one, which is looked at
  EXPECT_FALSE(tells("[[0, 17.6], [9, 9], [18, 17], [9, 25]]"));
  EXPECT_TRUE(tells("[[0, 17.6], [9, 9], [18, 17], [9, 25]]", "13"));  // beyond what is looked at, 5 % of the height
}

/// Every number is that of the quantities; the list of impacts can be saved as impacts.csv.
TEST(PlanReport, HoldsTheNumbers) {
  const PlanRun& run = twisting_pair();
  const std::string page = page_of(run);
  const std::string opening = "id=\"impacts-csv\">";
  const std::size_t start = page.find(opening) + opening.size();
  EXPECT_EQ(nlohmann::json::parse(page.substr(start, page.find("</script>", start) - start)), impacts_csv(run));
  for (const char* const told : {">0.08747</td>", ">2045</td>", "north frame", ">80.26</td>"}) {
    EXPECT_TRUE(shows(page, told)) << told;
  }
  const std::size_t sorted = page.find("data-sorted=\"1\"");
  ASSERT_NE(sorted, std::string::npos);  // #, and then the peak force
  EXPECT_TRUE(shows(page, "class=\"gapbars\""));
  // Floors of no contact point are watched, so that the bar tells of all of them.
  const std::string apart = test::with(test::twisting_pair("[12.04, 0.0]", "[12.4, 0.0]"), "= 0.10 ", "= 0.50 ");
  EXPECT_TRUE(shows(page_of(test::plan_run(apart)), "class=\"gapbars\""));
  const std::string one_watched = test::with(apart, "[3.5, 3.2]\nmasses = [250", "[3.5, 2.0]\nmasses = [250");
  EXPECT_TRUE(shows(page_of(test::plan_run(one_watched)), "class=\"gapbars\""));
}

/// Of a gap that is a wedge the bars are of one place, where it falls short the most, as the sentences are.
TEST(PlanReport, BarsAreOfOnePlace) {
  const std::string wedge = test::with(test::twisting_pair(), "corner = [12.04, 0.0]\nsize = [15.0, 18.0]",
                                       "polygon = [[12.02, 0], [27, 0], [27.4, 18], [12.4, 18]]");
  ASSERT_TRUE(shows(wedge, "polygon"));
  const PlanRun run = test::plan_run(wedge);
  const auto level = governing_level(run, 0);
  ASSERT_TRUE(level && level->gap_needed_reversed);
  const std::string page = page_of(run);
  const std::size_t begin = page.find("class=\"gapbars\"");
  const std::string bars = page.substr(begin, page.find("</table>", begin) - begin);
  for (const double value : {level->width, level->gap_needed, *level->gap_needed_reversed}) {
    EXPECT_TRUE(shows(bars, number(value))) << value << bars;
  }
  EXPECT_EQ(*gap_needed_reversed(row_of(run)->problem, row_of(run)->response, 0), *level->gap_needed_reversed);
}

/// Of many houses paper has the modes that move the most mass along x and along y, not a first one that moves none.
TEST(PlanReport, HasOfManyTheModesThatCount) {
  std::string text =
      "[units]\nlength = \"m\"\nforce = \"kN\"\n[plan]\nclearance = 0.1\ncontact = { law = \"linear\", stiffness = 4e5 "
      "}\n"
      "[excitation]\nkind = \"harmonic\"\nacceleration_amplitude = 0.5\nperiod = 0.5\n[analysis]\nduration "
      "= 0.5\n";
  constexpr int houses = 7;
  for (int n = 0; n < houses; ++n) {
    // Stiff along x and soft along y, so that the first mode is along y: mass 120 t, 10 m apart.
    text += "[[building]]\nname = \"H" + std::to_string(n) + "\"\ndamping = 0.05\n[building.plan]\ncorner = [" +
            std::to_string(n * 10.05) +
            ", 0.0]\nsize = [10.0, 12.0]\nstorey_heights = [3.0]\nmasses = [120.0]\n[building.rigidity]\n"
            "centre = [5.0, 6.0]\nx = " +
            std::to_string(40000 + 1000 * n) + "\ny = 10000\ntorsion = 9e6\n";
  }
  const std::string page = page_of(test::plan_run(text));
  const std::size_t begin = page.find(">Modes</th>"), end = page.find("</table>", begin);
  ASSERT_NE(begin, std::string::npos);
  const std::string table = page.substr(begin, end - begin);
  for (int n = 0; n < houses; ++n) {
    const double along_x = 2 * std::numbers::pi * std::sqrt(120.0 / (40000 + 1000 * n));
    EXPECT_TRUE(shows(table, ">H" + std::to_string(n) + "</td><td>" + fmt::format("{:.4f}", along_x))) << table;
  }
  const std::string alike = page.substr(end, page.find("</div>", end + 10) - end + 200);
  EXPECT_TRUE(shows(alike, "Mode along x 2; Mass along x 100\u00A0%; Mode along y 1; Period 0.6883\u00A0s;")) << alike;
}

TEST(PlanReport, ShowsTextsOfTheCaseAsTheyAre) {
  const std::string evil = "<script>alert(1)</script>";
  const PlanRun run = test::plan_run(test::twisting_pair("\"Walled\"", "\"" + evil + "\""));
  const std::string page = page_of(run);
  EXPECT_FALSE(shows(page, evil));
  EXPECT_TRUE(shows(page, "&lt;script&gt;alert(1)"));
}

TEST(PlanReport, SaysHowPlanesYield) {
  const std::string before = "[[building.plane]]\nname = \"west";
  const PlanRun run =
      test::plan_run(test::twisting_pair(before, "yield_forces = [777, 888]\nhardening = 0.05\n" + before));
  const std::string page = page_of(run);
  EXPECT_TRUE(shows(page, "777"));
  EXPECT_TRUE(shows(page, "Ductility"));
}

TEST(PlanReport, TellsOfHingesOfFrames) {
  const PlanRun run = test::plan_run(test::hinged_pair());
  const std::string page = page_of(run);
  for (const char* const text : {"Walled, middle", "Walled, across", "Moment capacity"}) {
    EXPECT_TRUE(shows(page, text)) << text;
  }
  const std::vector<FigureKind> kinds = figure_kinds(run);
  for (const std::string kind : {"hinges", "hinge-loop"}) {
    EXPECT_TRUE(std::any_of(kinds.begin(), kinds.end(), [&](const auto& one) { return one.name == kind; })) << kind;
    const Figure figure = make_figure(run, kind, {});
    EXPECT_EQ(figure.panels.size(), 2U) << kind;
    EXPECT_NE(figure.finding.find("Walled, middle"), std::string::npos) << figure.finding;
  }
}

/// The report of results is that of the run.
TEST(PlanReport, OfResultsIsThatOfTheRun) {
  PlanRun run = test::plan_run(test::twisting_pair());
  const TemporaryFolder folder;
  AtomicFiles files(folder.path());
  files.add("summary.json", summary_json(run, "0"), ResultKind::summary);
  files.add("histories.nc", histories_netcdf(run, "0"), ResultKind::histories);
  files.add("case.toml", run.c.source->text, ResultKind::case_copy);
  files.commit();
  EXPECT_EQ(page_of(read_plan_results(folder.path())), page_of(run));
  run.response.histories = {};
  EXPECT_THROW((void)page_of(run), InvalidParameter);
}

}  // namespace
}  // namespace bentur
