#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "bentur/core/number_text.h"
#include "bentur/model/restitution.h"
#include "bentur/model/run_results.h"
#include "bentur/report/html/internal/sections.h"
#include "bentur/report/scene/names.h"

namespace bentur::html {

std::string quantity(double value, const std::string& unit) { return number(value) + "\u00A0" + unit; }

std::string force_text(const ShownUnits& shown, double value, std::string_view form) {
  return quantity(value * shown.factor(form), unit_text(form, shown.units));
}

bool numbers_buildings(const Report& report) { return report.problem.buildings.size() > 2; }

namespace {

std::vector<std::string> names_of_row(const Report& report) {
  std::vector<std::string> names;
  for (const Building& building : report.problem.buildings) names.push_back(building.name);
  return names;
}

}  // namespace

std::string short_gap_name(const Report& report, Eigen::Index gap) {
  if (!numbers_buildings(report)) return gap_name(report.problem, gap);
  const std::vector<std::string> in_short = short_names(names_of_row(report));
  const auto left = static_cast<std::size_t>(gap);
  return in_short.at(left) + "\u00A0|\u00A0" + in_short.at(left + 1);
}

std::string numbered(const std::vector<std::string>& names) {
  std::string text;
  for (std::size_t b = 0; b < names.size(); ++b) {
    const std::string& name = names[b];
    const std::size_t word = name.find_last_not_of("0123456789") + 1;
    const bool is_a_word = word == 0 || name[word - 1] == ' ';              // which House 1.7 has not
    if (is_a_word && name.substr(word) == std::to_string(b + 1)) continue;  // which House 7 is need not be said
    text += fmt::format("{}{}\u00A0{}", text.empty() ? "" : ", ", b + 1, name);
  }
  return text;
}

std::string building_key(const Report& report) {
  const std::vector<std::string> names = names_of_row(report);
  return are_parts_of(short_names(names), names) ? "" : numbered(names);
}

std::string acceleration_unit(const Units& units) { return units.length + "/s²"; }

std::string mass_unit(const Units& units) {
  const std::string unit = units.force + "·s²/" + units.length;
  return unit == "N·s²/m" ? "kg" : unit == "kN·s²/m" || unit == "N·s²/mm" ? "t" : unit;
}

std::vector<Eigen::Index> points_of(const Problem& problem, Eigen::Index gap) {
  const Gap between = gap_at(problem, gap);
  return {between.points.rbegin(), between.points.rend()};
}

HtmlTable table_of(const RunTable& table) {
  HtmlTable made;
  for (const TableColumn& column : table.columns) {
    made.add(column.label, column.unit, column.cells, !column.is_words, column.values);
  }
  return made;
}

Html elastic_note(const std::vector<PointSummary>& points, const Words& say) {
  return is_elastic(points) ? element("p", say("peaks.elastic"), "class=\"note\"") : Html();
}

namespace {

/// A table under its title, folded away on a telephone.
Html folded(const HtmlTable& table) { return table.rows() == 0 ? Html() : fold("h4", table.title(), table.markup()); }

/// Restitution asked and obtained, where a law was asked for one or an impact tells one.
Html restitution_table(const Report& report) {
  if (!report.from_case()) return {};
  const Words& say = report.say;
  const std::vector<PointRestitution>& restitution = report.run.restitutions;
  const bool any =
      std::any_of(restitution.begin(), restitution.end(), [](const auto& r) { return r.asked.has_value(); });
  if (!any) return {};
  const auto text = [](const std::optional<double>& value) { return value ? fmt::format("{:.4f}", *value) : "–"; };
  std::vector<std::string> gaps, asked, smallest, largest;
  std::vector<double> elevations;
  std::vector<Eigen::Index> order;  // gap by gap, each from the top down
  for (Eigen::Index gap = 0; gap < gap_count(report.problem); ++gap) {
    const std::vector<Eigen::Index> points = points_of(report.problem, gap);
    order.insert(order.end(), points.begin(), points.end());
  }
  for (const Eigen::Index i : order) {
    gaps.push_back(short_gap_name(report, report.problem.points[i].gap));
    elevations.push_back(report.problem.points[i].elevation);
    asked.push_back(text(restitution[i].asked));
    smallest.push_back(text(restitution[i].smallest));
    largest.push_back(text(restitution[i].largest));
  }
  HtmlTable table;
  table.add(say("column.gap"), "", gaps, false);
  table.add(say("column.elevation"), report.c.units.length, elevations);
  table.add(say("column.asked"), "", asked);
  table.add(say("column.smallest"), "", smallest);
  table.add(say("column.largest"), "", largest);
  return under("h3", say("heading.restitution"), table) +
         element("p", Html::text(say("peaks.restitution_note")), "class=\"note\"");
}

Html proportions_text(const Report& report, Eigen::Index b) {
  const Building& building = report.problem.buildings[b];
  const Proportions found = proportions(building, report.c.units, &report.response.buildings[b]);
  if (!found.base_shear_coefficient) return {};  // results do not hold the masses
  const double period = 2 * std::numbers::pi / building.first_omega();
  return element(
      "p", Html::text(report.say("peaks.proportions", {{"weight", force_text(report.run.shown, found.weight, "F")},
                                                       {"coefficient", number(*found.base_shear_coefficient)},
                                                       {"period", quantity(period, "s")},
                                                       {"per_storey", quantity(found.period_per_storey, "s")}})));
}

/// Tables of what each gap, link and building came to.
/// @param of_buildings what else stands below the forces of each @param restitution behind contacts
Html peaks_of(const RunTables& tables, const RunOutcome& outcome, const std::vector<Html>& of_buildings,
              const Html& restitution, const Words& say) {
  EachOf contacts, buildings;
  for (const ContactTable& one : tables.contacts) {
    const std::string heading = say("heading.contact_of", {{"gap", one.gap}});
    const RunTable struck =
        one.points.where([&](const QuantityPlace& at) { return outcome.points[at.item].impacts > 0; });
    contacts.add(heading, table_of(one.points).called(heading).markup(), {table_of(struck)}, one.gap);
  }
  Html content = contacts.markup(say, "appendix.contacts") + elastic_note(outcome.points, say) + restitution;
  for (const LinkTable& one : tables.links) {
    content += under("h3", say("heading.links_of", {{"link", one.link}}), table_of(one.links));
  }
  for (std::size_t b = 0; b < tables.buildings.size(); ++b) {
    const BuildingTables& one = tables.buildings[b];
    const std::string heading = say("heading.peaks_of", {{"building", one.building}});
    const HtmlTable floors = table_of(one.floors);
    const HtmlTable forces = table_of(one.forces).called(say("peaks.forces"));
    const HtmlTable yielding = table_of(one.yielding).called(say("peaks.yielding"));
    buildings.add(heading,
                  floors.called(heading).markup() + folded(forces) + of_buildings.at(b) +
                      under("h4", say("plan.foundation"), table_of(one.foundation)) + folded(yielding) +
                      under("h4", say("plan.bearings"), table_of(one.bearings)) +
                      under("h4", say("plan.of_planes"), table_of(one.planes)),
                  {floors, forces, yielding}, one.building);
  }
  return content + buildings.markup(say, "appendix.buildings");
}

/// Tables of a story that do not stand in the verdict.
Html tables_of(const Story& story, const Words& say) {
  Html content;
  for (const StoryTable& table : story.tables) {
    if (table.kind.starts_with("row")) continue;
    const SaidTable shown = said(table, say);
    content += element("h3", shown.heading) + table_of(shown);
  }
  return content;
}

Html energy_text(const std::optional<EnergyAudit>& energy, const ShownUnits& shown, const Words& say) {
  if (!energy) return {};
  return element("p", say("peaks.energy", {{"input", force_text(shown, energy->peak_input, "F L")},
                                           {"residual", number(energy->relative_residual())}}));
}

}  // namespace

PageSection peaks_section(const Report& report, const RunTables& tables) {
  const Words& say = report.say;
  std::vector<Html> proportions;
  for (Eigen::Index b = 0; b < std::ssize(report.problem.buildings); ++b) {
    proportions.push_back(proportions_text(report, b));
  }
  Html content = peaks_of(tables, report.response, proportions, restitution_table(report), say) +
                 tables_of(report.story, say) + element("p", say("peaks.note"), "class=\"note\"");
  if (some_building_yields(report.problem, report.response)) {
    content += element("p", say("peaks.yielding_note"), "class=\"note\"");
  }
  return {"peaks", say("heading.peaks"), content + energy_text(report.response.energy, report.run.shown, say)};
}

PageSection peaks_section(const PlanRun& run, const RunTables& tables, const Story& story, const Words& say) {
  const std::vector<Html> nothing(tables.buildings.size());
  return {"peaks", say("heading.peaks"),
          peaks_of(tables, run.response, nothing, {}, say) + tables_of(story, say) +
              element("p", say("plan.peaks_note"), "class=\"note\"") +
              energy_text(run.response.energy, shown_units(run), say)};
}

}  // namespace bentur::html
