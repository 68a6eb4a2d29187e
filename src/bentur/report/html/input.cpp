#include <algorithm>
#include <functional>
#include <numbers>
#include <numeric>
#include <utility>
#include <variant>

#include "bentur/core/number_text.h"
#include "bentur/excitation/motion_measures.h"
#include "bentur/io/schema/case_keys.h"
#include "bentur/model/gap/spectral_gap.h"
#include "bentur/report/html/internal/echo.h"
#include "bentur/structure/modes.h"

namespace bentur::html {
namespace {

constexpr Eigen::Index most_modes = 8;

std::string list_text(const std::vector<double>& values) {
  std::string text;
  for (const double value : values) text += (text.empty() ? "" : ", ") + number(value);
  return text;
}

std::vector<double> reversed(std::vector<double> values, std::size_t size) {
  if (values.size() == 1) values.resize(size, double{values.front()});
  std::reverse(values.begin(), values.end());
  return values;
}

/// Areas, inertias and masses of a frame's members as computed with, where the case says them otherwise.
HtmlTable members_table(const PlaneFrame& frame, const TomlValue& given, const Report& report) {
  const Words& say = report.say;
  const std::string& length = report.c.units.length;
  const auto computed = [&](const char* members) {
    const std::vector<TomlValue>& sections = given.find(members)->items;
    return std::any_of(sections.begin(), sections.end(), [](const TomlValue& section) {
      return section.find("area") == nullptr || section.find("mass") == nullptr;
    });
  };
  if (!computed("columns") && !computed("beams") && given.find("floor_load") == nullptr) return {};
  const std::size_t storeys = frame.storey_heights.size();
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
  table.add(say("column.storey"), "", numbers_from_the_top(storeys));
  table.add(say("column.column_area"), length + "²", values(frame.columns, &Section::area));
  table.add(say("column.column_inertia"), length + "⁴", values(frame.columns, &Section::inertia));
  table.add(say("column.column_mass"), mass_unit(report.c.units), reversed(column_masses, storeys));
  table.add(say("column.beam_area"), length + "²", values(frame.beams, &Section::area));
  table.add(say("column.beam_inertia"), length + "⁴", values(frame.beams, &Section::inertia));
  table.add(say("column.beam_mass"), mass_unit(report.c.units), reversed(beam_masses, storeys));
  table.add(say("column.floor_mass"), mass_unit(report.c.units), reversed(frame.floor_masses, storeys));
  return table;
}

/// Of values mode by mode those that are shown.
std::vector<double> first_modes(const Eigen::VectorXd& values, Eigen::Index most = most_modes) {
  return {values.begin(), values.begin() + std::min(values.size(), most)};
}

/// "√t", "√(kgf·s²/cm)".
std::string root_unit(const std::string& unit) {
  const bool is_one = unit.find_first_of("·/") == std::string::npos;
  return is_one ? "√" + unit : "√(" + unit + ")";
}

/// Of modes as many as are asked for.
HtmlTable modes_table(const Building& building, const Report& report, Eigen::Index most) {
  const Words& say = report.say;
  const ModalProperties properties = modal_properties(building);
  const Eigen::Index shown = std::min(properties.periods.size(), most);
  std::vector<std::string> numbers = numbers_from_the_top(static_cast<std::size_t>(shown));
  std::reverse(numbers.begin(), numbers.end());
  Eigen::VectorXd cumulative = properties.effective_mass_fraction;
  std::partial_sum(cumulative.begin(), cumulative.end(), cumulative.begin());
  const Eigen::VectorXd damping = building.modal_damping.diagonal().cwiseQuotient(2 * building.modes.omega);
  HtmlTable table;
  table.add(say("column.mode"), "", numbers);
  table.add(say("column.period"), "s", first_modes(properties.periods, most));
  table.add(say("column.frequency"), "Hz", first_modes(properties.periods.cwiseInverse(), most));
  table.add(say("column.damping"), "%", first_modes(100 * damping, most));
  table.add(say("column.participation"), root_unit(mass_unit(report.c.units)),
            first_modes(properties.participation, most));
  table.add(say("column.effective_mass"), "%", first_modes(100 * properties.effective_mass_fraction, most));
  table.add(say("column.cumulative_mass"), "%", first_modes(100 * cumulative, most));
  return table;
}

/// What follows of the soil below a building, and by what its stiffness was multiplied for a period that is asked for.
Rows of_structure(const Case& c, const BuildingSpec& spec, const std::optional<double>& stiffness_factor,
                  const Words& say) {
  Rows rows;
  if (spec.soil && spec.soil->half_space) {
    const Soil soil = soil_of(*spec.soil);
    const auto add = [&](const char* motion, const KeyTable& keys, const Impedance& impedance) {
      rows.emplace_back(label_text(soil_keys().at(motion).label, say),
                        quantity(impedance.stiffness, unit_of(keys.at("stiffness"), c.units)) + ", " +
                            quantity(impedance.damping, unit_of(keys.at("damping"), c.units)));
    };
    add("sway", sway_keys(), soil.sway);
    add("rocking", rocking_keys(), soil.rocking);
  }
  if (spec.calibrate_period) rows.emplace_back(say("input.stiffness_factor"), number(stiffness_factor.value_or(1)));
  return rows;
}

/// What is computed from what a building is given by.
Derived of_building(const Report& report, const TomlValue& given, Eigen::Index b) {
  const Words& say = report.say;
  const BuildingSpec& spec = report.c.buildings.at(b);
  const Building& building = report.problem.buildings.at(b);
  Derived derived{building.name};
  derived.rows = of_structure(report.c, spec, building.model.stiffness_factor, say);
  if (const auto* frame = std::get_if<PlaneFrame>(&spec.structure)) {
    const HtmlTable members = members_table(*frame, *given.find("frame"), report);
    derived.tables += under("h4", say("input.members"), members);
    derived.printed.push_back(members.called(say("input.members")));
  }
  derived.printed.resize(1);  // one for each building
  if (building.is_rigid()) return derived;
  derived.tables += under("h4", say("heading.modes"), modes_table(building, report, most_modes));
  if (const Eigen::Index rest = modal_properties(building).periods.size() - most_modes; rest > 0) {
    derived.tables += element("p", say("input.modes_more", {{"n", std::to_string(rest)}}), "class=\"note\"");
  }
  derived.printed.push_back(modes_table(building, report, 1).called(say("heading.modes")));
  return derived;
}

/// What the law of a contact or a link works with is called as the key that says it.
const Key& key_of_law(const KeyTable& keys, const std::string& name, const std::string& law) {
  for (const Key& key : keys.keys) {
    if (key.name == name && key.is_for("law", law)) return key;
  }
  return keys.at(name);
}

/// What the laws of a gap work with, point by point from the top.
Derived of_gap(const Report& report, Eigen::Index gap) {
  const Words& say = report.say;
  const GapSpec& spec = report.c.gaps.at(gap);
  Derived derived{say("heading.gap_of", {{"gap", gap_name(report.problem, gap)}})};
  if (spec.elevations.empty()) {
    derived.rows.emplace_back(label_text(contact_keys().at("law").label, say), say("input.no_contact"));
    return derived;
  }
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
    for (const auto& [name, values] : spec.contact.numbers) {
      parameters.emplace_back(name, reversed(values, values.size()));
    }
  }
  HtmlTable table, row;
  const auto add = [&](const std::string& name, const std::string& unit, const std::vector<double>& values) {
    table.add(name, unit, values);
    const bool are_alike = std::adjacent_find(values.begin(), values.end(), std::not_equal_to<>()) == values.end();
    row.add(name, unit, {are_alike ? number(values.front()) : list_text({values.rbegin(), values.rend()})}, are_alike);
  };
  add(say("column.elevation"), report.c.units.length, elevations);
  add(say("column.gap"), report.c.units.length, widths);
  for (const auto& [name, values] : parameters) {
    const Key& key = key_of_law(contact_keys(), name, spec.contact.law);
    add(label_text(key.label, say), unit_of(key, report.c.units), values);
  }
  derived.tables = under("h4", say("input.levels"), table);
  derived.printed = {row};
  return derived;
}

/// The ground motion as it was read and as it is applied; of two components each behind its axis.
/// @param pgas of the components as applied [length/s²]
Rows of_motion(const Case& c, const std::vector<std::string>& buildings, const std::vector<double>& pgas,
               const Words& say) {
  const std::vector<const ExcitationSpec*> components = c.excitations();
  const bool are_two = std::count_if(pgas.begin(), pgas.end(), [](double pga) { return pga > 0; }) > 1;
  Rows rows;
  for (std::size_t i = 0; i < components.size(); ++i) {
    const ExcitationSpec& excitation = *components[i];
    const double pga = pgas.at(i);
    if (c.is_in_plan() && !(pga > 0) && !excitation.spectrum) continue;
    const std::string of = !are_two ? "" : i == 0 ? "x: " : "y: ";
    if (excitation.record) {
      for (auto& [name, text] : rows_of_record(*excitation.record, say)) rows.emplace_back(of + name, text);
    }
    if (excitation.spectrum && !excitation.spectrum->of_displacements) {
      rows.emplace_back(of + say("spectral.parameters"), spectrum_parameters(*excitation.spectrum, c.units));
    }
    if (pga > 0) {
      rows.emplace_back(of + say("motion.pga"),
                        quantity(pga, acceleration_unit(c.units)) + " = " + quantity(pga / c.units.gravity, "g"));
    }
    if (c.is_in_plan()) continue;  // results read back do not have the motion, and say what the run said
    const MotionMeasures measures = motion_measures(excitation.motion);
    if (measures.pgv > 0) rows.emplace_back(of + say("motion.pgv"), quantity(measures.pgv, c.units.length + "/s"));
    if (measures.significant_duration > 0) {
      rows.emplace_back(of + say("motion.significant"), quantity(measures.significant_duration, "s"));
    }
  }
  for (std::size_t b = 0; b < c.excitation.delays.size(); ++b) {
    if (c.excitation.delays[b] == 0) continue;
    rows.emplace_back(say("motion.delay", {{"building", buildings.at(b)}}), quantity(c.excitation.delays[b], "s"));
  }
  return rows;
}

Rows of_motion(const Report& report) {
  std::vector<std::string> names;
  for (const Building& building : report.problem.buildings) names.push_back(building.name);
  return of_motion(report.c, names, {applied_pga(report.c)}, report.say);
}

/// @param given the table of the case
Rows of_analysis(const InputOf& of, const TomlValue& given) {
  Rows rows;
  if (is_without_motion(of.c)) return rows;  // no run is told of
  if (given.find("duration") == nullptr) {
    rows.emplace_back(label_text(analysis_keys().at("duration").label, of.say), quantity(of.duration, "s"));
  }
  rows.emplace_back(of.say("analysis.events"), std::to_string(of.events));
  return rows;
}

InputOf input_of(const Report& report) {
  InputOf of{.c = report.c,
             .say = report.say,
             .to_hand_in = report.to_hand_in,
             .duration = report.problem.duration,
             .events = report.response.events};
  of.motion = of_motion(report);
  for (const std::vector<Eigen::Index>& links : links_by_spec(report.c.links)) {
    of.links.push_back(links.empty() ? "" : link_name(report.problem, report.problem.links.at(links.front())));
  }
  of.building = [&](std::size_t b, const TomlValue& given) {
    return of_building(report, given, static_cast<Eigen::Index>(b));
  };
  of.gap = [&](std::size_t gap) { return of_gap(report, static_cast<Eigen::Index>(gap)); };
  return of;
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

/// What is known of a run whose case is not at hand.
Html without_case(const Report& report) {
  const Words& say = report.say;
  const auto choice = [&](const KeyTable& keys, const char* key, std::string_view word) {
    return std::pair(label_text(keys.at(key).label, say), label_text(keys.at(key).label_of(word), say));
  };
  Rows motion = of_motion(report);
  const ExcitationSpec& excitation = report.c.excitation;
  if (excitation.record) {
    motion.emplace_back(label_text(excitation_keys().at("file").label, say), excitation.record->file);
    if (excitation.record->reversed) motion.push_back(choice(excitation_keys(), "polarity", "reversed"));
  }
  if (const auto* harmonic = std::get_if<HarmonicMotion>(&excitation.motion)) {
    const bool sine = harmonic->phase == HarmonicMotion::Phase::sine;
    motion.push_back(choice(excitation_keys(), "phase", sine ? "sine" : "cosine"));
    motion.emplace_back(label_text(excitation_keys().at("period").label, say), quantity(harmonic->period, "s"));
    motion.emplace_back(label_text(excitation_keys().at("displacement_amplitude").label, say),
                        quantity(std::abs(harmonic->displacement_amplitude), report.c.units.length));
    if (harmonic->is_reversed()) motion.push_back(choice(excitation_keys(), "polarity", "reversed"));
  }
  Html content = element("h3", label_text(case_keys().at("excitation").label, say)) + facts(motion);
  content += buildings_of_results(report);
  for (Eigen::Index gap = 0; gap < std::ssize(report.c.gaps); ++gap) {
    Derived derived = of_gap(report, gap);
    const ContactSpec& contact = report.c.gaps[gap].contact;
    if (!report.c.gaps[gap].elevations.empty()) {
      derived.rows.push_back(choice(contact_keys(), "law", contact.law));
      for (const auto& [key, word] : contact.words) derived.rows.push_back(choice(contact_keys(), key.c_str(), word));
    }
    content += element("h3", derived.heading) + facts(derived.rows) + derived.tables;
  }
  for (const LinkSpec& link : report.c.links) {
    HtmlTable table;
    table.add(say("column.elevation"), report.c.units.length, reversed(link.elevations, link.elevations.size()));
    for (const auto& [name, values] : link.numbers) {
      const Key& key = key_of_law(link_keys(), name, link.law);
      table.add(label_text(key.label, say), unit_of(key, report.c.units), reversed(values, link.elevations.size()));
    }
    content += element("h3", label_text(case_keys().at("link").label, say)) +
               facts({choice(link_keys(), "law", link.law)}) + under("h4", say("input.levels"), table);
  }
  Rows analysis = of_analysis(input_of(report), {});
  analysis.push_back(choice(analysis_keys(), "solver", name(report.c.analysis.solver)));
  analysis.emplace_back(say("analysis.units"), report.c.units.length + ", " + report.c.units.force + ", s");
  return content + element("h3", label_text(case_keys().at("analysis").label, say)) + facts(analysis);
}

}  // namespace

Rows rows_of_record(const RecordEcho& record, const Words& say) {
  Rows rows;
  rows.emplace_back(say("motion.format"), record.format + ", " + record.unit);
  if (!record.channel.empty()) rows.emplace_back(say("motion.channel"), record.channel);
  if (record.header_lines > 0) rows.emplace_back(say("motion.header_lines"), std::to_string(record.header_lines));
  if (record.mean_removed != 0) {
    rows.emplace_back(say("motion.mean_removed"), quantity(record.mean_removed, record.unit));
  }
  rows.emplace_back(say("motion.samples"), say("motion.samples_text", {{"count", std::to_string(record.count)},
                                                                       {"step", quantity(record.time_step, "s")},
                                                                       {"duration", quantity(record.duration, "s")}}));
  rows.emplace_back(say("motion.pga_read"), quantity(record.pga_read, record.unit));
  return rows;
}

PageSection input_section(const InputOf& of) {
  const Words& say = of.say;
  const Case& c = of.c;
  Html content;
  if (of.to_hand_in) {
    const std::string file = c.source ? c.source->file : "";
    if (!file.empty()) content += element("p", say("input.lines_of", {{"file", file}}), "class=\"note\"");
    Html sources;
    if (c.project) {
      for (const std::string& one : c.project->sources) sources += element("li", one);
    }
    if (!sources.str().empty()) content += element("p", say("input.sources")) + element("ul", sources);
  }
  for (const Key& key : case_keys().keys) {
    if (key.name == "project") continue;  // it stands at the head
    const TomlValue nothing;
    const TomlValue* const found = c.given->find(std::string(key.name));
    const TomlValue& given = found != nullptr ? *found : nothing;
    const bool always = key.name == "units" || (key.name == "analysis" && !is_without_motion(c));
    if (key.table == nullptr || (found == nullptr && !always)) continue;
    const bool is_list = given.kind == TomlValue::Kind::list;
    EachOf each(true);
    for (std::size_t i = 0; i < (is_list ? given.items.size() : 1); ++i) {
      TomlValue one = is_list ? given.items[i] : given;
      Derived derived{label_text(key.label, say)};
      if (key.name == "building") derived = of.building(i, one);
      if (key.name == "gap") derived = of.gap(i);
      if (key.name == "link") derived.heading = say("heading.links_of", {{"link", of.links.at(i)}});
      if (key.name == "excitation") derived.rows = of.motion;
      if (key.name == "analysis") derived.rows = of_analysis(of, one);
      if (key.name == "units" && one.find("gravity") == nullptr) {
        derived.rows.emplace_back(label_text(unit_keys().at("gravity").label, say),
                                  quantity(c.units.gravity, acceleration_unit(c.units)));
      }
      if (key.name == "building")
        std::erase_if(one.members, [](const TomlMember& member) { return member.key == "plane"; });
      Echoed echoed = echo(*key.table, one, say, c.units, of.to_hand_in, derived.rows);
      if (key.name == "gap") {
        for (const HtmlTable& of_points : std::exchange(derived.printed, {})) echoed.row.add_new(of_points);
      }
      derived.printed.insert(derived.printed.begin(), std::move(echoed.row));
      each.add(derived.heading, echoed.markup + derived.tables, derived.printed);
    }
    content += each.markup(say, entries_key(say, key.name));
    const bool is_of_plan = key.name == "plan" || (key.name == "gap" && c.given->find("plan") == nullptr);
    if (c.is_in_plan() && is_of_plan) content += element("p", say("plan.shared"), "class=\"note\"");
  }
  return {"input", say("heading.input"), content};
}

PageSection input_section(const Report& report) {
  if (report.c.given == nullptr) return {"input", report.say("heading.input"), without_case(report)};
  return input_section(input_of(report));
}

PageSection input_section(const Case& c, const PlanProblem& problem, long events, const Words& say) {
  InputOf of{.c = c, .say = say, .to_hand_in = c.project.has_value(), .duration = problem.duration, .events = events};
  std::vector<std::string> names;
  for (const PlanBuilding& building : problem.buildings) names.push_back(building.name);
  std::vector<double> pgas;
  for (std::size_t i = 0; i < c.excitations().size(); ++i) {
    const std::optional<RecordEcho>& record = c.excitations()[i]->record;
    pgas.push_back(record ? record->pga : peak_acceleration(problem.motions.at(i)));
  }
  of.motion = of_motion(c, names, pgas, say);
  for (const std::vector<Eigen::Index>& links : links_by_spec(c.links)) {
    of.links.push_back(links.empty() ? "" : link_name(problem, problem.links.at(links.front())));
  }
  of.building = [&](std::size_t b, const TomlValue& given) {
    Derived derived = of_building_in_plan(c, problem, static_cast<Eigen::Index>(b), given, say);
    derived.rows = of_structure(c, c.buildings.at(b), problem.buildings.at(b).model.stiffness_factor, say);
    return derived;
  };
  of.gap = [&](std::size_t gap) {
    return Derived{say("heading.gap_of", {{"gap", gap_name(problem, problem.gaps.at(gap))}})};
  };
  return input_section(of);
}

}  // namespace bentur::html
