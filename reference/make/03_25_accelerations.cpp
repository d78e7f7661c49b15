#include "reference/make/03_25_chain.hpp"

// Angular accelerations of the first, the middle and the last of n links whose masses, lengths, angles and
// speeds follow dyadic patterns. First route: tensions, eliminated from the pivot on. Second route: the
// articulated-body recursion [Featherstone, Rigid Body Dynamics Algorithms, ch. 7], from the free end: the
// chain beyond a joint resists its acceleration a by the force A a + b.
namespace oddity::truth {

namespace accelerations_03_25 {

struct Pattern {
  ChainData chain;
  std::vector<double> theta, omega;

  explicit Pattern(const std::vector<double>& in) {
    const int n = static_cast<int>(in[0]);
    chain.g = in[1];
    chain.h = 0;
    for (int k = 0; k < n; ++k) {
      chain.m.push_back(Number(1 + k % 4 / 4.0));
      chain.r.push_back(Number(1 + k % 3 / 4.0));
      theta.push_back(k * 37 % 64 / 32.0 - 1);
      omega.push_back(k * 29 % 64 / 32.0 - 1);
    }
  }
};

Numbers chosen(const Numbers& alpha) { return {alpha.front(), alpha[(alpha.size() - 1) / 2], alpha.back()}; }

Numbers by_tensions(const std::vector<double>& in, int) {
  const Pattern p(in);
  const ChainTensions rhs{p.chain};
  const Numbers x = rhs.start(p.theta, p.omega), dxdt = rhs(x, Number(0));
  const std::size_t n = p.theta.size();
  Numbers alpha;
  for (std::size_t k = 0; k < n; ++k)
    alpha.push_back((x[2 * k] * dxdt[2 * n + 2 * k + 1] - x[2 * k + 1] * dxdt[2 * n + 2 * k]) /
                    (x[2 * k] * x[2 * k] + x[2 * k + 1] * x[2 * k + 1]));
  return chosen(alpha);
}

struct Resistance {
  Number xx, xy, yy, bx, by;
};

Numbers by_articulation(const std::vector<double>& in, int) {
  const Pattern p(in);
  const ChainData& c = p.chain;
  const std::size_t n = p.theta.size();
  std::vector<Resistance> at(n + 1, Resistance{0, 0, 0, 0, 0});
  const auto beyond = [&](std::size_t k) {
    Resistance all = at[k + 1];
    all.xx += c.m[k];
    all.yy += c.m[k];
    all.by += c.m[k] * c.g;
    return all;
  };
  for (std::size_t k = n; k-- > 0;) {
    const Resistance A = beyond(k);
    const Number s = sin(Number(p.theta[k])), co = cos(Number(p.theta[k])),
                 pull = c.r[k] * Number(p.omega[k]) * p.omega[k];
    const Number nx = A.xx * co + A.xy * s, ny = A.xy * co + A.yy * s, nn = co * nx + s * ny;
    const Number bx = A.bx - pull * (A.xx * s - A.xy * co), by = A.by - pull * (A.xy * s - A.yy * co);
    const Number share = (co * bx + s * by) / nn;
    at[k] = {A.xx - nx * nx / nn, A.xy - nx * ny / nn, A.yy - ny * ny / nn, bx - nx * share, by - ny * share};
  }
  Numbers alpha;
  Number ax = 0, ay = 0;
  for (std::size_t k = 0; k < n; ++k) {
    const Resistance A = beyond(k);
    const Number s = sin(Number(p.theta[k])), co = cos(Number(p.theta[k])),
                 pull = c.r[k] * Number(p.omega[k]) * p.omega[k];
    const Number nx = A.xx * co + A.xy * s, ny = A.xy * co + A.yy * s, nn = co * nx + s * ny;
    ax -= pull * s;
    ay += pull * co;
    const Number along = -(nx * ax + ny * ay + co * A.bx + s * A.by) / nn;
    alpha.push_back(along / c.r[k]);
    ax += along * co;
    ay += along * s;
  }
  return chosen(alpha);
}

}  // namespace accelerations_03_25

Truth truth_03_25_accelerations() {
  using namespace accelerations_03_25;
  std::vector<std::vector<double>> rows;
  for (double g : {9.8125, 1.5})
    for (double n : {3.0, 10.0, 30.0, 100.0, 300.0, 1000.0}) rows.push_back({n, g});
  return {"angular accelerations of the first, the middle and the last of n links in a patterned state",
          "sum over j of mu_max(i,j) r_j (cos(theta_i - theta_j) theta_j'' + sin(theta_i - theta_j) "
          "theta_j'^2) = -mu_i g sin(theta_i)",
          {"n", "g"},
          {{"first", "rad/s^2"}, {"middle", "rad/s^2"}, {"last", "rad/s^2"}},
          rows,
          "tensions, eliminated from the pivot on",
          by_tensions,
          "articulated recursion from the free end",
          by_articulation,
          "the first route",
          by_tensions};
}

}  // namespace oddity::truth
