#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

#include "bentur/io/case/case_toml.h"
#include "bentur/model/plan/plan_run.h"

// Rows of sticks and frames stood in plan: symmetric floors with their stiffness in two planes, shaken along x.
namespace bentur::test {

inline const PlanPoint twin_size(10, 14);

inline std::vector<double> times(std::vector<double> list, double factor) {
  for (double& value : list) value *= factor;
  return list;
}

/// Half of a stick on a line along x, or as a plane along y that is so much stiffer that all its modes come after.
inline PlanPlane plane_of(const Stick& stick, double at, bool along_x, double factor) {
  PlanPlane plane{.name = "",
                  .through = along_x ? PlanPoint(0, at) : PlanPoint(at, 0),
                  .direction = along_x ? PlanPoint::UnitX() : PlanPoint::UnitY(),
                  .storeys = {.storey_heights = {}, .masses = {}, .stiffnesses = times(stick.stiffnesses, factor)}};
  if (!along_x) return plane;
  plane.storeys.yield_forces = times(stick.yield_forces, factor);
  plane.storeys.hardening = stick.hardening;
  plane.storeys.hysteresis = stick.hysteresis;
  plane.storeys.law_numbers = stick.law_numbers;
  plane.storeys.backbone = stick.backbone;
  if (auto& backbone = plane.storeys.backbone) {
    backbone->positive.yield = times(backbone->positive.yield, factor);
    if (backbone->negative) backbone->negative->yield = times(backbone->negative->yield, factor);
  }
  return plane;
}

/// The planes of a frame whose floors alone have mass: two of half of it along x, and stiffer springs along y. Empty:
/// it has more in it.
inline std::vector<PlanPlane> planes_of(PlaneFrame frame) {
  if (frame.mass_matrix != MassMatrix::lumped || !frame.nodes.empty()) return {};
  frame.elastic_modulus *= 0.5;
  for (std::optional<Infill>& infill : frame.infills) {
    if (!infill) continue;
    infill->thickness *= 0.5;  // of masonry both stiffness and strength go with it
    infill->stiffness *= 0.5;
    infill->backbone.yield *= 0.5;
  }
  for (auto* const members : {&frame.columns, &frame.beams}) {
    for (Section& section : *members) {
      section.moment_capacity = times(section.moment_capacity, 0.5);
      section.shear_capacity = times(section.shear_capacity, 0.5);
      section.line_load *= 0.5;
    }
  }
  PlanPlane low{.name = "", .through = {0, 1}, .direction = PlanPoint::UnitX()};
  stand_frame(frame, low);
  PlanPlane high = low;
  high.through = {0, 13};
  Stick springs;
  springs.stiffnesses = low.storeys.stiffnesses;
  return {low, high, plane_of(springs, 0.5, false, 400), plane_of(springs, 9.5, false, 400)};
}

/// Movements along x, or under a map of it, as u_x, u_y and rotation of floors.
inline std::vector<std::vector<double>> triples_of(const std::vector<std::vector<double>>& lists,
                                                   const Eigen::Matrix2d& map = Eigen::Matrix2d::Identity()) {
  std::vector<std::vector<double>> all;
  for (const std::vector<double>& list : lists) {
    std::vector<double>& one = all.emplace_back();
    for (const double x : list) one.insert(one.end(), {x * map(0, 0), x * map(1, 0), 0.0});
  }
  return all;
}

inline std::optional<BuildingSpec> twin_of(const BuildingSpec& spec, double corner) {
  const Footprint footprint{.corner = {corner, -3}, .size = twin_size};
  BuildingSpec twin;
  twin.name = spec.name;
  twin.structure = PlanWall{footprint, {}};
  twin.damping = spec.damping;
  twin.tangent_damping = spec.tangent_damping;
  twin.base_elevation = spec.base_elevation;
  if (const auto* wall = std::get_if<RigidSpec>(&spec.structure)) {
    twin.structure = PlanWall{footprint, wall->elevations};
    return twin;
  }
  if (const auto* modal = std::get_if<ModalBuilding>(&spec.structure)) {
    const StructuralModel row = structural_model(spec);
    Plan plan{.footprint = footprint, .storey_heights = row.storey_heights, .masses = row.floor_masses};
    plan.modes = GivenModes{.periods = modal->modes.periods, .shapes = triples_of(modal->modes.shapes)};
    twin.structure = std::move(plan);
    return twin;
  }
  const auto* stick = std::get_if<Stick>(&spec.structure);
  const auto* frame = std::get_if<PlaneFrame>(&spec.structure);
  if ((stick == nullptr && frame == nullptr) || spec.calibrate_period || spec.isolation || spec.soil) {
    return std::nullopt;
  }
  const StructuralModel row = structural_model(spec);
  Plan plan{.footprint = footprint, .storey_heights = row.storey_heights, .masses = row.floor_masses};
  plan.gravity_loads = spec.p_delta ? times(plan.masses, spec.gravity) : spec.gravity_loads;
  if (frame != nullptr) {
    plan.planes = planes_of(*frame);
    if (plan.planes.empty()) return std::nullopt;
  } else {
    plan.planes = {plane_of(*stick, 1, true, 0.5), plane_of(*stick, 13, true, 0.5), plane_of(*stick, 0.5, false, 200),
                   plane_of(*stick, 9.5, false, 200)};
  }
  if (auto* modal = std::get_if<ModalDamping>(&twin.damping); modal != nullptr && modal->ratios.size() > 1) {
    modal->ratios.resize(3 * modal->ratios.size(), 0.05);
  }
  twin.structure = std::move(plan);
  return twin;
}

/// A plan under a map of the common plan that takes rectangles to rectangles.
inline Footprint under(const Eigen::Matrix2d& map, const Footprint& from) {
  return {.corner = (map * from.corner).cwiseMin(map * from.far_corner()), .size = map.cwiseAbs() * from.size};
}
inline void put_under(const Eigen::Matrix2d& map, BuildingSpec& building) {
  if (auto* wall = std::get_if<PlanWall>(&building.structure)) {
    wall->footprint = under(map, wall->footprint);
    return;
  }
  Plan& plan = std::get<Plan>(building.structure);
  const Footprint from = plan.footprint;
  plan.footprint = under(map, from);
  for (PlanPlane& plane : plan.planes) {
    plane.through = map * (from.corner + plane.through) - plan.footprint.corner;
    plane.direction = map * plane.direction;
  }
  if (!plan.modes) return;
  for (std::vector<double>& shape : plan.modes->shapes) {
    for (std::size_t i = 0; i < shape.size(); i += 3) {
      Eigen::Map<Eigen::Vector2d> moved(&shape[i]);
      moved = (map * moved).eval();
      shape[i + 2] *= map.determinant();
    }
  }
}

inline bool is_integrated_law(const GapSpec& gap) {
  constexpr std::array<const char*, 4> laws = {"darmawan", "hertz", "hertz-damp", "jankowski"};
  return std::find(laws.begin(), laws.end(), gap.contact.law) != laws.end();
}

/// Whether both ends of an edge that touches without time may do so one after the other: integrated laws leave floors
/// turned by their tolerance, and what comes of two impacts at once is not what comes of one after the other.
inline bool ends_part(const Case& c) {
  const auto without_time = [](const GapSpec& gap) { return gap.contact.law == "restitution"; };
  return std::any_of(c.gaps.begin(), c.gaps.end(), is_integrated_law) &&
         std::any_of(c.gaps.begin(), c.gaps.end(), without_time);
}

/// Nothing where the row has more in it than sticks and walls one distance apart.
inline std::optional<Case> twin_of(const Case& c, int points, const Eigen::Matrix2d& map) {
  if (is_without_motion(c) || !c.links.empty() || ends_part(c)) return std::nullopt;
  Case twin;
  twin.units = c.units;
  double corner = 2;
  for (std::size_t b = 0; b < c.buildings.size(); ++b) {
    if (b > 0) {
      const GapSpec& gap = c.gaps[b - 1];
      const auto [least, most] = std::minmax_element(gap.widths.begin(), gap.widths.end());
      if (*least != *most || gap.elevations.empty() || gap.strikes_columns) return std::nullopt;
      corner += twin_size.x() + *least;
    }
    const auto building = twin_of(c.buildings[b], corner);
    if (!building) return std::nullopt;
    twin.buildings.push_back(*building);
    put_under(map, twin.buildings.back());
  }
  for (std::size_t g = 0; g < c.gaps.size(); ++g) {
    const StructuralModel left = structural_model(c.buildings[g]), right = structural_model(c.buildings[g + 1]);
    GapSpec gap;
    gap.left = static_cast<Eigen::Index>(g);
    gap.right = gap.left + 1;
    gap.stretch = *facing(twin.buildings[g].footprint(), twin.buildings[g + 1].footprint());
    gap.stretch.width = c.gaps[g].widths.front();  // without the round-off of where edges are
    gap.levels = floors_of_points(c.gaps[g], {c.buildings[g], left}, {c.buildings[g + 1], right});
    if (gap.stretch.swapped) {
      std::swap(gap.left, gap.right);
      for (LevelPair& level : gap.levels) std::swap(level.left_floor, level.right_floor);
    }
    gap.level_tolerance = c.gaps[g].level_tolerance;
    gap.points = c.gaps[g].contact.law == "restitution" ? 2 : points;
    gap.contact = c.gaps[g].contact;
    twin.gaps.push_back(std::move(gap));
  }
  twin.excitation = c.excitation;
  twin.angle = std::atan2(map(1, 0), map(0, 0)) * 180 / std::numbers::pi;
  twin.initial = {triples_of(c.initial.displacements, map), triples_of(c.initial.velocities, map)};
  twin.analysis = c.analysis;
  return twin;
}

}  // namespace bentur::test
