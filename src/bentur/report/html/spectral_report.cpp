#include "bentur/report/html/spectral_report.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "bentur/report/html/internal/page.h"
#include "bentur/report/html/internal/page_figures.h"
#include "bentur/report/html/internal/sections.h"
#include "bentur/structure/modes.h"

namespace bentur {
namespace {

using html::element;
using html::Html;
using html::HtmlTable;
using html::Report;

html::PageSection spectral_gap_section(const Report& report) {
  const Words& say = report.say;
  Html content = html::gap_tables(gap_names(report.problem), report.story.tables, say);
  const bool is_given = report.c.excitation.spectrum->of_displacements;
  content += element("p", say(is_given ? "spectral.given_note" : "spectral.note"), "class=\"note\"");
  content += element("p", say("screening.note"), "class=\"note\"");
  content += element("p", say(report.c.code.rules.empty() ? "gap.no_codes" : "gap.codes_note"), "class=\"note\"");
  return {"gaps", say("heading.gaps"), content};
}

/// Of a building known by its peaks, highest first.
HtmlTable given_peaks_table(const GivenPeaks& given, const std::vector<double>& elevations, const Report& report) {
  const std::string& length = report.c.units.length;
  std::vector<double> levels(elevations.rbegin(), elevations.rend());
  std::vector<double> as_given(given.displacement.begin(), given.displacement.end());
  std::reverse(as_given.begin(), as_given.end());
  std::vector<double> expected = as_given;
  for (double& u : expected) u *= given.amplification;
  HtmlTable table;
  table.add(report.say("column.elevation"), length, levels);
  table.add(report.say("spectral.given"), length, as_given);
  if (given.amplification != 1) table.add(report.say("spectral.amplified"), length, expected);
  return table;
}

/// The floors' peaks, the highest first; in plan along x and along y.
HtmlTable floor_peaks(const Building& building, const SpectralPeaks& peaks, const Report& report) {
  const std::string& length = report.c.units.length;
  const auto from_top = [](const auto& list) {
    std::vector<double> turned(list.begin(), list.end());
    std::reverse(turned.begin(), turned.end());
    return turned;
  };
  const bool in_plan = peaks.srss_y.size() > 0;
  HtmlTable table;
  table.add(report.say("column.elevation"), length, from_top(building.model.elevations));
  table.add(in_plan ? "x, SRSS" : "SRSS", length, from_top(peaks.srss));
  table.add(in_plan ? "x, CQC" : "CQC", length, from_top(peaks.cqc));
  if (in_plan) {
    table.add("y, SRSS", length, from_top(peaks.srss_y));
    table.add("y, CQC", length, from_top(peaks.cqc_y));
  }
  return table;
}

/// The modes that they are made of, with the mass that moves along each direction.
HtmlTable spectral_modes_table(const Modes& modes, const Eigen::MatrixXd& load, const SpectralModes& spectral,
                               const Report& report) {
  const Words& say = report.say;
  const auto values = [](const Eigen::VectorXd& list) { return std::vector<double>(list.begin(), list.end()); };
  HtmlTable table;
  table.add(say("spectral.period"), "s", values(modal_properties(modes, load.col(0)).periods));
  table.add(say("spectral.damping"), "", values(spectral.damping));
  table.add("Sd", report.c.units.length, values(spectral.displacement));
  for (Eigen::Index i = 0; i < load.cols(); ++i) {
    const std::string label = load.cols() == 1 ? say("spectral.mass") : say(i == 0 ? "plan.mass_x" : "plan.mass_y");
    table.add(label, "%", values(100 * modal_properties(modes, load.col(i)).effective_mass_fraction));
  }
  return table;
}

/// Of each building the floors' peaks, and the modes they are made of.
html::PageSection spectral_peaks_section(const Report& report, const SpectralGaps& spectral) {
  Html content;
  for (std::size_t b = 0; b < report.problem.buildings.size(); ++b) {
    const Building& building = report.problem.buildings[b];
    if (building.given) {
      content += under("h3", building.name, given_peaks_table(*building.given, building.model.elevations, report));
      continue;
    }
    if (building.is_rigid()) continue;
    content += under("h3", building.name, floor_peaks(building, spectral.peaks[b], report));
    const auto modes = [&](const auto& of) {
      return under("h4", report.say("heading.modes"),
                   spectral_modes_table(of.modes, of.model.load, spectral.modes[b], report));
    };
    content += spectral.plan ? modes(spectral.plan->buildings[b]) : modes(building);
  }
  return {"peaks", report.say("spectral.peaks"), content};
}

/// @param none of a case that is not run
Report report_of(const Case& c, const Problem& problem, const Response& none, const SpectralGaps& spectral,
                 const Words& say) {
  return {{problem, none, c.units},
          c,
          problem,
          none,
          say,
          spectral_story(c, problem, spectral),
          judged_gaps(c, problem, spectral),
          c.project.has_value()};
}

}  // namespace

std::vector<PagePart> table_parts(const Case& c, const Problem& problem, const SpectralGaps& spectral,
                                  const std::string& language) {
  const Words say(language);
  const Response none;
  const Report report = report_of(c, problem, none, spectral, say);
  return html::parts({spectral_gap_section(report), spectral_peaks_section(report, spectral)});
}

std::string spectral_report_html(const Case& c, const Problem& problem, const SpectralGaps& spectral,
                                 const ReportOptions& options) {
  const Words say(options.language);
  const Response none;
  const Report report = report_of(c, problem, none, spectral, say);
  const std::string title = c.title.empty() ? say("report.untitled") : c.title;
  const bool is_given = c.excitation.spectrum->of_displacements;
  std::vector<html::PageFigure> figures;
  if (!is_given)
    figures = html::page_figures(
        {{"spectrum", "the spectrum"}},
        [&](const std::string&, const FigureOptions& drawn) {
          return design_spectrum_figure(c, problem, spectral, drawn);
        },
        "figure.design.", options.language);
  html::PageBody body{
      .header = html::title_block(
          c, title, say(is_given ? "spectral.by_displacements" : "spectral.by", {{"version", options.version}}), say),
      .sections = {html::verdict_section(report), html::remarks_section(report), spectral_gap_section(report),
                   html::figures_section(say, figures), spectral_peaks_section(report, spectral),
                   spectral.plan ? html::input_section(c, *spectral.plan, 0, say) : html::input_section(report)}};
  if (report.to_hand_in) {
    body.sections =
        html::in_order_of_codes(std::move(body.sections), {}, c.project, say, hand_in(c, problem, spectral));
    body.running_head = html::running_head(c.project, title);
  }
  return html::page(say, title, body, false);
}

}  // namespace bentur
