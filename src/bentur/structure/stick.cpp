#include "bentur/structure/stick.h"

#include <cmath>
#include <numeric>

#include "bentur/core/errors.h"
#include "bentur/core/require.h"
#include "bentur/elements/kinematic_hardening.h"
#include "bentur/elements/peak_oriented.h"

namespace bentur {

StructuralModel stick_model(const Stick& stick, double base_elevation) {
  const std::size_t floors = stick.storey_heights.size();
  if (floors == 0) throw InvalidParameter("storey_heights", "an empty list", "must have at least one entry");
  require_size("masses", stick.masses.size(), floors);
  require_size("stiffnesses", stick.stiffnesses.size(), floors);
  require_finite("base_elevation", base_elevation);
  for (std::size_t i = 0; i < floors; ++i) {
    require_positive(indexed("storey_heights", i), stick.storey_heights[i]);
    require_positive(indexed("masses", i), stick.masses[i]);
    require_positive(indexed("stiffnesses", i), stick.stiffnesses[i]);
  }

  StructuralModel model;
  const Eigen::Index n = std::ssize(stick.masses);
  model.storey_heights = stick.storey_heights;
  model.elevations.resize(floors);
  std::partial_sum(stick.storey_heights.begin(), stick.storey_heights.end(), model.elevations.begin());
  for (double& elevation : model.elevations) elevation += base_elevation;
  model.load = Eigen::Map<const Eigen::VectorXd>(stick.masses.data(), n);
  model.mass = model.load.asDiagonal();
  model.floor_masses = stick.masses;
  model.stiffness = Eigen::MatrixXd::Zero(n, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const double k = stick.stiffnesses[i];
    model.stiffness(i, i) += k;
    if (i > 0) {
      model.stiffness(i - 1, i - 1) += k;
      model.stiffness(i, i - 1) -= k;
      model.stiffness(i - 1, i) -= k;
    }
  }
  return model;
}

std::vector<std::shared_ptr<const HystereticLaw>> storey_laws(const Stick& stick, const StructuralModel& model) {
  const std::vector<double>& forces = stick.yield_forces;
  if (forces.empty()) return {};
  const Eigen::Index n = model.floors();
  require_size("stiffnesses", stick.stiffnesses.size(), n);
  if (forces.size() != 1) require_size("yield_forces", forces.size(), n);
  if (stick.hardening.size() > 1) require_size("hardening", stick.hardening.size(), n);
  const double scale = model.stiffness(n - 1, n - 1) / stick.stiffnesses.back();  // the top storey's stiffness alone
  std::vector<std::shared_ptr<const HystereticLaw>> laws(stick.stiffnesses.size());
  bool any = false;
  for (std::size_t j = 0; j < laws.size(); ++j) {
    const double force = forces[forces.size() == 1 ? 0 : j];
    if (force > 0 && std::isinf(force)) continue;
    const double k = scale * stick.stiffnesses[j];
    const double r = stick.hardening.empty() ? 0 : stick.hardening[stick.hardening.size() == 1 ? 0 : j];
    any = true;
    if (stick.hysteresis == Hysteresis::bilinear) {
      laws[j] = std::make_shared<KinematicHardening>(k, force, r);
    } else {
      laws[j] = std::make_shared<PeakOriented>(k, force, r, stick.unloading_exponent);
    }
  }
  if (!any) laws.clear();
  return laws;
}

}  // namespace bentur
