#include "reference/truth.hpp"

// A triangular matrix with u_k = s_k m_k 2^e, m_k = 1 + (37 k mod 64)/64, s_k = -1 for every third k.
namespace oddity::truth {

namespace log_determinant_07_11 {

Number size_of(int k, int e) { return Number(64 + 37 * k % 64) / 64 * pow(Number(2), e); }

Numbers by_product(const std::vector<double>& in, int) {
  Number product = 1;
  for (int k = 1; k <= static_cast<int>(in[0]); ++k) product *= size_of(k, static_cast<int>(in[1]));
  return {log(product)};
}

Numbers by_logarithms(const std::vector<double>& in, int) {
  Number sum = 0;
  for (int k = 1; k <= static_cast<int>(in[0]); ++k) sum += log(size_of(k, static_cast<int>(in[1])));
  return {sum};
}

}  // namespace log_determinant_07_11

Truth truth_07_11_log_determinant() {
  using namespace log_determinant_07_11;
  return {
      "logarithm of the size of the determinant of an n x n triangular matrix with entries of size 2^e on "
      "its diagonal",
      "log |product of the diagonal entries|",
      {"n", "e"},
      {{"log|det|", "1"}},
      {{40, 60}, {2, 60}, {10, 200}, {40, 1}, {100, 300}},
      "logarithm of the product",
      by_product,
      "sum of the logarithms",
      by_logarithms,
      "the second route",
      by_logarithms};
}

}  // namespace oddity::truth
