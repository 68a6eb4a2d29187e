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

struct RayleighParts {
  double alpha = 0;  // [1/s]
  double beta = 0;   // [s]
};

RayleighParts rayleigh_parts(const RayleighDamping& damping) {
  const double w1 = 2 * std::numbers::pi / damping.periods.at(0);
  const double w2 = 2 * std::numbers::pi / damping.periods.at(1);
  const double z1 = damping.ratios.at(0);
  const double z2 = damping.ratios.at(1);
  return {2 * w1 * w2 * (z2 * w1 - z1 * w2) / (w1 * w1 - w2 * w2), 2 * (z1 * w1 - z2 * w2) / (w1 * w1 - w2 * w2)};
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
  const auto [alpha, beta] = rayleigh_parts(damping);
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

// C = βK with β = 2 ζ₁/ω₁, so 2ζω = βω² in every mode.
Eigen::MatrixXd damp(const StiffnessProportionalDamping& damping, const Modes& modes) {
  require_not_negative("stiffness_proportional", damping.ratio);
  return diagonal(2 * damping.ratio / modes.omega(0) * modes.omega.array().square());
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

std::optional<double> stiffness_part(const Damping& damping, double first_omega) {
  if (const auto* rayleigh = std::get_if<RayleighDamping>(&damping)) return rayleigh_parts(*rayleigh).beta;
  if (const auto* stiffness = std::get_if<StiffnessProportionalDamping>(&damping)) {
    return 2 * stiffness->ratio / first_omega;
  }
  return std::nullopt;
}

Eigen::MatrixXd modal_damping(const Damping& damping, const Modes& modes) {
  return std::visit([&](const auto& kind) { return damp(kind, modes); }, damping);
}

}  // namespace bentur
