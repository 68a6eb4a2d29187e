#include "bentur/structure/body.h"

#include "bentur/structure/frame/infill.h"

namespace bentur {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Course = Outputs::Course;

/// Storey shears of what yields: of a storey its own force, of hinges what they push on all that is above.
MatrixXd shears_of_forces(const Building& building, Index forces) {
  MatrixXd shears = MatrixXd::Zero(building.model.floors(), forces);
  Index force = 0;
  for (const BuildingElement& element : building.elements) shears(element.storey, force++) = 1.0;
  for (const CoupledElement& element : building.coupled) {
    shears.middleCols(force, element.rows.rows()) = above_storeys(building.model) * element.rows.transpose();
    force += element.rows.rows();
  }
  return shears;
}

/// Of the forces of hinges, which are the last ones.
MatrixXd of_hinges(const MatrixXd& rows, Index forces) {
  MatrixXd all = MatrixXd::Zero(rows.rows(), forces);
  all.rightCols(rows.cols()) = rows;
  return all;
}

}  // namespace

Body body_of(const Building& building) {
  const StructuralModel& model = building.model;
  const Hinges& hinges = model.hinges;
  const Index floors = model.floors(), columns = model.column_forces.rows();
  const Index hinge_count = std::ssize(hinges.places), breaking = std::ssize(hinges.columns);
  Index forces = std::ssize(building.elements);
  for (const CoupledElement& element : building.coupled) forces += element.rows.rows();

  const MatrixXd unit = MatrixXd::Identity(model.dofs(), model.dofs());
  MatrixXd drifts = drift_rows(model);
  for (Index f = 0; f < floors; ++f) {
    if (model.storey_heights[f] > 0.0) drifts.row(f) /= model.storey_heights[f];
  }
  const Course of_storeys = building.storeys_yield() ? Course::along : Course::none;
  MatrixXd foundation(0, model.dofs()), springs = foundation, dashpots = foundation;
  if (const auto& on_soil = model.foundation) {
    const auto rows = [&](double sway, double rocking) -> MatrixXd {
      MatrixXd both(2, model.dofs());
      both << sway * unit.row(on_soil->sway), rocking * unit.row(on_soil->rocking);
      return both;
    };
    foundation = rows(1, 1);
    springs = rows(on_soil->under_sway.stiffness, on_soil->under_rocking.stiffness);
    dashpots = rows(on_soil->under_sway.damping, on_soil->under_rocking.damping);
  }

  const Index panels = std::ssize(model.infills);
  MatrixXd infill = MatrixXd::Zero(panels, model.dofs()), of_infill = MatrixXd::Zero(panels, forces);
  for (Index n = 0; n < panels; ++n) {
    infill.row(n) = model.infills[n].stiffness * drift_rows(model).row(model.first_storey() + model.infills[n].storey);
  }
  for (Index e = 0; e < std::ssize(building.elements); ++e) {
    if (building.elements[e].infill) of_infill(*building.elements[e].infill, e) = 1.0;
  }
  // What a strut adds to the shear that a column beside it bears.
  const MatrixXd breaking_rows = hinges.rows.bottomRows(breaking);
  const MatrixXd of_breaking = of_hinges(hinges.stiffness.bottomRows(breaking), forces);
  const std::vector<StrutOnColumn> pushes = struts_on_columns(model.infills, hinges);
  MatrixXd on_columns = MatrixXd::Zero(std::ssize(pushes), model.dofs());
  MatrixXd of_pushes = MatrixXd::Zero(std::ssize(pushes), forces);
  Eigen::VectorXd before_pushes = Eigen::VectorXd::Zero(std::ssize(pushes));
  for (Index n = 0; n < std::ssize(pushes); ++n) {
    const auto& [panel, column] = pushes[n];
    on_columns.row(n) = infill.row(panel) + breaking_rows.row(column);
    of_pushes.row(n) = of_infill.row(panel) + of_breaking.row(column);
    before_pushes(n) = hinges.at_rest(hinge_count + column);
  }

  Body body{.name = building.name,
            .modes = building.modes,
            .modal_damping = building.modal_damping,
            .mass = model.mass,
            .stiffness = model.stiffness,
            .load = model.load,
            .elements = building.elements,
            .coupled = building.coupled,
            .tangent_damping = building.tangent_damping};
  body.outputs = {
      {.kind = OutputKind::displacement,
       .count = floors,
       .rows = unit.topRows(floors),
       .has_peak = true,
       .course = Course::followed},
      {.kind = OutputKind::drift_ratio, .count = floors, .rows = drifts, .has_peak = true, .course = of_storeys},
      {.kind = OutputKind::storey_shear,
       .count = floors,
       .rows = shear_rows(model),
       .forces = shears_of_forces(building, forces),
       .has_peak = true,
       .course = of_storeys},
      {.kind = OutputKind::column_force,
       .count = columns,
       .rows = model.column_forces,
       .has_peak = true,
       .course = Course::along},
      {.kind = OutputKind::hinge_moment,
       .count = hinge_count,
       .rows = hinges.rows.topRows(hinge_count),
       .forces = of_hinges(hinges.stiffness.topRows(hinge_count), forces),
       .at_rest = hinges.at_rest.head(hinge_count),
       .has_peak = true,
       .course = Course::along},
      {.kind = OutputKind::foundation,
       .count = foundation.rows(),
       .rows = foundation,
       .has_peak = true,
       .course = Course::along},
      {.kind = OutputKind::velocity, .count = floors, .rates = unit.topRows(floors)},
      {.kind = OutputKind::acceleration, .count = floors, .absolute = unit.topRows(floors), .has_peak = true},
      {.kind = OutputKind::node,
       .count = model.nodes(),
       .rows = unit.middleRows(floors, model.nodes()),
       .course = Course::along},
      {.kind = OutputKind::hinge_rotation,
       .count = hinge_count,
       .forces = of_hinges(-MatrixXd::Identity(hinge_count, hinge_count + breaking), forces),
       .has_peak = !hinges.backbones.empty(),  // of others their law knows it
       .course = Course::along},
      {.kind = OutputKind::breaking_shear,
       .count = breaking,
       .rows = breaking_rows,
       .forces = of_breaking,
       .at_rest = hinges.at_rest.tail(breaking),
       .has_peak = true},
      {.kind = OutputKind::infill_force, .count = panels, .rows = infill, .forces = of_infill, .has_peak = true},
      {.kind = OutputKind::foundation_force,
       .count = foundation.rows(),
       .rows = springs,
       .rates = dashpots,
       .course = Course::along},
      {.kind = OutputKind::infill_push,
       .count = std::ssize(pushes),
       .rows = on_columns,
       .forces = of_pushes,
       .at_rest = before_pushes,
       .has_peak = true},
  };
  if (hinges.size() > 0 && columns > 0) {
    body.outputs[static_cast<std::size_t>(OutputKind::column_force)].forces = of_hinges(-hinges.column_forces, forces);
  }
  return body;
}

}  // namespace bentur
