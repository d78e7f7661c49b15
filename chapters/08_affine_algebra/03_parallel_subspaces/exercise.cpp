// Exercise 8.3: affine subspaces A1 = P1 + V1 and A2 = P2 + V2 are parallel if V1 contains V2 or V2 contains
// V1. Equivalently, rank [V1 V2] = max(rank V1, rank V2). The book's are lines along the x-axis and the
// y-axis. The reference for random subspaces is how they were constructed. Exact ranks are by elimination in
// integers.

#include <algorithm>
#include <vector>

#include "chapters/08_affine_algebra/03_parallel_subspaces/parallel_subspaces.hpp"
#include "reference/text.hpp"
#include "solvers/counted_calls.hpp"
#include "solvers/linear.hpp"

namespace oddity {

namespace ex08_03 {

constexpr Parameter parameters[] = {
    {"pairs", 60, "", "random pairs of subspaces", 1, 500, whole_number},
    {"seed", 1, "", "seed of the random pairs", 0, 1e9, whole_number},
};

// ---- vector spaces ----------------------------------------------------------------------------------------

__extension__ typedef __int128 Wide;

int exact_rank(const MatrixXd& a) {
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

/// Gaussian elimination with complete pivoting; pivots below `relative` times the first count as zero.
int eliminated_rank(MatrixXd a, double relative) {
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

/// Projects the smaller's columns on the larger, until one leaves a residual.
bool by_projection(const Pair& pair, double relative, long& projections) {
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

MatrixXd whole(Random& random, long rows, long columns) {
  MatrixXd m(rows, columns);
  for (long i = 0; i < rows; ++i)
    for (long j = 0; j < columns; ++j) m(i, j) = random.below(9) - 4;
  return m;
}

MatrixXd independent(Random& random, long rows, long columns) {
  while (true) {
    const MatrixXd m = whole(random, rows, columns);
    if (exact_rank(m) == columns) return m;
  }
}

std::vector<Pair> random_pairs(double seed, int count) {
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

MatrixXd column(std::initializer_list<double> xs) {
  MatrixXd m(static_cast<long>(xs.size()), 1);
  long i = 0;
  for (double x : xs) m(i++, 0) = x;
  return m;
}

// ---- methods ----------------------------------------------------------------------------------------------

/// 1 for parallel, 0 for not, pair by pair. A rank or a projection counts as one evaluation.
template <class Judge>
Answer judged(const std::vector<Pair>& pairs, const Judge& judge) {
  Answer answer;
  std::vector<double> verdicts;
  for (const Pair& pair : pairs) {
    verdicts.push_back(judge(pair, answer.evaluations));
  }
  answer.value = Value(std::move(verdicts));
  return answer;
}

Quantity parallel(std::string name, std::string says, std::string because, const std::vector<Pair>& pairs,
                  Outcome in_integers, Outcome in_doubles, const std::string& why) {
  std::vector<double> truth;
  for (const Pair& pair : pairs) truth.push_back(pair.parallel);
  Quantity q{
      std::move(name), "1", std::move(says), {std::move(because), truth}, 0, {0.5, "whole numbers"}, {}, {}};
  const auto add = [&](const char* model, const char* algorithm, const Resolution& resolution,
                       Outcome expected, const auto& judge) {
    q.add({model, algorithm, resolution,
           [=](double e) {
             return judged(pairs, [=](const Pair& pair, long& calls) { return judge(pair, e, calls); });
           },
           expected, expected == Outcome::ok ? "" : why});
  };
  const Resolution resolution = tolerances(2, 12, 5);
  const auto ranks = [&](const char* algorithm, const Resolution& settings, Outcome expected,
                         const auto& rank_of) {
    add("ranks", algorithm, settings, expected, [rank_of](const Pair& pair, double e, long& calls) {
      const auto of = [&](const MatrixXd& m) { return rank_of(m, e); };
      return by_rank(pair, counted_calls(of, calls));
    });
  };
  ranks("elimination in integers", no_resolution(), in_integers,
        [](const MatrixXd& m, double) { return exact_rank(m); });
  ranks("singular values", resolution, in_doubles, [](const MatrixXd& m, double e) { return rank(m, e); });
  ranks("elimination, complete pivoting", resolution, in_doubles,
        [](const MatrixXd& m, double e) { return eliminated_rank(m, e); });
  add("projection", "Householder QR", resolution, in_doubles,
      [](const Pair& pair, double e, long& calls) { return by_projection(pair, e, calls); });
  return q;
}

/// Directions (10^k, 1), each paired with (10^k + 1, 1) and with three times itself.
std::vector<Pair> nearly_parallel() {
  std::vector<Pair> all;
  for (int k = 1; k <= 12; ++k) {
    const double large = std::round(std::pow(10, k));
    all.push_back({column({large, 1}), column({large + 1, 1}), false});
    all.push_back({column({large, 1}), column({3 * large, 3}), true});
  }
  return all;
}

/// Directions and their multiples by factors that round, in units of 2^-52, so that they are whole numbers.
std::vector<Pair> rounded_multiples(double seed) {
  Random random(seed);
  std::vector<Pair> all;
  for (int n = 0; n < 12; ++n) {
    const double x = random.between(1, 2), y = random.between(1, 2), factor = random.between(1, 2);
    all.push_back({0x1p52 * column({x, y}), 0x1p52 * column({factor * x, factor * y}), true});
    all.push_back({0x1p52 * column({x, y}), 0x1p52 * column({factor * x, 1.25 * factor * y}), false});
  }
  return all;
}

Findings study(const Parameters& p, const Reference&) {
  const Outcome ok = Outcome::ok, wrong = Outcome::inaccurate;
  Quantity random = parallel("random_pairs", "are they parallel? 1 or 0", "as they were made",
                             random_pairs(p["seed"], static_cast<int>(p["pairs"])), ok, ok, "");
  Quantity nearly = parallel("nearly_parallel",
                             R"(are $(10^k,1)$ and $(10^k+1,1)$ parallel? $(10^k,1)$ and $(3\cdot10^k,3)$?)",
                             "the determinants $-1$ and 0", nearly_parallel(), ok, wrong,
                             R"(for $k\ge8$ an angle of $10^{-2k}$, below what rounding allows)");
  constexpr double large = 1e8, determinant = large * 1 - (large + 1) * 1;
  nearly.add(Breakdown{
      "$(10^8,1)$ and $(10^8+1,1)$ have the determinant $@1$ and the sine $@1$: to singular "
      "values, at any tolerance above rounding, they are parallel. Whole numbers are decided in whole numbers.",
      "ranks, singular values",
      1e-12,
      wrong,
      "ranks, elimination in integers",
      0,
      {determinant, std::abs(determinant) / (std::hypot(large, 1) * std::hypot(large + 1, 1))}});
  Quantity rounded =
      parallel("rounded_multiples", "are $v$ and its rounded multiple parallel?", "as they were made",
               rounded_multiples(p["seed"]), wrong, ok, "the multiple is rounded, and exactness is no help");
  rounded.add(Breakdown{
      "Exact arithmetic on rounded numbers judges the rounding. Where the data are measured or computed, "
      "only a tolerance above their error makes sense.",
      "ranks, elimination in integers", 0, wrong, "ranks, singular values", 1e-12});
  return {claims(p["seed"]), {random, nearly, rounded}};
}

}  // namespace ex08_03

Exercise exercise_8_3() {
  using namespace ex08_03;
  return {"Parallel affine subspaces",
          "Two affine subspaces $A_i=P_i+V_i$: are they parallel, that is, does one of the vector spaces "
          "$V_1$, $V_2$ "
          "contain the other?",
          parameters,
          {},
          study,
          nullptr,
          Expected::in_whole_ranges};
}

}  // namespace oddity
