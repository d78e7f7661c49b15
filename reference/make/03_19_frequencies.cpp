#include "reference/make/03_19_pulleys.hpp"

// The angular frequencies w of M x'' + K x = 0. The second route has A of y'' = -A y by Newton's laws. It
// bisects on the sign of det(A - w^2), which changes once on either side of the mean of the two w^2.
namespace oddity::truth {

namespace frequencies_03_19 {

Numbers by_determinant(const std::vector<double>& in, int) {
  const Numbers s = pulleys::squares(in);
  return {sqrt(s[0]), sqrt(s[1])};
}

Numbers by_tensions(const std::vector<double>& in, int digits) {
  const Number c1 = in[6], c2 = in[7];
  Number A[2][2];
  const auto by = pulleys::accelerations(in);
  for (int i = 0; i < 2; ++i) {
    const auto& a = by[static_cast<std::size_t>(i)];
    A[i][0] = a[2] * c1 + 2 * c2 * (a[0] - a[3]);
    A[i][1] = c2 * (a[3] - a[0]);
  }
  const auto determinant = [&](const Number& s) {
    return Number((A[0][0] - s) * (A[1][1] - s) - A[0][1] * A[1][0]);
  };
  const Number trace = A[0][0] + A[1][1], mean = sqrt(Number(trace / 2));
  Numbers w;
  for (const bool second : {false, true}) {
    Number low = second ? mean : Number(0), high = second ? Number(sqrt(trace)) : mean;
    while (high - low > high * pow(Number(10), -digits - 4)) {
      const Number middle = (low + high) / 2;
      ((determinant(middle * middle) > 0) == second ? high : low) = middle;
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
          "bisection on det(A - w^2) with A by Newton's laws with the ropes' tensions",
          by_tensions,
          "the first route",
          by_determinant};
}

}  // namespace oddity::truth
