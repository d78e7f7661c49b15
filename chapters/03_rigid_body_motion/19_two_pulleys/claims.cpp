#include "chapters/provable_claims.hpp"

#include <Eigen/Core>

#include "chapters/03_rigid_body_motion/19_two_pulleys/two_pulleys.hpp"
#include "chapters/03_rigid_body_motion/shared/lagrange.hpp"
#include "reference/text.hpp"
#include "solvers/linear.hpp"

namespace oddity::ex03_19 {

using std::max, std::min;

inline Shortened of_two(const char* function, const Shortened& a, const Shortened& b) {
  return Expression::letter("(" + std::string(function) + " (" + a.expression().coq() + ") (" +
                            b.expression().coq() + "))");
}
inline Shortened max(const Shortened& a, const Shortened& b) { return of_two("Rmax", a, b); }
inline Shortened min(const Shortened& a, const Shortened& b) { return of_two("Rmin", a, b); }

/// Any two pulleys in any motion, hung between a ceiling and a floor at depth `floor`; y1 is the large one's.
template <class T>
struct SampleOf {
  two_pulleys::Given<T> p;
  Two<T> q, v, a;
  T floor, y1, delta;

  SampleOf() = default;
  explicit SampleOf(Random& random) {
    const auto size = [&] { return random.between(0.3, 3); };
    const auto any = [&] { return random.magnitude(0.1, 2); };
    p = {size(), size(), size(), size(), size(), size(), size(), size(), size(),
         size(), any(),  any(),  size(), any(),  any(),  any(),  any()};
    q = {p.y2, p.y3};
    v = {p.v2, p.v3};
    a = {any(), any()};
    floor = random.between(4, 8);
    y1 = random.between(0.1, 1);
    delta = any();
  }
  std::array<T*, 22> letters() {
    return {&p.m2, &p.m3, &p.I1, &p.I2, &p.R1, &p.R2, &p.c1, &p.c2, &p.L1,  &p.L2, &p.K1,
            &p.K2, &p.g,  &q[0], &q[1], &v[0], &v[1], &a[0], &a[1], &floor, &y1,   &delta};
  }
  /// The terms of lengths, energies and forces, added up, the accelerations being the forces over a mass.
  double size() const {
    const double mass = p.m2 + p.m3 + p.inertia_over_square_1() + 2 * p.inertia_over_square_2(),
                 speed = abs(v[0]) + abs(v[1]);
    const double pulls = (p.m2 + p.m3) * p.g + p.c1 * (abs(p.K1) + p.L1 + abs(q[0])) +
                         2 * p.c2 * (abs(p.K2) + p.L2 + abs(q[1]) + 2 * abs(q[0]));
    return floor + mass * (speed * speed + abs(a[0]) + abs(a[1])) + pulls * (1 + mass / std::min(p.m2, p.m3));
  }
  TypesetLetters typeset() const {
    const Two<T> s = springs(q), slopes = df_dq(lagrangian(), q, v);
    return {{"m_2", p.m2},
            {"m_3", p.m3},
            {"I_1", p.I1},
            {"I_2", p.I2},
            {"R_1", p.R1},
            {"R_2", p.R2},
            {"c_1", p.c1},
            {"c_2", p.c2},
            {"L_1", p.L1},
            {"L_2", p.L2},
            {"K_1", p.K1},
            {"K_2", p.K2},
            {"g", p.g},
            {"y_2", q[0]},
            {"y_3", q[1]},
            {R"(\dot y_2)", v[0]},
            {R"(\dot y_3)", v[1]},
            {R"(\ddot y_2)", a[0]},
            {R"(\ddot y_3)", a[1]},
            {"S_1", s[0]},
            {"S_2", s[1]},
            {R"(\Delta)", delta},
            {R"(\Delta_2)", v[0]},
            {R"(\Delta_3)", v[1]},
            {R"(\partial L/\partial y_2)", slopes[0]},
            {R"(\partial L/\partial y_3)", slopes[1]}};
  }
  std::string where() const { return told(typeset(), 15); }

  /// The springs between floor and rope, from the ropes' lengths alone.
  template <class X>
  Two<X> springs(const Two<X>& y) const {
    const T rope1 = floor - 2 * y1 - p.K1, rope2 = floor - p.K2;
    return {(floor - y1) - (rope1 - (y[0] - y1)), (floor - y[0]) - (rope2 - (y[1] - y[0]))};
  }
  /// What the ropes grow by, less what stays of them over the pulleys, their springs given by y - K.
  Two<T> ropes_after(const T& down2, const T& down3) const {
    const auto lengths = [&](const T& d2, const T& d3) {
      const T S1 = q[0] + d2 + p.K1, S2 = q[1] + d3 - 2 * (q[0] + d2) + p.K2;
      return Two<T>{(floor - y1 - S1) + (q[0] + d2 - y1), (floor - S2 - q[0] - d2) + (q[1] + d3 - q[0] - d2)};
    };
    const Two<T> before = lengths(0, 0), after = lengths(down2, down3);
    return {after[0] - before[0], after[1] - before[1]};
  }
  Two<T> springs_after(const T& down2, const T& down3) const {
    const Two<T> before = springs(q), after = springs(Two<T>{q[0] + down2, q[1] + down3});
    return {after[0] - before[0], after[1] - before[1]};
  }
  /// Rope that runs over each pulley's rim toward the far side, seen on the spring's side.
  Two<T> rim_speeds() const {
    const auto s = springs(moving(q, v));
    return {s[0].slope, s[1].slope + v[0]};
  }
  /// The same with a first spring whose length at rest is less than its length, or more.
  SampleOf stretched(double by = 1) const {
    SampleOf other = *this;
    other.p.L1 = springs(q)[0] - by * abs(delta);
    return other;
  }
  /// T from the ropes' lengths alone: the pulleys turn as the rope on the springs' side runs.
  auto kinetic() const {
    return [*this]<class X>(const Two<X>& y, const Two<X>& dy) {
      const auto s = springs(Two<Dual<X>>{Dual<X>(y[0], dy[0]), Dual<X>(y[1], dy[1])});
      const X w1 = s[0].slope / p.R1, w2 = (s[1].slope + dy[0]) / p.R2;
      return 0.5 * (p.m2 * dy[0] * dy[0] + p.m3 * dy[1] * dy[1] + p.I1 * w1 * w1 + p.I2 * w2 * w2);
    };
  }
  /// T of the models.
  auto model() const {
    return [p = p](const auto&, const auto& dy) { return p.kinetic_energy(dy); };
  }
  auto lagrangian() const {
    return [p = p](const auto& y, const auto& dy) { return p.kinetic_energy(dy) - p.potential_energy(y); };
  }
  /// Generalized, from the potential energy.
  Two<T> forces() const {
    return df_dq([&](const auto& y, const auto&) { return -p.potential_energy(y); }, q, v);
  }
  Two<T> by_lagrange() const { return lagrange_accelerations(lagrangian(), q, v); }
  Two<T> by_tensions() const {
    const two_pulleys::FourCoordinates<T> pulleys{p};
    typename two_pulleys::FourCoordinates<T>::State rate,
        x{q[0], q[1], q[0] / p.R1, (q[1] - q[0]) / p.R2, v[0], v[1], T(0), T(0)};
    pulleys(x, rate, T(0));
    return {rate[4], rate[5]};
  }
  T pull1() const { return p.c1 * (p.K1 - p.L1 + q[0]); }
  T pull2() const { return p.c2 * (p.K2 - p.L2 + q[1] - 2 * q[0]); }
};
namespace {

using Sample = SampleOf<double>;
using S = const Sample&;
using Samples = std::vector<Sample>;
using Table = ProvableClaims<SampleOf>;

// ---- the ropes --------------------------------------------------------------------------------------------

/// What the ropes and springs grow by when y2 and y3 grow by multiples of Delta; the text has it `by` Delta.
struct Move {
  std::size_t rope;
  double down2, down3, by;

  Formula<Sample> spring() const {
    return {"the spring, from the rope's length",
            [*this](S s) { return s.springs_after(down2 * s.delta, down3 * s.delta)[rope]; }};
  }
  Formula<Sample> wire() const {
    return {"the rope, summed over its straight parts",
            [*this](S s) { return s.ropes_after(down2 * s.delta, down3 * s.delta)[rope]; }};
  }
  Formula<Sample> told(double factor = 1) const {
    return {factor < 0 ? R"(the text's, by $-\Delta$)" : R"(the text's, by $\Delta$)",
            [=, by = by](S s) { return factor * by * s.delta; }};
  }
};

/// Where the text has a string stretched or compressed it is the spring that is: its rope keeps its length.
Claim string_for_spring(const Samples& samples, const Move& move, const std::array<std::string, 3>& readings,
                        std::string why) {
  const auto spring = [&](double factor) {
    return compare("change of the spring's length", move.told(factor), move.spring(), samples);
  };
  return {
      .printed = {readings[0], {compare("change of the string's length", move.told(), move.wire(), samples)}},
      .meant = {readings[1], {spring(1)}},
      .near_misses = {{readings[2], {spring(-1)}}},
      .why = std::move(why),
      .kind = Fault::term};
}

void kinematics(Claims& claims, Table& table, const Samples& samples) {
  table.formula("rolling", 2437,
                R"($R_1\dot\theta_1=\dot y_2-\dot y_1=\dot y_2$ and $R_2\dot\theta_2=\dot y_3-\dot y_2$)",
                samples,
                {.quantity = "the speeds of the rims",
                 .truth = {"the rope that runs over the rims, from the ropes' lengths on the springs' side",
                           [](const auto& s) { return s.rim_speeds(); }},
                 .printed = {R"($(\dot y_2,\ \dot y_3-\dot y_2)$)",
                             [](const auto& s) { return values(s.v[0], s.v[1] - s.v[0]); }},
                 .near_misses = {{R"($(\dot y_2,\ \dot y_3-2\dot y_2)$)",
                                  [](const auto& s) { return values(s.v[0], s.v[1] - 2 * s.v[0]); }},
                                 {R"($(\dot y_2,\ \dot y_3)$)", [](const auto& s) { return s.v; }}}});
  const auto freedoms = [](const std::string& text, int count, bool fixed) -> Reading {
    Eigen::MatrixXd ties(fixed ? 5 : 4, 7);  // of y1, y2, y3, S1, S2, theta1, theta2; R1 = 2, R2 = 3
    ties.topRows(4) << -2, 1, 0, -1, 0, 0, 0, /**/ 0, 2, -1, 0, 1, 0, 0, /**/ 1, -1, 0, 0, 0, 2, 0, /**/ 0, 1,
        -1, 0, 0, 0, 3;
    if (fixed) ties.row(4) << 1, 0, 0, 0, 0, 0, 0;
    return {text,
            {{"degrees of freedom",
              {"as stated", count},
              {"7 coordinates less the rank of their ties", 7 - rank(ties)},
              exact()}}};
  };
  claims.add("two_freedoms", 2439, "the system has two degrees of freedom, since $y_1$ is fixed",
             {.printed = freedoms("2", 2, true),
              .near_misses = {freedoms("3", 3, true), freedoms("2 with $y_1$ free", 2, false)}});

  const auto by_delta = [](double factor) { return [=](const auto& s) { return factor * s.delta; }; };
  table.formula(
      "length_1", 2521, "$S_1-y_2$ is constant", samples,
      {.quantity = R"(what $S_1$ grows by when $y_2$ grows by $\Delta$)",
       .truth = {"by the first rope's length", [](const auto& s) { return s.springs_after(s.delta, 0)[0]; }},
       .printed = {R"($\Delta$)", by_delta(1)},
       .near_misses = {{R"($-\Delta$, with $S_1+y_2$ constant)", by_delta(-1)}}});
  const auto second = [](double twice) { return [=](const auto& s) { return s.v[1] - twice * s.v[0]; }; };
  table.formula("length_2", 2529, "$S_2-y_3+2y_2$ is constant", samples,
                {.quantity = R"(what $S_2$ grows by when $y_2$ and $y_3$ grow by $\Delta_2$ and $\Delta_3$)",
                 .truth = {"by the second rope's length",
                           [](const auto& s) { return s.springs_after(s.v[0], s.v[1])[1]; }},
                 .printed = {R"($\Delta_3-2\Delta_2$)", second(2)},
                 .near_misses = {{R"($\Delta_3-\Delta_2$, with $S_2-y_3+y_2$ constant)", second(1)}}});
  table.formula(
      "mass_down", 2531, "with $y_2$ fixed, the second spring grows by what the mass goes down", samples,
      {.quantity = R"(what $S_2$ grows by when $y_3$ grows by $\Delta$)",
       .truth = {"by the second rope's length", [](const auto& s) { return s.springs_after(0, s.delta)[1]; }},
       .printed = {R"($\Delta$)", by_delta(1)},
       .near_misses = {{R"($2\Delta$)", by_delta(2)}}});
  table.formula("pulley_down", 2535,
                R"($S_2-\Delta$, $y_3+\Delta$ and $y_2+\Delta$ together keep the second rope's length)",
                samples,
                {.quantity = R"(what $S_2$ grows by when $y_2$ and $y_3$ grow by $\Delta$)",
                 .truth = {"by the second rope's length",
                           [](const auto& s) { return s.springs_after(s.delta, s.delta)[1]; }},
                 .printed = {R"($-\Delta$)", by_delta(-1)},
                 .near_misses = {{R"($\Delta$)", by_delta(1)}}});
  claims.add(
      "string_stretched", 2521, "when the small pulley goes down the string is stretched",
      string_for_spring(
          samples, {0, 1, 0, 1},
          {"the string over the large pulley gets longer", "the first spring gets longer",
           "the first spring gets shorter"},
          R"(The string is the wire, whose length the same paragraph calls constant; what gets longer )"
          R"(is the spring. The letter is right: $S_1$ is the spring's length, and grows by $\Delta$ )"
          R"(while the wire's change is 0. Line 2529 has the same word for the second spring.)"));
  claims.add(
      "must_compress", 2533,
      R"(when the small pulley and the mass both go down by $\Delta$ the string must be compressed)",
      string_for_spring(
          samples, {1, 1, 1, -1},
          {"the string over the small pulley gets shorter", R"(the second spring gets shorter by $\Delta$)",
           R"(the second spring gets longer by $\Delta$)"},
          R"(Again it is the spring, not the string, that gives way: $S_2$ becomes $S_2-\Delta$ and the )"
          R"(wire's length changes by 0. How much depends on the mass, for $y_2$ and $y_3$ are independent: )"
          R"(with $y_3$ fixed the spring shortens by $2\Delta$, and with $y_3\to y_3+3\Delta$ it gets longer )"
          R"(by $\Delta$. The text's example is the case in which the small pulley does not turn.)"));
}

// ---- the energies -----------------------------------------------------------------------------------------

void energies(Table& table, const Samples& samples) {
  const std::string dual = "dual numbers", nested = "nested dual numbers";
  const auto T = [](int first, int second, double sign = -1) {  // the pulleys' moments over R^2, by 1/2
    return [=](const auto& s) {
      const auto d = s.v[1] + sign * s.v[0], R1 = s.p.R1 * s.p.R1, R2 = s.p.R2 * s.p.R2;
      return s.p.m2 / 2 * s.v[0] * s.v[0] + s.p.I1 * pow(R1, first) * pow(2, first) * s.v[0] * s.v[0] +
             s.p.m3 / 2 * s.v[1] * s.v[1] + s.p.I2 * pow(R2, second) * pow(2, second) * d * d;
    };
  };
  table.formula(
      "kinetic_energy", 2443,
      R"(the kinetic energy is $\frac{m_2}2\dot y_2^2+I_1\,2R_1^2\,\dot y_2^2+\frac{m_3}2\dot y_3^2)"
      R"(+I_2\,2R_2^2\,(\dot y_3-\dot y_2)^2$)",
      samples,
      {.quantity = "the kinetic energy",
       .truth = {"that of the masses by their speeds, of the pulleys by the speeds of their rims",
                 [](const auto& s) {
                   const auto rim = s.rim_speeds();
                   const auto w1 = rim[0] / s.p.R1, w2 = rim[1] / s.p.R2;
                   return (s.p.m2 * s.v[0] * s.v[0] + s.p.m3 * s.v[1] * s.v[1] + s.p.I1 * w1 * w1 +
                           s.p.I2 * w2 * w2) /
                          2;
                 }},
       .printed = {"$I_1\\,2R_1^2$ and $I_2\\,2R_2^2$, as products", T(1, 1)},
       .meant = {"$I_1/(2R_1^2)$ and $I_2/(2R_2^2)$", T(-1, -1)},
       .near_misses = {{R"(the quotients with $(\dot y_3+\dot y_2)^2$)", T(-1, -1, 1)}},
       .kind = Fault::lost_typography,
       .why =
           R"(The fraction bars of the pulleys' terms are lost in the text at hand: $I_1/(2R_1^2)$ and )"
           R"($I_2/(2R_2^2)$, and before them $I_1/2$ and $I_2/2$. The default pulleys have 1 kg and 0.5 kg )"
           R"(there, and the products are 0.25 and 0.125.)"});
  table.formula("dT_dy", 2475, "the kinetic energy depends on neither $y_2$ nor $y_3$", samples,
                {.quantity = R"($(\partial T/\partial y_2,\ \partial T/\partial y_3)$)",
                 .truth = {"zero", [](const auto&) { return values(0, 0); }},
                 .printed = {dual + ", the pulleys turned by the ropes",
                             [](const auto& s) { return df_dq(s.kinetic(), s.q, s.v); }},
                 .near_misses = {{R"($(\partial L/\partial y_2,\ \partial L/\partial y_3)$)",
                                  [](const auto& s) { return df_dq(s.lagrangian(), s.q, s.v); }}}});

  // with the pulleys' moments times these powers of R^2
  const auto momenta = [](const auto& s, const auto& v, double sign, int first = -1, int second = -1) {
    const auto R1 = s.p.R1 * s.p.R1, R2 = s.p.R2 * s.p.R2;
    return values(
        s.p.m2 * v[0] + s.p.I1 * pow(R1, first) * v[0] + s.p.inertia_over_square_2() * (v[0] - v[1]),
        s.p.m3 * v[1] + s.p.I2 * pow(R2, second) * (v[1] - sign * v[0]));
  };
  table.formula(
      "dT_dydot", 2483,
      R"(the derivatives of $T$ by the speeds are $m_2\dot y_2+I_1R_1^2\dot y_2+(I_2/R_2^2)(\dot y_2-\dot y_3)$ )"
      R"(and $m_3\dot y_3+I_2R_2^2(\dot y_3-\dot y_2)$)",
      samples,
      {.quantity = R"($(\partial T/\partial\dot y_2,\ \partial T/\partial\dot y_3)$)",
       .truth = {dual, [](const auto& s) { return df_dv(s.model(), s.q, s.v); }},
       .printed = {"$I_1R_1^2$ and $I_2R_2^2$, as products",
                   [=](const auto& s) { return momenta(s, s.v, 1, 1, 1); }},
       .meant = {"$I_1/R_1^2$ and $I_2/R_2^2$", [=](const auto& s) { return momenta(s, s.v, 1); }},
       .near_misses = {{R"(the quotients with $\dot y_3+\dot y_2$)",
                        [=](const auto& s) { return momenta(s, s.v, -1); }}},
       .kind = Fault::lost_typography,
       .why =
           R"(The bars of $I_1/R_1^2$ in the first and of $I_2/R_2^2$ in the second derivative are lost in )"
           R"(the text at hand; the third one of the three is there. A pulley of a tenth of the radius )"
           R"(would turn a hundred times more easily, where its rim is a hundred times harder to move.)"});
  table.formula("momentum_rates", 2497, "the time derivatives of these", samples,
                {.truth = {nested, [](const auto& s) { return rate_of_df_dv(s.model(), s.q, s.v, s.a); }},
                 .printed = {R"(the same in $\ddot y_2$ and $\ddot y_3$)",
                             [=](const auto& s) { return momenta(s, s.a, 1); }},
                 .near_misses = {
                     {R"(with $\ddot y_3+\ddot y_2$)", [=](const auto& s) { return momenta(s, s.a, -1); }}}});
}

// ---- the forces -------------------------------------------------------------------------------------------

/// What m2 g - c1 (K1 - L1 + y2) has of the second spring's pull.
auto with_second_spring(double lever) {
  return [=](const auto& s) { return s.p.m2 * s.p.g - s.pull1() + lever * s.pull2(); };
}

/// A rope pulls or hangs slack: its tension and its slack are not negative, and one of them is zero. `of` has
/// the tension by the spring's pull.
template <class T, class Tension>
auto negative_or_both(const SampleOf<T>& s, const Tension& of) {
  const SampleOf<T> pressed = s.stretched(-1);
  const T S1 = pressed.springs(s.q)[0], L1 = pressed.p.L1, tension = of(T(s.p.c1 * (S1 - L1))),
          slack = L1 + tension / s.p.c1 - S1;
  return values(min(tension, T(0)), min(slack, T(0)), tension * slack);
}

void compression(Table& table, const Samples& samples) {
  const auto tension = [](const auto& of) { return [=](const auto& s) { return negative_or_both(s, of); }; };
  table.formula(
      "compression", 2517,
      "the force on the small pulley is $m_2g-c_1(S_1-L_1)$ also in compression, when $S_1<L_1$", samples,
      {.quantity = "negative tension of the rope, negative slack, and their product",
       .truth = {"zero", [](const auto&) { return values(0, 0, 0); }},
       .printed = {"the rope's tension is $c_1(S_1-L_1)$", tension([](const auto& pull) { return pull; })},
       .corrected = {"the rope's tension is $c_1(S_1-L_1)$, and 0 where that is negative",
                     tension([]<class T>(const T& pull) { return max(pull, T(0)); })},
       .near_misses = {{"the rope's tension is $c_1|S_1-L_1|$",
                        tension([](const auto& pull) { return abs(pull); })}},
       .kind = Fault::left_out,
       .root = "a rope that pushes",
       .why =
           R"(Between spring and pulley is a wire, and a wire cannot push: where $S_1<L_1$ it hangs slack )"
           R"(and the force is $m_2g$ alone; the same holds for $S_2<L_2$. With $K_1=-0.5$ m the default )"
           R"(pulley starts at $S_1=0.5$ m, pushed down with 20 N that are not there. The equations are )"
           R"(valid as long as both wires are taut; in the default motion they are, its springs being )"
           R"(stretched by at least 0.94 m and 0.18 m.)"});
}

void forces(Table& table, const Samples& samples) {
  const std::string second = "c_2(K_2-L_2+y_3-2y_2)", forgotten = "the second spring on the pulley";
  const std::string first = "$m_2g-c_1(K_1-L_1+y_2)$";

  const auto pull = [](double sign) {
    return [=](const auto& s) {
      const auto stretched = s.stretched();
      return -sign * s.p.c1 * (stretched.springs(s.q)[0] - stretched.p.L1);
    };
  };
  table.formula(
      "stretched", 2517, "$S_1>L_1$ is stretching: the first spring then pulls the small pulley up", samples,
      {.quantity = "the first spring's part of the force on the small pulley",
       .truth = {R"(what $-\partial V/\partial y_2$ has for $c_1$ and not for $c_1=0$, by dual numbers)",
                 [](const auto& s) {
                   auto stretched = s.stretched(), free = stretched;
                   free.p.c1 = 0;
                   return stretched.forces()[0] - free.forces()[0];
                 },
                 &Sample::size},
       .printed = {"a pull of $-c_1(S_1-L_1)$", pull(1)},
       .near_misses = {{"a pull of $+c_1(S_1-L_1)$", pull(-1)}}});
  table.formula(
      "force_on_pulley", 2517, "gravity and the first spring are all that acts on the small pulley", samples,
      {.quantity = "the force on the small pulley",
       .truth = {R"($m_2\ddot y_2$ by Lagrange's equations)",
                 [](const auto& s) { return s.p.m2 * s.by_lagrange()[0]; }, &Sample::size},
       .printed = {first, with_second_spring(0)},
       .corrected = {"$m_2g$ less the upper rope's tension, plus those of the lower rope's two sides",
                     [](const auto& s) {
                       const auto a = s.by_tensions();
                       return s.p.m2 * s.p.g - (s.pull1() + s.p.inertia_over_square_1() * a[0]) + s.pull2() +
                              (s.pull2() + s.p.inertia_over_square_2() * (a[1] - a[0]));
                     }},
       .near_misses = {{first + ", plus $2" + second + "$", with_second_spring(2)}},
       .kind = Fault::counterexample,
       .root = forgotten,
       .why =
           R"(There are four forces: gravity, the upper rope's tension, which is $c_1(S_1-L_1)$ only if the )"
           R"(large pulley has no inertia, and the lower rope on both sides of the small pulley.)"});
  const auto on_mass = [](double sign) {
    return [=](const auto& s) {
      const auto a = s.by_tensions();
      return s.p.m3 * s.p.g - s.pull2() + sign * s.p.inertia_over_square_2() * (a[1] - a[0]);
    };
  };
  table.formula(
      "force_on_mass", 2525, "gravity and the second spring's pull are the force on the mass", samples,
      {.quantity = "the force on the mass",
       .truth = {R"($m_3\ddot y_3$ by Lagrange's equations)",
                 [](const auto& s) { return s.p.m3 * s.by_lagrange()[1]; }, &Sample::size},
       .printed = {"$m_3g-c_2(S_2-L_2)$", on_mass(0)},
       .corrected =
           {R"($m_3g-c_2(S_2-L_2)-(I_2/R_2^2)(\ddot y_3-\ddot y_2)$, the accelerations those of its motion)",
            on_mass(-1)},
       .near_misses =
           {{R"($m_3g-c_2(S_2-L_2)+(I_2/R_2^2)(\ddot y_3-\ddot y_2)$, the accelerations those of its motion)",
             on_mass(1)}},
       .kind = Fault::left_out,
       .root = "the small pulley's inertia",
       .why = R"(The pulley between spring and mass has inertia: the rope pulls the mass with )"
              R"($c_2(S_2-L_2)+(I_2/R_2^2)(\ddot y_3-\ddot y_2)$, at the default start with 21.7 N for the )"
              R"(30 N of the spring. What the formula does give is the generalized force on $y_3$, and the )"
              R"(equation of motion that uses it as such is right.)"});

  table.formula(
      "force_y2", 2541, "the generalized force on $y_2$", samples,
      {.truth = {R"($-\partial V/\partial y_2$ by dual numbers)",
                 [](const auto& s) { return s.forces()[0]; }},
       .printed = {first, with_second_spring(0)},
       .corrected = {first + ", plus $2" + second + "$", with_second_spring(2)},
       .near_misses = {{first + ", plus $" + second + "$", with_second_spring(1)},
                       {first + ", less $2" + second + "$", with_second_spring(-2)}},
       .kind = Fault::formula,
       .root = forgotten,
       .why =
           R"(When $y_2$ grows by $\Delta$ at fixed $y_3$, the second spring shortens by $2\Delta$ and does )"
           R"(the work $2c_2(S_2-L_2)\Delta$: its rope pulls the small pulley down on both sides. At rest )"
           R"(the first spring must carry $(m_2+2m_3)g$; as published it carries $m_2g$ alone, 9.81 N for )"
           R"(49.05 N with the default masses.)"});
  const auto on_y3 = [](double sign) {
    return [=](const auto& s) { return s.p.m3 * s.p.g - sign * s.pull2(); };
  };
  table.formula("force_y3", 2543, "the generalized force on $y_3$", samples,
                {.truth = {R"($-\partial V/\partial y_3$ by dual numbers)",
                           [](const auto& s) { return s.forces()[1]; }},
                 .printed = {"$m_3g-" + second + "$", on_y3(1)},
                 .near_misses = {{"$m_3g+" + second + "$", on_y3(-1)}}});
}

// ---- the equations ----------------------------------------------------------------------------------------

void equations(Table& table, const Samples& samples) {
  const std::string two_routes = R"($\ddot y$ once by Lagrange's equations and once by the ropes' tensions)";
  const auto twice = [](const auto& of) {
    return [=](const auto& s) { return values(of(s, s.by_lagrange()), of(s, s.by_tensions())); };
  };
  const auto first = [=](double lever) {
    return twice([=](const auto& s, const auto& a) {
      return s.p.m2 * a[0] + s.p.inertia_over_square_1() * a[0] +
             s.p.inertia_over_square_2() * (a[0] - a[1]) - lever * s.pull2();
    });
  };
  table.formula(
      "equation_y2", 2547,
      R"($m_2\ddot y_2+(I_1/R_1^2)\ddot y_2+(I_2/R_2^2)(\ddot y_2-\ddot y_3)=m_2g-c_1(K_1-L_1+y_2)$, the bar )"
      R"(of $I_1/R_1^2$ restored)",
      samples,
      {.quantity = "the equation's left side less the second spring's part, " + two_routes,
       .truth = {"the right side's $m_2g-c_1(K_1-L_1+y_2)$, for both",
                 [](const auto& s) {
                   const auto right = s.p.m2 * s.p.g - s.pull1();
                   return values(right, right);
                 }},
       .printed = {"no part of the second spring", first(0)},
       .corrected = {"$2c_2(K_2-L_2+y_3-2y_2)$ added on the right", first(2)},
       .near_misses = {{"$c_2(K_2-L_2+y_3-2y_2)$ added on the right", first(1)},
                       {"$2c_2(K_2-L_2+y_3-2y_2)$ subtracted on the right", first(-2)}},
       .kind = Fault::formula,
       .root = "the second spring on the pulley",
       .why =
           R"(The term $+2c_2(K_2-L_2+y_3-2y_2)$ is missing. Without it energy is not conserved, and the )"
           R"(rest position is not even stable: with the default values the two frequencies are )"
           R"($3.05\pm1.06\,i$ per second, and the motion grows more than a thousandfold in eight seconds. )"
           R"(With the term they are 1.63 and 6.40 per second.)"});
  const auto second = [=](int power, double sign = 1) {
    return twice([=](const auto& s, const auto& a) {
      return s.p.m3 * a[1] + s.p.I2 * pow(s.p.R2 * s.p.R2, power) * (a[1] - a[0]) + s.pull2() -
             sign * s.p.m3 * s.p.g;
    });
  };
  table.formula(
      "equation_y3", 2553, R"($m_3\ddot y_3+I_2R_2^2(\ddot y_3-\ddot y_2)=m_3g-c_2(K_2-L_2+y_3-2y_2)$)",
      samples,
      {.quantity = "the equation's left side less its right side, " + two_routes,
       .truth = {"zero", [](const auto&) { return values(0, 0); }},
       .printed = {"$I_2R_2^2$, a product", second(1)},
       .meant = {"with $I_2/R_2^2$", second(-1)},
       .near_misses = {{"$I_2/R_2^2$ with $-m_3g$", second(-1, -1)}},
       .kind = Fault::lost_typography,
       .why =
           R"(The bar of $I_2/R_2^2$ is lost in the text at hand; line 2511, from which the term is taken, )"
           R"(has it. The default pulley would weigh in with 0.0625 kg at its rim for 1 kg.)"});
}

void state(Claims& claims, Table& table, const Samples& samples) {
  kinematics(claims, table, samples);
  energies(table, samples);
  forces(table, samples);
  equations(table, samples);
  compression(table, samples);
}

}  // namespace

std::vector<Claim> claims(double seed) {
  Claims claims("3.19");
  Table table(claims);
  state(claims, table, draw<Sample>(200, seed));
  return claims.in_order();
}

constexpr const char* by_tension = R"(
  pose proof (Rabs_pos delta) as size;
  set (S := depth - y1 - (depth - 2 * y1 - K1 - (y2 - y1))) in *; clearbody S;
  assert (pull : c1 * (S - (S - - 1 * Rabs delta)) <= 0) by nra;
  rewrite (Rmax_right _ _ pull); unfold Rdiv; rewrite ?Rmult_0_l, ?Rplus_0_r;
  try reflexivity; unfold Rmin; destruct (Rle_dec _ _); lra)";
constexpr const char* by_pull = "unfold Rmin; destruct (Rle_dec _ _) as [|N]; [|destruct N]; interval";

Provable proof_of_compression(ForAll<SampleOf> all) {
  Claims claims("3.19");
  Table table(claims);
  compression(table, {});
  all.given.push_back(above(all.any.p.c1.expression(), 0));
  all.tactic = by_tension;
  Provable proved = table.proofs("3.19", all)[0];
  for (Lemma& lemma : proved.lemmas)
    if (lemma.tactic == "interval") lemma.tactic = by_pull;
  return proved;
}

Provables proofs() {
  Claims claims("3.19");
  Table table(claims);
  state(claims, table, {});
  const std::vector<std::string> names{"m2", "m3", "I1", "I2",    "R1", "R2",   "c1", "c2",
                                       "L1", "L2", "K1", "K2",    "g",  "y2",   "y3", "v2",
                                       "v3", "a2", "a3", "depth", "y1", "delta"};
  ForAll<SampleOf> all{.any = lettered<SampleOf>(names),
                       .letters = quantified(names),
                       .tactic = std::string("field; repeat split; ") + by_positive_terms,
                       .says = "it holds for all pulleys in any motion"};
  for (const Shortened& positive :
       {all.any.p.m2, all.any.p.m3, all.any.p.I1, all.any.p.I2, all.any.p.R1, all.any.p.R2})
    all.given.push_back(above(positive.expression(), 0));
  double x = 0.25;
  for (double* letter : all.example.letters()) *letter = x += 0.25;
  const Provable slack = proof_of_compression(all);
  all.without = {"compression"};
  Provables proved = table.proofs("3.19", all);
  const std::string energy = all.any.kinetic()(all.any.q, all.any.v).expression().coq();
  std::vector<Proposition> none;
  for (const char* y : {"y2", "y3"})
    none.push_back({"derivable_pt_lim (fun " + std::string(y) + " => " + energy + ") " + y + " 0"});
  proved.push_back(slack);
  proved.push_back({"3.19-dT_dy",
                    "it holds for all pulleys in any motion",
                    {{"printed", all.letters, {}, none, "apply derivable_pt_lim_const"}}});
  return proved;
}

std::vector<Root> roots() {
  return {
      {"the second spring on the pulley",
       "By the published equations the small pulley of the default start is 0.93 m above the ceiling "
       "after one second, where it should hang 0.97 m below it."},
      {"the small pulley's inertia",
       "A rope that breaks at 25 N holds the default mass at the start, as its tension is 21.7 N; by the "
       "published formula it is 30 N, and the mass falls."},
      {"a rope that pushes",
       "Started with 0.5 m of slack ($K_1=-0.5$ m), the small pulley is pushed by its rope, and 11 cm too "
       "deep after a quarter of a second."}};
}

}  // namespace oddity::ex03_19

namespace oddity {

Provables proofs_3_19() { return ex03_19::proofs(); }

}  // namespace oddity
