#include <utility>

#include "bentur/structure/plan/plan_masses.h"

namespace bentur {

PlanPoint centre_of_mass(const Plan& plan, Eigen::Index floor) {
  return plan.centres_of_mass.empty()
             ? plan.footprint.middle()
             : plan.centres_of_mass[plan.centres_of_mass.size() == 1 ? 0 : static_cast<std::size_t>(floor)];
}

double inertia_of(const Plan& plan, Eigen::Index floor) {
  return plan.inertias.empty() ? plan.masses[floor] * plan.footprint.radius2() : plan.inertias[floor];
}

Plan with_masses_moved(Plan plan, const PlanPoint& parts) {
  std::vector<PlanPoint> moved;
  for (Eigen::Index f = 0; f < std::ssize(plan.masses); ++f) {
    moved.push_back(centre_of_mass(plan, f) + parts.cwiseProduct(plan.footprint.size));
  }
  plan.centres_of_mass = std::move(moved);
  plan.accidental_eccentricity = parts;
  return plan;
}

std::vector<Plan> with_masses_elsewhere(const Plan& plan) {
  std::vector<Plan> all;
  const double part = plan.eccentricity_both_ways;
  if (part == 0) return all;
  for (const PlanPoint& parts : {PlanPoint(part, 0), PlanPoint(-part, 0), PlanPoint(0, part), PlanPoint(0, -part)}) {
    all.push_back(with_masses_moved(plan, parts));
  }
  return all;
}

}  // namespace bentur
