#include "reference/make/routes.hpp"

// The triple pendulum's small oscillations. First route: the cubic det(K - lambda M) = 0, its three real
// roots by the cosine of a third of an angle. Second route: the masses on a string with the rods' tensions at
// rest; bisection by Sturm's sign count on that tridiagonal matrix.
namespace oddity::truth {

namespace modes_03_25 {

Numbers by_cubic(const std::vector<double>& in, int) {
  const Number m1 = in[0], m2 = in[1], m3 = in[2], r1 = in[3], r2 = in[4], r3 = in[5], g = in[6];
  const Number s2 = m2 + m3, s1 = m1 + s2;
  // det(K - lambda M) / (r1 r2 r3)^2, K = diag(s_i g r_i), M_ij = s_max(i,j) r_i r_j
  const Number p = s1 * g / r1, q = s2 * g / r2, w = m3 * g / r3;
  const Number a = -(s1 * (s2 * m3 - m3 * m3) - s2 * (s2 * m3 - m3 * m3));
  const Number b = p * (s2 * m3 - m3 * m3) + q * (s1 * m3 - m3 * m3) + w * (s1 * s2 - s2 * s2);
  const Number c = -(p * q * m3 + p * w * s2 + q * w * s1), d = p * q * w;
  const Number shift = -b / (3 * a), P = (3 * a * c - b * b) / (3 * a * a),
               Q = (2 * b * b * b - 9 * a * b * c + 27 * a * a * d) / (27 * a * a * a);
  const Number size = 2 * sqrt(-P / 3), angle = acos(3 * Q / (P * size)) / 3;
  Numbers rates;
  for (int k : {2, 1, 0}) rates.push_back(sqrt(shift + size * cos(angle - 2 * pi() * k / 3)));
  std::sort(rates.begin(), rates.end());
  return rates;
}

Numbers by_string(const std::vector<double>& in, int) {
  const Number m[] = {in[0], in[1], in[2]};
  const Number s[] = {Number((m[0] + m[1] + m[2]) * in[6] / in[3]), Number((m[1] + m[2]) * in[6] / in[4]),
                      Number(m[2] * in[6] / in[5])};  // tension over length
  const auto below = [&](const Number& lambda) {
    int count = 0;
    Number pivot = 1;
    for (int k = 0; k < 3; ++k) {
      pivot =
          (s[k] + (k < 2 ? s[k + 1] : Number(0))) - lambda * m[k] - (k > 0 ? s[k] * s[k] / pivot : Number(0));
      count += pivot < 0;
    }
    return count;
  };
  Numbers rates;
  for (int k = 0; k < 3; ++k) {
    Number low = 0, high = 4 * (s[0] / m[0] + s[1] / m[1] + s[2] / m[2] + s[1] / m[0] + s[2] / m[1]);
    for (int i = 0; i < 190; ++i) {
      const Number middle = (low + high) / 2;
      (below(middle) > k ? high : low) = middle;
    }
    rates.push_back(sqrt(low));
  }
  return rates;
}

}  // namespace modes_03_25

Truth truth_03_25_modes() {
  using namespace modes_03_25;
  return {
      "angular frequencies of the small oscillations of three masses in a chain, ascending",
      "det(K - w^2 M) = 0, K = diag(mu_i g r_i), M_ij = mu_max(i,j) r_i r_j",
      {"m1", "m2", "m3", "r1", "r2", "r3", "g"},
      {{"w1", "rad/s"}, {"w2", "rad/s"}, {"w3", "rad/s"}},
      {{1, 0.75, 0.5, 1, 0.75, 0.5, 9.8125}, {1, 1, 1, 1, 1, 1, 1}, {1, 0.0009765625, 1, 1, 1, 1, 9.8125}},
      "the characteristic cubic, by cosines",
      by_cubic,
      "the masses on a string, Sturm's count bisected",
      by_string,
      "the first route",
      by_cubic};
}

}  // namespace oddity::truth
