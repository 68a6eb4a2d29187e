#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <variant>

#include "bentur/core/number_text.h"
#include "bentur/elements/hysteretic_laws.h"
#include "bentur/excitation/motion_measures.h"
#include "bentur/io/schema/case_keys.h"
#include "bentur/report/html/internal/sections.h"
#include "bentur/structure/modes.h"

namespace bentur::html {
namespace {

/// A word of a case file in the report's language; one that is a name, such as that of a law, as it is.
std::string chosen_word(const Words& say, const std::string& word) {
  const std::string key = "choice." + word;
  return catalogue().texts.contains(key) ? say(key) : word;
}

/// What a key of the case is called in the report's language.
std::string label_of(const KeyTable& table, std::string_view key, const Words& say) {
  const Label& label = table.at(key).label;
  return std::string(say.language() == "id" ? label.indonesian : label.english);
}

using Rows = std::vector<std::pair<std::string, std::string>>;

constexpr Eigen::Index most_modes = 8;
constexpr Eigen::Index largest_matrix_shown = 12;

std::string list_text(const std::vector<double>& values) {
  std::string text;
  for (const double value : values) text += (text.empty() ? "" : ", ") + with_power(number(value));
  return text;
}

std::string percent_list(std::vector<double> ratios) {
  for (double& ratio : ratios) ratio *= 100;
  return list_text(ratios) + " %";
}

std::string damping_text(const Damping& damping, const Words& say) {
  if (const auto* modal = std::get_if<ModalDamping>(&damping)) {
    return say(modal->ratios.size() == 1 ? "damping.modal" : "damping.modal_list",
               {{"ratios", percent_list(modal->ratios)}});
  }
  if (const auto* rayleigh = std::get_if<RayleighDamping>(&damping)) {
    return say("damping.rayleigh",
               {{"ratios", percent_list(rayleigh->ratios)}, {"periods", list_text(rayleigh->periods)}});
  }
  if (const auto* mass = std::get_if<MassProportionalDamping>(&damping)) {
    return say("damping.mass", {{"ratio", percent_list({mass->ratio})}});
  }
  if (const auto* stiffness = std::get_if<StiffnessProportionalDamping>(&damping)) {
    return say("damping.stiffness", {{"ratio", percent_list({stiffness->ratio})}});
  }
  return say("damping.matrix");
}

std::vector<double> reversed(std::vector<double> values, std::size_t size) {
  if (values.size() == 1) values.resize(size, double{values.front()});
  std::reverse(values.begin(), values.end());
  return values;
}

/// Storeys are numbered from the bottom and stand as they do in the building.
std::vector<std::string> storey_numbers(std::size_t count) {
  std::vector<std::string> numbers;
  for (std::size_t i = count; i > 0; --i) numbers.push_back(std::to_string(i));
  return numbers;
}

Html structure_echo(const PlaneFrame& frame, const Report& report, Rows& rows) {
  const Words& say = report.say;
  const Units& units = report.c.units;
  rows.emplace_back(say("input.structure"), say("input.frame"));
  rows.emplace_back(label_of(frame_keys(), "elastic_modulus", say),
                    quantity(frame.elastic_modulus, units.force + "/" + units.length + "²"));
  rows.emplace_back(label_of(frame_keys(), "bay_widths", say), list_text(frame.bay_widths) + " " + units.length);
  rows.emplace_back(label_of(frame_keys(), "mass_matrix", say),
                    say(frame.mass_matrix == MassMatrix::consistent ? "input.consistent" : "input.lumped"));
  rows.emplace_back(label_of(frame_keys(), "condensation", say),
                    say(frame.condensation == Condensation::static_   ? "input.static"
                        : frame.condensation == Condensation::dynamic ? "input.dynamic"
                                                                      : "input.uncondensed"));
  if (!frame.base_coupling) rows.emplace_back(label_of(frame_keys(), "base_coupling", say), say("word.no"));
  const std::size_t storeys = frame.storey_heights.size();
  const bool by_length =
      std::any_of(frame.beams.begin(), frame.beams.end(), [](const Section& beam) { return beam.line_mass > 0; });
  const bool equal_bays = std::all_of(frame.bay_widths.begin(), frame.bay_widths.end(),
                                      [&](double bay) { return bay == frame.bay_widths.front(); });
  std::vector<double> column_masses, beam_masses;
  for (std::size_t i = 0; i < storeys; ++i) {
    double beams = 0;
    for (const double bay : frame.bay_widths) beams += frame.beams[i].mass_of(bay);
    column_masses.push_back(frame.columns[i].mass_of(frame.storey_heights[i]));
    beam_masses.push_back(beams / static_cast<double>(frame.bay_widths.size()));
  }
  const auto values = [&](const std::vector<Section>& sections, double Section::*member) {
    std::vector<double> list;
    for (const Section& section : sections) list.push_back(section.*member);
    return reversed(list, storeys);
  };
  HtmlTable table;
  table.add(say("column.storey"), "", storey_numbers(storeys));
  table.add(say("column.height"), units.length, reversed(frame.storey_heights, storeys));
  table.add(say("column.column_area"), units.length + "²", values(frame.columns, &Section::area));
  table.add(say("column.column_inertia"), units.length + "⁴", values(frame.columns, &Section::inertia));
  table.add(say("column.column_mass"), mass_unit(report.c), reversed(column_masses, storeys));
  table.add(say("column.beam_area"), units.length + "²", values(frame.beams, &Section::area));
  table.add(say("column.beam_inertia"), units.length + "⁴", values(frame.beams, &Section::inertia));
  table.add(say(by_length && !equal_bays ? "column.beam_mean_mass" : "column.beam_mass"), mass_unit(report.c),
            reversed(beam_masses, storeys));
  if (std::any_of(frame.floor_masses.begin(), frame.floor_masses.end(), [](double mass) { return mass != 0; })) {
    table.add(say("column.floor_mass"), mass_unit(report.c), reversed(frame.floor_masses, storeys));
  }
  return table.markup();
}

/// The law by which storeys yield, with its own numbers.
std::string hysteresis_text(const Stick& stick, const Words& say) {
  const std::string key = "input." + stick.hysteresis;
  if (stick.own || !say.has(key)) return stick.hysteresis;
  const auto* const law = find_entry(hysteretic_laws(), stick.hysteresis);
  std::vector<std::pair<std::string, std::string>> numbers;
  for (const Key& one : law->keys) {
    const auto given = stick.law_numbers.find(one.name);
    numbers.emplace_back(one.name, number(given != stick.law_numbers.end() ? given->second : *one.default_value));
  }
  return say(key, numbers);
}

Html structure_echo(const Stick& stick, const Report& report, Rows& rows) {
  const Words& say = report.say;
  const Units& units = report.c.units;
  rows.emplace_back(say("input.structure"), say("input.stick"));
  const std::size_t storeys = stick.storey_heights.size();
  HtmlTable table;
  table.add(say("column.storey"), "", storey_numbers(storeys));
  table.add(say("column.height"), units.length, reversed(stick.storey_heights, storeys));
  table.add(say("column.mass"), mass_unit(report.c), reversed(stick.masses, storeys));
  table.add(say("column.stiffness"), units.force + "/" + units.length, reversed(stick.stiffnesses, storeys));
  if (!stick.yield_forces.empty()) {
    rows.emplace_back(label_of(stick_keys(), "hysteresis", say), hysteresis_text(stick, say));
    std::vector<double> forces = reversed(stick.yield_forces, storeys);
    for (double& force : forces) force = std::isinf(force) ? std::numeric_limits<double>::quiet_NaN() : force;
    table.add(say("column.yield_force"), units.force, forces);
    table.add(say("column.hardening"), "",
              reversed(stick.hardening.empty() ? std::vector<double>{0} : stick.hardening, storeys));
  }
  return table.markup();
}

Html matrix_echo(const std::string& name, const std::string& unit, const Eigen::MatrixXd& matrix) {
  HtmlTable table;
  for (Eigen::Index j = 0; j < matrix.cols(); ++j) {
    const Eigen::VectorXd values = matrix.col(j);
    table.add(std::to_string(j + 1), "", std::vector<double>(values.begin(), values.end()));
  }
  return element("p", name + " [" + unit + "]") + table.markup();
}

Html structure_echo(const MatricesSpec& spec, const Report& report, Rows& rows) {
  const Words& say = report.say;
  const Units& units = report.c.units;
  rows.emplace_back(say("input.structure"), say("input.matrices"));
  rows.emplace_back(label_of(matrices_keys(), "elevations", say), list_text(spec.elevations) + " " + units.length);
  if (spec.mass.rows() > largest_matrix_shown) {
    rows.emplace_back(say("input.size"), fmt::format("{0} × {0}", spec.mass.rows()));
    return {};
  }
  return matrix_echo(say("column.mass"), mass_unit(report.c), spec.mass) +
         matrix_echo(say("column.stiffness"), units.force + "/" + units.length, spec.stiffness);
}

Html structure_echo(const RigidSpec& spec, const Report& report, Rows& rows) {
  rows.emplace_back(report.say("input.structure"), report.say("input.rigid"));
  rows.emplace_back(label_of(matrices_keys(), "elevations", report.say),
                    list_text(spec.elevations) + " " + report.c.units.length);
  return {};
}

Html structure_echo(const ModalBuilding& modal, const Report& report, Rows& rows) {
  const Words& say = report.say;
  rows.emplace_back(say("input.structure"), say("input.modal", {{"modes", std::to_string(modal.periods.size())}}));
  HtmlTable table;
  const std::size_t floors = modal.elevations.size();
  table.add(say("column.elevation"), report.c.units.length, reversed(modal.elevations, floors));
  table.add(say("column.mass"), mass_unit(report.c), reversed(modal.masses, floors));
  return table.markup();
}

Html structure_echo(const GenericBuilding& generic, const Report& report, Rows& rows) {
  const Words& say = report.say;
  rows.emplace_back(say("input.structure"), say("input.generic", {{"ratio", number(generic.stiffness_ratio)}}));
  const std::size_t storeys = generic.storey_heights.size();
  HtmlTable table;
  table.add(say("column.storey"), "", storey_numbers(storeys));
  table.add(say("column.height"), report.c.units.length, reversed(generic.storey_heights, storeys));
  table.add(say("column.mass"), mass_unit(report.c), reversed(generic.floor_masses, storeys));
  return table.markup();
}

/// What the building stands on and bears.
void support_echo(const BuildingSpec& spec, const Report& report, Rows& rows) {
  const Words& say = report.say;
  const Units& units = report.c.units;
  const std::string spring = units.force + "/" + units.length;
  if (spec.p_delta || !spec.gravity_loads.empty()) {
    rows.emplace_back(
        label_of(building_keys(), "gravity_loads", say),
        spec.gravity_loads.empty() ? say("input.own_weight") : list_text(spec.gravity_loads) + " " + units.force);
  }
  if (spec.isolation) {
    const Isolation& bearings = spec.isolation->bearings;
    rows.emplace_back(label_of(isolation_keys(), "mass", say), quantity(bearings.mass, mass_unit(report.c)));
    if (const auto& pendulum = spec.isolation->pendulum) {
      rows.emplace_back(label_of(building_keys(), "isolation", say),
                        say("input.pendulum", {{"coefficient", number(pendulum->coefficient)},
                                               {"radius", quantity(pendulum->radius, units.length)}}));
    } else {
      rows.emplace_back(
          label_of(building_keys(), "isolation", say),
          say("input.bearing_law", {{"stiffness", quantity(bearings.stiffness, spring)},
                                    {"strength", quantity(bearings.characteristic_strength, units.force)}}));
    }
  }
  if (!spec.soil) return;
  const Soil soil = soil_of(*spec.soil);
  const std::string ground = label_of(building_keys(), "soil", say) + ": ";
  rows.emplace_back(
      ground + label_of(soil_keys(), "sway", say),
      quantity(soil.sway.stiffness, spring) + ", " + quantity(soil.sway.damping, units.force + "·s/" + units.length));
  rows.emplace_back(ground + label_of(soil_keys(), "rocking", say),
                    quantity(soil.rocking.stiffness, units.force + "·" + units.length) + ", " +
                        quantity(soil.rocking.damping, units.force + "·" + units.length + "·s"));
}

/// Of values mode by mode those that are shown.
std::vector<double> first_modes(const Eigen::VectorXd& values) {
  return {values.begin(), values.begin() + std::min(values.size(), most_modes)};
}

Html modes_table(const Building& building, const Report& report) {
  const Words& say = report.say;
  const ModalProperties properties = modal_properties(building);
  const Eigen::Index shown = std::min(properties.periods.size(), most_modes);
  std::vector<std::string> numbers = storey_numbers(static_cast<std::size_t>(shown));
  std::reverse(numbers.begin(), numbers.end());
  Eigen::VectorXd cumulative = properties.effective_mass_fraction;
  std::partial_sum(cumulative.begin(), cumulative.end(), cumulative.begin());
  const Eigen::VectorXd damping = building.modal_damping.diagonal().cwiseQuotient(2 * building.modes.omega);
  HtmlTable table;
  table.add(say("column.mode"), "", numbers);
  table.add(say("column.period"), "s", first_modes(properties.periods));
  table.add(say("column.frequency"), "Hz", first_modes(properties.periods.cwiseInverse()));
  table.add(say("column.damping"), "%", first_modes(100 * damping));
  table.add(say("column.participation"), "(" + mass_unit(report.c) + ")^½", first_modes(properties.participation));
  table.add(say("column.effective_mass"), "%", first_modes(100 * properties.effective_mass_fraction));
  table.add(say("column.cumulative_mass"), "%", first_modes(100 * cumulative));
  Html content = element("h4", say("heading.modes")) + table.markup();
  if (shown < properties.periods.size()) {
    content += element("p", say("input.modes_more", {{"n", std::to_string(properties.periods.size() - shown)}}),
                       "class=\"note\"");
  }
  return content;
}

Html building_echo(const Report& report, Eigen::Index b) {
  const Words& say = report.say;
  const BuildingSpec& spec = report.c.buildings.at(b);
  const Building& building = report.problem.buildings.at(b);
  Rows rows;
  const Html table =
      std::visit([&](const auto& structure) { return structure_echo(structure, report, rows); }, spec.structure);
  if (building.is_rigid()) return element("h3", building.name) + facts(rows) + table;
  support_echo(spec, report, rows);
  const std::string damping = damping_text(spec.damping, say);
  rows.emplace_back(label_of(building_keys(), "damping", say),
                    spec.tangent_damping ? say("damping.tangent", {{"damping", damping}}) : damping);
  if (spec.calibrate_period) {
    rows.emplace_back(label_of(building_keys(), "calibrate_period", say),
                      say("input.calibrated_by", {{"period", quantity(*spec.calibrate_period, "s")},
                                                  {"factor", number(building.model.stiffness_factor.value_or(1))}}));
  }
  if (spec.base_elevation != 0) {
    rows.emplace_back(label_of(building_keys(), "base_elevation", say),
                      quantity(spec.base_elevation, report.c.units.length));
  }
  if (spec.width)
    rows.emplace_back(label_of(building_keys(), "width", say), quantity(*spec.width, report.c.units.length));
  return element("h3", building.name) + facts(rows) + table + modes_table(building, report);
}

/// Unit of what a law works with; empty where it has none or it is the law's own.
std::string parameter_unit(std::string_view name, const KeyTable& keys, const std::string& law, const Units& units) {
  const Key* found = keys.find(name);
  for (const Key& key : keys.keys) {
    if (key.name == name && key.is_for("law", law)) found = &key;
  }
  return found == nullptr ? "" : found->dimension.text(units.length, units.force);
}

Html gap_echo(const Report& report, Eigen::Index gap) {
  const Words& say = report.say;
  const GapSpec& spec = report.c.gaps.at(gap);
  Rows rows;
  if (spec.elevations.empty()) {
    rows.emplace_back(label_of(contact_keys(), "law", say), say("input.no_contact"));
    if (!spec.widths.empty())
      rows.emplace_back(say("column.gap"), quantity(spec.widths.front(), report.c.units.length));
    return element("h3", say("heading.gap_of", {{"gap", gap_name(report.problem, gap)}})) + facts(rows);
  }
  rows.emplace_back(label_of(contact_keys(), "law", say), spec.contact.law);
  for (const auto& [name, word] : report.from_case() ? spec.contact.choices() : spec.contact.words) {
    rows.emplace_back(chosen_word(say, name), chosen_word(say, word));
  }
  if (spec.contact.axial) rows.emplace_back(chosen_word(say, "stiffness"), say("input.axial"));
  std::vector<double> elevations, widths;
  std::vector<std::pair<std::string, std::vector<double>>> parameters;
  for (const Eigen::Index i : points_of(report.problem, gap)) {
    const ContactPoint& point = report.problem.points[i];
    elevations.push_back(point.elevation);
    widths.push_back(point.width);
    if (point.law == nullptr) continue;
    const LawParameters of_law = point.law->parameters();
    parameters.resize(of_law.size());
    for (std::size_t k = 0; k < of_law.size(); ++k) {
      parameters[k].first = of_law[k].first;
      parameters[k].second.push_back(of_law[k].second);
    }
  }
  if (!report.from_case()) {  // result files keep what the laws worked with, point by point from the lowest
    for (const auto& [name, values] : spec.contact.numbers)
      parameters.emplace_back(name, reversed(values, values.size()));
  }
  HtmlTable table;
  table.add(say("column.elevation"), report.c.units.length, elevations);
  table.add(say("column.gap"), report.c.units.length, widths);
  for (const auto& [name, values] : parameters) {
    table.add(say("parameter." + name), parameter_unit(name, contact_keys(), spec.contact.law, report.c.units), values);
  }
  return element("h3", say("heading.gap_of", {{"gap", gap_name(report.problem, gap)}})) + facts(rows) + table.markup();
}

/// Of one [[link]] table, from the top down.
Html link_echo(const Report& report, const LinkSpec& spec, const std::vector<Eigen::Index>& links) {
  if (links.empty()) return {};
  const Words& say = report.say;
  const Units& units = report.c.units;
  std::vector<double> elevations = spec.elevations;
  std::reverse(elevations.begin(), elevations.end());
  HtmlTable table;
  table.add(say("column.elevation"), units.length, elevations);
  const auto* const law = find_entry(link_laws(), spec.law, spec.own);
  for (const Key& key : law != nullptr ? law->keys : std::vector<Key>()) {
    std::vector<double> values;
    for (std::size_t i = spec.elevations.size(); i-- > 0;) values.push_back(spec.number(key.name, i));
    table.add(say("parameter." + std::string(key.name)), parameter_unit(key.name, link_keys(), spec.law, units),
              values);
  }
  const std::string name = link_name(report.problem, report.problem.links.at(links.front()));
  return element("h3", say("heading.links_of", {{"link", name}})) +
         facts({{label_of(link_keys(), "law", say), spec.own ? spec.law : say("input." + spec.law)}}) + table.markup();
}

Html motion_echo(const Report& report) {
  const Words& say = report.say;
  const Case& c = report.c;
  const std::string acceleration = acceleration_unit(c);
  const MotionMeasures measures = motion_measures(c.excitation.motion);
  Rows rows;
  if (c.excitation.record) {
    const RecordEcho& record = *c.excitation.record;
    rows.emplace_back(say("motion.record"), record.file);
    rows.emplace_back(say("motion.format"), chosen_word(say, record.format) + ", " + record.unit);
    if (!record.channel.empty()) rows.emplace_back(say("motion.channel"), record.channel);
    if (record.header_lines > 0) rows.emplace_back(say("motion.header_lines"), std::to_string(record.header_lines));
    if (record.reversed) rows.emplace_back(say("motion.polarity"), say("motion.reversed"));
    if (record.mean_removed != 0) {
      rows.emplace_back(say("motion.mean_removed"), quantity(record.mean_removed, record.unit));
    }
    rows.emplace_back(say("motion.samples"),
                      say("motion.samples_text", {{"count", std::to_string(record.count)},
                                                  {"step", quantity(record.time_step, "s")},
                                                  {"duration", quantity(record.duration, "s")}}));
    rows.emplace_back(say("motion.pga_read"), quantity(record.pga_read, record.unit));
  } else if (const auto* harmonic = std::get_if<HarmonicMotion>(&c.excitation.motion)) {
    rows.emplace_back(say("motion.kind"),
                      say(harmonic->phase == HarmonicMotion::Phase::sine ? "motion.sine" : "motion.cosine"));
    rows.emplace_back(say("motion.period"), quantity(harmonic->period, "s"));
    rows.emplace_back(say("motion.amplitude"), quantity(harmonic->displacement_amplitude, c.units.length));
  } else {
    rows.emplace_back(say("motion.kind"), say("motion.none"));
  }
  const double pga = applied_pga(c);
  if (pga > 0) {
    rows.emplace_back(say("motion.pga"), quantity(pga, acceleration) + " = " + quantity(pga / c.units.gravity, "g"));
  }
  if (measures.pgv > 0) rows.emplace_back(say("motion.pgv"), quantity(measures.pgv, c.units.length + "/s"));
  if (measures.significant_duration > 0) {
    rows.emplace_back(say("motion.significant"), quantity(measures.significant_duration, "s"));
  }
  for (Eigen::Index b = 0; b < std::ssize(c.excitation.delays); ++b) {
    if (c.excitation.delays[b] != 0) {
      rows.emplace_back(say("motion.delay", {{"building", report.problem.buildings.at(b).name}}),
                        quantity(c.excitation.delays[b], "s"));
    }
  }
  if (c.excitation.kinematics == Kinematics::absolute) {
    rows.emplace_back(say("motion.kinematics"), say("motion.absolute"));
  }
  return element("h3", say("heading.motion")) + facts(rows);
}

Html initial_echo(const Report& report) {
  const Words& say = report.say;
  const InitialSpec& initial = report.c.initial;
  Html content;
  for (Eigen::Index b = 0; b < std::ssize(report.c.buildings); ++b) {
    const auto given = [&](const std::vector<std::vector<double>>& all) {
      return b < std::ssize(all) ? all[b] : std::vector<double>();
    };
    const std::vector<double> displacements = given(initial.displacements);
    const std::vector<double> velocities = given(initial.velocities);
    if (displacements.empty() && velocities.empty()) continue;
    const std::vector<double>& elevations = report.problem.buildings[b].model.elevations;
    HtmlTable table;
    table.add(say("column.elevation"), report.c.units.length, reversed(elevations, elevations.size()));
    if (!displacements.empty()) {
      table.add(say("column.initial_displacement"), report.c.units.length, reversed(displacements, elevations.size()));
    }
    if (!velocities.empty()) {
      table.add(say("column.initial_velocity"), report.c.units.length + "/s", reversed(velocities, elevations.size()));
    }
    content += element("h3", say("heading.initial_of", {{"building", report.c.buildings[b].name}})) + table.markup();
  }
  return content;
}

Html analysis_echo(const Report& report) {
  const Words& say = report.say;
  const AnalysisSpec& analysis = report.c.analysis;
  Rows rows;
  std::string units = report.c.units.length + ", " + report.c.units.force + ", s";
  if (report.from_case()) units += "; g = " + quantity(report.c.units.gravity, acceleration_unit(report.c));
  rows.emplace_back(say("analysis.units"), units);
  rows.emplace_back(say("analysis.duration"), quantity(report.problem.duration, "s"));
  std::string solver = say("solver." + std::string(name(analysis.solver)));
  if (const auto* adaptive = std::get_if<AdaptiveSolver>(&analysis.solver)) {
    solver += fmt::format(" ({} {})", say("solver.tolerance"), adaptive->tolerance);
  }
  if (const auto* stepwise = std::get_if<RungeKuttaSolver>(&analysis.solver)) {
    solver += fmt::format(" ({} {})", say("solver.step"), quantity(stepwise->step, "s"));
  }
  rows.emplace_back(say("analysis.solver"), solver);
  rows.emplace_back(say("analysis.events"), std::to_string(report.response.events));
  return element("h3", say("heading.analysis")) + facts(rows);
}

/// What result files hold of the buildings.
Html buildings_of_results(const Report& report) {
  Html content = element("p", report.say("input.from_results"), "class=\"note\"");
  for (const Building& building : report.problem.buildings) {
    const Eigen::VectorXd periods = 2 * std::numbers::pi * building.modes.omega.cwiseInverse();
    content += element("h3", building.name) +
               facts({{report.say("input.floors"), list_text(building.model.elevations) + " " + report.c.units.length},
                      {report.say("input.periods"), list_text(first_modes(periods)) + " s"}});
  }
  return content;
}

}  // namespace

PageSection input_section(const Report& report) {
  Html content = motion_echo(report);
  if (!report.from_case()) content += buildings_of_results(report);
  for (Eigen::Index b = 0; b < std::ssize(report.c.buildings); ++b) content += building_echo(report, b);
  for (Eigen::Index gap = 0; gap < std::ssize(report.c.gaps); ++gap) content += gap_echo(report, gap);
  const std::vector<std::vector<Eigen::Index>> links = links_by_spec(report.c.links);
  for (std::size_t k = 0; k < links.size(); ++k) content += link_echo(report, report.c.links[k], links[k]);
  content += initial_echo(report) + analysis_echo(report);
  return {"input", report.say("heading.input"), content};
}

}  // namespace bentur::html
