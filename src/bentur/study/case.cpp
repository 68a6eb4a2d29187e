#include "bentur/study/case.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <string>
#include <tuple>

#include "bentur/contact/axial_stiffness.h"
#include "bentur/contact/laws.h"
#include "bentur/core/errors.h"
#include "bentur/structure/modes.h"

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

double height_of(const SpecAndModel& building) {
  const std::vector<double>& storeys = building.model.storey_heights;
  return std::accumulate(storeys.begin(), storeys.end(), 0.0);
}

/// The two floors that meet at an elevation, each within a millionth of the taller building's height of it.
std::pair<int, int> floors_at(double elevation, const SpecAndModel& left, const SpecAndModel& right) {
  const double tolerance = 1e-6 * std::max(height_of(left), height_of(right));
  const auto floor_of = [&](const SpecAndModel& building) {
    const std::vector<double>& floors = building.model.elevations;
    const auto near = [&](double floor) { return std::abs(floor - elevation) <= tolerance; };
    const auto found = std::find_if(floors.begin(), floors.end(), near);
    if (found == floors.end()) {
      throw InvalidParameter("elevations", std::to_string(elevation),
                             "\"" + building.spec.name + "\" has no floor there");
    }
    return static_cast<int>(found - floors.begin());
  };
  return {floor_of(left), floor_of(right)};
}

/// Half of the beam next to the gap, (3-4): the rightmost bay of a left building, the leftmost bay of a right one.
double beam_end_stiffness(const BuildingSpec& spec, int floor, bool left_of_gap) {
  const auto* frame = std::get_if<PlaneFrame>(&spec.structure);
  if (frame == nullptr) {
    throw InvalidParameter("stiffness", "axial", "needs a frame; \"" + spec.name + "\" is none");
  }
  const double bay = left_of_gap ? frame->bay_widths.back() : frame->bay_widths.front();
  return half_beam_stiffness(frame->elastic_modulus, frame->beams.at(static_cast<std::size_t>(floor)).area, bay);
}

/// Of the keys that exclude one another exactly one; a key that is required and missing the law itself reports.
void check_one_of(const LawEntry& law, const LawInput& input) {
  std::string names;
  int given = 0;
  for (const LawKey& key : law.keys) {
    if (key.need == LawKey::Need::one_of) {
      names += (names.empty() ? "" : ", ") + std::string(key.name);
      given += input.numbers.find(key.name) == input.numbers.end() ? 0 : 1;
    }
  }
  if (!names.empty() && given != 1) {
    throw InvalidParameter("contact", std::to_string(given) + " of " + names, "needs exactly one of them");
  }
}

/// Contact points of the gap to the right of building `gap`.
std::vector<ContactPoint> points_of(const Case& c, std::size_t gap, const std::vector<Building>& buildings) {
  const GapSpec& spec = c.gaps[gap];
  if (spec.elevations.empty() || spec.widths.size() != spec.elevations.size()) {
    throw InvalidParameter("widths", std::to_string(spec.widths.size()) + " values",
                           "must be one per contact point, of which a gap has at least one");
  }
  const SpecAndModel left{c.buildings[gap], buildings[gap].model};
  const SpecAndModel right{c.buildings[gap + 1], buildings[gap + 1].model};
  std::vector<ContactPoint> points;
  for (std::size_t i = 0; i < spec.elevations.size(); ++i) {
    ContactPoint point;
    point.left = static_cast<int>(gap);
    std::tie(point.left_floor, point.right_floor) = floors_at(spec.elevations[i], left, right);
    point.elevation = spec.elevations[i];
    point.width = spec.widths[i];
    point.law = make_contact_law(spec, i, left, right);
    points.push_back(point);
  }
  return points;
}

/// All degrees of freedom from the floors' values; joint rotations θ = −K_ss⁻¹ K_sp x, free of moment.
Eigen::VectorXd from_floors(const StructuralModel& model, const std::vector<double>& values) {
  const Eigen::Index floors = model.floors();
  const Eigen::Index rotations = model.dofs() - floors;
  if (static_cast<Eigen::Index>(values.size()) != floors) {
    throw InvalidParameter("initial", std::to_string(values.size()) + " values", "must be one per floor");
  }
  Eigen::VectorXd all(model.dofs());
  all.head(floors) = Eigen::Map<const Eigen::VectorXd>(values.data(), floors);
  if (rotations > 0) {
    all.tail(rotations) = -model.stiffness.bottomRightCorner(rotations, rotations)
                               .ldlt()
                               .solve(model.stiffness.bottomLeftCorner(rotations, floors) * all.head(floors));
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

std::optional<double> ContactSpec::number(std::string_view key, std::size_t point) const {
  const auto found = numbers.find(key);
  if (found == numbers.end()) {
    return std::nullopt;
  }
  const std::vector<double>& values = found->second;
  if (values.size() != 1 && point >= values.size()) {
    throw InvalidParameter(found->first, std::to_string(values.size()) + " values",
                           "must be one value or one per contact point");
  }
  return values.size() == 1 ? values.front() : values[point];
}

std::map<std::string, std::string, std::less<>> ContactSpec::choices() const {
  std::map<std::string, std::string, std::less<>> result;
  const LawEntry* const entry = find_law(law);
  if (entry == nullptr) {
    return result;
  }
  for (const LawChoice& choice : entry->choices) {
    if (choice.with.empty() || numbers.find(choice.with) != numbers.end()) {
      const auto made = words.find(choice.name);
      result.emplace(choice.name, made == words.end() ? choice.words.front() : std::string_view(made->second));
    }
  }
  return result;
}

std::shared_ptr<const ContactLaw> make_contact_law(const GapSpec& gap, std::size_t point, const SpecAndModel& left,
                                                   const SpecAndModel& right) {
  const ContactSpec& contact = gap.contact;
  const LawEntry* const entry = find_law(contact.law);
  if (entry == nullptr) {
    throw InvalidParameter("law", contact.law, "there is no such law");
  }
  const auto [left_floor, right_floor] = floors_at(gap.elevations.at(point), left, right);
  LawInput input;
  for (const auto& [key, values] : contact.numbers) {
    input.numbers[key] = *contact.number(key, point);
  }
  if (contact.axial) {
    input.numbers["stiffness"] = series_stiffness(beam_end_stiffness(left.spec, left_floor, true),
                                                  beam_end_stiffness(right.spec, right_floor, false));
  }
  input.words = contact.words;
  const double m1 = left.model.floor_masses.at(static_cast<std::size_t>(left_floor));
  const double m2 = right.model.floor_masses.at(static_cast<std::size_t>(right_floor));
  input.effective_mass = m1 * m2 / (m1 + m2);
  check_one_of(*entry, input);
  return entry->make(input);
}

StructuralModel structural_model(const BuildingSpec& spec) {
  StructuralModel model;
  if (const auto* frame = std::get_if<PlaneFrame>(&spec.structure)) {
    model = plane_frame_model(*frame, spec.base_elevation);
  } else if (const auto* stick = std::get_if<Stick>(&spec.structure)) {
    model = stick_model(*stick, spec.base_elevation);
  } else {
    model = matrices_model(std::get<MatricesSpec>(spec.structure), spec.base_elevation);
  }
  if (spec.calibrate_period) {
    calibrate_period(model, *spec.calibrate_period);
  }
  return model;
}

Building make_building(const BuildingSpec& spec) {
  return make_building(spec.name, structural_model(spec), spec.damping);
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

Problem make_problem(const Case& c) {
  std::vector<Building> buildings;
  for (const BuildingSpec& spec : c.buildings) {
    buildings.push_back(make_building(spec));
  }
  return make_problem(c, std::move(buildings));
}

Problem make_problem(const Case& c, std::vector<Building> buildings) {
  if (c.buildings.size() < 2 || c.gaps.size() + 1 != c.buildings.size() || buildings.size() != c.buildings.size()) {
    throw InvalidParameter("gaps", std::to_string(c.gaps.size()),
                           "must be one between each pair of neighbours, of two buildings or more");
  }
  Problem problem;
  problem.buildings = std::move(buildings);
  problem.points = contact_points(c, problem.buildings);
  problem.motion = c.excitation.motion;
  problem.delays = c.excitation.delays;
  problem.kinematics = c.excitation.kinematics;
  problem.initial_displacement = initial_state(c.initial.displacements, problem.buildings);
  problem.initial_velocity = initial_state(c.initial.velocities, problem.buildings);
  problem.duration = c.analysis.duration;
  validate(problem);
  return problem;
}

}  // namespace bentur
