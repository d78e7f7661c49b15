#include "reference/make/routes.hpp"

// The spheroid x = (a s cos t, a s sin t, d + b u), s^2 = 1 - u^2, |u| <= 1, with its center at d on its
// axis. The flux of x / |x|^3 is 2 pi a^2 times the integral over u of
// (b + d u) / (a^2 s^2 + (d + b u)^2)^(3/2). It is also the solid angle of the surface seen from the origin.
// That is 2 pi times the increase from u = -1 to 1 of the cosine of the polar angle, (d + b u) / sqrt(...).
namespace oddity::truth {

namespace spheroid_flux_05_03 {

Numbers by_quadrature(const std::vector<double>& in, int digits) {
  const Number a = in[0], b = in[1], d = in[2];
  const auto flux_density = [&](const Number& u) -> Number {
    const Number z = d + b * u, square = a * a * (1 - u * u) + z * z;
    return (b + d * u) / (square * sqrt(square));
  };
  return {2 * pi() * a * a * integral(flux_density, -1, 1, digits)};
}

Numbers by_solid_angle(const std::vector<double>& in, int) {
  const auto cosine_at_pole = [](const Number& z) { return z > 0 ? 1 : z < 0 ? -1 : 0; };
  const Number b = in[1], d = in[2];
  return {2 * pi() * (cosine_at_pole(d + b) - cosine_at_pole(d - b))};
}

}  // namespace spheroid_flux_05_03

Truth truth_05_03_spheroid_flux() {
  using namespace spheroid_flux_05_03;
  return {"flux of x / |x|^3 through a spheroid of semi-axes a, a, b, its centre at the distance d along b",
          "surface integral of x.dS / |x|^3",
          {"a", "b", "d"},
          {{"flux", "1"}},
          {{1.5, 1.5, 0.375}, {1, 2, 0.5}, {1, 2, 3}, {1, 2, 1.984375}, {1.5, 1.5, 0}},
          "solid angle of the surface as seen from the origin",
          by_solid_angle,
          "double-exponential quadrature over the latitude",
          by_quadrature,
          "the first route",
          by_solid_angle};
}

}  // namespace oddity::truth
