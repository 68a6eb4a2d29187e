#include "bentur/structure/modes.h"
#include "bentur/structure/plan/plan.h"

namespace bentur {
namespace {

void scale(std::vector<double>& list, double factor) {
  for (double& value : list) value *= factor;
}

void scale(PlanPlane& plane, double factor) {
  scale(plane.storeys.stiffnesses, factor);
  plane.sway_stiffness *= factor;
  plane.nodes.column_forces *= factor;
  plane.hinges.scale_stiffness(factor);
  for (InfillPanel& panel : plane.infills) panel.stiffness *= factor;
}

}  // namespace

void calibrate_period(Plan& plan, double first_period) {
  Plan bare = plan;
  bare.gravity_loads.clear();
  const PlanModel model = plan_model(bare);
  const double factor = calibration_factor(model.mass, model.stiffness, first_period);
  for (PlanPlane& plane : plan.planes) scale(plane, factor);
  if (plan.rigidity) {
    for (std::vector<double>* const list : {&plan.rigidity->x, &plan.rigidity->y, &plan.rigidity->torsion}) {
      scale(*list, factor);
    }
  }
  if (plan.cantilever) {
    for (Eigen::MatrixXd* const one : {&plan.cantilever->x, &plan.cantilever->y, &plan.cantilever->torsion}) {
      *one *= factor;
    }
  }
  if (plan.known) plan.known->matrix *= factor;
  plan.stiffness_factor = factor * plan.stiffness_factor.value_or(1);
}

}  // namespace bentur
