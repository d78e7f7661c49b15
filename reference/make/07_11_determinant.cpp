#include <cmath>

#include "reference/truth.hpp"

// A triangular matrix with u_k = s_k m_k 2^e in its first half and s_k m_k 2^-e in its second. The powers of
// two cancel in the product. m_k = 1 + (37 k mod 64)/64, and s_k = -1 for every third k.
namespace oddity::truth {

namespace determinant_07_11 {

Numbers diagonal(const std::vector<double>& in) {
  const int n = static_cast<int>(in[0]), e = static_cast<int>(in[1]);
  Numbers u;
  for (int k = 1; k <= n; ++k) {
    const Number m = Number(64 + 37 * k % 64) / 64 * pow(Number(2), 2 * k <= n ? e : -e);
    u.push_back(k % 3 == 0 ? Number(-m) : m);
  }
  return u;
}

Numbers by_product(const std::vector<double>& in, int) {
  Number product = 1;
  for (const Number& u : diagonal(in)) product *= u;
  return {product};
}

Numbers by_logarithms(const std::vector<double>& in, int) {
  Number sum = 0;
  int sign = 1;
  for (const Number& u : diagonal(in)) {
    sum += log(abs(u));
    if (u < 0) sign = -sign;
  }
  return {sign * exp(sum)};
}

}  // namespace determinant_07_11

Truth truth_07_11_determinant() {
  using namespace determinant_07_11;
  return {"determinant of an n x n triangular matrix whose diagonal entries are 2^e in size, then 2^-e",
          "product of the diagonal entries",
          {"n", "e"},
          {{"det", "1"}},
          {{40, 60}, {2, 60}, {10, 200}, {40, 1}, {100, 300}},
          "product",
          by_product,
          "exponential of the sum of logarithms",
          by_logarithms,
          "the first route",
          by_product};
}

}  // namespace oddity::truth
