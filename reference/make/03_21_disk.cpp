#include "reference/make/extrapolation.hpp"
#include "reference/make/taylor.hpp"

// A disk of mass m and radius r at the end of a pipe of length L, held at the inclination phi. A force f
// along x and friction -k times its velocity act on its center. A = (m L^2 + m r^2/4) sin(phi)^2.
//   angle   A theta'' = -f L sin(phi) sin(theta) - k L^2 sin(phi)^2 theta', psi' + theta' cos(phi) constant.
//   center  M x'' = (f, 0) - k x' + a force to the center of its circle, M = m + m r^2/(4 L^2).
namespace oddity::truth {

namespace disk_03_21 {

struct Pipe {
  Number m, L, moment, sine, cosine, f, k, theta, theta_dot, psi_dot, t;
  explicit Pipe(const std::vector<double>& in)
      : m(in[0]),
        L(in[1]),
        moment(m * in[2] * in[2] / 4),
        sine(sin(Number(in[3]))),
        cosine(cos(Number(in[3]))),
        f(in[4]),
        k(in[5]),
        theta(in[6]),
        theta_dot(in[7]),
        psi_dot(in[8]),
        t(in[9]) {}
};

Numbers by_taylor(const std::vector<double>& in, Precision digits) {
  const Pipe p(in);
  const Number inertia = (p.m * p.L * p.L + p.moment) * p.sine * p.sine;
  const Number pull = -p.f * p.L * p.sine / inertia, drag = -p.k * p.L * p.L * p.sine * p.sine / inertia;
  const auto rhs = [&](const auto& x, const auto&) {
    return std::vector{x[1], pull * sin(x[0]) + drag * x[1]};
  };
  const Number theta = solve_taylor(rhs, {p.theta, p.theta_dot}, 0, p.t, digits + 4)[0];
  const Number psi = (p.psi_dot + p.theta_dot * p.cosine) * p.t - p.cosine * (theta - p.theta);
  return {p.L * p.sine * cos(theta), p.L * p.sine * sin(theta), psi};
}

Numbers by_center(const std::vector<double>& in, Precision digits) {
  const Pipe p(in);
  const Number mass = p.m + p.moment / (p.L * p.L), radius = p.L * p.sine;
  const auto rhs = [&](const Numbers& s, const Number&) {
    const Number &x = s[0], &y = s[1], &u = s[2], &v = s[3];
    const Number a = (p.f - p.k * u) / mass, b = -p.k * v / mass, square = x * x + y * y;
    const Number inward = (a * x + b * y + u * u + v * v) / square;
    const Number across = (x * b - y * a) / square;
    return Numbers{u, v, a - inward * x, b - inward * y, s[5], -across * p.cosine};
  };
  const Number c = cos(p.theta), s = sin(p.theta);
  const Numbers start{radius * c, radius * s, -radius * s * p.theta_dot, radius * c * p.theta_dot,
                      0,          p.psi_dot};
  const Numbers end = solve_extrapolation(rhs, start, 0, p.t, digits + 6);
  return {end[0], end[1], end[4]};
}

}  // namespace disk_03_21

Truth truth_03_21_disk() {
  using namespace disk_03_21;
  std::vector<std::vector<double>> starts{{1, 2, 0.5, 1, 0, 0, 2, 0.5, 10},
                                          {1, 2, 0.5, 1, 3, 0.2, 2, 0.5, 10},
                                          {1, 2, 0.5, 1, 3, 0, 2, 0.5, 10},
                                          {1, 2, 0.5, 0.01, 3, 0.2, 2, 0.5, 10}};
  for (double theta : {1.5, 0.5, 0.2, 0.1, 0.05}) starts.push_back({1, 2, 0.5, theta, 3, 0.2, 2, 0.5, 10});
  std::vector<std::vector<double>> rows;
  for (const auto& row : starts)
    for (double t : {2.0, 4.0, 6.0, 8.0}) {
      rows.push_back(row);
      rows.back().push_back(t);
    }
  return {"center of a spinning disk at the end of a pipe of fixed inclination, and the angle of its spin",
          "T = (m L^2 + m r^2/4) sin(phi)^2 theta'^2/2 + m r^2 (psi' + theta' cos(phi))^2/4",
          {"m", "L", "r", "phi", "f", "k", "theta", "theta_dot", "psi_dot", "t"},
          {{"x", "m"}, {"y", "m"}, {"psi", "rad"}},
          rows,
          "Taylor series of the angle's equation, the spin from its conserved momentum",
          by_taylor,
          "extrapolated midpoint rule on the center's Cartesian equations and the spin's",
          by_center,
          "the first route, the remainders bounded",
          by_taylor};
}

}  // namespace oddity::truth
