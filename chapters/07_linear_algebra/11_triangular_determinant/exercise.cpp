// Exercise 7.11: the determinant of an upper triangular matrix, by cofactors of its last row over and over,
// is the product of its diagonal entries, u_nn ... u_11. The other route is fraction-free elimination in
// whole numbers (Bareiss 1968), which knows neither cofactors nor, since it is given full matrices too,
// triangles. Higham, Accuracy and Stability, 2nd ed., 14.6.

#include <cmath>

#include "chapters/07_linear_algebra/11_triangular_determinant/diagonals.hpp"
#include "chapters/07_linear_algebra/shared/matrices.hpp"

namespace oddity {

namespace ex07_11 {

using namespace matrices;

constexpr Parameter parameters[] = {
    {"n", 40, "", "size of the triangular matrix", 2, 100, whole_number},
    {"e", 60, "", "exponent of two in its diagonal entries", 0, 300, whole_number},
    {"seed", 1, "", "seed of the random matrices", 0, 1e9, whole_number},
};

// ---- the claims -------------------------------------------------------------------------------------------

Matrix<Whole> random_matrix(int n, Random& random, bool triangular) {
  return filled<Whole>(n, [&](int r, int c) {
    const Whole size = 1 + random.below(9), x = random.unit() < 0.5 ? -size : size;
    return triangular && r > c ? 0 : x;
  });
}

/// Without one row and one column.
Matrix<Whole> minor_of(const Matrix<Whole>& m, int row, int column) {
  return filled<Whole>(m.n - 1, [&](int r, int c) { return m(r + (r >= row), c + (c >= column)); });
}

/// Of u_n1, ..., u_nn the term `column` of the cofactor expansion.
Whole cofactor_term(const Matrix<Whole>& m, int column) {
  const Whole term = m(m.n - 1, column) * bareiss(minor_of(m, m.n - 1, column));
  return (m.n - 1 + column) % 2 == 0 ? term : -term;
}

/// Two whole numbers for random matrices of 1 to 8 rows, exactly.
Reading equal(std::string text, const std::string& left, const std::string& right, Random random,
              bool triangular, const auto& one, const auto& other) {
  Worst worst(left + " and " + right, left, right);
  for (int n = 8; n >= 1; --n)
    for (int sample = 0; sample < 10; ++sample) {
      const auto m = random_matrix(n, random, triangular);
      worst.see(static_cast<double>(one(m)), static_cast<double>(other(m)), exact(), std::pow(9.0, n),
                "n = " + std::to_string(n));
    }
  return {std::move(text), {worst.check()}};
}

Claim claim(std::string id, int line, std::string says, Reading printed, Reading near_miss) {
  Claim c{std::move(id), line, std::move(says)};
  c.printed = std::move(printed);
  c.near_misses = {std::move(near_miss)};
  return c;
}

Whole product_of(const Matrix<Whole>& m, int last) {
  Whole product = 1;
  for (int k = m.n - 1; k >= last; --k) product *= m(k, k);
  return product;
}

/// M bordered by a last row and column that are zero but for their common entry 1.
Matrix<Whole> bordered(const Matrix<Whole>& m) {
  return filled<Whole>(m.n + 1, [&](int r, int c) { return r < m.n && c < m.n ? m(r, c) : Whole{r == c}; });
}

/// The matrix with the first `columns` columns cleared below the diagonal, without a remainder (Bareiss
/// 1968).
Matrix<Whole> eliminated(Matrix<Whole> m, int columns) {
  Whole previous = 1;
  for (int k = 0; k < columns; ++k) {
    for (int pivot = k; m(k, k) == 0 && pivot < m.n; ++pivot)
      for (int c = 0; m(pivot, k) != 0 && c < m.n; ++c) std::swap(m(k, c), m(pivot, c));
    const Matrix<Whole> before = m;
    if (before(k, k) == 0) continue;
    for (int r = k + 1; r < m.n; ++r)
      for (int c = k; c < m.n; ++c)
        m(r, c) = (before(k, k) * before(r, c) - before(r, k) * before(k, c)) / previous;
    previous = before(k, k);
  }
  return m;
}

std::vector<Claim> claims(const Random& random) {
  const auto determinant_of = [](const auto& m) { return bareiss(m); };
  const auto none = [](const auto&) { return Whole{0}; };
  const auto last_row = [](const auto& m) {
    Whole sum = 0;
    for (int c = 0; c < m.n; ++c) sum += cofactor_term(m, c);
    return sum;
  };
  const auto first_entries = [](const auto& m) {
    Whole sum = 0;
    for (int c = 0; c + 1 < m.n; ++c) sum += m(m.n - 1, c) * m(m.n - 1, c);
    return sum;
  };
  const auto last_term = [](const auto& m) { return cofactor_term(m, m.n - 1); };
  const auto below = [](const Matrix<Whole>& m) {
    Whole sum = 0;
    for (int r = 0; r < m.n; ++r)
      for (int c = 0; c < r; ++c) sum += m(r, c) * m(r, c);
    return sum;
  };
  const auto recursion = [](int corner) {
    return [=](const auto& m) {
      return m(corner < 0 ? m.n - 1 : corner, corner < 0 ? m.n - 1 : corner) *
             bareiss(minor_of(m, m.n - 1, m.n - 1));
    };
  };
  const std::string det = "det U by elimination";
  return {
      claim("7.11-expansion", 3965, "the determinant is the cofactor expansion by the last row",
            equal("full matrices", "sum over the last row", "det by elimination", random, false, last_row,
                  determinant_of),
            equal("the last term alone", "last term", "det by elimination", random, false, last_term,
                  determinant_of)),
      claim("7.11-zeros", 3965, "the first n-1 entries of the last row are zero",
            equal(
                "U, left by an elimination", "sum of squares of u_n1, ..., u_n,n-1", "0", random, false,
                [&](const auto& m) { return first_entries(eliminated(m, m.n - 1)); }, none),
            equal(
                "before its last column is cleared", "sum of squares of u_n1, ..., u_n,n-1", "0", random,
                false, [&](const auto& m) { return first_entries(eliminated(m, m.n - 2)); }, none)),
      claim("7.11-only_contribution", 3965, "only the entry u_nn contributes",
            equal("the last term is all of det U", "last term", det, random, true, last_term, determinant_of),
            equal(
                "with one entry not zero below the diagonal", "last term", det, random, true,
                [&](auto m) { return m(m.n - 1, 0) = 5, last_term(m); },
                [&](auto m) { return m(m.n - 1, 0) = 5, bareiss(m); })),
      claim("7.11-submatrix", 3965, "without its last row and column U is upper triangular again",
            equal(
                "U'", "sum of squares below the diagonal", "0", random, true,
                [&](const auto& m) { return below(minor_of(m, m.n - 1, m.n - 1)); }, none),
            equal(
                "without the last row and the first column", "sum of squares below the diagonal", "0", random,
                true, [&](const auto& m) { return below(minor_of(m, m.n - 1, 0)); }, none)),
      claim("7.11-recursion", 3967, "det U = u_nn det U'",
            equal("u_nn det U'", "u_nn det U'", det, random, true, recursion(-1), determinant_of),
            equal("u_11 det U'", "u_11 det U'", det, random, true, recursion(0), determinant_of)),
      claim("7.11-sign", 3969, "the sign of u_nn is + for every n",
            equal(
                "+", "det of M bordered by 0 ... 0 1", "det M", random, false,
                [](const auto& m) { return bareiss(bordered(m)); }, determinant_of),
            equal(
                "(-1)^n", "det of M bordered by 0 ... 0 1", "det M", random, false,
                [](const auto& m) { return bareiss(bordered(m)); },
                [](const auto& m) { return m.n % 2 == 0 ? -bareiss(m) : bareiss(m); })),
      claim("7.11-product", 3971, "det U = u_nn ... u_11",
            equal(
                "u_nn ... u_11", "u_nn ... u_11", det, random, true,
                [](const auto& m) { return product_of(m, 0); }, determinant_of),
            equal(
                "u_nn ... u_22", "u_nn ... u_22", det, random, true,
                [](const auto& m) { return product_of(m, 1); }, determinant_of))};
}

Findings study(const Parameters& p, const Reference& truth) {
  const Random random(p["seed"]);
  const int n = static_cast<int>(p["n"]), e = static_cast<int>(p["e"]);
  return {claims(random),
          {diagonals::determinant_of(n, e, truth), diagonals::log_determinant(n, e, truth, random)}};
}

}  // namespace ex07_11

Exercise exercise_7_11() {
  using namespace ex07_11;
  return {"The determinant of a triangular matrix",
          "Show that the determinant of an upper triangular matrix is the product of its diagonal entries. "
          "What if that product, or a part of it, is out of the range of a double?",
          parameters,
          {},
          study};
}

}  // namespace oddity
