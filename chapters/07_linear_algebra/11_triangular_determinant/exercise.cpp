// Exercise 7.11: the determinant of an upper triangular matrix, by repeated cofactors of its last row, is the
// product of its diagonal entries, u_nn ... u_11. The independent route is fraction-free elimination in whole
// numbers (Bareiss 1968). It uses no cofactors and is also given full matrices. Higham, Accuracy and
// Stability, 2nd ed., 14.6.

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <string_view>
#include <vector>

#include "chapters/07_linear_algebra/11_triangular_determinant/triangular_determinant.hpp"
#include "chapters/inputs.hpp"
#include "reference/reference.hpp"
#include "solvers/linear.hpp"

namespace oddity {

namespace ex07_11 {

constexpr std::array<std::string_view, 10> letters{"u11", "u12", "u13", "u14", "u22",
                                                   "u23", "u24", "u33", "u34", "u44"};
constexpr auto parameters = together(
    std::array{Parameter{"n", 40, "", "size of the triangular matrix", 2, 100, whole_number},
               Parameter{"e", 60, "", "exponent of two in its diagonal entries", 0, 300, whole_number},
               Parameter{"seed", 1, "", "seed of the random matrices", 0, 1e9, whole_number}},
    numbers<10>(letters, {3, -1, 0.5, 2, -0.25, 4, 1, 7, -2, 0.125}, "",
                "entry of a triangular matrix that you choose", 1e70));

// ---- the methods ------------------------------------------------------------------------------------------

/// s_k m_k 2^e in the first half, s_k m_k 2^f in the second; m_k from 1 to 2, s_k = -1 for every third k.
std::vector<double> diagonal(int n, int e, int f) {
  std::vector<double> u;
  for (int k = 1; k <= n; ++k)
    u.push_back(std::ldexp((k % 3 == 0 ? -1 : 1) * (64 + 37 * k % 64) / 64.0, 2 * k <= n ? e : f));
  return u;
}

double product(const std::vector<double>& u) {
  double all = 1;
  for (double x : u) all *= x;
  return all;
}

/// A number as mantissa and power of two, so that products do not overflow.
struct Scaled {
  double mantissa = 1;
  long exponent = 0;
};

Scaled scaled_product(const std::vector<double>& u) {
  Scaled all;
  for (double x : u) {
    int of_factor = 0, of_product = 0;
    all.mantissa = std::frexp(all.mantissa * std::frexp(x, &of_factor), &of_product);
    all.exponent += of_factor + of_product;
  }
  return all;
}

double sum_of_logarithms(const std::vector<double>& u) {
  double sum = 0;
  for (double x : u) sum += std::log(std::abs(x));
  return sum;
}

double sign_of(const std::vector<double>& u) {
  double sign = 1;
  for (double x : u) sign *= std::copysign(1.0, x);
  return sign;
}

/// The largest next to the smallest, the second largest next to the second smallest, ...
std::vector<double> paired(std::vector<double> u) {
  std::ranges::sort(u, {}, [](double x) { return std::abs(x); });
  std::vector<double> all;
  for (std::size_t i = 0, j = u.size(); i < j;) {
    all.push_back(u[--j]);
    if (i < j) all.push_back(u[i++]);
  }
  return all;
}

Answer finite_answer(double x, long work) {
  if (std::isfinite(x)) return {x, work};
  return {x,
          work,
          std::numeric_limits<double>::quiet_NaN(),
          0,
          Ending::non_finite,
          "out of the range of a double"};
}

Method product_method(std::string algorithm, const std::vector<double>& u, Outcome expected = Outcome::ok,
                      std::string why = {}) {
  return {"product",       std::move(algorithm),
          no_resolution(), [=](double) { return finite_answer(product(u), static_cast<long>(u.size())); },
          expected,        std::move(why)};
}

Method by_mantissas(const std::vector<double>& u) {
  return {"mantissas and exponents", "the first first", no_resolution(), [=](double) {
            const Scaled s = scaled_product(u);
            return finite_answer(std::ldexp(s.mantissa, static_cast<int>(s.exponent)),
                                 static_cast<long>(u.size()));
          }};
}

Method by_logarithms(const std::vector<double>& u) {
  return {"logarithms", "exponential of the sum", no_resolution(), [=](double) {
            return finite_answer(sign_of(u) * std::exp(sum_of_logarithms(u)),
                                 static_cast<long>(u.size()) + 1);
          }};
}

Quantity determinant_quantity(int n, int e, const Reference& truth) {
  const std::vector<double> u = diagonal(n, e, -e), last_first(u.rbegin(), u.rend());
  const Known known = truth("07_11_determinant", {double(n), double(e)});
  Quantity q = quantity("determinant", "",
                        "determinant of a triangular matrix, the large entries of its diagonal first", known,
                        {1e-12 * std::abs(known.value[0]), "twelve digits"});
  q.add(product_method("as printed, the last first", last_first, Outcome::inaccurate,
                       "the small entries underflow to zero before the large ones come"));
  q.add(product_method("the first first", u, Outcome::non_finite,
                       "the large entries overflow before the small ones come"));
  q.add(product_method("large by small", paired(u)));
  q.add(by_mantissas(u));
  q.add(by_logarithms(u));
  q.add(
      Breakdown{"The determinant is a moderate number, but not the products on the way to it: in the "
                "printed order they fall below $2^{@4}$.",
                "product, as printed, the last first",
                0,
                Outcome::inaccurate,
                "mantissas and exponents, the first first",
                0,
                {std::log2(std::numeric_limits<double>::denorm_min())}});
  q.add(Breakdown{"In the other order they rise above $2^{@4}$.",
                  "product, the first first",
                  0,
                  Outcome::non_finite,
                  "logarithms, exponential of the sum",
                  0,
                  {std::numeric_limits<double>::max_exponent}});
  return q;
}

/// A full matrix with this diagonal and random entries above it.
Eigen::MatrixXd triangular(const std::vector<double>& u, Random random) {
  const auto n = static_cast<Eigen::Index>(u.size());
  Eigen::MatrixXd m = Eigen::MatrixXd::Zero(n, n);
  for (Eigen::Index r = 0; r < n; ++r)
    for (Eigen::Index c = r; c < n; ++c)
      m(r, c) = r == c ? u[static_cast<std::size_t>(r)] : random.between(-1, 1);
  return m;
}

Quantity log_determinant(int n, int e, const Reference& truth, const Random& random) {
  const std::vector<double> u = diagonal(n, e, e), last_first(u.rbegin(), u.rend());
  const Eigen::MatrixXd m = triangular(u, random);
  const Known known = truth("07_11_log_determinant", {double(n), double(e)});
  Quantity q = quantity("log_determinant", "", R"($\ln|\det U|$ with large entries all along the diagonal)",
                        known, {1e-12 * known.value[0], "twelve digits"});
  const std::string overflows = "the determinant itself is out of the range of a double";
  q.add({"logarithm of the product", "as printed, the last first", no_resolution(),
         [=](double) { return finite_answer(std::log(std::abs(product(last_first))), n + 1); },
         Outcome::non_finite, overflows});
  q.add({"logarithm of the product", "LU, rows exchanged", no_resolution(),
         [=](double) {
           Solved<double> solved = determinant(m);
           solved.value = std::log(std::abs(solved.value));
           return answer(solved);
         },
         Outcome::non_finite, overflows});
  q.add(
      {"logarithms", "sum", no_resolution(), [=](double) { return finite_answer(sum_of_logarithms(u), n); }});
  q.add({"mantissas and exponents", "logarithm of the mantissa", no_resolution(), [=](double) {
           const Scaled s = scaled_product(u);
           return finite_answer(
               std::log(std::abs(s.mantissa)) + static_cast<double>(s.exponent) * std::numbers::ln2, n + 2);
         }});
  q.add(
      Breakdown{"No order of the product helps against a determinant of $10^{@5}$. Its logarithm is a sum, "
                "and needs no determinant.",
                "logarithm of the product, LU, rows exchanged",
                0,
                Outcome::non_finite,
                "logarithms, sum",
                0,
                {std::round(known.value[0] / std::numbers::ln10)}});
  return q;
}

/// The determinant of the user's triangular matrix.
Quantity own_determinant(const Parameters& p, const Reference& truth) {
  std::vector<double> entries, u;
  Eigen::MatrixXd m = Eigen::MatrixXd::Zero(4, 4);
  std::size_t next = 0;
  for (Eigen::Index r = 0; r < 4; ++r)
    for (Eigen::Index c = 0; c < 4; ++c) {
      if (c >= r) m(r, c) = p[letters[next++]];
      if (c == r) u.push_back(m(r, c));
      entries.push_back(m(r, c));
    }
  const Known known = truth("07_09_determinant", entries);
  Quantity q =
      quantity("own_determinant", "", "determinant of the triangular matrix of the entries u11 to u44", known,
               {std::max(1e-12 * std::abs(known.value[0]), 1e-300), "twelve digits"});
  q.add(product_method("as printed, the last first", {u.rbegin(), u.rend()}));
  q.add(product_method("the first first", u));
  q.add(by_mantissas(u));
  q.add(by_logarithms(u));
  q.add(
      {"elimination", "LU, rows exchanged", no_resolution(), [=](double) { return answer(determinant(m)); }});
  return q;
}

Findings study(const Parameters& p, const Reference& truth) {
  const Random random(p["seed"]);
  const int n = static_cast<int>(p["n"]), e = static_cast<int>(p["e"]);
  return {claims(random), in_operations({determinant_quantity(n, e, truth),
                                         log_determinant(n, e, truth, random), own_determinant(p, truth)})};
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
