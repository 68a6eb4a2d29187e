#include <Eigen/Eigenvalues>

#include "bentur/elements/hinges.h"

namespace bentur {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

std::optional<VectorXd> free_shape(const MatrixXd& frame_stiffness, const MatrixXd& frame_rows,
                                   const MatrixXd& hinge_stiffness, const std::vector<Index>& flowing) {
  constexpr double singular = 1e-12;  // of the largest eigenvalue: a spin
  const MatrixXd rows = frame_rows(flowing, Eigen::all);
  const Eigen::SelfAdjointEigenSolver<MatrixXd> of_hinges(hinge_stiffness(flowing, flowing));
  const VectorXd& values = of_hinges.eigenvalues();
  const VectorXd inverse = (values.array() > singular * values.maxCoeff()).select(values.cwiseInverse(), 0.0);
  const MatrixXd turned = of_hinges.eigenvectors().transpose() * rows;
  const MatrixXd tangent = frame_stiffness - turned.transpose() * inverse.asDiagonal() * turned;
  const Eigen::GeneralizedSelfAdjointEigenSolver<MatrixXd> shapes(0.5 * (tangent + tangent.transpose()),
                                                                  frame_stiffness);
  if (!(shapes.eigenvalues()(0) < HingeLaw::bends)) return std::nullopt;
  return shapes.eigenvectors().col(0);
}

}  // namespace bentur
