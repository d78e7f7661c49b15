#include "reference/make/03_29_wire.hpp"

namespace oddity::truth {

namespace inertia_03_29 {

Numbers listed(const wire::Inertia& i) { return {i.mu0, i.x, i.y, i.mu2}; }

Numbers by_primitives(const std::vector<double>& in, int) {
  return listed(wire::by_primitives(static_cast<int>(in[0]), in[1], in[2]));
}

Numbers by_quadrature(const std::vector<double>& in, Precision digits) {
  return listed(wire::by_quadrature(static_cast<int>(in[0]), in[1], in[2], digits + 3));
}

}  // namespace inertia_03_29

Truth truth_03_29_inertia() {
  using namespace inertia_03_29;
  std::vector<std::vector<double>> rows;
  for (double shape : {0, 1, 2})
    for (double q : {1.0, 0.625, 3.0}) rows.push_back({shape, q, 2});
  return {
      "mass, center of mass and moment about it of a uniform wire: 0 straight, 1 a half circle, 2 a parabola",
      "mu0 = int d ds, c = int d r ds/mu0, mu2 = int d |r - c|^2 ds",
      {"shape", "q", "d"},
      {{"mu0", "kg"}, {"x", "m"}, {"y", "m"}, {"mu2", "kg m^2"}},
      rows,
      "primitives",
      by_primitives,
      "double-exponential quadrature over x, over the angle, over y",
      by_quadrature,
      "the first route",
      by_primitives};
}

}  // namespace oddity::truth
