#include "reference/make/03_19_pulleys.hpp"

// The angular frequencies w of M x'' + K x = 0. The second route bisects on the number of negative pivots of
// K - w^2 M, which is the number of frequencies below w [Sylvester's law of inertia].
namespace oddity::truth {

namespace frequencies_03_19 {

using pulleys::Matrices;

Numbers by_determinant(const std::vector<double>& in, int) {
  const Numbers s = pulleys::squares(in);
  return {sqrt(s[0]), sqrt(s[1])};
}

int frequencies_below(const Matrices& a, const Number& w) {
  const Number s = w * w, p = a.k22 - s * a.m22, off = a.k23 - s * a.m23;
  const Number second = a.k33 - s * a.m33 - off * off / p;
  return (p < 0) + (second < 0);
}

Numbers by_inertia(const std::vector<double>& in, int digits) {
  const Matrices a = pulleys::matrices(in);
  Numbers w;
  for (int k = 0; k < 2; ++k) {
    Number low = 0, high = 1;
    while (frequencies_below(a, high) <= k) high *= 2;
    while (high - low > high * pow(Number(10), -digits - 4)) {
      const Number middle = (low + high) / 2;
      (frequencies_below(a, middle) > k ? high : low) = middle;
    }
    w.push_back((low + high) / 2);
  }
  return w;
}

}  // namespace frequencies_03_19

Truth truth_03_19_frequencies() {
  using namespace frequencies_03_19;
  return {"angular frequencies of two pulleys, two springs and a mass",
          "det(K - w^2 M) = 0, M = ((m2 + I1/R1^2 + I2/R2^2, -I2/R2^2), (-I2/R2^2, m3 + I2/R2^2)), K = ((c1 "
          "+ 4 c2, -2 c2), (-2 c2, c2))",
          {"m2", "m3", "I1", "I2", "R1", "R2", "c1", "c2"},
          {{"w1", "rad/s"}, {"w2", "rad/s"}},
          {{1, 2, 0.5, 0.25, 0.5, 0.5, 40, 30},
           {1, 2, 0, 0, 0.5, 0.5, 40, 30},
           {1, 2, 0.5, 0.25, 0.5, 0.5, 40 * 0x1p30, 30}},
          "the roots of the determinant in 60 digits",
          by_determinant,
          "bisection on the number of negative pivots of K - w^2 M",
          by_inertia,
          "the first route",
          by_determinant};
}

}  // namespace oddity::truth
