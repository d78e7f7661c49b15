#pragma once

#include <Eigen/Core>
#include <complex>
#include <vector>

#include "solvers/solved.hpp"

/// Dense linear algebra over Eigen and, for QR, singular values and eigenvalues, over GSL, which takes a
/// tenth of the time to compile. `evaluations` are the multiplications, divisions and roots of the algorithm
/// as published, without those of the search for pivots. Singular (a pivot that is zero) or, for Cholesky,
/// not symmetric and positive definite: the ending is `raised`. Not finite: `non_finite`. A singular matrix
/// whose pivots round to something else than zero is found by full_pivot_lu alone.
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

/// x with a x = b; least squares when a is taller than wide (QR only).
Solved<Eigen::VectorXd> solve(Factorization, const Eigen::MatrixXd& a, const Eigen::VectorXd& b);
/// The determinant by LU with partial pivoting.
Solved<double> determinant(const Eigen::MatrixXd& a);
/// The ratio of the extreme singular values; infinity when the least one is zero, NaN when a is empty or not
/// finite, or when they do not converge.
double condition(const Eigen::MatrixXd& a);
/// The number of singular values above `relative` times the largest; zero when a is not finite.
int rank(const Eigen::MatrixXd& a, double relative = 1e-12);
/// The eigenvalues of a square matrix, in no order; none when it is not finite or they do not converge.
std::vector<std::complex<double>> eigenvalues(const Eigen::MatrixXd& a);

/// The oscillations of m x'' + k x = 0.
struct Modes {
  Eigen::VectorXd squares;  ///< of the angular frequencies, from the smallest on
  Eigen::MatrixXd shapes;   ///< a column each; shapes^T m shapes = 1
  Ending ending = Ending::reached;
  std::string message = {};  ///< why, when the ending is not `reached`
};

/// Of k symmetric, m symmetric and positive definite; `raised`, and every number NaN, when they are not.
Modes modes(const Eigen::MatrixXd& k, const Eigen::MatrixXd& m);

}  // namespace oddity
