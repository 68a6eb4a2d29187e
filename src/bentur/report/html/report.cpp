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

Html button(const Words& say, const std::string& id) {
  return element("button", say("motion." + id), fmt::format("type=\"button\" id=\"{}\"", id));
}

Html labelled(const Words& say, const std::string& key, const Html& control) {
  return element("label", Html::text(say(key)) + Html::markup(" ") + control);
}

Html speeds() {
  Html options;
  const std::pair<const char*, const char*> all[] = {{"2", "2 ×"},      {"1", "1 ×"},        {"0.5", "1/2 ×"},
                                                     {"0.1", "1/10 ×"}, {"0.01", "1/100 ×"}, {"0.001", "1/1000 ×"}};
  for (const auto& [value, text] : all) {
    const std::string chosen = std::string(value) == "1" ? " selected" : "";
    options += element("option", text, fmt::format("value=\"{}\"{}", value, chosen));
  }
  return element("select", options, "id=\"speed\"");
}

/// The buildings in motion; the script draws them.
html::PageSection motion_section(const Report& report) {
  const Words& say = report.say;
  const std::string label = Html::text(say("motion.picture")).str();
  Html content = element("noscript", element("p", say("motion.noscript")));
  content += element(
      "div",
      element("svg", Html(), "id=\"stage\" role=\"img\" aria-label=\"" + label + "\"") +
          element("div",
                  element("p", element("output", Html(), "id=\"clock\"") + Html::markup("<br>") +
                                   element("span", Html(), "id=\"event\"")) +
                      element("div",
                              element("table",
                                      element("caption", say("motion.opening", {{"unit", report.c.units.length}})) +
                                          element("tbody", Html(), "id=\"live\""),
                                      "class=\"live\""),
                              "class=\"wide\""),
                  "class=\"readout\""),
      "class=\"player\"");
  content += element("p", html::building_key(report), "id=\"building-key\" class=\"note\"");
  content += element("svg", Html(),
                     "id=\"timeline\" role=\"img\" aria-label=\"" + Html::text(say("motion.timeline")).str() + "\"");
  content += element("div", Html(), "id=\"time-axis\" aria-hidden=\"true\"");
  content += Html::markup("<input type=\"range\" id=\"scrub\" class=\"screen\" min=\"0\" aria-label=\"" +
                          Html::text(say("motion.scrub")).str() + "\">\n");
  content += element(
      "p",
      button(say, "play") + button(say, "previous") + button(say, "next") + button(say, "hardest") +
          labelled(say, "motion.speed", speeds()) +
          element("label", Html::markup("<input type=\"checkbox\" id=\"slow\"> ") + Html::text(say("motion.slow"))) +
          labelled(
              say, "motion.magnify",
              Html::markup("<input type=\"range\" id=\"magnify\">") + element("output", Html(), "id=\"magnified\"")),
      "class=\"controls screen\"");
  content += element("p", say("motion.note"), "class=\"note\"");
  return {"motion", say("heading.motion_picture"), content};
}

/// The sections of a page to hand in: what was assumed and given and what came out of the checks before all else.
std::vector<html::PageSection> in_order_of_codes(const Report& report, const RunResults& results,
                                                 std::vector<html::PageSection> sections) {
  const HandIn told = hand_in(results);
  std::vector<html::PageSection> ordered = {sections.front(),
                                            html::assumptions_section(report, told),
                                            std::move(sections.back()),
                                            html::records_section(report),
                                            html::checks_section(report, told),
                                            html::unchecked_section(report, told)};
  sections.pop_back();
  for (std::size_t i = 1; i < sections.size(); ++i) ordered.push_back(std::move(sections[i]));
  return ordered;
}

}  // namespace

double report_output_step(const Problem& problem) {
  Eigen::Index floors = 0;
  for (const Building& building : problem.buildings) floors += building.model.floors();
  const double bytes = 6e5 * std::clamp(problem.duration / 10, 1.0, 5.0);
  const double samples = bytes * 3 / 4 / 2;
  const double least = problem.duration * static_cast<double>(floors) / samples;
  double step = 5e-4;  // some samples of even a short impact
  for (const double longer : {1e-3, 2e-3, 5e-3, 1e-2, 2e-2, 5e-2, 0.1, 0.2, 0.5, 1.0}) {
    if (step < least) step = longer;
  }
  return std::max(std::min(step, problem.duration / 100), least);
}

std::string report_html(const RunResults& results, const ReportOptions& options) {
  const auto& [c, problem, response, remarks, unused] = results;
  if (response.histories.displacement.size() != problem.buildings.size() || response.histories.time.empty()) {
    throw InvalidParameter("response", std::to_string(response.histories.displacement.size()) + " histories",
                           "must have the histories of every building");
  }
  const Words say(options.language);
  const Report report{results.view(),
                      c,
                      problem,
                      response,
                      say,
                      run_story(results),
                      gap_tables_of(results),
                      separations(problem, response, c.code, c.units),
                      c.project || !options.head.empty()};
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
  body.header = html::title_block(report, title, say("report.by", {{"version", options.version}}), options);
  body.sections = {verdict,
                   html::remarks_section(report),
                   motion_section(report),
                   html::gap_section(report),
                   html::peaks_section(report),
                   html::damage_section(report),
                   html::columns_section(report),
                   html::impacts_section(report, listed),
                   html::figures_section(say, figures),
                   html::input_section(report)};
  if (report.to_hand_in) {
    body.sections = in_order_of_codes(report, results, std::move(body.sections));
    body.running_head = html::running_head(c.project, title);
  }
  body.footer = element("footer", element("p", say("report.footer"), "class=\"note\"")) +
                html::json_script("data", html::animation_json(report, listed)) +
                html::csv_script(csv_of(report, listed));
  return html::page(say, title, body, true);
}

}  // namespace bentur
