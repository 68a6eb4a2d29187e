#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <optional>

#include "bentur/core/number_text.h"
#include "bentur/model/restitution.h"
#include "bentur/report/html/internal/sections.h"
#include "bentur/report/remark_text.h"

namespace bentur::html {

std::string quantity(double value, const std::string& unit) { return number(value) + "\u00A0" + unit; }

std::string acceleration_unit(const Case& c) { return c.units.length + "/s²"; }

std::string mass_unit(const Case& c) { return c.units.force + "·s²/" + c.units.length; }

std::vector<std::size_t> points_of(const Problem& problem, std::size_t gap) {
  std::vector<std::size_t> points;
  for (std::size_t i = problem.points.size(); i-- > 0;) {
    if (problem.points[i].left == static_cast<int>(gap)) points.push_back(i);
  }
  return points;
}

std::vector<double> from_top(const Eigen::VectorXd& values) {
  std::vector<double> reversed(values.begin(), values.end());
  std::reverse(reversed.begin(), reversed.end());
  return reversed;
}

Html section(const std::string& id, const std::string& heading, const Html& content) {
  return element("section", element("h2", Html::text(heading)) + Html::markup("\n") + content, "id=\"" + id + "\"") +
         Html::markup("\n");
}

namespace {

constexpr std::size_t rows_in_print = 30;  // report.css hides the others

Html contact_table(const Story& story, std::size_t gap) {
  const Words& say = story.say;
  const std::string& length = story.c.units.length;
  const std::string& force = story.c.units.force;
  std::vector<double> elevation, duration, peak, time, depth, speed, impulse, energy;
  std::vector<std::string> impacts;
  for (const std::size_t i : points_of(story.problem, gap)) {
    const PointSummary& point = story.response.points[i];
    elevation.push_back(story.problem.points[i].elevation);
    impacts.push_back(std::to_string(point.impacts));
    duration.push_back(1e3 * point.contact_duration);
    peak.push_back(point.peak_force);
    time.push_back(point.peak_force_time.value_or(std::numeric_limits<double>::quiet_NaN()));
    depth.push_back(point.peak_penetration);
    speed.push_back(point.peak_closing_speed);
    impulse.push_back(point.impulse);
    energy.push_back(point.energy_lost);
  }
  HtmlTable table;
  table.add(say("column.elevation"), length, elevation);
  table.add(say("column.impacts"), "", impacts);
  table.add(say("column.in_contact"), "ms", duration);
  table.add(say("column.peak_force"), force, peak);
  table.add(say("column.at"), "s", time);
  table.add(say("column.penetration"), length, depth);
  table.add(say("column.closing_speed"), length + "/s", speed);
  table.add(say("column.impulse"), force + "·s", impulse);
  table.add(say("column.energy_lost"), force + "·" + length, energy);
  return table.markup();
}

Html building_table(const Story& story, std::size_t b) {
  const Words& say = story.say;
  const std::string& length = story.c.units.length;
  const StructuralModel& model = story.problem.buildings[b].model;
  const BuildingPeaks& peaks = story.response.buildings.at(b);
  std::vector<std::string> amplification;
  for (Eigen::Index i = peaks.displacement.size() - 1; i >= 0; --i) {
    const double free = peaks.displacement_no_contact(i);
    amplification.push_back(free > 0 ? fmt::format("{:.3f}", peaks.displacement(i) / free) : "–");
  }
  HtmlTable table;
  table.add(say("column.elevation"), length, std::vector<double>(model.elevations.rbegin(), model.elevations.rend()));
  table.add(say("column.displacement"), length, from_top(peaks.displacement));
  table.add(say("column.no_contact"), length, from_top(peaks.displacement_no_contact));
  table.add(say("column.amplification"), "", amplification);
  table.add(say("column.drift"), "%", from_top(100 * peaks.drift_ratio));
  table.add(say("column.acceleration"), acceleration_unit(story.c), from_top(peaks.acceleration));
  table.add(say("column.shear"), story.c.units.force, from_top(peaks.storey_shear));
  return table.markup();
}

/// Restitution asked and obtained, where a law was asked for one or an impact tells one.
Html restitution_table(const Story& story) {
  if (!story.from_case()) return {};
  const Words& say = story.say;
  const std::vector<PointRestitution> restitution = restitutions(story.problem, story.response);
  const bool any =
      std::any_of(restitution.begin(), restitution.end(), [](const auto& r) { return r.asked.has_value(); });
  if (!any) return {};
  const auto text = [](const std::optional<double>& value) { return value ? fmt::format("{:.4f}", *value) : "–"; };
  std::vector<std::string> gaps, asked, smallest, largest;
  std::vector<double> elevations;
  for (std::size_t i = restitution.size(); i-- > 0;) {
    gaps.push_back(gap_name(story.problem, story.problem.points[i].left));
    elevations.push_back(story.problem.points[i].elevation);
    asked.push_back(text(restitution[i].asked));
    smallest.push_back(text(restitution[i].smallest));
    largest.push_back(text(restitution[i].largest));
  }
  HtmlTable table;
  table.add(say("column.gap"), "", gaps, false);
  table.add(say("column.elevation"), story.c.units.length, elevations);
  table.add(say("column.asked"), "", asked);
  table.add(say("column.smallest"), "", smallest);
  table.add(say("column.largest"), "", largest);
  return element("h3", Html::text(say("heading.restitution"))) + table.markup() +
         element("p", Html::text(say("peaks.restitution_note")), "class=\"note\"");
}

Html proportions_text(const Story& story, std::size_t b) {
  const Building& building = story.problem.buildings[b];
  const Proportions found = proportions(building, story.c.units, &story.response.buildings[b]);
  if (!found.base_shear_coefficient) return {};  // results do not hold the masses
  const auto floors = static_cast<double>(building.model.elevations.size());
  return element("p",
                 Html::text(story.say("peaks.proportions", {{"weight", quantity(found.weight, story.c.units.force)},
                                                            {"coefficient", number(*found.base_shear_coefficient)},
                                                            {"period", quantity(found.period_per_storey * floors, "s")},
                                                            {"per_storey", quantity(found.period_per_storey, "s")}})));
}

}  // namespace

Html remarks_section(const Story& story) {
  Html content;
  for (const std::string& text : remark_texts(story.remarks, story.say.language())) {
    content += element("li", Html::text(text));
  }
  if (!story.remarks.empty()) content = element("ul", content);
  content += element("p", Html::text(model_text(story.say.language())));
  return section("remarks", story.say("remarks.heading"), content);
}

Html peaks_section(const Story& story) {
  const Words& say = story.say;
  Html content;
  for (std::size_t gap = 0; gap + 1 < story.problem.buildings.size(); ++gap) {
    if (points_of(story.problem, gap).empty()) continue;
    const std::string name = gap_name(story.problem, gap);
    content += element("h3", Html::text(say("heading.contact_of", {{"gap", name}}))) + contact_table(story, gap);
  }
  content += restitution_table(story);
  for (std::size_t b = 0; b < story.problem.buildings.size(); ++b) {
    const std::string name = story.problem.buildings[b].name;
    content += element("h3", Html::text(say("heading.peaks_of", {{"building", name}}))) + building_table(story, b) +
               proportions_text(story, b);
  }
  content += element("p", Html::text(say("peaks.note")), "class=\"note\"");
  if (story.response.energy) {
    const EnergyAudit& energy = *story.response.energy;
    content += element(
        "p", Html::text(say("peaks.energy",
                            {{"input", quantity(energy.peak_input, story.c.units.force + "·" + story.c.units.length)},
                             {"residual", fmt::format("{:.1e}", energy.relative_residual())}})));
  }
  return section("peaks", say("heading.peaks"), content);
}

Html impacts_section(const Story& story, const std::vector<std::size_t>& listed) {
  const Words& say = story.say;
  const std::vector<Impact>& all = story.response.impacts;
  if (all.empty()) return section("impacts", say("heading.impacts"), element("p", Html::text(say("impacts.none"))));
  const std::string& length = story.c.units.length;
  const std::string& force = story.c.units.force;
  std::vector<std::string> numbers, gaps, restitutions;
  std::vector<double> elevations, starts, contact, closing, forces, times, depths, impulses, lost;
  for (const std::size_t k : listed) {
    const Impact& impact = all[k];
    const ContactPoint& point = story.problem.points.at(static_cast<std::size_t>(impact.point));
    const auto restitution = impact.restitution();
    numbers.push_back(std::to_string(k + 1));
    gaps.push_back(gap_name(story.problem, point.left));
    elevations.push_back(point.elevation);
    starts.push_back(impact.start);
    contact.push_back(1e3 * (impact.end - impact.start));
    closing.push_back(impact.closing_speed);
    forces.push_back(impact.peak_force);
    depths.push_back(impact.peak_penetration);
    impulses.push_back(impact.impulse);
    lost.push_back(impact.energy_lost);
    restitutions.push_back(restitution ? fmt::format("{:.3f}", *restitution) : "–");
  }
  HtmlTable table;
  table.add("#", "", numbers);
  if (story.c.gaps.size() > 1) table.add(say("column.gap"), "", gaps, false);
  table.add(say("column.elevation"), length, elevations);
  std::vector<std::string> start_cells;
  start_cells.reserve(starts.size());
  for (const double start : starts) start_cells.push_back(fmt::format("{:.4f}", start));
  table.add(say("column.start"), "s", start_cells);
  table.add(say("column.in_contact"), "ms", contact);
  table.add(say("column.peak_force"), force, forces);
  table.add(say("column.closing_speed"), length + "/s", closing);
  table.add(say("column.restitution"), "", restitutions);
  table.add(say("column.penetration"), length, depths);
  table.add(say("column.impulse"), force + "·s", impulses);
  table.add(say("column.energy_lost"), force + "·" + length, lost);
  Html content;
  if (listed.size() < all.size()) {
    content += element("p", Html::text(say("impacts.cut", {{"listed", std::to_string(listed.size())},
                                                           {"all", std::to_string(all.size())}})));
  }
  content += element("p",
                     element("button", Html::text(say("impacts.download")), "type=\"button\" id=\"download\"") +
                         Html::markup(" ") + element("span", Html::text(say("impacts.sort")), "class=\"note\""),
                     "class=\"screen\"");
  const int sorted = story.c.gaps.size() > 1 ? 5 : 4;  // by peak force
  content += table.markup(fmt::format("id=\"impact-list\" data-sorted=\"{}\"", sorted));
  if (listed.size() > rows_in_print) {
    content += element("p", Html::text(say("impacts.print")), "class=\"print note\"");
  }
  return section("impacts", say("heading.impacts"), content);
}

}  // namespace bentur::html
