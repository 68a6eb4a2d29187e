#include "bentur/model/plan/plan_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <utility>

#include "bentur/contact/axial_stiffness.h"
#include "bentur/contact/laws/rubbing.h"
#include "bentur/core/algebra/factors.h"
#include "bentur/core/errors.h"
#include "bentur/model/plan/plan_row.h"
#include "bentur/model/plan/struck_in_plan.h"
#include "bentur/structure/plan/plan_masses.h"

namespace bentur {
namespace {

/// The axes along which motions act that are turned by an angle [degrees], as columns; right angles exactly.
Eigen::Matrix2d axes_at(double degrees) {
  const double quarters = degrees / 90;
  double c = std::cos(degrees * std::numbers::pi / 180), s = std::sin(degrees * std::numbers::pi / 180);
  if (quarters == std::round(quarters)) {
    c = std::round(c);
    s = std::round(s);
  }
  Eigen::Matrix2d axes;
  axes << c, -s, s, c;
  return axes;
}

double floor_mass(const BuildingSpec& spec, int floor) {
  const Plan* const plan = std::get_if<Plan>(&spec.structure);
  if (plan == nullptr) return std::numeric_limits<double>::infinity();
  const int slabs = plan->isolation ? 1 : 0;
  return floor < slabs ? plan->isolation->mass : plan->masses.at(static_cast<std::size_t>(floor - slabs));
}

/// Halves of the floor beams next to a joint (3-4), those of all frames that stand across it side by side
/// [force/length]. @param outward normal of the joint, away from the building
double beam_ends_stiffness(const BuildingSpec& spec, int floor, const PlanPoint& outward) {
  constexpr double parallel = 1e-9;
  const Plan* const plan = std::get_if<Plan>(&spec.structure);
  const int beams = floor - (plan != nullptr && plan->isolation ? 1 : 0);
  if (beams < 0)
    throw InvalidParameter("stiffness", "axial", "is of floor beams, of which a slab on bearings has none");
  double sum = 0;
  for (const PlanPlane& plane : plan != nullptr ? plan->planes : std::vector<PlanPlane>()) {
    const double along = plane.direction.dot(outward);
    if (plane.frame == nullptr || 1 - std::abs(along) > parallel) continue;
    const PlaneFrame& frame = *plane.frame;
    sum += half_beam_stiffness(frame.elastic_modulus, frame.beams.at(static_cast<std::size_t>(beams)).area,
                               along > 0 ? frame.bay_widths.back() : frame.bay_widths.front());
  }
  if (sum > 0) return sum;
  throw InvalidParameter("stiffness", "axial", "needs frames across the joint, but \"" + spec.name + "\" has none");
}

/// What a point of a level gives its law. @param axial the whole stiffness of floor beams, where that is asked for
LawInput input_of(const ContactSpec& contact, std::size_t level, double m_e, double share,
                  const std::optional<double>& axial) {
  LawInput input = contact_input(contact, level, m_e, share);
  if (axial) input.numbers["stiffness"] = share * *axial;
  return input;
}

/// How far two buildings may move by one another, of the height of a floor: what a joint's ends are looked at for.
constexpr double moves_of_height = 0.05;

/// The law of a point with the friction that the contact has at a level; null where it has none.
std::shared_ptr<const Rubbing> rubbing_of(const ContactSpec& contact, std::size_t level, double share,
                                          const std::shared_ptr<const ContactLaw>& law) {
  constexpr double mindlin = 8.0 / 9.0;  // 2 (1 − ν)/(2 − ν), ν = 0.2
  const double friction = contact.number("friction", level).value_or(0);
  if (friction == 0) return nullptr;
  const std::optional<double> given = contact.number("tangential_stiffness", level);
  const double across = law->branch(law->next({}, 0, 0.0, 0.0, 1.0)).stiffness;  // of what has just touched
  return std::make_shared<const Rubbing>(law, friction, given ? share * *given : mindlin * across);
}

/// The contacts of a level at which a floor strikes columns: at each of them, all with the same share.
void strike_columns(const GapSpec& gap, std::size_t level, const BuildingSpec& left, const BuildingSpec& right,
                    std::vector<PlanContact>& contacts) {
  const LevelPair& floors = gap.levels[level];
  const int side = floors.struck.value();
  const BuildingSpec& building = side == 0 ? left : right;
  const std::vector<StruckInPlan> columns = struck_columns(building, gap.stretch, side, floors.elevation);
  if (columns.empty()) {
    throw InvalidParameter("elevations", fmt::format("{}", floors.elevation),
                           "must be where \"" + building.name + "\" has columns with nodes at the joint");
  }
  if (gap.contact.axial) {
    throw InvalidParameter("stiffness", "axial", "is of floor beams: where a column is struck a number is needed");
  }
  const double share = 1.0 / static_cast<double>(columns.size());
  double mass = 0;
  for (const StruckInPlan& column : columns) mass += column.mass;
  const double m_e =
      effective_mass(side == 0 ? floor_mass(right, floors.right_floor) : floor_mass(left, floors.left_floor), mass);
  for (const StruckInPlan& column : columns) {
    const auto law = make_contact_law(gap.contact, input_of(gap.contact, level, m_e, share, {}));
    PlanContact& contact = contacts.emplace_back();
    contact.left_floor = floors.left_floor;
    contact.right_floor = floors.right_floor;
    (side == 0 ? contact.left_floor : contact.right_floor) = column.floor_or_node;
    contact.elevation = floors.elevation;
    contact.along = column.along;
    contact.law = law;
    contact.rubbing = rubbing_of(gap.contact, level, share, law);
    contact.column_shear_capacity =
        column_shear_capacity(gap, level, column.shear_capacity, column.storey, building.name);
    if (gap.column_capacity && !gap.column_capacity->moment.empty()) {
      contact.column_moment_capacity = gap.column_capacity->moment.at(level);
    }
  }
}

/// Foundations are at rest at first. Nodes in columns are where nothing pushes them.
std::vector<Eigen::VectorXd> initial_vectors(const std::vector<std::vector<double>>& given,
                                             const std::vector<PlanBuilding>& buildings) {
  std::vector<Eigen::VectorXd> vectors;
  for (std::size_t b = 0; b < given.size(); ++b) {
    const PlanModel& model = buildings.at(b).model;
    const Eigen::Index floors = std::ssize(given[b]), nodes = std::ssize(model.nodes);
    Eigen::VectorXd& all = vectors.emplace_back(Eigen::VectorXd::Zero(floors + nodes + model.foundation_dofs()));
    all.head(floors) = Eigen::Map<const Eigen::VectorXd>(given[b].data(), floors);
    if (nodes == 0) continue;
    all.segment(floors, nodes) = -Ldlt(model.stiffness.block(floors, floors, nodes, nodes))
                                      .solve(model.stiffness.block(floors, 0, nodes, floors) * all.head(floors));
  }
  return vectors;
}

/// Of each building those with its masses elsewhere; empty where none has any.
std::vector<std::vector<PlanBuilding>> buildings_elsewhere(const std::vector<BuildingSpec>& specs) {
  std::vector<std::vector<PlanBuilding>> all(specs.size());
  bool has_any = false;
  for (std::size_t b = 0; b < specs.size(); ++b) {
    const Plan* const plan = std::get_if<Plan>(&specs[b].structure);
    if (plan == nullptr) continue;
    BuildingSpec moved = specs[b];
    for (Plan& one : with_masses_elsewhere(*plan)) {
      moved.structure = std::move(one);
      all[b].push_back(make_plan_building(moved));
      has_any = true;
    }
  }
  return has_any ? all : std::vector<std::vector<PlanBuilding>>();
}

}  // namespace

PlanBuilding make_plan_building(const BuildingSpec& spec) {
  if (const Plan* const plan = std::get_if<Plan>(&spec.structure)) {
    return make_plan_building(spec.name, plan_model(*plan, spec.base_elevation), spec.damping, spec.tangent_damping,
                              plan->soil, plan->isolation);
  }
  std::vector<double> elevations = std::get<PlanWall>(spec.structure).elevations;
  for (double& elevation : elevations) elevation += spec.base_elevation;
  return rigid_plan_building(spec.name, spec.footprint(), elevations);
}

PlanGap gap_with_contacts(const GapSpec& gap, const BuildingSpec& left, const BuildingSpec& right) {
  PlanGap made{.left = gap.left, .right = gap.right, .stretch = gap.stretch};
  std::vector<PlanContact> others;
  for (std::size_t level = 0; level < gap.levels.size(); ++level) {
    const LevelPair& floors = gap.levels[level];
    if (floors.struck) {
      strike_columns(gap, level, left, right, made.contacts);
      continue;
    }
    const double m_e = effective_mass(floor_mass(left, floors.left_floor), floor_mass(right, floors.right_floor));
    std::optional<double> axial;
    if (gap.contact.axial) {
      axial = series_stiffness(beam_ends_stiffness(left, floors.left_floor, gap.stretch.n),
                               beam_ends_stiffness(right, floors.right_floor, -gap.stretch.n));
    }
    const double height = floors.elevation - std::min(left.base_elevation, right.base_elevation);
    for (StretchPoint& point : points_between(left.footprint(), right.footprint(), gap.stretch, gap.points,
                                              moves_of_height * height, gap.contact.number("spread", 0))) {
      if (point.seam) {
        made.seams.push_back({.left_floor = floors.left_floor,
                              .right_floor = floors.right_floor,
                              .elevation = floors.elevation,
                              .family = point.family,
                              .pair = point.pair,
                              .at = point.beside ? *point.beside : gap.stretch.at(point.along)});
        continue;
      }
      const auto law = make_contact_law(gap.contact, input_of(gap.contact, level, m_e, point.share, axial));
      (point.beside ? others : made.contacts)
          .push_back({.left_floor = floors.left_floor,
                      .right_floor = floors.right_floor,
                      .elevation = floors.elevation,
                      .along = point.along,
                      .law = law,
                      .rubbing = rubbing_of(gap.contact, level, point.share, law),
                      .family = point.family,
                      .beside = std::move(point.beside),
                      .pair = point.pair});
    }
  }
  made.contacts.insert(made.contacts.end(), std::make_move_iterator(others.begin()),
                       std::make_move_iterator(others.end()));
  return made;
}

FloorLevels levels_of(const PlanModel& model) {
  return {model.elevations, model.elevations.front() - model.storey_heights.front()};
}

/// As PlanGap::is_of_pair() of contacts, of the points of one level. @param width of the joint [length]
bool says_need(const std::vector<StretchPoint>& points, const StretchPoint& point, double width) {
  if (point.seam || point.family <= 0) return !point.seam;
  return width + point.beside->beyond >= 0 && std::none_of(points.begin(), points.end(), [&](const StretchPoint& one) {
           return !one.seam && one.family <= 0 && one.pair == point.pair;
         });
}

std::vector<PlanWatched> watched_floors(const GapSpec& gap, const std::vector<PlanBuilding>& buildings) {
  const auto touches = [&](int side, int floor) {
    return std::any_of(gap.levels.begin(), gap.levels.end(), [&](const LevelPair& level) {
      return level.struck != side && (side == 0 ? level.left_floor : level.right_floor) == floor;
    });
  };
  std::vector<PlanWatched> watched;
  const PlanBuilding &left = buildings.at(gap.left), &right = buildings.at(gap.right);
  const bool are_convex = left.model.footprint.is_convex() && right.model.footprint.is_convex();
  for (const FacingFloor& found :
       facing_floors(levels_of(left.model), levels_of(right.model), gap.level_tolerance, touches)) {
    PlanWatched one{.floor_of = found.side == 0 ? gap.left : gap.right,
                    .floor = found.floor,
                    .facing_floor = found.facing,
                    .elevation = found.elevation};
    for (const double end : gap.stretch.is_corner() ? std::vector<double>() : gap.stretch.corners_along()) {
      one.along = end;
      watched.push_back(one);
    }
    if (are_convex) continue;  // of which there is one pair of parts
    const double height = found.elevation - std::min(levels_of(left.model).base, levels_of(right.model).base);
    const std::vector<StretchPoint> points =
        points_between(left.model.footprint, right.model.footprint, gap.stretch, 2, moves_of_height * height);
    for (const StretchPoint& point : points) {
      if (point.pair == 0 || !says_need(points, point, gap.stretch.width)) continue;
      one.along = point.along;
      one.beside = point.beside;
      watched.push_back(one);
    }
  }
  return watched;
}

std::vector<PlanLink> links_of(const std::vector<LinkSpec>& specs, const std::vector<PlanBuilding>& buildings) {
  std::vector<PlanLink> links;
  for (const LinkSpec& spec : specs) {
    const PlanBuilding &left = buildings.at(spec.left), &right = buildings.at(spec.right);
    for (Link& link : links_of(spec, levels_of(left.model), levels_of(right.model), {left.name, right.name})) {
      links.push_back({std::move(link), spec.stretch, spec.at, spec.direction});
    }
  }
  return links;
}

std::string link_name(const PlanProblem& problem, const PlanLink& link) {
  return problem.buildings.at(link.link.left).name + " – " + problem.buildings.at(link.link.right).name;
}

std::string direction_text(const PlanPoint& along) {
  constexpr double near = 1e-9;
  for (const auto& [axis, name] : {std::pair(PlanPoint(PlanPoint::UnitX()), "x"), {PlanPoint::UnitY(), "y"}}) {
    if ((along - axis).norm() < near || (along + axis).norm() < near) return name;
  }
  return fmt::format("({:.4g}, {:.4g})", along.x(), along.y());
}

std::string link_along(const PlanLink& link) { return direction_text(link.direction); }

PlanProblem make_plan_problem(const Case& c) {
  std::vector<PlanBuilding> buildings;
  for (const BuildingSpec& spec : c.buildings) buildings.push_back(make_plan_building(spec));
  return make_plan_problem(c, std::move(buildings));
}

PlanProblem make_plan_problem(const Case& c, std::vector<PlanBuilding> buildings) {
  PlanProblem problem;
  problem.buildings = std::move(buildings);
  for (const GapSpec& gap : c.gaps) {
    problem.gaps.push_back(gap_with_contacts(gap, c.buildings.at(gap.left), c.buildings.at(gap.right)));
    problem.gaps.back().watched = watched_floors(gap, problem.buildings);
  }
  problem.links = links_of(c.links, problem.buildings);
  problem.elsewhere = buildings_elsewhere(c.buildings);
  problem.initial_displacement = initial_vectors(c.initial.displacements, problem.buildings);
  problem.initial_velocity = initial_vectors(c.initial.velocities, problem.buildings);
  problem.collapse_drift = c.analysis.collapse_drift;
  take_motion(c, problem);
  return problem;
}

void take_motion(const Case& c, PlanProblem& problem) {
  problem.motions = {c.excitation.motion, c.excitation_y.motion};
  problem.axes = axes_at(c.angle);
  problem.delays = c.excitation.delays;
  problem.kinematics = c.excitation.kinematics;
  problem.duration = c.analysis.duration;
  problem.goes_on = c.analysis.goes_on;
  validate(problem);
}

PlanRun run_results(Case c, PlanProblem problem, PlanResponse response) {
  if (response.duration > 0) problem.duration = response.duration;
  problem.goes_on = false;
  std::vector<Remark> found = remarks(c, problem, &response);
  PlanRun run{std::move(c), std::move(problem), std::move(response), std::move(found)};
  run.row = row_of(run);
  return run;
}

double applied_pga(const PlanRun& run, std::size_t component) {
  const std::optional<RecordEcho>& record = run.c.excitations().at(component)->record;
  return record ? record->pga : peak_acceleration(run.problem.motions.at(component));
}

}  // namespace bentur
