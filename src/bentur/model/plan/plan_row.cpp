#include "bentur/model/plan/plan_row.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "bentur/core/errors.h"

namespace bentur {
namespace {

using Eigen::Index;

/// The first component of the ground's motion that there is, which is told of.
std::size_t told_motion(const PlanProblem& problem) {
  return std::holds_alternative<NoMotion>(problem.motions[0]) ? 1 : 0;
}

Building building_of(const PlanBuilding& building) {
  Building row;
  row.name = building.name;
  row.model.elevations = building.model.elevations;
  row.model.storey_heights = building.model.storey_heights;
  row.model.floor_masses = building.model.floor_masses;
  row.model.slab = building.model.slab;
  for (const PlanModel::Node& node : building.model.nodes) {
    row.model.node_elevations.push_back(node.elevation);
    row.model.node_masses.push_back(node.mass);
  }
  row.modes.omega = building.modes.omega;
  row.has_gravity_loads = building.has_gravity_loads();
  return row;
}

void add_gap(const PlanGap& gap, Index number, Problem& row) {
  row.sides.push_back({gap.left, gap.right});
  for (const Index i : contacts_in_row(gap)) {
    const PlanContact& contact = gap.contacts[static_cast<std::size_t>(i)];
    row.points.push_back({.left = gap.left,
                          .left_floor = contact.left_floor,
                          .right_floor = contact.right_floor,
                          .elevation = contact.elevation,
                          .width = gap.width_at(contact),
                          .beyond = gap.at(contact).beyond,
                          .opens = gap.opens(contact),
                          .beside = contact.beside.has_value(),
                          .law = contact.law,
                          .column_shear_capacity = contact.column_shear_capacity,
                          .column_moment_capacity = contact.column_moment_capacity,
                          .right = gap.right,
                          .gap = number});
  }
  for (const PlanWatched& watched : gap.watched) {
    WatchedFloor& floor = row.watched.emplace_back();
    floor.left = gap.left;
    floor.right = gap.right;
    floor.gap = number;
    floor.floor_of = watched.floor_of;
    floor.floor = watched.floor;
    floor.facing_floor = watched.facing_floor;
    floor.elevation = watched.elevation;
    floor.width = gap.width_at(watched);
    floor.beyond = gap.at(watched).beyond;
    floor.opens = gap.opens(watched);
    floor.beside = watched.beside.has_value();
  }
}

/// What a contact of no joint did, as done by the first at its level of the joint of its pair of parts.
/// @param in_row contacts_in_row() of the gap, whose summaries are `points`
void add_beside(const PlanGap& gap, const std::vector<Index>& in_row, const PlanContact& contact,
                const PointSummary& did, PointSummary* points) {
  for (std::size_t i = 0; i < in_row.size(); ++i) {
    const PlanContact& one = gap.contacts[static_cast<std::size_t>(in_row[i])];
    if (one.elevation != contact.elevation || one.pair != contact.pair) continue;
    points[i].impacts += did.impacts;
    points[i].settling += did.settling;
    points[i].peak_force = std::max(points[i].peak_force, did.peak_force);
    return;
  }
}

/// The points of the row out of those of all contacts, with what those beside them did.
std::vector<PointSummary> points_of_joints(const PlanProblem& problem, const std::vector<PointSummary>& all) {
  std::vector<PointSummary> points;
  std::size_t first = 0;
  for (const PlanGap& gap : problem.gaps) {
    const std::size_t begin = points.size();
    const std::vector<Index> in_row = contacts_in_row(gap);
    for (const Index i : in_row) points.push_back(all[first + static_cast<std::size_t>(i)]);
    for (std::size_t i = 0; i < gap.contacts.size(); ++i) {
      const PlanContact& contact = gap.contacts[i];
      if (!gap.is_of_pair(contact)) add_beside(gap, in_row, contact, all[first + i], points.data() + begin);
    }
    first += gap.contacts.size();
  }
  return points;
}

/// How far the edges of the floors of a building move along a normal [length]; of an oblique one not less than that.
Eigen::VectorXd moves_across(const PlanPeaks& peaks, const PlanPoint& normal) {
  const PlanPoint across = normal.cwiseAbs();
  return across.x() * peaks.south.cwiseMax(peaks.north) + across.y() * peaks.west.cwiseMax(peaks.east);
}

/// Along which normals the places of a row move: its points, else what is watched, gap after gap.
std::vector<PlanPoint> normals_of(const PlanProblem& problem, bool of_points) {
  std::vector<PlanPoint> normals;
  for (const PlanGap& gap : problem.gaps) {
    const auto add = [&](const auto& one) { normals.push_back(one.beside ? one.beside->normal : gap.stretch.n); };
    if (of_points) {
      for (const Index i : contacts_in_row(gap)) add(gap.contacts[static_cast<std::size_t>(i)]);
    } else {
      for (const PlanWatched& watched : gap.watched) add(watched);
    }
  }
  return normals;
}

/// Peaks of faces that are floors, where those were not asked for.
template <class Summary, class Place>
void know_peaks(const PlanRun& run, const std::vector<Place>& places, std::vector<Summary>& summaries) {
  const std::vector<PlanPoint> normals = normals_of(run.problem, std::is_same_v<Place, ContactPoint>);
  for (std::size_t i = 0; i < places.size(); ++i) {
    const Place& at = places[i];
    const auto peak = [&](Index building, std::optional<Index> floor, double& of) {
      if (!std::isnan(of) || !floor) return;
      const Eigen::VectorXd floors = moves_across(run.response.buildings_no_contact[building], normals[i]);
      if (*floor < floors.size()) of = floors(*floor);
    };
    if constexpr (std::is_same_v<Place, ContactPoint>) {
      peak(at.left, at.left_floor, summaries[i].peak_left);
      peak(at.right, at.right_floor, summaries[i].peak_right);
    } else {
      peak(at.left, face_floor(at, 0), summaries[i].peak_left);
      peak(at.right, face_floor(at, 1), summaries[i].peak_right);
    }
  }
}

void check_response(const PlanRun& run) {
  std::size_t points = 0, watched = 0;
  for (const PlanGap& gap : run.problem.gaps) {
    points += gap.contacts.size();
    watched += gap.watched.size();
  }
  if (run.response.points.size() == points && run.response.watched.size() == watched &&
      run.response.buildings_no_contact.size() == run.problem.buildings.size()) {
    return;
  }
  throw InvalidParameter("response", std::to_string(run.response.points.size()) + " points",
                         "must be the response of this problem");
}

}  // namespace

Problem row_of(const PlanProblem& problem) {
  Problem row;
  for (const PlanBuilding& building : problem.buildings) row.buildings.push_back(building_of(building));
  for (std::size_t g = 0; g < problem.gaps.size(); ++g) add_gap(problem.gaps[g], static_cast<Index>(g), row);
  row.motion = problem.motions[told_motion(problem)];
  row.kinematics = problem.kinematics;
  row.duration = problem.duration;
  row.collapse_drift = problem.collapse_drift;
  return row;
}

RunResults row_of(const Case& c, const PlanProblem& problem) {
  RunResults row;
  row.c.title = c.title;
  row.c.units = c.units;
  row.c.analysis = c.analysis;
  row.c.code = c.code;
  row.c.excitation = *c.excitations()[told_motion(problem)];
  row.problem = row_of(problem);
  return row;
}

std::shared_ptr<const RunResults> row_of(const PlanRun& run) {
  if (run.row) return run.row;
  check_response(run);
  auto made = std::make_shared<RunResults>(row_of(run.c, run.problem));
  RunResults& row = *made;
  const std::size_t mover = applied_pga(run, 0) > 0 ? 0 : 1;  // of results read back no motion is known
  row.problem.motion = run.problem.motions[mover];
  row.c.excitation = *run.c.excitations()[mover];
  row.response.status = run.response.status;
  row.response.collapse_no_contact = run.response.collapse_no_contact;
  row.response.duration = run.response.duration;
  row.response.points = points_of_joints(run.problem, run.response.points);
  row.response.watched = run.response.watched;
  know_peaks(run, row.problem.points, row.response.points);
  know_peaks(run, row.problem.watched, row.response.watched);
  if (const auto& other = run.response.reversed) {
    ReversedRun& reversed = row.response.reversed.emplace();
    reversed.collapse = other->collapse;
    reversed.collapse_no_contact = other->collapse_no_contact;
    reversed.has_contact = other->has_contact;
    if (other->has_contact) {
      reversed.points = points_of_joints(run.problem, other->points);
      reversed.watched = other->watched;
    }
  }
  const std::vector<LargestDrift> drifts = drifts_no_contact(run.response);
  for (std::size_t b = 0; b < drifts.size(); ++b) {
    const PlanPeaks& free = run.response.buildings_no_contact[b];
    BuildingPeaks& peaks = row.response.buildings.emplace_back();
    peaks.displacement_no_contact = free.edge_displacement();
    peaks.drift_ratio_no_contact = drift_ratios_with(free.south.size(), drifts[b]);
  }
  return made;
}

std::vector<Index> contacts_in_row(const PlanGap& gap) {
  std::vector<Index> places;
  for (std::size_t i = 0; i < gap.contacts.size(); ++i) {
    if (gap.is_of_pair(gap.contacts[i])) places.push_back(static_cast<Index>(i));
  }
  std::stable_sort(places.begin(), places.end(),
                   [&](Index a, Index b) { return gap.contacts[a].elevation < gap.contacts[b].elevation; });
  return places;
}

PlaceInGap place_in_gap(const PlanProblem& problem, const Problem& row, bool is_point, Index index) {
  const auto place = [&](const auto& all) {
    const Index gap = all.at(static_cast<std::size_t>(index)).gap;
    Index first = index;
    while (first > 0 && all[first - 1].gap == gap) --first;
    return PlaceInGap{static_cast<std::size_t>(gap), index - first};
  };
  if (!is_point) return place(row.watched);
  PlaceInGap at = place(row.points);
  at.index = contacts_in_row(problem.gaps.at(at.gap)).at(static_cast<std::size_t>(at.index));
  return at;
}

PlanPoint place_of(const PlanProblem& problem, const Problem& row, bool is_point, Index index) {
  const PlaceInGap at = place_in_gap(problem, row, is_point, index);
  const PlanGap& gap = problem.gaps.at(at.gap);
  return is_point ? gap.middle(gap.contacts.at(at.index)) : gap.middle(gap.watched.at(at.index));
}

std::optional<GoverningLevel> governing_level(const PlanRun& run, std::size_t gap) {
  const auto row = row_of(run);
  if (facing_levels(row->problem, static_cast<Index>(gap)).empty()) return std::nullopt;
  GoverningLevel level = governing_level(row->problem, row->response, static_cast<Index>(gap));
  if (!run.c.analysis.both_ways) level.gap_needed_reversed.reset();
  return level;
}

}  // namespace bentur
