#include "bentur/model/story/remarks.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "bentur/model/suite/suite.h"

namespace bentur {
namespace {

/// Usual, and from where on it is remarked on: a factor apart, so that the unusual is not nagged at.
struct Range {
  double usual_from, usual_to, least, most;
};

constexpr Range period_range = {0.05, 0.2, 0.02, 0.6};      // [s] per storey
constexpr Range modulus_range = {1e10, 2.1e11, 5e8, 3e11};  // [N/m²]: timber, concrete, steel
constexpr Range section_range = {0.2, 2.0, 0.04, 4.0};      // [m]
constexpr Range height_range = {2.5, 6.0, 0.5, 15.0};       // [m]
constexpr Range stiffness_range = {1e7, 1e10, 1e5, 1e13};   // [N/m] of contact: by beams over half a bay, or tests
constexpr Range damping_range = {0.01, 0.07, 0.0, 0.2};     // [-]
constexpr Range pga_range = {0.05, 1.0, 0.05, 2.5};         // [g]
constexpr Range length_range = {5.0, 600.0, 5.0, 600.0};    // [s] of a record
constexpr double most_step = 0.1;                           // [s] of a record
constexpr double usual_step = 0.05;                         // [s]
constexpr Range factor_range = {0.3, 3.0, 0.3, 3.0};        // [-] of stiffness, to reach a period
constexpr Range weight_range = {5e3, 1e7, 500.0, 2e8};      // [N] of a floor
constexpr double most_gap = 2.0;                            // [m]
constexpr double usual_gap = 0.5;                           // [m]
constexpr double most_drift = 1.0;                          // [%]
constexpr double most_base_shear = 0.4;                     // [-]
constexpr double most_penetration = 0.05;                   // [m]
constexpr double usual_penetration = 0.02;                  // [m]
constexpr double least_share = 0.9;                         // [-] of a floor's mass that known modes move
constexpr double most_weight_per_width = 1e7;               // [N/m] of a floor
constexpr double usual_weight_per_width = 1e6;              // [N/m]
constexpr double usual_beam_depth = 0.6;                    // [m] where it is not known
constexpr double share_of_blow = 0.1;                       // [-] of its energy, that makes a mode matter
constexpr double most_push = 0.1;                           // [-] of a first period: longer is no blow
constexpr double usual_push = 0.05;                         // [-]
constexpr double samples_per_period = 4.0;                  // fewer draw no curve
constexpr double usual_samples = 20.0;

double two_digits(double x) {
  if (!(x > 0) || !std::isfinite(x)) return x;
  const double unit = std::pow(10.0, std::floor(std::log10(x)) - 1);
  return std::round(x / unit) * unit;
}

/// Remarks with their usual ranges in the units of a case.
class List {
 public:
  explicit List(const Units& units) : length_(units.length), metre_(1 / metres(units.length)) {}

  /// A value outside a range in `factor` units of the case.
  void check(const char* key, const std::string& subject, double value, const std::string& unit, const Range& range,
             double factor = 1) {
    if (value >= range.least * factor && value <= range.most * factor) return;
    add({key, subject, value, unit, two_digits(range.usual_from * factor), two_digits(range.usual_to * factor)});
  }
  void most(const char* key, const std::string& subject, double value, const std::string& unit, double limit,
            double usual) {
    if (value > limit) add({key, subject, value, unit, std::nullopt, two_digits(usual)});
  }
  void add(Remark remark) {
    // One of a kind and subject: the farther out.
    const auto same = std::find_if(all_.begin(), all_.end(), [&](const Remark& other) {
      return other.key == remark.key && other.subject == remark.subject;
    });
    if (same == all_.end()) {
      all_.push_back(std::move(remark));
    } else if (distance(remark) > distance(*same)) {
      *same = std::move(remark);
    }
  }
  [[nodiscard]] double metre() const { return metre_; }  ///< in the case's length
  [[nodiscard]] const std::string& length() const { return length_; }
  [[nodiscard]] std::vector<Remark> take() { return std::move(all_); }

 private:
  static double distance(const Remark& remark) {
    // Where nothing at all is usual, by its size.
    const double over = !remark.usual_to ? 0 : *remark.usual_to > 0 ? remark.value / *remark.usual_to : remark.value;
    const double under = remark.usual_from && remark.value > 0 ? *remark.usual_from / remark.value : 0;
    return std::max(over, under);
  }

  std::string length_;
  double metre_;
  std::vector<Remark> all_;
};

void check_frame(const std::string& name, const PlaneFrame& frame, const Units& units, List& list) {
  const double modulus_factor = list.metre() * list.metre();  // N/m² per N/length²
  list.check("elastic_modulus", name, frame.elastic_modulus, units.force + "/" + units.length + "²", modulus_range,
             1 / (newtons(units.force) * modulus_factor));
  for (const auto* sections : {&frame.columns, &frame.beams}) {
    for (const Section& section : *sections) {
      const double depth = std::sqrt(12 * section.inertia / section.area);  // of a rectangle
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
void check_weights(const Case& c, std::size_t b, const Building& building, List& list) {
  const double newton = 1 / newtons(c.units.force);
  const double width = b < c.buildings.size() ? c.buildings[b].width.value_or(0) : 0;
  for (const double mass : building.model.floor_masses) {
    const double weight = mass * c.units.gravity;
    list.check("storey_weight", building.name, weight, c.units.force, weight_range, newton);
    if (!(width > 0)) continue;
    const double per_metre = newton / list.metre();
    list.most("storey_weight_per_width", building.name, weight / width, c.units.force + "/" + c.units.length,
              most_weight_per_width * per_metre, usual_weight_per_width * per_metre);
  }
}

void check_buildings(const Case& c, const Problem& problem, List& list) {
  for (std::size_t b = 0; b < problem.buildings.size(); ++b) {
    const Building& building = problem.buildings[b];
    const double omega = building.first_omega();
    if (building.is_rigid()) continue;
    if (omega > 0 && !building.model.slab) {  // bearings are there to change both
      list.check("period_per_storey", building.name, proportions(building, c.units, nullptr).period_per_storey, "s",
                 period_range);
      list.check("damping", building.name, building.modal_damping(0, 0) / (2 * omega), "", damping_range);
    }
    if (building.model.stiffness_factor) {
      list.check("stiffness_factor", building.name, *building.model.stiffness_factor, "", factor_range);
    }
    check_weights(c, b, building, list);
    if (b >= c.buildings.size()) continue;
    for (const double height : building.model.storey_heights) {
      if (height == 0) continue;  // of a slab on bearings
      list.check("storey_height", building.name, height, list.length(), height_range, list.metre());
    }
    if (const auto* frame = std::get_if<PlaneFrame>(&c.buildings[b].structure)) {
      check_frame(building.name, *frame, c.units, list);
      check_spans(building.name, *frame, c.units, list);
    }
  }
}

/// The depth of the beams at a floor [length]; nothing where it is not known.
std::optional<double> beam_depth(const Case& c, Eigen::Index b, Eigen::Index floor) {
  const auto place = static_cast<std::size_t>(b);
  const auto* frame = place < c.buildings.size() ? std::get_if<PlaneFrame>(&c.buildings[place].structure) : nullptr;
  if (frame == nullptr || floor >= std::ssize(frame->beams)) return std::nullopt;
  const Section& beam = frame->beams[static_cast<std::size_t>(floor)];
  return std::sqrt(12 * beam.inertia / beam.area);  // of a rectangle
}

/// Floors that meet though the beam of the upper one ends above the lower one.
void check_levels(const Case& c, const Problem& problem, List& list) {
  for (const ContactPoint& point : problem.points) {
    const StructuralModel& left = problem.buildings[point.left].model;
    const StructuralModel& right = problem.buildings[point.left + 1].model;
    if (point.left_floor >= left.floors() || point.right_floor >= right.floors()) continue;
    const double above = left.elevations[point.left_floor] - right.elevations[point.right_floor];
    const auto depth = above > 0 ? beam_depth(c, point.left, point.left_floor - left.first_storey())
                                 : beam_depth(c, point.left + 1, point.right_floor - right.first_storey());
    const double limit = depth.value_or(usual_beam_depth * list.metre());
    list.most("level_tolerance", gap_name(problem, point.left), std::abs(above), list.length(), limit, limit);
  }
}

/// Damping of the modes that take a blow at a column that is struck: by the squares of their shapes there. Modes of its
/// node are fast, so that damping which grows with frequency all but holds it.
void check_blows(const Problem& problem, List& list) {
  for (const ContactPoint& point : problem.points) {
    const auto struck = struck_column(problem, point);
    if (!struck) continue;
    const Building& building = problem.buildings[struck->building];
    const Eigen::VectorXd shape = building.modes.shapes.row(building.model.floors() + struck->node);
    for (Eigen::Index mode = 0; mode < shape.size(); ++mode) {
      const double omega = building.modes.omega(mode);
      if (shape(mode) * shape(mode) < share_of_blow * shape.squaredNorm() || !(omega > 0)) continue;
      list.most("impact_damping", building.name, building.modal_damping(mode, mode) / (2 * omega), "",
                damping_range.most, damping_range.usual_to);
    }
  }
}

/// Buildings that touch at rest through something soft.
void check_fillers(const Case& c, const Problem& problem, List& list) {
  for (const ContactPoint& point : problem.points) {
    if (point.width > 0) continue;
    const GapSpec& gap = c.gaps.at(point.left);
    if (gap.contact.law == "hertz" || gap.contact.law == "hertz-damp" || gap.contact.law == "jankowski") continue;
    double shorter = 0, compliance = 0;
    for (const auto& [b, at] :
         {std::pair(point.left, point.left_floor), std::pair(point.left + 1, point.right_floor)}) {
      const Building& building = problem.buildings[b];
      if (!(building.first_omega() > 0)) continue;
      const double period = 2 * std::numbers::pi / building.first_omega();
      shorter = shorter > 0 ? std::min(shorter, period) : period;
      const Eigen::Index floors = building.model.floors();
      compliance += 1 / (at < floors ? building.model.floor_masses[at] : building.model.node_masses[at - floors]);
    }
    for (const auto& [key, value] : point.law->parameters()) {
      if (key != "stiffness" || !(shorter > 0) || !(compliance > 0)) continue;
      list.most("soft_contact", gap_name(problem, point.left),
                std::numbers::pi / std::sqrt(value * compliance) / shorter, "", most_push, usual_push);
    }
  }
}

/// Factors of codes that amplify displacements under reduced forces, beside a motion.
void check_codes(const Case& c, List& list) {
  if (c.excitation.spectrum) return;
  for (const CodeRuleSpec& rule : c.code.rules) {
    for (const char* const key :
         {"deflection_amplification", "behaviour_factor", "response_reduction", "ductility_factor"}) {
      const auto found = rule.numbers.find(key);
      if (found == rule.numbers.end()) continue;
      for (const double factor : found->second) list.most("code_on_record", rule.rule, factor, "", 1, 1);
    }
  }
}

/// Floors that can be struck, of buildings that move in few modes.
void check_modes(const Case& c, const Problem& problem, List& list) {
  for (const ContactPoint& point : problem.points) {
    for (const auto& [b, floor] :
         {std::pair(point.left, point.left_floor), std::pair(point.left + 1, point.right_floor)}) {
      const auto place = static_cast<std::size_t>(b);
      if (place >= c.buildings.size()) continue;
      const auto* modal = std::get_if<ModalBuilding>(&c.buildings[place].structure);
      if (modal == nullptr) continue;
      const Building& building = problem.buildings[place];
      // M φ is m_i φ_i, since M is diagonal.
      const double share = building.model.mass(floor, floor) * building.modes.shapes.row(floor).squaredNorm();
      if (share < least_share) list.add({"modal_mass", building.name, share, "", least_share, std::nullopt});
    }
  }
}

double first_floor_value(const std::vector<Eigen::VectorXd>& all, std::size_t building, Eigen::Index floor) {
  return all.empty() ? 0.0 : all[building](floor);
}

void check_gaps(const Case& c, const Problem& problem, List& list) {
  for (const ContactPoint& point : problem.points) {
    const Eigen::Index left = point.left;
    const std::string name = gap_name(problem, left);
    list.most("gap_width", name, point.width, list.length(), most_gap * list.metre(), usual_gap * list.metre());
    const double overlap = first_floor_value(problem.initial_displacement, left, point.left_floor) -
                           first_floor_value(problem.initial_displacement, left + 1, point.right_floor) - point.width;
    list.most("initial_overlap", name, overlap, list.length(), 0, 0);
    const GapSpec& gap = c.gaps.at(left);
    if (gap.contact.law == "hertz" || gap.contact.law == "hertz-damp" || gap.contact.law == "jankowski") continue;
    for (const auto& [key, value] : point.law->parameters()) {
      if (key != "stiffness") continue;
      list.check("contact_stiffness", name, value, c.units.force + "/" + c.units.length, stiffness_range,
                 1 / (newtons(c.units.force) * list.metre()));
    }
  }
}

/// Whether the times of a record are those of an earthquake in seconds.
void check_record(const RecordEcho& record, const std::string& subject, List& list) {
  if (record.count < 2) return;  // not read
  list.most("record_step", subject, record.time_step, "s", most_step, usual_step);
  list.check("record_length", subject, record.duration, "s", length_range);
}

void check_records(const Case& c, List& list) {
  if (c.excitation.record) check_record(*c.excitation.record, "", list);
  if (!c.excitation.suite) return;
  for (const SuiteRecord& record : c.excitation.suite->records) check_record(record.echo, record.echo.file, list);
}

void check_motion(const Case& c, const Problem& problem, List& list) {
  if (std::holds_alternative<NoMotion>(problem.motion)) return;
  const double peak = peak_acceleration(problem.motion);
  if (peak == 0) {
    list.add({"motion_of_zeros", "", 0, "g", pga_range.usual_from, pga_range.usual_to});
  } else {
    const double in_g = peak / c.units.gravity;
    const auto& record = c.excitation.record;
    const double asked = record ? record->pga_without_unit.value_or(0) : 0;
    if (in_g < pga_range.least && asked >= pga_range.least && asked <= pga_range.most &&
        record->pga_read * acceleration_factor(record->unit, c.units) > pga_range.least * c.units.gravity) {
      list.add({"pga_without_unit", "", in_g, "g", asked, asked});
    } else {
      list.check("pga", "", in_g, "g", pga_range);
    }
  }
  for (std::size_t b = 0; b < problem.delays.size(); ++b) {
    if (problem.delays[b] < problem.duration) continue;
    list.add({"delay", problem.buildings[b].name, problem.delays[b], "s", std::nullopt, problem.duration});
  }
  if (const auto* record = std::get_if<SampledMotion>(&problem.motion); record != nullptr && peak > 0) {
    const auto at = std::max_element(record->acceleration.begin(), record->acceleration.end(),
                                     [](double a, double b) { return std::abs(a) < std::abs(b); });
    const double time = record->time_step * static_cast<double>(at - record->acceleration.begin());
    if (problem.duration < time) list.add({"duration", "", problem.duration, "s", time, std::nullopt});
  }
}

void check_output(const Case& c, const Problem& problem, List& list) {
  double shortest = problem.duration;
  for (const Building& building : problem.buildings) {
    if (building.first_omega() > 0) shortest = std::min(shortest, 2 * std::numbers::pi / building.first_omega());
  }
  list.most("output_step", "", c.analysis.output_step, "s", shortest / samples_per_period, shortest / usual_samples);
}

void check_before(const Case& c, const Problem& problem, List& list) {
  check_buildings(c, problem, list);
  check_modes(c, problem, list);
  check_blows(problem, list);
  check_levels(c, problem, list);
  check_gaps(c, problem, list);
  check_fillers(c, problem, list);
  check_records(c, list);
  check_motion(c, problem, list);
  check_codes(c, list);
  check_output(c, problem, list);
}

}  // namespace

std::vector<Remark> remarks(const Case& c, const Problem& problem) {
  List list(c.units);
  check_before(c, problem, list);
  return list.take();
}

std::vector<Remark> remarks(const RecordEcho& record, const Units& units) {
  List list(units);
  check_record(record, "", list);
  if (record.pga == 0) {
    list.add({"motion_of_zeros", "", 0, "g", pga_range.usual_from, pga_range.usual_to});
  } else {
    list.check("pga", "", record.pga / units.gravity, "g", pga_range);
  }
  return list.take();
}

std::vector<Remark> remarks(const Case& c, const Problem& problem, const Response& response) {
  List list(c.units);
  check_before(c, problem, list);
  for (std::size_t b = 0; b < problem.buildings.size(); ++b) {
    const Building& building = problem.buildings[b];
    if (!(building.first_omega() > 0)) continue;  // a free body
    const BuildingPeaks& peaks = response.buildings.at(b);
    const auto broken = std::count_if(peaks.columns.begin(), peaks.columns.end(),
                                      [](const BuildingPeaks::Breaking& column) { return column.break_time; });
    list.most("broken_columns", building.name, static_cast<double>(broken), "", 0, 0);
    // Both say what the linear elastic model overlooks.
    if (building.storeys_yield() || !building.model.hinges.places.empty()) continue;
    double drift = 0;
    for (const double ratio : peaks.drift_ratio) drift = std::fmax(drift, ratio);  // a slab has none
    list.most("drift", building.name, 100 * drift, "%", most_drift, most_drift);
    const Proportions found = proportions(building, c.units, &peaks);
    list.most("base_shear", building.name, found.base_shear_coefficient.value_or(0), "", most_base_shear,
              most_base_shear);
  }
  std::vector<int> slow_starts(problem.buildings.size(), 0);  // per gap
  for (std::size_t i = 0; i < problem.points.size(); ++i) {
    const Eigen::Index left = problem.points[i].left;
    list.most("penetration", gap_name(problem, left), response.points.at(i).peak_penetration, list.length(),
              most_penetration * list.metre(), usual_penetration * list.metre());
    slow_starts.at(left) += response.points.at(i).slow_starts;
  }
  for (Eigen::Index gap = 0; gap + 1 < std::ssize(problem.buildings); ++gap) {
    list.most("slow_starts", gap_name(problem, gap), slow_starts[gap], "", 0, 0);
  }
  for (const Discrepancy& found : response.discrepancies) {
    list.add({.key = found.key, .subject = {}, .value = found.size, .unit = {}, .usual_from = {}, .usual_to = 1e-9});
  }
  return list.take();
}

Proportions proportions(const Building& building, const Units& units, const BuildingPeaks* peaks) {
  Proportions result;
  if (building.is_rigid()) return result;
  for (const double mass : building.model.floor_masses) result.weight += mass * units.gravity;
  const auto storeys = static_cast<double>(building.model.floors() - building.model.first_storey());
  result.period_per_storey = 2 * std::numbers::pi / building.first_omega() / storeys;
  if (peaks != nullptr && result.weight > 0) result.base_shear_coefficient = peaks->storey_shear(0) / result.weight;
  return result;
}

}  // namespace bentur
