// Exercise 7.3: (AB)^T = B^T A^T, line by line, with a'_rc = a_cr, b'_rc = b_cr and m_rc = sum_k a_rk b_kc.
// The independent route never forms a product of matrices. Column r of AB is A(B e_r). A transpose moves a
// matrix to the other side of a scalar product, y.(M x) = (M^T y).x. All numbers are whole, so it is exact.
// In floating point both sides have the same bits if their sums run in the same order, fused or not. The law
// a b = b a is exact, but a + (b + c) = (a + b) + c is not.

#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "chapters/07_linear_algebra/03_transpose_of_product/transpose_of_product.hpp"
#include "chapters/07_linear_algebra/shared/double_double.hpp"
#include "chapters/07_linear_algebra/shared/matrices.hpp"
#include "solvers/counted.hpp"

namespace oddity {

namespace ex07_03 {

using namespace matrices;

constexpr Parameter parameters[] = {
    {"decades", 8, "", "range of the sizes of random entries", 1, 100},
    {"m", 200, "", "largest entry of the triangular factors of $B$, whose inverse is $A$", 1, 200,
     whole_number},
    {"seed", 1, "", "seed of the random matrices", 0, 1e9, whole_number},
};

// ---- in floating point ------------------------------------------------------------------------------------

/// Operations of a product of two matrices, the same for any order of the sums.
long work_of_product(int n) {
  const Matrix<Counted<double>> factor{n};
  return operations_of([&] { return product(factor, factor, Order::ascending); }).all_but_additions();
}

/// Counts entries of (AB)^T and B^T A^T that are not the same double.
template <class T>
Answer differing(int n, double decades, Random random, Order left, Order right, long work) {
  const auto entry = [&](int, int) {
    return T(random.magnitude(std::pow(10, -decades / 2), std::pow(10, decades / 2)));
  };
  const auto a = filled<T>(n, entry), b = filled<T>(n, entry);
  const auto one = transposed(product(a, b, left)), other = product(transposed(b), transposed(a), right);
  double count = 0;
  for (std::size_t i = 0; i < one.entries.size(); ++i)
    count += static_cast<double>(one.entries[i]) != static_cast<double>(other.entries[i]);
  return {count, work};
}

Quantity same_bits(double decades, const Random& random) {
  Quantity q{"differing_entries",
             "",
             "entries in which $(AB)^T$ and $B^TA^T$ differ, random matrices",
             {"none, in exact arithmetic", 0.0},
             0,
             {0, "bit for bit"},
             {},
             {}};
  const Resolution sizes = doubling("n", 2, 5);
  std::map<double, long> work;  // for both sides
  for (double n : sizes.settings) work[n] = 2 * work_of_product(static_cast<int>(n));
  const auto add = [&]<class T>(T, std::string model, std::string algorithm, Order left, Order right,
                                Outcome expected, std::string why) {
    q.add({std::move(model), std::move(algorithm), sizes,
           [=](double n) {
             return differing<T>(static_cast<int>(n), decades, random, left, right, work.at(n));
           },
           expected, std::move(why)});
  };
  const Outcome equal = Outcome::ok, differ = Outcome::inaccurate;
  const std::string associative = "addition is not associative",
                    once = "the fused sum rounds once a term, the plain one twice";
  add(0.0, "doubles", "both sums ascending", Order::ascending, Order::ascending, equal, "");
  add(0.0, "doubles", "both sums pairwise", Order::pairwise, Order::pairwise, equal, "");
  add(0.0, "doubles", "both sums fused", Order::fused, Order::fused, equal, "");
  add(0.0, "doubles", "ascending and descending", Order::ascending, Order::descending, differ, associative);
  add(0.0, "doubles", "ascending and pairwise", Order::ascending, Order::pairwise, differ, associative);
  add(0.0, "doubles", "ascending and fused", Order::ascending, Order::fused, differ, once);
  add(DoubleDouble(), "twice the digits, then rounded", "ascending and descending", Order::ascending,
      Order::descending, equal, "");
  q.add(Breakdown{
      "The two sides agree bit for bit only if their sums run the same way. Sums in twice the digits, "
      "rounded at the end, agree in any order.",
      "doubles, ascending and descending", 32, differ,
      "twice the digits, then rounded, ascending and descending", 32});
  return q;
}

// ---- a product that cancels -------------------------------------------------------------------------------

/// The inverse of a triangular matrix of whole numbers with ones on its diagonal, by substitution: exact.
Matrix<Whole> inverse(const Matrix<Whole>& b) {
  Matrix<Whole> a{b.n};
  for (int c = 0; c < b.n; ++c)
    for (int r = c; r < b.n; ++r) {
      a(r, c) = r == c;
      for (int k = c; k < r; ++k) a(r, c) -= b(r, k) * a(k, c);
    }
  return a;
}

template <class T>
T converted(Whole x) {
  if constexpr (std::same_as<T, DoubleDouble>) {
    const double high = static_cast<double>(x);
    return {high, static_cast<double>(x - static_cast<Whole>(high))};
  } else {
    return static_cast<T>(x);
  }
}

Quantity identity(int size, Random random) {
  constexpr int n = 4;
  const auto triangle = [&] {
    return filled<Whole>(n, [&](int r, int c) {
      const Whole x = random.below(2 * size + 1) - size;
      return r == c ? 1 : r > c ? x : 0;
    });
  };
  const auto times = [](const auto& x, const auto& y) { return product(x, y, Order::ascending); };
  const auto first = triangle(), second = triangle(), third = triangle();
  const auto a = times(inverse(third), times(transposed(inverse(second)), inverse(first)));
  const auto b = times(first, times(transposed(second), third));
  const auto unit = filled<double>(n, [](int r, int c) { return r == c; });
  Quantity q{"product_with_inverse",
             "",
             "$(AB)^T$ for a matrix $B$ of whole numbers and its inverse $A$",
             {"the identity", unit.entries},
             0,
             {1e-9, "nine decimals"},
             {},
             {}};
  const long work = work_of_product(n);
  const auto add = [&]<class T>(T, std::string model, std::string algorithm, Order order, Outcome expected,
                                std::string why) {
    const auto number = [](const Matrix<Whole>& m) {
      return filled<T>(n, [&](int r, int c) { return converted<T>(m(r, c)); });
    };
    q.add({std::move(model), std::move(algorithm), no_resolution(),
           [=, left = number(a), right = number(b)](double) {
             std::vector<double> all;
             for (const T& x : transposed(product(left, right, order)).entries)
               all.push_back(static_cast<double>(x));
             return Answer{all, work};
           },
           expected, std::move(why)});
  };
  double entry = 0, term = 0;
  for (int r = 0; r < n; ++r)
    for (int k = 0; k < n; ++k) {
      const double left = std::abs(static_cast<double>(a(r, k)));
      entry = std::max(entry, left);
      for (int c = 0; c < n; ++c) term = std::max(term, left * std::abs(static_cast<double>(b(k, c))));
    }
  const std::string cancels = oddity::filled("terms of up to $@1$ cancel", {term});
  add(0.0, "doubles", "ascending", Order::ascending, Outcome::diverged, cancels);
  add(0.0, "doubles", "descending", Order::descending, Outcome::diverged, cancels);
  add(0.0, "doubles", "pairwise", Order::pairwise, Outcome::diverged, cancels);
  add(0.0, "doubles", "fused", Order::fused, Outcome::diverged, cancels);
  add(DoubleDouble(), "twice the digits", "ascending", Order::ascending, Outcome::ok, "");
  add(Whole(), "whole numbers of 128 bits", "ascending", Order::ascending, Outcome::ok, "");
  q.add(
      Breakdown{"The entries of the inverse are up to $@1$, the terms up to $@1$; no order of summation "
                "keeps the digits that a product of two doubles does not have.",
                "doubles, ascending",
                0,
                Outcome::diverged,
                "twice the digits, ascending",
                0,
                {entry, term}});
  return q;
}

Findings study(const Parameters& p, const Reference&) {
  const Random random(p["seed"]);
  return {claims(random),
          in_operations({same_bits(p["decades"], random), identity(static_cast<int>(p["m"]), random)})};
}

}  // namespace ex07_03

Exercise exercise_7_3() {
  using namespace ex07_03;
  return {
      "The transpose of a product",
      "Show that $(AB)^T=B^TA^T$ for $n\\times n$ matrices, entry by entry. Does it hold in floating point?",
      parameters,
      {},
      study};
}

}  // namespace oddity
