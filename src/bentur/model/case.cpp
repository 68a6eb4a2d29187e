#include "bentur/model/case.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>

#include "bentur/contact/axial_stiffness.h"
#include "bentur/contact/laws.h"
#include "bentur/core/algebra/factors.h"
#include "bentur/core/errors.h"
#include "bentur/model/suite/suite.h"
#include "bentur/structure/modes.h"
#include "bentur/structure/sway.h"

namespace bentur {
namespace {

StructuralModel matrices_model(const MatricesSpec& spec, double base_elevation) {
  const auto floors = static_cast<Eigen::Index>(spec.elevations.size());
  if (floors == 0 || spec.mass.rows() != floors || spec.mass.cols() != floors || spec.stiffness.rows() != floors ||
      spec.stiffness.cols() != floors) {
    throw InvalidParameter("matrices", std::to_string(floors) + " elevations",
                           "mass and stiffness must have one row and column per elevation");
  }
  StructuralModel model;
  double below = 0;
  for (const double elevation : spec.elevations) {
    if (!(elevation > below)) {
      throw InvalidParameter("elevations", std::to_string(elevation), "must ascend from above the base");
    }
    model.elevations.push_back(base_elevation + elevation);
    model.storey_heights.push_back(elevation - below);
    below = elevation;
  }
  model.mass = spec.mass;
  model.stiffness = spec.stiffness;
  model.load = spec.mass.rowwise().sum();
  model.floor_masses.assign(model.load.begin(), model.load.end());
  return model;
}

/// The node in the column of a building that faces the gap, at an elevation; nothing where there is none.
std::optional<int> node_at(double elevation, const SpecAndModel& building, bool left_of_gap) {
  const std::vector<ColumnNode>* const nodes = column_nodes(building.spec);
  constexpr double round_off = 1e-9;
  for (std::size_t n = 0; nodes != nullptr && n < nodes->size(); ++n) {
    const double at = building.spec.base_elevation + (*nodes)[n].elevation;
    const bool faces = (*nodes)[n].left != left_of_gap;
    if (faces && std::abs(at - elevation) <= round_off * (1 + std::abs(elevation))) {
      return static_cast<int>(building.model.floors()) + static_cast<int>(n);
    }
  }
  return std::nullopt;
}

int nearest_floor(double elevation, const StructuralModel& model) {
  const std::vector<double>& all = model.elevations;
  const auto nearer = [&](double a, double b) { return std::abs(a - elevation) < std::abs(b - elevation); };
  return static_cast<int>(std::min_element(all.begin(), all.end(), nearer) - all.begin());
}

/// Half of the beam next to the gap, (3-4): the rightmost bay of a left building, the leftmost bay of a right one.
double beam_end_stiffness(const BuildingSpec& spec, std::size_t floor, bool left_of_gap) {
  const auto* frame = std::get_if<PlaneFrame>(&spec.structure);
  if (frame == nullptr) {
    throw InvalidParameter("stiffness", "axial", "needs a frame; \"" + spec.name + "\" is none");
  }
  if (floor >= frame->beams.size()) {
    throw InvalidParameter("stiffness", "axial", "is of floor beams: where a column is struck a number is needed");
  }
  const double bay = left_of_gap ? frame->bay_widths.back() : frame->bay_widths.front();
  return half_beam_stiffness(frame->elastic_modulus, frame->beams.at(floor).area, bay);
}

/// Contact points of the gap to the right of building `gap`.
std::vector<ContactPoint> points_of(const Case& c, std::size_t gap, const std::vector<Building>& buildings) {
  const GapSpec& spec = c.gaps[gap];
  if (spec.widths.size() != std::max<std::size_t>(spec.elevations.size(), 1)) {
    throw InvalidParameter("widths", std::to_string(spec.widths.size()) + " values",
                           "must be one per contact point, or one where there are none");
  }
  const SpecAndModel left{c.buildings[gap], buildings[gap].model};
  const SpecAndModel right{c.buildings[gap + 1], buildings[gap + 1].model};
  const double round_off = round_off_of_levels(levels_of(left.model), levels_of(right.model));
  const std::vector<LevelPair> floors_of = floors_of_points(spec, left, right);
  std::vector<ContactPoint> points;
  for (std::size_t i = 0; i < spec.elevations.size(); ++i) {
    ContactPoint point;
    point.left = point.gap = static_cast<Eigen::Index>(gap);
    point.right = point.left + 1;
    const LevelPair& floors = floors_of[i];
    point.left_floor = floors.left_floor;
    point.right_floor = floors.right_floor;
    const bool at_level = std::abs(spec.elevations[i] - floors.elevation) <= round_off;
    if (spec.column_capacity) {
      const std::vector<double>& moments = spec.column_capacity->moment;
      if (!moments.empty()) point.column_moment_capacity = moments.at(i);
    }
    point.column_shear_capacity = column_shear_capacity(spec, i, left, right, floors);
    point.elevation = at_level ? spec.elevations[i] : floors.elevation;
    point.width = spec.widths[i];
    point.law = make_contact_law(spec, i, left, right, floors);
    points.push_back(point);
  }
  return points;
}

/// The watched floors of one gap, from the lowest up.
void watch_gap(const GapSpec& spec, int gap, const std::vector<Building>& buildings,
               const std::vector<ContactPoint>& points, std::vector<WatchedFloor>& all) {
  const auto left = static_cast<std::size_t>(gap);
  const StructuralModel* const models[] = {&buildings[left].model, &buildings[left + 1].model};
  const FloorLevels levels[] = {levels_of(*models[0]), levels_of(*models[1])};
  const auto touches = [&](int side, int floor) {
    return std::any_of(points.begin(), points.end(), [&](const ContactPoint& point) {
      return point.left == gap && (side == 0 ? point.left_floor : point.right_floor) == floor;
    });
  };
  for (const FacingFloor& found : facing_floors(levels[0], levels[1], spec.level_tolerance, touches)) {
    const auto row = [&](int side) -> Eigen::VectorXd {
      const StructuralModel& model = *models[side];
      const std::optional<int> floor = side == found.side ? std::optional(found.floor) : found.facing;
      if (floor) return Eigen::VectorXd::Unit(model.dofs(), *floor);
      const double elevation = std::clamp(found.elevation, levels[side].base, model.elevations.back());
      return sway_at(model, elevation, side == 0 ? Face::right : Face::left);
    };
    WatchedFloor watched;
    watched.left = watched.gap = gap;
    watched.right = gap + 1;
    watched.floor_of = gap + found.side;
    watched.floor = found.floor;
    watched.facing_floor = found.facing;
    watched.elevation = found.elevation;
    watched.left_row = row(0);
    watched.right_row = row(1);
    watched.width = watched_width(points, gap, watched.elevation).value_or(spec.widths.front());
    all.push_back(std::move(watched));
  }
}

/// All degrees of freedom from the floors' values; joint rotations θ = −K_ss⁻¹ K_sp x, free of moment. A foundation on
/// soil is where it was.
Eigen::VectorXd from_floors(const StructuralModel& model, const std::vector<double>& values) {
  const Eigen::Index floors = model.floors();
  const Eigen::Index rotations = model.dofs() - floors - (model.foundation ? 2 : 0);
  if (static_cast<Eigen::Index>(values.size()) != floors) {
    throw InvalidParameter("initial", std::to_string(values.size()) + " values", "must be one per floor");
  }
  Eigen::VectorXd all = Eigen::VectorXd::Zero(model.dofs());
  all.head(floors) = Eigen::Map<const Eigen::VectorXd>(values.data(), floors);
  if (rotations > 0) {
    all.segment(floors, rotations) =
        -Ldlt(model.stiffness.block(floors, floors, rotations, rotations))
             .solve(model.stiffness.block(floors, 0, rotations, floors) * all.head(floors));
  }
  return all;
}

std::vector<Eigen::VectorXd> initial_state(const std::vector<std::vector<double>>& given,
                                           const std::vector<Building>& buildings) {
  if (given.empty()) {
    return {};
  }
  if (given.size() != buildings.size()) {
    throw InvalidParameter("initial", std::to_string(given.size()) + " lists", "must be one per building");
  }
  std::vector<Eigen::VectorXd> state;
  for (std::size_t b = 0; b < buildings.size(); ++b) {
    state.push_back(given[b].empty() ? Eigen::VectorXd::Zero(buildings[b].model.dofs())
                                     : from_floors(buildings[b].model, given[b]));
  }
  return state;
}

}  // namespace

std::vector<LevelPair> floors_of_points(const GapSpec& gap, const SpecAndModel& left, const SpecAndModel& right) {
  const FloorLevels a = levels_of(left.model), b = levels_of(right.model);
  const std::vector<LevelPair> pairs = level_floors(a, b, gap.level_tolerance);
  std::vector<LevelPair> floors;
  for (const double elevation : gap.elevations) {
    if (const LevelPair* const found = pair_at(elevation, pairs, a, b)) {
      floors.push_back(*found);
    } else if (const auto left_node = node_at(elevation, left, true)) {
      floors.push_back({*left_node, nearest_floor(elevation, right.model), elevation});
    } else if (const auto right_node = node_at(elevation, right, false)) {
      floors.push_back({nearest_floor(elevation, left.model), *right_node, elevation});
    } else {
      throw InvalidParameter(
          "elevations", std::to_string(elevation),
          "\"" + left.spec.name + "\" and \"" + right.spec.name + "\" have no floors there that meet");
    }
  }
  return floors;
}

std::shared_ptr<const ContactLaw> make_contact_law(const GapSpec& gap, std::size_t point, const SpecAndModel& left,
                                                   const SpecAndModel& right, const LevelPair& floors) {
  const auto left_floor = static_cast<std::size_t>(floors.left_floor);
  const auto right_floor = static_cast<std::size_t>(floors.right_floor);
  const auto mass_at = [](const StructuralModel& model, std::size_t at) {
    const std::size_t count = model.floor_masses.size();
    return at < count ? model.floor_masses[at] : model.node_masses.at(at - count);
  };
  LawInput input = contact_input(gap.contact, point,
                                 effective_mass(mass_at(left.model, left_floor), mass_at(right.model, right_floor)));
  if (gap.contact.axial) {
    input.numbers["stiffness"] = series_stiffness(beam_end_stiffness(left.spec, left_floor, true),
                                                  beam_end_stiffness(right.spec, right_floor, false));
  }
  return make_contact_law(gap.contact, input);
}

bool BuildingSpec::is_in_plan() const {
  return std::holds_alternative<Plan>(structure) || std::holds_alternative<PlanWall>(structure);
}

const Footprint& BuildingSpec::footprint() const {
  const Plan* const plan = std::get_if<Plan>(&structure);
  return plan != nullptr ? plan->footprint : std::get<PlanWall>(structure).footprint;
}

bool BuildingSpec::is_rigid() const {
  return std::holds_alternative<RigidSpec>(structure) || std::holds_alternative<PlanWall>(structure);
}

std::vector<const ExcitationSpec*> Case::excitations() const {
  if (!is_in_plan()) return {&excitation};
  return {&excitation, &excitation_y};
}

const std::vector<ColumnNode>* column_nodes(const BuildingSpec& spec) {
  if (const auto* frame = std::get_if<PlaneFrame>(&spec.structure)) return &frame->nodes;
  return spec.columns ? &spec.columns->nodes : nullptr;
}

std::vector<ColumnNode>* column_nodes(BuildingSpec& spec) {
  if (auto* frame = std::get_if<PlaneFrame>(&spec.structure)) return &frame->nodes;
  return spec.columns ? &spec.columns->nodes : nullptr;
}

bool has_column_nodes(const BuildingSpec& spec) {
  const std::vector<ColumnNode>* const nodes = column_nodes(spec);
  return nodes != nullptr && !nodes->empty();
}

StructuralModel structural_model(const BuildingSpec& spec) {
  const double base = spec.base_elevation;
  struct Make {
    double base;
    StructuralModel operator()(const PlaneFrame& frame) const { return plane_frame_model(frame, base); }
    StructuralModel operator()(const Stick& stick) const { return stick_model(stick, base); }
    StructuralModel operator()(const MatricesSpec& matrices) const { return matrices_model(matrices, base); }
    StructuralModel operator()(const ModalBuilding& modal) const { return modal_model(modal, base).model; }
    StructuralModel operator()(const GenericBuilding& generic) const { return generic_model(generic, base); }
    StructuralModel operator()(const DisplacementsSpec& given) const {
      return known_by_displacements("", given, base).model;
    }
    StructuralModel operator()(const RigidSpec& rigid) const {
      std::vector<double> elevations = rigid.elevations;
      for (double& elevation : elevations) elevation += base;
      return rigid_building("", elevations).model;
    }
    StructuralModel operator()(const Plan& /*plan*/) const { return not_in_a_row(); }
    StructuralModel operator()(const PlanWall& /*wall*/) const { return not_in_a_row(); }
    [[noreturn]] static StructuralModel not_in_a_row() {
      throw InvalidParameter("structure", "plan", "must be that of a building in a row");
    }
  };
  StructuralModel model = std::visit(Make{base}, spec.structure);
  if (spec.columns) add_columns(model, *spec.columns);
  if (spec.calibrate_period) {
    calibrate_period(model, *spec.calibrate_period);
  }
  return model;
}

Soil soil_of(const SoilSpec& spec) {
  return spec.half_space ? soil_of(*spec.half_space, spec.soil.mass, spec.soil.inertia) : spec.soil;
}

Bearings bearings_of(const IsolationSpec& spec, double weight) {
  const auto* const entry = find_entry(bearing_laws(), spec.law);
  if (entry == nullptr) throw InvalidParameter("isolation", spec.law, "there are no such bearings");
  return *entry->make({.numbers = spec.numbers, .weight = weight});
}

Building make_building(const BuildingSpec& spec) { return make_building(spec, structural_model(spec)); }

namespace {

Support support_of(const BuildingSpec& spec, const StructuralModel& model) {
  Support support;
  if (!spec.gravity_loads.empty()) {
    support.gravity = GravityLoads{spec.gravity_loads};
  } else if (spec.p_delta) {
    GravityLoads gravity;
    for (const double mass : model.floor_masses) gravity.loads.push_back(mass * spec.gravity);
    support.gravity = gravity;
  }
  if (spec.isolation) {
    const double weight = spec.gravity * mass_above_bearings(model, spec.isolation->mass);
    support.isolation = {spec.isolation->mass, bearings_of(*spec.isolation, weight), spec.isolation->damping};
  }
  if (spec.soil) support.soil = soil_of(*spec.soil);
  return support;
}

std::vector<std::shared_ptr<const HystereticLaw>> laws_of_storeys(const BuildingSpec& spec,
                                                                  const StructuralModel& model) {
  if (const auto* stick = std::get_if<Stick>(&spec.structure)) return storey_laws(*stick, model);
  if (const auto* generic = std::get_if<GenericBuilding>(&spec.structure)) {
    return storey_laws(*generic, model, spec.gravity);
  }
  return {};
}

}  // namespace

Building make_building(const BuildingSpec& spec, StructuralModel model) {
  if (std::holds_alternative<RigidSpec>(spec.structure)) return rigid_building(spec.name, model.elevations);
  if (const auto* known = std::get_if<DisplacementsSpec>(&spec.structure)) {
    return known_by_displacements(spec.name, *known, spec.base_elevation);
  }
  Building building;
  const double fixed_omega = spec.tangent_damping ? modes(model.mass, model.stiffness).omega(0) : 0;  // [rad/s]
  if (const auto* modal = std::get_if<ModalBuilding>(&spec.structure)) {
    ModalModel known = modal_model(*modal, spec.base_elevation);
    building = {spec.name, std::move(known.model), std::move(known.known.modes), {}};
    building.modal_damping = modal_damping(spec.damping, building.modes);
  } else {
    const Support support = support_of(spec, model);
    std::vector<std::shared_ptr<const HystereticLaw>> laws = laws_of_storeys(spec, model);
    building = make_building(spec.name, std::move(model), spec.damping, support, std::move(laws));
  }
  if (const auto* frame = std::get_if<PlaneFrame>(&spec.structure)) {
    building.bays = frame->bay_widths;
  } else if (spec.width) {
    building.bays = {*spec.width};
  }
  if (spec.tangent_damping) {
    const auto beta = stiffness_part(spec.damping, fixed_omega);
    if (!beta || *beta < 0) {
      throw InvalidParameter("damping_stiffness", "tangent",
                             "needs damping with a stiffness part that is not negative");
    }
    building.tangent_damping = *beta;
  }
  return building;
}

std::vector<ContactPoint> contact_points(const Case& c, const std::vector<Building>& buildings) {
  std::vector<ContactPoint> points;
  for (std::size_t gap = 0; gap < c.gaps.size(); ++gap) {
    for (ContactPoint& point : points_of(c, gap, buildings)) {
      points.push_back(std::move(point));
    }
  }
  return points;
}

FloorLevels levels_of(const StructuralModel& model) { return {model.elevations, base_of(model)}; }

std::optional<double> watched_width(const std::vector<ContactPoint>& points, Eigen::Index gap, double elevation) {
  const ContactPoint* below = nullptr;
  const ContactPoint* above = nullptr;
  for (const ContactPoint& point : points) {
    if (point.gap != gap) continue;
    if (point.elevation <= elevation) below = &point;
    if (point.elevation >= elevation && above == nullptr) above = &point;
  }
  if (below == nullptr && above == nullptr) return std::nullopt;
  return std::min((below != nullptr ? below : above)->width, (above != nullptr ? above : below)->width);
}

std::vector<WatchedFloor> watched_floors(const Case& c, const std::vector<Building>& buildings,
                                         const std::vector<ContactPoint>& points) {
  std::vector<WatchedFloor> all;
  for (std::size_t gap = 0; gap < c.gaps.size(); ++gap) {
    watch_gap(c.gaps[gap], static_cast<int>(gap), buildings, points, all);
  }
  return all;
}

namespace {

const std::string spectrum_is_no_motion =
    "a spectrum has no course in time: bentur gap and report take it, a run needs kind = \"record\" with a ground "
    "motion, such as one matched to the spectrum";

const std::string displacements_are_no_course =
    "displacements are no course in time: bentur gap and report take them, a run needs the building itself";

const std::string suite_is_many_motions =
    "a suite is many ground motions: bentur run, gap and report take them all, --record N (record=N of Python) one "
    "of them";

std::vector<Building> buildings_of(const Case& c) {
  std::vector<Building> buildings;
  for (const BuildingSpec& spec : c.buildings) buildings.push_back(make_building(spec));
  return buildings;
}

Problem problem_of(const Case& c, std::vector<Building> buildings) {
  if (c.buildings.size() < 2 || c.gaps.size() + 1 != c.buildings.size() || buildings.size() != c.buildings.size()) {
    throw InvalidParameter("gaps", std::to_string(c.gaps.size()),
                           "must be one between each pair of neighbours, of two buildings or more");
  }
  Problem problem;
  problem.buildings = std::move(buildings);
  problem.points = contact_points(c, problem.buildings);
  problem.watched = watched_floors(c, problem.buildings, problem.points);
  problem.links = links_of(c.links, problem.buildings);
  problem.motion = c.excitation.motion;
  problem.delays = c.excitation.delays;
  problem.kinematics = c.excitation.kinematics;
  problem.initial_displacement = initial_state(c.initial.displacements, problem.buildings);
  problem.initial_velocity = initial_state(c.initial.velocities, problem.buildings);
  problem.duration = c.analysis.duration;
  problem.goes_on = c.analysis.goes_on;
  problem.collapse_drift = c.analysis.collapse_drift;
  validate(problem);
  return problem;
}

}  // namespace

SolveOptions solve_options(const Case& c) { return solve_options(c.analysis); }

RunLimits run_limits(const AnalysisSpec& analysis) {
  return {.steps = static_cast<long>(analysis.limits.steps),
          .events = static_cast<long>(analysis.limits.events),
          .seconds = analysis.limits.seconds};
}

SolveOptions solve_options(const AnalysisSpec& analysis) {
  SolveOptions options;
  options.levels = true;
  options.both_ways = analysis.both_ways;
  options.energy_audit = analysis.energy_audit;
  options.limits = run_limits(analysis);
  return options;
}

bool is_without_motion(const Case& c) { return c.excitation.spectrum || c.excitation.suite != nullptr; }

bool refuse_without_motion(const Case& c, Diagnostics& diagnostics) {
  if (const auto& spectrum = c.excitation.spectrum) {
    diagnostics.add({.position = spectrum->position,
                     .key = "excitation.kind",
                     .value = spectrum->of_displacements ? "\"displacements\"" : "\"spectrum\"",
                     .rule = spectrum->of_displacements ? displacements_are_no_course : spectrum_is_no_motion});
  } else if (const auto& suite = c.excitation.suite) {
    diagnostics.add(
        {.position = suite->position, .key = "excitation.kind", .value = "\"suite\"", .rule = suite_is_many_motions});
  }
  return is_without_motion(c);
}

Problem make_problem(const Case& c) { return make_problem(c, buildings_of(c)); }

Problem make_problem(const Case& c, std::vector<Building> buildings) {
  for (const BuildingSpec& spec : c.buildings) {
    if (std::holds_alternative<DisplacementsSpec>(spec.structure))
      throw InvalidParameter("displacements", spec.name, displacements_are_no_course);
  }
  if (c.excitation.spectrum) throw InvalidParameter("excitation.kind", "\"spectrum\"", spectrum_is_no_motion);
  if (c.excitation.suite) throw InvalidParameter("excitation.kind", "\"suite\"", suite_is_many_motions);
  return problem_of(c, std::move(buildings));
}

Problem make_still_problem(const Case& c) { return make_still_problem(c, buildings_of(c)); }

Problem make_still_problem(const Case& c, std::vector<Building> buildings) {
  return problem_of(c, std::move(buildings));
}

}  // namespace bentur
