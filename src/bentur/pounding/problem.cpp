#include "bentur/pounding/problem.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bentur/core/algebra/factors.h"
#include "bentur/core/errors.h"
#include "bentur/elements/hinges.h"
#include "bentur/pounding/internal/problem_checks.h"

namespace bentur {
namespace {

/// What of a row over the dofs is no sum of the forces at nodes in columns that are struck.
Eigen::RowVectorXd beside_nodes(const StructuralModel& model, const Eigen::RowVectorXd& row) {
  if (model.nodes() == 0) return row;
  const Eigen::MatrixXd nodes = model.stiffness.middleRows(model.floors(), model.nodes());
  const Eigen::VectorXd of_nodes = combination_of(nodes, row);
  return row - of_nodes.transpose() * nodes;
}

/// The law of a storey takes over all of what works against its drift, but for what pushes columns between floors.
void check_elements(const Building& building, const std::string& name) {
  const Eigen::MatrixXd shears = shear_rows(building.model);
  const Eigen::MatrixXd drifts = drift_rows(building.model);
  for (std::size_t i = 0; i < building.elements.size(); ++i) {
    const BuildingElement& element = building.elements[i];
    const auto what = fmt::format("{}.elements[{}]", name, i);
    require(element.law != nullptr, what + ".law", "none", "must be given");
    const Eigen::Index f = element.storey, last = i > 0 ? building.elements[i - 1].storey : -1;
    if (element.infill) {  // beside what else the storey has
      require(*element.infill >= 0 && *element.infill < std::ssize(building.model.infills), what + ".infill",
              *element.infill, "must be a panel of the model");
      require(element.row.size() == building.model.dofs() && f >= 0 && f < building.model.floors() &&
                  element.law->initial_stiffness() == building.model.infills[*element.infill].stiffness,
              what, building.name, "must be in its storey, with the stiffness of its panel");
      continue;
    }
    require(f > last && f < building.model.floors(), what + ".storey", f,
            "must be a storey above that of the one before");
    constexpr double round_off = 1e-9;
    const double k = element.law->initial_stiffness();
    const auto vanishes = [&](const Eigen::RowVectorXd& left, const Eigen::RowVectorXd& of) {
      return left.cwiseAbs().maxCoeff() <= round_off * of.cwiseAbs().maxCoeff();
    };
    require(element.row.size() == building.model.dofs() &&
                vanishes(drifts.row(f) - element.row.transpose(), element.row.transpose()),
            what + ".row", building.name, "must be that of its storey's drift");
    require(vanishes(beside_nodes(building.model, shears.row(f) - k * drifts.row(f)), k * drifts.row(f)), what, k,
            "must have the stiffness that K has in this storey, and K no other there");
  }
}

/// Elements of several deformations, and that what is told of hinges is of them.
void check_coupled(const Building& building, const std::string& name) {
  Eigen::Index hinges = 0;
  for (std::size_t i = 0; i < building.coupled.size(); ++i) {
    const CoupledElement& element = building.coupled[i];
    const auto what = fmt::format("{}.coupled[{}]", name, i);
    require(element.law != nullptr, what + ".law", "none", "must be given");
    require(element.rows.rows() == element.law->size() && element.rows.cols() == building.model.dofs(), what + ".rows",
            building.name, "must have a row per deformation and a column per degree of freedom");
    require(element.rows.allFinite(), what + ".rows", building.name, "must be finite");
    if (dynamic_cast<const HingeLaw*>(element.law.get()) != nullptr) hinges += element.law->size();
  }
  require(hinges == building.model.hinges.rows.rows(), name + ".model.hinges", building.name,
          "must be those of its elements");
}

void check_building(const Building& building, Eigen::Index b, double duration) {
  const Eigen::Index dofs = building.model.dofs();
  const auto name = fmt::format("buildings[{}]", b);
  require(building.model.floors() > 0, name, building.name, "must have a floor");
  require(building.model.storey_heights.size() == building.model.elevations.size(), name + ".model.storey_heights",
          fmt::format("{} entries", building.model.storey_heights.size()), "must have one entry per floor");
  require(building.model.stiffness.rows() == dofs && building.model.load.size() == dofs &&
              building.modes.shapes.rows() == dofs && building.modes.shapes.cols() == building.modes.omega.size() &&
              building.modal_damping.rows() == building.modes.omega.size(),
          name, building.name, "must have matrices of one size");
  require(building.modes.omega.allFinite() && (building.modes.omega.array() >= 0.0).all(), name + ".modes.omega",
          building.name, "must be finite and ≥ 0");
  require(building.modes.shapes.allFinite() && building.model.load.allFinite() && building.model.mass.allFinite(),
          name + ".modes.shapes", building.name, "must be finite, and mass and load too");
  const double fastest = building.modes.omega.size() > 0 ? building.modes.omega.maxCoeff() : 0.0;
  require(fastest * duration <= most_times, name + ".modes.omega", fastest,
          "must be at most 1e15 over the duration: such vibrations are beyond what numbers can follow");
  require(std::isfinite(building.tangent_damping) && building.tangent_damping >= 0.0, name + ".tangent_damping",
          building.tangent_damping, "must be finite and ≥ 0");
  if (building.can_yield()) {
    require(building.modes.omega.size() == building.model.dofs(), name + ".elements", building.name,
            "must be those of a building with all its modes");
    require((building.modes.omega.array() > 0.0).all(), name + ".modes.omega", building.name,
            "must be > 0 where storeys yield");
    check_elements(building, name);
  }
  check_coupled(building, name);
  require(building.modal_damping.allFinite() && building.modal_damping.norm() * duration <= most_times,
          name + ".modal_damping", building.modal_damping.norm(), "must be finite, and at most 1e15 over the duration");
}

/// The places of a row that is solved are between neighbours.
template <class Place>
void check_place(const Place& place, const std::string& name) {
  require(place.right == place.left + 1, name + ".right", place.right, "must be the building to the right of left");
  require(place.gap == place.left, name + ".gap", place.gap, "must be the number of the building to its left");
}

void check_point(const Problem& problem, const ContactPoint& point, std::size_t i) {
  const auto name = fmt::format("points[{}]", i);
  const Eigen::Index last = std::ssize(problem.buildings) - 1;
  require(point.left >= 0 && point.left < last, name + ".left", point.left, "must have a building to its right");
  check_place(point, name);
  const Eigen::Index left = point.left, right = point.right;
  // Nodes in columns come after the floors.
  const auto floors = [&](Eigen::Index b) {
    return problem.buildings[b].model.floors() + problem.buildings[b].model.nodes();
  };
  require(point.left_floor >= 0 && point.left_floor < floors(left), name + ".left_floor", point.left_floor,
          "must be a floor of the left building");
  require(point.right_floor >= 0 && point.right_floor < floors(right), name + ".right_floor", point.right_floor,
          "must be a floor of the right building");
  require(std::isfinite(point.width) && point.width >= 0.0, name + ".width", point.width, "must be finite and ≥ 0");
  require(point.law != nullptr, name + ".law", "none", "must be given");
}

void check_link(const Problem& problem, const Link& link, std::size_t i) {
  const auto name = fmt::format("links[{}]", i);
  const Eigen::Index count = std::ssize(problem.buildings);
  require(link.left >= 0 && link.left < link.right, name + ".left", link.left, "must be left of the other building");
  require(link.right < count, name + ".right", link.right, "must be a building");
  const auto floors = [&](Eigen::Index b) { return problem.buildings[b].model.floors(); };
  require(link.left_floor >= 0 && link.left_floor < floors(link.left), name + ".left_floor", link.left_floor,
          "must be a floor of the left building");
  require(link.right_floor >= 0 && link.right_floor < floors(link.right), name + ".right_floor", link.right_floor,
          "must be a floor of the right building");
  require(link.law != nullptr, name + ".law", "none", "must be given");
}

/// Within one gap a floor meets one other floor: points that share one would not move independently (E-1).
void check_floors_of_points(const Problem& problem) {
  for (std::size_t i = 0; i < problem.points.size(); ++i) {
    const ContactPoint& one = problem.points[i];
    for (std::size_t j = 0; j < i; ++j) {
      const ContactPoint& other = problem.points[j];
      if (one.left != other.left) continue;
      // Of many pairs no texts are made that nobody reads.
      if (one.left_floor != other.left_floor && one.right_floor != other.right_floor) continue;
      require(one.left_floor != other.left_floor, fmt::format("points[{}].left_floor", i), one.left_floor,
              fmt::format("is that of points[{}] already: a floor of a gap has one contact point", j));
      require(one.right_floor != other.right_floor, fmt::format("points[{}].right_floor", i), one.right_floor,
              fmt::format("is that of points[{}] already: a floor of a gap has one contact point", j));
    }
  }
}

void check_watched(const Problem& problem, const WatchedFloor& watched, std::size_t i) {
  const auto name = fmt::format("watched[{}]", i);
  const Eigen::Index last = std::ssize(problem.buildings) - 1;
  require(watched.left >= 0 && watched.left < last, name + ".left", watched.left, "must have a building to its right");
  check_place(watched, name);
  require(watched.floor_of == watched.left || watched.floor_of == watched.right, name + ".floor_of", watched.floor_of,
          "must be one of the two neighbours");
  const Eigen::Index left = watched.left, right = watched.right;
  require(watched.left_row.size() == problem.buildings[left].model.dofs() && watched.left_row.allFinite(),
          name + ".left_row", fmt::format("{} entries", watched.left_row.size()),
          "must have one finite entry per degree of freedom");
  require(watched.right_row.size() == problem.buildings[right].model.dofs() && watched.right_row.allFinite(),
          name + ".right_row", fmt::format("{} entries", watched.right_row.size()),
          "must have one finite entry per degree of freedom");
  require(std::isfinite(watched.width) && watched.width >= 0.0, name + ".width", watched.width,
          "must be finite and ≥ 0");
  require(i == 0 || problem.watched[i - 1].left <= watched.left, name + ".left", watched.left,
          "must ascend from left to right");
}

double initial_at(const Problem& problem, Eigen::Index building, Eigen::Index floor) {
  return problem.initial_displacement.empty() ? 0.0 : problem.initial_displacement[building](floor);
}

/// Faces that collide without a force cannot be inside one another: no force would part them.
void check_overlap(const ContactPoint& point, const Problem& problem, std::size_t i) {
  if (!point.law->restitution()) return;
  const double left_at = initial_at(problem, point.left, point.left_floor);
  const double right_at = initial_at(problem, point.right, point.right_floor);
  require(!overlap(point.width, left_at, right_at), fmt::format("points[{}]", i), left_at - right_at - point.width,
          "must not overlap at the start: its law has no force that would part the buildings");
}

}  // namespace

bool overlap(double width, double left, double right) {
  constexpr double round_off = 0x1p-40;
  return left - right - width > round_off * (width + std::abs(left) + std::abs(right));
}

Eigen::Index gap_count(const Problem& problem) {
  if (!problem.sides.empty()) return std::ssize(problem.sides);
  return std::max<Eigen::Index>(std::ssize(problem.buildings), 1) - 1;
}

GapPair sides_of(const Problem& problem, Eigen::Index gap) {
  require(gap >= 0 && gap < gap_count(problem), "gap", fmt::format("{}", gap), "must have a building on either side");
  return problem.sides.empty() ? GapPair{gap, gap + 1} : problem.sides[gap];
}

std::vector<Eigen::Index> buildings_of(const Problem& problem, Eigen::Index gap) {
  const GapPair sides = sides_of(problem, gap);
  return {std::min(sides.left, sides.right), std::max(sides.left, sides.right)};
}

Gap gap_at(const Problem& problem, Eigen::Index gap) {
  const GapPair sides = sides_of(problem, gap);
  const auto indices = [gap](const auto& all) {
    std::vector<Eigen::Index> found;
    for (Eigen::Index i = 0; i < std::ssize(all); ++i) {
      if (all[i].gap == gap) found.push_back(i);
    }
    return found;
  };
  return {gap, sides.left, sides.right, indices(problem.points), indices(problem.watched)};
}

std::vector<Gap> gaps_of(const Problem& problem) {
  std::vector<Gap> gaps;
  for (Eigen::Index gap = 0; gap < gap_count(problem); ++gap) gaps.push_back(gap_at(problem, gap));
  return gaps;
}

double delay_of(const Problem& problem, std::size_t building) {
  return problem.delays.empty() ? 0.0 : problem.delays.at(building);
}

std::optional<Eigen::Index> face_floor(const Problem& problem, const ContactPoint& point, int side) {
  const Eigen::Index dof = side == 0 ? point.left_floor : point.right_floor;
  return dof < problem.buildings[side == 0 ? point.left : point.right].model.floors() ? std::optional(dof)
                                                                                      : std::nullopt;
}

std::optional<Eigen::Index> face_floor(const WatchedFloor& floor, int side) {
  return floor.floor_of == (side == 0 ? floor.left : floor.right) ? std::optional(floor.floor) : floor.facing_floor;
}

std::optional<StruckColumn> struck_column(const Problem& problem, const ContactPoint& point) {
  for (const Eigen::Index b : {point.left, point.right}) {
    const StructuralModel& model = problem.buildings.at(b).model;
    const Eigen::Index node = (b == point.left ? point.left_floor : point.right_floor) - model.floors();
    if (node >= 0) return StruckColumn{b, node};
  }
  return std::nullopt;
}

std::string gap_name(const Problem& problem, Eigen::Index gap) {
  const std::vector<Eigen::Index> both = buildings_of(problem, gap);
  return problem.buildings.at(both[0]).name + " | " + problem.buildings.at(both[1]).name;
}

std::vector<std::string> gap_names(const Problem& problem) {
  std::vector<std::string> names;
  for (Eigen::Index gap = 0; gap < gap_count(problem); ++gap) names.push_back(gap_name(problem, gap));
  return names;
}

std::vector<double> gap_widths(const Problem& problem) {
  std::vector<double> widths;
  widths.reserve(problem.points.size());
  for (const ContactPoint& point : problem.points) widths.push_back(point.width);
  return widths;
}

void validate(const Problem& problem) {
  require(!problem.buildings.empty(), "buildings", "none", "must not be empty");
  require(std::isfinite(problem.duration) && problem.duration > 0.0, "duration", problem.duration,
          "must be finite and > 0");
  require(std::isfinite(problem.collapse_drift) && problem.collapse_drift > 0.0, "collapse_drift",
          problem.collapse_drift, "must be finite and > 0");
  for (Eigen::Index b = 0; b < std::ssize(problem.buildings); ++b)
    check_building(problem.buildings[b], b, problem.duration);
  for (std::size_t i = 0; i < problem.points.size(); ++i) check_point(problem, problem.points[i], i);
  check_floors_of_points(problem);
  for (std::size_t i = 0; i < problem.links.size(); ++i) check_link(problem, problem.links[i], i);
  for (std::size_t i = 0; i < problem.watched.size(); ++i) check_watched(problem, problem.watched[i], i);
  check_delays(problem.delays, problem.buildings.size());
  if (const auto* sampled = std::get_if<SampledMotion>(&problem.motion)) {
    require(std::isfinite(sampled->time_step) && sampled->time_step * most_times >= problem.duration,
            "motion.time_step", sampled->time_step, "must be finite and at least 1e-15 of the duration");
  }
  if (const auto* harmonic = std::get_if<HarmonicMotion>(&problem.motion)) {
    require(std::isfinite(harmonic->period) && harmonic->period * most_times >= problem.duration, "motion.period",
            harmonic->period, "must be finite and at least 1e-15 of the duration");
    require(std::isfinite(peak_acceleration(problem.motion)), "motion.displacement_amplitude",
            harmonic->displacement_amplitude, "must give a finite acceleration");
  }
  std::vector<Eigen::Index> dofs;
  for (const Building& building : problem.buildings) dofs.push_back(building.model.dofs());
  check_initial(problem.initial_displacement, dofs, "initial_displacement");
  check_initial(problem.initial_velocity, dofs, "initial_velocity");
  for (std::size_t i = 0; i < problem.points.size(); ++i) check_overlap(problem.points[i], problem, i);
}

}  // namespace bentur
