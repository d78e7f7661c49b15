#include <Eigen/Eigenvalues>

#include "solvers/linear.hpp"

namespace oddity {

Modes modes(const Eigen::MatrixXd& k, const Eigen::MatrixXd& m) {
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> solver(k, m);
  return {solver.eigenvalues(), solver.eigenvectors()};
}

}  // namespace oddity
