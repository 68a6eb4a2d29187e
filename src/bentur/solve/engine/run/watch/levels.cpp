#include "bentur/solve/engine/run/watch/levels.h"

#include <algorithm>
#include <optional>

namespace bentur::engine {
namespace {

using Eigen::Index;
using Relation = ModalSystem::Relation;

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

/// Adds the sways of faces that are no floors, there and back; `floor_of`: the floor that a side is.
void add_sways(const ModalSystem& system, const Relation& both, const auto& floor_of,
               std::vector<Relation>& relations) {
  for (const int side : {0, 1}) {
    if (floor_of(side)) continue;
    for (const double sign : {1.0, -1.0}) relations.push_back(times(one_side(system, both, side == 0), sign));
  }
}

}  // namespace

std::vector<Relation> level_relations(const Problem& problem, const ModalSystem& system) {
  std::vector<Relation> relations;
  const auto points = static_cast<Index>(problem.points.size());
  for (Index i = 0; i < points; ++i) relations.push_back(times(system.elements[i].relation, -1.0));
  for (const Relation& both : system.watched) relations.push_back(times(both, -1.0));
  for (Index i = 0; i < points; ++i) {
    const auto floor_of = [&](int side) { return face_floor(problem, problem.points[i], side); };
    add_sways(system, system.elements[i].relation, floor_of, relations);
  }
  for (Index i = 0; i < std::ssize(problem.watched); ++i) {
    const auto floor_of = [&](int side) { return face_floor(problem.watched[i], side); };
    add_sways(system, system.watched[i], floor_of, relations);
  }
  return relations;
}

void report_levels(const Problem& problem, const std::vector<SpanWatch::Nearest>& nearest, bool reversed,
                   Response& response) {
  auto at = nearest.begin();
  auto sway = at + std::ssize(problem.points) + std::ssize(problem.watched);
  const auto report = [&](Index left, const auto& floor_of, auto& summary) {
    if (reversed) summary.gap_needed_reversed = at->reach;
    ++at;
    for (const int side : {0, 1}) {
      double& peak = side == 0 ? summary.peak_left : summary.peak_right;
      if (const std::optional<Index> floor = floor_of(side)) {
        peak = response.buildings[left + side].displacement_no_contact(*floor);
      } else {
        peak = std::max(sway[0].reach, sway[1].reach);
        sway += 2;
      }
    }
  };
  for (Index i = 0; i < std::ssize(problem.points); ++i) {
    const ContactPoint& point = problem.points[i];
    report(
        point.left, [&](int side) { return face_floor(problem, point, side); }, response.points[i]);
  }
  for (Index i = 0; i < std::ssize(problem.watched); ++i) {
    const WatchedFloor& floor = problem.watched[i];
    report(
        floor.left, [&](int side) { return face_floor(floor, side); }, response.watched[i]);
  }
}

}  // namespace bentur::engine
