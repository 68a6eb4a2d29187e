#include "bentur/structure/building.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numeric>
#include <utility>

#include "bentur/core/errors.h"
#include "bentur/core/require.h"
#include "bentur/elements/hinges.h"
#include "bentur/elements/softening/strut_pair.h"
#include "bentur/structure/damping.h"
#include "bentur/structure/frame/frame_hinges.h"
#include "bentur/structure/modes.h"

namespace bentur {

std::vector<double> floor_elevations(const std::vector<double>& storey_heights, double base_elevation) {
  std::vector<double> elevations(storey_heights.size());
  std::partial_sum(storey_heights.begin(), storey_heights.end(), elevations.begin());
  for (double& elevation : elevations) elevation += base_elevation;
  return elevations;
}

Building make_building(std::string name, StructuralModel model, const Damping& damping) {
  Modes free_modes = modes(model.mass, model.stiffness);
  Eigen::MatrixXd c = modal_damping(damping, free_modes);
  Building building{std::move(name), std::move(model), std::move(free_modes), std::move(c)};
  add_infill(building.model, building.elements);
  building.coupled = hinge_elements(building.model);
  return building;
}

namespace {

constexpr std::array<std::string_view, 5> hinge_ends = {"bottom", "node", "top", "left", "right"};

}  // namespace

std::string_view word_of(HingePlace::End end) { return hinge_ends[static_cast<std::size_t>(end)]; }

HingePlace::End hinge_end(std::string_view word) {
  const auto found = std::find(hinge_ends.begin(), hinge_ends.end(), word);
  if (found == hinge_ends.end()) throw InvalidParameter("end", std::string(word), "must be an end of a member");
  return static_cast<HingePlace::End>(found - hinge_ends.begin());
}

bool Building::can_lose_strength() const {
  return std::any_of(elements.begin(), elements.end(),
                     [](const BuildingElement& element) { return !element.infill && element.law->loss({}, 0); });
}

const HystereticLaw* Building::storey_law(Eigen::Index storey) const {
  const auto found = std::find_if(elements.begin(), elements.end(),
                                  [&](const BuildingElement& one) { return !one.infill && one.storey == storey; });
  return found == elements.end() ? nullptr : found->law.get();
}

std::vector<BuildingElement> storey_elements(const StructuralModel& model,
                                             const std::vector<std::shared_ptr<const HystereticLaw>>& laws) {
  if (laws.empty()) return {};
  require_size("laws", laws.size(), model.floors());
  const Eigen::MatrixXd drifts = drift_rows(model);
  std::vector<BuildingElement> elements;
  for (Eigen::Index storey = 0; storey < model.floors(); ++storey) {
    if (laws[storey]) elements.push_back({drifts.row(storey), laws[storey], storey});
  }
  return elements;
}

std::optional<BuildingElement> infill_element(const InfillPanel& panel, Eigen::VectorXd drift, Eigen::Index storey,
                                              Eigen::Index number) {
  if (std::isinf(panel.backbone.yield)) return std::nullopt;
  return BuildingElement{std::move(drift), std::make_shared<StrutPair>(panel.stiffness, panel.backbone), storey,
                         number};
}

void add_infill(const StructuralModel& model, std::vector<BuildingElement>& elements) {
  const Eigen::MatrixXd drifts = drift_rows(model);
  for (std::size_t n = 0; n < model.infills.size(); ++n) {
    const Eigen::Index storey = model.first_storey() + model.infills[n].storey;
    auto element = infill_element(model.infills[n], drifts.row(storey), storey, static_cast<Eigen::Index>(n));
    if (element) elements.push_back(*std::move(element));
  }
}

CoupledElement element_of(const Hinges& hinges) {
  check_backbones(hinges);
  return {hinges.rows, std::make_shared<HingeLaw>(HingeLaw::Parameters{.stiffness = hinges.stiffness,
                                                                       .hardening = hinges.hardening,
                                                                       .upper = hinges.clockwise - hinges.at_rest,
                                                                       .lower = hinges.anticlockwise + hinges.at_rest,
                                                                       .rows = hinges.rows,
                                                                       .kept = hinges.kept,
                                                                       .backbones = hinges.backbones,
                                                                       .frame_stiffness = hinges.frame_stiffness,
                                                                       .frame_rows = hinges.frame_rows})};
}

std::vector<CoupledElement> hinge_elements(const StructuralModel& model) {
  if (model.hinges.size() == 0) return {};
  return {element_of(model.hinges)};
}

Eigen::MatrixXd drift_rows(const StructuralModel& model) {
  if (model.drifts.size() > 0) return model.drifts;
  const Eigen::Index floors = model.floors();
  Eigen::MatrixXd rows = Eigen::MatrixXd::Zero(floors, model.dofs());
  for (Eigen::Index f = 0; f < floors; ++f) {
    rows(f, f) = 1;
    if (f > 0) rows(f, f - 1) = -1;
  }
  return rows;
}

Eigen::MatrixXd above_storeys(const StructuralModel& model) {
  const Eigen::Index floors = model.floors();
  Eigen::MatrixXd above = Eigen::MatrixXd::Zero(floors, model.dofs());
  for (Eigen::Index f = 0; f < floors; ++f) {
    above.row(f).segment(f, floors - f).setOnes();
    const double below = f > 0 ? model.elevations[f - 1] : model.elevations[0] - model.storey_heights[0];
    for (Eigen::Index node = 0; node < model.nodes(); ++node) {
      if (model.node_elevations[node] > below) above(f, floors + node) = 1;
    }
  }
  return above;
}

Eigen::MatrixXd shear_rows(const StructuralModel& model) {
  if (model.shears.size() > 0) return model.shears;
  const Eigen::Index floors = model.floors();
  Eigen::MatrixXd rows(floors, model.dofs());
  for (Eigen::Index f = 0; f < floors; ++f) {
    rows.row(f) = model.stiffness.middleRows(f, floors - f).colwise().sum();
    for (Eigen::Index node = 0; node < model.nodes(); ++node) {  // those above the floor below
      const double below = f > 0 ? model.elevations[f - 1] : model.elevations[0] - model.storey_heights[0];
      if (model.node_elevations[node] > below) rows.row(f) += model.stiffness.row(floors + node);
    }
  }
  return rows;
}

StructuralModel::RigidBody rigid_body(const StructuralModel& model) {
  if (model.rigid_body.rocking.size() > 0) return model.rigid_body;
  const double base = model.elevations.front() - model.storey_heights.front();
  Eigen::VectorXd ones = Eigen::VectorXd::Zero(model.dofs());
  Eigen::VectorXd heights = ones;
  for (Eigen::Index f = 0; f < model.floors(); ++f) {
    ones(f) = 1;
    heights(f) = model.elevations[f] - base;
  }
  for (Eigen::Index node = 0; node < model.nodes(); ++node) {
    ones(model.floors() + node) = 1;
    heights(model.floors() + node) = model.node_elevations[node] - base;
  }
  StructuralModel::RigidBody body;
  body.rocking = model.mass * heights;
  body.mass = ones.dot(model.mass * ones);
  body.moment = ones.dot(body.rocking);
  body.inertia = heights.dot(body.rocking);
  return body;
}

}  // namespace bentur
