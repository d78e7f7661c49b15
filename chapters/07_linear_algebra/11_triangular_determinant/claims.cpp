// The claims of exercise 7.11, in whole numbers. Cofactors are compared with fraction-free elimination.

#include <cmath>

#include "chapters/07_linear_algebra/11_triangular_determinant/triangular_determinant.hpp"
#include "chapters/07_linear_algebra/shared/matrices.hpp"
#include "chapters/claims.hpp"

namespace oddity::ex07_11 {

namespace {

using namespace matrices;

constexpr int largest = 8;  ///< size

/// A random matrix M of whole numbers, or U, which is zero below its diagonal; one of each is all zero.
struct Sample {
  static constexpr bool whole = true;
  Matrix<Whole> m;
  double size() const { return std::pow(9.0, m.n); }
  TypesetLetters typeset() const;
  std::string where() const { return "$n$ = " + std::to_string(m.n); }
};

std::vector<Sample> matrices_of_whole_numbers(Random random, bool triangular) {
  std::vector<Sample> all;
  for (int n = largest; n >= 1; --n)
    for (int sample = 0; sample < 10; ++sample)
      all.push_back({filled<Whole>(n, [&](int r, int c) {
        const Whole size = 1 + random.below(9), x = random.unit() < 0.5 ? -size : size;
        return triangular && r > c ? 0 : x;
      })});
  all.push_back({Matrix<Whole>{3}});  // no column has a pivot
  return all;
}

/// The matrix without its last row and one column.
Matrix<Whole> minor_of(const Matrix<Whole>& m, int column) {
  return filled<Whole>(m.n - 1, [&](int r, int c) { return m(r, c + (c >= column)); });
}
/// For smaller matrices, missing entries of the last row are zero and missing diagonal entries are one.
TypesetLetters Sample::typeset() const {
  const auto number = [](Whole x) { return static_cast<double>(x); };
  TypesetLetters all{{"n", m.n},
                     {"u_{nn}", number(m(m.n - 1, m.n - 1))},
                     {R"(\det M)", number(bareiss(m))},
                     {R"(\det U)", number(bareiss(m))},
                     {R"(\det U')", number(bareiss(minor_of(m, m.n - 1)))}};
  for (int k = 0; k < largest; ++k) {
    const std::string at = std::to_string(k + 1);
    const bool inside = k < m.n;
    all.emplace_back("u_{" + at + at + "}", inside ? number(m(k, k)) : 1.0);
    all.emplace_back("u_{n" + at + "}", inside ? number(m(m.n - 1, k)) : 0.0);
    all.emplace_back(R"(\det U_{n)" + at + "}", inside ? number(bareiss(minor_of(m, k))) : 0.0);
  }
  return all;
}

/// M with an additional last row and column, zero except for their common entry 2.
Matrix<Whole> bordered(const Matrix<Whole>& m) {
  return filled<Whole>(m.n + 1,
                       [&](int r, int c) { return r < m.n && c < m.n ? m(r, c) : Whole{r == c ? 2 : 0}; });
}

Formula<Sample> in_whole(std::string text, const std::function<Whole(const Matrix<Whole>&)>& of) {
  return {std::move(text), [=](const Sample& s) { return values(of(s.m)); }};
}

/// Sum of the squares of the entries below the diagonal.
Whole below(const Matrix<Whole>& m) {
  Whole sum = 0;
  for (int r = 0; r < m.n; ++r)
    for (int c = 0; c < r; ++c) sum += m(r, c) * m(r, c);
  return sum;
}

}  // namespace

std::vector<Claim> claims(const Random& random) {
  Claims claims("7.11");
  const auto full = matrices_of_whole_numbers(random, false), upper = matrices_of_whole_numbers(random, true);
  using Of = Formula<Sample>;
  const auto add = [&](const char* slug, int line, const char* says, const std::vector<Sample>& samples,
                       const char* quantity, const Of& truth, const Of& printed,
                       const std::vector<Of>& near_misses = {}, const char* others_hold = "") {
    claims.formula<Sample>(slug, line, says, samples,
                           {.quantity = quantity,
                            .truth = truth,
                            .printed = printed,
                            .near_misses = near_misses,
                            .changes_that_hold = others_hold});
  };
  using M = const Matrix<Whole>&;
  const auto zero = in_whole("zero", [](M) { return Whole{0}; }),
             det = in_whole("fraction-free elimination", bareiss);

  add("expansion", 3965,
      R"($\det U$ is its cofactor expansion by the last row, $\sum_c(-1)^{n+c}u_{nc}\det U_{nc}$)", full,
      R"($\det M$)", det, {R"($\sum_c(-1)^{n+c}u_{nc}\det U_{nc}$)"}, {}, "an exponent of $-1$ has no sign");
  add("only_contribution", 3965, "only the entry $u_{nn}$ contributes to the determinant", upper,
      "elimination's determinant less the expansion's last term", zero, {R"($\det U=u_{nn}\det U'$)"});
  add("submatrix", 3965, "the submatrix $U'$ of the first $n-1$ rows and columns is upper triangular too",
      upper, "sum of squares below the diagonal", zero,
      in_whole("$U$ without its last row and column, its squares below the diagonal",
               [](M m) { return below(minor_of(m, m.n - 1)); }),
      {in_whole("without the last row and the first column", [](M m) { return below(minor_of(m, 0)); })});
  add("recursion", 3967, R"($\det U=u_{nn}\det U'$)", upper, R"($\det U$)", det, {R"($u_{nn}\det U'$)"});
  add("sign", 3969, "the sign of $u_{nn}$ in the expansion is $+1$ for every $n$", full,
      R"(half the determinant of $M$ bordered by $0,\ldots,0,2$)",
      in_whole("elimination of the bordered matrix", [](M m) { return bareiss(bordered(m)) / 2; }),
      {R"($\det M$)"}, {{R"($(-1)^{n+1}\det M$)"}});
  add("product", 3971, R"($\det U=u_{nn}u_{n-1,n-1}\cdots u_{11}$, the product of the diagonal entries)",
      upper, R"($\det U$)", det, {"$u_{88}u_{77}u_{66}u_{55}u_{44}u_{33}u_{22}u_{11}$"});
  return claims.in_order();
}

}  // namespace oddity::ex07_11
