// Exercise 7.9: the determinant of a 4 x 4 matrix as a sum over permutations, and the table of its 24 terms:
//   det A = sum_s e_s a_s(1)1 a_s(2)2 a_s(3)3 a_s(4)4, e_s = +1 for an even permutation s, -1 for an odd one.
// Every row of the table is checked by the determinant of whole numbers at its four places and zeros
// elsewhere, by fraction-free elimination, which is independent of permutations. All of this is exact.

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "chapters/07_linear_algebra/09_determinant_4x4/determinant_4x4.hpp"
#include "chapters/07_linear_algebra/shared/double_double.hpp"
#include "chapters/inputs.hpp"
#include "reference/reference.hpp"
#include "reference/text.hpp"
#include "solvers/counted.hpp"
#include "solvers/linear.hpp"

namespace oddity {

namespace ex07_09 {

constexpr std::array<std::string_view, 16> letters{"a11", "a12", "a13", "a14", "a21", "a22", "a23", "a24",
                                                   "a31", "a32", "a33", "a34", "a41", "a42", "a43", "a44"};
constexpr auto parameters =
    together(std::array{Parameter{"s", 0, "", "shift of the Hilbert matrix $1/(i+j-1+s)$", 0, 20},
                        Parameter{"m", 300, "",
                                  "largest entry of the triangular factors of the matrix of determinant one",
                                  1, 300, whole_number},
                        Parameter{"seed", 1, "", "seed of the random matrices", 0, 1e9, whole_number}},
             numbers<16>(letters, {4, 1, -2, 2, 1, 2, 0, 1, -2, 0, 3, -2, 2, 1, -2, -1}, "",
                         "entry of a matrix that you choose", 1e70));

// ---- the methods ------------------------------------------------------------------------------------------

/// Minors of the upper two rows times those of the lower two (Laplace).
template <class T>
T by_minors(const Matrix4<T>& m) {
  const auto pair = [&](std::size_t a, std::size_t b, std::size_t c, std::size_t d) {
    return minor_2(m, 0, 1, a, b) * minor_2(m, 2, 3, c, d);
  };
  return pair(0, 1, 2, 3) - pair(0, 2, 1, 3) + pair(0, 3, 1, 2) + pair(1, 2, 0, 3) - pair(1, 3, 0, 2) +
         pair(2, 3, 0, 1);
}

double number(Whole x) { return static_cast<double>(x); }

Matrix4<Whole> product(const Matrix4<Whole>& a, const Matrix4<Whole>& b) {
  Matrix4<Whole> m{};
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < 4; ++j)
      for (std::size_t k = 0; k < 4; ++k) m[i][j] += a[i][k] * b[k][j];
  return m;
}

/// A triangular matrix of whole numbers with ones on the diagonal.
Matrix4<Whole> triangular(Random& random, int size, bool upper) {
  Matrix4<Whole> m = random_matrix(random, size);
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < 4; ++j)
      if (i == j || (j > i) != upper) m[i][j] = i == j;
  return m;
}

/// An expansion in numbers of 24, 53 or 106 bits, with its multiplications counted beforehand.
Method expansion(std::string algorithm, const Matrix4<double>& m, const auto& determinant,
                 std::string why = {}) {
  const auto numbers = cast<Counted<double>>(m, [](double x) { return x; });
  const long work = operations_of([&] { return determinant(numbers); }).all_but_additions();
  const auto single = cast<float>(m, [](double x) { return static_cast<float>(x); });
  const auto twice = cast<DoubleDouble>(m, [](double x) { return DoubleDouble(x); });
  return {"expansion",
          std::move(algorithm),
          {"significant bits", {24, 53, 106}},
          [=](double bits) {
            return Answer{bits == 24   ? double{determinant(single)}
                          : bits == 53 ? determinant(m)
                                       : static_cast<double>(determinant(twice)),
                          work};
          },
          Outcome::ok,
          std::move(why)};
}

/// Adds all expansions, including `terms`, and elimination.
void add_methods(Quantity& q, const Matrix4<double>& m, const auto& terms, Outcome of_elimination,
                 const std::string& why) {
  q.add(expansion("24 terms", m, terms));
  q.add(expansion("cofactors of the first row", m, [](const auto& a) { return by_cofactors(a); }));
  q.add(expansion("2 x 2 minors", m, [](const auto& a) { return by_minors(a); }));
  Eigen::MatrixXd dense(4, 4);
  for (int i = 0; i < 16; ++i)
    dense(i / 4, i % 4) = m[static_cast<std::size_t>(i / 4)][static_cast<std::size_t>(i % 4)];
  q.add({"elimination", "LU, rows exchanged", no_resolution(),
         [=](double) { return answer(determinant(dense)); }, of_elimination, why});
}

double largest_term(const Matrix4<double>& m) {
  double largest = 0;
  for (const Term& term : printed_terms()) largest = std::max(largest, std::abs(term_of(term, m)));
  return largest;
}

/// The printed sum.
template <class T>
T by_terms(const std::vector<Term>& terms, const Matrix4<T>& m) {
  T sum = term_of(terms[0], m);
  for (std::size_t i = 1; i < terms.size(); ++i)
    sum = terms[i].negative ? sum - term_of(terms[i], m) : sum + term_of(terms[i], m);
  return sum;
}

auto printed_sum() {
  return [terms = printed_terms()](const auto& m) { return by_terms(terms, m); };
}

/// The determinant of the user's matrix. Its terms may cancel, so the tolerance is nine digits of them.
Quantity own_determinant(const Parameters& p, const Reference& truth) {
  Matrix4<double> m;
  std::vector<double> given;
  for (std::string_view name : letters) given.push_back(p[name]);
  for (std::size_t i = 0; i < 16; ++i) m[i / 4][i % 4] = given[i];
  double terms = 1;  // at least as large as the largest of the 24
  for (const auto& row : m)
    terms *= std::abs(*std::ranges::max_element(row, {}, [](double x) { return std::abs(x); }));
  Quantity q = quantity("determinant", "", "determinant of the matrix of the entries a11 to a44",
                        truth("07_09_determinant", given),
                        {terms > 0 ? 1e-9 * terms : 1e-300, "nine digits of the product of row maxima"});
  add_methods(q, m, printed_sum(), Outcome::ok, "");
  return q;
}

Matrix4<double> hilbert_matrix(double s) {
  Matrix4<double> m;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < 4; ++j) m[i][j] = 1 / (static_cast<double>(i + j + 1) + s);
  return m;
}

Quantity hilbert(std::string name, double s, const Reference& truth) {
  const Matrix4<double> m = hilbert_matrix(s);
  std::vector<double> entries;
  for (const auto& row : m) entries.insert(entries.end(), row.begin(), row.end());
  const Known known = truth("07_09_determinant", entries);
  Quantity q = quantity(
      std::move(name), "",
      "determinant of the Hilbert matrix $1/(i+j-1+" + format_shortest(s) + ")$, its entries rounded", known,
      {1e-9 * std::abs(known.value[0]), "nine significant digits"});
  add_methods(q, m, printed_sum(), Outcome::ok, "");
  return q;
}

Quantity determinant_one(int size, Random random) {
  const Matrix4<Whole> first = triangular(random, size, false), second = triangular(random, size, true);
  const Matrix4<Whole> m = product(product(first, second), triangular(random, size, false));
  Quantity q{"determinant_one",
             "",
             "determinant of a matrix of large whole numbers",
             {"1: the product of triangular matrices with ones on their diagonals", 1.0},
             0,
             {1e-9, "nine significant digits"},
             {},
             {}};
  add_methods(q, cast<double>(m, number), printed_sum(), Outcome::diverged,
              "the last pivot is nothing but rounding error");
  const auto counted = cast<Counted<Whole>>(m, [](Whole x) { return x; });
  const long work = operations_of([&] { return printed_sum()(counted); }).all_but_additions();
  q.add({"exact", "24 terms, whole numbers of 128 bits", no_resolution(),
         [m, work, sum = printed_sum()](double) {
           return Answer{number(sum(m)), work};
         }});
  const std::string says =
      "The terms are up to $@1$ and cancel to 1; in doubles only their rounding is left. In whole "
      "numbers nothing is lost, and twice the digits are enough too.";
  const std::vector<Told> terms{largest_term(cast<double>(m, number))};
  q.add(Breakdown{says, "expansion, 24 terms", 53, Outcome::diverged,
                  "exact, 24 terms, whole numbers of 128 bits", 0, terms});
  q.add(Breakdown{says, "elimination, LU, rows exchanged", 0, Outcome::diverged, "expansion, 2 x 2 minors",
                  106, terms});
  return q;
}

Findings study(const Parameters& p, const Reference& truth) {
  const Random random(p["seed"]);
  constexpr double shift = 8;
  Quantity shifted = hilbert("hilbert_shifted", shift, truth);
  shifted.add(
      Breakdown{"The 24 terms are up to $@1$ and cancel to $@1$; every expansion loses digits with them. "
                "Elimination of this positive definite matrix keeps them.",
                "expansion, 24 terms",
                53,
                Outcome::inaccurate,
                "elimination, LU, rows exchanged",
                0,
                {largest_term(hilbert_matrix(shift)), shifted.reference.value[0]}});
  return {claims(random),
          in_operations({hilbert("hilbert", p["s"], truth), shifted,
                         determinant_one(static_cast<int>(p["m"]), random), own_determinant(p, truth)})};
}

}  // namespace ex07_09

Exercise exercise_7_9() {
  using namespace ex07_09;
  return {"The 24 terms of a determinant",
          "Write out $\\det A=\\sum_\\sigma\\varepsilon_\\sigma "
          "a_{\\sigma(1)1}a_{\\sigma(2)2}a_{\\sigma(3)3}a_{\\sigma(4)4}$ for a $4\\times4$ matrix: all 24 "
          "terms with their signs.",
          parameters,
          {},
          study,
          proofs};
}

}  // namespace oddity
