#include "bentur/report/html/report.h"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

#include "bentur/core/errors.h"
#include "bentur/io/results/result_csv.h"
#include "bentur/model/plan/plan_places.h"
#include "bentur/model/story/hand_in.h"
#include "bentur/model/story/story.h"
#include "bentur/report/figures/internal/text.h"
#include "bentur/report/html/internal/animation.h"
#include "bentur/report/html/internal/motion_data.h"
#include "bentur/report/html/internal/motion_section.h"
#include "bentur/report/html/internal/page.h"
#include "bentur/report/html/internal/page_figures.h"
#include "bentur/report/html/internal/sections.h"
#include "bentur/report/html/page_parts.h"
#include "bentur/report/run_tables.h"

namespace bentur {
namespace {

using html::element;
using html::Html;
using html::Report;

// What rows and buildings in plan have each of their own.

/// All that sections of a row are written from.
Report told_of(const RunResults& run, const Story& story, const Words& say) {
  return {run.view(), run.c, run.problem, run.response, say, story, judged_gaps(run), run.c.project.has_value()};
}

RunTables tables_of(const RunResults& run, const Words& say) { return run_tables(run.view(), run.c, say); }
RunTables tables_of(const PlanRun& run, const Words& say) { return run_tables(run, say); }

RunTable list_of(const RunResults& run, const std::vector<Eigen::Index>& impacts, const Words& say) {
  return impact_table(run.view(), impacts, say);
}
RunTable list_of(const PlanRun& run, const std::vector<Eigen::Index>& impacts, const Words& say) {
  return impact_table(run, impacts, say);
}

html::PageSection verdict_of(const RunResults& run, const Story& story, const Words& say) {
  return html::verdict_section(told_of(run, story, say));
}

html::PageSection verdict_of(const PlanRun& run, const Story& story, const Words& say) {
  const std::vector<std::string> gaps = gap_names(run.problem);
  const std::vector<JudgedGap> judged = judged_gaps(run);
  html::Verdict verdict{.story = story, .c = run.c};
  for (std::size_t g = 0; g < gaps.size(); ++g) verdict.gaps.push_back({gaps[g], gaps[g], &judged.at(g)});
  return html::verdict_section(verdict, say);
}

html::PageSection peaks_of(const RunResults& run, const RunTables& tables, const Story& story, const Words& say) {
  return html::peaks_section(told_of(run, story, say), tables);
}
html::PageSection peaks_of(const PlanRun& run, const RunTables& tables, const Story& story, const Words& say) {
  return html::peaks_section(run, tables, story, say);
}

html::PageSection columns_of(const RunResults& run, const RunTables& tables, const Words& say) {
  return html::columns_section(run.view(), tables.struck, say);
}
html::PageSection columns_of(const PlanRun& run, const RunTables& tables, const Words& say) {
  return html::columns_section(run, tables.struck, say);
}

html::PageSection damage_of(const RunResults& run, const Words& say) {
  return html::damage_section(told_of(run, {}, say));
}
html::PageSection damage_of(const PlanRun& /*run*/, const Words& /*say*/) { return {}; }

html::PageSection input_of(const RunResults& run, const Words& say) {
  return html::input_section(told_of(run, {}, say));
}
html::PageSection input_of(const PlanRun& run, const Words& say) {
  return html::input_section(run.c, run.problem, run.response.events, say);
}

/// The records of a run as applied.
std::vector<html::AppliedRecord> records_of(const RunResults& run) { return {{run.c.excitation, applied_pga(run.c)}}; }
std::vector<html::AppliedRecord> records_of(const PlanRun& run) {
  std::vector<html::AppliedRecord> applied;
  for (const std::size_t i : {0U, 1U}) applied.push_back({*run.c.excitations()[i], applied_pga(run, i)});
  return applied;
}

/// Whether there is something that plays: in plan the picture is one of contacts.
bool has_motion(const RunResults& /*run*/) { return true; }
bool has_motion(const PlanRun& run) { return !run.response.points.empty(); }

// What they have alike.

/// impacts.csv of these.
template <class Run>
std::string csv_of(const Run& run, std::vector<Eigen::Index> listed) {
  std::sort(listed.begin(), listed.end());
  Run shown{run.c, run.problem, {}, {}};
  for (const Eigen::Index k : listed) shown.response.impacts.push_back(run.response.impacts[k]);
  return impacts_csv(shown.view());
}

/// The opening figures, below the verdict.
template <class Run>
Html opening_figures(const Run& run, const Words& say) {
  Html figures;
  for (const FigureKind& kind : figure_kinds(run)) {
    if (kind.name != "map" && kind.name != "overview") continue;
    figures += html::opening_figure([&](const FigureOptions& drawn) { return make_figure(run, kind.name, drawn); },
                                    say(caption_key(kind.name, run.c.is_in_plan())), say.language());
  }
  return figures;
}

template <class Run>
std::string report_of(const Run& run, const ReportOptions& options) {
  const Case& c = run.c;
  if (run.response.histories.time.empty() || run.response.buildings.size() != run.problem.buildings.size()) {
    throw InvalidParameter("response", std::to_string(run.response.histories.time.size()) + " samples",
                           "must have the histories of every building");
  }
  const Words say(options.language);
  const Story story = run_story(run);
  const RunTables tables = tables_of(run, say);
  const std::vector<Eigen::Index> listed = html::hardest_impacts(run.response.impacts);
  const std::string title = c.title.empty() ? say("report.untitled") : c.title;
  const std::vector<html::PageFigure> figures = html::page_figures(
      figure_kinds(run),
      [&](const std::string& kind, const FigureOptions& drawn) { return make_figure(run, kind, drawn); }, "figure.",
      options.language);
  const html::MotionView from = c.is_in_plan() ? html::MotionView::plan : html::MotionView::row;
  html::PageSection verdict = verdict_of(run, story, say), motion;
  verdict.content += opening_figures(run, say);
  Html data;
  if (has_motion(run)) {
    motion = html::motion_section(say, c.units.length, from);
    data = html::json_script("data", html::animation_json(run, listed, say));
  }
  html::PageBody body{.header = html::title_block(c, title, say("report.by", {{"version", options.version}}), say),
                      .sections = {verdict, html::remarks_section(story, say, c.project.has_value()), motion,
                                   html::gap_section(gap_names(run.problem), gap_tables_of(run), c, say),
                                   peaks_of(run, tables, story, say), damage_of(run, say), columns_of(run, tables, say),
                                   html::impacts_section(run.response, list_of(run, listed, say), say),
                                   html::sensitivity_section(options.sensitivity, c, say, options.language),
                                   html::figures_section(say, figures), input_of(run, say)},
                      .footer = element("footer", element("p", say("report.footer"), "class=\"note\"")) + data +
                                html::csv_script(csv_of(run, listed))};
  if (c.project) {
    body.sections = html::in_order_of_codes(
        std::move(body.sections), html::records_section(records_of(run), c.units, say), c.project, say, hand_in(run));
    body.running_head = html::running_head(c.project, title);
  }
  return html::page(say, title, body, true);
}

template <class Run>
std::vector<PagePart> parts_of(const Run& run, const std::string& language) {
  const Words say(language);
  const RunTables tables = tables_of(run, say);
  return html::parts({html::gap_section(gap_names(run.problem), gap_tables_of(run), run.c, say),
                      peaks_of(run, tables, run_story(run), say), columns_of(run, tables, say)});
}

template <class Run>
std::vector<TableColumn> impact_columns_of(const Run& run, const std::string& language) {
  std::vector<TableColumn> columns = list_of(run, html::hardest_impacts(run.response.impacts), Words(language)).columns;
  for (TableColumn& column : columns) {
    if (column.is_words) continue;
    for (std::string& cell : column.cells) cell = signed_text(cell);
  }
  return columns;
}

}  // namespace

double report_output_step(const Problem& problem) {
  Eigen::Index floors = 0;
  for (const Building& building : problem.buildings) floors += building.model.floors();
  return html::motion_step(problem.duration, floors);
}

double report_output_step(const PlanProblem& problem) {
  constexpr double finest = 1e-3, most = 5e4, most_numbers = 5e6;  // [s], samples, of all histories
  double numbers = 0;                                              // of one sample
  for (const PlanBuilding& building : problem.buildings) {
    // Movements, rotation and accelerations; drifts and shears of planes.
    const Eigen::Index kinds = 5 + 2 * std::ssize(building.model.planes);
    numbers += static_cast<double>(kinds * building.model.floors());
  }
  for (const PlanGap& gap : problem.gaps) numbers += 4 * static_cast<double>(gap.contacts.size());
  const double least = std::max({finest, problem.duration / most, problem.duration * numbers / most_numbers});
  // Rounded up to what most output steps are multiples of: some figures show samples at these alone.
  const double ten = std::pow(10, std::floor(std::log10(least) + 1e-9));
  for (const double factor : {1, 2, 5}) {
    if (factor * ten >= (1 - 1e-9) * least) return factor * ten;
  }
  return 10 * ten;
}

std::string report_html(const RunResults& run, const ReportOptions& options) { return report_of(run, options); }
std::string report_html(const PlanRun& run, const ReportOptions& options) { return report_of(run, options); }

std::vector<PagePart> table_parts(const RunResults& run, const std::string& language) {
  return parts_of(run, language);
}
std::vector<PagePart> table_parts(const PlanRun& run, const std::string& language) { return parts_of(run, language); }

std::vector<TableColumn> impact_columns(const RunResults& run, const std::string& language) {
  return impact_columns_of(run, language);
}
std::vector<TableColumn> impact_columns(const PlanRun& run, const std::string& language) {
  return impact_columns_of(run, language);
}

}  // namespace bentur
