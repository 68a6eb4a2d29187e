#include "bentur/solve/engine/run/watch/levels.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>

namespace bentur::engine {
namespace {

using Relation = ModalSystem::Relation;

/// A face of a level: of which building, and its floor; nothing where it is no floor, but a column.
struct FloorFace {
  Eigen::Index building = 0;
  std::optional<Eigen::Index> floor;
};

/// Left and right.
using Faces = std::array<FloorFace, 2>;

Faces faces_of(const Problem& problem, const ContactPoint& point) {
  const auto face = [&](Eigen::Index building, Eigen::Index dof) -> FloorFace {
    const bool is_floor = dof < problem.buildings[building].model.floors();
    return {building, is_floor ? std::optional(dof) : std::nullopt};
  };
  return {face(point.left, point.left_floor), face(point.left + 1, point.right_floor)};
}

Faces faces_of(const Problem& /*problem*/, const WatchedFloor& floor) {
  Faces faces = {FloorFace{floor.left, floor.facing_floor}, FloorFace{floor.left + 1, floor.facing_floor}};
  faces[static_cast<std::size_t>(floor.floor_of - floor.left)].floor = floor.floor;
  return faces;
}

Relation times(Relation relation, double sign) {
  relation.left_row *= sign;
  relation.right_row *= sign;
  return relation;
}

/// The sway of one face alone, relative to the own base; `left` or right.
Relation one_side(const ModalSystem& system, const Relation& both, bool left) {
  Relation one;
  one.left = one.right = left ? both.left : both.right;
  one.left_begin = one.right_begin = left ? both.left_begin : both.right_begin;
  one.left_size = left ? both.left_size : both.right_size;
  one.left_row = left ? both.left_row : both.right_row;
  one.left_row(system.blocks[one.left].modes) = 0.0;  // the ground
  return one;
}

/// Calls `each` with the faces and the relation of every level.
template <typename Each>
void for_each_level(const Problem& problem, const ModalSystem& system, const Each& each) {
  for (std::size_t i = 0; i < problem.points.size(); ++i) {
    each(faces_of(problem, problem.points[i]), system.elements[i].relation);
  }
  for (std::size_t i = 0; i < problem.watched.size(); ++i) {
    each(faces_of(problem, problem.watched[i]), system.watched[i]);
  }
}

}  // namespace

std::vector<Relation> level_relations(const Problem& problem, const ModalSystem& system) {
  std::vector<Relation> relations;
  for_each_level(problem, system, [&](const Faces&, const Relation& both) { relations.push_back(times(both, -1.0)); });
  for_each_level(problem, system, [&](const Faces& faces, const Relation& both) {
    for (const bool left : {true, false}) {
      if (faces[left ? 0 : 1].floor) continue;
      for (const double sign : {1.0, -1.0}) relations.push_back(times(one_side(system, both, left), sign));
    }
  });
  return relations;
}

void report_levels(const Problem& problem, const std::vector<SpanWatch::Nearest>& nearest, bool reversed,
                   Response& response) {
  auto at = nearest.begin();
  auto sway = at + std::ssize(problem.points) + std::ssize(problem.watched);
  const auto report = [&](const Faces& faces, auto& summary) {
    if (reversed) summary.gap_needed_reversed = at->reach;
    ++at;
    for (const bool left : {true, false}) {
      const FloorFace& face = faces[left ? 0 : 1];
      double& peak = left ? summary.peak_left : summary.peak_right;
      if (face.floor) {
        peak = response.buildings[face.building].displacement_no_contact(*face.floor);
      } else {
        peak = std::max(sway[0].reach, sway[1].reach);
        sway += 2;
      }
    }
  };
  for (std::size_t i = 0; i < problem.points.size(); ++i) {
    report(faces_of(problem, problem.points[i]), response.points[i]);
  }
  for (std::size_t i = 0; i < problem.watched.size(); ++i) {
    report(faces_of(problem, problem.watched[i]), response.watched[i]);
  }
}

}  // namespace bentur::engine
