#include "chapters/integral_proofs.hpp"
#include "chapters/provable_claims.hpp"

#include "chapters/03_rigid_body_motion/23_spring_bar/spring_bar.hpp"
#include "chapters/03_rigid_body_motion/shared/lagrange.hpp"
#include "reference/text.hpp"
#include "solvers/quadrature.hpp"

namespace oddity::ex03_23 {

/// A random bar at a random angle q with q' = v, q'' = a.
template <class T>
struct SampleOf {
  T m, r, s, c, h, g, ell, q, v, a;

  Letters<T> table() {
    return {{"m", m, {0.3, 3}},
            {"r", r, {0.3, 3}},
            {"s", s, {0.3, 3}},
            {"c", c, {1, 30}},
            {"h", h, {0.3, 3}},
            {"g", g, {1, 10}},
            {R"(\ell)", ell, {0.3, 4}},
            {R"(\theta)", q, {-3, 3}, "q"},
            {R"(\dot\theta)", v, {-3, 3}, "v"},
            {R"(\ddot\theta)", a, {-5, 5}, "a"}};
  }
  TypesetIn<T> typeset() const {
    return {{R"(dV/d\theta)", derivative([bar = bar()](const auto& x) { return bar.potential(x); }, q)}};
  }
  std::string where() const { return listed(typeset_of(*this), 10); }

  /// Moments about the origin, as arm times force.
  T moment_of_weight(const T& angle) const { return r * cos(angle) * (-m * g); }
  T moment_of_spring(const T& angle) const {
    const T x = s * cos(angle), y = s * sin(angle), across = x - s, up = y + h;
    const T d = sqrt(across * across + up * up), pull = -c * (d - ell);
    return (x * up - y * across) / d * pull;
  }
  T moments(const T& angle) const { return moment_of_weight(angle) + moment_of_spring(angle); }
  /// Work against a moment from the level position to q.
  T work(T (SampleOf::*moment)(const T&) const) const {
    const auto at = [&](const T& angle) { return (this->*moment)(angle); };
    if constexpr (std::same_as<T, Shortened>)
      return -recorded_integral(at, 0, q);
    else
      return -qag(at, 0, q, 1e-14).value;
  }
  spring_bar::Given<T> bar() const { return {m, r, s, c, h, g, ell, T(0), T(0)}; }
  /// T + sign V, from the positions.
  auto energies(double sign) const {
    return [*this, sign](const auto& angle, const auto& rate, const auto&) {
      const auto vx = -r * sin(angle) * rate, vy = r * cos(angle) * rate;
      return 0.5 * m * (vx * vx + vy * vy) + sign * bar().potential(angle);
    };
  }
  /// m r^2 theta'' by Lagrange's equation.
  T by_lagrange(const T& angle, const T& rate, double sign = -1) const {
    return m * r * r * lagrange_acceleration(energies(sign), angle, rate);
  }
  /// d/dt dL/dtheta' - dL/dtheta.
  T left_side() const { return rate_of_df_dv(energies(-1), q, v, a) - df_dq(energies(-1), q, v); }
};

namespace {

using Sample = SampleOf<double>;
using Table = ProvableClaims<SampleOf>;

/// The rest length that balances the level bar; the moments are linear in it.
constexpr auto balancing_length = [](auto x) {
  x.ell = 0;
  const auto without = x.moments(0);
  x.ell = 1;
  return -without / (x.moments(0) - without);
};

void state(Table& table, const std::vector<Sample>& samples) {
  const std::string
      of_gravity = R"(mgr\sin\theta)",
      of_spring =
          R"(\frac c2\Big(\big(\sqrt{s^2(\cos\theta-1)^2+(h+s\sin\theta)^2}-\ell\big)^2-(h-\ell)^2\Big))";
  const auto claim = table.over(samples);
  const auto gravity = []<class T>(const SampleOf<T>& x) { return x.work(&SampleOf<T>::moment_of_weight); };
  const auto spring = []<class T>(const SampleOf<T>& x) { return x.work(&SampleOf<T>::moment_of_spring); };
  claim("potential_of_gravity", 2579, "The potential energy of gravity is $" + of_gravity + "$",
        {"the work done against the weight from the level, by quadrature", gravity}, "$" + of_gravity + "$",
        "the potential energy of gravity");
  claim("potential_of_spring", 2583, "The potential energy of the spring is $" + of_spring + "$",
        {"the work done against the spring from the level, by quadrature", spring}, "$" + of_spring + "$",
        "the potential energy of the spring");
  claim("potential", 2593, "The potential energy $V$ is the sum of the two",
        {"the work done against both from the level, by quadrature",
         [=](const auto& x) { return gravity(x) + spring(x); }},
        "$" + of_gravity + "+" + of_spring + "$", "the potential energy");
  claim("kinetic_energy", 2597, R"(The kinetic energy is $T=\frac m2r^2\dot\theta^2$)",
        {.quantity = "the kinetic energy",
         .truth = {R"($\frac m2|\dot x|^2$, the velocity by dual numbers)",
                   [](const auto& x) {
                     const Dual q(x.q, x.v), along = x.r * cos(q), up = x.r * sin(q);
                     return x.m / 2 * (along.slope * along.slope + up.slope * up.slope);
                   }},
         .printed = R"($\frac m2r^2\dot\theta^2$)",
         .near_misses = {R"($\frac m6r^2\dot\theta^2$)"}});
  claim(
      "lagrangian", 2601, "The Lagrangian is $L=T-V$",
      {.quantity = R"(the Lagrangian; it gives $mr^2\ddot\theta$)",
       .truth = {"the moments of the weight and of the spring", [](const auto& x) { return x.moments(x.q); }},
       .printed = {"by $L=T-V$", [](const auto& x) { return x.by_lagrange(x.q, x.v); }},
       .near_misses = {{"by $L=T+V$", [](const auto& x) { return x.by_lagrange(x.q, x.v, 1); }}}});
  const std::string lagrange =
      R"($\frac{d}{dt}\frac{\partial L}{\partial\dot\theta}-\frac{\partial L}{\partial\theta}$ by nested dual numbers)";
  claim("equation_in_V", 2613, R"(The equation of motion is $0=mr^2\ddot\theta+dV/d\theta$)",
        {lagrange, [](const auto& x) { return x.left_side(); }}, R"($mr^2\ddot\theta+dV/d\theta$)",
        "the right side of the equation of motion");
  const auto written = [](const std::string& before_root, const std::string& after_root) {
    return R"(mr^2\ddot\theta+mgr\cos\theta+c\left(1-)" + before_root +
           R"(\sqrt{s^2(\cos\theta-1)^2+(h+s\sin\theta)^2})" + after_root +
           R"(\right)\left(s^2(1-\cos\theta)\sin\theta+s(h+s\sin\theta)\cos\theta\right)$)";
  };
  claim(
      "equation_of_motion", 2615, "The equation of motion is $0=" + written(R"(\ell)", ""),
      {.quantity = "the right side of the equation of motion",
       .truth = {lagrange + R"(, and $mr^2\ddot\theta$ less the moments of the forces)",
                 [](const auto& x) { return values(x.left_side(), x.m * x.r * x.r * x.a - x.moments(x.q)); }},
       .printed = "$" + written(R"(\ell)", ""),
       .meant = "$" + written(R"(\frac\ell{)", "}"),
       .why = filled(
           R"(The fraction bar is lost in the text at hand: $1-\ell/\sqrt{\dots}$. As a product it subtracts )"
           R"(an area from a number. At the level bar of the scene, $h=@1$ m and $\ell=@1$ m, it is @2 for )"
           R"($@2$: the pressed spring, which holds the bar up, would pull it down.)",
           {usual.h, usual.ell, 1 - usual.ell * usual.h, 1 - usual.ell / usual.h})});

  const std::string condition = R"($mgr+cs(h-\ell)$)";
  claim(
      "equilibrium_terms", 2623,
      R"(The level bar is in equilibrium when all terms at $\theta=0$ but that in $\ddot\theta$ evaluate to )"
      R"(zero (our reading: their sum, which is $mgr+cs(h-\ell)$))",
      {R"($-mr^2\ddot\theta$ of the level bar at rest, by Lagrange's equation)",
       [](const auto& x) { return -x.by_lagrange(0, 0); }},
      condition, R"(the condition of equilibrium has all terms at $\theta=0$ but the one in $\ddot\theta$)");
  claim(
      "equilibrium_condition", 2625, R"(The level bar is in equilibrium when $mgr+cs(h-\ell)=0$)",
      {"the moments of the forces on the level bar, clockwise", [](const auto& x) { return -x.moments(0); }},
      condition, "the moment on the level bar, zero in equilibrium");
  claim(
      "as_by_virtual_work", 2627,
      "The condition is the book's (our reading, as that is not in the solutions: the equilibrium of the moments)",
      {"the one for which the moments on the level bar add up to zero", balancing_length},
      R"($h+\frac{mgr}{cs}$)", R"(the rest length $\ell$ that the condition asks for)");
}

}  // namespace

std::vector<Claim> claims(double seed) {
  Claims claims("3.23");
  Table table(claims);
  state(table, draw<Sample>(200, seed));
  return claims.in_order();
}

Provables proofs() {
  Claims claims("3.23");
  Table table(claims);
  state(table, {});
  const std::string by_one_root = "by_one_root q s h r";
  auto all = for_all<SampleOf>(by_one_root, "it holds for every bar at any angle",
                               {0.25, 0.5, 0.75, 1, 1.25, 1.5, 1.75, 2, 2.25, 2.5});
  all.given = positive({all.any.m, all.any.r, all.any.s, all.any.c, all.any.h});
  all.preamble = coq_source({"foot"});
  Provables proved = table.proofs("3.23", all);
  for (const char* potential : {"3.23-potential", "3.23-potential_of_gravity", "3.23-potential_of_spring"}) {
    Provable& proof = proof_of(proved, potential);
    proof.preamble = coq_source({"works"});
    for (Lemma& lemma : proof.lemmas) lemma.tactic = "by_works m r s c h g ell; " + by_one_root;
  }
  return proved;
}

}  // namespace oddity::ex03_23
