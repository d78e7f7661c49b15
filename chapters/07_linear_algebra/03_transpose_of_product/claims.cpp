// The claims of exercise 7.3, in whole numbers. The transpose of the product is compared with A(B e_r),
// column by column, and with scalar products.

#include <numeric>
#include <string>
#include <utility>

#include "chapters/07_linear_algebra/03_transpose_of_product/transpose_of_product.hpp"
#include "chapters/07_linear_algebra/shared/matrices.hpp"
#include "chapters/claims.hpp"

namespace oddity::ex07_03 {

namespace {

using namespace matrices;

/// Two matrices and two vectors.
struct Sample {
  static constexpr bool whole = true;
  Matrix<double> a, b;
  std::vector<double> x, y;

  Sample(int n, Random& random) : a{n}, b{n} {
    const auto draw = [&](std::vector<double>& all) {
      for (double& one : all) one = random.below(199) - 99;
    };
    x.resize(static_cast<std::size_t>(n)), y.resize(x.size());
    for (std::vector<double>* all : {&a.entries, &b.entries, &x, &y}) draw(*all);
  }
  TypesetLetters typeset() const {
    TypesetLetters all;
    for (int r = 0; r < a.n; ++r) {
      const std::string row = std::to_string(r + 1);
      all.emplace_back("x_" + row, x[static_cast<std::size_t>(r)]);
      all.emplace_back("y_" + row, y[static_cast<std::size_t>(r)]);
      for (int c = 0; c < a.n; ++c) {
        const std::string at = "_{" + row + std::to_string(c + 1) + "}";
        for (const auto& [letter, value] :
             {std::pair{"a", a(r, c)}, {"b", b(r, c)}, {"a'", a(c, r)}, {"b'", b(c, r)}})
          all.emplace_back(letter + at, value);
      }
    }
    return all;
  }
  std::string where() const { return "$n$ = " + std::to_string(a.n); }
};
using Of = Formula<Sample>;

double dot(const std::vector<double>& u, const std::vector<double>& v) {
  return std::inner_product(u.begin(), u.end(), v.begin(), 0.0);
}

/// Column r of AB as A(B e_r), written as row r: the transpose of the product, entry by entry.
Value by_columns(const Sample& s) {
  std::vector<double> all;
  for (std::size_t r = 0; r < s.x.size(); ++r) {
    std::vector<double> unit(s.x.size());
    unit[r] = 1;
    const std::vector<double> column = applied(s.a, applied(s.b, unit));
    all.insert(all.end(), column.begin(), column.end());
  }
  return all;
}

/// For the matrices a i and b j the product AB is k times ab. B^T A^T, the sum with its factors exchanged, is
/// k times the same.
Value exchanged_in_quaternions(const Sample& s) {
  const auto times = [](const Matrix<double>& m, const Quaternion& unit) {
    return filled<Quaternion>(m.n, [&](int r, int c) { return Quaternion{m(c, r)} * unit; });
  };
  std::vector<double> all;
  for (const Quaternion& q : product(times(s.b, {0, 0, 1}), times(s.a, {0, 1}), Order::ascending).entries)
    all.push_back(q.z);
  return all;
}

}  // namespace

std::vector<Claim> claims(Random random) {
  Claims claims("7.3");
  // Single changes of a text are tried on the first sixteen, which have the same size.
  std::vector<Sample> samples;
  for (int n = 8; n >= 1; --n)
    for (int sample = 0; sample < 16; ++sample) samples.emplace_back(n, random);
  const auto entry = [&](const char* slug, int line, const char* says, const char* printed,
                         const std::vector<Of>& near_misses = {}) {
    claims.formula<Sample>(slug, line, says, samples,
                           {.quantity = R"(all entries $(r,c)$ of $(AB)^T$)",
                            .truth = {"$A(Be_r)$, column by column", by_columns},
                            .printed = {printed},
                            .near_misses = near_misses});
  };
  entry("product", 3815, R"($AB=[m_{rc}]$ with $m_{rc}=\sum_ka_{rk}b_{kc}$)",
        R"($m_{cr}=\sum_ka_{ck}b_{kr}$)");
  claims.formula<Sample>(
      "transpose_of_a", 3817, R"($A^T=[a'_{rc}]$ with $a'_{rc}=a_{cr}$)", samples,
      {.quantity = R"(the transpose of a matrix, on the other side of a scalar product)",
       .truth = {R"($y\cdot Ax$)", [](const Sample& s) { return dot(s.y, applied(s.a, s.x)); }},
       .printed = {R"($\sum_rx_r\sum_ca'_{rc}y_c$)"}});
  claims.formula<Sample>(
      "transpose_of_b", 3817, R"($B^T=[b'_{rc}]$ with $b'_{rc}=b_{cr}$, printed $B=[b'_{rc}]$)", samples,
      {.quantity = "the matrix in a scalar product",
       .truth = {R"($y\cdot Bx$)", [](const Sample& s) { return dot(s.y, applied(s.b, s.x)); }},
       .printed = {R"($\sum_ry_r\sum_cb'_{rc}x_c$)"},
       .meant = {R"($\sum_rx_r\sum_cb'_{rc}y_c$)"},
       .kind = Fault::formula,
       .why = R"(The exponent $T$ is missing: $B^T=[b'_{rc}]$, as the conclusion has it. For the rows )"
              R"($(1,2)$, $(3,4)$ of $B$ the matrix $[b'_{rc}]$ has the rows $(1,3)$, $(2,4)$.)"});
  entry("entry", 3823, R"($m'_{rc}=m_{cr}=\sum_ka_{ck}b_{kr}$)", R"($\sum_ka_{ck}b_{kr}$)",
        {{R"($\sum_ka_{rk}b_{kc}$)"}});
  entry("primed", 3827, R"($m'_{rc}=\sum_ka'_{kc}b'_{rk}$ in the primed entries)",
        R"($\sum_ka'_{kc}b'_{rk}$)");
  entry("swapped", 3831, R"($m'_{rc}=\sum_kb'_{rk}a'_{kc}$, the factors exchanged)",
        R"($\sum_kb'_{rk}a'_{kc}$)",
        {{R"($\sum_kb'_{rk}a'_{kc}$ of quaternions, $a_{rc}$ times $i$ and $b_{rc}$ times $j$: their $k$)",
          exchanged_in_quaternions}});
  claims.formula<Sample>(
      "result", 3835, "$(AB)^T=B^TA^T$", samples,
      {.quantity = R"(the transpose of $AB$, on the other side of a scalar product)",
       .truth = {R"($y\cdot A(Bx)$ with random vectors $x$, $y$)",
                 [](const Sample& s) { return dot(s.y, applied(s.a, applied(s.b, s.x))); }},
       .printed = {R"($\sum_rx_r\sum_kb'_{rk}\sum_ca'_{kc}y_c$)"},
       .near_misses = {{R"($\sum_rx_r\sum_ka'_{rk}\sum_cb'_{kc}y_c$)"}}});
  return claims.in_order();
}

}  // namespace oddity::ex07_03
