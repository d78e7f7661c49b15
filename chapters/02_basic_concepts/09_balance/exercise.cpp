// Exercise 2.9: a plate of particles balances on every line through its center of mass C.
//   P = C + s D + t N, s = D . (P - C), t = N . (P - C);  M = sum of m t = N . sum of m (P - C) = 0
// The independent route is the torque of the weights about the fulcrum in space, (k x N) . sum of (P - A) x
// (0, 0, -m), which uses no coordinate t. The lines of the derivation hold for any point A of the fulcrum, so
// they are checked at a random one, where M is not zero. The lamina is a half disc with the density exp(k x).

#include "chapters/02_basic_concepts/09_balance/balance.hpp"
#include "reference/reference.hpp"
#include "solvers/counted.hpp"

namespace oddity {

namespace ex02_09 {

using namespace balance;
using namespace bodies;
using std::sqrt;

constexpr Parameter parameters[] = {
    {"k", 1, "1/m", "growth of the half disc's density, $e^{kx}$, along its edge", 0.01, 20},
    {"phi", 0.7, "rad", "direction of the fulcrum", -7, 7},
    {"seed", 9, "", "seed of the random systems", 0, 1e9, whole_number},
};

Integral by_columns(const Rule& rule, double k, std::size_t which) {
  return nested(
      rule, [=](double x, double y) { return moments_of(std::exp(k * x), x, y)[which]; }, -1, 1,
      [](double) { return 0.0; }, [](double x) { return sqrt(std::max(0.0, 1 - x * x)); });
}

/// The center of mass, and the moments over mass about four lines through the true center, 45 degrees apart.
Quantity half_disc(double k, double phi, double seed, const Reference& truth) {
  const Known known = truth("02_09_half_disc", {k});
  const double mass = known.value[0], x = known.value[1], y = known.value[2];
  Quantity q{"half_disc",
             "m",
             "center of mass; first moment over mass about four lines through the true center",
             {known.source + "; zero", {x, y, 0, 0, 0, 0}},
             known.error / mass + 1e-15,
             {1e-10, "a tenth of a nanometre"},
             {},
             {}};
  const auto seen = [=](Answer a) {
    const double dx = a.value[1] - a.value[0] * x, dy = a.value[2] - a.value[0] * y;
    std::vector<double> all{a.value[1] / a.value[0], a.value[2] / a.value[0]};
    for (int j = 0; j < 4; ++j)
      all.push_back((cos(phi + j * pi / 4) * dy - sin(phi + j * pi / 4) * dx) / mass);
    a.value = all;
    a.error_estimate *= 2 / mass;
    return a;
  };
  const auto add = [&](const std::string& model, auto integral, const std::string& algorithm,
                       const Resolution& resolution, Rule (*rule)(double), const std::string& why = "") {
    q.add({model, algorithm, resolution,
           [=](double setting) {
             return seen(all_of(3, [&](std::size_t which) { return integral(rule(setting), k, which); }));
           },
           why.empty() ? Outcome::ok : Outcome::inaccurate, why});
  };
  const Resolution points = doubling("points", 4, 4), panels = doubling("panels", 8, 5);
  const std::string vertical = "the columns' height has a vertical tangent at both ends";
  add("columns", by_columns, "QAGS", tolerances(), qags_rule);
  add("columns", by_columns, "Gauss-Legendre", points, gauss_rule, vertical);
  add("columns", by_columns, "Simpson", panels, simpson_rule, vertical);
  add("columns at x = sin u", by_sine, "CQUAD", tolerances(), cquad_rule);
  add("columns at x = sin u", by_sine, "Gauss-Legendre", points, gauss_rule);
  add("columns at x = sin u", by_sine, "Simpson", panels, simpson_rule,
      filled("its error shrinks as $h^4$: too slow for ten digits at @3 panels", {panels.settings.back()}));
  add("sectors", by_sectors, "QAGS", tolerances(), qags_rule);
  add("sectors", by_sectors, "Gauss-Legendre", points, gauss_rule);
  const std::size_t smooth = q.methods.size();
  add_box_methods<2>(q, {1024, 4096, 16384, 65536}, seed, [k](const std::array<double, 2>& u) {
    const double at = 2 * u[0] - 1;
    return at * at + u[1] * u[1] > 1 ? Moments{} : moments_of(2 * std::exp(k * at), at, u[1]);
  });
  for (std::size_t i = smooth; i < q.methods.size(); ++i)
    q.methods[i].run = [seen, run = q.methods[i].run](double n) { return seen(run(n)); };
  q.add(
      Breakdown{R"(@2 Gauss points a side, exact to rounding over $u$ with $x=\sin u$, keep @1 digits over )"
                "$x$: the half disc ends in vertical tangents.",
                "columns, Gauss-Legendre",
                32,
                Outcome::inaccurate,
                "columns at x = sin u, Gauss-Legendre",
                32,
                {setting_of(Side::broken), digits_of(Side::broken)}});
  return q;
}

/// Five particles with an exact center, 2^30 m from the origin.
Quantity far_balance() {
  constexpr double away = 0x1p30;
  const Vector center{away, -away / 2, 0};
  const std::vector<Particle> particles{{3, center + Vector{5, 1, 0}},
                                        {5, center + Vector{-3, 2, 0}},
                                        {7, center + Vector{2, -3, 0}},
                                        {1, center + Vector{-14, 8, 0}},
                                        {11, center}};
  double mass = 0;
  for (const Particle& p : particles) mass += p.m;
  std::vector<double> beside;
  for (int j = 0; j < 8; ++j) beside.push_back(-mass * j);
  constexpr double need = 1e-12;
  Quantity q{
      "far_balance",
      "kg m",
      filled("first moments of five particles about eight lines, $j=0,1,\\ldots$ m beside their center, "
             "$2^{@2}$ m away",
             {std::log2(length(center))}),
      {filled("$-@2j$: the particles are placed so", {mass}), beside},
      0,
      {need, filled("@2 roundings of the largest moment", {need / (0x1p-52 * std::abs(beside.back()))})},
      {},
      {}};
  const auto add = [&](const std::string& model, const std::string& algorithm, bool relative) {
    const auto moments = [=]<class T>(T all_mass) {
      std::vector<T> all;
      for (int j = 0; j < 8; ++j) {
        const auto along = [x = T(cos(0.3 + j)), y = T(sin(0.3 + j))](const Vector& r) {
          return x * T(r[0]) + y * T(r[1]);
        };
        T sum = 0.0;
        for (const Particle& p : particles)
          sum = sum + T(p.m) * (along(relative ? p.r - center : p.r) - T(j));
        all.push_back(relative ? sum : sum - all_mass * along(center));
      }
      return all;
    };
    const long work = operations_of([&] { return moments(Counted<double>(mass)); }).all_but_additions();
    q.add({model, algorithm, no_resolution(),
           [=](double) {
             return Answer{moments(mass), work};
           },
           relative ? Outcome::ok : Outcome::inaccurate,
           relative ? "" : filled("terms of size $@1$ cancel", {mass * size_of(center)})});
  };
  add("positions relative to the center", "sum of m N . (P - C)", true);
  add("positions from the origin", "sum of m N . P - m N . C", false);
  q.add(
      Breakdown{"Far from the origin the moments of the particles and of the center lose the digits in which "
                "they differ; the text's order, which subtracts the positions first, keeps them.",
                "positions from the origin, sum of m N . P - m N . C", 0, Outcome::inaccurate,
                "positions relative to the center, sum of m N . (P - C)", 0});
  return q;
}

Findings study(const Parameters& p, const Reference& truth) {
  return {claims(p["seed"], p["k"]),
          {half_disc(p["k"], p["phi"], p["seed"], truth), far_balance()},
          roots(),
          R"(The proof is right; {{distance for coordinate|its "distance" has a sign}}.)"};
}

}  // namespace ex02_09

Exercise exercise_2_9() {
  using namespace ex02_09;
  return {
      "Balance of a plate",
      "Show that a plate of point masses $m_i$ balances on every line through its center of mass $C$. Below "
      "$D$ and $N$ are the line's direction and normal, $s$ and $t$ the coordinates of a point along them, "
      "counted from $C$.",
      parameters,
      {},
      study,
      proofs,
      Expected::in_whole_ranges};
}

}  // namespace oddity
