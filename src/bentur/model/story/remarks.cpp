#include "bentur/model/story/remarks.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "bentur/model/story/internal/remark_checks.h"
#include "bentur/model/suite/suite.h"

namespace bentur {
namespace {

using namespace remarking;

void check_buildings(const Case& c, const Problem& problem, List& list) {
  for (std::size_t b = 0; b < problem.buildings.size(); ++b) {
    const Building& building = problem.buildings[b];
    if (building.is_rigid()) continue;
    const bool given = b < c.buildings.size();  // not of results read back
    const StructuralModel& model = building.model;
    static const std::vector<double> unknown;
    BuildingLook look{.name = building.name,
                      .omega = building.first_omega(),
                      .damping_rate = building.modal_damping(0, 0),
                      .on_bearings = model.slab.has_value(),
                      .storeys = static_cast<std::size_t>(model.floors() - model.first_storey()),
                      .heights = given ? model.storey_heights : unknown,
                      .masses = model.floor_masses,
                      .width = given ? c.buildings[b].width.value_or(0) : 0,
                      .stiffness_factor = model.stiffness_factor};
    if (const auto* frame = given ? std::get_if<PlaneFrame>(&c.buildings[b].structure) : nullptr) {
      look.frames = {frame};
    }
    check_building(look, c.units, list);
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

/// Floors that can be struck, of buildings that move in few modes.
void check_modes(const Case& c, const Problem& problem, List& list) {
  for (const ContactPoint& point : problem.points) {
    for (const auto& [b, floor] :
         {std::pair(point.left, point.left_floor), std::pair(point.right, point.right_floor)}) {
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

void check_levels(const Case& c, const Problem& problem, List& list) {
  for (const ContactPoint& point : problem.points) {
    const Eigen::Index left = point.left, right = point.right;
    const std::string name = gap_name(problem, left);
    const StructuralModel &of_left = problem.buildings[left].model, &of_right = problem.buildings[right].model;
    LevelLook look{.gap = name,
                   .width = point.width,
                   .overlap = first_floor_value(problem.initial_displacement, left, point.left_floor) -
                              first_floor_value(problem.initial_displacement, right, point.right_floor) - point.width,
                   .stiffness = stiffness_of(c.gaps.at(left).contact.law, point.law->parameters())};
    if (point.left_floor < of_left.floors() && point.right_floor < of_right.floors()) {
      const double above = of_left.elevations[point.left_floor] - of_right.elevations[point.right_floor];
      look.apart = std::abs(above);
      look.beam_depth = above > 0 ? beam_depth(c, left, point.left_floor - of_left.first_storey())
                                  : beam_depth(c, right, point.right_floor - of_right.first_storey());
    }
    for (const auto& [b, at] : {std::pair(left, point.left_floor), std::pair(right, point.right_floor)}) {
      const StructuralModel& model = problem.buildings[b].model;
      const Eigen::Index floors = model.floors();
      look.take(at < floors ? model.floor_masses[at] : model.node_masses[at - floors],
                problem.buildings[b].first_omega());
    }
    check_level(look, c.units, list);
  }
}

void check_records(const Case& c, List& list) {
  if (c.excitation.record) check_record(*c.excitation.record, "", list);
  if (!c.excitation.suite) return;
  for (const SuiteRecord& record : c.excitation.suite->records) check_record(record.echo, record.echo.file, list);
}

void check_before(const Case& c, const Problem& problem, List& list) {
  check_buildings(c, problem, list);
  check_modes(c, problem, list);
  check_blows(problem, list);
  check_levels(c, problem, list);
  check_records(c, list);
  check_motion(problem.motion, c.excitation, "", problem.duration, c.units, list);
  std::vector<std::string> names;
  std::vector<double> omegas;
  for (const Building& building : problem.buildings) {
    names.push_back(building.name);
    omegas.push_back(building.first_omega());
  }
  check_delays(names, problem.delays, problem.duration, list);
  if (!c.excitation.spectrum) check_codes(c.code, list);
  check_output(c.analysis.output_step, omegas, problem.duration, list);
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
    list.add({"motion_of_zeros", "", 0, "g", pga_range.usual_from, pga_range.usual_to, true});
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
    Proportions found = proportions(building, c.units, &peaks);
    if (const Eigen::VectorXd& free = peaks.storey_shear_no_contact; found.base_shear_coefficient && free.size() > 0) {
      found.base_shear_coefficient = std::max(*found.base_shear_coefficient, free(0) / found.weight);
    }
    const auto broken = std::count_if(peaks.columns.begin(), peaks.columns.end(),
                                      [](const BuildingPeaks::Breaking& column) { return column.break_time; });
    check_response(
        {.name = building.name,
         .drift = std::max(largest_drift(peaks.drift_ratio).ratio, largest_drift(peaks.drift_ratio_no_contact).ratio),
         .base_shear = found.base_shear_coefficient,
         .yields = building.storeys_yield() || !building.model.hinges.places.empty(),
         .broken_columns = broken},
        list);
  }
  for (Eigen::Index gap = 0; gap < gap_count(problem); ++gap) {
    double deepest = 0;
    int slow_starts = 0;
    for (const Eigen::Index i : gap_at(problem, gap).points) {
      deepest = std::max(deepest, response.points.at(i).peak_penetration);
      slow_starts += response.points.at(i).slow_starts;
    }
    check_impacts(gap_name(problem, gap), deepest, slow_starts, list);
  }
  check_discrepancies(response.discrepancies, list);
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

const std::vector<std::string_view>& remark_keys() {
  static const std::vector<std::string_view> keys = {"period_per_storey",
                                                     "stiffness_factor",
                                                     "storey_weight",
                                                     "storey_weight_per_width",
                                                     "impact_damping",
                                                     "damping",
                                                     "storey_height",
                                                     "elastic_modulus",
                                                     "density",
                                                     "section",
                                                     "line_load",
                                                     "gap_width",
                                                     "level_tolerance",
                                                     "soft_contact",
                                                     "code_on_record",
                                                     "broken_columns",
                                                     "initial_overlap",
                                                     "contact_stiffness",
                                                     "record_step",
                                                     "record_length",
                                                     "motion_of_zeros",
                                                     "pga",
                                                     "pga_without_unit",
                                                     "delay",
                                                     "duration",
                                                     "output_step",
                                                     "modal_mass",
                                                     "drift",
                                                     "base_shear",
                                                     "penetration",
                                                     "check_first_contact",
                                                     "check_without_impact",
                                                     "check_momentum",
                                                     "check_opening",
                                                     "check_peaks",
                                                     "check_forces",
                                                     "check_energy",
                                                     "slow_starts",
                                                     "merged_corners"};
  return keys;
}

std::uint64_t remark_kinds(const std::vector<Remark>& remarks) {
  std::uint64_t kinds = 0;
  for (const Remark& one : remarks) {
    const auto& keys = remark_keys();
    const auto found = std::find(keys.begin(), keys.end(), one.key);
    if (found != keys.end()) kinds |= std::uint64_t{1} << static_cast<unsigned>(found - keys.begin());
  }
  return kinds;
}

long count_of_doubts(const std::vector<Remark>& remarks) {
  return std::count_if(remarks.begin(), remarks.end(), [](const Remark& one) { return one.is_doubt; });
}

}  // namespace bentur
