#pragma once

#include <Eigen/Core>
#include <vector>

#include "chapters/random.hpp"
#include "solvers/linear.hpp"

/// Vector spaces by columns that span them, and whether one of two contains the other: the affine subspaces
/// with these directions are parallel then, and only then.
namespace oddity::subspaces {

using Eigen::MatrixXd;
using Eigen::VectorXd;

__extension__ typedef __int128 Wide;

struct Pair {
  MatrixXd first, second;
  bool parallel;  ///< as made

  MatrixXd both() const {
    MatrixXd m(first.rows(), first.cols() + second.cols());
    m << first, second;
    return m;
  }
  const MatrixXd& larger() const { return first.cols() >= second.cols() ? first : second; }
  const MatrixXd& smaller() const { return first.cols() >= second.cols() ? second : first; }
};

/// The rank of a matrix of whole numbers, without a division that leaves a remainder [Bareiss, Math. Comp.
/// 22, 1968, p. 565].
inline int exact_rank(const MatrixXd& a) {
  const auto rows = static_cast<std::size_t>(a.rows()), columns = static_cast<std::size_t>(a.cols());
  std::vector<std::vector<Wide>> m(rows, std::vector<Wide>(columns));
  for (std::size_t i = 0; i < rows; ++i)
    for (std::size_t j = 0; j < columns; ++j)
      m[i][j] = static_cast<Wide>(a(static_cast<long>(i), static_cast<long>(j)));
  std::size_t r = 0;
  Wide before = 1;
  for (std::size_t c = 0; c < columns && r < rows; ++c) {
    std::size_t pivot = r;
    while (pivot < rows && m[pivot][c] == 0) ++pivot;
    if (pivot == rows) continue;
    std::swap(m[pivot], m[r]);
    for (std::size_t i = r + 1; i < rows; ++i) {
      for (std::size_t j = c + 1; j < columns; ++j)
        m[i][j] = (m[r][c] * m[i][j] - m[i][c] * m[r][j]) / before;
      m[i][c] = 0;
    }
    before = m[r++][c];
  }
  return static_cast<int>(r);
}

/// Gaussian elimination with complete pivoting; pivots below `relative` times the first are taken for zero.
inline int eliminated_rank(MatrixXd a, double relative) {
  const double first = a.cwiseAbs().maxCoeff();
  int r = 0;
  while (r < std::min(a.rows(), a.cols())) {
    long i = 0, j = 0;
    const double pivot = a.bottomRightCorner(a.rows() - r, a.cols() - r).cwiseAbs().maxCoeff(&i, &j);
    if (!(pivot > relative * first)) break;
    a.row(r).swap(a.row(r + i));
    a.col(r).swap(a.col(r + j));
    for (long k = r + 1; k < a.rows(); ++k) a.row(k) -= a(k, r) / a(r, r) * a.row(r).eval();
    ++r;
  }
  return r;
}

/// Does either contain the other? Together they span no more than the larger does.
template <class Rank>
bool by_rank(const Pair& pair, const Rank& rank_of) {
  return rank_of(pair.both()) == std::max(rank_of(pair.first), rank_of(pair.second));
}

/// The smaller's columns projected on the larger, until something is left of one.
inline bool by_projection(const Pair& pair, double relative, long& projections) {
  const MatrixXd& basis = pair.larger();
  for (long j = 0; j < pair.smaller().cols(); ++j) {
    ++projections;
    const VectorXd v = pair.smaller().col(j);
    const auto x = solve(Factorization::householder_qr, basis, v);
    if (!x.reached() || (basis * x.value - v).norm() > relative * v.norm()) return false;
  }
  return true;
}

// ---- samples ----------------------------------------------------------------------------------------------

inline MatrixXd whole(Random& random, long rows, long columns) {
  MatrixXd m(rows, columns);
  for (long i = 0; i < rows; ++i)
    for (long j = 0; j < columns; ++j) m(i, j) = random.below(9) - 4;
  return m;
}

inline MatrixXd independent(Random& random, long rows, long columns) {
  while (true) {
    const MatrixXd m = whole(random, rows, columns);
    if (exact_rank(m) == columns) return m;
  }
}

/// Pairs in dimensions 2 to 5: contained, coincident, and with at least one direction outside (a column of
/// full rank beside the larger's).
inline std::vector<Pair> random_pairs(double seed, int count) {
  Random random(seed);
  std::vector<Pair> all;
  while (static_cast<int>(all.size()) < count) {
    const int n = 2 + random.below(4), large = 1 + random.below(n - 1), small = 1 + random.below(large);
    const MatrixXd frame = independent(random, n, large + 1);
    const MatrixXd larger = frame.leftCols(large);
    MatrixXd smaller = larger * independent(random, large, small);
    const bool contained = random.below(2) == 0;
    if (!contained) smaller.col(0) += (1 + random.below(3)) * frame.col(large);
    if (exact_rank(smaller) < small) continue;
    if (random.below(2) == 0)
      all.push_back({larger, smaller, contained});
    else
      all.push_back({smaller, larger, contained});
  }
  return all;
}

}  // namespace oddity::subspaces
