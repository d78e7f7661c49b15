#include <boost/math/special_functions/bessel.hpp>

#include "reference/make/routes.hpp"

// Columns of the half disc x^2 + y^2 <= 1, y >= 0 with the density exp(k x):
//   mass = int e^(kx) sqrt(1 - x^2) = pi I1(k)/k, first moments pi I2(k)/k and 2 (k cosh k - sinh k)/k^3
//   [DLMF 10.32.2]. The second route takes circles of radius r: int_0^pi e^(kr cos t) dt = pi I0(kr) is not
//   used.
namespace oddity::truth {

namespace {

Numbers centered(const Number& mass, const Number& x, const Number& y) { return {mass, x / mass, y / mass}; }

Numbers by_bessel(const std::vector<double>& in, int) {
  const Number k = in[0];
  return centered(pi() / k * boost::math::cyl_bessel_i(1, k), pi() / k * boost::math::cyl_bessel_i(2, k),
                  2 * (k * cosh(k) - sinh(k)) / (k * k * k));
}

/// Over the angle t from the x axis, the integral over the radius done by parts: with q = k cos t,
/// int_0^1 r e^(qr) dr and int_0^1 r^2 e^(qr) dr as series, which no cancellation spoils.
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

}  // namespace

Truth truth_02_09_half_disc() {
  return {"mass and center of mass of the half disc x^2 + y^2 <= 1, y >= 0 with the density exp(k x)",
          "m = int e^(kx), m x = int x e^(kx), m y = int y e^(kx)",
          {"k"},
          {{"mass", "kg"}, {"x", "m"}, {"y", "m"}},
          {{0.0625}, {1}, {4}, {16}},
          "modified Bessel functions",
          by_bessel,
          "sectors: double-exponential quadrature over the angle, series over the radius",
          by_sectors};
}

}  // namespace oddity::truth
