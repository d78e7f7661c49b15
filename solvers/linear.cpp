#include "solvers/linear.hpp"

#include <Eigen/Dense>
#include <limits>

namespace oddity {

namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

long work(Factorization how, long m, long n) {
  switch (how) {
    case Factorization::partial_pivot_lu:
    case Factorization::full_pivot_lu:
      return n * (n * n - 1) / 3 + n * n;
    case Factorization::householder_qr:
      return m * n * n - n * n * n / 3 + 2 * m * n;
    case Factorization::cholesky:
      return n * n * n / 6 + n * n;
  }
  return 0;
}

/// The solution, and whether the factorization found the matrix regular.
std::pair<VectorXd, bool> solution(Factorization how, const MatrixXd& a, const VectorXd& b) {
  switch (how) {
    case Factorization::partial_pivot_lu: {
      const Eigen::PartialPivLU<MatrixXd> lu(a);
      return {lu.solve(b), lu.matrixLU().diagonal().cwiseAbs().minCoeff() > 0};
    }
    case Factorization::full_pivot_lu: {
      const Eigen::FullPivLU<MatrixXd> lu(a);
      return {lu.solve(b), lu.isInvertible()};
    }
    case Factorization::householder_qr: {
      const Eigen::HouseholderQR<MatrixXd> qr(a);
      return {qr.solve(b), qr.matrixQR().diagonal().cwiseAbs().minCoeff() > 0};
    }
    case Factorization::cholesky: {
      if (!a.isApprox(a.transpose()))  // of which Eigen would read one half only
        return {VectorXd::Constant(a.cols(), std::numeric_limits<double>::quiet_NaN()), false};
      const Eigen::LDLT<MatrixXd> ldlt(a);
      return {ldlt.solve(b),
              ldlt.info() == Eigen::Success && ldlt.isPositive() && ldlt.vectorD().minCoeff() > 0};
    }
  }
  return {};
}

}  // namespace

Solved<VectorXd> solve(Factorization how, const MatrixXd& a, const VectorXd& b) {
  Solved<VectorXd> solved;
  solved.evaluations = work(how, a.rows(), a.cols());
  const bool shapes = a.rows() == b.size() && a.cols() > 0 &&
                      (a.rows() == a.cols() || (how == Factorization::householder_qr && a.rows() > a.cols()));
  if (!shapes) {
    solved.ending = Ending::raised;
    solved.message = "the shapes do not fit";
    return solved;
  }
  if (!a.allFinite() || !b.allFinite()) {
    solved.ending = Ending::non_finite;
    solved.message = "the matrix or the right-hand side is not finite";
    return solved;
  }
  auto [x, regular] = solution(how, a, b);
  solved.value = std::move(x);
  if (!regular) {
    solved.ending = Ending::raised;
    solved.message = "the matrix is singular to this factorization";
  } else if (!solved.value.allFinite()) {
    solved.ending = Ending::non_finite;
    solved.message = "the solution is not finite";
  }
  return solved;
}

Solved<double> determinant(const MatrixXd& a) {
  Solved<double> solved;
  if (a.rows() != a.cols() || a.rows() == 0) {
    solved.ending = Ending::raised;
    solved.message = "a determinant needs a square matrix";
    return solved;
  }
  const long n = a.rows();
  solved.value = Eigen::PartialPivLU<MatrixXd>(a).determinant();
  solved.evaluations = n * (n * n - 1) / 3 + n - 1;
  if (!std::isfinite(solved.value)) {
    solved.ending = Ending::non_finite;
    solved.message = "the determinant is not finite: it, or a product on the way, overflows";
  }
  return solved;
}

double condition(const MatrixXd& a) {
  if (a.size() == 0 || !a.allFinite()) return std::numeric_limits<double>::quiet_NaN();
  const VectorXd s = Eigen::JacobiSVD<MatrixXd>(a).singularValues();
  const double least = s(s.size() - 1);
  return least > 0 ? s(0) / least : std::numeric_limits<double>::infinity();
}

int rank(const MatrixXd& a, double relative) {
  if (a.size() == 0 || !a.allFinite()) return 0;
  const VectorXd s = Eigen::JacobiSVD<MatrixXd>(a).singularValues();
  int count = 0;
  for (double value : s) count += value > relative * s(0);
  return count;
}

}  // namespace oddity
