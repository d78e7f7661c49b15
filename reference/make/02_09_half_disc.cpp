#include "reference/make/routes.hpp"

// Columns of the half disc x^2 + y^2 <= 1, y >= 0 with the density exp(k x):
//   mass = int e^(kx) sqrt(1 - x^2) = pi I1(k)/k, first moments pi I2(k)/k and 2 (k cosh k - sinh k)/k^3.
// Source: [DLMF 10.32.2], the NIST Digital Library of Mathematical Functions.
// Sectors: polar coordinates, the radius by a power series.
namespace oddity::truth {

namespace half_disc_02_09 {

Numbers centered(const Number& mass, const Number& x, const Number& y) { return {mass, x / mass, y / mass}; }

/// I_n(k) [DLMF 10.25.2]; no term is negative, and the omitted ones are less than half the previous one.
Number bessel_i(int n, const Number& k) {
  Number term = 1, sum = 0;
  for (int m = 1; m <= n; ++m) term *= k / (2 * m);
  const Number least = pow(Number(10), -static_cast<int>(working_digits));
  for (int m = 1; term > sum * least || 2 * m * (m + n) < k * k; ++m) {
    sum += term;
    term *= k * k / (4 * m * (m + n));
  }
  return within(sum, Number(2 * term));
}

Numbers by_bessel(const std::vector<double>& in, int) {
  const Number k = in[0];
  return centered(pi() / k * bessel_i(1, k), pi() / k * bessel_i(2, k),
                  2 * (k * cosh(k) - sinh(k)) / (k * k * k));
}

/// int_0^1 r^p e^(qr) dr = sum of q^n / (n! (n + p + 1)) with q = k cos t, integrated over the angle t.
Numbers by_sectors(const std::vector<double>& in, int digits) {
  const Number k = in[0];
  const auto radial = [&](const Number& q, int power) -> Number {
    Number sum = 0, term = 1;
    for (int n = 0; n < 400; ++n) {
      sum += term / (n + power + 1);
      term *= q / (n + 1);
    }
    return sum;
  };
  const auto over = [&](int power, const auto& weight) -> Number {
    const auto sector = [&](const Number& t) -> Number { return weight(t) * radial(k * cos(t), power); };
    return integral(sector, 0, pi(), digits);
  };
  return centered(over(1, [](const Number&) { return Number(1); }),
                  over(2, [](const Number& t) { return Number(cos(t)); }),
                  over(2, [](const Number& t) { return Number(sin(t)); }));
}

}  // namespace half_disc_02_09

Truth truth_02_09_half_disc() {
  using namespace half_disc_02_09;
  return {"mass and center of mass of the half disc x^2 + y^2 <= 1, y >= 0 with the density exp(k x)",
          "m = int e^(kx), m x = int x e^(kx), m y = int y e^(kx)",
          {"k"},
          {{"mass", "kg"}, {"x", "m"}, {"y", "m"}},
          {{0.0625}, {1}, {4}, {16}},
          "modified Bessel functions",
          by_bessel,
          "sectors: double-exponential quadrature over the angle, series over the radius",
          by_sectors,
          "the first route, the rest of the series bounded",
          by_bessel};
}

}  // namespace oddity::truth
