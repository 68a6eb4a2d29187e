#include "bentur/structure/plan/plan_checks.h"

#include <cmath>

#include "bentur/core/errors.h"
#include "bentur/core/require.h"
#include "bentur/structure/plan/footprint_parts.h"
#include "bentur/structure/plan/plan_masses.h"

namespace bentur {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

void check_point(const std::string& name, const PlanPoint& at) {
  require_finite(name, at.x());
  require_finite(name, at.y());
}

/// One value for all or one per storey.
void check_list(const std::string& name, const std::vector<double>& list, Index storeys) {
  if (list.size() > 1) require_size(name, list.size(), storeys);
  for (std::size_t i = 0; i < list.size(); ++i) require_not_negative(indexed(name, i), list[i]);
}

void check_floors(const Plan& plan) {
  const Index floors = std::ssize(plan.storey_heights);
  if (floors == 0) throw InvalidParameter("storey_heights", "an empty list", "must have at least one entry");
  require_size("masses", plan.masses.size(), floors);
  if (plan.centres_of_mass.size() > 1) require_size("centres_of_mass", plan.centres_of_mass.size(), floors);
  if (!plan.inertias.empty()) require_size("inertias", plan.inertias.size(), floors);
  for (Index i = 0; i < floors; ++i) {
    require_positive(indexed("storey_heights", i), plan.storey_heights[i]);
    require_positive(indexed("masses", i), plan.masses[i]);
    if (!plan.inertias.empty()) require_positive(indexed("inertias", i), plan.inertias[i]);
    if (!plan.footprint.contains(centre_of_mass(plan, i))) {
      throw InvalidParameter(indexed("centres_of_mass", i), "", "must be inside the footprint");
    }
  }
}

void check_matrix(const std::string& name, const MatrixXd& stiffness, Index floors) {
  if (stiffness.rows() != floors || stiffness.cols() != floors || !stiffness.allFinite()) {
    throw InvalidParameter(name, "", "must be finite, of as many floors as the building");
  }
}

/// Modes are of a building with these masses on a base that does not move.
void check_stands_as_given(const Plan& plan) {
  const auto refuse = [](const char* key) {
    throw InvalidParameter(key, "beside modes",
                           "must not be given: a building known by its modes stands as it is given");
  };
  if (!plan.planes.empty()) refuse("planes");
  if (plan.rigidity) refuse("rigidity");
  if (plan.cantilever) refuse("cantilever");
  if (plan.known) refuse("known");
  if (!plan.gravity_loads.empty()) refuse("gravity_loads");
  if (plan.soil) refuse("soil");
  if (plan.isolation) refuse("isolation");
  if (plan.eccentricity_both_ways > 0 || !plan.accidental_eccentricity.isZero()) refuse("accidental_eccentricity");
}

void check_holds(const Plan& plan) {
  const Index floors = std::ssize(plan.storey_heights);
  for (const PlanPlane& plane : plan.planes) {
    check_point("through", plane.through);
    if (!(std::abs(plane.direction.norm() - 1) <= 1e-12)) {
      throw InvalidParameter("direction", plane.name, "must be of length 1");
    }
    require_size("stiffnesses", plane.storeys.stiffnesses.size(), floors);
    check_list("stiffnesses", plane.storeys.stiffnesses, floors);
    if (!plane.is_frame()) continue;
    const Index sways = floors + plane.nodes.count();
    check_matrix("sway_stiffness", plane.sway_stiffness, sways);
    if (plane.hinges.size() > 0 && plane.hinges.rows.cols() != sways) {
      throw InvalidParameter("hinges", plane.name,
                             "must be over as many sways as the building has floors and the frame nodes");
    }
  }
  if (plan.cantilever) {
    check_point("cantilever", plan.cantilever->at);
    for (const MatrixXd* const one : {&plan.cantilever->x, &plan.cantilever->y, &plan.cantilever->torsion}) {
      check_matrix("cantilever", *one, floors);
    }
  }
  if (plan.known) {
    check_matrix("known", plan.known->matrix, 3 * floors);
    require_size("at", plan.known->at.size(), floors);
    for (const PlanPoint& at : plan.known->at) check_point("at", at);
  }
  if (plan.rigidity) {
    const PlanRigidity& rigidity = *plan.rigidity;
    if (rigidity.centres.size() != 1) require_size("centre", rigidity.centres.size(), floors);
    for (const PlanPoint& centre : rigidity.centres) check_point("centre", centre);
    check_list("x", rigidity.x, floors);
    check_list("y", rigidity.y, floors);
    check_list("torsion", rigidity.torsion, floors);
  }
  if (plan.modes) {
    check_stands_as_given(plan);
    return;
  }
  if (const std::vector<UnheldStorey> found = unheld_storeys(plan); !found.empty()) {
    throw InvalidParameter("planes", "storey " + std::to_string(found.front().storey + 1),
                           "must hold it: nothing does in " + std::string(found.front().direction));
  }
}

}  // namespace

void check_footprint(const Footprint& footprint) {
  check_point("corner", footprint.corner);
  require_positive("size", footprint.size.x());
  require_positive("size", footprint.size.y());
  if (footprint.polygon.empty()) return;
  if (const auto fault = fault_of_outline(footprint.polygon)) throw InvalidParameter("polygon", "", *fault);
  for (std::size_t i = 0; i < footprint.rings.size(); ++i) {
    auto fault = fault_of_outline(footprint.rings[i]);
    const bool is_part = area_of(footprint.rings[i]) > 0;
    if (!fault) fault = is_part ? fault_of_part(footprint, i) : fault_of_court(footprint, i);
    if (fault) throw InvalidParameter(indexed(is_part ? "parts" : "courts", i), "", *fault);
  }
}

void check_plan(const Plan& plan) {
  check_footprint(plan.footprint);
  check_floors(plan);
  check_holds(plan);
}

}  // namespace bentur
