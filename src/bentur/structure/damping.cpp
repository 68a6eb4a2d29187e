#include "bentur/structure/damping.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "bentur/core/errors.h"
#include "bentur/core/require.h"

namespace bentur {
namespace {

Eigen::MatrixXd diagonal(const Eigen::VectorXd& terms) { return terms.asDiagonal(); }

// 2ζω, one ratio for each mode or one for all.
Eigen::MatrixXd damp(const ModalDamping& damping, const Modes& modes) {
  const Eigen::Index n = modes.omega.size();
  const std::size_t given = damping.ratios.size();
  if (given != 1) require_size("damping ratios", given, n);
  for (std::size_t i = 0; i < given; ++i) require_not_negative(indexed("damping ratios", i), damping.ratios[i]);
  Eigen::VectorXd terms(n);
  for (Eigen::Index j = 0; j < n; ++j) {
    terms(j) = 2 * damping.ratios[given == 1 ? 0 : j] * modes.omega(j);
  }
  return diagonal(terms);
}

// C = αM + βK, so 2ζω = α + βω² in every mode; α, β from ζ = α/(2ω) + βω/2 at two frequencies.
Eigen::MatrixXd damp(const RayleighDamping& damping, const Modes& modes) {
  require_size("rayleigh ratios", damping.ratios.size(), 2);
  require_size("rayleigh periods", damping.periods.size(), 2);
  for (std::size_t i = 0; i < 2; ++i) {
    require_not_negative(indexed("rayleigh ratios", i), damping.ratios[i]);
    require_positive(indexed("rayleigh periods", i), damping.periods[i]);
  }
  if (damping.periods[0] == damping.periods[1]) {
    throw InvalidParameter("rayleigh periods", fmt::format("[{0}, {0}]", damping.periods[0]), "must differ");
  }
  const double w1 = 2 * std::numbers::pi / damping.periods[0];
  const double w2 = 2 * std::numbers::pi / damping.periods[1];
  const double beta = 2 * (damping.ratios[0] * w1 - damping.ratios[1] * w2) / (w1 * w1 - w2 * w2);
  const double alpha = 2 * w1 * w2 * (damping.ratios[1] * w1 - damping.ratios[0] * w2) / (w1 * w1 - w2 * w2);
  const Eigen::VectorXd terms = alpha + beta * modes.omega.array().square();
  if (terms.size() > 0 && terms.minCoeff() < 0) {
    Eigen::Index worst = 0;
    const double term = terms.minCoeff(&worst);
    throw InvalidParameter("rayleigh ratios", fmt::format("[{}, {}]", damping.ratios[0], damping.ratios[1]),
                           fmt::format("must not give a negative ratio in any mode (mode {}: {:.3g})", worst + 1,
                                       term / (2 * modes.omega(worst))));
  }
  return diagonal(terms);
}

// C = αM with α = 2 ζ₁ ω₁ (2-25).
Eigen::MatrixXd damp(const MassProportionalDamping& damping, const Modes& modes) {
  require_not_negative("mass_proportional", damping.ratio);
  return diagonal(Eigen::VectorXd::Constant(modes.omega.size(), 2 * damping.ratio * modes.omega(0)));
}

Eigen::MatrixXd damp(const MatrixDamping& damping, const Modes& modes) {
  const Eigen::Index n = modes.shapes.rows();
  if (damping.matrix.rows() != n || damping.matrix.cols() != n) {
    throw InvalidParameter("damping matrix", fmt::format("{} x {}", damping.matrix.rows(), damping.matrix.cols()),
                           fmt::format("must be {0} x {0}", n));
  }
  if (!damping.matrix.allFinite()) throw InvalidParameter("damping matrix", "not finite", "must be finite");
  Eigen::MatrixXd c = modes.shapes.transpose() * damping.matrix * modes.shapes;
  const double threshold = 1e-12 * c.cwiseAbs().maxCoeff();
  for (Eigen::Index j = 0; j < c.cols(); ++j) {
    for (Eigen::Index i = 0; i < c.rows(); ++i) {
      if (i != j && std::abs(c(i, j)) < threshold) c(i, j) = 0;
    }
  }
  return c;
}

}  // namespace

Eigen::MatrixXd modal_damping(const Damping& damping, const Modes& modes) {
  return std::visit([&](const auto& kind) { return damp(kind, modes); }, damping);
}

}  // namespace bentur
