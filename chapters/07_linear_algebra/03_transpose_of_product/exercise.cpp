// Exercise 7.3: (AB)^T = B^T A^T, line by line, with a'_rc = a_cr, b'_rc = b_cr and m_rc = sum_k a_rk b_kc.
// The other route never forms a product of matrices: column r of AB is A(B e_r), and a transpose is what
// moves a matrix to the other side of a scalar product, y.(M x) = (M^T y).x. All of it in whole numbers,
// exact. In floating point both sides have the same bits when their sums run in the same order, fused or not:
// a b = b a is exact, a + (b + c) = (a + b) + c is not.

#include <numeric>

#include "chapters/07_linear_algebra/03_transpose_of_product/products.hpp"
#include "reference/text.hpp"

namespace oddity {

namespace ex07_03 {

using namespace matrices;

constexpr Parameter parameters[] = {
    {"decades", 8, "", "range of the sizes of random entries", 1, 100},
    {"m", 200, "", "largest entry of the triangular factors of B, whose inverse is A", 1, 200, whole_number},
    {"seed", 1, "", "seed of the random matrices", 0, 1e9, whole_number},
};

// ---- the claims -------------------------------------------------------------------------------------------

Value value(const std::vector<double>& x) { return x; }
Value value(const std::vector<Quaternion>& x) {
  std::vector<double> all;
  for (const Quaternion& q : x) all.insert(all.end(), {q.w, q.x, q.y, q.z});
  return all;
}

template <class T>
T whole(Random& random) {
  const auto digit = [&] { return static_cast<double>(random.below(199) - 99); };
  if constexpr (std::same_as<T, double>) {
    return digit();
  } else {
    return {digit(), digit(), digit(), digit()};
  }
}

/// Column r of AB as A(B e_r), written as row r: the transpose of the product, entry by entry.
template <class T>
Matrix<T> by_columns(const Matrix<T>& a, const Matrix<T>& b, const T& one) {
  Matrix<T> all{a.n};
  for (int r = 0; r < a.n; ++r) {
    std::vector<T> unit(static_cast<std::size_t>(a.n));
    unit[static_cast<std::size_t>(r)] = one;
    const std::vector<T> column = applied(a, applied(b, unit));
    for (int c = 0; c < a.n; ++c) all(r, c) = column[static_cast<std::size_t>(c)];
  }
  return all;
}

/// A formula for the entry (r, c) of (AB)^T as a sum over k, against A(B e_r); random whole numbers, n = 1
/// to 8.
template <class T = double>
Reading entries(std::string text, Random random, const auto& term) {
  Worst worst("all entries of (AB)^T, against A(B e_r)", text, "A(B e_r)");
  for (int n = 8; n >= 1; --n)
    for (int sample = 0; sample < 10; ++sample) {
      const auto entry = [&](int, int) { return whole<T>(random); };
      const auto a = filled<T>(n, entry), b = filled<T>(n, entry);
      const auto sums = filled<T>(n, [&](int r, int c) {
        T sum{};
        for (int k = 0; k < n; ++k) sum = sum + term(a, b, r, c, k);
        return sum;
      });
      worst.see(value(sums.entries), value(by_columns(a, b, T{1.0}).entries), exact(), n * 1e4,
                "n = " + std::to_string(n));
    }
  return {std::move(text), {worst.check()}};
}

std::vector<double> vector(int n, Random& random) {
  std::vector<double> x;
  for (int i = 0; i < n; ++i) x.push_back(whole<double>(random));
  return x;
}
double dot(const std::vector<double>& u, const std::vector<double>& v) {
  return std::inner_product(u.begin(), u.end(), v.begin(), 0.0);
}

/// What is said to be the transpose of a matrix, seen through scalar products.
Reading transposes(std::string text, Random random, const auto& candidate) {
  Worst worst(text + " and y.(B x)", text, "y.(B x)");
  for (int n = 8; n >= 2; --n) {
    const auto b = filled<double>(n, [&](int, int) { return whole<double>(random); });
    const auto x = vector(n, random), y = vector(n, random);
    worst.see(dot(applied(candidate(b), y), x), dot(y, applied(b, x)), exact(), n * n * 1e6,
              "n = " + std::to_string(n));
  }
  return {std::move(text), {worst.check()}};
}

/// The transpose of AB, seen through scalar products, as two transposes one after the other.
Reading transposes_product(std::string text, Random random, bool a_last) {
  Worst worst("x.(" + text + ") and y.(A (B x))", text + ", times x", "y.(A (B x))");
  for (int n = 8; n >= 2; --n) {
    const auto entry = [&](int, int) { return whole<double>(random); };
    const auto a = filled<double>(n, entry), b = filled<double>(n, entry);
    const auto x = vector(n, random), y = vector(n, random);
    const auto both = a_last ? applied(transposed(a), applied(transposed(b), y))
                             : applied(transposed(b), applied(transposed(a), y));
    worst.see(dot(both, x), dot(y, applied(a, applied(b, x))), exact(), n * n * n * 1e8,
              "n = " + std::to_string(n));
  }
  return {std::move(text), {worst.check()}};
}

/// The entry (r, c) of m'.
auto primed(const auto& m) {
  return [&m](int r, int c) { return m(c, r); };
}

Claim line(std::string id, int number, std::string says, const Reading& printed, const Reading& near_miss) {
  Claim claim{std::move(id), number, std::move(says)};
  claim.printed = printed;
  claim.near_misses = {near_miss};
  return claim;
}

Claim transpose_of_b(const Random& random) {
  Claim claim{"7.3-transpose_of_b", 3817, "the matrix with the entries b'_rc = b_cr is written B"};
  Worst worst("B x", "[b'_rc] x", "B x");
  Random numbers = random;
  const auto b = filled<double>(8, [&](int, int) { return whole<double>(numbers); });
  const std::vector<double> x(8, 1.0);
  worst.see(applied(transposed(b), x), applied(b, x), exact(), 1e3, "n = 8");
  claim.printed = {"B = [b'_rc]", {worst.check()}};
  claim.meant = transposes("([b'_rc] y).x", random, [](const auto& m) { return transposed(m); });
  claim.near_misses = {transposes("([b_rc] y).x", random, [](const auto& m) { return m; })};
  claim.why =
      "The exponent T is missing: $B^T=[b'_{rc}]$, as the conclusion has it. For the rows $(1,2)$, $(3,4)$ "
      "of $B$ "
      "the matrix $[b'_{rc}]$ has the rows $(1,3)$, $(2,4)$.";
  return claim;
}

std::vector<Claim> claims(const Random& random) {
  const auto sum = [&](std::string text, const auto& term) { return entries(std::move(text), random, term); };
  const auto swapped = [](auto& a, auto& b, int r, int c, int k) {
    return primed(b)(r, k) * primed(a)(k, c);
  };
  const auto noncommuting =
      entries<Quaternion>("sum of b'_rk a'_kc, the entries quaternions", random, swapped);
  return {
      line("7.3-product", 3815, "the entries m_rc of AB are the sums over k of a_rk b_kc",
           sum("sum of a_rk b_kc at (c, r)",
               [](auto& a, auto& b, int r, int c, int k) { return a(c, k) * b(k, r); }),
           sum("sum of a_rk b_ck at (c, r)",
               [](auto& a, auto& b, int r, int c, int k) { return a(c, k) * b(r, k); })),
      line("7.3-transpose_of_a", 3817, "the transpose of A has the entries a'_rc = a_cr",
           transposes("([a'_rc] y).x", random, [](const auto& m) { return transposed(m); }),
           transposes("([a_rc] y).x", random, [](const auto& m) { return m; })),
      transpose_of_b(random),
      line("7.3-entry", 3823, "m'_rc = m_cr is the sum over k of a_ck b_kr",
           sum("sum of a_ck b_kr", [](auto& a, auto& b, int r, int c, int k) { return a(c, k) * b(k, r); }),
           sum("sum of a_rk b_kc", [](auto& a, auto& b, int r, int c, int k) { return a(r, k) * b(k, c); })),
      line("7.3-primed", 3827, "this is the sum over k of a'_kc b'_rk",
           sum("sum of a'_kc b'_rk",
               [](auto& a, auto& b, int r, int c, int k) { return primed(a)(k, c) * primed(b)(r, k); }),
           sum("sum of a'_ck b'_rk",
               [](auto& a, auto& b, int r, int c, int k) { return primed(a)(c, k) * primed(b)(r, k); })),
      line("7.3-swapped", 3831, "this is the sum over k of b'_rk a'_kc", sum("sum of b'_rk a'_kc", swapped),
           noncommuting),
      line("7.3-result", 3835, "(AB)^T = B^T A^T", transposes_product("B^T (A^T y)", random, false),
           transposes_product("A^T (B^T y)", random, true))};
}

Findings study(const Parameters& p, const Reference&) {
  const Random random(p["seed"]);
  return {claims(random), {same_bits(p["decades"], random), identity(static_cast<int>(p["m"]), random)}};
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
