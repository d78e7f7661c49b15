#include "chapters/provable_claims.hpp"

#include <Eigen/Core>

#include "chapters/03_rigid_body_motion/19_two_pulleys/two_pulleys.hpp"
#include "chapters/03_rigid_body_motion/shared/lagrange.hpp"
#include "reference/text.hpp"
#include "solvers/linear.hpp"
#include "solvers/ode/algorithms.hpp"
#include "solvers/ode/integrate.hpp"

namespace oddity::ex03_19 {

using std::max, std::min;

inline Shortened of_two(const char* function, const Shortened& a, const Shortened& b) {
  return Expression::letter("(" + std::string(function) + " (" + a.expression().coq() + ") (" +
                            b.expression().coq() + "))");
}
inline Shortened max(const Shortened& a, const Shortened& b) { return of_two("Rmax", a, b); }
inline Shortened min(const Shortened& a, const Shortened& b) { return of_two("Rmin", a, b); }

/// Two random pulleys in motion, between a ceiling and a floor at depth `floor`; y1 is the depth of the large
/// one.
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
  /// Size of the terms of lengths, energies and forces; accelerations are forces divided by a mass.
  double size() const {
    const double mass = p.m2 + p.m3 + p.inertia_over_square_1() + 2 * p.inertia_over_square_2(),
                 speed = abs(v[0]) + abs(v[1]);
    const double pulls = (p.m2 + p.m3) * p.g + p.c1 * (abs(p.K1) + p.L1 + abs(q[0])) +
                         2 * p.c2 * (abs(p.K2) + p.L2 + abs(q[1]) + 2 * abs(q[0]));
    return floor + mass * (speed * speed + abs(a[0]) + abs(a[1])) + pulls * (1 + mass / std::min(p.m2, p.m3));
  }
  TypesetIn<T> typeset() const {
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

  /// Lengths of the springs between floor and rope, from the ropes' lengths alone.
  template <class X>
  Two<X> springs(const Two<X>& y) const {
    const T rope1 = floor - 2 * y1 - p.K1, rope2 = floor - p.K2;
    return {(floor - y1) - (rope1 - (y[0] - y1)), (floor - y[0]) - (rope2 - (y[1] - y[0]))};
  }
  /// Changes of the ropes' lengths without their parts over the pulleys, for springs of lengths given by y
  /// and K.
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
  /// Speed of the rope over each pulley's rim toward the far side, from the rope on the spring's side.
  Two<T> rim_speeds() const {
    const auto s = springs(moving(q, v));
    return {s[0].slope, s[1].slope + v[0]};
  }
  /// A copy whose first spring is stretched, or compressed if `by` is negative.
  SampleOf stretched(double by = 1) const {
    SampleOf other = *this;
    other.p.L1 = springs(q)[0] - by * abs(delta);
    return other;
  }
  /// T from the ropes' lengths alone: the pulleys turn with the rope on the springs' side.
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
  /// Generalized forces, from the potential energy.
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
  /// A copy with these accelerations.
  SampleOf in_motion(const Two<T>& accelerations) const {
    SampleOf other = *this;
    other.a = accelerations;
    return other;
  }
};
namespace {

using Sample = SampleOf<double>;
using S = const Sample&;
using Samples = std::vector<Sample>;
using Table = ProvableClaims<SampleOf>;

/// The default pulleys.
constexpr two_pulleys::Given<double> standard{1, 2, 0.5, 0.25, 0.5, 0.5, 40,   30,  1,
                                              1, 1, 1.5, 9.81, 1,   2.5, 0.25, -0.5};
/// The tension of the second rope on the mass at the standard initial condition.
double tension_at_start() {
  std::array<double, 2> a;
  const std::array y{standard.y2, standard.y3};
  two_pulleys::TwoCoordinates<double>{standard}.acceleration(y, a);
  return standard.c2 * standard.stretch2(y) + standard.inertia_over_square_2() * (a[1] - a[0]);
}
/// The standard initial condition with a longer upper rope; loose() is the compression of its spring.
constexpr two_pulleys::Given<double> let_loose = [] {
  auto p = standard;
  p.K1 = -0.5;
  return p;
}();
double loose() { return -let_loose.stretch1(std::array{let_loose.y2, let_loose.y3}); }
/// The depth of the standard small pulley after this time.
double depth_after(double time, double lever) {
  const two_pulleys::TwoCoordinates<double> model{standard, lever};
  return ode::integrate<ode::Fehlberg78>(model, model.start(), 0, time, 1e-10).value[0];
}
/// The squared frequencies of the standard pulleys: the mean of both, and their squared distance from the
/// mean.
std::array<double, 2> squares_of_frequencies(double lever) {
  const auto& p = standard;
  const double c = p.c1 + 2 * lever * p.c2, d = -lever * p.c2;
  const auto a = p.accelerations(std::array{c, -2 * p.c2}), b = p.accelerations(std::array{d, p.c2});
  const double mean = (a[0] + b[1]) / 2;
  return {mean, mean * mean - (a[0] * b[1] - a[1] * b[0])};
}

// ---- the ropes --------------------------------------------------------------------------------------------

/// Changes of ropes and springs as y2 and y3 change by multiples of Delta; the text's change is `by` Delta.
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

/// For a string that the text stretches or compresses: its spring does so, and the rope keeps its length.
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
                 .printed = R"($(\dot y_2,\ \dot y_3-\dot y_2)$)"});
  const auto freedoms = [](const std::string& text, int count, bool fixed) -> Reading {
    Eigen::MatrixXd ties(fixed ? 5 : 4, 7);  // y1, y2, y3, S1, S2, theta1, theta2; R1 = 2, R2 = 3
    ties.topRows(4) << -2, 1, 0, -1, 0, 0, 0, /**/ 0, 2, -1, 0, 1, 0, 0, /**/ 1, -1, 0, 0, 0, 2, 0, /**/ 0, 1,
        -1, 0, 0, 0, 3;
    if (fixed) ties.row(4) << 1, 0, 0, 0, 0, 0, 0;
    return {text,
            {{"degrees of freedom",
              {"as stated", count},
              {"7 coordinates less the rank of their ties", 7 - rank(ties)},
              exact()}}};
  };
  claims.add("two_freedoms", 2439,
             "The system has two degrees of freedom, $y_2$ and $y_3$, since $y_1$ is fixed",
             {.printed = freedoms("2", 2, true),
              .near_misses = {freedoms("3", 3, true), freedoms("2 with $y_1$ free", 2, false)}});

  table.formula(
      "length_1", 2521, "$S_1-y_2$ is constant", samples,
      {.quantity = R"(what $S_1$ grows by when $y_2$ grows by $\Delta$)",
       .truth = {"by the first rope's length", [](const auto& s) { return s.springs_after(s.delta, 0)[0]; }},
       .printed = R"($\Delta$)"});
  table.formula("length_2", 2529, "$S_2-y_3+2y_2$ is constant", samples,
                {.quantity = R"(what $S_2$ grows by when $y_2$ and $y_3$ grow by $\Delta_2$ and $\Delta_3$)",
                 .truth = {"by the second rope's length",
                           [](const auto& s) { return s.springs_after(s.v[0], s.v[1])[1]; }},
                 .printed = R"($\Delta_3-2\Delta_2$)"});
  table.formula(
      "mass_down", 2531, "With $y_2$ fixed, the second spring grows by what the mass goes down", samples,
      {.quantity = R"(what $S_2$ grows by when $y_3$ grows by $\Delta$)",
       .truth = {"by the second rope's length", [](const auto& s) { return s.springs_after(0, s.delta)[1]; }},
       .printed = R"($\Delta$)"});
  table.formula("pulley_down", 2535,
                R"($S_2-\Delta$, $y_3+\Delta$ and $y_2+\Delta$ together keep the second rope's length)",
                samples,
                {.quantity = R"(what $S_2$ grows by when $y_2$ and $y_3$ grow by $\Delta$)",
                 .truth = {"by the second rope's length",
                           [](const auto& s) { return s.springs_after(s.delta, s.delta)[1]; }},
                 .printed = R"($-\Delta$)"});
  claims.add(
      "string_stretched", 2521, "When the small pulley goes down the string is stretched",
      string_for_spring(
          samples, {0, 1, 0, 1},
          {"the string over the large pulley gets longer", "the first spring gets longer",
           "the first spring gets shorter"},
          R"(The string is the wire, whose length the same paragraph calls constant; what gets longer )"
          R"(is the spring. The letter is right: $S_1$ is the spring's length, and grows by $\Delta$ )"
          R"(while the wire's change is 0. Line 2529 has the same word for the second spring.)"));
  claims.add(
      "must_compress", 2533,
      R"(When the small pulley and the mass both go down by $\Delta$ the string must be compressed)",
      string_for_spring(
          samples, {1, 1, 1, -1},
          {"the string over the small pulley gets shorter", R"(the second spring gets shorter by $\Delta$)",
           R"(the second spring gets longer by $\Delta$)"},
          R"(Again it is the spring, not the string, that gives way: $S_2$ becomes $S_2-\Delta$ and the )"
          R"(wire's length changes by 0. How much depends on the mass, for $y_2$ and $y_3$ are independent: )"
          R"(with $y_3$ fixed the spring shortens by $2\Delta$, and with $y_3\to y_3)"
          R"(+3\Delta$ it gets longer )"
          R"(by $\Delta$. The text's example is the case in which the small pulley does not turn.)"));
}

// ---- the energies -----------------------------------------------------------------------------------------

void energies(Table& table, const Samples& samples) {
  const std::string dual = "dual numbers", nested = "nested dual numbers";
  table.formula(
      "kinetic_energy", 2443,
      R"(The kinetic energy is $\frac{m_2}2\dot y_2^2+I_1\,2R_1^2\,\dot y_2^2+\frac{m_3}2\dot )"
      R"(y_3^2+I_2\,2R_2^2\,(\dot y_3-\dot y_2)^2$)",
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
       .printed = R"($\frac{m_2}2\dot y_2^2+I_1\,2R_1^2\,\dot y_2^2+\frac{m_3}2\dot y_3^2)"
                  R"(+I_2\,2R_2^2\,(\dot y_3-\dot y_2)^2$)",
       .meant = R"($\frac{m_2}2\dot y_2^2+\frac{I_1}{2R_1^2}\dot y_2^2+\frac{m_3}2\dot y_3^2)"
                R"(+\frac{I_2}{2R_2^2}(\dot y_3-\dot y_2)^2$)",
       .kind = Fault::lost_typography,
       .why = filled(
           "The fraction bars of the pulleys' terms are lost in the text at hand: $I_1/(2R_1^2)$ and "
           "$I_2/(2R_2^2)$, and before them $I_1/2$ and $I_2/2$. The default pulleys have @2 kg and @2 kg "
           "there, and the products are @2 and @3.",
           {0.5 / (2 * 0.25), 0.25 / (2 * 0.25), 0.5 * 2 * 0.25, 0.25 * 2 * 0.25})});
  table.formula("dT_dy", 2475, R"($\partial T/\partial y_2=\partial T/\partial y_3=0$)", samples,
                {.quantity = R"($(\partial T/\partial y_2,\ \partial T/\partial y_3)$)",
                 .truth = {"zero", [](const auto&) { return values(0, 0); }},
                 .printed = {dual + ", the pulleys turned by the ropes",
                             [](const auto& s) { return df_dq(s.kinetic(), s.q, s.v); }},
                 .near_misses = {{R"($(\partial L/\partial y_2,\ \partial L/\partial y_3)$)"}}});

  table.formula(
      "dT_dydot", 2483,
      R"(The derivatives of $T$ by the speeds are $m_2\dot y_2+I_1R_1^2\dot y_2+(I_2/R_2^2)(\dot )"
      R"(y_2-\dot y_3)$ and $m_3\dot y_3+I_2R_2^2(\dot y_3-\dot y_2)$)",
      samples,
      {.quantity = R"($(\partial T/\partial\dot y_2,\ \partial T/\partial\dot y_3)$)",
       .truth = {dual, [](const auto& s) { return df_dv(s.model(), s.q, s.v); }},
       .printed = R"($(m_2\dot y_2+I_1R_1^2\dot y_2+\frac{I_2}{R_2^2}(\dot y_2-\dot y_3),\ m_3\dot y_3)"
                  R"(+I_2R_2^2(\dot y_3-\dot y_2))$)",
       .meant = R"($(m_2\dot y_2+\frac{I_1}{R_1^2}\dot y_2+\frac{I_2}{R_2^2}(\dot y_2)"
                R"(-\dot y_3),\ m_3\dot y_3+\frac{I_2}{R_2^2}(\dot y_3-\dot y_2))$)",
       .kind = Fault::lost_typography,
       .why = filled(
           R"(The bars of $I_1/R_1^2$ in the first and of $I_2/R_2^2$ in the second derivative are lost in )"
           R"(the text at hand; the third one of the three is there. A pulley of a tenth of the radius )"
           R"(would turn @3 times more easily, where its rim is @3 times harder to move.)",
           {10 * 10, 10 * 10})});
  const std::string rates = R"($(m_2\ddot y_2+\frac{I_1}{R_1^2}\ddot y_2+\frac{I_2}{R_2^2}(\ddot y_2)"
                            R"(-\ddot y_3),\ m_3\ddot y_3+\frac{I_2}{R_2^2}(\ddot y_3-\ddot y_2))$)";
  table.formula("momentum_rates", 2497, "The time derivatives of these are " + rates, samples,
                {.quantity = "the time derivatives of these",
                 .truth = {nested, [](const auto& s) { return rate_of_df_dv(s.model(), s.q, s.v, s.a); }},
                 .printed = rates});
}

// ---- the forces -------------------------------------------------------------------------------------------

/// A rope is taut or slack: tension and slack are not negative, and one of them is zero. `of` returns the
/// tension from the spring's pull.
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
      "The force on the small pulley is $m_2g-c_1(S_1-L_1)$ also in compression, when $S_1<L_1$", samples,
      {.quantity = "negative tension of the rope, which is $m_2g$ less the force, negative slack, and their "
                   "product",
       .truth = {"zero", [](const auto&) { return values(0, 0, 0); }},
       .printed = {"the force is $m_2g-c_1(S_1-L_1)$", tension([](const auto& pull) { return pull; })},
       .corrected = {R"(the force is $m_2g-c_1\max(S_1-L_1,0)$)",
                     tension([]<class T>(const T& pull) { return max(pull, T(0)); })},
       .near_misses = {{"the force is $m_2g-c_1|S_1-L_1|$",
                        tension([](const auto& pull) { return abs(pull); })}},
       .kind = Fault::left_out,
       .root = "a rope that pushes",
       .why = filled(
           "Between spring and pulley is a wire, and a wire cannot push: where $S_1<L_1$ it hangs slack and "
           "the force is $m_2g$ alone; the same holds for $S_2<L_2$. With $K_1=@1$ m the default pulley "
           "starts at $S_1=@1$ m, pushed down with @2 N that are not there. The equations are valid as "
           "long as both wires are taut.",
           {let_loose.K1, let_loose.L1 - loose(), let_loose.c1 * loose()})});
}

/// The statement of `compression`, for stretched springs instead of compressed ones.
Reading in_stretching(const Samples& samples) {
  const Formula<Sample> tension{"the rope's tension is $c_1(S_1-L_1)$", [](S s) {
                                  const Sample stretched = s.stretched();
                                  const double S1 = stretched.springs(s.q)[0], L1 = stretched.p.L1,
                                               pull = s.p.c1 * (S1 - L1), slack = L1 + pull / s.p.c1 - S1;
                                  return values(min(pull, 0.0), min(slack, 0.0), pull * slack);
                                }};
  return {"in stretching, when $S_1>L_1$",
          {compare<Sample>("negative tension of the rope, negative slack, and their product", tension,
                           {"zero", [](S) { return values(0, 0, 0); }}, samples)}};
}

void forces(Table& table, Table& in_motion, const Samples& samples, const Samples& motions) {
  const std::string forgotten = "the second spring on the pulley";
  Samples stretched;
  for (const Sample& s : samples) stretched.push_back(s.stretched());
  table.formula(
      "stretched", 2517,
      "$S_1>L_1$ is stretching (our check: the first spring then pulls the small pulley up)", stretched,
      {.quantity = "the first spring's part of the force on the small pulley",
       .truth = {R"(what $-\partial V/\partial y_2$ has for $c_1$ and not for $c_1=0$, by dual numbers)",
                 [](const auto& s) {
                   auto free = s;
                   free.p.c1 = 0;
                   return s.forces()[0] - free.forces()[0];
                 },
                 &Sample::size},
       .printed = "$-c_1(S_1-L_1)$"});
  in_motion.formula(
      "force_on_pulley", 2517,
      "Gravity and the first spring are all that acts on the small pulley: $m_2g-c_1(K_1-L_1+y_2)$", motions,
      {.quantity = "the force on the small pulley",
       .truth = {R"($m_2\ddot y_2$ by Lagrange's equations)",
                 [](const auto& s) { return s.p.m2 * s.by_lagrange()[0]; }, &Sample::size},
       .printed = "$m_2g-c_1(K_1-L_1+y_2)$",
       .corrected = R"($m_2g-c_1(S_1-L_1)-\frac{I_1}{R_1^2}\ddot y_2+2c_2(S_2-L_2))"
                    R"(+\frac{I_2}{R_2^2}(\ddot y_3-\ddot y_2)$)",
       .kind = Fault::counterexample,
       .root = forgotten,
       .why =
           R"(There are four forces: gravity, the upper rope's tension, which is $c_1(S_1-L_1)$ only if the )"
           R"(large pulley has no inertia, and the lower rope on both sides of the small pulley.)"});
  in_motion.formula(
      "force_on_mass", 2525,
      "Gravity and the second spring's pull are the force on the mass: $m_3g-c_2(S_2-L_2)$", motions,
      {.quantity = "the force on the mass",
       .truth = {R"($m_3\ddot y_3$ by Lagrange's equations)",
                 [](const auto& s) { return s.p.m3 * s.by_lagrange()[1]; }, &Sample::size},
       .printed = "$m_3g-c_2(S_2-L_2)$",
       .corrected = R"($m_3g-c_2(S_2-L_2)-\frac{I_2}{R_2^2}(\ddot y_3-\ddot y_2)$)",
       .kind = Fault::counterexample,
       .root = "the small pulley's inertia",
       .why = filled(
           R"(The pulley between spring and mass has inertia: the rope pulls the mass with )"
           R"($c_2(S_2-L_2)+(I_2/R_2^2)(\ddot y_3-\ddot y_2)$, at the default start with @3 N for the @2 N of )"
           R"(the spring. The formula is the generalized force on $y_3$, and the equation of motion that uses )"
           R"(it as such is right.)",
           {tension_at_start(), standard.c2 * standard.stretch2(std::array{standard.y2, standard.y3})})});

  table.formula(
      "force_y2", 2541, "The generalized force on $y_2$ is $m_2g-c_1(K_1-L_1+y_2)$", samples,
      {.quantity = "the generalized force on $y_2$",
       .truth = {R"($-\partial V/\partial y_2$ by dual numbers)",
                 [](const auto& s) { return s.forces()[0]; }},
       .printed = "$m_2g-c_1(K_1-L_1+y_2)$",
       .corrected = "$m_2g-c_1(K_1-L_1+y_2)+2c_2(K_2-L_2+y_3-2y_2)$",
       .kind = Fault::formula,
       .root = forgotten,
       .why = filled(
           R"(When $y_2$ grows by $\Delta$ at fixed $y_3$, the second spring shortens by $2\Delta$ and does )"
           R"(the work $2c_2(S_2-L_2)\Delta$: its rope pulls the small pulley down on both sides. At rest the )"
           R"(first spring must carry $(m_2+2m_3)g$. As published it carries $m_2g$ alone, @3 N for @4 N with )"
           R"(the default masses.)",
           {standard.m2 * standard.g, (standard.m2 + 2 * standard.m3) * standard.g})});
  table.formula("force_y3", 2543, "The generalized force on $y_3$ is $m_3g-c_2(K_2-L_2+y_3-2y_2)$", samples,
                {.quantity = "the generalized force on $y_3$",
                 .truth = {R"($-\partial V/\partial y_3$ by dual numbers)",
                           [](const auto& s) { return s.forces()[1]; }},
                 .printed = "$m_3g-c_2(K_2-L_2+y_3-2y_2)$"});
}

// ---- the equations ----------------------------------------------------------------------------------------

std::string of_frequencies() {
  const auto [mean, square] = squares_of_frequencies(0);
  const double size = sqrt(mean * mean - square), rate = sqrt((size - mean) / 2);
  const auto [sum, difference] = squares_of_frequencies(2);
  return filled(
      R"(The term $+2c_2(K_2-L_2+y_3-2y_2)$ is missing. Without it energy is not conserved, and the )"
      R"(rest position is not even stable: with the default values the two frequencies are )"
      R"($@3\pm@3\,i$ per second, and its swings double every @2 s. )"
      R"(With the term they are @3 and @3 per second.)",
      {sqrt((size + mean) / 2), rate, std::log(2.0) / rate, sqrt(sum - sqrt(difference)),
       sqrt(sum + sqrt(difference))});
}

/// Left minus right side of the equations is zero in a motion, by Lagrange's equations or by the ropes'
/// tensions.
void equations(Table& in_motion, const Samples& motions) {
  const ProvableFormula<SampleOf> zero{"zero", [](const auto&) { return 0.0; }};
  const std::string balance =
      R"(left side less right side, with $\ddot y$ by Lagrange's equations or by the ropes' tensions)";
  in_motion.formula(
      "equation_y2", 2547,
      R"($m_2\ddot y_2+(I_1/R_1^2)\ddot y_2+(I_2/R_2^2)(\ddot y_2-\ddot y_3)=m_2g-c_1(K_1-L_1)"
      R"(+y_2)$, the bar )"
      R"(of $I_1/R_1^2$ restored)",
      motions,
      {.quantity = balance,
       .truth = zero,
       .printed = R"($m_2\ddot y_2+\frac{I_1}{R_1^2}\ddot y_2+\frac{I_2}{R_2^2}(\ddot y_2-\ddot y_3)=m_2g)"
                  R"(-c_1(K_1-L_1+y_2)$)",
       .corrected = R"($m_2\ddot y_2+\frac{I_1}{R_1^2}\ddot y_2+\frac{I_2}{R_2^2}(\ddot y_2-\ddot y_3)=m_2g)"
                    R"(-c_1(K_1-L_1+y_2)+2c_2(K_2-L_2+y_3-2y_2)$)",
       .kind = Fault::formula,
       .root = "the second spring on the pulley",
       .why = of_frequencies()});
  in_motion.formula(
      "equation_y3", 2553, R"($m_3\ddot y_3+I_2R_2^2(\ddot y_3-\ddot y_2)=m_3g-c_2(K_2-L_2+y_3-2y_2)$)",
      motions,
      {.quantity = balance,
       .truth = zero,
       .printed = R"($m_3\ddot y_3+I_2R_2^2(\ddot y_3-\ddot y_2)=m_3g-c_2(K_2-L_2+y_3-2y_2)$)",
       .meant = R"($m_3\ddot y_3+\frac{I_2}{R_2^2}(\ddot y_3-\ddot y_2)=m_3g-c_2(K_2-L_2+y_3-2y_2)$)",
       .kind = Fault::lost_typography,
       .why = filled(
           "The bar of $I_2/R_2^2$ is lost in the text at hand; line 2511, from which the term is taken, "
           "has it. The default pulley would weigh in with @3 kg at its rim for @2 kg.",
           {0.25 * 0.25, standard.inertia_over_square_2()})});
}

void state(Claims& claims, Table& table, Table& in_motion, const Samples& samples) {
  Samples motions;
  for (const Sample& s : samples) {
    motions.push_back(s.in_motion(s.by_lagrange()));
    motions.push_back(s.in_motion(s.by_tensions()));
  }
  kinematics(claims, table, samples);
  energies(table, samples);
  forces(table, in_motion, samples, motions);
  equations(in_motion, motions);
  compression(table, samples);
}

}  // namespace

std::vector<Claim> claims(double seed) {
  Claims claims("3.19");
  Table table(claims), in_motion(claims);
  const auto samples = draw<Sample>(200, seed);
  state(claims, table, in_motion, samples);
  std::vector<Claim> all = claims.in_order();
  std::ranges::find(all, "3.19-compression", &Claim::id)->in_view = in_stretching(samples);
  return all;
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
  Table table(claims), in_motion(claims);
  state(claims, table, in_motion, {});
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
  ForAll<SampleOf> by_lagrange = all, by_tensions = all;
  by_lagrange.any = all.any.in_motion(all.any.by_lagrange());
  by_lagrange.example = all.example.in_motion(all.example.by_lagrange());
  by_tensions.any = all.any.in_motion(all.any.by_tensions());
  by_tensions.example = all.example.in_motion(all.example.by_tensions());
  const Provables again = in_motion.proofs("3.19", by_lagrange);
  for (Provable& one : in_motion.proofs("3.19", by_tensions)) {
    one.lemmas.push_back(std::ranges::find(again, one.claim, &Provable::claim)->lemmas[0]);
    one.lemmas.back().name += "_by_lagrange";
    proved.push_back(std::move(one));
  }
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
  constexpr double shown_after = 1;
  return {
      {"the second spring on the pulley",
       filled("By the published equations the small pulley of the default start is @2 m above the ceiling "
              "after @1 s, where it should hang @2 m below it.",
              {-depth_after(shown_after, 0), shown_after, depth_after(shown_after, 2)})},
      {"the small pulley's inertia",
       filled(
           "A rope that breaks at 25 N holds the default mass at the start, as its tension is @3 N; by the "
           "published formula it is @2 N, and the mass falls.",
           {tension_at_start(), standard.c2 * standard.stretch2(std::array{standard.y2, standard.y3})})},
      {"a rope that pushes",
       filled(
           "Started with @1 m of slack ($K_1=@1$ m), the small pulley is pushed down by its rope with @2 N.",
           {loose(), let_loose.K1, let_loose.c1 * loose()})}};
}

}  // namespace oddity::ex03_19

namespace oddity {

Provables proofs_3_19() { return ex03_19::proofs(); }

}  // namespace oddity
