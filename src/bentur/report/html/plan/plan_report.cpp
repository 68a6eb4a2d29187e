#include "bentur/report/html/plan/plan_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "bentur/core/errors.h"
#include "bentur/core/number_text.h"
#include "bentur/excitation/motion_measures.h"
#include "bentur/io/results/result_csv.h"
#include "bentur/io/schema/case_keys.h"
#include "bentur/model/plan/plan_places.h"
#include "bentur/model/story/hand_in.h"
#include "bentur/model/story/story.h"
#include "bentur/report/html/internal/echo.h"
#include "bentur/report/html/internal/motion_section.h"
#include "bentur/report/html/internal/page.h"
#include "bentur/report/html/internal/page_figures.h"
#include "bentur/report/html/internal/sections.h"
#include "bentur/report/html/page_parts.h"
#include "bentur/report/html/plan/plan_animation.h"
#include "bentur/report/scene/names.h"
#include "bentur/structure/modes.h"

namespace bentur {
namespace {

using Eigen::Index;
using html::element;
using html::Html;
using html::HtmlTable;

/// Where contacts are.
void add_places(const PlanRun& run, const std::vector<Index>& points, const Words& say, HtmlTable& table) {
  const std::string& length = run.c.units.length;
  std::vector<double> elevation, x, y;
  for (const Index point : points) {
    const PlanContactPlace place = contact_at(run.problem, point);
    elevation.push_back(place.contact->elevation);
    x.push_back(place.at.x());
    y.push_back(place.at.y());
  }
  table.add(say("column.elevation"), length, elevation);
  table.add("x", length, x);
  table.add("y", length, y);
}

/// Writes the sections of a report of buildings in plan.
class PlanPage {
 public:
  PlanPage(const PlanRun& run, const Words& say)
      : run_(run),
        say_(say),
        length_(run.c.units.length),
        story_(run_story(run)),
        gaps_(gap_names(run.problem)),
        judged_(judged_gaps(run)) {}

  [[nodiscard]] html::PageSection verdict() const {
    html::Verdict verdict{.story = story_, .c = run_.c};
    for (std::size_t g = 0; g < gaps_.size(); ++g) verdict.gaps.push_back({gaps_[g], gaps_[g], &judged_.at(g)});
    return html::verdict_section(verdict, say_);
  }

  /// What every level needs, what rules ask of it, how the buildings stand.
  [[nodiscard]] html::PageSection gap_needs() const {
    const std::vector<StoryTable> tables = gap_tables_of(run_);
    if (tables.empty()) return {};
    const bool is_screened =
        std::any_of(tables.begin(), tables.end(), [](const StoryTable& one) { return one.kind == "screening"; });
    Html content = html::gap_tables(gaps_, tables, say_);
    content += element("p", say_("cli.plan_gap_note"), "class=\"note\"");
    if (is_screened) content += element("p", say_("screening.note"), "class=\"note\"");
    content += element("p", say_(run_.c.code.rules.empty() ? "gap.no_codes" : "gap.codes_note"), "class=\"note\"");
    return {"gaps", say_("heading.gaps"), content};
  }

  [[nodiscard]] html::PageSection remarks() const {
    return html::remarks_section(story_, say_, run_.c.project.has_value());
  }

  /// Contact points gap by gap, floors and planes building by building.
  [[nodiscard]] html::PageSection peaks() const {
    html::EachOf all_contacts, buildings;
    for (std::size_t g = 0; g < gaps_.size(); ++g) {
      const std::string heading = say_("heading.contact_of", {{"gap", gaps_[g]}});
      all_contacts.add(heading, contacts(g, false).called(heading).markup(), {contacts(g, true)}, gaps_[g]);
    }
    Html content = all_contacts.markup(say_, "appendix.contacts") + html::elastic_note(run_.response.points, say_);
    for (const std::vector<Index>& links : links_by_spec(run_.c.links)) {
      if (links.empty()) continue;
      const std::string name = link_name(run_.problem, run_.problem.links[links.front()]);
      content += html::under("h3", say_("heading.links_of", {{"link", name}}), links_table(links));
    }
    for (Index b = 0; b < std::ssize(run_.problem.buildings); ++b) {
      const HtmlTable main = floors(b, false), forces = floors(b, true).called(say_("peaks.forces"));
      const std::string& name = run_.problem.buildings[b].name;
      const std::string heading = say_("heading.peaks_of", {{"building", name}});
      buildings.add(heading,
                    main.called(heading).markup() + html::under("h4", forces.title(), forces) + foundation(b) +
                        bearings(b) + planes(b),
                    {main, forces}, name);
    }
    content += buildings.markup(say_, "appendix.buildings");
    for (const StoryTable& table : story_.tables) {
      if (table.kind.starts_with("row")) continue;  // it stands in the verdict
      const SaidTable shown = said(table, say_);
      content += element("h3", shown.heading) + html::table_of(shown);
    }
    content += element("p", say_("plan.peaks_note"), "class=\"note\"");
    if (run_.response.energy) {
      const EnergyAudit& energy = *run_.response.energy;
      const ShownUnits shown = shown_units(run_);
      content += element(
          "p", say_("peaks.energy",
                    {{"input", html::quantity(energy.peak_input * shown.factor("F L"), unit_text("F L", shown.units))},
                     {"residual", number(energy.relative_residual())}}));
    }
    return {"peaks", say_("heading.peaks"), content};
  }

  /// Columns that are struck, gap after gap from the top down; empty where none is.
  [[nodiscard]] html::PageSection columns() const {
    std::vector<Index> points;
    std::vector<std::string> struck;
    std::vector<QuantityPlace> places;
    for (std::size_t g = 0; g < run_.problem.gaps.size(); ++g) {
      const PlanGap& gap = run_.problem.gaps[g];
      for (Index i = std::ssize(gap.contacts); i-- > 0;) {
        const auto column = struck_column(run_.problem, gap, gap.contacts[static_cast<std::size_t>(i)]);
        if (!column) continue;
        points.push_back(first_contact(run_.problem, g) + i);
        places.push_back({points.back()});
        struck.push_back(run_.problem.buildings[column->building].name);
      }
    }
    if (points.empty()) return {};
    HtmlTable table;
    add_places(run_, points, say_, table);
    table.add(say_("columns.struck"), "", struck, false);
    html::add_columns(table, table_columns(Owner::point, run_, places, say_.number(), QuantityTable::struck));
    return {"columns", say_("heading.columns"),
            table.called(say_("columns.table")).markup() +
                element("p", Html::text(say_("columns.note_in_plan")), "class=\"note\"")};
  }

  [[nodiscard]] html::PageSection impacts(const std::vector<Index>& listed) const {
    const std::vector<Impact>& all = run_.response.impacts;
    if (all.empty()) return {"impacts", say_("heading.impacts"), element("p", say_("impacts.none"))};
    const HtmlTable table = html::impact_table(run_, listed, say_);
    return {"impacts", say_("heading.impacts"),
            html::impact_list(say_, table, listed.size(), all.size()) + html::elastic_note(run_.response.points, say_)};
  }

 private:
  [[nodiscard]] HtmlTable contacts(std::size_t g, bool are_struck) const {
    std::vector<Index> points;
    for (Index i = 0; i < std::ssize(run_.problem.gaps[g].contacts); ++i) {
      const Index point = first_contact(run_.problem, g) + i;
      if (!are_struck || run_.response.points[point].impacts > 0) points.push_back(point);
    }
    std::stable_sort(points.begin(), points.end(), [&](Index a, Index b) {
      return contact_at(run_.problem, a).contact->elevation > contact_at(run_.problem, b).contact->elevation;
    });
    std::vector<QuantityPlace> places;
    for (const Index point : points) places.push_back({point});
    HtmlTable table;
    add_places(run_, points, say_, table);
    html::add_columns(table, html::without_losses(table_columns(Owner::point, run_, places, say_.number()),
                                                  Owner::point, run_.response.points, say_));
    return table;
  }

  /// Of one [[link]] table, from the top down, with where in plan they are and along what they act.
  [[nodiscard]] HtmlTable links_table(const std::vector<Index>& links) const {
    std::vector<QuantityPlace> places;
    std::vector<double> elevation, x, y;
    std::vector<std::string> along;
    for (auto number = links.rbegin(); number != links.rend(); ++number) {
      const PlanLink& link = run_.problem.links[*number];
      const PlanPoint at = link.stretch.middle(link.along);
      places.push_back({*number});
      elevation.push_back(link.link.elevation);
      x.push_back(at.x());
      y.push_back(at.y());
      along.push_back(link_along(link));
    }
    HtmlTable table;
    table.add(say_("column.elevation"), length_, elevation);
    table.add("x", length_, x);
    table.add("y", length_, y);
    table.add(say_("column.along"), "", along, false);
    html::add_columns(table, table_columns(Owner::link, run_, places, say_.number()));
    return table;
  }

  [[nodiscard]] HtmlTable floors(Index b, bool of_forces) const {
    std::vector<QuantityPlace> places = floors_of(run_.problem, b);
    std::reverse(places.begin(), places.end());
    const std::vector<double>& levels = run_.problem.buildings[b].model.elevations;
    std::vector<TableColumn> columns = table_columns(Owner::floor, run_, places, say_.number(),
                                                     of_forces ? QuantityTable::forces : QuantityTable::main);
    if (columns.empty()) return {};
    HtmlTable table;
    table.add(say_("column.elevation"), length_, std::vector<double>(levels.rbegin(), levels.rend()));
    html::add_columns(table, std::move(columns));
    return table;
  }

  /// What the foundation does; empty without soil.
  [[nodiscard]] Html foundation(Index b) const {
    std::vector<TableColumn> columns = table_columns(Owner::building, run_, {{b}}, say_.number());
    if (columns.empty()) return {};
    HtmlTable table;
    html::add_columns(table, std::move(columns));
    return html::under("h4", say_("plan.foundation"), table);
  }

  /// What bearings below a slab do; empty without one.
  [[nodiscard]] Html bearings(Index b) const {
    const std::vector<QuantityPlace> places = bearings_of(run_.problem, b);
    if (places.empty()) return {};
    std::vector<double> x, y;
    for (const PlanModel::Bearing& one : run_.problem.buildings[b].model.bearings) {
      x.push_back(run_.problem.buildings[b].model.footprint.corner.x() + one.at.x());
      y.push_back(run_.problem.buildings[b].model.footprint.corner.y() + one.at.y());
    }
    HtmlTable table;
    table.add("x", length_, x);
    table.add("y", length_, y);
    html::add_columns(table, table_columns(Owner::bearing, run_, places, say_.number()));
    return html::under("h4", say_("plan.bearings"), table);
  }

  [[nodiscard]] Html planes(Index b) const {
    const PlanModel& model = run_.problem.buildings[b].model;
    const std::vector<QuantityPlace> places = planes_from_top(run_.problem, b);
    std::vector<std::string> names;
    std::vector<double> levels;
    for (const QuantityPlace& place : places) {
      names.push_back(model.planes[place.plane].name);
      levels.push_back(model.elevations[place.floor]);
    }
    if (places.empty()) return {};
    HtmlTable table;
    table.add(say_("column.plane"), "", names, false);
    table.add(say_("column.elevation"), length_, levels);
    html::add_columns(table, table_columns(Owner::plane, run_, places, say_.number()));
    return html::under("h4", say_("plan.of_planes"), table);
  }

  const PlanRun& run_;
  const Words& say_;
  const std::string& length_;
  Story story_;
  std::vector<std::string> gaps_;
  std::vector<JudgedGap> judged_;
};

/// impacts.csv of these.
std::string csv_of(const PlanRun& run, std::vector<Index> listed) {
  std::sort(listed.begin(), listed.end());
  PlanRun shown{run.c, run.problem, {}};
  for (const Index k : listed) shown.response.impacts.push_back(run.response.impacts[k]);
  return impacts_csv(shown);
}

}  // namespace

html::HtmlTable html::impact_table(const PlanRun& run, const std::vector<Index>& listed, const Words& say) {
  const std::vector<std::string> names = building_names(run.problem), in_short = short_names(names);
  const std::vector<std::string>& called = are_parts_of(in_short, names) ? in_short : names;
  std::vector<std::string> numbers, gaps;
  std::vector<QuantityPlace> impacts;
  std::vector<Index> points;
  for (const Index k : listed) {
    const Index point = run.response.impacts.at(static_cast<std::size_t>(k)).point;
    numbers.push_back(std::to_string(k + 1));
    const PlanGap& gap = run.problem.gaps[contact_at(run.problem, point).gap];
    gaps.push_back(called[gap.left] + " | " + called[gap.right]);
    impacts.push_back({k});
    points.push_back(point);
  }
  HtmlTable table, places;
  table.add("#", "", numbers);
  if (run.problem.gaps.size() > 1) table.add(say("column.gap"), "", gaps, false);
  add_places(run, points, say, places);
  html::add_impacts(table,
                    html::without_losses(table_columns(Owner::impact, run, impacts, say.number()), Owner::impact,
                                         run.response.points, say),
                    places, say, true);
  return table;
}

std::vector<PagePart> table_parts(const PlanRun& run, const std::string& language) {
  const Words say(language);
  const PlanPage page(run, say);
  return html::parts({page.gap_needs(), page.peaks()});
}

double report_output_step(const PlanProblem& problem) {
  constexpr double finest = 1e-3, most = 5e4, most_numbers = 5e6;  // [s], samples, of all histories
  double numbers = 0;                                              // of one sample
  for (const PlanBuilding& building : problem.buildings) {
    // Movements, rotation and accelerations; drifts and shears of planes.
    const Index kinds = 5 + 2 * std::ssize(building.model.planes);
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

std::string plan_report_html(const PlanRun& run, const ReportOptions& options) {
  if (run.response.histories.time.empty()) {
    throw InvalidParameter("response", "no histories", "must have the histories of every building");
  }
  const Words say(options.language);
  const PlanPage sections(run, say);
  const std::vector<Index> listed = html::hardest_impacts(run.response.impacts);
  const std::string title = run.c.title.empty() ? say("report.untitled") : run.c.title;
  const std::vector<html::PageFigure> figures = html::page_figures(
      figure_kinds(run),
      [&](const std::string& kind, const FigureOptions& drawn) { return make_figure(run, kind, drawn); }, "figure.",
      options.language);
  html::PageSection verdict = sections.verdict();
  for (const FigureKind& kind : figure_kinds(run)) {
    if (kind.name != "map" && kind.name != "overview") continue;
    verdict.content +=
        html::opening_figure([&](const FigureOptions& drawn) { return make_figure(run, kind.name, drawn); },
                             say(caption_key(kind.name, true)), options.language);
  }
  html::PageSection motion;
  Html data;
  if (!run.response.points.empty()) {
    motion = html::motion_section(say, run.c.units.length, html::MotionView::plan);
    data = html::json_script("data", html::plan_animation_json(run, say, listed));
  }
  html::PageBody body{.header = html::title_block(run.c, title, say("report.by", {{"version", options.version}}), say),
                      .sections = {verdict, sections.remarks(), motion, sections.gap_needs(), sections.peaks(),
                                   sections.columns(), sections.impacts(listed),
                                   html::sensitivity_section(options.sensitivity, run.c, say, options.language),
                                   html::figures_section(say, figures),
                                   html::plan_input_section(run.c, run.problem, run.response.events, say)},
                      .footer = element("footer", element("p", say("report.footer"), "class=\"note\"")) + data +
                                html::csv_script(csv_of(run, listed))};
  if (run.c.project) {
    std::vector<html::AppliedRecord> applied;
    for (const std::size_t i : {0U, 1U}) applied.push_back({*run.c.excitations()[i], applied_pga(run, i)});
    body.sections = html::in_order_of_codes(std::move(body.sections), html::records_section(applied, run.c.units, say),
                                            run.c.project, say, hand_in(run));
    body.running_head = html::running_head(run.c.project, title);
  }
  return html::page(say, title, body, true);
}

}  // namespace bentur
