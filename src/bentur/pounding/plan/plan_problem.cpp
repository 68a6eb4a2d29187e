#include "bentur/pounding/plan/plan_problem.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "bentur/contact/laws/rubbing.h"
#include "bentur/elements/deformation_limit.h"
#include "bentur/pounding/internal/asked.h"
#include "bentur/pounding/internal/levels.h"
#include "bentur/pounding/internal/problem_checks.h"
#include "bentur/pounding/plan/no_force.h"
#include "bentur/structure/plan/plan_body.h"

namespace bentur {
namespace {

using Eigen::Index;

void check_building(const PlanBuilding& building, double duration) {
  const Index dofs = building.model.dofs();
  require(building.model.floors() > 0 && building.model.mass.rows() == dofs &&
              building.model.stiffness.rows() == dofs && building.model.load.rows() == dofs &&
              building.modes.shapes.rows() == dofs && building.modes.shapes.cols() == building.modes.omega.size() &&
              building.modal_damping.rows() == building.modes.omega.size(),
          "buildings", building.name, "must have a floor, and matrices of one size");
  const double fastest = building.is_rigid() ? 0.0 : building.modes.omega.maxCoeff();
  require(building.modes.omega.allFinite() && building.modes.shapes.allFinite() && building.modal_damping.allFinite() &&
              fastest * duration <= most_times && building.modal_damping.norm() * duration <= most_times,
          "buildings", building.name, "must have modes and damping of at most 1e15 over the duration");
}

bool moves(const GroundMotion& motion) { return !std::holds_alternative<NoMotion>(motion); }

/// The axes of those motions that move something; of the first where none does.
Eigen::Matrix2Xd axes_of(const PlanProblem& problem) {
  const bool first = moves(problem.motions[0]), second = moves(problem.motions[1]);
  if (first && second) return problem.axes;
  return problem.axes.col(second ? 1 : 0);
}

/// A place where both edges of a stretch may come near: of each building its floor, or where it has none there its edge
/// between floors, at an elevation [length].
struct EdgePlace {
  std::optional<Index> left_floor, right_floor;
  double elevation = 0;
  StretchCorner at;
};

EdgePlace place_of(const PlanGap& gap, const PlanContact& contact) {
  return {contact.left_floor, contact.right_floor, contact.elevation, gap.at(contact)};
}

EdgePlace place_of(const PlanSeam& seam) { return {seam.left_floor, seam.right_floor, seam.elevation, seam.at}; }

EdgePlace place_of(const PlanGap& gap, const PlanWatched& watched) {
  EdgePlace place{watched.floor, watched.facing_floor, watched.elevation, gap.at(watched)};
  if (watched.floor_of != gap.left) std::swap(place.left_floor, place.right_floor);
  return place;
}

/// How far the edge of one side moves there along a direction.
BodyRow side_of(const PlanProblem& problem, const PlanGap& gap, const EdgePlace& place, int side,
                const PlanPoint& direction) {
  const double sign = side == 0 ? 1.0 : -1.0;
  const Index building = side == 0 ? gap.left : gap.right;
  const std::optional<Index> floor = side == 0 ? place.left_floor : place.right_floor;
  const PlanModel& model = problem.buildings[building].model;
  const PlanPoint& at = side == 0 ? place.at.left : place.at.right;
  const double base = model.elevations.front() - model.storey_heights.front();
  const double elevation = std::clamp(place.elevation, base, model.elevations.back());
  BodyRow row{
      .body = building,
      .row = sign * (floor ? model.movement(*floor, at, direction) : model.movement_at(elevation, at, direction))};
  if (problem.kinematics == Kinematics::absolute) row.ground = sign * axes_of(problem).transpose() * direction;
  return row;
}

/// L and R in this order, which level_interfaces() keeps.
Interface interface_of(const PlanProblem& problem, const PlanGap& gap, const EdgePlace& place,
                       const PlanPoint& direction) {
  return {side_of(problem, gap, place, 0, direction), side_of(problem, gap, place, 1, direction)};
}

/// δ is the sum of both sides: bodies go in their order.
Interface in_order(Interface at) {
  if (at.right.body >= 0 && at.left.body > at.right.body) std::swap(at.left, at.right);
  return at;
}

/// Points that collide without a force cannot be inside one another: no force would part them.
void check_start(const PlanProblem& problem, const PlanGap& gap, const PlanContact& contact) {
  if (!contact.law->restitution() || problem.initial_displacement.empty() || contact.family >= 0) return;
  const EdgePlace place = place_of(gap, contact);
  const Interface at = interface_of(problem, gap, place, place.at.normal);
  const double left = at.left.row.dot(problem.initial_displacement[gap.left]);
  const double right = -at.right.row.dot(problem.initial_displacement[gap.right]);
  require(!overlap(gap.width_at(contact), left, right), "gaps", gap_name(problem, gap),
          "must not overlap at the start: its law has no force that would part the buildings");
}

void check_gap(const PlanProblem& problem, const PlanGap& gap) {
  const Index count = std::ssize(problem.buildings);
  require(gap.left >= 0 && gap.left < count && gap.right >= 0 && gap.right < count && gap.left != gap.right, "gaps",
          fmt::format("{} and {}", gap.left, gap.right), "must be between two buildings");
  const std::string name = gap_name(problem, gap);
  require(!problem.buildings[gap.left].is_rigid() || !problem.buildings[gap.right].is_rigid(), "gaps", name,
          "must not be between two walls");
  require(std::isfinite(gap.stretch.width) && gap.stretch.width >= 0 && gap.stretch.to >= gap.stretch.from, "gaps",
          name, "must have a width ≥ 0 and a stretch");
  for (const PlanContact& contact : gap.contacts) {
    const auto has = [&](Index building, Index floor_or_node) {
      const PlanModel& model = problem.buildings[building].model;
      return floor_or_node >= 0 && floor_or_node < model.floors() + std::ssize(model.nodes);
    };
    require(has(gap.left, contact.left_floor) && has(gap.right, contact.right_floor), "gaps", name,
            "must have its contacts at floors of both buildings, or nodes");
    require(contact.law != nullptr && std::isfinite(contact.along), "gaps", name,
            "must have a law and a place for every contact");
    require(contact.rubbing == nullptr || &contact.rubbing->normal() == contact.law.get(), "gaps", name,
            "must rub with the law of the contact");
  }
  for (const PlanWatched& watched : gap.watched) {
    const bool of_left = watched.floor_of == gap.left;
    require(of_left || watched.floor_of == gap.right, "gaps", name, "must watch floors of its two buildings");
    const Index own = problem.buildings[watched.floor_of].model.floors();
    const Index other = problem.buildings[of_left ? gap.right : gap.left].model.floors();
    require(watched.floor >= 0 && watched.floor < own && std::isfinite(watched.along + watched.elevation) &&
                (!watched.facing_floor || (*watched.facing_floor >= 0 && *watched.facing_floor < other)),
            "gaps", name, "must watch floors of its two buildings");
  }
}

void check_link(const PlanProblem& problem, const PlanLink& one) {
  const Link& link = one.link;
  const Index count = std::ssize(problem.buildings);
  require(link.left >= 0 && link.left < count && link.right >= 0 && link.right < count && link.left != link.right,
          "links", fmt::format("{} and {}", link.left, link.right), "must be between two buildings");
  const PlanModel &left = problem.buildings[link.left].model, &right = problem.buildings[link.right].model;
  const std::string name = problem.buildings[link.left].name + " – " + problem.buildings[link.right].name;
  require(link.left_floor >= 0 && link.left_floor < left.floors() && link.right_floor >= 0 &&
              link.right_floor < right.floors(),
          "links", name, "must be at floors of both buildings");
  require(link.law != nullptr && std::isfinite(one.along) && std::abs(one.direction.norm() - 1) <= 1e-12, "links", name,
          "must have a law, a place and a direction of length 1");
}

void check_motion(const GroundMotion& motion, double duration) {
  if (const auto* sampled = std::get_if<SampledMotion>(&motion)) {
    require(std::isfinite(sampled->time_step) && sampled->time_step * most_times >= duration, "motions",
            fmt::format("{}", sampled->time_step), "must have a step of at least 1e-15 of the duration");
  }
  if (const auto* harmonic = std::get_if<HarmonicMotion>(&motion)) {
    require(std::isfinite(harmonic->period) && harmonic->period * most_times >= duration &&
                std::isfinite(peak_acceleration(motion)),
            "motions", fmt::format("{}", harmonic->period),
            "must have a period of at least 1e-15 of the duration and a finite acceleration");
  }
}

/// The edges of storeys of buildings that gravity pulls down: an end of a run where one drifts too far along itself.
std::vector<Element> drift_limits(const PlanProblem& problem) {
  std::vector<Element> limits;
  for (Index b = 0; b < std::ssize(problem.buildings); ++b) {
    const PlanBuilding& building = problem.buildings[b];
    if (!building.has_gravity_loads()) continue;
    const PlanModel& model = building.model;
    const std::vector<PlanPoint> corners = model.footprint.corners();
    for (Index j = model.first_storey(); j < model.floors(); ++j) {
      const auto law = std::make_shared<DeformationLimit>(problem.collapse_drift * model.storey_heights[j]);
      for (std::size_t i = 0; i < corners.size(); ++i) {
        const PlanPoint edge = corners[(i + 1) % corners.size()] - corners[i];
        Element& limit = limits.emplace_back();
        limit.at.left = {.body = b, .row = model.drift(j, corners[i], edge.normalized())};
        limit.law = law;
      }
    }
  }
  return limits;
}

}  // namespace

std::optional<Collapse> collapse_of(const PlanProblem& problem, const Solution& solution) {
  if (!solution.passed) return std::nullopt;
  Index limit = solution.passed->limit;
  for (Index b = 0; b < std::ssize(problem.buildings); ++b) {
    const PlanBuilding& building = problem.buildings[b];
    if (!building.has_gravity_loads()) continue;
    const Index edges = std::ssize(building.model.footprint.corners()), first = building.model.first_storey();
    const Index limits = edges * (building.model.floors() - first);
    if (limit < limits) return Collapse{b, first + limit / edges, solution.passed->time};
    limit -= limits;
  }
  return std::nullopt;
}

std::vector<Index> places_of(const PlanProblem& problem) {
  std::vector<Index> places, rubbing;
  Index place = 0;
  for (const PlanGap& gap : problem.gaps) {
    for (const PlanContact& contact : gap.contacts) (contact.rubbing ? rubbing : places).push_back(place++);
  }
  for (const PlanGap& gap : problem.gaps) places.insert(places.end(), gap.seams.size(), -1);
  places.insert(places.end(), rubbing.begin(), rubbing.end());
  return places;
}

std::string gap_name(const PlanProblem& problem, const PlanGap& gap) {
  const auto [first, second] = std::minmax(gap.left, gap.right);
  return problem.buildings.at(first).name + " | " + problem.buildings.at(second).name;
}

std::optional<StruckColumn> struck_column(const PlanProblem& problem, const PlanGap& gap, const PlanContact& contact) {
  for (const auto& [b, at] : {std::pair(gap.left, contact.left_floor), {gap.right, contact.right_floor}}) {
    const Index node = at - problem.buildings[b].model.floors();
    if (node >= 0) return StruckColumn{b, node};
  }
  return std::nullopt;
}

Index floor_at(const PlanProblem& problem, const PlanGap& gap, const PlanContact& contact, int side) {
  const PlanModel& model = problem.buildings[side == 0 ? gap.left : gap.right].model;
  return model.floor_at_or_above(side == 0 ? contact.left_floor : contact.right_floor);
}

void validate(const PlanProblem& problem) {
  require(!problem.buildings.empty(), "buildings", "none", "must not be empty");
  require(std::isfinite(problem.duration) && problem.duration > 0, "duration", fmt::format("{}", problem.duration),
          "must be finite and > 0");
  require(std::isfinite(problem.collapse_drift) && problem.collapse_drift > 0, "collapse_drift",
          fmt::format("{}", problem.collapse_drift), "must be finite and > 0");
  for (const PlanBuilding& building : problem.buildings) check_building(building, problem.duration);
  for (const PlanGap& gap : problem.gaps) check_gap(problem, gap);
  for (const PlanLink& link : problem.links) check_link(problem, link);
  for (const GroundMotion& motion : problem.motions) check_motion(motion, problem.duration);
  check_delays(problem.delays, problem.buildings.size());
  std::vector<Index> dofs;
  for (const PlanBuilding& building : problem.buildings) dofs.push_back(building.model.dofs());
  check_initial(problem.initial_displacement, dofs, "initial_displacement");
  check_initial(problem.initial_velocity, dofs, "initial_velocity");
  const std::size_t moved = problem.elsewhere.size();
  require(moved == 0 || moved == problem.buildings.size(), "elsewhere", fmt::format("{}", moved),
          "must have a list for every building, or none");
  for (std::size_t b = 0; b < moved; ++b) {
    const std::size_t count = problem.elsewhere[b].size();
    require(count == 0 || count == 4, "elsewhere", problem.buildings[b].name, "must have four places of its masses");
    for (const PlanBuilding& one : problem.elsewhere[b]) {
      check_building(one, problem.duration);
      require(one.model.dofs() == dofs[b], "elsewhere", one.name, "must be the same building");
    }
  }
  for (const PlanGap& gap : problem.gaps) {
    for (const PlanContact& contact : gap.contacts) check_start(problem, gap, contact);
  }
}

System system_of(const PlanProblem& problem, bool levels) {
  System system;
  const Eigen::Matrix2Xd axes = axes_of(problem);
  for (const PlanBuilding& building : problem.buildings) system.bodies.push_back(body_of(building, axes));
  std::vector<Interface> faces, rubbing_faces;
  std::vector<Contact> seams;
  Index meetings = 0;
  for (const PlanGap& gap : problem.gaps) {
    std::map<std::pair<double, Index>, Index> known;  // by level and pair of parts
    const auto meeting_of = [&](const auto& one) {
      const auto [found, is_new] = known.try_emplace({one.elevation, one.pair}, meetings);
      if (is_new) ++meetings;
      return found->second;
    };
    for (const PlanContact& contact : gap.contacts) {
      const EdgePlace place = place_of(gap, contact);
      std::vector<Interface>& of_kind = contact.rubbing ? rubbing_faces : faces;
      of_kind.push_back(interface_of(problem, gap, place, place.at.normal));
      const Interface at = in_order(of_kind.back());
      MeetingPlace meets;
      if (contact.family >= 0) meets = {meeting_of(contact), contact.family};
      if (contact.rubbing) {
        const PlanPoint along(-place.at.normal.y(), place.at.normal.x());
        system.rubbing.push_back(
            {at, in_order(interface_of(problem, gap, place, along)), contact.rubbing, gap.width_at(contact), meets});
      } else {
        system.contacts.push_back({at, contact.law, gap.width_at(contact), meets});
      }
    }
    for (const PlanSeam& seam : gap.seams) {
      const EdgePlace place = place_of(seam);
      seams.push_back({interface_of(problem, gap, place, place.at.normal),
                       no_force(),
                       gap.stretch.width + seam.at.beyond,
                       {meeting_of(seam), seam.family, true}});
    }
  }
  for (Contact& seam : seams) {
    faces.push_back(seam.at);
    seam.at = in_order(std::move(seam.at));
    system.contacts.push_back(std::move(seam));
  }
  faces.insert(faces.end(), rubbing_faces.begin(), rubbing_faces.end());
  for (const PlanGap& gap : problem.gaps) {
    for (const PlanWatched& watched : gap.watched) {
      const EdgePlace place = place_of(gap, watched);
      faces.push_back(interface_of(problem, gap, place, place.at.normal));
      system.watched.push_back(in_order(faces.back()));
    }
  }
  if (levels) {
    for (Interface& one : level_interfaces(faces, [](std::size_t, int) { return false; })) {
      system.watched_free.push_back(in_order(std::move(one)));
    }
  }
  for (const GroundMotion& motion : problem.motions) {
    if (moves(motion)) system.motions.push_back(motion);
  }
  if (system.motions.empty()) system.motions.push_back(NoMotion{});
  for (const PlanLink& link : problem.links) {
    const PlanGap between{.left = link.link.left, .right = link.link.right, .stretch = link.stretch};
    const EdgePlace at{link.link.left_floor, link.link.right_floor, link.link.elevation, link.stretch.at(link.along)};
    system.joints.push_back({in_order(interface_of(problem, between, at, link.direction)), link.link.law});
  }
  system.limits = drift_limits(problem);
  system.delays = problem.delays;
  system.initial_displacement = problem.initial_displacement;
  system.initial_velocity = problem.initial_velocity;
  system.duration = problem.duration;
  return system;
}

}  // namespace bentur
