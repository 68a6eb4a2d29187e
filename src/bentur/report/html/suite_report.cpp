#include "bentur/report/html/suite_report.h"

#include <algorithm>
#include <utility>

#include "bentur/model/suite/suite_story.h"
#include "bentur/report/html/internal/page.h"
#include "bentur/report/html/internal/page_figures.h"
#include "bentur/report/html/internal/sections.h"
#include "bentur/report/html/report.h"
#include "bentur/report/kinds/kinds.h"
#include "bentur/study/suite/suite_hand_in.h"

namespace bentur {

namespace {

using html::element;
using html::Html;
using html::PageSection;

Html suite_tables(const html::Report& report, const char* first, const char* second) {
  Html content;
  for (const StoryTable& table : report.story.tables) {
    if (table.kind != first && table.kind != second) continue;
    const SaidTable shown = said(table, report.say);
    content += element("h3", shown.heading) + html::table_of(shown);
  }
  return content;
}

/// How the records were chosen and scaled.
bool is_of_choice(const Statement& one) { return !one.gap && one.kind.starts_with("suite") && !is_grave(one.severity); }

PageSection suite_section(const html::Report& report) {
  std::vector<Statement> of_choice = report.story.statements;
  std::erase_if(of_choice, [](const Statement& one) { return !is_of_choice(one); });
  Html sentences;
  for (const SaidStatement& one : said(of_choice, report.say)) sentences += element("p", Html::text(one.text));
  return {"records", report.say("suite.records"), sentences + suite_tables(report, "suite", "suite_buildings")};
}

/// The buildings and their gap under one record, which is run again.
template <class AnyProblem>
Html picture_of(const Case& c, const AnyProblem& problem, const std::string& caption, const std::string& language) {
  SolveOptions options = solve_options(c);
  options.output_step = report_output_step(problem);
  auto response = solve(problem, c.analysis.solver, options);
  if (response.status == Status::failed) return {};
  const auto results = run_results(c, problem, std::move(response));
  return html::opening_figure([&](const FigureOptions& drawn) { return make_figure(results, "overview", drawn); },
                              caption, language);
}

/// The same with its records reversed.
Case with_motion_reversed(Case c) {
  for (ExcitationSpec* const excitation : {&c.excitation, &c.excitation_y}) {
    excitation->motion = reversed(std::move(excitation->motion));
    if (excitation->record) excitation->record->reversed = !excitation->record->reversed;
  }
  return c;
}

/// Under the record that governs, as the bars above it name it, and in the direction that needs more.
Html worst_picture(const SuiteRun& run, const html::Report& report, const std::string& language) {
  const std::size_t record = governing_record(run);
  const bool is_reversed = governs_reversed(run, record);
  const Case as_recorded = case_of_record(run.c, record),
             c = is_reversed ? with_motion_reversed(as_recorded) : as_recorded;
  const std::string caption = report.say(is_reversed ? "figure.overview_of_reversed" : "figure.overview_of_record",
                                         {{"record", run.c.excitation.suite->records[record].name()}});
  return run.plan ? picture_of(c, make_plan_problem(c, run.plan->buildings), caption, language)
                  : picture_of(c, make_problem(c, run.problem.buildings), caption, language);
}

Html needs_picture(const SuiteRun& run, const GapStudy& gaps, const html::Report& report, const std::string& language) {
  try {
    return html::opening_figure([&](const FigureOptions& drawn) { return make_figure(run, gaps, "gap-needed", drawn); },
                                report.say("figure.gap-needed"), language);
  } catch (const NoFigure&) {
    return {};
  }
}

PageSection suite_runs_section(const html::Report& report) {
  return {"runs", report.say("heading.peaks"), suite_tables(report, "suite_runs", "")};
}

/// Rules that have no number under any record, and why.
Html silent_rules(const html::Report& report) {
  const std::vector<std::string> gaps = gap_names(report.problem);
  Html reasons;
  for (const SaidStatement& one : said(report.story.statements, report.say)) {
    if (one.kind != "rules_silent") continue;
    const std::string& gap = gaps.at(static_cast<std::size_t>(one.gap.value()));
    reasons += element("p", gaps.size() > 1 ? of_gap(one.text, gap) : one.text, "class=\"note\"");
  }
  return reasons;
}

PageSection suite_gaps_section(const html::Report& report) {
  std::vector<StoryTable> of_gaps = report.story.tables;
  std::erase_if(of_gaps, [](const StoryTable& one) { return !one.gap; });
  return {"gaps", report.say("heading.gaps"),
          html::gap_tables(gap_names(report.problem), of_gaps, report.say) + silent_rules(report) +
              element("p", report.say("suite.note"), "class=\"note\"")};
}

}  // namespace

std::vector<PagePart> table_parts(const SuiteRun& run, const GapStudy& gaps, const std::string& language) {
  const Words say(language);
  const Response none;
  const html::Report report{{run.problem, none, run.c.units}, run.c, run.problem, none, say, suite_story(run, gaps)};
  return html::parts({suite_section(report), suite_runs_section(report), suite_gaps_section(report)});
}

std::string suite_report_html(const SuiteRun& run, const GapStudy& gaps, const ReportOptions& options) {
  const Words say(options.language);
  const Response none;
  const html::Report report{{run.problem, none, run.c.units}, run.c, run.problem, none, say, suite_story(run, gaps), {},
                            run.c.project.has_value()};
  const std::string title = run.c.title.empty() ? say("report.untitled") : run.c.title;
  const std::vector<html::PageFigure> figures = html::page_figures(
      {{"suite", "the spectra"}},
      [&](const std::string& kind, const FigureOptions& drawn) { return make_figure(run, gaps, kind, drawn); },
      "figure.", options.language);
  html::PageSection verdict = html::verdict_section(report);
  verdict.content += needs_picture(run, gaps, report, options.language);
  verdict.content += worst_picture(run, report, options.language);
  html::PageBody body{
      .header = html::title_block(run.c, title, say("suite.by", {{"version", options.version}}), say),
      .sections = {std::move(verdict), suite_section(report), html::remarks_section(report),
                   html::figures_section(say, figures), suite_runs_section(report), suite_gaps_section(report),
                   run.plan ? html::input_section(run.c, *run.plan, 0, say) : html::input_section(report)}};
  if (report.to_hand_in) {
    const auto records = body.sections.begin() + 1;
    html::PageSection of_suite = std::move(*records);
    body.sections.erase(records);
    body.sections = html::in_order_of_codes(std::move(body.sections), std::move(of_suite), run.c.project, say,
                                            suite_hand_in(run, gaps));
    body.running_head = html::running_head(run.c.project, title);
  }
  return html::page(say, title, body, true);
}

}  // namespace bentur
