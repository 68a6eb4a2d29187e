#include "bentur/model/story/internal/remark_checks.h"

#include <algorithm>
#include <cmath>
#include <variant>

#include "bentur/excitation/usual_peaks.h"

namespace bentur::remarking {
namespace {

/// Of a rectangle with the area and inertia of a section [length].
double depth_of(const Section& section) { return std::sqrt(12 * section.inertia / section.area); }

/// The frames that a building is, or has in plan.
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

void check_frame(const std::string& name, const PlaneFrame& frame, List& list) {
  list.check("elastic_modulus", name, frame.elastic_modulus);
  for (const auto* sections : {&frame.columns, &frame.beams}) {
    for (const Section& section : *sections) {
      if (section.line_mass > 0) {
        list.check("density", name, section.line_mass / section.area * list.si("F L-4"));
      }
      // A steel section's equal area is a narrow rectangle, so that only its depth is small where something is wrong.
      const double depth = depth_of(section);
      for (const double side : {depth, section.area / depth}) list.check("section", name, std::max(side, depth));
    }
  }
  for (const std::optional<Infill>& infill : frame.infills) {
    if (infill && infill->thickness > 0) list.check(infill_thickness, name + ", infill.thickness", infill->thickness);
  }
  // Beams that their load would make yield within the span before the sagging end does (docs/theory/hinges.md,
  // Gravity).
  const double widest = *std::max_element(frame.bay_widths.begin(), frame.bay_widths.end());
  for (std::size_t i = 0; i < frame.beams.size(); ++i) {
    const Section& beam = frame.beams[i];
    if (beam.moment_capacity.empty()) continue;
    const double most = 2 * (beam.moment_capacity.front() + beam.moment_capacity.back()) / (widest * widest);
    list.check("line_load", name + ", beams[" + std::to_string(i) + "]", beam.line_load, most, most);
  }
}

}  // namespace

void check_given(const BuildingSpec& spec, const std::vector<double>& heights, const std::vector<double>& masses,
                 List& list) {
  const double width = spec.is_in_plan() ? spec.footprint().size.minCoeff() : spec.width.value_or(0);
  for (const double mass : masses) {
    if (width > 0) list.check("storey_weight_per_width", spec.name, mass * list.units().gravity / width);
  }
  for (const double height : heights) {
    if (height != 0) list.check("storey_height", spec.name, height);  // 0: of a slab on bearings
  }
  for (const PlaneFrame* const frame : frames_in(spec)) check_frame(spec.name, *frame, list);
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

void check_motion(const GroundMotion& motion, const ExcitationSpec& excitation, const std::string& subject,
                  double duration, List& list) {
  if (std::holds_alternative<NoMotion>(motion)) return;
  const double peak = peak_acceleration(motion);
  const double in_g = peak / list.units().gravity;
  const auto& record = excitation.record;
  const double asked = (record ? record->pga_without_unit : excitation.amplitude_without_unit).value_or(0);
  // Before a record is scaled it may be as weak, and meant so; but if its unit stands in the case alone, that may be
  // another one.
  const bool is_read = record && !record->unit.empty();
  const double read = is_read ? record->pga_read * acceleration_factor(record->unit, list.units()) : 0;
  const double read_in_g = read / list.units().gravity;
  const bool is_weak = is_read && read_in_g <= UsualPeak().from;
  const double number = excitation.amplitude_without_unit.value_or(0);
  if (peak > 0 && is_rather_in_g(asked, in_g) && !is_weak) {
    list.add("pga_without_unit", subject, in_g, asked, asked);
  } else if (is_weak && in_g < UsualPeak().from && record->unit != "g" && is_rather_in_g(number, read_in_g)) {
    list.add("pga", subject, in_g, UsualPeak().from, UsualPeak().to);
  } else {
    list.check(peak == 0 ? "motion_of_zeros" : "pga", subject, in_g);
  }
  const auto* const sampled = std::get_if<SampledMotion>(&motion);
  if (sampled != nullptr && peak > 0 &&
      duration < sampled->time_step * static_cast<double>(sampled->acceleration.size())) {
    const auto at = std::max_element(sampled->acceleration.begin(), sampled->acceleration.end(),
                                     [](double a, double b) { return std::abs(a) < std::abs(b); });
    const double time = sampled->time_step * static_cast<double>(at - sampled->acceleration.begin());
    if (duration < time) list.add("duration", subject, duration, time, std::nullopt);
  }
}

void check_record(const RecordEcho& record, const std::string& subject, List& list) {
  if (record.count < 2) return;  // not read
  list.check("record_step", subject, record.time_step);
  list.check("record_length", subject, record.duration);
}

void check_codes(const CodeSpec& code, List& list) {
  for (const CodeRuleSpec& rule : code.rules) {
    for (const char* const key : {"deflection_amplification", "behaviour_factor", "response_reduction",
                                  "ductility_factor", "overstrength_factor"}) {
      const auto found = rule.numbers.find(key);
      if (found == rule.numbers.end()) continue;
      for (const double factor : found->second) list.check("code_on_record", rule.rule, factor);
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

}  // namespace bentur::remarking
