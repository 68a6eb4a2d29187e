#include "bentur/structure/known/generic.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <numeric>

#include "bentur/core/errors.h"
#include "bentur/core/require.h"
#include "bentur/elements/kinematic_hardening.h"
#include "bentur/structure/frame/condensation.h"
#include "bentur/structure/modes.h"

namespace bentur {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double pure_shear = 30;  // α from which on bending is left out

/// Stiffness of a cantilever beam of EI = 1 over sways and rotations of its floors (2-48).
MatrixXd beam_stiffness(const std::vector<double>& heights) {
  const Index n = std::ssize(heights);
  MatrixXd k = MatrixXd::Zero(2 * n, 2 * n);
  for (Index storey = 0; storey < n; ++storey) {
    const double l = heights[storey];
    Eigen::Matrix4d element;
    element << 12, 6 * l, -12, 6 * l,         //
        6 * l, 4 * l * l, -6 * l, 2 * l * l,  //
        -12, -6 * l, 12, -6 * l,              //
        6 * l, 2 * l * l, -6 * l, 4 * l * l;
    element /= l * l * l;
    const Index dofs[] = {storey - 1, n + storey - 1, storey, n + storey};
    for (Index i = storey > 0 ? 0 : 2; i < 4; ++i) {
      for (Index j = storey > 0 ? 0 : 2; j < 4; ++j) k(dofs[i], dofs[j]) += element(i, j);
    }
  }
  return k;
}

MatrixXd chain_stiffness(const std::vector<double>& heights) {
  const Index n = std::ssize(heights);
  MatrixXd k = MatrixXd::Zero(n, n);
  for (Index storey = 0; storey < n; ++storey) {
    const double spring = 1 / heights[storey];
    k(storey, storey) += spring;
    if (storey == 0) continue;
    k(storey - 1, storey - 1) += spring;
    k(storey, storey - 1) -= spring;
    k(storey - 1, storey) -= spring;
  }
  return k;
}

}  // namespace

StructuralModel generic_model(const GenericBuilding& building, double base_elevation) {
  const Index n = std::ssize(building.storey_heights);
  if (n == 0) throw InvalidParameter("storeys", "0", "must be at least 1");
  require_size("floor_mass", building.floor_masses.size(), n);
  for (Index i = 0; i < n; ++i) {
    require_positive(indexed("storey_height", i), building.storey_heights[i]);
    require_positive(indexed("floor_mass", i), building.floor_masses[i]);
  }
  double period = building.period;
  if (const auto& formula = building.period_formula) {
    const double height = std::accumulate(building.storey_heights.begin(), building.storey_heights.end(), 0.0);
    period = formula->coefficient * std::pow(height / formula->metre, formula->exponent);
  }
  require_positive("period", period);
  require_not_negative("stiffness_ratio", building.stiffness_ratio);
  require_finite("base_elevation", base_elevation);
  StructuralModel model;
  model.storey_heights = building.storey_heights;
  model.elevations = floor_elevations(building.storey_heights, base_elevation);
  const double height = floor_elevations(building.storey_heights).back();
  model.load = Eigen::Map<const VectorXd>(building.floor_masses.data(), n);
  model.mass = model.load.asDiagonal();
  model.floor_masses = building.floor_masses;
  const double alpha = building.stiffness_ratio;
  const double shear = alpha * alpha / (height * height);  // GA of EI = 1
  if (alpha >= pure_shear) {
    model.stiffness = chain_stiffness(building.storey_heights);
  } else {
    StructuralModel beam = model;
    beam.stiffness = beam_stiffness(building.storey_heights);
    beam.mass = MatrixXd::Zero(2 * n, 2 * n);
    beam.mass.topLeftCorner(n, n) = model.mass;
    beam.load = VectorXd::Zero(2 * n);
    beam.load.head(n) = model.load;
    model.stiffness = condense_statically(beam, n).stiffness + shear * chain_stiffness(building.storey_heights);
  }
  const double omega = modes(model.mass, model.stiffness).omega(0);
  const double wanted = 2 * std::numbers::pi / period;
  model.stiffness *= wanted * wanted / (omega * omega);
  return model;
}

std::vector<std::shared_ptr<const HystereticLaw>> storey_laws(const GenericBuilding& building,
                                                              const StructuralModel& model, double gravity) {
  if (!building.yield_base_shear) return {};
  require_positive("yield_base_shear", *building.yield_base_shear);
  if (!(building.stiffness_ratio >= pure_shear)) {
    throw InvalidParameter(
        "stiffness_ratio", fmt::format("{}", building.stiffness_ratio),
        "must be 30 at least where yield_base_shear is given: shear springs yield, bending does not; give 30, or the "
        "building as building.stick with yield_forces, which shears alone too, or as building.frame with "
        "moment_capacity, which bends");
  }
  if (model.nodes() > 0) {  // laws are of storeys, whatever is struck in them
    StructuralModel bare = generic_model(building);
    bare.stiffness *= model.stiffness_factor.value_or(1);
    return storey_laws(building, bare, gravity);
  }
  const VectorXd shape = modes(model.mass, model.stiffness).shapes.col(0);
  const VectorXd shears = shear_rows(model).leftCols(model.floors()) * shape;
  const double base = *building.yield_base_shear * gravity * model.load.sum();
  std::vector<std::shared_ptr<const HystereticLaw>> laws;
  const MatrixXd rows = shear_rows(model);
  for (Index f = 0; f < model.floors(); ++f) {
    laws.push_back(std::make_shared<KinematicHardening>(rows(f, f), base * shears(f) / shears(0), building.hardening));
  }
  return laws;
}

}  // namespace bentur
