#include "bentur/core/algebra/factors.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <Eigen/QR>

namespace bentur {

using Eigen::MatrixXd;
using Eigen::VectorXd;

struct Cholesky::Factors {
  Eigen::LLT<MatrixXd> of;
};

Cholesky::Cholesky(const MatrixXd& a) : factors_(std::make_unique<const Factors>(Factors{Eigen::LLT<MatrixXd>(a)})) {}
Cholesky::~Cholesky() = default;

bool Cholesky::is_positive_definite() const { return factors_->of.info() == Eigen::Success; }
MatrixXd Cholesky::lower() const { return factors_->of.matrixL(); }
VectorXd Cholesky::solve_vector(const VectorXd& b) const { return factors_->of.solve(b); }
MatrixXd Cholesky::solve_matrix(const MatrixXd& b) const { return factors_->of.solve(b); }

struct Ldlt::Factors {
  Eigen::LDLT<MatrixXd> of;
};

Ldlt::Ldlt(const MatrixXd& a) : factors_(std::make_unique<const Factors>(Factors{Eigen::LDLT<MatrixXd>(a)})) {}
Ldlt::~Ldlt() = default;

VectorXd Ldlt::pivots() const { return factors_->of.vectorD(); }

bool Ldlt::is_definite(double part) const {
  const auto d = factors_->of.vectorD();
  return d.minCoeff() > part * d.maxCoeff();
}

VectorXd Ldlt::solve_vector(const VectorXd& b) const { return factors_->of.solve(b); }
MatrixXd Ldlt::solve_matrix(const MatrixXd& b) const { return factors_->of.solve(b); }

bool is_positive_definite(const MatrixXd& a) { return Eigen::LLT<MatrixXd>(a).info() == Eigen::Success; }

MatrixXd solve_general(const MatrixXd& a, const MatrixXd& b) { return a.partialPivLu().solve(b); }

VectorXd least_norm_solution(const MatrixXd& a, const VectorXd& b) {
  return a.completeOrthogonalDecomposition().solve(b);
}

VectorXd least_norm_solution(const MatrixXd& a, const VectorXd& b, double apart) {
  Eigen::CompleteOrthogonalDecomposition<MatrixXd> factors;
  factors.setThreshold(apart);
  return factors.compute(a).solve(b);
}

VectorXd combination_of(const MatrixXd& rows, const Eigen::RowVectorXd& row) {
  return rows.transpose().colPivHouseholderQr().solve(row.transpose());
}

}  // namespace bentur
