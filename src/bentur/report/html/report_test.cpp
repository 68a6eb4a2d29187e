#include "bentur/report/html/report.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "bentur/core/errors.h"
#include "bentur/core/number_text.h"
#include "bentur/io/case/case_toml.h"
#include "bentur/io/file_identity.h"
#include "bentur/io/results/result_csv.h"
#include "bentur/report/html/internal/motion_data.h"
#include "bentur/report/html/internal/page.h"
#include "bentur/report/html/internal/page_figures.h"
#include "bentur/report/html/page_parts.h"

namespace bentur {
namespace {

struct Simulated : RunResults {
  [[nodiscard]] std::string page(const std::string& language = "en") const {
    return report_html(*this, {.language = language, .version = "0"});
  }
};

Simulated run(const std::string& text) {
  Diagnostics diagnostics;
  auto c = read_case_text(text, std::string(BENTUR_SOURCE_DIR) + "/examples/case.toml", diagnostics);
  if (!c) throw std::runtime_error(diagnostics.errors().front().text());
  Problem problem = make_problem(*c);
  SolveOptions options = solve_options(*c);
  options.output_step = report_output_step(problem);
  Response response = solve(problem, c->analysis.solver, options);
  return {run_results(std::move(*c), std::move(problem), std::move(response))};
}

std::string example(const std::string& name) {
  std::ifstream stream(std::string(BENTUR_SOURCE_DIR) + "/examples/" + name + ".toml");
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  EXPECT_NE(text.find(from), std::string::npos) << from;
  for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size())) {
    text.replace(at, from.size(), to);
  }
  return text;
}

/// The JSON that the script gets to read.
std::string json_of(const std::string& page, const std::string& id = "data") {
  const std::string opening = "<script type=\"application/json\" id=\"" + id + "\">";
  const std::size_t start = page.find(opening) + opening.size();
  return page.substr(start, page.find("</script>", start) - start);
}

nlohmann::json data_of(const std::string& page) { return nlohmann::json::parse(json_of(page)); }

std::string decoded(const std::string& text) {
  const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  unsigned bits = 0;
  int count = 0;
  for (const char c : text) {
    if (c == '=') break;
    bits = bits << 6U | static_cast<unsigned>(digits.find(c));
    count += 6;
    if (count >= 8) {
      count -= 8;
      bytes += static_cast<char>(bits >> count & 0xFFU);
    }
  }
  return bytes;
}

/// Without the spaces that no line break separates.
std::string plain(const std::string& page) { return replaced(page, "\u00A0", " "); }

bool has(const std::string& page, const std::string& text) { return page.find(text) != std::string::npos; }

/// What is not known has a colour of its own beside what pounds.
TEST(Report, WhatIsNotKnownIsNotRed) {
  const std::string page = run(replaced(example("two-frames-si"), "width = 0.05\n", "width = 0.39\n")).page();
  EXPECT_TRUE(has(page, "class=\"verdict open\""));
  EXPECT_TRUE(has(page, "<p class=\"badge\" data-open>Not known</p>"));
  const std::string pounds = run(example("two-frames-si")).page();
  EXPECT_TRUE(has(pounds, "class=\"verdict pounds\"") && !has(pounds, " data-open>"));
}

TEST(Report, Base64IsThatOfTheStandard) {
  EXPECT_EQ(html::base64(""), "");
  EXPECT_EQ(html::base64("f"), "Zg==");
  EXPECT_EQ(html::base64("fo"), "Zm8=");
  EXPECT_EQ(html::base64("foobar"), "Zm9vYmFy");  // RFC 4648, 10
  EXPECT_EQ(html::base64("\xFF\xEF\xBE"), "/+++");
}

TEST(Report, VerdictComesFirstWithNumbersOfTheResponse) {
  const Simulated m12 = run(example("m12-el-centro"));
  const std::string page = plain(m12.page());
  EXPECT_TRUE(
      has(page, "Model 1 and Model 2 collide " + std::to_string(m12.response.impacts.size()) + " times in 10 s"));
  EXPECT_TRUE(has(page, "they need 0.7262 cm at level 300 cm; the 0.2 cm given there are 0.5262 cm too small."));
  EXPECT_TRUE(has(page, "more than is given; 0.04538 cm less than this motion needs, as recorded or reversed"));
  EXPECT_LT(page.find("collide"), page.find("<table", page.find("id=\"verdict\"")));
  EXPECT_TRUE(has(page, "<td>kgf") || has(page, "kgf/cm²"));
  EXPECT_TRUE(has(page, "341.7 cm/s² = 0.3487 g"));  // 341.7/980
  EXPECT_LT(page.size(), 2'000'000U);
}

TEST(Report, NoPoundingIsSaidSo) {
  const std::string wide = replaced(example("m12-el-centro"), "width = 0.2 ", "width = 5.0 ");
  const std::string page = plain(run(replaced(wide, "duration = 10.0", "")).page());
  const std::string cut = plain(run(wide).page());
  EXPECT_FALSE(has(cut, "No pounding"));
  EXPECT_TRUE(has(cut, "the motion goes on after the end of the run"));
  EXPECT_TRUE(has(page, "No pounding"));
  EXPECT_TRUE(has(page, "do not touch in 31."));
  EXPECT_TRUE(has(page, "4.274 cm to spare"));
  EXPECT_FALSE(has(page, "<table id=\"impact-list\""));
  EXPECT_TRUE(has(page, "There were no impacts."));
}

TEST(Report, EveryRuleOfTheCaseIsShown) {
  const std::string code =
      "\n[code]\nen-1998-1 = { behaviour_factor = 1.0 }\nnbcc = { ductility_factor = 1.0, overstrength_factor = 1.0, "
      "importance_factor = 1.0 }\n";
  const Simulated m12 = run(example("m12-el-centro") + code);
  const std::string page = m12.page();
  for (const CodeRuleSpec& rule : m12.c.code.rules) {
    EXPECT_TRUE(has(page, std::string(find_code_rule(rule.rule)->title))) << rule.rule;
    EXPECT_TRUE(has(page, std::string(find_code_rule(rule.rule)->clause))) << rule.rule;
  }
}

TEST(Report, HingesThatTurnedFurthest) {
  const Simulated pair = run(example("hinged-frame"));
  const std::string page = plain(pair.page());
  EXPECT_TRUE(has(page, "Hinges of Old frame, those that turned furthest"));
  EXPECT_TRUE(has(page, "Contact events (a contact closes, opens or changes its branch of the law)"));
  EXPECT_EQ(pair.response.events, 2 * std::ssize(pair.response.impacts)) << "and no hinges";
  EXPECT_TRUE(has(page, "right end"));
  EXPECT_TRUE(has(page, "Old frame has a soft storey"));
  EXPECT_TRUE(has(page, "times that limit"));
  EXPECT_TRUE(has(page, "Moment over rotation of the hinge of each building that turned furthest"));
  EXPECT_TRUE(has(page, "numbered in the order in which they formed"));
  EXPECT_TRUE(has(page, R"({"tone":"teal","mark":"●","text":"beyond IO"})")) << "what dots in motion mean";
  EXPECT_TRUE(has(plain(pair.page("id")), "Sendi plastis Old frame, yang berputar paling jauh"));
  EXPECT_FALSE(has(plain(run(example("two-frames-si")).page()), "Hinges"));
}

TEST(Report, BuildingsThatYield) {
  const Simulated pair = run(example("yielding-pair"));
  const std::string page = plain(pair.page());
  EXPECT_TRUE(has(page, "Storeys that yield"));
  EXPECT_TRUE(has(page, "bilinear, kinematic hardening"));
  EXPECT_TRUE(has(page, "Stiffness-proportional, ratio in mode 1"));
  EXPECT_TRUE(has(page, "Yield forces"));
  EXPECT_TRUE(has(page, "Ductility without contact"));
  EXPECT_TRUE(has(page, "members, storeys and bearings yield, and lose strength, only where the case says so"));
  EXPECT_FALSE(has(page, "computed as linear elastic"));
  EXPECT_TRUE(has(plain(pair.page("id")), "Daktilitas tanpa kontak"));
  const std::string tangent =
      replaced(example("yielding-pair"), "damping = { s", "damping_stiffness = \"tangent\"\ndamping = { s");
  EXPECT_TRUE(has(plain(run(tangent).page()), "tangent where a storey yields"));
  EXPECT_FALSE(has(plain(run(example("free-impact")).page()), "Ductility"));
}

// Every number and word of a case stands in its report, with its unit, and what is left out as it is by default.
TEST(Report, TheInputIsTheCaseKeyByKey) {
  const std::string english = plain(run(example("generic-neighbour")).page());
  for (const std::string shown :
       {"<th scope=\"row\">Half-space: Shear wave velocity</th><td>", "<th scope=\"row\">Foundation: Mass</th>",
        "<th scope=\"row\">Formula for the period: Exponent</th>", "<th scope=\"row\">Kinematics</th>"}) {
    EXPECT_TRUE(has(english, shown)) << shown;
  }
  const std::string indonesian = plain(run(example("generic-neighbour")).page("id"));
  EXPECT_TRUE(has(indonesian, "<th scope=\"row\">Setengah ruang: Kecepatan gelombang geser</th><td>"));
  EXPECT_TRUE(has(indonesian, "(bawaan)"));
  Simulated changed = run(example("m12-el-centro"));
  EXPECT_TRUE(has(plain(changed.page()), "condensed statically (default)"));
  changed.c.given = nullptr;  // as of a case that was put together in memory
  EXPECT_TRUE(has(plain(changed.page()), "The case file is not at hand"));
}

TEST(Report, BearingsWallsAndTheirAnimation) {
  const Simulated moat = run(example("isolated-moat"));
  const std::string page = plain(moat.page());
  EXPECT_TRUE(has(page, "bearings"));
  EXPECT_FALSE(has(page, ">nan<"));
  EXPECT_FALSE(has(page, ">inf<"));
  const nlohmann::json data = data_of(moat.page());
  std::vector<std::string> roles;
  for (const nlohmann::json& shape : data.at("scene").at("shapes")) roles.push_back(shape.at("role"));
  EXPECT_EQ(roles, (std::vector<std::string>{"ground", "bearing", "wall", "column", "slab", "wall"}));
  EXPECT_GT(data.at("scene").at("breadths").at(0).get<double>(), 0) << "a wall is drawn with some width";
}

TEST(Report, SoilAndANeighbourKnownByLittle) {
  const Simulated pair = run(example("generic-neighbour"));
  const std::string page = plain(pair.page());
  EXPECT_TRUE(has(page, "Foundation, relative to the free field"));
  EXPECT_TRUE(has(plain(pair.page("id")), "Fondasi"));
  EXPECT_FALSE(has(page, ">nan<"));
  EXPECT_FALSE(has(page, "collapses"));
}

TEST(Report, CollapseComesFirst) {
  const std::string weak = replaced(example("generic-neighbour"), "1.8e5]", "1.8e5]\nyield_forces = 600");
  const Simulated pair = run(weak + "collapse_drift = 0.01\n");
  ASSERT_TRUE(pair.response.collapse);
  const std::string page = plain(pair.page());
  EXPECT_TRUE(has(page, "New collapses at"));
  EXPECT_TRUE(has(page, "exceeds 1 % of its height"));
  EXPECT_LT(page.find("New collapses at"), page.find("<p class=\"badge\">Pounding"));
  EXPECT_TRUE(has(plain(pair.page("id")), "New runtuh pada"));
}

TEST(Report, LinksOfTheCaseAndWhatTheyDid) {
  const std::string page = plain(run(example("linked-pair")).page());
  EXPECT_TRUE(has(page, "Links Tall – Low"));
  EXPECT_TRUE(has(page, "spring and dashpot"));
  EXPECT_TRUE(has(page, "Peak pull"));
  EXPECT_TRUE(has(page, "Yield force"));
  EXPECT_FALSE(has(plain(run(example("free-impact")).page()), "Links"));
}

TEST(Report, TheSameRunGivesTheSameBytes) {
  EXPECT_EQ(run(example("row-of-three")).page(), run(example("row-of-three")).page());
}

TEST(Report, Indonesian) {
  const std::string page = run(example("m12-el-centro")).page("id");
  EXPECT_TRUE(has(page, "<html lang=\"id\">"));
  EXPECT_TRUE(has(page, "Model 1 dan Model 2 berbenturan"));
  for (const std::string english : {"Verdict", "Gap needed", "collide", "Peak force", "Magnification"}) {
    EXPECT_FALSE(has(page, english)) << english;
  }
  EXPECT_THROW(static_cast<void>(run(example("free-impact")).page("fr")), InvalidParameter);
}

TEST(Report, SamplesAreThoseOfTheResponseWithinTheirScale) {
  const Simulated m12 = run(example("m12-el-centro"));
  const std::string page = m12.page();
  const nlohmann::json data = data_of(page);
  for (std::size_t b = 0; b < 2; ++b) {
    const Eigen::MatrixXd& x = m12.response.histories.displacement[b];
    const std::string bytes = decoded(data["buildings"][b]["samples"]);
    const double scale = data["buildings"][b]["scale"];
    ASSERT_EQ(bytes.size(), static_cast<std::size_t>(2 * x.size()));
    for (Eigen::Index k = 0; k < x.size(); ++k) {
      const auto low = static_cast<unsigned char>(bytes[static_cast<std::size_t>(2 * k)]);
      const auto high = static_cast<unsigned char>(bytes[static_cast<std::size_t>(2 * k + 1)]);
      const auto whole = static_cast<std::int16_t>(low | high << 8);
      ASSERT_NEAR(whole * scale, x.data()[k], 0.5001 * scale);  // rounding to the nearest; columns are instants
    }
    EXPECT_NEAR(scale, x.cwiseAbs().maxCoeff() / 32767, 1e-12 * scale);
  }
  EXPECT_NEAR(data["step"], 5e-4, 1e-12);
  ASSERT_EQ(data["impacts"].size(), m12.response.impacts.size());
  EXPECT_EQ(data["impacts"][6][1], m12.response.impacts[6].start);
  EXPECT_EQ(nlohmann::json::parse(json_of(page, "impacts-csv")), impacts_csv(m12.view()));
}

/// What has no colour of its own is that of the page, on a dark screen too.
TEST(Report, DuctilitiesStandInTheInkOfThePage) {
  const Simulated pair = run(example("yielding-pair"));
  const std::string page = pair.page();
  const std::size_t from = page.find("class=\"damage\"");
  ASSERT_NE(from, std::string::npos);
  const std::string drawn = page.substr(from, page.find("</svg>", from) - from);
  EXPECT_TRUE(has(drawn, R"(fill="none" stroke="currentColor")"));
  const Eigen::VectorXd& ductility = pair.response.buildings[0].yielding.ductility;
  EXPECT_TRUE(has(drawn, R"(fill="currentColor">)" + number(ductility(2)) + "<"));
  EXPECT_TRUE(has(drawn, R"(fill="#000000">)" + number(ductility(0)) + "<"));
  EXPECT_FALSE(has(drawn, R"(fill="#ffffff" stroke)"));
}

TEST(Report, LongRunsStaySmall) {
  Problem problem = run(example("two-frames-si")).problem;
  const auto floors = static_cast<double>(problem.buildings[0].model.floors() + problem.buildings[1].model.floors());
  for (const double duration : {0.01, 10.0, 60.0, 600.0, 1e5}) {
    problem.duration = duration;
    const double step = report_output_step(problem);
    const double bytes = 8.0 / 3 * floors * (duration / step + 1);  // 16 bits in base64
    EXPECT_LT(bytes, duration <= 10 ? 7e5 : 3.1e6) << duration;
    EXPECT_GE(duration / step, 99) << duration;
  }
}

TEST(Report, TextOfACaseCannotBringInMarkupOrScript) {
  const std::vector<std::string> hostile = {"<script>alert(1)</script>",
                                            "</script><script>alert(2)</script>",
                                            "\"><img src=x onerror=alert(3)>",
                                            "' onmouseover='alert(4)",
                                            "`${alert(5)}`",
                                            "\"; system('touch pwned'); \"",
                                            "<!-- ]]> {left}",
                                            "</title></style><svg onload=alert(6)>"};
  for (const std::string& text : hostile) {
    const std::string quoted = nlohmann::json(text).dump();  // TOML's basic strings have these escapes too
    std::string source = replaced(example("m12-el-centro"), "\"Model 1\"", quoted);
    source = replaced(source, "\"Monograph M1-2, El Centro\"", quoted);
    const Simulated injected = run(source);
    const Simulated harmless = run(example("m12-el-centro"));
    for (const std::string language : {"en", "id"}) {
      const std::string page = injected.page(language);
      std::string shown = page;
      for (const char* const id : {"data", "impacts-csv"}) {
        EXPECT_FALSE(has(json_of(page, id), "<")) << text;
        shown = replaced(shown, json_of(page, id), "");
      }
      EXPECT_FALSE(has(shown, text)) << text;
      EXPECT_EQ(data_of(page)["buildings"][0]["name"], text);
      // As many tags of every kind as without it: nothing was opened or closed.
      for (const std::string tag : {"<script", "</script", "<img", "<svg", "<!--", "</title", "</style", "</td"}) {
        const auto count = [&](const std::string& in) {
          std::size_t n = 0;
          for (std::size_t at = in.find(tag); at != std::string::npos; at = in.find(tag, at + 1)) ++n;
          return n;
        };
        EXPECT_EQ(count(page), count(harmless.page(language))) << text << ": " << tag;
      }
    }
  }
}

TEST(Report, ThePolicyLetsInTheOwnScriptAndStyleAlone) {
  const std::string page = run(example("m12-el-centro")).page("en");
  const auto between = [&](const std::string& opens, const std::string& closes) {
    const std::size_t from = page.find(opens) + opens.size();
    return page.substr(from, page.find(closes, from) - from);
  };
  const std::string policy = between("Content-Security-Policy\" content=\"", "\"");
  for (const auto& [directive, text] :
       {std::pair{"script-src", between("<script>", "</script>")}, {"style-src", between("<style>", "</style>")}}) {
    std::string bytes;
    for (std::size_t i = 0; i < 64; i += 2) {
      bytes += static_cast<char>(std::stoi(sha256(text).substr(i, 2), nullptr, 16));
    }
    EXPECT_TRUE(has(policy, fmt::format("{} 'sha256-{}';", directive, html::base64(bytes)))) << policy;
  }
  EXPECT_FALSE(has(policy, "unsafe"));
  EXPECT_FALSE(has(between("<body>", "<script>"), " style="));  // which no hash lets in
}

TEST(Report, FiguresStandInlineInThePagesOwnStyle) {
  const html::PageFigure figure{.caption = "a < b", .svg = "<svg class=\"bentur\"></svg>"};
  const std::string section = html::figures_section(Words("en"), {figure, figure}).content.str();
  EXPECT_TRUE(has(section, "<figure><svg class=\"bentur\"></svg><figcaption>Figure 1. a &lt; b</figcaption>"));
  EXPECT_TRUE(has(section, "<figcaption>Figure 2. a &lt; b</figcaption>"));
  EXPECT_TRUE(html::figures_section(Words("en"), {}).content.str().empty());
  const Simulated impact = run(example("free-impact"));
  const std::string page = impact.page();
  EXPECT_TRUE(has(page, ".bentur .stroke-blue{stroke:var(--blue)}"));
  // Every kind that tells something stands there once.
  std::size_t drawn = 0;
  for (const FigureKind& kind : figure_kinds(impact)) drawn += kind.tells ? 1 : 0;
  std::size_t found = 0;
  for (std::size_t at = page.find("<figcaption>"); at != std::string::npos; at = page.find("<figcaption>", at + 1)) {
    ++found;
  }
  EXPECT_EQ(found, drawn + 1) << "and the opening figure";
  const auto make = [&](const std::string& kind, const FigureOptions& options) {
    return make_figure(impact, kind, options);
  };
  for (const html::PageFigure& one : html::page_figures(figure_kinds(impact), make, "figure.", "en")) {
    EXPECT_TRUE(has(page, one.svg)) << one.caption;
  }
}

/// A column of zeros is left out, and why it is not there is said below; without contact nothing is said.
TEST(Report, ElasticContactHasNoColumnOfWhatIsLost) {
  const std::string note = "No energy is lost across the gap: the contact is elastic.", lost = ">Energy lost<";
  const std::string text = example("two-frames-si");
  ASSERT_NE(text.find("law = \"linear\""), std::string::npos);
  const std::string elastic = run(text).page();
  EXPECT_TRUE(has(elastic, note) && !has(elastic, lost));
  const std::string lossy = run(example("struck-column")).page();
  EXPECT_TRUE(!has(lossy, note) && has(lossy, lost));
  const std::string apart = run(replaced(text, "width = 0.05", "width = 2.0")).page();
  EXPECT_TRUE(!has(apart, note) && has(apart, lost));
}

/// What is higher than a third of a page is of two pictures, between which a page may end, or of one for each of three
/// rows, under one caption, and comes last; those of a column's width come first, two to a line.
TEST(Report, HighFiguresArePartedForPaper) {
  const Simulated frames = run(example("row-of-three"));
  const auto make = [&](const std::string& kind, const FigureOptions& options) {
    return make_figure(frames, kind, options);
  };
  const std::vector<html::PageFigure> figures = html::page_figures(figure_kinds(frames), make, "figure.", "en");
  const auto pictures = [](const std::string& markup) {
    std::size_t count = 0;
    for (std::size_t at = 0; (at = markup.find("class=\"bentur\"", at)) != std::string::npos; ++at) ++count;
    return count;
  };
  std::size_t parted = 0;
  bool wide_before = false;
  for (const html::PageFigure& one : figures) {
    EXPECT_TRUE(one.is_parted ? pictures(one.svg) > 1 : pictures(one.svg) == 1) << one.caption;
    EXPECT_TRUE(one.wide || !wide_before) << one.caption << " has no neighbour";
    EXPECT_TRUE(one.is_parted || parted == 0) << one.caption << " would fill what the one before it leaves";
    parted += one.is_parted ? 1 : 0;
    wide_before = one.wide;
  }
  EXPECT_GE(parted, 1U) << "of two gaps";
  const std::string section = html::figures_section(Words("en"), figures).content.str();
  EXPECT_TRUE(has(section, "<figure class=\"broad parted\"><div class=\"wide\""));
}

/// When an impact is hardest stands beside how hard it is, and the table says its order.
TEST(Report, ImpactsHaveTheTimeOfTheirPeak) {
  const Simulated impact = run(example("two-frames-si"));
  const std::vector<TableColumn> columns = impact_columns(impact, "en");
  const auto force = std::find_if(columns.begin(), columns.end(),
                                  [](const TableColumn& column) { return column.label == "Peak force"; });
  ASSERT_NE(force, columns.end());
  ASSERT_NE(force + 1, columns.end());
  EXPECT_EQ((force + 1)->label, "Peak at");
  EXPECT_EQ((force + 1)->unit, "s");
  const auto& impacts = impact.response.impacts;
  const auto hardest = std::max_element(impacts.begin(), impacts.end(),
                                        [](const Impact& a, const Impact& b) { return a.peak_force < b.peak_force; });
  EXPECT_EQ((force + 1)->cells.front(), fmt::format("{:.4f}", hardest->peak_force_time));
  EXPECT_TRUE(has(impact.page(), ">Impacts, the hardest first</th>"));
}

TEST(Report, ImpactsWithoutDurationHaveASpeedInPlaceOfAForce) {
  const std::string page = run(replaced(example("free-impact"), R"(law = "linear", stiffness = 2.0e8)",
                                        R"(law = "restitution", restitution = 0.6)"))
                               .page();
  EXPECT_TRUE(has(page, "The fastest impact closes at "));
  EXPECT_FALSE(has(page, "The hardest impact reaches"));
}

TEST(Report, NeedsHistories) {
  Simulated m12 = run(example("free-impact"));
  m12.response.histories = {};
  EXPECT_THROW(static_cast<void>(m12.page()), InvalidParameter);
}

/// The head names files without folders of the machine, and the whole version.
TEST(Report, ItsHeadIsATitleBlock) {
  const std::string data = std::string(BENTUR_SOURCE_DIR) + "/data/el-centro-1940-ns.csv";
  const Simulated m12 = run(replaced(example("m12-el-centro"), "../data/el-centro-1940-ns.csv", data));
  RunResults hashed = m12;
  hashed.c.excitation.record.value().sha256 = std::string(64, 'a');
  const std::string page = report_html(hashed, {.version = "0.2.0.dev5+gabc.dirty"});
  const std::string head = page.substr(page.find("<header>"), page.find("</header>") - page.find("<header>"));
  // The whole version: another build of the same number may say another thing.
  EXPECT_NE(head.find("bentur 0.2.0.dev5+gabc.dirty<"), std::string::npos) << head;
  EXPECT_NE(head.find(">el-centro-1940-ns.csv, SHA-256 aaaaaaaaaaaaaaaa…<"), std::string::npos) << head;
  for (const char* const label : {">Report<", ">Record<"}) EXPECT_NE(head.find(label), std::string::npos) << label;
}

/// Where the next figure has no room below those before it one that has comes first; one that is alone takes the width.
TEST(Report, FiguresFillTheirPages) {
  const auto make = [](const std::string& kind, const FigureOptions& options) {
    Figure figure{.width = options.narrow || kind == "loop" ? column_width : page_width};
    for (int row = 0; row < (kind == "spectrum" || kind == "loop" ? 1 : 3); ++row) {
      figure.panels.push_back({.height = 5, .curves = {{.x = {0, 1}, .y = {0, 1}}}});
    }
    return figure;
  };
  const auto order_of = [&](const std::vector<FigureKind>& kinds) {
    return html::page_figures(kinds, make, "figure.", "en");
  };
  const std::vector<html::PageFigure> all = order_of({{"envelope", ""}, {"drift", ""}, {"spectrum", ""}});
  ASSERT_EQ(all.size(), 3U);
  EXPECT_TRUE(all[1].caption.starts_with("Response spectrum")) << all[1].caption;
  EXPECT_TRUE(order_of({{"loop", ""}}).front().wide);
}

}  // namespace
}  // namespace bentur
