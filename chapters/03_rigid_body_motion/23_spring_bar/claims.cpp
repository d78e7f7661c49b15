#include "chapters/claims.hpp"

#include "chapters/03_rigid_body_motion/23_spring_bar/spring_bar.hpp"
#include "chapters/03_rigid_body_motion/shared/lagrange.hpp"
#include "reference/text.hpp"
#include "solvers/quadrature.hpp"

namespace oddity::ex03_23 {

namespace {

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
  double size() const { return m * g * r + c * (s + h + ell) * (s + h + ell) + m * r * r * (v * v + abs(a)); }
  std::string where() const {
    return R"($m,r,s,c,h,g,\ell$ = )" + format_significant(m, 4) + ", " + format_significant(r, 4) + ", " +
           format_significant(s, 4) + ", " + format_significant(c, 4) + ", " + format_significant(h, 4) +
           ", " + format_significant(g, 4) + ", " + format_significant(ell, 4) +
           R"(; $\theta,\dot\theta,\ddot\theta$ = )" + format_significant(q, 4) + ", " +
           format_significant(v, 4) + ", " + format_significant(a, 4);
  }

  double length(double angle) const { return hypot(s * cos(angle) - s, s * sin(angle) + h); }
  /// Moments about the origin of the forces at the ends of their arms.
  double moment_of_weight(double angle) const { return r * cos(angle) * (-m * g); }
  double moment_of_spring(double angle) const {
    const double x = s * cos(angle), y = s * sin(angle), d = length(angle), pull = -c * (d - ell);
    return (x * (y + h) - y * (x - s)) / d * pull;
  }
  double moments(double angle) const { return moment_of_weight(angle) + moment_of_spring(angle); }
  /// What has to be done against a moment from the level to q.
  double work(double (Sample::*moment)(double) const) const {
    return -gauss_legendre([&](double angle) { return (this->*moment)(angle); }, 0, q, 100).value;
  }
  spring_bar::Given<double> bar() const { return {m, r, s, c, h, g, ell, 0, 0}; }
  /// T + sign V by the positions.
  auto energies(double sign) const {
    return [*this, sign](const auto& angle, const auto& rate, const auto&) {
      const auto vx = -r * sin(angle) * rate, vy = r * cos(angle) * rate;
      return 0.5 * m * (vx * vx + vy * vy) + sign * bar().potential(angle);
    };
  }
  /// m r^2 theta'' by Lagrange's equation.
  double by_lagrange(double angle, double rate, double sign = -1) const {
    return m * r * r * lagrange_acceleration(energies(sign), angle, rate);
  }
  /// d/dt dL/dtheta' - dL/dtheta.
  double left_side() const { return rate_of_df_dv(energies(-1), q, v, a) - df_dq(energies(-1), q, v); }
};
using S = const Sample&;

double of_gravity(S x) { return x.m * x.g * x.r * sin(x.q); }

/// c/2 of the stretch's square less that of another length.
double of_spring(S x, double other) {
  const double stretch =
      sqrt(x.s * x.s * (cos(x.q) - 1) * (cos(x.q) - 1) + (x.h + x.s * sin(x.q)) * (x.h + x.s * sin(x.q))) -
      x.ell;
  return x.c / 2 * (stretch * stretch - other * other);
}

/// The right side of the equation of motion, with factors that are 1 as meant, and the power of d in 1 -
/// ell/d; twice, as it is compared with two routes.
auto equation(double first, double second, double ratio = 1, int power = -1) {
  return [=](S x) {
    const double C = cos(x.q), s2 = x.s * x.s, reach = x.h + x.s * sin(x.q);
    const double d = sqrt(s2 * (C - 1) * (C - 1) + reach * reach);
    const double sum = x.m * x.r * x.r * x.a + x.m * x.g * x.r * C +
                       x.c * (1 - ratio * x.ell * pow(d, power)) *
                           (first * s2 * (1 - C) * sin(x.q) + second * x.s * reach * C);
    return values(sum, sum);
  };
}

auto balance(double sign, double Sample::*arm) {
  return [=](S x) { return x.m * x.g * x.r + sign * x.c * x.*arm * (x.h - x.ell); };
}

/// The spring's moment on the level bar with ell = h + side m g r/(c s).
auto balanced(double side) {
  return [=](Sample x) {
    x.ell = x.h + side * x.m * x.g * x.r / (x.c * x.s);
    return x.moment_of_spring(0);
  };
}

}  // namespace

std::vector<Claim> claims(double seed) {
  Claims claims("3.23");
  const auto samples = draw<Sample>(200, seed);

  claims.formula<Sample>(
      "potential_of_gravity", 2579, "the potential energy of gravity", samples,
      {.truth = {"the work done against the weight from the level, by quadrature",
                 [](S x) { return x.work(&Sample::moment_of_weight); }},
       .printed = {R"($mgr\sin\theta$)", of_gravity},
       .near_misses = {{R"($mgr\cos\theta$)", [](S x) { return x.m * x.g * x.r * cos(x.q); }},
                       {R"($-mgr\sin\theta$)", [](S x) { return -of_gravity(x); }}}});
  claims.formula<Sample>(
      "potential_of_spring", 2583, "the potential energy of the spring", samples,
      {.truth = {"the work done against the spring from the level, by quadrature",
                 [](S x) { return x.work(&Sample::moment_of_spring); }},
       .printed =
           {R"($\frac c2\Big(\big(\sqrt{s^2(\cos\theta-1)^2+(h+s\sin\theta)^2}-\ell\big)^2-(h-\ell)^2\Big)$)",
            [](S x) { return of_spring(x, x.h - x.ell); }},
       .near_misses = {{R"($h^2$ for $(h-\ell)^2$)", [](S x) { return of_spring(x, x.h); }},
                       {"twice as much", [](S x) { return 2 * of_spring(x, x.h - x.ell); }}}});
  claims.formula<Sample>(
      "potential", 2593, "the potential energy", samples,
      {.truth = {"the work done against both from the level, by quadrature",
                 [](S x) { return x.work(&Sample::moment_of_weight) + x.work(&Sample::moment_of_spring); }},
       .printed = {"the sum of the two", [](S x) { return of_gravity(x) + of_spring(x, x.h - x.ell); }},
       .near_misses = {{"their difference", [](S x) { return of_gravity(x) - of_spring(x, x.h - x.ell); }}}});
  claims.formula<Sample>(
      "kinetic_energy", 2597, "the kinetic energy", samples,
      {.truth = {R"($\frac m2|\dot x|^2$, the velocity by dual numbers)",
                 [](S x) {
                   const Dual<double> q(x.q, x.v), along = x.r * cos(q), up = x.r * sin(q);
                   return x.m / 2 * (along.slope * along.slope + up.slope * up.slope);
                 }},
       .printed = {R"($\frac m2r^2\dot\theta^2$)", [](S x) { return x.m / 2 * x.r * x.r * x.v * x.v; }},
       .near_misses = {{R"($\frac m6r^2\dot\theta^2$, a uniform bar of length $r$)",
                        [](S x) { return x.m / 6 * x.r * x.r * x.v * x.v; }},
                       {R"($\frac m2r\dot\theta^2$)", [](S x) { return x.m / 2 * x.r * x.v * x.v; }}}});

  claims.formula<Sample>(
      "lagrangian", 2601, R"(the Lagrangian; it gives $mr^2\ddot\theta$)", samples,
      {.truth = {"the moments of the weight and of the spring", [](S x) { return x.moments(x.q); }},
       .printed = {"$L=T-V$", [](S x) { return x.by_lagrange(x.q, x.v); }},
       .near_misses = {{"$L=T+V$", [](S x) { return x.by_lagrange(x.q, x.v, 1); }}}});
  const std::string lagrange =
      R"($\frac{d}{dt}\frac{\partial L}{\partial\dot\theta}-\frac{\partial L}{\partial\theta}$ by nested dual numbers)";
  const auto by_potential = [](double sign) {
    return [sign](S x) {
      const auto V = [bar = x.bar()](const auto& q) { return bar.potential(q); };
      return x.m * x.r * x.r * x.a + sign * derivative(V, x.q);
    };
  };
  claims.formula<Sample>("equation_in_V", 2613, "the right side of the equation of motion", samples,
                         {.truth = {lagrange, &Sample::left_side},
                          .printed = {R"($mr^2\ddot\theta+dV/d\theta$)", by_potential(1)},
                          .near_misses = {{R"($mr^2\ddot\theta-dV/d\theta$)", by_potential(-1)}}});
  claims.formula<Sample>(
      "equation_of_motion", 2615,
      R"(the equation of motion is $0=mr^2\ddot\theta+mgr\cos\theta+c\,(1-\ell\sqrt{\dots})\,)"
      R"((s^2(1-\cos\theta)\sin\theta+s(h+s\sin\theta)\cos\theta)$)",
      samples,
      {.quantity = "the right side of the equation of motion",
       .truth = {lagrange + R"(, and $mr^2\ddot\theta$ less the moments of the forces)",
                 [](S x) { return values(x.left_side(), x.m * x.r * x.r * x.a - x.moments(x.q)); }},
       .printed = {R"($1-\ell\,d$, a product with $d=\sqrt{s^2(\cos\theta-1)^2+(h+s\sin\theta)^2}$)",
                   equation(1, 1, 1, 1)},
       .meant = {R"($1-\ell/d$)", equation(1, 1)},
       .near_misses = {{R"($1-\ell/d$ with $s^2(\cos\theta-1)\sin\theta$)", equation(-1, 1)},
                       {R"($1-\ell/d$ with $-s(h+s\sin\theta)\cos\theta$)", equation(1, -1)},
                       {R"($1+\ell/d$)", equation(1, 1, -1)},
                       {R"($1-\ell/d$ with half of the bracket)", equation(0.5, 0.5)}},
       .kind = Fault::lost_typography,
       .why =
           R"(The fraction bar is lost in the text at hand: $1-\ell/\sqrt{\dots}$. As a product it subtracts )"
           R"(an area from a number; at the level bar of the scene, $h=0.8$ m and $\ell=1$ m, it is 0.2 for )"
           R"($-0.25$, and the pressed spring, which holds the bar up, would pull it down.)"});

  const Formula<Sample> condition{R"($mgr+cs(h-\ell)$)", balance(1, &Sample::s)};
  const std::vector<Formula<Sample>> others{{R"($mgr-cs(h-\ell)$)", balance(-1, &Sample::s)},
                                            {R"($mgr+cr(h-\ell)$)", balance(1, &Sample::r)}};
  claims.formula<Sample>(
      "equilibrium_terms", 2623,
      R"(the condition of equilibrium has all terms at $\theta=0$ but the one in $\ddot\theta$)", samples,
      {.truth = {R"($-mr^2\ddot\theta$ of the level bar at rest, by Lagrange's equation)",
                 [](S x) { return -x.by_lagrange(0, 0); }},
       .printed = condition,
       .near_misses = others});
  claims.formula<Sample>(
      "equilibrium_condition", 2625, "what is zero when the level bar is in equilibrium", samples,
      {.truth = {"the moments of the forces on the level bar, clockwise", [](S x) { return -x.moments(0); }},
       .printed = condition,
       .near_misses = others});
  claims.formula<Sample>("as_by_virtual_work", 2627, "the condition is that of the equilibrium of forces",
                         samples,
                         {.quantity = "the spring's moment on the level bar",
                          .truth = {"minus the weight's", [](S x) { return -x.moment_of_weight(0); }},
                          .printed = {R"(with $\ell=h+mgr/(cs)$, which the condition asks for)", balanced(1)},
                          .near_misses = {{R"(with $\ell=h-mgr/(cs)$)", balanced(-1)}}});
  return claims.in_order();
}

}  // namespace oddity::ex03_23
