#include "bentur/structure/plan/plan_generic.h"

#include <algorithm>
#include <numbers>
#include <utility>

#include "bentur/core/require.h"
#include "bentur/structure/modes.h"
#include "bentur/structure/plan/plan_masses.h"

namespace bentur {
namespace {

/// Of the same building with these masses and this first period.
Eigen::MatrixXd stiffness_of(GenericBuilding building, std::vector<double> masses, double period) {
  building.floor_masses = std::move(masses);
  building.period = period;
  building.period_formula.reset();
  return generic_model(building).stiffness;
}

}  // namespace

void stand_generic(const GenericPlan& generic, Plan& plan) {
  const GenericBuilding& known = generic.along_x;
  const StructuralModel along_x = generic_model(known);
  require_positive("torsion_ratio", generic.torsion_ratio);
  plan.storey_heights = known.storey_heights;
  plan.masses = known.floor_masses;
  if (plan.centres_of_mass.size() > 1) require_size("centres_of_mass", plan.centres_of_mass.size(), along_x.floors());
  if (!plan.inertias.empty()) require_size("inertias", plan.inertias.size(), along_x.floors());
  PlanCantilever cantilever{.at = generic.eccentricity, .x = along_x.stiffness, .y = along_x.stiffness, .torsion = {}};
  std::vector<double> inertias;
  double mass = 0;
  PlanPoint moment = PlanPoint::Zero();
  for (Eigen::Index f = 0; f < along_x.floors(); ++f) {
    inertias.push_back(inertia_of(plan, f));
    mass += known.floor_masses[f];
    moment += known.floor_masses[f] * centre_of_mass(plan, f);
  }
  cantilever.at += moment / mass;
  double longest = 2 * std::numbers::pi / modes(along_x.mass, along_x.stiffness).omega(0);
  if (generic.period_y) {
    require_positive("period_y", *generic.period_y);
    longest = std::max(longest, *generic.period_y);
    cantilever.y = stiffness_of(known, known.floor_masses, *generic.period_y);
  }
  cantilever.torsion = stiffness_of(known, std::move(inertias), longest / generic.torsion_ratio);
  plan.cantilever = std::move(cantilever);
}

}  // namespace bentur
