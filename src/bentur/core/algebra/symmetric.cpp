#include "bentur/core/algebra/symmetric.h"

#include <Eigen/Eigenvalues>

namespace bentur {

using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

using Solver = Eigen::SelfAdjointEigenSolver<MatrixXd>;
using GeneralisedSolver = Eigen::GeneralizedSelfAdjointEigenSolver<MatrixXd>;

template <class Solver>
SymmetricModes found(const Solver& solver) {
  return {solver.eigenvalues(), solver.eigenvectors(), solver.info() == Eigen::Success};
}

}  // namespace

SymmetricModes symmetric_modes(const MatrixXd& a) { return found(Solver(a)); }
SymmetricModes symmetric_modes_of_3(const Eigen::Matrix3d& a) {
  return found(Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(a));
}

VectorXd symmetric_values(const MatrixXd& a) { return Solver(a, Eigen::EigenvaluesOnly).eigenvalues(); }

MatrixXd inverse_square_root(const MatrixXd& a) { return Solver(a).operatorInverseSqrt(); }

SymmetricModes generalised_modes(const MatrixXd& a, const MatrixXd& b) { return found(GeneralisedSolver(a, b)); }

VectorXd generalised_values(const MatrixXd& a, const MatrixXd& b) {
  return GeneralisedSolver(a, b, Eigen::EigenvaluesOnly | Eigen::Ax_lBx).eigenvalues();
}

}  // namespace bentur
