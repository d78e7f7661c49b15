#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <initializer_list>
#include <vector>

#include "chapters/exercise.hpp"
#include "chapters/random.hpp"

/// Pairs of vector spaces, and the claims of exercise 8.3.
namespace oddity::ex08_03 {

using Eigen::MatrixXd;
using Eigen::VectorXd;

struct Pair {
  MatrixXd first, second;
  bool parallel;  ///< by construction

  MatrixXd both() const {
    MatrixXd m(first.rows(), first.cols() + second.cols());
    m << first, second;
    return m;
  }
  const MatrixXd& larger() const { return first.cols() >= second.cols() ? first : second; }
  const MatrixXd& smaller() const { return first.cols() >= second.cols() ? second : first; }
};

/// Whether one contains the other: together they span no more than the larger does.
template <class Rank>
bool by_rank(const Pair& pair, const Rank& rank_of) {
  return rank_of(pair.both()) == std::max(rank_of(pair.first), rank_of(pair.second));
}

/// The rank of a matrix of whole numbers, by divisions without remainder [Bareiss, Math. Comp. 22, 1968, p.
/// 565].
int exact_rank(const MatrixXd&);
MatrixXd whole(Random&, long rows, long columns);
/// Pairs in dimensions 2 to 5: contained, coincident, and with at least one direction outside (a column that
/// increases the larger's rank).
std::vector<Pair> random_pairs(double seed, int count);
MatrixXd column(std::initializer_list<double>);

std::vector<Claim> claims(double seed);

}  // namespace oddity::ex08_03
