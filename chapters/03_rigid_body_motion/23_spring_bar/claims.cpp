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

  SampleOf() = default;
  explicit SampleOf(Random& random)
      : m(random.between(0.3, 3)),
        r(random.between(0.3, 3)),
        s(random.between(0.3, 3)),
        c(random.between(1, 30)),
        h(random.between(0.3, 3)),
        g(random.between(1, 10)),
        ell(random.between(0.3, 4)),
        q(random.between(-3, 3)),
        v(random.between(-3, 3)),
        a(random.between(-5, 5)) {}

  std::array<T*, 10> letters() { return {&m, &r, &s, &c, &h, &g, &ell, &q, &v, &a}; }
  TypesetIn<T> typeset() const {
    return {{"m", m},
            {"r", r},
            {"s", s},
            {"c", c},
            {"h", h},
            {"g", g},
            {R"(\ell)", ell},
            {R"(\theta)", q},
            {R"(\dot\theta)", v},
            {R"(\ddot\theta)", a},
            {R"(dV/d\theta)", derivative([bar = bar()](const auto& x) { return bar.potential(x); }, q)}};
  }
  std::string where() const {
    return R"($m,r,s,c,h,g,\ell$ = )" + format_significant(m, 4) + ", " + format_significant(r, 4) + ", " +
           format_significant(s, 4) + ", " + format_significant(c, 4) + ", " + format_significant(h, 4) +
           ", " + format_significant(g, 4) + ", " + format_significant(ell, 4) +
           R"(; $\theta,\dot\theta,\ddot\theta$ = )" + format_significant(q, 4) + ", " +
           format_significant(v, 4) + ", " + format_significant(a, 4);
  }

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
  table.formula(
      "potential_of_gravity", 2579, "The potential energy of gravity is $" + of_gravity + "$", samples,
      {.quantity = "the potential energy of gravity",
       .truth = {"the work done against the weight from the level, by quadrature",
                 []<class T>(const SampleOf<T>& x) { return x.work(&SampleOf<T>::moment_of_weight); }},
       .printed = "$" + of_gravity + "$"});
  table.formula(
      "potential_of_spring", 2583, "The potential energy of the spring is $" + of_spring + "$", samples,
      {.quantity = "the potential energy of the spring",
       .truth = {"the work done against the spring from the level, by quadrature",
                 []<class T>(const SampleOf<T>& x) { return x.work(&SampleOf<T>::moment_of_spring); }},
       .printed = "$" + of_spring + "$"});
  table.formula("potential", 2593, "The potential energy $V$ is the sum of the two", samples,
                {.quantity = "the potential energy",
                 .truth = {"the work done against both from the level, by quadrature",
                           []<class T>(const SampleOf<T>& x) {
                             return x.work(&SampleOf<T>::moment_of_weight) +
                                    x.work(&SampleOf<T>::moment_of_spring);
                           }},
                 .printed = "$" + of_gravity + "+" + of_spring + "$"});
  table.formula("kinetic_energy", 2597, R"(The kinetic energy is $T=\frac m2r^2\dot\theta^2$)", samples,
                {.quantity = "the kinetic energy",
                 .truth = {R"($\frac m2|\dot x|^2$, the velocity by dual numbers)",
                           [](const auto& x) {
                             const Dual q(x.q, x.v), along = x.r * cos(q), up = x.r * sin(q);
                             return x.m / 2 * (along.slope * along.slope + up.slope * up.slope);
                           }},
                 .printed = R"($\frac m2r^2\dot\theta^2$)",
                 .near_misses = {R"($\frac m6r^2\dot\theta^2$)"}});

  table.formula(
      "lagrangian", 2601, "The Lagrangian is $L=T-V$", samples,
      {.quantity = R"(the Lagrangian; it gives $mr^2\ddot\theta$)",
       .truth = {"the moments of the weight and of the spring", [](const auto& x) { return x.moments(x.q); }},
       .printed = {"by $L=T-V$", [](const auto& x) { return x.by_lagrange(x.q, x.v); }},
       .near_misses = {{"by $L=T+V$", [](const auto& x) { return x.by_lagrange(x.q, x.v, 1); }}}});
  const std::string lagrange =
      R"($\frac{d}{dt}\frac{\partial L}{\partial\dot\theta}-\frac{\partial L}{\partial\theta}$ by nested dual numbers)";
  table.formula("equation_in_V", 2613, R"(The equation of motion is $0=mr^2\ddot\theta+dV/d\theta$)", samples,
                {.quantity = "the right side of the equation of motion",
                 .truth = {lagrange, [](const auto& x) { return x.left_side(); }},
                 .printed = R"($mr^2\ddot\theta+dV/d\theta$)"});
  const auto written = [](const std::string& before_root, const std::string& after_root) {
    return R"(mr^2\ddot\theta+mgr\cos\theta+c\left(1-)" + before_root +
           R"(\sqrt{s^2(\cos\theta-1)^2+(h+s\sin\theta)^2})" + after_root +
           R"(\right)\left(s^2(1-\cos\theta)\sin\theta+s(h+s\sin\theta)\cos\theta\right)$)";
  };
  table.formula(
      "equation_of_motion", 2615, "The equation of motion is $0=" + written(R"(\ell)", ""), samples,
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
  table.formula(
      "equilibrium_terms", 2623,
      R"(The level bar is in equilibrium when all terms at $\theta=0$ but that in $\ddot\theta$ evaluate to )"
      R"(zero (our reading: their sum, which is $mgr+cs(h-\ell)$))",
      samples,
      {.quantity = R"(the condition of equilibrium has all terms at $\theta=0$ but the one in $\ddot\theta$)",
       .truth = {R"($-mr^2\ddot\theta$ of the level bar at rest, by Lagrange's equation)",
                 [](const auto& x) { return -x.by_lagrange(0, 0); }},
       .printed = condition});
  table.formula("equilibrium_condition", 2625, R"(The level bar is in equilibrium when $mgr+cs(h-\ell)=0$)",
                samples,
                {.quantity = "the moment on the level bar, zero in equilibrium",
                 .truth = {"the moments of the forces on the level bar, clockwise",
                           [](const auto& x) { return -x.moments(0); }},
                 .printed = condition});
  table.formula(
      "as_by_virtual_work", 2627,
      "The condition is the book's (our reading, as that is not in the solutions: the equilibrium of the moments)",
      samples,
      {.quantity = R"(the rest length $\ell$ that the condition asks for)",
       .truth = {"the one for which the moments on the level bar add up to zero", balancing_length},
       .printed = R"($h+\frac{mgr}{cs}$)"});
}

}  // namespace

std::vector<Claim> claims(double seed) {
  Claims claims("3.23");
  Table table(claims);
  state(table, draw<Sample>(200, seed));
  return claims.in_order();
}

/// All square roots are the spring's length, which is h for the level bar.
constexpr const char* by_one_root = R"(
  assert (circle : sin q * sin q = 1 - cos q * cos q) by (pose proof (sin2_cos2 q) as all; unfold Rsqr in all; lra);
  assert (far : 0 < (s * cos q - s) * (s * cos q - s) + (s * sin q + h) * (s * sin q + h))
    by (apply above_foot; assumption);
  assert (arm : r * r > 0) by nra;
  rewrite ?cos_0, ?sin_0;
  repeat (match goal with |- context [sqrt ?x] =>
    first [ let level := fresh in
            assert (level : sqrt x = h) by (replace x with (h * h) by ring; apply sqrt_square; lra);
            rewrite !level; clear level
          | match goal with |- context [sqrt ?y] =>
              assert_fails (constr_eq x y);
              let same := fresh in
              assert (same : sqrt y = sqrt x) by (f_equal; ring); rewrite !same; clear same end ] end);
  try (match goal with |- context [sqrt ?x] =>
    let d := fresh "d" in
    assert (sqrt x > 0) by (apply sqrt_lt_R0; nra); set (d := sqrt x) in *; clearbody d end);
  field [circle]; repeat split; apply Rgt_not_eq; nra)";

/// Tactic: the works of weight and spring, then `rest`.
std::string by_potentials(const std::string& rest) {
  return R"(
  assert (positive : forall t, 0 < (s * cos t - s) * (s * cos t - s) + (s * sin t + h) * (s * sin t + h))
    by (intro t; apply above_foot; assumption);
  assert (root : forall t, sqrt ((s * cos t - s) * (s * cos t - s) + (s * sin t + h) * (s * sin t + h)) <> 0)
    by (intro t; apply Rgt_not_eq, sqrt_lt_R0, positive);
  unfold Rminus in *;
  try integrate (fun t => - m * g * r * sin t);
  try integrate (fun t => - c / 2 *
    ((sqrt ((s * cos t + - s) * (s * cos t + - s) + (s * sin t + h) * (s * sin t + h)) + - ell) *
     (sqrt ((s * cos t + - s) * (s * cos t + - s) + (s * sin t + h) * (s * sin t + h)) + - ell)));)" +
         rest;
}

Provables proofs() {
  Claims claims("3.23");
  Table table(claims);
  state(table, {});
  const std::vector<std::string> names{"m", "r", "s", "c", "h", "g", "ell", "q", "v", "a"};
  ForAll<SampleOf> all{.any = lettered<SampleOf>(names),
                       .letters = quantified(names),
                       .tactic = by_one_root,
                       .says = "it holds for every bar at any angle"};
  for (const Shortened& positive : {all.any.m, all.any.r, all.any.s, all.any.c, all.any.h})
    all.given.push_back(above(positive.expression(), 0));
  double x = 0;
  for (double* letter : all.example.letters()) *letter = x += 0.25;
  Provables proved = table.proofs("3.23", all);
  for (Provable& claim : proved) {
    claim.preamble = coq_source({"foot"});
    if (!claim.claim.starts_with("3.23-potential")) continue;
    claim.preamble = coq_source({"integrals", "foot"});
    for (Lemma& lemma : claim.lemmas) lemma.tactic = by_potentials(lemma.tactic);
  }
  return proved;
}

}  // namespace oddity::ex03_23

namespace oddity {

Provables proofs_3_23() { return ex03_23::proofs(); }

}  // namespace oddity
