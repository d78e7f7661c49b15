#include "reference/make/routes.hpp"
#include "reference/make/taylor.hpp"
#include "reference/make/universal_kepler.hpp"

// Two bodies that attract each other by G m1 m2/r^2: the second one relative to the first. The first route
// solves Kepler's equation in universal variables with mu = G (m1 + m2); the second moves both bodies.
namespace oddity::truth {

namespace two_bodies_03_27 {

struct Start {
  Number m1, m2, G, x, y, vx, vy;

  explicit Start(const std::vector<double>& in) : m1(in[1]), m2(in[2]), G(in[0]) {
    const Number r = in[3], radial = in[4], phi = in[5], transverse = r * Number(in[6]);
    const Number c = cos(phi), s = sin(phi);
    x = r * c;
    y = r * s;
    vx = radial * c - transverse * s;
    vy = radial * s + transverse * c;
  }
};

Numbers by_kepler(const std::vector<double>& in, Precision digits) {
  const Start a(in);
  return by_universal_kepler(a.G * (a.m1 + a.m2), {a.x, a.y, a.vx, a.vy}, in[7], digits);
}

Numbers by_taylor(const std::vector<double>& in, Precision digits) {
  const Start a(in);
  const auto rhs = [&](const auto& q, const auto&) {
    const auto dx = q[2] - q[0], dy = q[3] - q[1];
    const auto square = dx * dx + dy * dy;
    const auto pull = a.G / (square * sqrt(square));
    return std::vector{
        q[4], q[5], q[6], q[7], a.m2 * pull * dx, a.m2 * pull * dy, -a.m1 * pull * dx, -a.m1 * pull * dy};
  };
  const Number first = a.m2 / (a.m1 + a.m2), second = a.m1 / (a.m1 + a.m2);
  const Numbers end = solve_taylor(rhs,
                                   {-first * a.x, -first * a.y, second * a.x, second * a.y, -first * a.vx,
                                    -first * a.vy, second * a.vx, second * a.vy},
                                   0, Number(in[7]), digits + 4);
  return {end[2] - end[0], end[3] - end[1]};
}

}  // namespace two_bodies_03_27

Truth truth_03_27_two_bodies() {
  using namespace two_bodies_03_27;
  std::vector<std::vector<double>> rows;
  for (double rate : {1.5, 0.5, 0x1p-5, 1.7, 1.0, 0.25, 0.17})
    for (double t : {1.0, 2.0, 3.0, 4.0}) rows.push_back({1, 2, 1, 1, 0.25, 0.5, rate, t});
  return {"position of the second of two bodies, seen from the first, t after (r0, r0', phi0, phi0')",
          "r'' = r phi'^2 - G (m1 + m2)/r^2, r^2 phi' constant",
          {"G", "m1", "m2", "r0", "r0_dot", "phi0", "phi0_dot", "t"},
          {{"x", "m"}, {"y", "m"}},
          rows,
          "Kepler's equation in universal variables",
          by_kepler,
          "Taylor series of the two bodies in Cartesian coordinates",
          by_taylor,
          "the first route, each sign proved and the rest of each series bounded",
          by_kepler};
}

}  // namespace oddity::truth
