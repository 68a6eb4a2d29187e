#include "bentur/report/html/report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "bentur/core/errors.h"
#include "bentur/io/results/result_csv.h"
#include "bentur/model/gap/gap_outcome.h"
#include "bentur/report/html/internal/animation.h"
#include "bentur/report/html/internal/markup.h"
#include "bentur/report/html/internal/motion_data.h"
#include "bentur/report/html/internal/motion_section.h"
#include "bentur/report/html/internal/page.h"
#include "bentur/report/html/internal/sections.h"

namespace bentur {
namespace {

using html::element;
using html::Html;
using html::Report;

/// impacts.csv of these.
std::string csv_of(const Report& report, std::vector<Eigen::Index> listed) {
  std::sort(listed.begin(), listed.end());
  Response shown;
  for (const Eigen::Index k : listed) shown.impacts.push_back(report.response.impacts[k]);
  return impacts_csv({report.problem, shown, report.c.units});
}

}  // namespace

double report_output_step(const Problem& problem) {
  Eigen::Index floors = 0;
  for (const Building& building : problem.buildings) floors += building.model.floors();
  return html::motion_step(problem.duration, floors);
}

std::string report_html(const RunResults& results, const ReportOptions& options) {
  const auto& [c, problem, response, remarks, unused] = results;
  if (response.histories.displacement.size() != problem.buildings.size() || response.histories.time.empty()) {
    throw InvalidParameter("response", std::to_string(response.histories.displacement.size()) + " histories",
                           "must have the histories of every building");
  }
  const Words say(options.language);
  const Report report{
      results.view(),       c, problem, response, say, run_story(results), gap_tables_of(results), judged_gaps(results),
      c.project.has_value()};
  const std::vector<Eigen::Index> listed = html::hardest_impacts(response.impacts);
  const std::string title = c.title.empty() ? say("report.untitled") : c.title;

  const std::vector<html::PageFigure> figures = html::page_figures(
      figure_kinds(results),
      [&](const std::string& kind, const FigureOptions& drawn) { return make_figure(results, kind, drawn); }, "figure.",
      options.language);

  html::PageSection verdict = html::verdict_section(report);
  verdict.content +=
      html::opening_figure([&](const FigureOptions& drawn) { return make_figure(results, "overview", drawn); },
                           say("figure.overview"), options.language);

  html::PageBody body;
  body.header = html::title_block(c, title, say("report.by", {{"version", options.version}}), say);
  body.sections = {verdict,
                   html::remarks_section(report),
                   html::motion_section(say, report.c.units.length, html::MotionView::row),
                   html::gap_section(report),
                   html::peaks_section(report),
                   html::damage_section(report),
                   html::columns_section(report),
                   html::impacts_section(report, listed),
                   html::sensitivity_section(options.sensitivity, c, say, options.language),
                   html::figures_section(say, figures),
                   html::input_section(report)};
  if (report.to_hand_in) {
    body.sections = html::in_order_of_codes(std::move(body.sections),
                                            html::records_section({{c.excitation, applied_pga(c)}}, c.units, say),
                                            c.project, say, hand_in(results));
    body.running_head = html::running_head(c.project, title);
  }
  body.footer = element("footer", element("p", say("report.footer"), "class=\"note\"")) +
                html::json_script("data", html::animation_json(report, listed)) +
                html::csv_script(csv_of(report, listed));
  return html::page(say, title, body, true);
}

}  // namespace bentur
