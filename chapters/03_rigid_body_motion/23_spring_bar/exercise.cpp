// Exercise 3.23: a bar without mass turns about the origin; at r it carries a mass m, at s it stands on a
// spring of constant c and rest length ell from (s, -h). Its equation of motion, and when is it at rest
// level?
//   m r^2 theta'' + m g r cos theta + c (1 - ell/d) (s^2 (1 - cos) sin + s (h + s sin) cos) = 0
//   d^2 = s^2 (cos theta - 1)^2 + (h + s sin theta)^2
// The energies are compared with the work of the forces in the plane, the equation with the Lagrangian,
// differentiated by dual numbers, and with the moments of the forces. Small oscillations have the frequency
// (s/r) sqrt(c/m), in which neither gravity nor the spring's length appears.

#include "chapters/03_rigid_body_motion/23_spring_bar/spring_bar.hpp"
#include "reference/text.hpp"
#include "solvers/quadrature.hpp"

namespace oddity {

namespace ex03_23 {

using namespace spring_bar;
using std::cos, std::sin, std::sqrt;

constexpr Parameter parameters[] = {
    {"m", 1, "kg", "mass", 0.1, 100},
    {"r", 1, "m", "where the mass is on the bar", 0.1, 10},
    {"s", 0.5, "m", "where the spring is on the bar", 0.1, 10},
    {"c", 98.1, "N/m", "spring constant", 1, 1e4},
    {"h", 0.8, "m", "depth of the spring's foot", 0.2, 10},
    {"g", 9.81, "m/s^2", "gravity", 0, 100},
    {"ell", 1, "m", "rest length of the spring", 0.1, 20},
    {"theta0", 0.3, "rad", "angle at the start", -1.5, 1.5},
    {"w0", 0, "rad/s", "angular speed at the start", -2, 2},
    {"seed", 23, "", "seed of the random samples", 0, 1e9, whole_number},
};

// ---- the claims -------------------------------------------------------------------------------------------

/// A random bar at a random angle q with q' = v, q'' = a.
struct Sample {
  double m, r, s, c, h, g, ell, q, v, a;

  explicit Sample(Random& random)
      : m(random.between(0.3, 3)),
        r(random.between(0.3, 3)),
        s(random.between(0.3, 1)),
        c(random.between(1, 30)),
        h(random.between(1.2, 3)),
        g(random.between(1, 10)),
        ell(random.between(0.3, 4)),
        q(random.between(-3, 3)),
        v(random.between(-3, 3)),
        a(random.between(-5, 5)) {}

  std::array<double*, 10> letters() { return {&m, &r, &s, &c, &h, &g, &ell, &q, &v, &a}; }
  double size() const {
    return m * g * r + c * (s + h + ell) * (s + h + ell) + m * r * r * (v * v + std::abs(a));
  }
  std::string where() const {
    return "m, r, s, c, h, g, ell = " + rounded(m, 4) + ", " + rounded(r, 4) + ", " + rounded(s, 4) + ", " +
           rounded(c, 4) + ", " + rounded(h, 4) + ", " + rounded(g, 4) + ", " + rounded(ell, 4) +
           "; theta, theta', theta'' = " + rounded(q, 4) + ", " + rounded(v, 4) + ", " + rounded(a, 4);
  }

  double length(double angle) const { return std::hypot(s * cos(angle) - s, s * sin(angle) + h); }
  /// Moments about the origin of the forces at the ends of their arms.
  double moment_of_weight(double angle) const { return r * cos(angle) * (-m * g); }
  double moment_of_spring(double angle) const {
    const double x = s * cos(angle), y = s * sin(angle), d = length(angle), pull = -c * (d - ell);
    return (x * (y + h) - y * (x - s)) / d * pull;
  }
  /// What has to be done against a moment from the level to q.
  double work(double (Sample::*moment)(double) const) const {
    return -gauss_legendre([&](double angle) { return (this->*moment)(angle); }, 0, q, 100).value;
  }
  auto T() const {
    return [*this](const auto& angle, const auto& rate, const auto&) {
      const auto vx = -r * sin(angle) * rate, vy = r * cos(angle) * rate;
      return 0.5 * m * (vx * vx + vy * vy);
    };
  }
  /// T + sign V, V by its positions.
  auto energies(double sign) const {
    return [*this, sign](const auto& angle, const auto& rate, const auto& t) {
      return T()(angle, rate, t) + sign * Given<double>{m, r, s, c, h, g, ell, 0, 0}.potential(angle);
    };
  }
};
using S = const Sample&;
using Versions = std::vector<Version<Sample>>;

double gravity(S x) { return x.m * x.g * x.r * sin(x.q); }

double spring(S x, double at_rest) {
  const double stretch =
      sqrt(x.s * x.s * (cos(x.q) - 1) * (cos(x.q) - 1) + (x.h + x.s * sin(x.q)) * (x.h + x.s * sin(x.q))) -
      x.ell;
  return x.c / 2 * (stretch * stretch - at_rest * at_rest);
}

/// The right side of the equation of motion; signs and factors are 1 as meant. `power` is that of the
/// spring's length d in 1 - ell/d.
double equation(S x, double first, double second, double ratio = 1, int power = -1) {
  const double C = cos(x.q), s2 = x.s * x.s, reach = x.h + x.s * sin(x.q);
  const double d = sqrt(s2 * (C - 1) * (C - 1) + reach * reach);
  return x.m * x.r * x.r * x.a + x.m * x.g * x.r * C +
         x.c * (1 - ratio * x.ell * std::pow(d, power)) *
             (first * s2 * (1 - C) * sin(x.q) + second * x.s * reach * C);
}

double balance(S x, double sign, double arm) { return x.m * x.g * x.r + sign * x.c * arm * (x.h - x.ell); }

std::vector<Claim> claims(double seed) {
  std::vector<Claim> all;
  const auto says = [&](const char* id, int line, const char* what, const Version<Sample>& printed,
                        const Version<Sample>& truth, const Versions& near) {
    all.push_back(formula_claim(std::string("3.23-") + id, line, what, seed, printed, truth, near));
  };
  const auto also = [&](const char* what, const Version<Sample>& printed, const Version<Sample>& truth) {
    all.back().printed.checks.push_back(compare<Sample>(what, printed, truth, seed));
  };
  says("potential_of_gravity", 2579, "the potential energy of gravity", {"m g r sin theta", gravity},
       {"work against the weight, by quadrature", [](S x) { return x.work(&Sample::moment_of_weight); }},
       {{"m g r cos theta", [](S x) { return x.m * x.g * x.r * cos(x.q); }},
        {"-m g r sin theta", [](S x) { return -gravity(x); }}});
  says("potential_of_spring", 2583, "the potential energy of the spring",
       {"(c/2) ((sqrt(s^2 (cos - 1)^2 + (h + s sin)^2) - ell)^2 - (h - ell)^2)",
        [](S x) { return spring(x, x.h - x.ell); }},
       {"work against the spring, by quadrature", [](S x) { return x.work(&Sample::moment_of_spring); }},
       {{"- h^2 at the end", [](S x) { return spring(x, x.h); }},
        {"twice as much", [](S x) { return 2 * spring(x, x.h - x.ell); }}});
  says("potential", 2593, "the potential energy",
       {"the sum of the two", [](S x) { return gravity(x) + spring(x, x.h - x.ell); }},
       {"work against both, by quadrature",
        [](S x) { return x.work(&Sample::moment_of_weight) + x.work(&Sample::moment_of_spring); }},
       {{"their difference", [](S x) { return gravity(x) - spring(x, x.h - x.ell); }}});
  says(
      "kinetic_energy", 2597, "the kinetic energy",
      {"(m/2) r^2 theta'^2", [](S x) { return x.m / 2 * x.r * x.r * x.v * x.v; }},
      {"(m/2) |x'|^2, x' by dual numbers",
       [](S x) {
         const Dual<double> q(x.q, x.v), along = x.r * cos(q), up = x.r * sin(q);
         return x.m / 2 * (along.slope * along.slope + up.slope * up.slope);
       }},
      {{"(m/6) r^2 theta'^2, a uniform bar of length r", [](S x) { return x.m / 6 * x.r * x.r * x.v * x.v; }},
       {"(m/2) r theta'^2", [](S x) { return x.m / 2 * x.r * x.v * x.v; }}});
  const auto moments = [](S x) { return x.moment_of_weight(x.q) + x.moment_of_spring(x.q); };
  const auto by_lagrangian = [](double sign) {
    return [sign](S x) { return x.m * x.r * x.r * lagrange_acceleration(x.energies(sign), x.q, x.v); };
  };
  says("lagrangian", 2601, "m r^2 theta'' by Lagrange's equation", {"L = T - V", by_lagrangian(-1)},
       {"the moments of the weight and of the spring", moments}, {{"L = T + V", by_lagrangian(1)}});
  const Version<Sample> lagrange{
      "d/dt dL/dtheta' - dL/dtheta by nested dual numbers",
      [](S x) { return momentum_rate(x.energies(-1), x.q, x.v, x.a) - d_dq(x.energies(-1), x.q, x.v); }};
  const auto by_potential = [](double sign) {
    return [sign](S x) {
      const Given<double> bar{x.m, x.r, x.s, x.c, x.h, x.g, x.ell, 0, 0};
      return x.m * x.r * x.r * x.a + sign * derivative([&](const auto& q) { return bar.potential(q); }, x.q);
    };
  };
  says("equation_in_V", 2613, "the equation of motion, right side",
       {"m r^2 theta'' + dV/dtheta", by_potential(1)}, lagrange,
       {{"m r^2 theta'' - dV/dtheta", by_potential(-1)}});
  const Version<Sample> written{
      "m r^2 theta'' + m g r cos + c (1 - ell/d) (s^2 (1 - cos) sin + s (h + s sin) cos)",
      [](S x) { return equation(x, 1, 1); }};
  says("equation_of_motion", 2615, "the equation of motion, right side", written, lagrange,
       {{"s^2 (cos - 1) sin", [](S x) { return equation(x, -1, 1); }},
        {"- s (h + s sin) cos", [](S x) { return equation(x, 1, -1); }},
        {"1 + ell/d", [](S x) { return equation(x, 1, 1, -1); }},
        {"half of the bracket", [](S x) { return equation(x, 0.5, 0.5); }}});
  also("the equation of motion, by moments", written, {"m r^2 theta'' - the moments of the forces", [=](S x) {
                                                         return x.m * x.r * x.r * x.a - moments(x);
                                                       }});
  bars_lost(
      all.back(),
      "the equation of motion is 0 = m r^2 theta'' + m g r cos + c (1 - ell sqrt(...)) (s^2 (1 - cos) "
      "sin + s (h + s sin) cos)",
      seed, {"1 - ell d, as a product", [](S x) { return equation(x, 1, 1, 1, 1); }}, lagrange,
      "The fraction bar is lost in the text at hand: $1-\\ell/\\sqrt{\\dots}$. As a product it subtracts "
      "an area from a number; at the level bar of the scene, $h=0.8$ m and $\\ell=1$ m, it is 0.2 for "
      "-0.25, and the pressed spring, which holds the bar up, would pull it down.");

  const Version<Sample> condition{"m g r + c s (h - ell)", [](S x) { return balance(x, 1, x.s); }};
  const Versions other{{"m g r - c s (h - ell)", [](S x) { return balance(x, -1, x.s); }},
                       {"m g r + c r (h - ell)", [](S x) { return balance(x, 1, x.r); }}};
  says("equilibrium_terms", 2623,
       "the equilibrium's condition is all terms but the one in theta'', at theta = 0", condition,
       {"-m r^2 theta'' of the level bar at rest, by Lagrange's equation",
        [](S x) { return -x.m * x.r * x.r * lagrange_acceleration(x.energies(-1), 0, 0); }},
       other);
  says("equilibrium_condition", 2625, "what is zero when the level bar is in equilibrium", condition,
       {"the moments of the forces on the level bar, clockwise",
        [](S x) { return -x.moment_of_weight(0) - x.moment_of_spring(0); }},
       other);
  const auto balanced = [](double side) {
    return [side](S x) {
      Sample y = x;
      y.ell = y.h + side * y.m * y.g * y.r / (y.c * y.s);
      return y.moment_of_spring(0);
    };
  };
  says("as_by_virtual_work", 2627, "the condition is that of the equilibrium of forces; the spring's moment",
       {"with ell = h + m g r/(c s)", balanced(1)},
       {"against the weight's", [](S x) { return -x.moment_of_weight(0); }},
       {{"with ell = h - m g r/(c s)", balanced(-1)}});
  return all;
}

Given<double> asked(const Parameters& p) {
  return {p["m"], p["r"], p["s"], p["c"], p["h"], p["g"], p["ell"], p["theta0"], p["w0"]};
}

Quantity swing_of(const Parameters& p, const Horizon& horizon, const Reference& truth) {
  return swing(asked(p), horizon, truth);
}

Scene scene() {
  return {
      swing_of,
      4,
      centimeter,
      "c",
      {20, 50, 100, 300, 1000, 2500},
      {"theta0", "m", "h"},
      {{"x", "y"}, "s", {{"m", {0, 1}}}},
      {{"chapters/03_rigid_body_motion/23_spring_bar/models.hpp"},
       {{"small oscillation", "spring_bar::SmallOscillation<double>{{m, r, s, c, h, g, ell, theta0, w0}}"},
        {"one angle", "spring_bar::OneAngle<double>{{m, r, s, c, h, g, ell, theta0, w0}}"},
        {"Cartesian with constraint",
         "spring_bar::CartesianWithConstraint<double>{{m, r, s, c, h, g, ell, theta0, w0}}"}}}};
}

Findings study(const Parameters& p, const Reference& truth) {
  const Given<double> bar = asked(p);
  Quantity mass = motion(scene(), p, truth);
  mass.add(Breakdown{
      "Explicit Euler gains energy at every step: at eight steps a second the bar turns over "
      "and over. Classical Runge-Kutta follows it at 256 steps a second.",
      "one angle, explicit Euler", 0.125, Outcome::drifted, "one angle, Runge-Kutta 4", 0.00390625});
  Given<double> stiff = bar;
  stiff.c = 1000 * bar.c;
  stiff.ell = stiff.balancing_rest_length();
  Quantity fast = stiff_swing(stiff, truth);
  fast.add(
      Breakdown{"A spring a thousand times as strong swings at 25 a second; explicit steps longer than "
                "2/w to 2.8/w throw the bar around. Step control finds the step by itself.",
                "one angle, Runge-Kutta 4", 0.0625, Outcome::drifted, "one angle, Fehlberg 7(8)", 1e-10});
  return {claims(p["seed"]), {small_frequency(bar, truth), mass, fast}};
}

}  // namespace ex03_23

Exercise exercise_3_23() {
  using namespace ex03_23;
  return {
      "Bar on a spring",
      "A light bar, hinged at one end, carries a mass $m$ at the distance $r$ and stands at the distance "
      "$s$ on a spring whose foot is $h$ below the level bar. What is its equation of motion, and when is "
      "it in equilibrium at $\\theta=0$?",
      parameters, scene(), study};
}

}  // namespace oddity
