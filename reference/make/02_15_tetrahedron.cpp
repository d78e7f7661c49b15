#include "reference/make/routes.hpp"

// The tetrahedron has its right-angled corner at (x, y, z) and edges a, b, c along the axes.
// Vertices: int r r^T dm = m/20 (sum over the vertices of v v^T + 16 times that of the center of mass).
// Slices: at the height c s the section is the base triangle, scaled by 1 - s. Its mean of a quadratic is the
// mean over the midpoints of its sides.
namespace oddity::truth {

namespace tetrahedron_02_15 {

/// The six components from a function that integrates a quadratic over the body.
template <class Integrate>
Numbers components(const Integrate& over) {
  const auto product = [&](int i, int j) -> Number {
    return over([=](const Numbers& r) -> Number {
      return r[static_cast<std::size_t>(i)] * r[static_cast<std::size_t>(j)];
    });
  };
  const Number xx = product(0, 0), yy = product(1, 1), zz = product(2, 2);
  return {yy + zz, xx + zz, xx + yy, product(0, 1), product(0, 2), product(1, 2)};
}

Numbers by_vertices(const std::vector<double>& in, int) {
  const Number a = in[0], b = in[1], c = in[2], x = in[3], y = in[4], z = in[5];
  const Number mass = Number(in[6]) * a * b * c / 6;
  return components([&](const auto& f) -> Number {
    const Number corners = f({x, y, z}) + f({x + a, y, z}) + f({x, y + b, z}) + f({x, y, z + c});
    return mass / 20 * (corners + 16 * f({x + a / 4, y + b / 4, z + c / 4}));
  });
}

Numbers by_slices(const std::vector<double>& in, int digits) {
  const Number a = in[0], b = in[1], c = in[2], x = in[3], y = in[4], z = in[5], rho = in[6];
  return components([&](const auto& f) -> Number {
    const auto section = [&](const Number& h) -> Number {
      const Number s = 1 - h / c, u = a * s, v = b * s, up = z + h;
      const Number middles = f({x + u / 2, y, up}) + f({x, y + v / 2, up}) + f({x + u / 2, y + v / 2, up});
      return rho * u * v / 2 * middles / 3;
    };
    return integral(section, 0, c, digits);
  });
}

}  // namespace tetrahedron_02_15

Truth truth_02_15_tetrahedron() {
  using namespace tetrahedron_02_15;
  return {
      "inertia about the origin of a tetrahedron with legs a, b, c from the corner (x, y, z), density rho",
      "Ixx = rho int y^2 + z^2, Iyy = rho int x^2 + z^2, Izz = rho int x^2 + y^2, Ixy = rho int x y, ...",
      {"a", "b", "c", "x", "y", "z", "rho"},
      {{"Ixx", "kg m^2"},
       {"Iyy", "kg m^2"},
       {"Izz", "kg m^2"},
       {"Ixy", "kg m^2"},
       {"Ixz", "kg m^2"},
       {"Iyz", "kg m^2"}},
      {{1, 1.5, 0.75, 2, -1, 0.5, 1},
       {1, 1.5, 0.75, -0.25, -0.375, -0.1875, 1},
       {1, 1.5, 0.75, 0, 0, 0, 1},
       {0.125, 2, 8, -3, 0.25, 5, 2}},
      "vertices and center of mass",
      by_vertices,
      "slices: double-exponential quadrature over the height",
      by_slices,
      "the first route",
      by_vertices};
}

}  // namespace oddity::truth
