#include "bentur/model/closer/frame_forces.h"

#include "bentur/model/closer/nearest_floor.h"

namespace bentur {

using Eigen::Index;
using Eigen::MatrixXd;

std::optional<MemberForces> forces_of(const PlaneFrame& frame, const Building& building) {
  const Hinges& hinges = building.model.hinges;
  if (!hinges.columns.empty() || !MemberForces::knows(frame, hinges.places)) return std::nullopt;
  PlaneFrame as_it_is = frame;
  as_it_is.elastic_modulus *= building.model.stiffness_factor.value_or(1);
  return MemberForces(as_it_is, hinges.places);
}

MatrixXd frame_sways(const Histories& histories, const PlaneFrame& frame, const Problem& problem, Index building) {
  const StructuralModel& model = problem.buildings[building].model;
  const MatrixXd all = dof_histories(histories, problem, building);
  const Index floors = std::ssize(frame.storey_heights), nodes = model.nodes(), first = model.first_storey();
  MatrixXd sways(floors + nodes, all.cols());
  sways << all.middleRows(first, floors), all.middleRows(model.floors(), nodes);
  if (model.slab) sways.rowwise() -= all.row(*model.slab);
  if (!model.foundation) return sways;
  if (!model.slab) sways.rowwise() -= all.row(model.foundation->sway);
  const std::vector<double> levels = floor_elevations(frame.storey_heights);
  for (Index i = 0; i < floors + nodes; ++i) {
    const double height = i < floors ? levels[i] : frame.nodes[i - floors].elevation;
    sways.row(i) -= height * all.row(model.foundation->rocking);
  }
  return sways;
}

}  // namespace bentur
