#include "bentur/structure/known/modal.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "bentur/core/algebra/symmetric.h"
#include "bentur/core/errors.h"
#include "bentur/core/require.h"

namespace bentur {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double most_product = 0.02;  // of two shapes scaled to unit modal mass [-]

}  // namespace

KnownModes known_modes(const GivenModes& given, const VectorXd& mass) {
  const Index dofs = mass.size();
  const Index count = std::ssize(given.periods);
  if (count == 0 || count > dofs) {
    throw InvalidParameter("periods", fmt::format("{} entries", count),
                           fmt::format("must have one entry per mode, 1 to {} of them", dofs));
  }
  require_size("shapes", given.shapes.size(), count);
  KnownModes known;
  std::vector<Index> order(given.periods.size());
  std::iota(order.begin(), order.end(), Index{0});
  std::stable_sort(order.begin(), order.end(), [&](Index a, Index b) { return given.periods[a] > given.periods[b]; });
  MatrixXd shapes(dofs, count);
  known.modes.omega.resize(count);
  for (Index j = 0; j < count; ++j) {
    const Index from = order[j];
    require_positive(indexed("periods", from), given.periods[from]);
    require_size(indexed("shapes", from), given.shapes[from].size(), dofs);
    shapes.col(j) = Eigen::Map<const VectorXd>(given.shapes[from].data(), dofs);
    const double modal_mass = shapes.col(j).cwiseAbs2().dot(mass);
    if (!(std::isfinite(modal_mass) && modal_mass > 0)) {
      throw InvalidParameter(indexed("shapes", from), "zero or not finite", "must have a floor that moves");
    }
    shapes.col(j) /= std::sqrt(modal_mass);
    known.modes.omega(j) = 2 * std::numbers::pi / given.periods[from];
  }
  const MatrixXd products = shapes.transpose() * mass.asDiagonal() * shapes;
  for (Index i = 0; i < count; ++i) {
    for (Index j = 0; j < i; ++j) {
      const double product = std::abs(products(i, j));
      known.largest_product = std::max(known.largest_product, product);
      if (product <= most_product) continue;
      throw InvalidParameter(
          "shapes", fmt::format("{:.3g} between modes {} and {}", product, order[j] + 1, order[i] + 1),
          "must be orthogonal over the masses to within 0.02: are they of these masses, the lowest floor "
          "first?");
    }
  }
  known.modes.shapes = shapes * inverse_square_root(products);
  for (Index j = 0; j < count; ++j) {
    auto shape = known.modes.shapes.col(j);
    Index first = 0;
    while (first + 1 < dofs && std::abs(shape(first)) <= 1e-12 * shape.cwiseAbs().maxCoeff()) ++first;
    if (shape(first) < 0) shape *= -1;
  }
  const MatrixXd pushed = mass.asDiagonal() * known.modes.shapes;  // M Φ
  known.stiffness = pushed * known.modes.omega.cwiseAbs2().asDiagonal() * pushed.transpose();
  const VectorXd shares = mass.cwiseProduct(known.modes.shapes.rowwise().squaredNorm());
  known.mass_shares.assign(shares.begin(), shares.end());
  return known;
}

ModalModel modal_model(const ModalBuilding& building, double base_elevation) {
  const Index floors = std::ssize(building.elevations);
  if (floors == 0) throw InvalidParameter("elevations", "an empty list", "must have at least one entry");
  require_size("masses", building.masses.size(), floors);
  require_finite("base_elevation", base_elevation);
  ModalModel result;
  StructuralModel& model = result.model;
  for (Index f = 0; f < floors; ++f) {
    const double below = f > 0 ? building.elevations[f - 1] : 0.0;
    if (!(building.elevations[f] > below)) {
      throw InvalidParameter(indexed("elevations", f), fmt::format("{}", building.elevations[f]),
                             "must ascend from above the base");
    }
    require_positive(indexed("masses", f), building.masses[f]);
    model.elevations.push_back(base_elevation + building.elevations[f]);
    model.storey_heights.push_back(building.elevations[f] - below);
  }
  const VectorXd mass = Eigen::Map<const VectorXd>(building.masses.data(), floors);
  result.known = known_modes(building.modes, mass);
  model.mass = mass.asDiagonal();
  model.stiffness = result.known.stiffness;
  model.load = mass;
  model.floor_masses = building.masses;
  return result;
}

}  // namespace bentur
