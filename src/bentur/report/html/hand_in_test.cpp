#include "bentur/model/story/hand_in.h"
#include "bentur/core/number_text.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "bentur/io/case/case_toml.h"
#include "bentur/report/html/report.h"
#include "bentur/report/html/spectral_report.h"
#include "bentur/report/html/suite_report.h"
#include "bentur/report/kinds/kinds.h"
#include "bentur/study/suite/suite_hand_in.h"

namespace bentur {
namespace {

const std::string project_table =
    "\n[project]\nname = \"Hotel <Harapan>\"\nnumber = \"24-117\"\nengineer = \"S. Wirawan\"\nrevision = \"B\"\n"
    "date = \"14 March 2026\"\ncode_basis = \"SNI 1726:2019\"\nassumptions = [\"Infill is <b>separated</b>.\"]\n"
    "sources = [\"Drawings S-101.\"]\n";

std::string case_to_hand_in(const std::string& name, const std::string& more = project_table) {
  std::ifstream stream(std::string(BENTUR_SOURCE_DIR) + "/examples/" + name + ".toml");
  return std::string(std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()) + more;
}

Case case_of(const std::string& text, const std::string& folder = "/examples/") {
  Diagnostics diagnostics;
  auto c = read_case_text(text, BENTUR_SOURCE_DIR + folder + "case.toml", diagnostics);
  if (!c) throw std::runtime_error(diagnostics.errors().front().text());
  return *c;
}

RunResults run_to_hand_in(const std::string& text) {
  Case c = case_of(text);
  Problem problem = make_problem(c);
  SolveOptions options = solve_options(c);
  options.output_step = report_output_step(problem);
  Response response = solve(problem, c.analysis.solver, options);
  return run_results(std::move(c), std::move(problem), std::move(response));
}

std::string spectrum_to_hand_in(const std::string& language) {
  const Case c = case_of(case_to_hand_in("gaps/design-spectrum"), "/examples/gaps/");
  const Problem problem = make_still_problem(c);
  return spectral_report_html(c, problem, spectral_gaps(problem, *c.excitation.spectrum, c.code, c.units),
                              {.language = language, .version = "0"});
}

/// The ids of the page's sections, in order.
std::vector<std::string> sections_of(const std::string& page) {
  std::vector<std::string> ids;
  const std::string opening = "<section id=\"";
  for (std::size_t at = page.find(opening); at != std::string::npos; at = page.find(opening, at)) {
    at += opening.size();
    ids.push_back(page.substr(at, page.find('"', at) - at));
  }
  return ids;
}

bool holds(const std::string& page, const std::string& text) { return page.find(text) != std::string::npos; }

std::vector<std::string> kinds_of(const std::vector<Statement>& statements) {
  std::vector<std::string> kinds;
  for (const Statement& one : statements) kinds.push_back(one.kind);
  return kinds;
}

bool has_kind(const std::vector<Statement>& statements, const std::string& kind) {
  const std::vector<std::string> kinds = kinds_of(statements);
  return std::find(kinds.begin(), kinds.end(), kind) != kinds.end();
}

/// Row of the checks that begins with this word; -1: there is none.
std::ptrdiff_t row_of(const StoryTable& checks, const std::string& check) {
  const std::vector<std::string>& all = checks.columns.at(0).texts;
  const auto found = std::find(all.begin(), all.end(), check);
  return found == all.end() ? -1 : found - all.begin();
}

TEST(HandIn, AReportHasItsSectionsInOrderAndItsProject) {
  const RunResults run = run_to_hand_in(case_to_hand_in("m12-el-centro"));
  for (const char* const language : {"en", "id"}) {
    const std::string page = report_html(run, {.language = language, .version = "0"});
    const std::vector<std::string> expected = {"verdict", "assumptions", "input", "records", "checks",  "unchecked",
                                               "remarks", "motion",      "gaps",  "peaks",   "impacts", "figures"};
    EXPECT_EQ(sections_of(page), expected);
    EXPECT_TRUE(holds(page, "<body class=\"hand-in\">"));
    EXPECT_TRUE(holds(page, "<td>Hotel &lt;Harapan&gt;</td>"));
    EXPECT_TRUE(holds(page, "<td>24-117</td>") && holds(page, "<td>S. Wirawan</td>") && holds(page, "<td>B</td>"));
    EXPECT_TRUE(holds(page, "<li>Infill is &lt;b&gt;separated&lt;/b&gt;.</li>"));
    EXPECT_TRUE(holds(page, "<li>Drawings S-101.</li>"));
    EXPECT_TRUE(holds(page, "@top-left { content: \"Hotel\\20 \\3c Harapan\\3e \\20 \\b7 \\20 24\\2d 117"));
    EXPECT_EQ(page.find("<script>"), page.rfind("<script>"));
    // Where the width of the gap stands in the case.
    const std::string text = run.c.source->text;
    const auto line =
        1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(text.find("\nwidth")) + 1, '\n');
    EXPECT_TRUE(holds(page, (language == std::string("en") ? ">line " : ">baris ") + std::to_string(line) + "</td>"));
  }
}

TEST(HandIn, WithoutProjectNothingIsOtherThanBefore) {
  const std::string page = report_html(run_to_hand_in(case_to_hand_in("m12-el-centro", "")), {.version = "0"});
  const std::vector<std::string> expected = {"verdict", "remarks", "motion",  "gaps",
                                             "peaks",   "impacts", "figures", "input"};
  EXPECT_EQ(sections_of(page), expected);
  EXPECT_FALSE(holds(page, "<body class="));
  EXPECT_FALSE(holds(page, ">line "));
}

TEST(HandIn, ChecksAreThoseOfTheVerdict) {
  const RunResults run = run_to_hand_in(case_to_hand_in("m12-el-centro"));
  const HandIn told = hand_in(run);
  const auto simulated = row_of(told.checks, "check.gap");
  ASSERT_GE(simulated, 0);
  EXPECT_EQ(told.checks.columns[3].texts[simulated], "0.7262\u00A0cm");
  EXPECT_EQ(told.checks.columns[4].texts[simulated], "0.2\u00A0cm");
  EXPECT_EQ(told.checks.columns[5].texts[simulated], "check.not_met");
  const auto is_marked = [&](std::ptrdiff_t row) {
    const auto& marked = told.checks.marked;
    return std::find(marked.begin(), marked.end(), static_cast<std::size_t>(row)) != marked.end();
  };
  EXPECT_TRUE(is_marked(simulated));
  const auto solution = row_of(told.checks, "check.solution");
  EXPECT_EQ(told.checks.columns[5].texts[solution], "check.met");
  EXPECT_FALSE(is_marked(solution));
  EXPECT_EQ(row_of(told.checks, "check.drift"), -1) << "there is no limit";
  ASSERT_GE(row_of(told.checks, "check.contact"), 0);
  EXPECT_LT(row_of(told.checks, "check.contact"), simulated);
  EXPECT_TRUE(has_kind(told.unchecked, "unchecked.codes_of_basis"));
  EXPECT_TRUE(has_kind(told.unchecked, "unchecked.gravity") && has_kind(told.unchecked, "unchecked.motions"));
  EXPECT_FALSE(has_kind(told.unchecked, "unchecked.reversed"));
  EXPECT_EQ(told.assumptions.front().kind, "model");
}

TEST(HandIn, WhatIsGivenIsNoLongerUnchecked) {
  const std::string more = project_table +
                           "[code.sni-1726-2019]\ndeflection_amplification = 1.0\nimportance_factor = 1.0\n"
                           "[screening]\nseismicity = \"high\"\n";
  const HandIn bare = hand_in(run_to_hand_in(case_to_hand_in("m12-el-centro")));
  const HandIn told = hand_in(run_to_hand_in(case_to_hand_in("m12-el-centro", more)));
  EXPECT_FALSE(has_kind(told.unchecked, "unchecked.codes_of_basis") || has_kind(told.unchecked, "unchecked.screening"));
  EXPECT_TRUE(has_kind(bare.unchecked, "unchecked.screening"));
  EXPECT_TRUE(has_kind(told.assumptions, "assumption.codes"));
  const auto& by = told.checks.columns[1].texts;
  EXPECT_TRUE(std::any_of(by.begin(), by.end(), [](const std::string& one) { return holds(one, "7.12.3"); }));
  EXPECT_GE(row_of(told.checks, "screening.gap-per-height"), 0);
  EXPECT_GT(told.checks.columns[0].texts.size(), bare.checks.columns[0].texts.size());
}

TEST(HandIn, StruckColumnsAndHingesComeFirst) {
  const HandIn struck = hand_in(run_to_hand_in(case_to_hand_in("struck-column")));
  EXPECT_EQ(struck.checks.columns[0].texts.front(), "check.column_shear");
  EXPECT_FALSE(has_kind(struck.unchecked, "unchecked.columns"));
  std::string text = case_to_hand_in("struck-column");
  const std::size_t at = text.find("[gap.column_capacity]"), end = text.find("[excitation]");
  ASSERT_LT(at, end);
  text.erase(at, end - at);
  const HandIn bare = hand_in(run_to_hand_in(text));
  EXPECT_TRUE(has_kind(bare.unchecked, "unchecked.columns"));
  EXPECT_EQ(row_of(bare.checks, "check.column_shear"), -1);
}

TEST(HandIn, BySpectrumToo) {
  for (const char* const language : {"en", "id"}) {
    const std::string page = spectrum_to_hand_in(language);
    const std::vector<std::string> expected = {"verdict",   "assumptions", "input",   "checks",
                                               "unchecked", "gaps",        "figures", "peaks"};
    std::vector<std::string> found = sections_of(page);
    std::erase(found, "remarks");
    EXPECT_EQ(found, expected);
    EXPECT_TRUE(holds(page, "24-117"));
  }
}

TEST(HandIn, OfASuiteOfRecordsToo) {
  const std::string folder = "/examples/two-real-buildings/";
  const auto page_of = [&](const std::string& text, const std::string& language) {
    const Case c = case_of(text, folder);
    const SuiteRun run = run_suite(c, [](double) { return true; });
    Diagnostics diagnostics;
    const auto gaps = gap_study(
        c, BENTUR_SOURCE_DIR + folder + "record.toml", [](double) { return true; }, diagnostics);
    return suite_report_html(run, gaps.value(), {.language = language, .version = "0"});
  };
  const std::string text = case_to_hand_in("two-real-buildings/record", "");
  for (const char* const language : {"en", "id"}) {
    const std::string page = page_of(text, language);
    EXPECT_EQ(sections_of(page), (std::vector<std::string>{"verdict", "assumptions", "input", "records", "checks",
                                                           "unchecked", "remarks", "figures", "runs", "gaps"}));
    EXPECT_TRUE(holds(page, "<body class=\"hand-in\">") && holds(page, "31-07"));
    EXPECT_TRUE(holds(page, "<h3>Office | Hotel</h3><div")) << "the name of a gap once";
  }
  EXPECT_TRUE(holds(page_of(text, "en"), "too few records"));
  std::string plain = text;
  plain.erase(plain.find("[project]"), plain.find("[[gap]]") - plain.find("[project]"));
  const std::string bare = page_of(plain, "en");
  EXPECT_EQ(sections_of(bare),
            (std::vector<std::string>{"verdict", "records", "remarks", "figures", "runs", "gaps", "input"}));
  EXPECT_FALSE(holds(bare, "<body class="));
  EXPECT_TRUE(holds(bare, "usual is up to")) << "what is unusual under some record";
}

// The first record sends floors into a column where no contact is modelled, and others against each other; the second
// moves nothing so far.
TEST(HandIn, ImpactsOfARecordWhoseContactIsNotModelledAreNotKnown) {
  std::string text = case_to_hand_in("two-real-buildings/record", "");
  const auto replace = [&](const std::string& old, const std::string& by) {
    text.replace(text.find(old), old.size(), by);
  };
  replace("event = \"Imperial Valley 1940\" }",
          "event = \"A\" }, { file = \"../../data/four-lobes.csv\", unit = \"m/s2\", time_step = 0.4, event = \"B\" }");
  replace("scale = \"en-1998-1\"", "scale = { factors = [3.0, 0.1] }");
  const Case c = case_of(text, "/examples/two-real-buildings/");
  const SuiteRun run = run_suite(c, [](double) { return true; });
  Diagnostics diagnostics;
  const GapStudy gaps = *gap_study(
      c, BENTUR_SOURCE_DIR "/examples/two-real-buildings/record.toml", [](double) { return true; }, diagnostics);
  ASSERT_TRUE(has_kind(run.records[0].statements, "unmodelled") && has_kind(run.records[0].statements, "pounding"));
  ASSERT_FALSE(has_kind(run.records[1].statements, "unmodelled"));
  int counted = 0;
  for (std::size_t q = 0; q < run.quantities.size(); ++q) {
    if (run.quantities[q].name != "impacts" && run.quantities[q].name != "peak_force") continue;
    ++counted;
    EXPECT_TRUE(std::isnan(run.records[0].values[q]) && std::isnan(run.mean(q)));
    EXPECT_EQ(run.records[1].values[q], 0);
  }
  EXPECT_EQ(counted, 2);
  const Story told = suite_story(run, gaps);
  EXPECT_TRUE(has_kind(told.statements, "unmodelled"));
  const StoryTable checks = suite_hand_in(run, gaps).checks;
  EXPECT_EQ(checks.columns.at(5).texts.at(static_cast<std::size_t>(row_of(checks, "check.unmodelled_records"))),
            "check.not_met");
  const auto table = std::find_if(told.tables.begin(), told.tables.end(),
                                  [](const StoryTable& one) { return one.kind == "suite_runs"; });
  for (const std::size_t column : {1, 2}) {
    EXPECT_TRUE(table->columns[column].label.ends_with("_modelled"));
    EXPECT_GT(parse_number(table->columns[column].texts[0]).value_or(0), 0);
    EXPECT_EQ(table->columns[column].texts[1], "0");
    EXPECT_EQ(table->columns[column].texts[2], "–");
    EXPECT_EQ(table->columns[column].texts[3], "–");
  }
  // Both tables have one gap needed, of both ways of the motion; drifts are in per cent, as checks have them.
  const auto numbers = [&](const StoryTable& of, const std::string& label) {
    return std::find_if(of.columns.begin(), of.columns.end(),
                        [&](const StoryColumn& one) { return one.label == label; });
  };
  const StoryColumn needed = *numbers(*table, "column.suite.gap_needed");
  const auto by_record =
      std::find_if(told.tables.begin(), told.tables.end(), [](const StoryTable& one) { return one.kind == "records"; });
  ASSERT_NE(by_record, told.tables.end());
  const std::vector<double>& simulated = by_record->columns.at(1).numbers;
  EXPECT_NEAR(simulated.at(0), needed.numbers.at(0), 1e-9);
  EXPECT_NEAR(simulated.at(1), needed.numbers.at(1), 1e-9);
  EXPECT_NEAR(needed.numbers.at(2), (simulated[0] + simulated[1]) / 2, 1e-9);
  const StoryColumn drift = *numbers(*table, "column.suite.peak_drift_ratio");
  EXPECT_EQ(drift.unit, "%");
  const auto of_drift =
      std::find_if(run.quantities.begin(), run.quantities.end(),
                   [](const SuiteQuantity& one) { return one.name.starts_with("peak_drift_ratio"); }) -
      run.quantities.begin();
  EXPECT_GE(drift.numbers.at(0), 100 * run.records[0].values.at(of_drift));
  // What a sentence has said already is no reason once more.
  for (const Statement& one : told.statements) {
    if (one.kind != "records_too_small") continue;
    ASSERT_EQ(one.items.size(), 2U);
    for (const auto& item : one.items) {
      EXPECT_TRUE(std::none_of(item.begin(), item.end(), [](const StoryValue& value) {
        const auto* const word = std::get_if<std::string>(&value.value);
        return word != nullptr && (*word == "reason.contact" || *word == "reason.unmodelled");
      }));
    }
  }
  // The buildings are drawn under the record that needs most; how records were scaled stands with them.
  const std::string page = suite_report_html(run, gaps, {.version = "0"});
  const std::size_t verdict = page.find("<section id=\"verdict\""), records = page.find("<section id=\"records\"");
  const std::size_t drawn = page.find("class=\"overview\""), scaled = page.find("2 records of 2 files taken");
  EXPECT_TRUE(verdict < drawn && drawn < page.find("<section", drawn));
  EXPECT_TRUE(holds(page, "The record that needs most, el-centro-1940-ns, "));
  EXPECT_TRUE(records < scaled && scaled == page.rfind("2 records of 2 files taken"));
}

/// Whose bar is the longest, and whom the verdict names, though another has harder impacts.
TEST(HandIn, OfASuiteTheRecordThatNeedsMostIsDrawn) {
  const Case c = case_of(case_to_hand_in("two-real-buildings/record", ""), "/examples/two-real-buildings/");
  const SuiteRun run = run_suite(c, [](double) { return true; });
  Diagnostics diagnostics;
  const auto gaps = gap_study(
      c, BENTUR_SOURCE_DIR "/examples/two-real-buildings/record.toml", [](double) { return true; }, diagnostics);
  const std::size_t governing = governing_record(run);
  for (const SuiteRecordRun& one : run.records) {
    EXPECT_GE(run.records[governing].needed.front(), one.needed.front());
  }
  SuiteRun near = run;  // whose number would lie on the line of what is given
  const double given = near.records[0].judged.front().width;
  near.records[0].needed.front() = 0.95 * given;
  EXPECT_EQ(make_figure(near, gaps.value(), "gap-needed").panels.front().texts.front().x, given);
  const std::string page = suite_report_html(run, gaps.value(), {.version = "0"});
  EXPECT_TRUE(holds(page, "The record that needs most, " + c.excitation.suite->records[governing].name()));
  EXPECT_TRUE(holds(page, "Not evaluated: DDC (links tie the buildings"));
}

/// The picture is of the direction of the motion that needs more, and bars of that which is not as given are outlines.
TEST(HandIn, OfASuiteTheDirectionThatNeedsMoreIsDrawn) {
  Case c = case_of(case_to_hand_in("two-real-buildings/record", ""), "/examples/two-real-buildings/");
  Diagnostics diagnostics;
  const auto gaps = gap_study(
      c, BENTUR_SOURCE_DIR "/examples/two-real-buildings/record.toml", [](double) { return true; }, diagnostics);
  std::set<bool> found;
  for (const double sign : {1.0, -1.0}) {
    auto suite = std::make_shared<SuiteSpec>(*c.excitation.suite);
    for (SuiteRecord& record : suite->records) record.factor *= sign;
    c.excitation.suite = suite;
    const SuiteRun run = run_suite(c, [](double) { return true; });
    const std::size_t governing = governing_record(run);
    const bool is_reversed = governs_reversed(run, governing);
    found.insert(is_reversed);
    const std::string page = suite_report_html(run, gaps.value(), {.version = "0"});
    const std::string needed = number(run.records[governing].needed.front());
    EXPECT_EQ(holds(page, "reversed: " + needed), is_reversed);
    EXPECT_EQ(holds(page, "as recorded: " + needed), !is_reversed);
    for (const ToldJudgement& one : run.records[governing].judged) {  // which has both names too
      const auto way = [](const std::vector<StoryValue>& item) {
        return std::any_of(item.begin(), item.end(), [](const StoryValue& value) {
          const auto* const word = std::get_if<std::string>(&value.value);
          return word != nullptr && *word == "reason.way.recorded";
        });
      };
      EXPECT_TRUE(std::any_of(one.reasons.begin(), one.reasons.end(), way));
    }
    EXPECT_EQ(holds(page, ", reversed, as it needs more than as recorded:"), is_reversed);
    const Panel bars = make_figure(run, gaps.value(), "gap-needed").panels.front();
    const auto is_outline = [](const Curve& one) { return one.label.starts_with("reversed: ") && one.top.empty(); };
    EXPECT_EQ(std::any_of(bars.curves.begin(), bars.curves.end(), is_outline), is_reversed);
  }
  EXPECT_EQ(found.size(), 2U);
}

/// Lines across the spectra are the first periods, with whose they are.
TEST(HandIn, SpectraOfASuiteNameThePeriodsOfTheBuildings) {
  const Case c = case_of(case_to_hand_in("two-real-buildings/record", ""), "/examples/two-real-buildings/");
  const std::vector<RuleLine> rules = suite_figure(*c.excitation.suite, c.units, {}).panels.front().rules;
  ASSERT_EQ(rules.size(), 2U);
  EXPECT_EQ(rules[0].label, "T₁ of Office");
  EXPECT_EQ(rules[1].label, "T₁ of Hotel");
  EXPECT_NE(rules[0].line, rules[1].line);
}

TEST(HandIn, WhatARecordDoesNotTellCountsAsNotMet) {
  const Case c = case_of(case_to_hand_in("two-real-buildings/record", ""), "/examples/two-real-buildings/");
  SuiteRun run = run_suite(c, [](double) { return true; });
  Diagnostics diagnostics;
  GapStudy gaps = *gap_study(
      c, BENTUR_SOURCE_DIR "/examples/two-real-buildings/record.toml", [](double) { return true; }, diagnostics);
  const auto result = [&](const std::string& check) {
    const StoryTable checks = suite_hand_in(run, gaps).checks;
    return checks.columns.at(5).texts.at(static_cast<std::size_t>(row_of(checks, check)));
  };
  EXPECT_EQ(result("check.contact_records"), "check.not_met");
  EXPECT_EQ(result("check.gap_records"), "check.not_met");
  gaps.needs.front().records.front().falls = true;
  EXPECT_EQ(result("check.gap_records"), "story.silence.collapsed");
}

TEST(HandIn, ALogoIsAnImageOfItsBytes) {
  RunResults run = run_to_hand_in(case_to_hand_in("m12-el-centro"));
  EXPECT_FALSE(holds(report_html(run, {.version = "0"}), "<img"));
  run.c.project->logo = "\x89PNG\r\n\x1A\n<script>";
  run.c.project->logo_type = "image/png";
  run.c.project->engineer = "\" onerror=\"alert(1)";
  EXPECT_TRUE(holds(report_html(run, {.version = "0"}),
                    "<img class=\"logo\" src=\"data:image/png;base64,iVBORw0KGgo8c2NyaXB0Pg==\" "
                    "alt=\"&quot; onerror=&quot;alert(1)\">"));
}

}  // namespace
}  // namespace bentur
