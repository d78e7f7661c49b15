#pragma once

#include <Eigen/Core>
#include <complex>
#include <vector>

#include "solvers/solved.hpp"

/// Dense linear algebra over Eigen and, for QR, singular values and eigenvalues, over GSL, which compiles in
/// a tenth of the time. `evaluations` are the multiplications, divisions and roots of the algorithm as
/// published, without the search for pivots. The ending is `raised` for a singular matrix (a pivot is zero)
/// or, with Cholesky, one that is not symmetric and positive definite. It is `non_finite` for results that
/// are not finite. Only full_pivot_lu detects a singular matrix whose pivots do not round to zero.
///
///   const auto solved = solve(Factorization::partial_pivot_lu, a, b);
///   if (solved.reached()) std::cout << solved.value.transpose() << " by " << solved.evaluations;
namespace oddity {

enum class Factorization {
  partial_pivot_lu,  ///< n^3/3, the default of engines
  full_pivot_lu,     ///< n^3/3 and n^3/3 comparisons; reveals rank
  householder_qr,    ///< m n^2 - n^3/3; also least squares
  cholesky,          ///< n^3/6, symmetric positive definite only (LDL^T)
};

/// x with a x = b; least squares if a has more rows than columns (QR only).
Solved<Eigen::VectorXd> solve(Factorization, const Eigen::MatrixXd& a, const Eigen::VectorXd& b);
/// The determinant by LU with partial pivoting.
Solved<double> determinant(const Eigen::MatrixXd& a);
/// The ratio of the extreme singular values; infinity if the smallest is zero, NaN if a is empty or not
/// finite, or if they do not converge.
double condition(const Eigen::MatrixXd& a);
/// The number of singular values above `relative` times the largest; zero if a is not finite.
int rank(const Eigen::MatrixXd& a, double relative = 1e-12);
/// The pseudo-inverse (Moore, Penrose), with the singular values above `relative` times the largest; zero if
/// a is not finite or they do not converge.
Eigen::MatrixXd pseudo_inverse(const Eigen::MatrixXd& a, double relative = 1e-12);
/// The eigenvalues of a square matrix, in no order; empty if it is not finite or they do not converge.
std::vector<std::complex<double>> eigenvalues(const Eigen::MatrixXd& a);

/// The oscillations of m x'' + k x = 0.
struct Modes {
  Eigen::VectorXd squares;  ///< squared angular frequencies, smallest first
  Eigen::MatrixXd shapes;   ///< one per column; shapes^T m shapes = 1
  Ending ending = Ending::reached;
  std::string message = {};  ///< the reason, if the ending is not `reached`
};

/// Modes for k symmetric, m symmetric and positive definite; otherwise `raised`, and every number NaN.
Modes modes(const Eigen::MatrixXd& k, const Eigen::MatrixXd& m);

}  // namespace oddity
