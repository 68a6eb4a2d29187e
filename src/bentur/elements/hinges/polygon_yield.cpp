#include "bentur/elements/hinges/polygon_yield.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "bentur/core/errors.h"
#include "bentur/core/require.h"
#include "bentur/elements/hinges.h"

namespace bentur {

/// Perfectly plastic mechanisms of one spring, one along each direction: hinges as any others are. (H-2), (H-3)
PolygonYield polygon_yield(double stiffness, double strength, double yield_displacement, int sides) {
  require_positive("strength", strength);
  require_positive("yield_displacement", yield_displacement);
  const double yielding = strength / yield_displacement;
  if (!(stiffness > yielding)) {
    throw InvalidParameter("stiffness", fmt::format("{:.6g}", stiffness), "must be more than what yields of it");
  }
  if (sides < PolygonYield::least_sides || sides > PolygonYield::most_sides || sides % 4 != 0) {
    throw InvalidParameter(
        "yield_sides", fmt::format("{}", sides),
        fmt::format("must be a multiple of 4, {} … {}", PolygonYield::least_sides, PolygonYield::most_sides));
  }
  const Eigen::Index count = sides / 2;
  Eigen::MatrixXd unit(count, 2);
  for (Eigen::Index n = 0; n < count; ++n) {
    const double angle = std::numbers::pi * static_cast<double>(n) / static_cast<double>(count);
    unit.row(n) << (2 * n == count ? 0.0 : std::cos(angle)), std::sin(angle);
  }
  PolygonYield made{.directions = yielding * unit, .law = {}, .stiffness = stiffness};
  const Eigen::VectorXd most = Eigen::VectorXd::Constant(count, strength);
  made.law = std::make_shared<HingeLaw>(HingeLaw::Parameters{.stiffness = yielding * unit * unit.transpose(),
                                                             .hardening = Eigen::VectorXd::Zero(count),
                                                             .upper = most,
                                                             .lower = most,
                                                             .rows = made.directions});
  return made;
}

Yielded yielded_of(const PolygonYield& yield, const CoupledState& state) {
  const auto& law = dynamic_cast<const HingeLaw&>(*yield.law);
  Yielded found{.residual = {0, 0}};
  for (Eigen::Index n = 0; n < law.size(); ++n) {
    const HingeLaw::Record record = law.record(state, n);
    found.residual += record.rotation / yield.stiffness * yield.directions.row(n).transpose();
    found.energy += record.lost;
  }
  return found;
}

}  // namespace bentur
