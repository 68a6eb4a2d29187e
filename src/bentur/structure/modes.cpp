#include "bentur/structure/modes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <stdexcept>
#include <vector>

#include "bentur/core/algebra/factors.h"
#include "bentur/core/algebra/symmetric.h"
#include "bentur/core/require.h"

namespace bentur {
namespace {

// Cholesky factor L of M = LLᵀ.
Eigen::MatrixXd mass_factor(const Eigen::MatrixXd& mass) {
  const Cholesky cholesky(mass);
  if (!cholesky.is_positive_definite() || !mass.allFinite()) {
    throw std::runtime_error("the mass matrix is not positive definite");
  }
  return cholesky.lower();
}

// ω ascending from ω² in any order; the first entry of each shape above 1e-9 of its largest is made positive.
Modes sorted(const Eigen::VectorXd& omega_squared, const Eigen::MatrixXd& shapes) {
  const Eigen::Index n = omega_squared.size();
  if (n > 0 && !(omega_squared.minCoeff() > 0)) {  // also refuses NaN
    throw std::runtime_error("the stiffness matrix is not positive definite");
  }
  if (!omega_squared.allFinite() || !shapes.allFinite()) {
    throw std::runtime_error("stiffness over mass is beyond what numbers can hold");
  }
  std::vector<Eigen::Index> order(n);
  std::iota(order.begin(), order.end(), Eigen::Index{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](Eigen::Index a, Eigen::Index b) { return omega_squared(a) < omega_squared(b); });
  Modes result{Eigen::VectorXd(n), Eigen::MatrixXd(shapes.rows(), n)};
  for (Eigen::Index j = 0; j < n; ++j) {
    const Eigen::Index from = order[j];
    const auto shape = shapes.col(from);
    const double threshold = 1e-9 * shape.cwiseAbs().maxCoeff();
    Eigen::Index first = 0;
    while (first + 1 < shape.size() && std::abs(shape(first)) <= threshold) ++first;
    result.omega(j) = std::sqrt(omega_squared(from));
    result.shapes.col(j) = shape(first) < 0 ? Eigen::VectorXd(-shape) : Eigen::VectorXd(shape);
  }
  return result;
}

// One Jacobi rotation in the plane (p, q) that makes a(p, q) zero (Golub & Van Loan, Matrix Computations, 8.5).
void rotate(Eigen::MatrixXd& a, Eigen::MatrixXd& vectors, Eigen::Index p, Eigen::Index q) {
  const double theta = (a(q, q) - a(p, p)) / (2 * a(p, q));
  const double t = std::copysign(1.0, theta) / (std::abs(theta) + std::hypot(1.0, theta));
  const double c = 1 / std::hypot(1.0, t);
  const double s = t * c;
  const double shift = t * a(p, q);
  a(p, p) -= shift;
  a(q, q) += shift;
  a(p, q) = a(q, p) = 0;
  for (Eigen::Index k = 0; k < a.rows(); ++k) {
    if (k != p && k != q) {
      const double akp = a(k, p);
      const double akq = a(k, q);
      a(k, p) = a(p, k) = c * akp - s * akq;
      a(k, q) = a(q, k) = s * akp + c * akq;
    }
    const double vkp = vectors(k, p);
    const double vkq = vectors(k, q);
    vectors(k, p) = c * vkp - s * vkq;
    vectors(k, q) = s * vkp + c * vkq;
  }
}

}  // namespace

Modes modes(const Eigen::MatrixXd& mass, const Eigen::MatrixXd& stiffness) {
  static_cast<void>(mass_factor(mass));  // the solver below would not notice
  if (!(stiffness.diagonal().array() / mass.diagonal().array()).allFinite()) {
    throw std::runtime_error("stiffness over mass is beyond what numbers can hold");
  }
  const SymmetricModes found = generalised_modes(stiffness, mass);
  if (!found.converged) throw std::runtime_error("the eigenvalue iteration did not converge");
  return sorted(found.values, found.vectors);
}

Modes modes_by_jacobi(const Eigen::MatrixXd& mass, const Eigen::MatrixXd& stiffness) {
  const Eigen::MatrixXd factor = mass_factor(mass);
  const auto lower = factor.triangularView<Eigen::Lower>();
  Eigen::MatrixXd a = lower.solve(stiffness);
  a = lower.solve(a.transpose().eval());
  a = (0.5 * (a + a.transpose())).eval();

  // A rotation is skipped when its entry is below round-off of both diagonal entries; a sweep without rotations ends
  // it. Convergence is quadratic: some ten sweeps serve any size, so 100 is out of reach for finite input.
  Eigen::MatrixXd vectors = Eigen::MatrixXd::Identity(a.rows(), a.cols());
  constexpr int most_sweeps = 100;
  bool rotated = true;
  for (int sweep = 0; rotated; ++sweep) {
    if (sweep == most_sweeps) throw std::runtime_error("the Jacobi rotations did not converge");
    rotated = false;
    for (Eigen::Index p = 0; p + 1 < a.rows(); ++p) {
      for (Eigen::Index q = p + 1; q < a.rows(); ++q) {
        const double scale = std::sqrt(std::abs(a(p, p) * a(q, q)));
        if (!(std::abs(a(p, q)) <= std::numeric_limits<double>::epsilon() * scale)) {
          rotate(a, vectors, p, q);
          rotated = true;
        }
      }
    }
  }
  return sorted(a.diagonal(), lower.transpose().solve(vectors));
}

double smallest_eigenvalue(const Eigen::MatrixXd& matrix) { return symmetric_values(matrix)(0); }

ModalProperties modal_properties(const Modes& modes, const Eigen::VectorXd& load) {
  ModalProperties result;
  result.periods = 2 * std::numbers::pi * modes.omega.cwiseInverse();
  result.participation = modes.shapes.transpose() * load;
  const Eigen::VectorXd effective = result.participation.cwiseAbs2();
  const double total = effective.sum();
  result.effective_mass_fraction = total > 0 ? Eigen::VectorXd(effective / total) : effective;
  return result;
}

ModalProperties modal_properties(const Building& building) {
  ModalProperties properties = modal_properties(building.modes, building.model.load);
  if (building.modes.omega.size() >= building.model.dofs() || building.is_rigid()) return properties;
  const Eigen::VectorXd& load = building.model.load;
  const double moving = load.dot(Ldlt(building.model.mass).solve(load));
  properties.effective_mass_fraction = properties.participation.cwiseAbs2() / moving;
  return properties;
}

double calibration_factor(const Eigen::MatrixXd& mass, const Eigen::MatrixXd& stiffness, double first_period) {
  require_positive("calibrate_period", first_period);
  const double ratio = 2 * std::numbers::pi / (first_period * modes(mass, stiffness).omega(0));
  return ratio * ratio;
}

void calibrate_period(StructuralModel& model, double first_period) {
  const double factor = calibration_factor(model.mass, model.stiffness, first_period);
  model.stiffness *= factor;
  model.shears *= factor;
  model.column_forces *= factor;
  for (InfillPanel& panel : model.infills) panel.stiffness *= factor;
  model.hinges.scale_stiffness(factor);
  model.stiffness_factor = factor * model.stiffness_factor.value_or(1);
}

}  // namespace bentur
