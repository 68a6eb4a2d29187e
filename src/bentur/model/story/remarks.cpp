#include "bentur/model/story/remarks.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <utility>

#include "bentur/model/plan/plan_places.h"
#include "bentur/model/plan/plan_row.h"
#include "bentur/model/story/internal/remark_checks.h"
#include "bentur/model/suite/suite.h"

// What is unusual of a case and a run of it, of a row as in plan: what only one of both has stands in a function of its
// own for each.
namespace bentur {
namespace {

using Eigen::Index;
using namespace remarking;

double first_omega(const Building& building) { return building.first_omega(); }
double first_omega(const PlanBuilding& building) { return building.is_rigid() ? 0 : building.modes.omega(0); }

template <class AnyProblem>
void check_buildings(const Case& c, const AnyProblem& problem, List& list) {
  for (std::size_t b = 0; b < problem.buildings.size(); ++b) {
    const auto& building = problem.buildings[b];
    if (building.is_rigid()) continue;
    const auto& model = building.model;
    static const std::vector<double> unknown;
    const bool is_given = b < c.buildings.size();  // not of results read back
    BuildingLook look{.name = building.name,
                      .omega = first_omega(building),
                      .damping_rate = building.modal_damping(0, 0),
                      .on_bearings = model.slab.has_value(),
                      .storeys = static_cast<std::size_t>(model.floors() - model.first_storey()),
                      .heights = is_given ? model.storey_heights : unknown,
                      .masses = model.floor_masses,
                      .width = is_given ? width_of(c.buildings[b]) : 0};
    if constexpr (requires { model.stiffness_factor; }) look.stiffness_factor = model.stiffness_factor;
    if (is_given) look.frames = frames_in(c.buildings[b]);
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

/// How far each contact point of a joint overlaps at the start [length]; empty where no building starts displaced.
std::vector<double> overlaps(const Problem& problem) {
  std::vector<double> found;
  const auto& start = problem.initial_displacement;
  if (start.empty()) return found;
  for (const ContactPoint& point : problem.points) {
    found.push_back(start[point.left](point.left_floor) - start[point.right](point.right_floor) - point.width);
  }
  return found;
}

std::vector<double> overlaps(const PlanProblem& problem) {
  std::vector<double> found;
  if (problem.initial_displacement.empty()) return found;
  const System system = system_of(problem);
  const std::vector<const Interface*> contacts = contact_interfaces(problem, system);
  const auto of = [&](const BodyRow& row) { return row.row.dot(problem.initial_displacement[row.body]); };
  std::size_t i = 0;
  for (const PlanGap& gap : problem.gaps) {
    for (const PlanContact& one : gap.contacts) {
      const Interface& at = *contacts[i++];
      if (one.is_of_joint()) found.push_back(of(at.left) + of(at.right) - gap.width_at(one));
    }
  }
  return found;
}

/// Level after level of every gap, with all contacts of its joint together. @param row the problem, of buildings in
/// plan row_of() it @param overlaps overlaps()
void check_levels(const Case& c, const Problem& row, const std::vector<double>& overlaps, List& list) {
  for (std::size_t i = 0; i < row.points.size();) {
    const ContactPoint& first = row.points[i];
    const std::string name = gap_name(row, first.gap);
    const StructuralModel &left = row.buildings[first.left].model, &right = row.buildings[first.right].model;
    LevelLook look{.gap = name, .width = first.width - first.beyond};
    if (first.left_floor < left.floors() && first.right_floor < right.floors()) {
      const double above = left.elevations[first.left_floor] - right.elevations[first.right_floor];
      look.apart = std::abs(above);
      look.beam_depth = above > 0 ? beam_depth(c, first.left, first.left_floor - left.first_storey())
                                  : beam_depth(c, first.right, first.right_floor - right.first_storey());
    }
    for (; i < row.points.size() && row.points[i].gap == first.gap && row.points[i].elevation == first.elevation; ++i) {
      const auto gap = static_cast<std::size_t>(first.gap);
      const std::string law = gap < c.gaps.size() ? c.gaps[gap].contact.law : "";
      const auto stiffness = stiffness_of(law, row.points[i].law->parameters());
      if (stiffness) look.stiffness = look.stiffness.value_or(0) + *stiffness;
      if (!overlaps.empty()) look.overlap = std::max(look.overlap, overlaps[i]);
    }
    for (const auto& [b, at] : {std::pair(first.left, first.left_floor), std::pair(first.right, first.right_floor)}) {
      const StructuralModel& model = row.buildings[b].model;
      const Index floors = model.floors();
      look.take(at < floors ? model.floor_masses[at] : model.node_masses[at - floors], row.buildings[b].first_omega());
    }
    check_level(look, c.units, list);
  }
}

/// Corners of a joint that carry no share, being too near to others.
double merged_corners(const PlanGap& gap) {
  if (gap.contacts.empty()) return 0;
  const auto is_place = [&](const StretchCorner& corner) {
    return std::any_of(gap.contacts.begin(), gap.contacts.end(), [&](const PlanContact& one) {
      return one.is_of_joint() && one.elevation == gap.contacts.front().elevation && one.along == corner.along;
    });
  };
  return static_cast<double>(
      std::count_if(gap.stretch.corners.begin(), gap.stretch.corners.end(),
                    [&](const StretchCorner& corner) { return gap.stretch.includes(corner) && !is_place(corner); }));
}

void check_gaps(const Case& c, const Problem& problem, List& list) {
  check_modes(c, problem, list);
  check_blows(problem, list);
  check_levels(c, problem, overlaps(problem), list);
}

void check_gaps(const Case& c, const PlanProblem& problem, List& list) {
  check_levels(c, row_of(problem), overlaps(problem), list);
  for (const PlanGap& gap : problem.gaps) {
    const auto is_convex = [&](Index b) { return problem.buildings[b].model.footprint.is_convex(); };
    if (!is_convex(gap.left) || !is_convex(gap.right)) continue;  // of which other corners are other pairs' of parts
    list.most("merged_corners", gap_name(problem, gap), merged_corners(gap), "", 0, 0);
  }
}

std::vector<const GroundMotion*> motions_of(const Problem& problem) { return {&problem.motion}; }
std::vector<const GroundMotion*> motions_of(const PlanProblem& problem) {
  return {&problem.motions[0], &problem.motions[1]};
}

template <class AnyProblem>
void check_motions(const Case& c, const AnyProblem& problem, List& list) {
  const std::vector<const GroundMotion*> motions = motions_of(problem);
  const auto moving = std::count_if(motions.begin(), motions.end(), [](const GroundMotion* motion) {
    return !std::holds_alternative<NoMotion>(*motion);
  });
  constexpr const char* axes[] = {"x", "y"};
  for (std::size_t i = 0; i < motions.size(); ++i) {
    const char* const subject = moving > 1 ? axes[i] : "";
    const ExcitationSpec& excitation = *c.excitations()[i];
    if (excitation.record) check_record(*excitation.record, subject, list);
    check_motion(*motions[i], excitation, subject, problem.duration, c.units, list);
  }
  if (!c.excitation.suite) return;
  for (const SuiteRecord& record : c.excitation.suite->records) {
    check_record(record.echo, record.echo.file, list);
    if (record.along_y) check_record(record.along_y->echo, record.along_y->echo.file, list);
  }
}

template <class AnyProblem>
void check_before(const Case& c, const AnyProblem& problem, List& list) {
  check_buildings(c, problem, list);
  check_gaps(c, problem, list);
  check_motions(c, problem, list);
  std::vector<std::string> names;
  std::vector<double> omegas;
  for (const auto& building : problem.buildings) {
    names.push_back(building.name);
    omegas.push_back(first_omega(building));
  }
  check_delays(names, problem.delays, problem.duration, list);
  if (!c.excitation.spectrum) check_codes(c.code, list);
  check_output(c.analysis.output_step, omegas, problem.duration, list);
}

double over_weight(double shear, const std::vector<double>& masses, double gravity) {
  const double weight = gravity * std::accumulate(masses.begin(), masses.end(), 0.0);
  return weight > 0 ? shear / weight : 0;
}

long broken_of(const BuildingPeaks& peaks) {
  return std::count_if(peaks.columns.begin(), peaks.columns.end(),
                       [](const BuildingPeaks::Breaking& column) { return column.break_time; });
}

/// The largest shear of the lowest storey, with contact and without, and the largest drift; what yields and what broke.
ResponseLook look_of(const Building& building, const Response& response, std::size_t b, double gravity) {
  const BuildingPeaks& peaks = response.buildings.at(b);
  const Eigen::VectorXd& alone = peaks.storey_shear_no_contact;
  const double shear = std::max(peaks.storey_shear(0), alone.size() > 0 ? alone(0) : 0.0);
  return {.name = building.name,
          .drift = std::max(largest_drift(peaks.drift_ratio).ratio, largest_drift(peaks.drift_ratio_no_contact).ratio),
          .base_shear = over_weight(shear, building.model.floor_masses, gravity),
          .yields = building.storeys_yield() || !building.model.hinges.places.empty(),
          .broken_columns = broken_of(peaks)};
}

ResponseLook look_of(const PlanBuilding& building, const PlanResponse& response, std::size_t b, double gravity) {
  const PlanPeaks &with = response.buildings.at(b), &alone = response.buildings_no_contact.at(b);
  ResponseLook look{.name = building.name, .drift = std::max(with.largest_drift().ratio, alone.largest_drift().ratio)};
  const Index storey = building.model.first_storey();
  double shear = 0;
  for (const PlanPeaks* const peaks : {&with, &alone}) {
    for (const Eigen::VectorXd* const list : {&peaks->shear_x, &peaks->shear_y}) {
      if (storey < list->size()) shear = std::max(shear, (*list)(storey));
    }
    for (const PlanPeaks::Plane& plane : peaks->planes) {
      look.yields = look.yields || plane.yielding.ductility.size() > 0 || !plane.frame.hinges.empty();
    }
  }
  for (const PlanPeaks::Plane& plane : with.planes) look.broken_columns += broken_of(plane.frame);
  look.base_shear = over_weight(shear, building.model.floor_masses, gravity);
  return look;
}

/// Of each contact its gap.
std::vector<Index> gaps_of_contacts(const Problem& problem) {
  std::vector<Index> gaps;
  for (const ContactPoint& point : problem.points) gaps.push_back(point.gap);
  return gaps;
}
std::vector<Index> gaps_of_contacts(const PlanProblem& problem) {
  std::vector<Index> gaps;
  for (const PlanGap& gap : problem.gaps) gaps.insert(gaps.end(), gap.contacts.size(), &gap - problem.gaps.data());
  return gaps;
}

template <class AnyProblem, class AnyResponse>
std::vector<Remark> remarks_of(const Case& c, const AnyProblem& problem, const AnyResponse& response) {
  List list(c.units);
  check_before(c, problem, list);
  for (std::size_t b = 0; b < problem.buildings.size(); ++b) {
    if (!(first_omega(problem.buildings[b]) > 0)) continue;  // it moves with the ground, or freely
    check_response(look_of(problem.buildings[b], response, b, c.units.gravity), list);
  }
  const std::vector<std::string> names = gap_names(problem);
  const std::vector<Index> gaps = gaps_of_contacts(problem);
  std::vector<std::pair<double, int>> found(names.size(), {0, 0});
  for (std::size_t point = 0; point < response.points.size(); ++point) {
    auto& [deepest, slow_starts] = found[gaps[point]];
    deepest = std::max(deepest, response.points[point].peak_penetration);
    slow_starts += response.points[point].slow_starts;
  }
  for (std::size_t gap = 0; gap < names.size(); ++gap) {
    check_impacts(names[gap], found[gap].first, found[gap].second, list);
  }
  check_discrepancies(response.discrepancies, list);
  return list.take();
}

template <class AnyProblem>
std::vector<Remark> remarks_before(const Case& c, const AnyProblem& problem) {
  List list(c.units);
  check_before(c, problem, list);
  return list.take();
}

}  // namespace

std::vector<Remark> remarks(const Case& c, const Problem& problem) { return remarks_before(c, problem); }
std::vector<Remark> remarks(const Case& c, const PlanProblem& problem) { return remarks_before(c, problem); }

std::vector<Remark> remarks(const Case& c, const Problem& problem, const Response& response) {
  return remarks_of(c, problem, response);
}
std::vector<Remark> remarks(const Case& c, const PlanProblem& problem, const PlanResponse& response) {
  return remarks_of(c, problem, response);
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
