#include "reference/make/03_29_wire.hpp"
#include "reference/make/taylor.hpp"

// A wire along y = x^2 from 0 to q is thrown with its center of mass at the origin, the velocity (u, v) and
// the angular velocity w. Its mark is its first end. The second route has two particles of mu0/2 each, at the
// distance k = sqrt(mu2/mu0) from the center of mass, joined by a massless rod. Its unknowns are half their
// sum and half their difference. After a long fall the particles' own places would hide digits of the rod.
namespace oddity::truth {

namespace fall_03_29 {

Numbers by_center(const std::vector<double>& in, int) {
  const Number q = in[0], u = in[2], v = in[3], w = in[4], g = in[5], t = in[6];
  const auto wire = wire::by_primitives(wire::parabola, q, in[1]);
  const Number c = cos(w * t), s = sin(w * t);
  return {u * t - c * wire.x + s * wire.y, v * t - g * t * t / 2 - s * wire.x - c * wire.y};
}

Numbers by_particles(const std::vector<double>& in, Precision digits) {
  const Number q = in[0], u = in[2], v = in[3], w = in[4], g = in[5], t = in[6];
  const auto wire = wire::by_quadrature(wire::parabola, q, in[1], digits + 3);
  const Number k = sqrt(wire.mu2 / wire.mu0);
  const auto rhs = [&](const auto& x, const auto& now) {
    const auto &dx = x[2], &dy = x[3], &du = x[6], &dv = x[7];
    const auto hold = (du * du + dv * dv) / (dx * dx + dy * dy);
    const auto nothing = Number(0) * now;
    return std::vector{x[4], x[5], du, dv, nothing, nothing - g, -(hold * dx), -(hold * dy)};
  };
  const Numbers x = solve_taylor(rhs, {0, 0, k, 0, u, v, 0, w * k}, 0, t, digits + 4);
  const Number c = x[2] / k, s = x[3] / k;
  return {x[0] - c * wire.x + s * wire.y, x[1] - s * wire.x - c * wire.y};
}

}  // namespace fall_03_29

Truth truth_03_29_fall() {
  using namespace fall_03_29;
  std::vector<std::vector<double>> rows;
  for (double w : {6.0, 1.0, 3.0, 10.0, 20.0})
    for (double t : {0.5, 1.0, 1.5, 2.0}) rows.push_back({1, 2, 2, 5, w, 9.81, t});
  return {"first end of a thrown wire along y = x^2, its center of mass starting at the origin",
          "m c'' = -m g j, theta'' = 0, r = c + R(theta) b",
          {"q", "d", "u", "v", "w", "g", "t"},
          {{"x", "m"}, {"y", "m"}},
          rows,
          "parabola of the center and uniform turning, the center of mass by primitives",
          by_center,
          "Taylor series of two particles and a rod, the inertia by quadrature",
          by_particles,
          "the first route",
          by_center};
}

}  // namespace oddity::truth
