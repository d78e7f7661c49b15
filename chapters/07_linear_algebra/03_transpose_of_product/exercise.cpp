// Exercise 7.3: (AB)^T = B^T A^T, line by line, with a'_rc = a_cr, b'_rc = b_cr and m_rc = sum_k a_rk b_kc.
// The other route never forms a product of matrices: column r of AB is A(B e_r), and a transpose is what
// moves a matrix to the other side of a scalar product, y.(M x) = (M^T y).x. All of it in whole numbers,
// exact. In floating point both sides have the same bits when their sums run in the same order, fused or not:
// a b = b a is exact, a + (b + c) = (a + b) + c is not.

#include <cmath>
#include <map>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include "chapters/07_linear_algebra/shared/double_double.hpp"
#include "chapters/07_linear_algebra/shared/matrices.hpp"
#include "chapters/claims.hpp"
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

// ---- the claims -------------------------------------------------------------------------------------------

template <class T>
T whole_number_of(Random& random) {
  const auto digit = [&] { return static_cast<double>(random.below(199) - 99); };
  if constexpr (std::same_as<T, double>) {
    return digit();
  } else {
    return {digit(), digit(), digit(), digit()};
  }
}

template <class T>
Matrix<T> whole_matrix(int n, Random& random) {
  return filled<T>(n, [&](int, int) { return whole_number_of<T>(random); });
}

std::vector<double> whole_vector(int n, Random& random) {
  std::vector<double> x;
  for (int i = 0; i < n; ++i) x.push_back(whole_number_of<double>(random));
  return x;
}

Value value(const std::vector<double>& x) { return x; }
Value value(const std::vector<Quaternion>& x) {
  std::vector<double> all;
  for (const Quaternion& q : x) all.insert(all.end(), {q.w, q.x, q.y, q.z});
  return all;
}

double dot(const std::vector<double>& u, const std::vector<double>& v) {
  return std::inner_product(u.begin(), u.end(), v.begin(), 0.0);
}

/// Two matrices.
template <class T>
struct Factors {
  static constexpr bool whole = true;
  Matrix<T> a, b;
  TypesetLetters typeset() const requires std::same_as<T, double> {
    TypesetLetters all;
    for (int r = 0; r < a.n; ++r)
      for (int c = 0; c < a.n; ++c) {
        const std::string at = "_{" + std::to_string(r + 1) + std::to_string(c + 1) + "}";
        for (const auto& [letter, value] :
             {std::pair{"a", a(r, c)}, {"b", b(r, c)}, {"a'", a(c, r)}, {"b'", b(c, r)}})
          all.emplace_back(letter + at, value);
      }
    return all;
  }
  std::string where() const { return "$n$ = " + std::to_string(a.n); }
};

template <class T>
std::vector<Factors<T>> factors(Random random) {
  std::vector<Factors<T>> all;
  for (int n = 8; n >= 1; --n)
    for (int sample = 0; sample < 10; ++sample)
      all.push_back({whole_matrix<T>(n, random), whole_matrix<T>(n, random)});
  return all;
}

/// Column r of AB as A(B e_r), written as row r: the transpose of the product, entry by entry.
template <class T>
Formula<Factors<T>> by_columns(const T& one) {
  return {"$A(Be_r)$, column by column", [=](const Factors<T>& f) {
            Matrix<T> all{f.a.n};
            for (int r = 0; r < f.a.n; ++r) {
              std::vector<T> unit(static_cast<std::size_t>(f.a.n));
              unit[static_cast<std::size_t>(r)] = one;
              const std::vector<T> column = applied(f.a, applied(f.b, unit));
              for (int c = 0; c < f.a.n; ++c) all(r, c) = column[static_cast<std::size_t>(c)];
            }
            return value(all.entries);
          }};
}

/// The entry (r, c) of (AB)^T as a sum over k.
template <class T>
using Term = T (*)(const Matrix<T>& a, const Matrix<T>& b, int r, int c, int k);

template <class T = double>
Formula<Factors<T>> sum_of(std::string text, std::type_identity_t<Term<T>> term) {
  return {std::move(text), [=](const Factors<T>& f) {
            return value(filled<T>(f.a.n, [&](int r, int c) {
                           T sum{};
                           for (int k = 0; k < f.a.n; ++k) sum = sum + term(f.a, f.b, r, c, k);
                           return sum;
                         }).entries);
          }};
}

/// The entry (r, c) of m'.
template <class T>
T primed(const Matrix<T>& m, int r, int c) {
  return m(c, r);
}

template <class T>
T swapped(const Matrix<T>& a, const Matrix<T>& b, int r, int c, int k) {
  return primed(b, r, k) * primed(a, k, c);
}

/// One matrix or the product of two between two vectors.
struct Between {
  static constexpr bool whole = true;
  Matrix<double> a, b;
  std::vector<double> x, y;
  /// Where n is 3: as many numbers as a letter can have.
  TypesetLetters typeset() const {
    if (b.n != 3) return {};
    const Value A = a.entries, B = b.entries, AT = transposed(a).entries, BT = transposed(b).entries;
    return {{"A^T", AT}, {"B^T", BT},     {"A", A},          {"B", B},        {"x", x},
            {"y", y},    {"[a_{rc}]", B}, {"[a'_{rc}]", BT}, {"[b_{rc}]", B}, {"[b'_{rc}]", BT}};
  }
  std::string where() const { return "$n$ = " + std::to_string(b.n); }
};

std::vector<Between> between(Random random, bool two) {
  std::vector<Between> all;
  for (int n = 8; n >= 2; --n)
    all.push_back({two ? whole_matrix<double>(n, random) : Matrix<double>{n}, whole_matrix<double>(n, random),
                   whole_vector(n, random), whole_vector(n, random)});
  return all;
}

std::vector<Claim> claims(const Random& random) {
  Claims claims("7.3");
  const auto pairs = factors<double>(random);
  const auto single = between(random, false);
  const auto entry = [&](const char* slug, int line, const char* says,
                         const Formula<Factors<double>>& printed, const Formula<Factors<double>>& near) {
    claims.formula<Factors<double>>(slug, line, says, pairs,
                                    {.quantity = R"(all entries $(r,c)$ of $(AB)^T$)",
                                     .truth = by_columns(1.0),
                                     .printed = printed,
                                     .near_misses = {near}});
  };
  using M = const Matrix<double>&;

  entry("product", 3815, R"($AB=[m_{rc}]$ with $m_{rc}=\sum_ka_{rk}b_{kc}$)",
        sum_of(R"($m_{cr}=\sum_ka_{ck}b_{kr}$)",
               [](M a, M b, int r, int c, int k) { return a(c, k) * b(k, r); }),
        sum_of(R"($m_{cr}=\sum_ka_{ck}b_{rk}$)",
               [](M a, M b, int r, int c, int k) { return a(c, k) * b(r, k); }));

  const Formula<Between> moved{R"($y\cdot Bx$)", [](const Between&s) { return dot(s.y, applied(s.b, s.x)); }},
      primes{R"($[b'_{rc}]\,y\cdot x$)",
             [](const Between&s) { return dot(applied(transposed(s.b), s.y), s.x); }},
      none{R"($[b_{rc}]\,y\cdot x$)", [](const Between&s) { return dot(applied(s.b, s.y), s.x); }};
  claims.formula<Between>("transpose_of_a", 3817, R"($A^T=[a'_{rc}]$ with $a'_{rc}=a_{cr}$)", single,
                          {.quantity = R"(the transpose of a matrix, on the other side of a scalar product)",
                           .truth = {R"($y\cdot Ax$)", moved.of},
                           .printed = {R"($[a'_{rc}]\,y\cdot x$)", primes.of},
                           .near_misses = {{R"($[a_{rc}]\,y\cdot x$)", none.of}}});
  claims.formula<Between>(
      "transpose_of_b", 3817, R"($B^T=[b'_{rc}]$ with $b'_{rc}=b_{cr}$, printed $B=[b'_{rc}]$)", single,
      {.quantity = "the matrix in a scalar product",
       .truth = moved,
       .printed = {R"($B=[b'_{rc}]$: $y\cdot[b'_{rc}]\,x$)",
                   [](const Between& s) { return dot(s.y, applied(transposed(s.b), s.x)); }},
       .meant = {R"($B^T=[b'_{rc}]$: $[b'_{rc}]\,y\cdot x$)", primes.of},
       .near_misses = {{R"($B^T=[b_{rc}]$: $[b_{rc}]\,y\cdot x$)", none.of}},
       .kind = Fault::formula,
       .why = R"(The exponent $T$ is missing: $B^T=[b'_{rc}]$, as the conclusion has it. For the rows )"
              R"($(1,2)$, $(3,4)$ of $B$ the matrix $[b'_{rc}]$ has the rows $(1,3)$, $(2,4)$.)"});

  entry("entry", 3823, R"($m'_{rc}=m_{cr}=\sum_ka_{ck}b_{kr}$)",
        sum_of(R"($\sum_ka_{ck}b_{kr}$)", [](M a, M b, int r, int c, int k) { return a(c, k) * b(k, r); }),
        sum_of(R"($\sum_ka_{rk}b_{kc}$)", [](M a, M b, int r, int c, int k) { return a(r, k) * b(k, c); }));
  entry("primed", 3827, R"($m'_{rc}=\sum_ka'_{kc}b'_{rk}$ in the primed entries)",
        sum_of(R"($\sum_ka'_{kc}b'_{rk}$)",
               [](M a, M b, int r, int c, int k) { return primed(a, k, c) * primed(b, r, k); }),
        sum_of(R"($\sum_ka'_{ck}b'_{rk}$)",
               [](M a, M b, int r, int c, int k) { return primed(a, c, k) * primed(b, r, k); }));
  const std::string entries = R"(all entries $(r,c)$ of $(AB)^T$)", exchanged = R"($\sum_kb'_{rk}a'_{kc}$)";
  const Formula<Factors<double>> in_doubles = sum_of(exchanged, swapped<double>);
  claims.add("swapped", 3831, R"($m'_{rc}=\sum_kb'_{rk}a'_{kc}$, the factors exchanged)",
             {.printed = {exchanged,
                          {compare(entries, in_doubles, by_columns(1.0), pairs)},
                          is_as_typeset(compare_typeset(in_doubles, pairs))},
              .near_misses = {{exchanged + ", the entries quaternions",
                               {compare(entries, sum_of<Quaternion>(exchanged, swapped<Quaternion>),
                                        by_columns(Quaternion{1.0}), factors<Quaternion>(random))}}}});

  claims.formula<Between>(
      "result", 3835, "$(AB)^T=B^TA^T$", between(random, true),
      {.quantity = R"(the transpose of $AB$, on the other side of a scalar product)",
       .truth = {R"($y\cdot A(Bx)$ with random vectors $x$, $y$)",
                 [](const Between& s) { return dot(s.y, applied(s.a, applied(s.b, s.x))); }},
       .printed = {R"($B^T(A^Ty)\cdot x$)",
                   [](const Between& s) {
                     return dot(applied(transposed(s.b), applied(transposed(s.a), s.y)), s.x);
                   }},
       .near_misses = {{R"($A^T(B^Ty)\cdot x$)", [](const Between& s) {
                          return dot(applied(transposed(s.a), applied(transposed(s.b), s.y)), s.x);
                        }}}});
  return claims.in_order();
}

// ---- in floating point ------------------------------------------------------------------------------------

/// The operations of a product of two matrices; those of one sum are as many in any order.
long work_of_product(int n) {
  const Matrix<Counted<double>> factor{n};
  return operations_of([&] { return product(factor, factor, Order::ascending); }).all_but_additions();
}

/// How many entries of (AB)^T and B^T A^T are not the same double.
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
  const Knob sizes = doubling("n", 2, 5);
  std::map<double, long> work;  // of both sides
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
  q.add(
      Breakdown{"The two sides agree bit for bit only while their sums run alike. Sums in twice the digits, "
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
    q.add({std::move(model), std::move(algorithm), no_knob(),
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
