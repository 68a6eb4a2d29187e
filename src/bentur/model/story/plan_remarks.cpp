#include <algorithm>

#include "bentur/model/plan/plan_run.h"
#include "bentur/model/story/internal/remark_checks.h"

namespace bentur {
namespace {

using Eigen::Index;
using namespace remarking;

void check_buildings(const Case& c, const PlanProblem& problem, List& list) {
  for (std::size_t b = 0; b < problem.buildings.size(); ++b) {
    const PlanBuilding& building = problem.buildings[b];
    if (building.is_rigid()) continue;
    const PlanModel& model = building.model;
    const Eigen::Vector2d size = model.footprint.size;
    BuildingLook look{.name = building.name,
                      .omega = building.modes.omega(0),
                      .damping_rate = building.modal_damping(0, 0),
                      .on_bearings = model.slab.has_value(),
                      .storeys = static_cast<std::size_t>(model.floors() - model.first_storey()),
                      .heights = model.storey_heights,
                      .masses = model.floor_masses,
                      .width = size.minCoeff()};
    if (b < c.buildings.size() && !c.buildings[b].is_rigid()) {
      for (const PlanPlane& plane : std::get<Plan>(c.buildings[b].structure).planes) {
        if (plane.frame) look.frames.push_back(plane.frame.get());
      }
    }
    check_building(look, c.units, list);
  }
}

/// How far contacts of all gaps overlap at the start [length].
std::vector<double> overlaps(const PlanProblem& problem) {
  const std::vector<Index> places = places_of(problem);
  std::vector<double> found(places.size(), 0.0);
  if (problem.initial_displacement.empty()) return found;
  const System system = system_of(problem);
  const auto of = [&](const BodyRow& row) { return row.row.dot(problem.initial_displacement[row.body]); };
  std::size_t n = 0;
  for (const Contact& one : system.contacts) found[places[n++]] = of(one.at.left) + of(one.at.right) - one.width;
  for (const RubbingContact& one : system.rubbing) found[places[n++]] = of(one.at.left) + of(one.at.right) - one.width;
  return found;
}

/// Level after level of a gap, with all contacts of its joint together. @param overlaps of the gap's contacts
void check_levels(const Case& c, const PlanProblem& problem, std::size_t g, const double* overlaps, List& list) {
  const PlanGap& gap = problem.gaps[g];
  const std::string name = gap_name(problem, gap);
  for (std::size_t i = 0; i < gap.contacts.size();) {
    const PlanContact& first = gap.contacts[i];
    if (!first.is_of_joint()) break;
    const PlanModel &left = problem.buildings[gap.left].model, &right = problem.buildings[gap.right].model;
    const double above = left.elevations[first.left_floor] - right.elevations[first.right_floor];
    LevelLook look{.gap = name, .width = gap.stretch.width, .apart = std::abs(above)};
    look.beam_depth = above > 0 ? beam_depth(c, gap.left, first.left_floor - left.first_storey())
                                : beam_depth(c, gap.right, first.right_floor - right.first_storey());
    for (; i < gap.contacts.size() && gap.contacts[i].elevation == first.elevation; ++i) {
      const auto stiffness = stiffness_of(c.gaps[g].contact.law, gap.contacts[i].law->parameters());
      if (stiffness) look.stiffness = look.stiffness.value_or(0) + *stiffness;
      look.overlap = std::max(look.overlap, overlaps[i]);
    }
    for (const auto& [b, floor] : {std::pair(gap.left, first.left_floor), std::pair(gap.right, first.right_floor)}) {
      const PlanBuilding& building = problem.buildings[b];
      if (!building.is_rigid()) look.take(building.model.floor_masses[floor], building.modes.omega(0));
    }
    check_level(look, c.units, list);
  }
}

/// Corners of a joint that bear no share, being too near to others.
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

void check_before(const Case& c, const PlanProblem& problem, List& list) {
  check_buildings(c, problem, list);
  const std::vector<double> overlap = overlaps(problem);
  const double* of_gap = overlap.data();
  for (std::size_t g = 0; g < problem.gaps.size() && g < c.gaps.size(); ++g) {
    check_levels(c, problem, g, of_gap, list);
    list.most("merged_corners", gap_name(problem, problem.gaps[g]), merged_corners(problem.gaps[g]), "", 0, 0);
    of_gap += problem.gaps[g].contacts.size();
  }
  const bool both = std::none_of(problem.motions.begin(), problem.motions.end(),
                                 [](const GroundMotion& motion) { return std::holds_alternative<NoMotion>(motion); });
  constexpr const char* axes[] = {"x", "y"};
  for (const std::size_t i : {0U, 1U}) {
    const char* const subject = both ? axes[i] : "";
    const ExcitationSpec& excitation = *c.excitations()[i];
    if (excitation.record) check_record(*excitation.record, subject, list);
    check_motion(problem.motions[i], excitation, subject, problem.duration, c.units, list);
  }
  std::vector<std::string> names;
  std::vector<double> omegas;
  for (const PlanBuilding& building : problem.buildings) {
    names.push_back(building.name);
    omegas.push_back(building.is_rigid() ? 0 : building.modes.omega(0));
  }
  check_delays(names, problem.delays, problem.duration, list);
  check_codes(c.code, list);
  check_output(c.analysis.output_step, omegas, problem.duration, list);
}

ResponseLook look_of(const PlanBuilding& building, const PlanPeaks& with, const PlanPeaks& alone, double gravity) {
  ResponseLook look{.name = building.name, .drift = std::max(with.largest_drift().ratio, alone.largest_drift().ratio)};
  const Index storey = building.model.first_storey();
  double weight = 0, shear = 0;
  for (const double mass : building.model.floor_masses) weight += mass * gravity;
  for (const PlanPeaks* const peaks : {&with, &alone}) {
    for (const Eigen::VectorXd* const list : {&peaks->shear_x, &peaks->shear_y}) {
      if (storey < list->size()) shear = std::max(shear, (*list)(storey));
    }
    for (const PlanPeaks::Plane& plane : peaks->planes) {
      look.yields = look.yields || plane.yielding.ductility.size() > 0 || !plane.frame.hinges.empty();
    }
  }
  for (const PlanPeaks::Plane& plane : with.planes) {
    look.broken_columns += std::count_if(plane.frame.columns.begin(), plane.frame.columns.end(),
                                         [](const auto& column) { return column.break_time.has_value(); });
  }
  if (weight > 0) look.base_shear = shear / weight;
  return look;
}

}  // namespace

std::vector<Remark> remarks(const Case& c, const PlanProblem& problem) {
  List list(c.units);
  check_before(c, problem, list);
  return list.take();
}

std::vector<Remark> remarks(const Case& c, const PlanProblem& problem, const PlanResponse& response) {
  List list(c.units);
  check_before(c, problem, list);
  for (std::size_t b = 0; b < problem.buildings.size(); ++b) {
    const PlanBuilding& building = problem.buildings[b];
    if (building.is_rigid()) continue;
    check_response(look_of(building, response.buildings.at(b), response.buildings_no_contact.at(b), c.units.gravity),
                   list);
  }
  std::size_t point = 0;
  for (const PlanGap& gap : problem.gaps) {
    double deepest = 0;
    int slow_starts = 0;
    for (std::size_t i = 0; i < gap.contacts.size(); ++i, ++point) {
      deepest = std::max(deepest, response.points.at(point).peak_penetration);
      slow_starts += response.points.at(point).slow_starts;
    }
    check_impacts(gap_name(problem, gap), deepest, slow_starts, list);
  }
  check_discrepancies(response.discrepancies, list);
  return list.take();
}

}  // namespace bentur
