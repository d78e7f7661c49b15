#include "solvers/linear.hpp"

#include <gsl/gsl_eigen.h>
#include <gsl/gsl_errno.h>
#include <gsl/gsl_linalg.h>

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <limits>
#include <map>
#include <memory>
#include <tuple>

#include "solvers/counted.hpp"
#include "solvers/gsl.hpp"

namespace oddity {

namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

// ---- costs, by counting one run of each algorithm as published --------------------------------------------

using Number = Counted<double>;

/// A matrix of counted numbers, row by row, which is singular for none of the factorizations.
struct Numbers {
  long m, n;
  std::vector<Number> entries;

  Numbers(long rows, long columns) : m(rows), n(columns), entries(static_cast<std::size_t>(m * n), 1.0) {
    for (long i = 0; i < std::min(m, n); ++i) (*this)(i, i) = static_cast<double>(m + 1);
  }
  Number& operator()(long i, long j) { return entries[static_cast<std::size_t>(i * n + j)]; }
};

void eliminate(Numbers& a) {
  for (long k = 0; k < a.n; ++k)
    for (long i = k + 1; i < a.n; ++i) {
      a(i, k) /= a(k, k);
      for (long j = k + 1; j < a.n; ++j) a(i, j) -= a(i, k) * a(k, j);
    }
}

/// Overwrites the lower half with L D L^T.
void factorize_symmetric(Numbers& a) {
  for (long k = 0; k < a.n; ++k) {
    Numbers scaled(1, k + 1);
    for (long j = 0; j < k; ++j) scaled(0, j) = a(k, j) * a(j, j);
    for (long i = k; i < a.n; ++i) {
      for (long j = 0; j < k; ++j) a(i, k) -= a(i, j) * scaled(0, j);
      if (i > k) a(i, k) /= a(k, k);
    }
  }
}

/// Applies the reflection of column k of `a`, whose vector is below the first entry, to column j of `b`.
void reflect(Numbers& a, long k, const Number& tau, Numbers& b, long j) {
  Number along = b(k, j);
  for (long i = k + 1; i < a.m; ++i) along += a(i, k) * b(i, j);
  along *= tau;
  b(k, j) -= along;
  for (long i = k + 1; i < a.m; ++i) b(i, j) -= a(i, k) * along;
}

/// Overwrites `a` with R above the reflections' vectors, and reflects `right`.
void reflect_all(Numbers& a, Numbers& right) {
  for (long k = 0; k < a.n; ++k) {
    Number squares = 0.0;
    for (long i = k + 1; i < a.m; ++i) squares += a(i, k) * a(i, k);
    const Number beta = -hypot(a(k, k), sqrt(squares)), tau = (beta - a(k, k)) / beta,
                 inverse = Number(1.0) / (a(k, k) - beta);
    for (long i = k + 1; i < a.m; ++i) a(i, k) *= inverse;
    for (long j = k + 1; j < a.n; ++j) reflect(a, k, tau, a, j);
    reflect(a, k, tau, right, 0);
    a(k, k) = beta;
  }
}

/// Substitutes with a lower triangle that has ones on its diagonal.
void substitute_forward(Numbers& l, Numbers& x) {
  for (long i = 0; i < l.n; ++i)
    for (long j = 0; j < i; ++j) x(i, 0) -= l(i, j) * x(j, 0);
}

void substitute_back(Numbers& u, Numbers& x) {
  for (long i = u.n - 1; i >= 0; --i) {
    for (long j = i + 1; j < u.n; ++j) x(i, 0) -= u(i, j) * x(j, 0);
    x(i, 0) /= u(i, i);
  }
}

void solve_once(Factorization how, long m, long n) {
  Numbers a(m, n), x(m, 1);
  switch (how) {
    case Factorization::partial_pivot_lu:
    case Factorization::full_pivot_lu:
      eliminate(a);
      substitute_forward(a, x);
      return substitute_back(a, x);
    case Factorization::householder_qr:
      reflect_all(a, x);
      return substitute_back(a, x);
    case Factorization::cholesky:
      factorize_symmetric(a);
      substitute_forward(a, x);
      for (long i = 0; i < n; ++i) x(i, 0) /= a(i, i);
      for (long i = n - 1; i >= 0; --i)
        for (long j = i + 1; j < n; ++j) x(i, 0) -= a(j, i) * x(j, 0);
  }
}

long counted_once(Factorization how, long m, long n) {
  const Operations all = operations_of([&] {
    solve_once(how, m, n);
    return 0;
  });
  return all.all_but_additions();
}

/// Multiplications, divisions and roots of a solution. Each thread counts a size once.
long work(Factorization how, long m, long n) {
  if (m < n || n < 1) return 0;
  thread_local std::map<std::tuple<Factorization, long, long>, long> known;
  const auto [found, is_new] = known.try_emplace({how, m, n});
  if (is_new) found->second = counted_once(how, m, n);
  return found->second;
}

/// Work for the triangular factors and the product of the pivots.
long work_of_determinant(long n) {
  thread_local std::map<long, long> known;
  const auto [found, is_new] = known.try_emplace(n);
  if (is_new)
    found->second = operations_of([&] {
                      Numbers a(n, n);
                      eliminate(a);
                      Number product = a(0, 0);
                      for (long i = 1; i < n; ++i) product *= a(i, i);
                      return product;
                    }).all_but_additions();
  return found->second;
}

// ---- GSL's side -------------------------------------------------------------------------------------------

using GslMatrix = std::unique_ptr<gsl_matrix, Free<gsl_matrix_free>>;
using GslVector = std::unique_ptr<gsl_vector, Free<gsl_vector_free>>;

GslMatrix copied(const MatrixXd& a) {
  GslMatrix copy(
      allocated(gsl_matrix_alloc(static_cast<std::size_t>(a.rows()), static_cast<std::size_t>(a.cols()))));
  for (std::size_t i = 0; i < copy->size1; ++i)
    for (std::size_t j = 0; j < copy->size2; ++j)
      gsl_matrix_set(copy.get(), i, j, a(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)));
  return copy;
}

GslVector copied(const VectorXd& b) {
  GslVector copy(allocated(gsl_vector_alloc(static_cast<std::size_t>(b.size()))));
  std::ranges::copy(b, copy->data);
  return copy;
}

GslVector vector_of(std::size_t n) { return GslVector(allocated(gsl_vector_alloc(n))); }
GslMatrix square(std::size_t n) { return GslMatrix(allocated(gsl_matrix_alloc(n, n))); }

/// Whether a equals its transpose, up to the rounding of two sums of a row's terms in different order.
bool symmetric(const MatrixXd& a) {
  const double roundings = 4 * static_cast<double>(a.rows()) * std::numeric_limits<double>::epsilon();
  return (a - a.transpose()).cwiseAbs().maxCoeff() <= roundings * a.cwiseAbs().maxCoeff();
}

/// The solution by Householder's reflections, and whether their triangle has no zero on its diagonal.
std::pair<VectorXd, bool> least_squares(const MatrixXd& a, const VectorXd& b) {
  disable_gsl_abort();
  const GslMatrix qr = copied(a);
  const GslVector right = copied(b), tau = vector_of(qr->size2), x = vector_of(qr->size2),
                  residual = vector_of(qr->size1);
  bool regular = gsl_linalg_QR_decomp(qr.get(), tau.get()) == GSL_SUCCESS;
  for (std::size_t i = 0; i < qr->size2; ++i) regular = regular && gsl_matrix_get(qr.get(), i, i) != 0;
  if (!regular ||
      gsl_linalg_QR_lssolve(qr.get(), tau.get(), right.get(), x.get(), residual.get()) != GSL_SUCCESS)
    return {VectorXd::Constant(a.cols(), std::numeric_limits<double>::quiet_NaN()), false};
  return {Eigen::Map<const VectorXd>(x->data, a.cols()), true};
}

// ---- Eigen's side -----------------------------------------------------------------------------------------

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
    case Factorization::householder_qr:
      return least_squares(a, b);
    case Factorization::cholesky: {
      if (!symmetric(a))  // Eigen would read one half only
        return {VectorXd::Constant(a.cols(), std::numeric_limits<double>::quiet_NaN()), false};
      const Eigen::LDLT<MatrixXd> ldlt(a);
      return {ldlt.solve(b), ldlt.info() == Eigen::Success && ldlt.vectorD().minCoeff() > 0};
    }
  }
  return {};
}

/// a = left diag(values) right^T, for a with at least as many rows as columns.
struct Singular {
  GslMatrix left, right;
  std::vector<double> values = {};  ///< largest first; empty if they do not converge
};

/// By one-sided Jacobi rotations, which keep the digits of the small values.
Singular singular(const MatrixXd& tall) {
  disable_gsl_abort();
  Singular all{copied(tall), square(static_cast<std::size_t>(tall.cols()))};
  const GslVector values = vector_of(all.left->size2);
  if (gsl_linalg_SV_decomp_jacobi(all.left.get(), all.right.get(), values.get()) == GSL_SUCCESS)
    all.values.assign(values->data, values->data + values->size);
  return all;
}
std::vector<double> singular_values(const MatrixXd& a) {
  return singular(a.rows() < a.cols() ? MatrixXd(a.transpose()) : a).values;
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
  solved.evaluations = work_of_determinant(n);
  if (!std::isfinite(solved.value)) {
    solved.ending = Ending::non_finite;
    solved.message = a.allFinite() ? "the determinant is not finite: it, or a product on the way, overflows"
                                   : "the matrix is not finite";
  }
  return solved;
}

double condition(const MatrixXd& a) {
  if (a.size() == 0 || !a.allFinite()) return std::numeric_limits<double>::quiet_NaN();
  const std::vector<double> s = singular_values(a);
  if (s.empty()) return std::numeric_limits<double>::quiet_NaN();
  return s.back() > 0 ? s.front() / s.back() : std::numeric_limits<double>::infinity();
}

int rank(const MatrixXd& a, double relative) {
  if (a.size() == 0 || !a.allFinite()) return 0;
  const std::vector<double> s = singular_values(a);
  return static_cast<int>(std::ranges::count_if(s, [&](double x) { return x > relative * s.front(); }));
}

MatrixXd pseudo_inverse(const MatrixXd& a, double relative) {
  if (a.rows() < a.cols()) return pseudo_inverse(a.transpose(), relative).transpose();
  MatrixXd inverse = MatrixXd::Zero(a.cols(), a.rows());
  if (a.size() == 0 || !a.allFinite()) return inverse;
  const Singular parts = singular(a);
  for (std::size_t k = 0; k < parts.values.size() && parts.values[k] > relative * parts.values.front(); ++k)
    for (Eigen::Index i = 0; i < inverse.rows(); ++i)
      for (Eigen::Index j = 0; j < inverse.cols(); ++j)
        inverse(i, j) += gsl_matrix_get(parts.right.get(), static_cast<std::size_t>(i), k) *
                         gsl_matrix_get(parts.left.get(), static_cast<std::size_t>(j), k) / parts.values[k];
  return inverse;
}

std::vector<std::complex<double>> eigenvalues(const MatrixXd& a) {
  disable_gsl_abort();
  if (a.size() == 0 || a.rows() != a.cols() || !a.allFinite()) return {};
  const GslMatrix destroyed = copied(a);
  const std::size_t n = destroyed->size1;
  const std::unique_ptr<gsl_vector_complex, Free<gsl_vector_complex_free>> found(
      allocated(gsl_vector_complex_alloc(n)));
  const std::unique_ptr<gsl_eigen_nonsymm_workspace, Free<gsl_eigen_nonsymm_free>> space(
      allocated(gsl_eigen_nonsymm_alloc(n)));
  if (gsl_eigen_nonsymm(destroyed.get(), found.get(), space.get()) != GSL_SUCCESS) return {};
  std::vector<std::complex<double>> all;
  for (std::size_t i = 0; i < n; ++i) {
    const gsl_complex z = gsl_vector_complex_get(found.get(), i);
    all.emplace_back(GSL_REAL(z), GSL_IMAG(z));
  }
  return all;
}

Modes modes(const MatrixXd& k, const MatrixXd& m) {
  disable_gsl_abort();
  const auto none = [&](const char* why) {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    return Modes{VectorXd::Constant(k.rows(), nan), MatrixXd::Constant(k.rows(), k.rows(), nan),
                 Ending::raised, why};
  };
  if (k.rows() == 0 || k.rows() != k.cols() || m.rows() != k.rows() || m.cols() != k.cols())
    return none("the shapes do not fit");
  if (!k.allFinite() || !m.allFinite()) return none("a matrix is not finite");
  if (!symmetric(k) || !symmetric(m)) return none("a matrix is not symmetric");
  const GslMatrix stiffness = copied(k), mass = copied(m);
  const std::size_t n = stiffness->size1;
  const GslVector squares = vector_of(n);
  const GslMatrix shapes = square(n);
  const std::unique_ptr<gsl_eigen_gensymmv_workspace, Free<gsl_eigen_gensymmv_free>> space(
      allocated(gsl_eigen_gensymmv_alloc(n)));
  if (gsl_eigen_gensymmv(stiffness.get(), mass.get(), squares.get(), shapes.get(), space.get()) !=
      GSL_SUCCESS)
    return none("the mass matrix is not positive definite");
  gsl_eigen_gensymmv_sort(squares.get(), shapes.get(), GSL_EIGEN_SORT_VAL_ASC);
  Modes found{VectorXd(k.rows()), MatrixXd(k.rows(), k.rows())};
  for (Eigen::Index j = 0; j < k.rows(); ++j) {
    const auto column = static_cast<std::size_t>(j);
    VectorXd shape(k.rows());
    for (Eigen::Index i = 0; i < k.rows(); ++i)
      shape[i] = gsl_matrix_get(shapes.get(), static_cast<std::size_t>(i), column);
    found.squares[j] = gsl_vector_get(squares.get(), column);
    found.shapes.col(j) = shape / std::sqrt(shape.dot(m * shape));
  }
  return found;
}

}  // namespace oddity
