#include "bentur/pounding/plan/plan_problem.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "bentur/contact/laws/rubbing.h"
#include "bentur/core/errors.h"
#include "bentur/structure/plan/plan_body.h"

namespace bentur {
namespace {

using Eigen::Index;

void require_that(bool ok, const std::string& parameter, const std::string& value, const std::string& rule) {
  if (!ok) throw InvalidParameter(parameter, value, rule);
}

constexpr double most_of_a_time = 1e15;  // times in the whole analysis: of more no phase is left in a double [-]

void check_building(const PlanBuilding& building, double duration) {
  const Index dofs = building.model.dofs();
  require_that(building.model.floors() > 0 && building.model.mass.rows() == dofs &&
                   building.model.stiffness.rows() == dofs && building.model.load.rows() == dofs &&
                   building.modes.shapes.rows() == dofs &&
                   building.modes.shapes.cols() == building.modes.omega.size() &&
                   building.modal_damping.rows() == building.modes.omega.size(),
               "buildings", building.name, "must have a floor, and matrices of one size");
  const double fastest = building.is_rigid() ? 0.0 : building.modes.omega.maxCoeff();
  require_that(building.modes.omega.allFinite() && building.modes.shapes.allFinite() &&
                   building.modal_damping.allFinite() && fastest * duration <= most_of_a_time &&
                   building.modal_damping.norm() * duration <= most_of_a_time,
               "buildings", building.name, "must have modes and damping of at most 1e15 over the duration");
}

void check_initial_state(const PlanProblem& problem, const std::vector<Eigen::VectorXd>& values, const char* name) {
  require_that(values.empty() || values.size() == problem.buildings.size(), name,
               fmt::format("{} entries", values.size()), "must be empty or have one entry per building");
  for (Index b = 0; b < std::ssize(values); ++b) {
    require_that(values[b].size() == problem.buildings[b].model.dofs() && values[b].allFinite(),
                 fmt::format("{}[{}]", name, b), fmt::format("{} entries", values[b].size()),
                 "must have one finite entry per degree of freedom");
  }
}

bool moves(const GroundMotion& motion) { return !std::holds_alternative<NoMotion>(motion); }

/// The axes of those motions that move something; of the first where none does.
Eigen::Matrix2Xd axes_of(const PlanProblem& problem) {
  const bool first = moves(problem.motions[0]), second = moves(problem.motions[1]);
  if (first && second) return problem.axes;
  return problem.axes.col(second ? 1 : 0);
}

/// How far a contact's point of one side moves along a direction.
BodyRow side_of(const PlanProblem& problem, const PlanGap& gap, const PlanContact& contact, int side,
                const PlanPoint& direction) {
  const double sign = side == 0 ? 1.0 : -1.0;
  const Index building = side == 0 ? gap.left : gap.right;
  const Index floor = side == 0 ? contact.left_floor : contact.right_floor;
  const PlanPoint at = gap.stretch.on_edge(side, contact.along);
  BodyRow row{.body = building, .row = sign * problem.buildings[building].model.movement(floor, at, direction)};
  if (problem.kinematics == Kinematics::absolute) row.ground = sign * axes_of(problem).transpose() * direction;
  return row;
}

Interface interface_of(const PlanProblem& problem, const PlanGap& gap, const PlanContact& contact,
                       const PlanPoint& direction) {
  return {side_of(problem, gap, contact, 0, direction), side_of(problem, gap, contact, 1, direction)};
}

/// Points that collide without a force cannot be inside one another: no force would part them.
void check_start(const PlanProblem& problem, const PlanGap& gap, const PlanContact& contact) {
  if (!contact.law->restitution() || problem.initial_displacement.empty()) return;
  const Interface at = interface_of(problem, gap, contact, gap.stretch.normal());
  const double left = at.left.row.dot(problem.initial_displacement[gap.left]);
  const double right = -at.right.row.dot(problem.initial_displacement[gap.right]);
  require_that(!overlap(gap.stretch.width, left, right), "gaps", gap_name(problem, gap),
               "must not overlap at the start: its law has no force that would part the buildings");
}

void check_gap(const PlanProblem& problem, const PlanGap& gap) {
  const Index count = std::ssize(problem.buildings);
  require_that(gap.left >= 0 && gap.left < count && gap.right >= 0 && gap.right < count && gap.left != gap.right,
               "gaps", fmt::format("{} and {}", gap.left, gap.right), "must be between two buildings");
  const std::string name = gap_name(problem, gap);
  require_that(!problem.buildings[gap.left].is_rigid() || !problem.buildings[gap.right].is_rigid(), "gaps", name,
               "must not be between two walls");
  require_that(std::isfinite(gap.stretch.width) && gap.stretch.width >= 0 && gap.stretch.to > gap.stretch.from, "gaps",
               name, "must have a width ≥ 0 and a stretch");
  for (const PlanContact& contact : gap.contacts) {
    require_that(contact.left_floor >= 0 && contact.left_floor < problem.buildings[gap.left].model.floors() &&
                     contact.right_floor >= 0 && contact.right_floor < problem.buildings[gap.right].model.floors(),
                 "gaps", name, "must have its contacts at floors of both buildings");
    require_that(contact.law != nullptr && std::isfinite(contact.along), "gaps", name,
                 "must have a law and a place for every contact");
    require_that(contact.rubbing == nullptr || &contact.rubbing->normal() == contact.law.get(), "gaps", name,
                 "must rub with the law of the contact");
  }
}

void check_motion(const GroundMotion& motion, double duration) {
  if (const auto* sampled = std::get_if<SampledMotion>(&motion)) {
    require_that(std::isfinite(sampled->time_step) && sampled->time_step * most_of_a_time >= duration, "motions",
                 fmt::format("{}", sampled->time_step), "must have a step of at least 1e-15 of the duration");
  }
  if (const auto* harmonic = std::get_if<HarmonicMotion>(&motion)) {
    require_that(std::isfinite(harmonic->period) && harmonic->period * most_of_a_time >= duration &&
                     std::isfinite(peak_acceleration(motion)),
                 "motions", fmt::format("{}", harmonic->period),
                 "must have a period of at least 1e-15 of the duration and a finite acceleration");
  }
}

}  // namespace

std::string gap_name(const PlanProblem& problem, const PlanGap& gap) {
  const auto [first, second] = std::minmax(gap.left, gap.right);
  return problem.buildings.at(first).name + " | " + problem.buildings.at(second).name;
}

void validate(const PlanProblem& problem) {
  require_that(!problem.buildings.empty(), "buildings", "none", "must not be empty");
  require_that(std::isfinite(problem.duration) && problem.duration > 0, "duration", fmt::format("{}", problem.duration),
               "must be finite and > 0");
  for (const PlanBuilding& building : problem.buildings) check_building(building, problem.duration);
  for (const PlanGap& gap : problem.gaps) check_gap(problem, gap);
  for (const GroundMotion& motion : problem.motions) check_motion(motion, problem.duration);
  require_that(problem.delays.empty() || problem.delays.size() == problem.buildings.size(), "delays",
               fmt::format("{} entries", problem.delays.size()), "must be empty or have one entry per building");
  for (const double delay : problem.delays) {
    require_that(std::isfinite(delay) && delay >= 0, "delays", fmt::format("{}", delay), "must be finite and ≥ 0");
  }
  check_initial_state(problem, problem.initial_displacement, "initial_displacement");
  check_initial_state(problem, problem.initial_velocity, "initial_velocity");
  for (const PlanGap& gap : problem.gaps) {
    for (const PlanContact& contact : gap.contacts) check_start(problem, gap, contact);
  }
}

System system_of(const PlanProblem& problem) {
  System system;
  const Eigen::Matrix2Xd axes = axes_of(problem);
  for (const PlanBuilding& building : problem.buildings) system.bodies.push_back(body_of(building, axes));
  for (const PlanGap& gap : problem.gaps) {
    for (const PlanContact& contact : gap.contacts) {
      const auto along = [&](const PlanPoint& direction) {
        Interface at = interface_of(problem, gap, contact, direction);
        if (gap.left > gap.right) std::swap(at.left, at.right);  // δ is their sum: bodies go in their order
        return at;
      };
      const Interface at = along(gap.stretch.normal());
      if (contact.rubbing) {
        system.rubbing.push_back({at, along(gap.stretch.tangent()), contact.rubbing, gap.stretch.width});
      } else {
        system.contacts.push_back({at, contact.law, gap.stretch.width});
      }
      Interface& reversed = system.watched_free.emplace_back(at);
      for (BodyRow* side : {&reversed.left, &reversed.right}) {
        side->row *= -1.0;
        side->ground *= -1.0;
      }
    }
  }
  for (const GroundMotion& motion : problem.motions) {
    if (moves(motion)) system.motions.push_back(motion);
  }
  if (system.motions.empty()) system.motions.push_back(NoMotion{});
  system.delays = problem.delays;
  system.initial_displacement = problem.initial_displacement;
  system.initial_velocity = problem.initial_velocity;
  system.duration = problem.duration;
  return system;
}

}  // namespace bentur
