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

std::string force_text(const Report& report, double value, std::string_view form) {
  const ShownUnits& shown = report.run.shown;
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

void add_columns(HtmlTable& table, std::vector<TableColumn> columns) {
  for (TableColumn& column : columns) {
    table.add(column.label, column.unit, std::move(column.cells), true, std::move(column.values));
  }
}

bool is_elastic(const std::vector<PointSummary>& points) {
  constexpr double round_off = 1e-9;
  const auto loses_nothing = [](const PointSummary& one) {
    return std::abs(one.energy_lost) <= round_off * one.peak_force * one.peak_penetration;
  };
  return std::any_of(points.begin(), points.end(), [](const PointSummary& one) { return one.impacts > 0; }) &&
         std::all_of(points.begin(), points.end(), loses_nothing);
}

std::vector<TableColumn> without_losses(std::vector<TableColumn> columns, Owner owner,
                                        const std::vector<PointSummary>& points, const Words& say) {
  const std::string_view lost = quantity_named("energy_lost", owner).label[say.number()];
  if (is_elastic(points)) std::erase_if(columns, [&](const TableColumn& one) { return one.label == lost; });
  return columns;
}

Html elastic_note(const std::vector<PointSummary>& points, const Words& say) {
  return is_elastic(points) ? element("p", say("peaks.elastic"), "class=\"note\"") : Html();
}

void add_quantities(HtmlTable& table, const Report& report, Owner owner, const std::vector<QuantityPlace>& places) {
  add_columns(table, table_columns(owner, report.run, places, report.say.number()));
}

namespace {

HtmlTable contact_table(const Report& report, const std::vector<Eigen::Index>& points) {
  std::vector<double> elevations;
  for (const Eigen::Index i : points) elevations.push_back(report.problem.points[i].elevation);
  HtmlTable table;
  table.add(report.say("column.elevation"), report.c.units.length, elevations);
  add_columns(table, without_losses(table_columns(Owner::point, report.run, places_of(points), report.say.number()),
                                    Owner::point, report.response.points, report.say));
  return table;
}

/// Some quantities of a building's floors, from the top down; empty where there are none.
HtmlTable floors_table(const Report& report, Eigen::Index b, std::vector<TableColumn> columns) {
  if (columns.empty()) return {};
  const std::vector<double>& levels = report.problem.buildings[b].model.elevations;
  HtmlTable table;
  table.add(report.say("column.elevation"), report.c.units.length, std::vector<double>(levels.rbegin(), levels.rend()));
  add_columns(table, std::move(columns));
  return table;
}

/// A table under its title, folded away on a telephone.
Html folded(const HtmlTable& table) { return table.rows() == 0 ? Html() : fold("h4", table.title(), table.markup()); }

/// What the foundation does; empty without soil.
Html foundation_text(const Report& report, Eigen::Index b) {
  const Eigen::VectorXd& peaks = report.response.buildings[b].foundation;
  if (peaks.size() < 2) return {};
  return element("p", Html::text(report.say("peaks.foundation", {{"sway", quantity(peaks(0), report.c.units.length)},
                                                                 {"rocking", quantity(peaks(1), "rad")}})));
}

/// Of one [[link]] table, from the top down.
HtmlTable links_table(const Report& report, const std::vector<Eigen::Index>& links) {
  std::vector<double> elevations;
  for (const Eigen::Index i : links) elevations.push_back(report.problem.links[i].elevation);
  HtmlTable table;
  table.add(report.say("column.elevation"), report.c.units.length, elevations);
  add_quantities(table, report, Owner::link, places_of(links));
  return table;
}

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
    gaps.push_back(short_gap_name(report, report.problem.points[i].left));
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
  return element("p",
                 Html::text(report.say("peaks.proportions", {{"weight", force_text(report, found.weight, "F")},
                                                             {"coefficient", number(*found.base_shear_coefficient)},
                                                             {"period", quantity(period, "s")},
                                                             {"per_storey", quantity(found.period_per_storey, "s")}})));
}

}  // namespace

PageSection peaks_section(const Report& report) {
  const Words& say = report.say;
  EachOf contacts, buildings;
  for (Eigen::Index gap = 0; gap < gap_count(report.problem); ++gap) {
    std::vector<Eigen::Index> points = points_of(report.problem, gap);
    if (points.empty()) continue;
    const std::string name = gap_name(report.problem, gap), heading = say("heading.contact_of", {{"gap", name}});
    const Html all = contact_table(report, points).called(heading).markup();
    std::erase_if(points, [&](Eigen::Index point) { return report.response.points[point].impacts == 0; });
    contacts.add(heading, all, {contact_table(report, points)}, name);
  }
  Html content = contacts.markup(say, "appendix.contacts") + elastic_note(report.response.points, say);
  const std::size_t language = say.number();
  content += restitution_table(report);
  for (std::vector<Eigen::Index> links : links_by_spec(report.c.links)) {
    if (links.empty()) continue;
    std::reverse(links.begin(), links.end());
    const std::string name = link_name(report.problem, report.problem.links.at(links.front()));
    content += under("h3", say("heading.links_of", {{"link", name}}), links_table(report, links));
  }
  for (Eigen::Index b = 0; b < std::ssize(report.problem.buildings); ++b) {
    const std::string name = report.problem.buildings[b].name, heading = say("heading.peaks_of", {{"building", name}});
    const std::vector<QuantityPlace> floors = floors_from_top(report.problem, b);
    const auto table = [&](QuantityTable of) {
      return floors_table(report, b, table_columns(Owner::floor, report.run, floors, language, of));
    };
    const HtmlTable main = table(QuantityTable::main);
    const HtmlTable forces = table(QuantityTable::forces).called(say("peaks.forces"));
    const HtmlTable yielding = table(QuantityTable::yielding).called(say("peaks.yielding"));
    buildings.add(heading,
                  main.called(heading).markup() + folded(forces) + proportions_text(report, b) +
                      foundation_text(report, b) + folded(yielding),
                  {main, forces, yielding}, name);
  }
  content += buildings.markup(say, "appendix.buildings");
  for (const StoryTable& table : report.story.tables) {
    if (table.kind != "hinges" && table.kind != "broken_columns") continue;
    const SaidTable shown = said(table, say);
    content += element("h3", shown.heading) + table_of(shown);
  }
  content += element("p", Html::text(say("peaks.note")), "class=\"note\"");
  if (some_building_yields(report.problem, report.response)) {
    content += element("p", Html::text(say("peaks.yielding_note")), "class=\"note\"");
  }
  if (report.response.energy) {
    const EnergyAudit& energy = *report.response.energy;
    content += element("p", Html::text(say("peaks.energy", {{"input", force_text(report, energy.peak_input, "F L")},
                                                            {"residual", number(energy.relative_residual())}})));
  }
  return {"peaks", say("heading.peaks"), content};
}

}  // namespace bentur::html
