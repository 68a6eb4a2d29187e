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

ModalModel modal_model(const ModalBuilding& building, double base_elevation) {
  const Index floors = std::ssize(building.elevations);
  const Index count = std::ssize(building.periods);
  if (floors == 0) throw InvalidParameter("elevations", "an empty list", "must have at least one entry");
  require_size("masses", building.masses.size(), floors);
  require_finite("base_elevation", base_elevation);
  if (count == 0 || count > floors) {
    throw InvalidParameter("periods", fmt::format("{} entries", count),
                           fmt::format("must have one entry per mode, 1 to {} of them", floors));
  }
  require_size("shapes", building.shapes.size(), count);
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
  std::vector<Index> order(building.periods.size());
  std::iota(order.begin(), order.end(), Index{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](Index a, Index b) { return building.periods[a] > building.periods[b]; });
  const VectorXd mass = Eigen::Map<const VectorXd>(building.masses.data(), floors);
  MatrixXd shapes(floors, count);
  result.modes.omega.resize(count);
  for (Index j = 0; j < count; ++j) {
    const Index given = order[j];
    require_positive(indexed("periods", given), building.periods[given]);
    require_size(indexed("shapes", given), building.shapes[given].size(), floors);
    shapes.col(j) = Eigen::Map<const VectorXd>(building.shapes[given].data(), floors);
    const double modal_mass = shapes.col(j).cwiseAbs2().dot(mass);
    if (!(std::isfinite(modal_mass) && modal_mass > 0)) {
      throw InvalidParameter(indexed("shapes", given), "zero or not finite", "must have a floor that moves");
    }
    shapes.col(j) /= std::sqrt(modal_mass);
    result.modes.omega(j) = 2 * std::numbers::pi / building.periods[given];
  }
  const MatrixXd products = shapes.transpose() * mass.asDiagonal() * shapes;
  for (Index i = 0; i < count; ++i) {
    for (Index j = 0; j < i; ++j) {
      const double product = std::abs(products(i, j));
      result.largest_product = std::max(result.largest_product, product);
      if (product <= most_product) continue;
      throw InvalidParameter(
          "shapes", fmt::format("{:.3g} between modes {} and {}", product, order[j] + 1, order[i] + 1),
          "must be orthogonal over the masses to within 0.02: are they of these masses, the lowest floor "
          "first?");
    }
  }
  result.modes.shapes = shapes * inverse_square_root(products);
  for (Index j = 0; j < count; ++j) {
    auto shape = result.modes.shapes.col(j);
    Index first = 0;
    while (first + 1 < floors && std::abs(shape(first)) <= 1e-12 * shape.cwiseAbs().maxCoeff()) ++first;
    if (shape(first) < 0) shape *= -1;
  }
  const MatrixXd pushed = mass.asDiagonal() * result.modes.shapes;  // M Φ
  model.mass = mass.asDiagonal();
  model.stiffness = pushed * result.modes.omega.cwiseAbs2().asDiagonal() * pushed.transpose();
  model.load = mass;
  model.floor_masses = building.masses;
  const VectorXd shares = mass.cwiseProduct(result.modes.shapes.rowwise().squaredNorm());
  result.mass_shares.assign(shares.begin(), shares.end());
  return result;
}

}  // namespace bentur
