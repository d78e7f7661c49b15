#include "chapters/provable_claims.hpp"

#include <Eigen/Core>
#include <complex>

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

  Letters<T> table() {
    const Range positive{0.3, 3}, any = either_sign(0.1, 2);
    return {{"m_2", p.m2, positive},     {"m_3", p.m3, positive},
            {"I_1", p.I1, positive},     {"I_2", p.I2, positive},
            {"R_1", p.R1, positive},     {"R_2", p.R2, positive},
            {"c_1", p.c1, positive},     {"c_2", p.c2, positive},
            {"L_1", p.L1, positive},     {"L_2", p.L2, positive},
            {"K_1", p.K1, any},          {"K_2", p.K2, any},
            {"g", p.g, positive},        {"y_2", q[0], any},
            {"y_3", q[1], any},          {R"(\dot y_2)", v[0], any},
            {R"(\dot y_3)", v[1], any},  {R"(\ddot y_2)", a[0], any},
            {R"(\ddot y_3)", a[1], any}, {"floor", floor, {4, 8}, "depth"},
            {"y_1", y1, {0.1, 1}},       {R"(\Delta)", delta, any, "delta"}};
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
    const Two<T> s = springs(q), slopes = df_dq(lagrangian(), q, v), of_T = df_dq(kinetic(), q, v),
                 rims = rim_speeds(), pulls = of_springs();
    const T dS = springs_after(abs(v[0]), abs(v[1]))[1];
    return {{"S_1", s[0]},         {R"(\dot\theta_1)", rims[0] / p.R1},
            {"S_2", s[1]},         {R"(\dot\theta_2)", rims[1] / p.R2},
            {"F_1", pulls[0]},     {R"(\partial L/\partial y_2)", slopes[0]},
            {"F_2", pulls[1]},     {R"(\partial L/\partial y_3)", slopes[1]},
            {R"(\Delta_2)", v[0]}, {R"(\partial T/\partial y_2)", of_T[0]},
            {R"(\Delta_3)", v[1]}, {R"(\partial T/\partial y_3)", of_T[1]},
            {R"(\Delta S_2)", dS}};
  }
  std::string where() const { return listed(typeset_of(*this), 15); }

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
  /// Force of each spring on its own body: of the first on the small pulley, of the second on the mass.
  Two<T> of_springs() const {
    SampleOf first = *this, second = *this;
    first.p.c1 = T(0), second.p.c2 = T(0);
    return {forces()[0] - first.forces()[0], forces()[1] - second.forces()[1]};
  }
  Two<T> by_lagrange() const { return lagrange_accelerations(lagrangian(), q, v); }
  Two<T> by_tensions() const {
    std::array<T, 4> rates;
    two_pulleys::FourCoordinates<T>{p}.acceleration(
        std::array<T, 4>{q[0], q[1], q[0] / p.R1, (q[1] - q[0]) / p.R2}, rates);
    return {rates[0], rates[1]};
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
using Form = ProvableFormula<SampleOf>;

/// The default pulleys.
constexpr two_pulleys::Given<double> standard{1, 2, 0.5, 0.25, 0.5, 0.5, 40,   30,  1,
                                              1, 1, 1.5, 9.81, 1,   2.5, 0.25, -0.5};
using Model = two_pulleys::TwoCoordinates<double>;

/// The tensions of the ropes' ends: the first at its spring and at the small pulley, the second at its spring
/// and at the mass.
std::array<double, 4> tensions(const Model& model, const Pair& y) {
  const auto& p = model.p;
  Pair a;
  model.acceleration(y, a);
  const double pull1 = p.c1 * p.stretch1(y), pull2 = p.c2 * p.stretch2(y);
  return {pull1, pull1 + p.inertia_over_square_1() * a[0], pull2,
          pull2 + p.inertia_over_square_2() * (a[1] - a[0])};
}
const auto at_start = tensions({standard}, {standard.y2, standard.y3});
/// The default initial condition with a longer upper rope; loose() is the compression of its spring.
constexpr two_pulleys::Given<double> let_loose = [p = standard]() mutable { return p.K1 = -0.5, p; }();
double loose() { return -let_loose.stretch1(std::array{let_loose.y2, let_loose.y3}); }
/// The default pulleys after these times.
std::vector<Model::State> default_motion(const std::vector<double>& times, double lever = 2) {
  const Model model{standard, lever};
  return ode::integrate<ode::Fehlberg78>(model, model.start(), times, 1e-10).value;
}
constexpr double watched = 8, shown_after = 0.5;
/// The tensions of both ropes' ends over the default motion.
std::vector<double> tensions_until(double end, double lever = 2) {
  std::vector<double> times, all;
  for (int i = 0; i <= 64 * end; ++i) times.push_back(i / 64.0);
  for (const Model::State& x : default_motion(times, lever))
    std::ranges::copy(tensions({standard, lever}, {x[0], x[1]}), std::back_inserter(all));
  return all;
}
/// The frequencies of the standard pulleys, complex where they are not stable.
std::array<std::complex<double>, 2> frequencies(double lever) {
  const auto& p = standard;
  const auto a = p.accelerations(std::array{p.c1 + 2 * lever * p.c2, -2 * p.c2}),
             b = p.accelerations(std::array{-lever * p.c2, p.c2});
  const auto squares = eigenvalues(Eigen::Matrix2d{{a[0], b[0]}, {a[1], b[1]}});
  return {std::sqrt(squares.at(0)), std::sqrt(squares.at(1))};
}

// ---- the ropes --------------------------------------------------------------------------------------------

/// The freedoms of y1, y2, y3, S1, S2, theta1 and theta2, and whether the two chosen ones decide the others;
/// R1 = 2, R2 = 3. Of the ties the last holds the large pulley.
Reading freedoms(const std::string& text, int count, const std::array<Eigen::Index, 2>& chosen) {
  constexpr int all = 7, tied = 5;
  Eigen::MatrixXd ties(tied, all);
  ties << -2, 1, 0, -1, 0, 0, 0, /**/ 0, 2, -1, 0, 1, 0, 0, /**/ 1, -1, 0, 0, 0, 2, 0, /**/ 0, 1, -1, 0, 0, 0,
      3, /**/ 1, 0, 0, 0, 0, 0, 0;
  const int tie = rank(ties);
  std::vector<double> varying;
  for (Eigen::Index i : {0, 1, 2, 5, 6}) {
    Eigen::MatrixXd held(tied + 1, all);
    held << ties, Eigen::RowVectorXd::Unit(all, i);
    varying.push_back(rank(held) - tie);
  }
  Eigen::MatrixXd others = ties;
  for (Eigen::Index i : chosen) others.col(i).setZero();
  return {text,
          {{"degrees of freedom",
            {"as stated", count},
            {"7 coordinates less the rank of their ties", all - tie},
            exact()},
           {"coordinates that the two decide",
            {"all others", all - 2},
            {"the rank of the ties without those two", rank(others)},
            exact()},
           {R"(which of $y_1$, $y_2$, $y_3$, $\theta_1$ and $\theta_2$ vary)",
            {"all but $y_1$", {0, 1, 1, 1, 1}},
            {"whether the rank grows when one is held", varying},
            exact()}}};
}

/// Growth of a spring, by its rope's length, when the small pulley and the mass go down by multiples of
/// Delta.
Form growth(std::size_t rope, double pulley, double mass) {
  return {std::string("by the ") + (rope == 0 ? "first" : "second") + " rope's length",
          [=](const auto& s) { return s.springs_after(pulley * s.delta, mass * s.delta)[rope]; }};
}

void kinematics(Claims& claims, Table& table, const Samples& samples) {
  const auto claim = table.over(samples);
  claim("rolling", 2437,
        R"($R_1\dot\theta_1=\dot y_2-\dot y_1=\dot y_2$ and $R_2\dot\theta_2=\dot y_3-\dot y_2$)",
        {"the rope that runs over the rims, from the ropes' lengths on the springs' side",
         [](const auto& s) { return s.rim_speeds(); }},
        R"($(\dot y_2,\ \dot y_3-\dot y_2)$)");
  claims.add("two_freedoms", 2439, "The system has only two degrees of freedom, $y_2$ and $y_3$",
             {.printed = freedoms("2, $y_2$ and $y_3$", 2, {1, 2}),
              .near_misses = {freedoms("2, $y_2$ and $S_1$", 2, {1, 3})}});

  claim("length_1", 2521, "$S_1-y_2$ is constant", growth(0, 1, 0), R"($\Delta$)",
        R"(growth of $S_1$ when $y_2$ grows by $\Delta$)");
  claim("length_2", 2529, "$S_2-y_3+2y_2$ is constant",
        {"by the second rope's length", [](const auto& s) { return s.springs_after(s.v[0], s.v[1])[1]; }},
        R"($\Delta_3-2\Delta_2$)",
        R"(growth of $S_2$ when $y_2$ and $y_3$ grow by $\Delta_2$ and $\Delta_3$)");
  claim("mass_down", 2531, R"(With $y_2$ fixed, $S_2+\Delta$ and $y_3+\Delta$ keep the second rope's length)",
        growth(1, 0, 1), R"($\Delta$)", R"(growth of $S_2$ when $y_3$ grows by $\Delta$)");
  claim("pulley_down", 2535,
        R"($S_2-\Delta$, $y_3+\Delta$ and $y_2+\Delta$ together keep the second rope's length)",
        growth(1, 1, 1), R"($-\Delta$)", R"(growth of $S_2$ when $y_2$ and $y_3$ grow by $\Delta$)");
  // When the text stretches or compresses a string, its spring gets longer or shorter, and the string does
  // not.
  const auto string_for_spring = [&](std::string_view slug, int line, std::string says, std::size_t rope,
                                     double pulley, double mass, const std::string& change, std::string why) {
    claim(slug, line, std::move(says),
          {.quantity = "(change of the string's length, change of its spring's length)",
           .truth = {"the string summed over its straight parts; the spring by the rope's length",
                     [=](const auto& s) {
                       const auto down2 = pulley * s.delta, down3 = mass * s.delta;
                       return values(s.ropes_after(down2, down3)[rope], s.springs_after(down2, down3)[rope]);
                     }},
           .printed = "$(" + change + R"(,\ 0)$)",
           .meant = "$(0,\\ " + change + ")$",
           .kind = Fault::term,
           .why = std::move(why)});
  };
  const std::string as_stretched = " (our reading: it gets longer, and not its spring)";
  string_for_spring(
      "string_stretched", 2521,
      R"(When the small pulley goes down by $\Delta$ the string is stretched)" + as_stretched, 0, 1, 0,
      R"(\Delta)",
      R"(The string is the wire, whose length the same paragraph calls constant; the spring gets )"
      R"(longer. The letter is right: $S_1$ is the spring's length, and grows by $\Delta$ )"
      R"(while the wire's change is 0.)");
  string_for_spring(
      "second_string_stretched", 2529,
      R"(When the mass goes down by $\Delta$ at fixed $y_2$ the string must be stretched)" + as_stretched, 1,
      0, 1, R"(\Delta)",
      R"(As in line 2521, the spring is stretched, from $S_2$ to $S_2+\Delta$, while the string keeps )"
      R"(its length.)");
  string_for_spring(
      "must_compress", 2533,
      R"(When the small pulley and the mass both go down by $\Delta$ (the text's example) the string is compressed )"
      R"((our reading: it gets shorter, and not its spring))",
      1, 1, 1, R"(-\Delta)",
      R"(Again the spring, not the string, gives way: $S_2$ becomes $S_2-\Delta$ and the wire's length )"
      R"(changes by 0. Compressed here means shorter than before; in line 2525 it means $S_2<L_2$. )"
      R"(In the example the small pulley does not turn.)");
  claims.statement<Sample>(
      "must_shorten", 2533,
      R"(When the small pulley goes down while the mass does, the second spring must get shorter (our check: )"
      R"($\Delta S_2$ is its growth when they go down by $|\Delta_2|$ and $|\Delta_3|$))",
      samples,
      {.printed = {R"($\Delta S_2<0$)"},
       .corrected = {R"($\Delta S_2\,(|\Delta_3|-2|\Delta_2|)>0$)"},
       .in_view = {"where the mass goes down no further than the small pulley, as in the text's example",
                   [](S s) { return abs(s.v[1]) <= abs(s.v[0]); }},
       .near_misses = {{R"($\Delta S_2\,(|\Delta_3|-|\Delta_2|)>0$)"}},
       .root = "a spring that must get shorter",
       .why =
           R"($y_2$ and $y_3$ are independent. When they grow by $\Delta_2$ and $\Delta_3$ the second spring )"
           R"(grows by $\Delta_3-2\Delta_2$: with $\Delta_3=3\Delta_2$ it gets longer by $\Delta_2$.)"});
}

// ---- the energies -----------------------------------------------------------------------------------------

/// The derivatives of T by the speeds, for y "\dot y"; their rates, for "\ddot y".
Two<std::string> momenta(const std::string& y) {
  const std::string second = R"(+\frac{I_2}{R_2^2}()" + y;
  return {"m_2" + y + R"(_2+\frac{I_1}{R_1^2})" + y + "_2" + second + "_2-" + y + "_3)",
          "m_3" + y + "_3" + second + "_3-" + y + "_2)"};
}
std::string both(const Two<std::string>& of) { return "$(" + of[0] + R"(,\ )" + of[1] + ")$"; }

void energies(Table& table, const Samples& samples) {
  const auto claim = table.over(samples);
  const Form kinetic_energy{"that of the masses by their speeds, of the pulleys by the speeds of their rims",
                            [](const auto& s) { return s.kinetic()(s.q, s.v); }};
  const auto kinetic = [&](std::string_view slug, int line, const std::string& begin,
                           const std::string& printed, const std::string& meant, const std::string& why) {
    claim(slug, line, begin + "kinetic energy is " + printed,
          {.truth = kinetic_energy, .printed = printed, .meant = meant, .why = why});
  };
  kinetic(
      "kinetic_energy_by_angles", 2443, "The ",
      R"($\frac{m_2}2\dot y_2^2+I_1\,2\,\dot\theta_1^2+\frac{m_3}2\dot y_3^2+I_2\,2\,\dot\theta_2^2$)",
      R"($\frac{m_2}2\dot y_2^2+\frac{I_1}2\dot\theta_1^2+\frac{m_3}2\dot y_3^2+\frac{I_2}2\dot\theta_2^2$)",
      filled("The fraction bars of $I_1/2$ and $I_2/2$ are lost in the text at hand; read as products "
             "they are @1 times as much.",
             {2 * 2}));
  kinetic(
      "kinetic_energy", 2443, "With the pulleys turned by their ropes the ",
      R"($\frac{m_2}2\dot y_2^2+I_1\,2R_1^2\,\dot y_2^2+\frac{m_3}2\dot y_3^2+I_2\,2R_2^2\,(\dot y_3-\dot y_2)^2$)",
      R"($\frac{m_2}2\dot y_2^2+\frac{I_1}{2R_1^2}\dot y_2^2+\frac{m_3}2\dot y_3^2)"
      R"(+\frac{I_2}{2R_2^2}(\dot y_3-\dot y_2)^2$)",
      filled("The fraction bars of the pulleys' terms are lost in the text at hand: $I_1/(2R_1^2)$ and "
             "$I_2/(2R_2^2)$. The default pulleys have @2 kg and @2 kg there, and the products are @2 and @3 "
             "kg m$^4$, of another unit.",
             {0.5 / (2 * 0.25), 0.25 / (2 * 0.25), 0.5 * 2 * 0.25, 0.25 * 2 * 0.25}));
  claim(
      "dT_dy", 2475, R"($\partial T/\partial y_2=\partial T/\partial y_3=0$)",
      {.quantity =
           R"($(\partial T/\partial y_2,\ \partial T/\partial y_3)$ by dual numbers, the pulleys turned by the ropes)",
       .truth = {"zero", [](const auto&) { return values(0, 0); }},
       .printed = R"($(\partial T/\partial y_2,\ \partial T/\partial y_3)=(0,0)$)",
       .near_misses = {R"($(\partial L/\partial y_2,\ \partial L/\partial y_3)=(0,0)$)"},
       .changes_that_hold = "a factor of zero may have any size and sign"});

  claim(
      "dT_dydot", 2483,
      R"(The derivatives of $T$ by the speeds are $m_2\dot y_2+I_1R_1^2\dot y_2+(I_2/R_2^2)(\dot )"
      R"(y_2-\dot y_3)$ and $m_3\dot y_3+I_2R_2^2(\dot y_3-\dot y_2)$)",
      {.truth = {"dual numbers", [](const auto& s) { return df_dv(s.model(), s.q, s.v); }},
       .printed = R"($(m_2\dot y_2+I_1R_1^2\dot y_2+\frac{I_2}{R_2^2}(\dot y_2-\dot y_3),\ m_3\dot y_3)"
                  R"(+I_2R_2^2(\dot y_3-\dot y_2))$)",
       .meant = both(momenta(R"(\dot y)")),
       .why = filled(
           R"(The bars of $I_1/R_1^2$ in the first and of $I_2/R_2^2$ in the second derivative are lost in )"
           R"(the text at hand; the third one of the three is there. At a tenth of the radius, with the )"
           R"(same moment of inertia, a pulley would turn @3 times more easily, where its rim is @3 times harder )"
           R"(to move.)",
           {10 * 10, 10 * 10})});
  const std::string rates = both(momenta(R"(\ddot y)"));
  claim("momentum_rates", 2497,
        R"(The time derivatives of $\partial T/\partial\dot y_2$ and $\partial T/\partial\dot y_3$ are )" +
            rates,
        {"nested dual numbers", [](const auto& s) { return rate_of_df_dv(s.model(), s.q, s.v, s.a); }},
        rates);
}

// ---- the forces -------------------------------------------------------------------------------------------

/// A rope is taut or slack: tension and slack are not negative, and one of them is zero. `of` returns the
/// tension from the spring's pull.
template <class T, class Tension>
auto negative_or_both(const SampleOf<T>& s, const Tension& of) {
  const Two<T> lengths = s.springs(s.q), c{s.p.c1, s.p.c2}, rest{s.p.L1, s.p.L2};
  std::array<T, 6> all;
  for (std::size_t i = 0; i < 2; ++i) {
    const T tension = of(T(c[i] * (lengths[i] - rest[i]))), slack = rest[i] + tension / c[i] - lengths[i];
    all[3 * i] = min(tension, T(0)), all[3 * i + 1] = min(slack, T(0)), all[3 * i + 2] = tension * slack;
  }
  return all;
}

Form pulls(const std::string& text, const auto& of) {
  return {text, [=](const auto& s) { return negative_or_both(s, of); }};
}

void compression(Table& table, Samples samples) {
  // also with rest lengths that are |delta| less than the springs' lengths
  for (Sample s : Samples(samples)) {
    const Pair lengths = s.springs(s.q);
    s.p.L1 = lengths[0] - abs(s.delta), s.p.L2 = lengths[1] - abs(s.delta);
    samples.push_back(s);
  }
  table.over(samples)(
      "compression", 2517,
      "The springs pull their ropes with $c_1(S_1-L_1)$ and $c_2(S_2-L_2)$ (our reading: also in compression, "
      "when $S_1<L_1$ or $S_2<L_2$)",
      {.quantity = "negative tension of each rope at its spring, negative slack, and their product",
       .truth = {"zero", [](const auto&) { return values(0, 0, 0, 0, 0, 0); }},
       .printed = pulls("the ropes are pulled with $c_1(S_1-L_1)$ and $c_2(S_2-L_2)$",
                        [](const auto& pull) { return pull; }),
       .corrected =
           pulls(R"(the ropes are pulled with $c_1\max(S_1-L_1,0)$ and $c_2\max(S_2-L_2,0)$, where $S_1$ )"
                 R"(is $y_2+K_1$ and $S_2$ is $y_3-2y_2+K_2$)",
                 []<class T>(const T& pull) { return max(pull, T(0)); }),
       .in_view = {"in stretching, when $S_1>L_1$ and $S_2>L_2$",
                   [](S s) { return s.p.stretch1(s.q) > 0 && s.p.stretch2(s.q) > 0; }},
       .near_misses = {pulls("with $c_1|S_1-L_1|$ and $c_2|S_2-L_2|$",
                             [](const auto& pull) { return abs(pull); })},
       .root = "a rope that pushes",
       .why = filled(
           "Between a spring and its body is a wire, and a wire cannot push: where $y_2+K_1<L_1$ the first "
           "hangs slack and its spring pulls nothing. With $K_1=@1$ m the default start has $y_2+K_1=@1$ m, "
           "and the formula pushes the first rope with @2 N. The equations are valid as long as both ropes "
           "are taut at both ends, whose tensions differ by the pull that turns the pulley. In @1 s of the "
           "default motion the least tension of the four ends is @2 N.",
           {let_loose.K1, let_loose.L1 - loose(), let_loose.c1 * loose(), watched,
            std::ranges::min(tensions_until(watched))})});
}

Check taut() {
  std::vector<double> all = tensions_until(watched);
  std::ranges::copy(tensions_until(shown_after, 0), std::back_inserter(all));
  return no_violations(
      "both ropes of the default motion, and until shown of the published one, are taut at both "
      "ends: cases against it",
      std::ranges::count_if(all, [](double tension) { return tension <= 0; }), std::ssize(all));
}

void forces(Claims& claims, Table& table, Table& in_motion, const Samples& samples, const Samples& motions) {
  const auto claim = table.over(samples);
  const auto moving = in_motion.over(motions);
  const std::string forgotten = "the second spring on the pulley", pull_1 = "$m_2g-c_1(S_1-L_1)$",
                    pull_2 = "$m_3g-c_2(S_2-L_2)$", on_y2 = "$m_2g-c_1(K_1-L_1+y_2)$",
                    on_y3 = "$m_3g-c_2(K_2-L_2+y_3-2y_2)$";
  const auto generalized = [](std::size_t i) -> Form {
    return {R"($-\partial V/\partial y_)" + std::to_string(i + 2) + "$ by dual numbers",
            [=](const auto& s) { return s.forces()[i]; }};
  };
  claims.statement<Sample>(
      "stretched", 2515,
      "$S_1>L_1$ is stretching and $S_1<L_1$ compression, and so with $S_2$ and $L_2$ (our check: by the "
      "energies a spring then pulls its body up, or pushes it down, with the forces $F_1$ and $F_2$)",
      samples,
      {.printed = {R"($(F_1(S_1-L_1),\ F_2(S_2-L_2))<0$)"},
       .near_misses = {{R"($(F_1(L_1-S_1),\ F_2(L_2-S_2))<0$)"}}});
  moving(
      "force_on_pulley", 2517,
      "The force on the small pulley has two components, gravity and the first spring's: " + pull_1,
      {.truth = {R"($m_2\ddot y_2$ by Lagrange's equations)",
                 [](const auto& s) { return s.p.m2 * s.by_lagrange()[0]; }},
       .printed = pull_1,
       .corrected = R"($m_2g-c_1(S_1-L_1)-\frac{I_1}{R_1^2}\ddot y_2+2c_2(S_2-L_2))"
                    R"(+\frac{I_2}{R_2^2}(\ddot y_3-\ddot y_2)$)",
       .kind = Fault::counterexample,
       .root = forgotten,
       .why =
           R"(There are four forces: gravity, the upper rope's tension, and the lower rope's on both sides )"
           R"(of the small pulley. The upper tension is $c_1(S_1-L_1)$ only where the large pulley has no )"
           R"(inertia or does not accelerate. So the formula lacks the second spring and, as the mass's )"
           R"(does, the pulleys' inertia.)"});
  claim("force_in_y2", 2523, pull_1 + " is " + on_y2,
        {"by the first rope's length",
         [](const auto& s) { return s.p.m2 * s.p.g - s.p.c1 * (s.springs(s.q)[0] - s.p.L1); }},
        on_y2);
  moving(
      "force_on_mass", 2525, "Gravity and the second spring's pull are the force on the mass: " + pull_2,
      {.truth = {R"($m_3\ddot y_3$ by Lagrange's equations)",
                 [](const auto& s) { return s.p.m3 * s.by_lagrange()[1]; }},
       .printed = pull_2,
       .corrected = R"($m_3g-c_2(S_2-L_2)-\frac{I_2}{R_2^2}(\ddot y_3-\ddot y_2)$)",
       .kind = Fault::counterexample,
       .root = "the small pulley's inertia",
       .why = filled(
           R"(The pulley between spring and mass has inertia: the rope pulls the mass with )"
           R"($c_2(S_2-L_2)+(I_2/R_2^2)(\ddot y_3-\ddot y_2)$, at the default start with @3 N for the @2 N of )"
           R"(the spring. The verdict takes "the force on the point mass" at its word, as line 2543 names )"
           R"(the generalized force separately. The paragraph's first line announces generalized forces: as )"
           R"(the one on $y_3$ the formula is right, and so is the equation of motion that uses it.)",
           {at_start[3], at_start[2]})});
  claim("force_in_y3", 2539, pull_2 + " is " + on_y3,
        {"by the second rope's length",
         [](const auto& s) { return s.p.m3 * s.p.g - s.p.c2 * (s.springs(s.q)[1] - s.p.L2); }},
        on_y3);
  claim(
      "force_y2", 2541, "The generalized force on $y_2$ is " + on_y2,
      {.truth = generalized(0),
       .printed = on_y2,
       .corrected = "$m_2g-c_1(K_1-L_1+y_2)+2c_2(K_2-L_2+y_3-2y_2)$",
       .root = forgotten,
       .why = filled(
           R"(When $y_2$ grows by $\Delta$ at fixed $y_3$, the second spring shortens by $2\Delta$ and does )"
           R"(the work $2c_2(S_2-L_2)\Delta$, for small $\Delta$: its rope pulls the small pulley down on both sides. At rest the )"
           R"(first spring must carry $(m_2+2m_3)g$. As published it carries $m_2g$ alone, @3 N for @4 N with )"
           R"(the default masses.)",
           {standard.m2 * standard.g, (standard.m2 + 2 * standard.m3) * standard.g})});
  claim("force_y3", 2543, "The generalized force on $y_3$ is " + on_y3, generalized(1), on_y3);
}

// ---- the equations ----------------------------------------------------------------------------------------

std::string of_frequencies() {
  const auto published = frequencies(0)[0];
  const double rate = std::abs(published.imag());
  const auto [slow, fast] = std::minmax({frequencies(2)[0].real(), frequencies(2)[1].real()});
  return filled(
      R"(The term $+2c_2(K_2-L_2+y_3-2y_2)$ is missing. Without it the energy changes at the rate )"
      R"($-2c_2(S_2-L_2)\dot y_2$, and the rest position is not even stable: with the default values the two frequencies are )"
      R"($@3\pm@3\,i$ per second, and its swings double every @2 s. )"
      R"(With the term they are @3 and @3 per second.)",
      {published.real(), rate, std::log(2.0) / rate, slow, fast});
}

/// Rate of the energy along the published equations, which omit the second spring's force on the small
/// pulley.
Check energy_lost(const Samples& samples) {
  return compare<Sample>("rate of the energy along the published equations",
                         computed(Formula<Sample>{R"($-2c_2(S_2-L_2)\dot y_2$)"}),
                         {"kinetic and potential energy by dual numbers",
                          [](S s) {
                            Pair a;
                            Model{s.p, 0}.acceleration(s.q, a);
                            const auto y = moving(s.q, s.v), dy = moving(s.v, a);
                            return (s.p.kinetic_energy(dy) + s.p.potential_energy(y)).slope;
                          }},
                         samples);
}

/// Left minus right side of the equations is zero in a motion, by Lagrange's equations or by the ropes'
/// tensions.
void equations(Table& in_motion, const Samples& motions) {
  const auto claim = in_motion.over(motions);
  const Form zero{"zero", [](const auto&) { return 0.0; }};
  const std::string balance =
      R"(left side less right side, with $\ddot y$ by Lagrange's equations or by the ropes' tensions)";
  const std::string right_y2 = "=m_2g-c_1(K_1-L_1+y_2)", right_y3 = "=m_3g-c_2(K_2-L_2+y_3-2y_2)$",
                    printed_y2 = "$" + momenta(R"(\ddot y)")[0] + right_y2,
                    printed_y3 = R"($m_3\ddot y_3+I_2R_2^2(\ddot y_3-\ddot y_2))" + right_y3;
  claim("equation_y2", 2547,
        R"($m_2\ddot y_2+(I_1/R_1^2)\ddot y_2+(I_2/R_2^2)(\ddot y_2-\ddot y_3))" + right_y2 +
            "$, the bar of $I_1/R_1^2$ restored",
        {.quantity = balance,
         .truth = zero,
         .printed = printed_y2 + "$",
         .corrected = printed_y2 + "+2c_2(K_2-L_2+y_3-2y_2)$",
         .root = "the second spring on the pulley",
         .why = of_frequencies()});
  claim("equation_y3", 2553, printed_y3,
        {.quantity = balance,
         .truth = zero,
         .printed = printed_y3,
         .meant = "$" + momenta(R"(\ddot y)")[1] + right_y3,
         .why = filled(
             "The bar of $I_2/R_2^2$ is lost in the text at hand; line 2511, from which the term is taken, "
             "shows it. The default pulley would count as @3 kg m$^4$ at its rim instead of @2 kg.",
             {0.25 * 0.25, standard.inertia_over_square_2()})});
}

void state(Claims& claims, Table& table, Table& in_motion, const Samples& samples) {
  Samples motions;
  for (const Sample& s : samples)
    for (const Pair& a : {s.by_lagrange(), s.by_tensions()}) motions.push_back(s.in_motion(a));
  kinematics(claims, table, samples);
  energies(table, samples);
  forces(claims, table, in_motion, samples, motions);
  equations(in_motion, motions);
}

}  // namespace

std::vector<Claim> claims(double seed) {
  Claims claims("3.19");
  Table table(claims), in_motion(claims);
  const auto samples = draw<Sample>(200, seed);
  state(claims, table, in_motion, samples);
  compression(table, samples);
  std::vector<Claim> all = claims.in_order();
  for (Claim& claim : all) {
    if (claim.id == "3.19-compression") claim.corrected.checks.push_back(taut());
    if (claim.id == "3.19-equation_y2") claim.corrected.checks.push_back(energy_lost(samples));
  }
  return all;
}

constexpr const char* by_tension = R"(
  set (S1 := depth - y1 - (depth - 2 * y1 - K1 - (y2 - y1))) in *; clearbody S1;
  set (S2 := depth - y2 - (depth - K2 - (y3 - y2 - y2))) in *; clearbody S2;
  unfold Rmin, Rmax; repeat destruct (Rle_dec _ _); try nra; try (field_simplify; nra))";
constexpr const char* by_pull = "unfold Rmin; destruct (Rle_dec _ _) as [|N]; [|destruct N]; interval";

Provable proof_of_stretched(const ForAll<SampleOf>& all) {
  const auto& s = all.any;
  const Two<Shortened> parts = s.of_springs(), lengths = s.springs(s.q), c{s.p.c1, s.p.c2}, L{s.p.L1, s.p.L2};
  Provable proved{"3.19-stretched", all.says};
  for (std::size_t i = 0; i < 2; ++i) {
    const std::string part = parts[i].expression().coq();
    proved.lemmas.push_back(
        {i == 0 ? "first" : "second",
         all.letters,
         all.given,
         {{"(" + part + " < 0 <-> " + above(lengths[i].expression(), L[i].expression()).coq + ")"}},
         "replace (" + part + ") with (" + (-c[i] * (lengths[i] - L[i])).expression().coq() +
             ") by field; intros; nra"});
  }
  return proved;
}

Provables proofs() {
  Claims claims("3.19");
  Table table(claims), in_motion(claims), ropes(claims);
  state(claims, table, in_motion, {});
  compression(ropes, {});
  auto all = for_all<SampleOf>(std::string("field; repeat split; ") + by_positive_terms,
                               "it holds for all pulleys in any motion");
  const auto& p = all.any.p;
  all.given = positive({p.m2, p.m3, p.I1, p.I2, p.R1, p.R2});
  double x = 0.25;
  for (double* letter : letters_of(all.example)) *letter = x += 0.25;
  ForAll<SampleOf> with_springs = all;
  with_springs.given = positive({p.m2, p.m3, p.I1, p.I2, p.R1, p.R2, p.c1, p.c2});
  Provables proved = table.proofs("3.19", all);
  const auto in_motions = [&](const auto& accelerations) {
    ForAll<SampleOf> moving = all;
    moving.any = all.any.in_motion(accelerations(all.any));
    moving.example = all.example.in_motion(accelerations(all.example));
    return in_motion.proofs("3.19", moving);
  };
  Provables again = in_motions([](const auto& s) { return s.by_lagrange(); });
  for (Provable& one : in_motions([](const auto& s) { return s.by_tensions(); })) {
    one.lemmas.push_back(proof_of(again, one.claim).lemmas[0]);
    one.lemmas.back().name += "_by_lagrange";
    proved.push_back(std::move(one));
  }
  const std::string energy = all.any.kinetic()(all.any.q, all.any.v).expression().coq();
  std::vector<Proposition> none;
  for (const char* y : {"y2", "y3"})
    none.push_back({"derivable_pt_lim (fun " + std::string(y) + " => " + energy + ") " + y + " 0"});
  proved.push_back(proof_of_stretched(with_springs));
  with_springs.tactic = by_tension;
  for (Provable& one : ropes.proofs("3.19", with_springs)) {
    one.lemmas.back().tactic = by_pull;
    proved.push_back(std::move(one));
  }
  proved.push_back(
      {"3.19-dT_dy", all.says, {{"printed", all.letters, {}, none, "apply derivable_pt_lim_const"}}});
  return proved;
}

std::vector<Root> roots() {
  const auto depth = [](double lever) { return default_motion({0, shown_after}, lever).back()[0]; };
  const auto up = [](double tension) { return tension / standard.m3 - standard.g; };
  constexpr double pulley = 1, mass = 3;
  return {
      {"the second spring on the pulley",
       filled(
           "By the published equations the small pulley of the default start is @2 m below the ceiling after "
           "@1 s, where it should hang @3 m below it. In both motions all ropes are taut until then.",
           {depth(0), shown_after, depth(2)})},
      {"the small pulley's inertia",
       filled("The default mass starts with an upward acceleration of @3 m/s$^2$; by the published force it "
              "would be @3 m/s$^2$.",
              {up(at_start[3]), up(at_start[2])})},
      {"a rope that pushes",
       filled("Started with @1 m of slack ($K_1=@1$ m), the first spring pushes its rope with @2 N by the "
              "published formula, where it does not pull at all.",
              {loose(), let_loose.K1, let_loose.c1 * loose()})},
      {"a spring that must get shorter",
       filled(
           "When the small pulley goes down by @1 m and the mass by @1 m, the second spring gets @1 m longer.",
           {pulley, mass, mass - 2 * pulley})}};
}

}  // namespace oddity::ex03_19
