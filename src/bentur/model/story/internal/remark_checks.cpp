#include "bentur/model/story/internal/remark_checks.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <variant>

namespace bentur::remarking {
namespace {

/// Of a density of the case in kg/m³.
double kilograms(const Units& units) {
  const double metre = metres(units.length);
  return newtons(units.force) / (metre * metre * metre * metre);
}

void check_frame(const std::string& name, const PlaneFrame& frame, const Units& units, List& list) {
  const double modulus_factor = list.metre() * list.metre();  // N/m² per N/length²
  list.check("elastic_modulus", name, frame.elastic_modulus, units.force + "/" + units.length + "²", modulus_range,
             1 / (newtons(units.force) * modulus_factor));
  for (const auto* sections : {&frame.columns, &frame.beams}) {
    for (const Section& section : *sections) {
      if (section.line_mass > 0) {
        list.check("density", name, section.line_mass / section.area * kilograms(units), "kg/m³", density_range);
      }
      const double depth = depth_of(section);
      for (const double side : {depth, section.area / depth}) {
        // A steel section's equal area is a narrow rectangle, so that only its depth is small where something is wrong.
        if (side == depth || side > section_range.most * list.metre()) {
          list.check("section", name, side, list.length(), section_range, list.metre());
        }
      }
    }
  }
}

/// Beams that their load would make yield within the span before the sagging end does (docs/theory/hinges.md, Gravity).
void check_spans(const std::string& name, const PlaneFrame& frame, const Units& units, List& list) {
  const double widest = *std::max_element(frame.bay_widths.begin(), frame.bay_widths.end());
  for (std::size_t i = 0; i < frame.beams.size(); ++i) {
    const Section& beam = frame.beams[i];
    if (beam.moment_capacity.empty()) continue;
    const double most = 2 * (beam.moment_capacity.front() + beam.moment_capacity.back()) / (widest * widest);
    const std::string subject = name + ", beams[" + std::to_string(i) + "]";
    list.most("line_load", subject, beam.line_load, units.force + "/" + units.length, most, most);
  }
}

/// What the floors weigh, by themselves and by the width of the building.
void check_weights(const BuildingLook& look, const Units& units, List& list) {
  const double newton = 1 / newtons(units.force);
  for (const double mass : look.masses) {
    const double weight = mass * units.gravity;
    list.check("storey_weight", look.name, weight, units.force, weight_range, newton);
    if (!(look.width > 0)) continue;
    const double per_metre = newton / list.metre();
    list.most("storey_weight_per_width", look.name, weight / look.width, units.force + "/" + units.length,
              most_weight_per_width * per_metre, usual_weight_per_width * per_metre);
  }
}

}  // namespace

std::vector<const PlaneFrame*> frames_in(const BuildingSpec& spec) {
  std::vector<const PlaneFrame*> frames;
  if (const auto* const frame = std::get_if<PlaneFrame>(&spec.structure)) frames.push_back(frame);
  if (const auto* const plan = std::get_if<Plan>(&spec.structure)) {
    for (const PlanPlane& plane : plan->planes) {
      if (plane.frame) frames.push_back(plane.frame.get());
    }
  }
  return frames;
}

double width_of(const BuildingSpec& spec) {
  return spec.is_in_plan() ? spec.footprint().size.minCoeff() : spec.width.value_or(0);
}

std::optional<double> beam_depth(const Case& c, Eigen::Index building, Eigen::Index floor) {
  std::optional<double> depth;
  if (building >= std::ssize(c.buildings) || floor < 0) return depth;
  for (const PlaneFrame* const frame : frames_in(c.buildings[static_cast<std::size_t>(building)])) {
    if (floor >= std::ssize(frame->beams)) continue;
    depth = std::max(depth.value_or(0), depth_of(frame->beams[static_cast<std::size_t>(floor)]));
  }
  return depth;
}

double depth_of(const Section& section) { return std::sqrt(12 * section.inertia / section.area); }

void check_building(const BuildingLook& look, const Units& units, List& list) {
  if (look.omega > 0 && !look.on_bearings) {
    const auto storeys = static_cast<double>(look.storeys);
    list.check("period_per_storey", look.name, 2 * std::numbers::pi / look.omega / storeys, "s", period_range);
    list.check("damping", look.name, look.damping_rate / (2 * look.omega), "", damping_range);
  }
  if (look.stiffness_factor) list.check("stiffness_factor", look.name, *look.stiffness_factor, "", factor_range);
  check_weights(look, units, list);
  for (const double height : look.heights) {
    if (height == 0) continue;  // of a slab on bearings
    list.check("storey_height", look.name, height, list.length(), height_range, list.metre());
  }
  for (const PlaneFrame* const frame : look.frames) {
    check_frame(look.name, *frame, units, list);
    check_spans(look.name, *frame, units, list);
  }
}

void check_response(const ResponseLook& look, List& list) {
  list.most("broken_columns", look.name, static_cast<double>(look.broken_columns), "", 0, 0);
  if (look.yields) return;  // both say what the linear elastic model overlooks
  list.most("drift", look.name, 100 * look.drift, "%", most_drift, most_drift);
  list.most("base_shear", look.name, look.base_shear, "", most_base_shear, most_base_shear);
}

void check_motion(const GroundMotion& motion, const ExcitationSpec& excitation, const std::string& subject,
                  double duration, const Units& units, List& list) {
  if (std::holds_alternative<NoMotion>(motion)) return;
  const double peak = peak_acceleration(motion);
  if (peak == 0) {
    list.add({"motion_of_zeros", subject, 0, "g", pga_range.usual_from, pga_range.usual_to, true});
  } else {
    const double in_g = peak / units.gravity;
    const auto& record = excitation.record;
    const double asked = record ? record->pga_without_unit.value_or(0) : 0;
    if (in_g < pga_range.least && asked >= pga_range.least && asked <= pga_range.most &&
        record->pga_read * acceleration_factor(record->unit, units) > pga_range.least * units.gravity) {
      list.add({"pga_without_unit", subject, in_g, "g", asked, asked, true});
    } else {
      list.check("pga", subject, in_g, "g", pga_range);
    }
  }
  if (const auto* record = std::get_if<SampledMotion>(&motion); record != nullptr && peak > 0) {
    const auto at = std::max_element(record->acceleration.begin(), record->acceleration.end(),
                                     [](double a, double b) { return std::abs(a) < std::abs(b); });
    const double time = record->time_step * static_cast<double>(at - record->acceleration.begin());
    if (duration < time) list.add({"duration", subject, duration, "s", time, std::nullopt, true});
  }
}

void check_delays(const std::vector<std::string>& names, const std::vector<double>& delays, double duration,
                  List& list) {
  for (std::size_t b = 0; b < delays.size(); ++b) {
    if (delays[b] < duration) continue;
    list.add({"delay", names[b], delays[b], "s", std::nullopt, duration, true});
  }
}

void check_record(const RecordEcho& record, const std::string& subject, List& list) {
  if (record.count < 2) return;  // not read
  list.most("record_step", subject, record.time_step, "s", most_step, usual_step, far * usual_step);
  list.check("record_length", subject, record.duration, "s", length_range);
}

void check_codes(const CodeSpec& code, List& list) {
  for (const CodeRuleSpec& rule : code.rules) {
    for (const char* const key : {"deflection_amplification", "behaviour_factor", "response_reduction",
                                  "ductility_factor", "overstrength_factor"}) {
      const auto found = rule.numbers.find(key);
      if (found == rule.numbers.end()) continue;
      for (const double factor : found->second) list.most("code_on_record", rule.rule, factor, "", 1, 1, 1);
    }
  }
}

std::optional<double> stiffness_of(const std::string& law, const LawParameters& parameters) {
  if (law == "hertz" || law == "hertz-damp" || law == "jankowski") return std::nullopt;
  for (const auto& [key, value] : parameters) {
    if (key == "stiffness") return value;
  }
  return std::nullopt;
}

void LevelLook::take(double mass, double omega) {
  if (!(omega > 0)) return;
  const double period = 2 * std::numbers::pi / omega;
  shorter_period = shorter_period > 0 ? std::min(shorter_period, period) : period;
  compliance += 1 / mass;
}

void check_level(const LevelLook& look, const Units& units, List& list) {
  // Floors meet though the beam of the upper one ends above the lower one.
  const double depth = look.beam_depth.value_or(usual_beam_depth * list.metre());
  list.most("level_tolerance", look.gap, look.apart, list.length(), depth, depth);
  list.most("initial_overlap", look.gap, look.overlap, list.length(), 0, 0);
  list.most("gap_width", look.gap, look.width, list.length(), most_gap * list.metre(), usual_gap * list.metre());
  if (!look.stiffness) return;
  list.check("contact_stiffness", look.gap, *look.stiffness, units.force + "/" + units.length, stiffness_range,
             1 / (newtons(units.force) * list.metre()));
  // Buildings that touch at rest through something soft.
  if (look.width > 0 || !(look.shorter_period > 0) || !(look.compliance > 0)) return;
  const double push = std::numbers::pi / std::sqrt(*look.stiffness * look.compliance);
  list.most("soft_contact", look.gap, push / look.shorter_period, "", most_push, usual_push);
}

void check_impacts(const std::string& gap, double penetration, int slow_starts, List& list) {
  list.most("penetration", gap, penetration, list.length(), most_penetration * list.metre(),
            usual_penetration * list.metre());
  list.most("slow_starts", gap, slow_starts, "", 0, 0);
}

void check_output(double step, const std::vector<double>& omegas, double duration, List& list) {
  double shortest = duration;
  for (const double omega : omegas) {
    if (omega > 0) shortest = std::min(shortest, 2 * std::numbers::pi / omega);
  }
  list.most("output_step", "", step, "s", shortest / samples_per_period, shortest / usual_samples);
}

void check_discrepancies(const std::vector<Discrepancy>& found, List& list) {
  for (const Discrepancy& one : found) {
    list.add({.key = one.key, .subject = {}, .value = one.size, .unit = {}, .usual_from = {}, .usual_to = 1e-9});
  }
}

}  // namespace bentur::remarking
