// The claims of exercise 3.9. The equations are derived from L = m|x'|^2/2 - c|x|^2/2 and Rayleigh's
// dissipation a|x'|^2/2 by dual numbers. The published solutions are compared with the differential
// equation's Taylor series, which knows no roots, and arrivals are found along it. In proofs the solutions
// are substituted in the equation. Letters: r1 > r2 are the real roots of m r^2 + a r + c; alpha, beta are
// the parts of the complex ones.

#include <algorithm>
#include <cmath>
#include <concepts>
#include <iterator>
#include <limits>
#include <numbers>

#include "chapters/03_rigid_body_motion/09_damped_ball/damped_ball.hpp"
#include "chapters/03_rigid_body_motion/shared/lagrange.hpp"
#include "chapters/provable_claims.hpp"
#include "reference/text.hpp"
#include "solvers/dual.hpp"
#include "solvers/roots.hpp"

namespace oddity::ex03_09 {

using namespace damped_ball;
using std::abs, std::sqrt, std::numbers::pi;

// ---- by the equation --------------------------------------------------------------------------------------

/// One coordinate and its rate.
struct Moving {
  double x, rate;
};

/// A coordinate a time later, by the Taylor series of the differential equation, which knows no roots. Its
/// steps are at most half a radian of the undamped spring.
Moving later(const Ball& b, Moving now, double time) {
  const int steps = 1 + static_cast<int>(2 * time * sqrt(b.c / b.m));
  for (int i = 0; i < steps; ++i) {
    Moving term = now;
    for (int n = 1; n < 30; ++n) {
      const double part = time / steps / n;
      term = {part * term.rate, -part * (b.c * term.x + b.a * term.rate) / b.m};
      now.x += term.x, now.rate += term.rate;
    }
  }
  return now;
}

/// Both coordinates at a time.
Pair by_equation(const Ball& b, double t) {
  return {later(b, {b.p1, b.v1}, t).x, later(b, {b.p2, b.v2}, t).x};
}
const std::string series = "the differential equation's Taylor series";

// ---- samples ----------------------------------------------------------------------------------------------

/// exp(alpha t) (K1 cos(beta t) + K2 sin(beta t)).
template <class T, class X>
X oscillation(const T& alpha, const T& beta, const T& k1, const T& k2, const X& t) {
  return exp(alpha * t) * (k1 * cos(beta * t) + k2 * sin(beta * t));
}

/// A ball from p with velocity v, its friction below the critical, and a time.
template <class T>
struct MotionOf : Given<T> {
  T t;
  using Given<T>::m, Given<T>::c, Given<T>::a, Given<T>::p1, Given<T>::p2, Given<T>::v1, Given<T>::v2;

  Letters<T> table() {
    return {{"m", m}, {"c", c}, {"a", a}, {"p_1", p1}, {"p_2", p2}, {"v_1", v1}, {"v_2", v2}, {"t", t}};
  }
  Two<T> p() const { return {p1, p2}; }
  Two<T> v() const { return {v1, v2}; }
  T alpha() const { return -a / (2 * m); }
  T beta() const { return sqrt(4 * m * c - a * a) / (2 * m); }
  /// The solution's K2 of each coordinate; its K1 is p.
  Two<T> k() const { return {(v1 - alpha() * p1) / beta(), (v2 - alpha() * p2) / beta()}; }
  T product_of_p_and_k() const { return p1 * k()[1] - p2 * k()[0]; }
  /// Letters by the equation; in expressions x_1 and x_2 are those of its solution.
  TypesetIn<T> typeset() const {
    const Two<T> rates = lagrange_accelerations(energy(m, c), p(), v(), friction()), x = [this] {
      if constexpr (std::same_as<T, double>)
        return by_equation(*this, t);
      else
        return Two<T>{solution(t)[0].value, solution(t)[1].value};
    }();
    return {
        {R"(\alpha)", alpha()}, {R"(\beta)", beta()}, {"k_1", k()[0]}, {"k_2", k()[1]}, {"x_1", x[0]},
        {"x_2", x[1]},          {"p", p()},           {"v", v()},      {"x", p()},      {R"(\dot x)", v()},
        {R"(\ddot x)", rates},  {"K_1", p()},         {"K_2", k()}};
  }
  /// The solutions' coordinates and their rates.
  Two<Dual<T>> solution(const T& time) const {
    const Dual<T> at(time, T(1));
    return {oscillation(alpha(), beta(), p1, k()[0], at), oscillation(alpha(), beta(), p2, k()[1], at)};
  }
  /// The Lagrangian m|u|^2/2 - c|q|^2/2. With -a and 0 it is minus Rayleigh's dissipation.
  static auto energy(const T& of_u, const T& of_q) {
    return [=]<class X>(const Two<X>& q, const Two<X>& u) {
      return X(of_u / 2) * (u[0] * u[0] + u[1] * u[1]) - X(of_q / 2) * (q[0] * q[0] + q[1] * q[1]);
    };
  }
  Two<T> friction() const { return df_dv(energy(-a, T(0)), p(), v()); }
};
using Motion = MotionOf<double>;

/// A ball at p with velocity v; its friction is a part of the critical one.
Ball ball_of(Random& random, double part, Pair p, Pair v) {
  const double m = random.between(0.3, 3), c = random.between(0.3, 3);
  return {m, c, 2 * sqrt(m * c) * part, p[0], p[1], v[0], v[1]};
}

std::vector<Motion> motions(double seed) {
  std::vector<Motion> all;
  Random random(seed);
  for (int i = 0; i < 200; ++i) {
    const auto p = random.point(2), v = random.point(2);
    const double t = random.between(0.1, 6);
    all.push_back({ball_of(random, random.between(0.05, 0.9), {p[0], p[1]}, {v[0], v[1]}), t});
  }
  return all;
}

/// A motion with v = s p.
template <class T>
struct InLineOf : MotionOf<T> {
  /// Size of the terms that cancel in the products of both pairs (p, k), and of x and p.
  double size() const {
    return 2 * abs(this->p2) *
           (abs(this->p1) + (abs(this->v1) + abs(this->alpha() * this->p1)) / this->beta());
  }
};
using InLine = InLineOf<double>;

std::vector<InLine> in_line(double seed) {
  std::vector<InLine> all;
  Random random(seed);
  for (const Motion& motion : motions(seed)) {
    InLine& s = all.emplace_back(InLine{motion});
    s.p1 = random.magnitude(0.2, 2), s.p2 = random.magnitude(0.2, 2);
    const double rate = random.between(-2, 2);
    s.v1 = rate * s.p1, s.v2 = rate * s.p2;
  }
  return all;
}

/// The characteristic polynomial's coefficients, its roots by the text, any number r, and a time.
template <class T>
struct PolynomialOf {
  T m, c, a, r, t;
  Letters<T> table() {
    return {{"m", m, {0.1, 3}}, {"c", c, {0.1, 3}}, {"a", a, {0.1, 9}}, {"r", r, {-3, 3}}, {"t", t, {0, 2}}};
  }
  TypesetIn<T> typeset() const { return {{R"(\mathrm{Im}\,r)", {root(1)[1], root(-1)[1]}}}; }
  /// Real and imaginary part.
  Two<T> root(double sign, double factor = 4) const {
    const T square = a * a - factor * m * c, size = abs(square);
    return {(-a + sign * sqrt((size + square) / 2)) / (2 * m), sign * sqrt((size - square) / 2) / (2 * m)};
  }
  /// m x'' + a x' + c x of x = e^(rt), over x.
  T of_exponential() const {
    const auto x = [this](const auto& at) { return exp(r * at); };
    return (m * second_derivative(x, t) + a * derivative(x, t) + c * x(t)) / x(t);
  }
  auto sum_and_product(double factor) const {
    const Two<T> x = root(1, factor), y = root(-1, factor);
    return values(x[0] + y[0], x[0] * y[0] - x[1] * y[1], x[1] + y[1], x[0] * y[1] + x[1] * y[0]);
  }
};
using Polynomial = PolynomialOf<double>;

/// A ball whose friction is critical or more, and the constants of its first coordinate.
struct Strong : Ball {
  double r1, r2, k1, k2, t;

  /// `part`: its friction in parts of the critical one.
  Strong(const Ball& ball, double part, double time = 0) : Ball(ball), t(time) {
    const double w = sqrt(c / m * (part * part - 1));
    r1 = -a / (2 * m) + w, r2 = -a / (2 * m) - w;
    k1 = (v1 - r2 * p1) / (r1 - r2), k2 = p1 - k1;
  }
  TypesetLetters typeset() const {
    return {{"m", m}, {"c", c},    {"a", a},    {"v", v1},   {"p", p1},
            {"t", t}, {"r_1", r1}, {"r_2", r2}, {"K_1", k1}, {"K_2", k2}};
  }
  /// Changes of the coordinate's sign until long after the last that there may be.
  int passages() const {
    int count = 0;
    Moving now{p1, v1};
    for (int i = 0; i < 300; ++i) {
      const double before = now.x;
      now = later(*this, now, 0.1 * sqrt(m / c));
      count += before * now.x < 0;
    }
    return count;
  }
  /// Whether the coordinate's sign changes within a billionth of this time.
  bool passes_at(double time) const {
    constexpr double billionth = 1e-9;
    const auto x = [&](double part) { return later(*this, {p1, v1}, part * time).x; };
    return x(1 - billionth) * x(1 + billionth) < 0;
  }
  double passage() const { return r1 == r2 ? -1 / (v1 / p1 - r1) : std::log(-k2 / k1) / (r1 - r2); }
  /// At the origin, in |p| a second.
  double speed() const { return abs(later(*this, {p1, v1}, passage()).rate / p1); }
};

/// Balls from any place with any velocity, the last one with a double root.
std::vector<Strong> strong(double seed) {
  std::vector<Strong> all;
  Random random(seed);
  for (int i = 0; i < 200; ++i) {
    const double part = random.between(1.1, 3), p = random.between(-2, 2), v = random.between(-2, 2);
    all.emplace_back(ball_of(random, part, {p, 0}, {v, 0}), part, random.between(0.1, 5));
  }
  all.push_back({{1, 4, 4, 1, 0.5, 0, 1.5}, 1, 1});
  return all;
}

/// Balls thrown from 1 towards the origin or away; their speed is on either side of both roots.
std::vector<Strong> thrown(double seed) {
  std::vector<Strong> all;
  Random random(seed);
  for (int i = 0; i < 200; ++i) {
    const double part = random.unit() < 0.2 ? 1 : random.between(1.02, 3);
    Ball ball = ball_of(random, part, {1, 0}, {0, 0});
    const double fast = -Strong(ball, part).r2;
    ball.v1 = -fast * (random.unit() < 0.5 ? random.between(1.05, 3) : random.between(-1, 0.95));
    all.emplace_back(ball, part);
  }
  return all;
}
/// A ball thrown towards the origin, which it passes.
const Strong throw_in{{1, 4, 5, 1, 2, -9, -18}, 1.25};

/// Strong friction, and stronger friction.
struct Frictions {
  double a, b;
  explicit Frictions(Random& random) : a(random.between(4.5, 60)), b(a * random.between(1.05, 3)) {}
  TypesetLetters typeset() const {
    return {{"a", a}, {"b", b}, {"x_a", left_after(a, seconds)}, {"x_b", left_after(b, seconds)}};
  }
  static constexpr double m = 1, c = 4, seconds = 5, nearly = 0.01;
  /// Distance from the origin of a ball some time after its release at rest.
  static double left_after(double friction, double t) {
    return abs(OneForm<double>{{m, c, friction, 1, 1, 0, 0}}.at(t)[0]);
  }
  /// The time to come near the origin, for strong friction.
  static double home_after(double friction) {
    return brent([=](double t) { return left_after(friction, t) - nearly; }, 0, 1000, 0).value;
  }
};

/// A coordinate when it is zero, and the uncertainty of this time.
template <class T>
struct AtZeroOf {
  T alpha, beta, p, v, t;
  double known = 0;

  std::array<T*, 5> quantities() { return {&alpha, &beta, &p, &v, &t}; }
  TypesetIn<T> typeset() const {
    return {{R"(\alpha)", alpha}, {R"(\beta)", beta}, {"p_1", p}, {"v_1", v}, {"t", t}};
  }
  template <class X>
  X at(const X& time) const {
    return oscillation(alpha, beta, p, T((v - alpha * p) / beta), time);
  }
  /// lambda (-sin(beta t), cos(beta t)), which makes x' = beta e^(alpha t) lambda.
  Two<T> turned() const {
    const T lambda = derivative([&](const auto& time) { return at(time); }, t) / (beta * exp(alpha * t));
    return {-lambda * sin(beta * t), lambda * cos(beta * t)};
  }
  Tolerance tolerance(double size) const {
    return {beta * known * size + rounding(size).allowed,
            "the passage's uncertainty, as an angle, and 64 roundings"};
  }
};
using AtZero = AtZeroOf<double>;

struct Tables {
  Claims& all;
  std::vector<Motion> motions = {};
  std::vector<InLine> motions_in_line = {};
  std::vector<Polynomial> polynomials = {};
  std::vector<AtZero> at_zeros = {};
  ProvableClaims<MotionOf> motion{all};
  ProvableClaims<InLineOf> in_line{all};
  ProvableClaims<PolynomialOf> polynomial{all};
  ProvableClaims<AtZeroOf> zeros{all};
};

template <template <class> class Of>
const ProvableFormula<Of> zero{"zero", []<class T>(const Of<T>&) { return T(0); }};
const std::string of_zero = "a factor of zero may have any size and sign";

// ---- texts ------------------------------------------------------------------------------------------------

const std::string

    two_exponentials = "$K_1e^{r_1t}+K_2e^{r_2t}$",
    damped_oscillation = R"(e^{\alpha t}\left(p\cos\beta t+\frac{v-\alpha p}\beta\sin\beta t\right))",
    as_cotangent = R"($t=\frac1\beta\left(\frac\pi2+\tan^{-1}\frac{v_1-\alpha p_1}{\beta p_1}\right)$)",
    of_products =
        R"($t=\frac1\beta\left(\frac\pi2+\tan^{-1}\frac{(v-\alpha p)\cdot p}{\beta\,p\cdot p}\right)$)",
    principal = R"($t=\frac1\beta\tan^{-1}\frac{-\beta p_1}{v_1-\alpha p_1}$)";

// ---- the equation and its solutions -----------------------------------------------------------------------

void equations(Tables& tables) {
  const auto claim = tables.motion.over(tables.motions);
  claim("generalized_forces", 1439,
        R"(The generalized forces of spring and friction are $-cx-a\dot x$ for each coordinate)",
        {"the spring's potential and Rayleigh's dissipation by dual numbers",
         [](const auto& s) {
           const auto spring = df_dq(s.energy(s.m, s.c), s.p(), s.v()), slowing = s.friction();
           return values(spring[0] + slowing[0], spring[1] + slowing[1]);
         }},
        R"($-cx-a\dot x$)", R"($(F_{x_1},F_{x_2})$)");
  claim("equations", 1449, R"(Each coordinate obeys $m\ddot x+a\dot x+cx=0$)", zero<MotionOf>,
        R"($m\ddot x+a\dot x+cx=0$)", R"($m\ddot x+a\dot x+cx$, the accelerations by Lagrange's equations)",
        of_zero);
}

void characteristic_roots(Tables& tables) {
  const auto claim = tables.polynomial.over(tables.polynomials);
  claim(
      "characteristic_polynomial", 1453,
      "The characteristic polynomial is $mr^2+ar+{}=0$ (our reading of the dangling plus: nothing follows it)",
      {.quantity = "the polynomial at any $r$",
       .truth = {R"($e^{-rt}(m\ddot x+a\dot x+cx)$ of $x=e^{rt}$, by dual numbers)",
                 [](const auto& s) { return s.of_exponential(); }},
       .printed = "$mr^2+ar$",
       .meant = "$mr^2+ar+c$",
       .kind = Fault::formula,
       .why = "The last coefficient, $c$, is missing after its plus sign; the roots that follow show it."});
  const auto roots_with = [](std::string text, double factor) -> ProvableFormula<PolynomialOf> {
    return {std::move(text), [=](const auto& s) { return s.sum_and_product(factor); },
            [](const Polynomial& s) { return s.a * s.a / (s.m * s.m) + 1; }};
  };
  claim("roots", 1455, R"(The roots of the characteristic polynomial are $(-a\pm\sqrt{a^2-4mc})/(2m)$)",
        {.quantity = "the roots' sum and product, real and imaginary parts",
         .truth = {"the coefficients: $-a/m$ and $c/m$, both real",
                   [](const auto& s) { return values(-s.a / s.m, s.c / s.m, 0, 0); }},
         .printed = roots_with(R"(of $(-a\pm\sqrt{a^2-4mc})/(2m)$)", 4),
         .near_misses = {roots_with(R"(of $(-a\pm\sqrt{a^2-2mc})/(2m)$)", 2)}});
}

void solutions(Claims& claims, std::vector<Polynomial> polynomials, double seed) {
  const auto is_as_told = [](const Polynomial& s, double sign) {
    const auto [re, im] = s.root(sign);
    // the roundings of -a and the square root, which may cancel, change r by roundings of a/m; the slope is
    // at most a
    const double terms = s.m * (re * re + im * im) + s.a * std::hypot(re, im) + s.c + s.a * s.a / s.m,
                 off = std::hypot(s.m * (re * re - im * im) + s.a * re + s.c, (2 * s.m * re + s.a) * im);
    return off <= rounding(terms).allowed && re < 0 && (im == 0) == (s.a * s.a - 4 * s.m * s.c >= 0);
  };
  polynomials.push_back({1, 4, 4, 0, 0});  // a double root
  claims.statement<Polynomial>(
      "negative_roots", 1461,
      R"(Both roots are real and negative when $a^2-4mc\ge0$, and complex with negative real parts when )"
      R"($a^2-4mc<0$)",
      polynomials,
      {.printed = {"the text's roots are zeros of the polynomial, and are such",
                   [=](const Polynomial& s) { return is_as_told(s, 1) && is_as_told(s, -1); }},
       .near_misses = {Statement<Polynomial>{R"($\mathrm{Im}\,r=0$)"}}});

  const auto two_forms = [](std::string text, double part) -> Formula<Strong> {
    return {std::move(text), [part](const Strong& s) {
              return s.r1 == s.r2 ? (s.p1 + (s.v1 - part * s.r1 * s.p1) * s.t) * std::exp(s.r1 * s.t)
                                  : s.k1 * std::exp(s.r1 * s.t) + s.k2 * std::exp(s.r2 * s.t);
            }};
  };
  std::vector<Strong> balls = strong(seed);
  claims.over(balls)(
      "two_exponentials", 1469, "The general solution for real roots is $x=K_1e^{r_1t}+K_2e^{r_2t}$",
      {.quantity = "$x$, $K_1$ and $K_2$ by $x(0)=p$ and $\\dot x(0)=v$",
       .truth = {series, [](const Strong& s) { return by_equation(s, s.t)[0]; }},
       .printed = {two_exponentials},
       .corrected = two_forms(
           R"($K_1e^{r_1t}+K_2e^{r_2t}$ for $r_1\ne r_2$, and $(K_1+K_2t)\,e^{rt}$ for a double root $r$)",
           1),
       .in_view = {"where the roots differ", [](const Strong& s) { return s.r1 != s.r2; }},
       .near_misses = {two_forms(R"($(p+vt)\,e^{rt}$ for a double root $r$)", 0)},
       .root = "the double root",
       .why =
           R"(Case 1 includes $a^2=4mc$, where both exponentials are the same function: solving for $K_1$ and )"
           R"($K_2$ divides by $r_1-r_2=0$. With nearly equal roots they are right, but large and of opposite )"
           R"(sign, and their sum loses digits (see `near_critical`).)"});

  balls.pop_back();
  for (Strong& s : balls) s.t = -40 / s.r1;
  claims.statement<Strong>(
      "limit", 1471,
      "With real roots $x=K_1e^{r_1t}+K_2e^{r_2t}$ tends to zero, whatever $K_1$ and $K_2$ (our check: at "
      "$t=40/|r_1|$)",
      balls,
      {.printed = {"$|K_1e^{r_1t}+K_2e^{r_2t}|<10^{-12}$"},
       .near_misses = {{"$|K_1e^{-r_1t}+K_2e^{r_2t}|<10^{-12}$"}}});

  const auto passes_once = [](std::string text, double Strong::*root, int sign) -> Statement<Strong> {
    return {std::move(text), [=](const Strong& s) {
              const bool passes = s.v1 < s.*root * s.p1;
              return s.passages() == passes && (!passes || s.passes_at(sign * s.passage()));
            }};
  };
  claims.statement<Strong>(
      "overdamped_never_arrives", 1477,
      R"(With real roots the ball reaches the origin after an infinite time (our reading: and, for $p\ne0$, not )"
      R"(before))",
      thrown(seed),
      {.printed = {"$|x|>0$ for all $t$", [](const Strong& s) { return s.passages() == 0; }},
       .corrected = passes_once(
           R"(with $v=-up$, $p\ne0$, the ball passes the origin once for $u>|r_2|$, at )"
           R"($e^{(r_1-r_2)t}=-K_2/K_1$, or at $t=1/(u+r)$ for a double root $r$, and else never)",
           &Strong::r2, 1),
       .near_misses = {passes_once("at $e^{(r_1-r_2)t}=-K_1/K_2$", &Strong::r2, -1),
                       passes_once("once for $u>|r_1|$, else never", &Strong::r1, 1)},
       .kind = Fault::counterexample,
       .root = "a fast throw",
       .why = filled(
           R"(The ball passes if $v$ points to the origin and $|v|>|r_2||p|$. For $m=@1$, $c=@1$, $a=@1$ the )"
           R"(roots are $@1$ and $@1$; from $p$ with $v=@1p$, $x=(K_1e^{r_1t}+K_2e^{r_2t})\,p$ with $K_1=@3$ )"
           R"(and $K_2=@3$ is zero at $t=\ln(-K_2/K_1)/(r_1-r_2)=@3$.)",
           {throw_in.m, throw_in.c, throw_in.a, throw_in.r1, throw_in.r2, throw_in.v1 / throw_in.p1,
            throw_in.k1 / throw_in.p1, throw_in.k2 / throw_in.p1, throw_in.passage()})});

  claims.statement<Frictions>(
      "larger_friction_sooner", 1477,
      filled(
          "With real roots, the larger the friction, the sooner the ball is nearly at the origin. (Our check: "
          "$x_a$ is the distance left after @1 s from rest with friction $a$; $b>a$, $m=@1$, $c=@1$.)",
          {Frictions::seconds, Frictions::m, Frictions::c}),
      draw<Frictions>(100, seed),
      {.printed = {"$x_b<x_a$"},
       .corrected = {"$x_b>x_a$"},
       .near_misses = {{"$x_b>2x_a$"}},
       .kind = Fault::counterexample,
       .root = "too much friction",
       .why =
           R"(Beyond critical damping the slow root $r_1=-2c/(a+\sqrt{a^2-4mc})$ goes to zero as $-c/a$: )"
           R"(the spring draws the ball through honey. The rate of decay is greatest at $a=2\sqrt{mc}$.)"});
}

void oscillations(Tables& tables) {
  const auto claim = tables.motion.over(tables.motions);
  const std::string rate = R"(e^{\alpha t}(-\beta K_1\sin\beta t+\beta K_2\cos\beta t))"
                           R"(+\alpha e^{\alpha t}(K_1\cos\beta t+K_2\sin\beta t)$)";
  claim("derivative", 1487, R"($\dot x=)" + rate,
        {R"($x=e^{\alpha t}(K_1\cos\beta t+K_2\sin\beta t)$ by dual numbers)",
         [](const auto& s) {
           const auto [x1, x2] = s.solution(s.t);
           return values(x1.slope, x2.slope);
         }},
        "$" + rate);
  claim("start_values", 1489, R"($x(0)=p$ and $\dot x(0)=v$ lead to $p=K_1$, $v=\beta K_2+\alpha K_1$)",
        {"$x$ by dual numbers",
         []<class T>(const MotionOf<T>& s) {
           const auto [x1, x2] = s.solution(T(0));
           return values(x1.value, x2.value, x1.slope, x2.slope);
         }},
        R"($(K_1,\ \beta K_2+\alpha K_1)$)", R"($(x(0),\dot x(0))$)");
  claim("constants", 1489,
        R"(The solution of $p=K_1$, $v=\beta K_2+\alpha K_1$ is $K_1=p$, $K_2=(v-\alpha p)/\beta$)",
        {R"(the equations $x(0)=p$, $\dot x(0)=v$, by dual numbers)",
         []<class T>(const MotionOf<T>& s) {
           const Dual<T> start(T(0), T(1));
           const auto c = oscillation(s.alpha(), s.beta(), T(1), T(0), start),
                      w = oscillation(s.alpha(), s.beta(), T(0), T(1), start);
           const T determinant = c.value * w.slope - w.value * c.slope;
           const auto k1 = [&](const T& p, const T& v) { return (p * w.slope - w.value * v) / determinant; };
           const auto k2 = [&](const T& p, const T& v) { return (c.value * v - p * c.slope) / determinant; };
           return values(k1(s.p1, s.v1), k1(s.p2, s.v2), k2(s.p1, s.v1), k2(s.p2, s.v2));
         }},
        R"($(p,\ (v-\alpha p)/\beta)$)", "$(K_1,K_2)$");
  tables.all.over(tables.motions)(
      "damped_oscillation", 1491,
      R"(For complex roots $x=e^{\alpha t}\big(p\cos\beta t+\frac{v-\alpha p}\beta\sin\beta t\big)$, )"
      R"(with $\alpha=-a/(2m)$ and $\beta=\sqrt{4mc-a^2}/(2m)$)",
      {series, [](const Motion& s) { return by_equation(s, s.t); }}, {"$" + damped_oscillation + "$"}, "$x$");
}

// ---- the arrival ------------------------------------------------------------------------------------------

/// A ball below the critical friction at its passage: the first positive time at the origin, found by
/// marching along p for half a turn and by Brent-Dekker. Its uncertainty in double is that of roundings of
/// the terms that cancel there, divided by the slope. No number if the ball does not come there.
struct Start {
  Motion motion;
  Tolerance known = exact();

  explicit Start(const Ball& b) : motion{b, std::numeric_limits<double>::quiet_NaN()} {
    const double rate = sqrt(b.c / b.m), step = 0.5 / rate, half_turn = pi / motion.beta();
    const auto along = [&](double t) {
      return later(b, {b.p1 * b.p1 + b.p2 * b.p2, b.p1 * b.v1 + b.p2 * b.v2}, t);
    };
    double low = 0;
    for (; along(low).x * along(low + step).x > 0; low += step)
      if (low > half_turn) return;
    const double high = brent([&](double t) { return along(t).x; }, low, low + step, 0).value;
    const double terms =
                     abs(b.p1) * (abs(b.p1) + abs(b.v1) / rate) + abs(b.p2) * (abs(b.p2) + abs(b.v2) / rate),
                 across = later(b, {0, b.p1 * b.v2 - b.p2 * b.v1}, high).x;
    if (abs(across) > rounding(terms).allowed) return;
    motion.t = high, known = rounding(high + terms / abs(along(high).rate));
  }
  TypesetLetters typeset() const { return typeset_of(motion); }
  Tolerance tolerance(double) const { return known; }
};
/// The ball of the examples, with little friction.
Start weak(double p1, double p2, double v1, double v2) { return Start({1, 4, 0.4, p1, p2, v1, v2}); }

/// Balls with p and v parallel in all directions. Some are on an axis, where the other coordinate is zero for
/// ever. For some v = alpha p.
std::vector<Start> in_all_directions(double seed) {
  std::vector<Start> all;
  Random random(seed);
  for (int i = 0; i < 120; ++i) {
    const double angle = random.between(0, 2 * pi), size = random.between(0.2, 2),
                 p1 = i % 3 == 0 ? 0 : size * std::cos(angle), p2 = i % 3 == 1 ? 0 : size * std::sin(angle);
    Ball ball = ball_of(random, random.between(0.03, 0.95), {p1, p2}, {});
    const double s = i % 5 == 0 ? Motion{ball, 0}.alpha() : random.between(-2, 2);
    ball.v1 = s * p1, ball.v2 = s * p2;
    all.emplace_back(ball);
  }
  return all;
}

void parallel(Tables& tables) {
  const auto claim = tables.motion.over(tables.motions);
  const auto in_line = tables.in_line.over(tables.motions_in_line);
  claim(
      "parallel", 1515,
      R"($p$ and $(v-\alpha p)/\beta$ are parallel exactly when $p$ and $v$ are, as the products of both pairs )"
      R"(differ by the factor $\beta\ne0$ alone (the text's parenthesis does not close))",
      {R"($\beta\,p\times(v-\alpha p)/\beta$)",
       [](const auto& s) { return s.beta() * s.product_of_p_and_k(); }},
      "$p_1v_2-p_2v_1$", R"($\beta$ times the vectors' product)");
  in_line("one_equation", 1515,
          R"(With complex roots, and $p$ and $v$ parallel, the two conditions are one equation: the pairs )"
          R"($(p_i,\ (v_i-\alpha p_i)/\beta)$ of $i=1$ and 2 are parallel)",
          zero<InLineOf>, R"($p_1\frac{v_2-\alpha p_2}\beta-p_2\frac{v_1-\alpha p_1}\beta=0$)",
          R"(the pairs' product)", of_zero);
  in_line(
      "pulled_directly", 1525,
      "With complex roots, and $p$ and $v$ parallel, the ball is pulled directly to the origin (our reading: it "
      "stays on the line through $p$ and the origin)",
      zero<InLineOf>, "$x_1p_2-x_2p_1=0$", R"($x\times p$ at any time, $x$ by the equation's Taylor series)",
      of_zero);
  claim("both_zero_parallel", 1541,
        R"(Where both coordinates are zero, $p$ and $(v-\alpha p)/\beta$ are parallel (the text has `beta` )"
        R"(for the letter))",
        {"the vectors' product", [](const auto& s) { return s.product_of_p_and_k(); }},
        R"($(p_1\cos\beta t+k_1\sin\beta t)(k_2\cos\beta t-p_2\sin\beta t))"
        R"(-(p_2\cos\beta t+k_2\sin\beta t)(k_1\cos\beta t-p_1\sin\beta t)$)",
        R"($p_1k_2-p_2k_1$, $k=(v-\alpha p)/\beta$)");
  claim(
      "not_parallel_never", 1541,
      R"(With complex roots, and $p$ and $v$ not parallel, the ball never reaches the origin in finite time )"
      R"((our check: $x_1\dot x_2-x_2\dot x_1$, which is zero there, is $e^{-at/m}(p_1v_2-p_2v_1)\ne0$))",
      {"the closed form, differentiated by dual numbers",
       [](const auto& s) {
         const auto [x1, x2] = s.solution(s.t);
         return x1.value * x2.slope - x2.value * x1.slope;
       }},
      "$e^{-at/m}(p_1v_2-p_2v_1)$", R"($x_1\dot x_2-x_2\dot x_1$ at $t$)");
}

void at_zeros(Tables& tables) {
  const auto claim = tables.zeros.over(tables.at_zeros);
  claim(
      "arrival_conditions", 1501,
      R"(With complex roots the ball is at the origin where $p_i\cos\beta t+\frac{v_i-\alpha p_i}\beta\sin\beta t=0$ )"
      R"(for $i=1$ and 2, as the exponential is not zero for finite time)",
      zero<AtZeroOf>, R"($p_1\cos\beta t+\frac{v_1-\alpha p_1}\beta\sin\beta t=0$)",
      "either left side, named the first, where the integrated motion is at the origin", of_zero);
  const Motion b = weak(1, 0, 0, 0).motion;
  claim(
      "dot_product", 1531,
      R"(Where $x_1$ is zero, $(\cos\beta t,\ \sin\beta t)\cdot(p_1,\ (v_1-\alpha p_1)/\beta)=0$ (the text has $i$ )"
      R"(for 1 and 2))",
      {.quantity = R"(the pair's product with $(\cos\beta t,\ \sin\beta t)$)",
       .truth = zero<AtZeroOf>,
       .printed = R"($(\cos\beta t,\ \sin\beta t)\cdot(p_1,\ v_1-\alpha p_1\beta)=0$)",
       .meant = R"($(\cos\beta t,\ \sin\beta t)\cdot(p_1,\ (v_1-\alpha p_1)/\beta)=0$)",
       .changes_that_hold = of_zero,
       .why = filled(
           "The fraction bar is lost here and in line 1537; lines 1505 and 1511 show it. For $m=@1$, $c=@1$, "
           "$a=@1$ and $p=@1$ at rest the pair is $(@1,@2)$, and $(@1,@2)$ with the product.",
           {b.m, b.c, b.a, b.p1, b.p1, -b.alpha() * b.p1 / b.beta(), b.p1, -b.alpha() * b.p1 * b.beta()})});
  claim(
      "turned_pair", 1537,
      R"(Where $x_1$ is zero, $(p_1,\ (v_1-\alpha p_1)/\beta)=\lambda_1(-\sin\beta t,\ \cos\beta t)$ (the text has $i$ )"
      R"(for 1 and 2))",
      {.quantity = "the pair",
       .truth = {R"($\lambda_1(-\sin\beta t,\ \cos\beta t)$, $\lambda_1=\dot x_1/(\beta e^{\alpha t})$)",
                 [](const auto& s) { return s.turned(); }},
       .printed = R"($(p_1,\ v_1-\alpha p_1\beta)$)",
       .meant = R"($(p_1,\ (v_1-\alpha p_1)/\beta)$)",
       .why = "The fraction bar is lost here and in line 1531; lines 1505 and 1511 show it."});
}

void arrivals(Claims& claims, double seed) {
  const std::vector<Start> directions = in_all_directions(seed);
  const auto moves_along_1 = [](const Start& s) { return s.motion.p1 != 0; };
  std::vector<Start> aslant;
  std::ranges::copy_if(directions, std::back_inserter(aslant), moves_along_1);
  const Formula<Start> integrated{"the integrated motion's first sign change along $p$, by Brent-Dekker",
                                  [](const Start& s) { return s.motion.t; }};
  const std::string when = "first time at the origin";
  claims.over(directions)(
      "first_equation_suffices", 1515,
      R"(With complex roots, and $p\ne0$ and $v$ parallel, the first condition can be solved for the time (our )"
      R"(reading: the first $t>0$, by the inverse cotangent))",
      {.quantity = when,
       .truth = integrated,
       .printed = {as_cotangent},
       .corrected = {of_products},
       .in_view = {"where $p_1$ is not zero", moves_along_1},
       .root = "the first equation alone",
       .why =
           R"(Where $p_1=v_1=0$ the first condition reads $0=0$ and does not determine the time. With the )"
           R"(products by $p\ne0$ no direction is special.)"});
  claims.over(aslant)(
      "arrival_time", 1517,
      "With complex roots, and $p$ and $v$ parallel, $p_1\\ne0$, the ball is at the origin at " + principal +
          " (our reading: the principal value, and the first $t>0$)",
      {.quantity = when,
       .truth = integrated,
       .printed = {principal},
       .corrected = {as_cotangent},
       .root = "the arctangent's branch",
       .why =
           R"(The principal value is negative whenever $(v_1-\alpha p_1)/p_1>0$, which includes every ball let )"
           R"(go at rest or moving away. The first arrival is $\pi/\beta$ later.)"});
  claims.statement<Start>(
      "arrival_quotient", 1517,
      R"(With complex roots, and $p$ and $v$ parallel, $p_1\ne0$, the quotient in the arrival's arctangent is a )"
      R"(number, as its denominator is not zero)",
      aslant,
      {.printed = {R"($v_1-\alpha p_1\ne0$)"},
       .corrected = {as_cotangent},
       .in_view =
           {R"(where the integrated motion is not at the origin at $\pi/(2\beta)$, so that $v_1\ne\alpha p_1$)",
            [](const Start& s) { return abs(s.motion.t - pi / (2 * s.motion.beta())) > s.known.allowed; }},
       .near_misses = {{R"($t=\frac1\beta\left(\frac\pi2+\tan^{-1}\frac{v_1}{\beta p_1}\right)$)"}},
       .kind = Fault::left_out,
       .root = "a zero denominator",
       .why =
           R"(For $v_1=\alpha p_1$ the denominator is zero: $x$ is a pure cosine except for its decay, and the )"
           R"(ball arrives at $t=\pi/(2\beta)$. The inverse cotangent $\frac\pi2+\tan^{-1}$ divides by $\beta p_1$, )"
           R"(and needs no $\pi/\beta$ to be added either.)"});

  claims.statement<Start>(
      "finite_time", 1525,
      R"(With complex roots, and $p\ne0$ and $v$ parallel, the ball reaches the origin in finite time. (Our )"
      R"(check: $t$ is the first time when both coordinates of the integrated motion are zero.))",
      directions, {.printed = {R"($0<t<\pi/\beta$)"}, .near_misses = {{R"($0<t<\pi/(2\beta)$)"}}});
  const Start away = weak(1, 2, 1, 2), at_rest = weak(1, 0, 0, 0);
  std::vector<Start> arriving = directions;
  for (const Start& start : {away, at_rest, weak(1, 2, -1, -2), weak(1, 2, 1, 1), weak(1, 2, -1, -1)})
    if (std::isfinite(start.motion.t)) arriving.push_back(start);
  claims.statement<Start>(
      "velocity_points_to_origin", 1525,
      "With complex roots, a ball that reaches the origin has a velocity that points to the origin at the start",
      arriving,
      {.printed = {R"($p\cdot v<0$)"},
       .corrected = {"$p_1v_2=p_2v_1$"},
       .near_misses = {{R"($p\cdot v\le0$)"}},
       .kind = Fault::counterexample,
       .root = "a ball that turns back",
       .why =
           R"(Parallel to $p\ne0$ is enough, in either direction or with $v=0$: a ball that moves straight away )"
           R"(from the origin turns round and comes back through it.)"});
}

constexpr auto provable_sections = {equations, characteristic_roots, oscillations, parallel, at_zeros};

std::vector<Claim> claims(double seed) {
  Claims all("3.9");
  Tables tables{all, motions(seed), in_line(seed), draw<Polynomial>(300, seed)};
  for (const auto& [x, known] : in_all_directions(seed))
    for (std::size_t i = 0; i < 2; ++i)
      tables.at_zeros.push_back({x.alpha(), x.beta(), x.p()[i], x.v()[i], x.t, known.allowed});
  for (auto* section : provable_sections) section(tables);
  solutions(all, tables.polynomials, seed);
  arrivals(all, seed);
  std::vector<Motion> late = tables.motions;
  for (Motion& s : late) s.t = -40 / s.alpha();
  all.statement<Motion>(
      "infinite_time", 1541,
      R"(With complex roots, and $p$ and $v$ not parallel, the ball reaches the origin in infinite time, since )"
      R"($e^{\alpha t}$ tends to zero for $\alpha<0$ (our check: at $t=40/|\alpha|$))",
      late,
      {.printed = {"$|" + damped_oscillation + "|<10^{-12}$"},
       .near_misses = {{R"($|p\cos\beta t+\frac{v-\alpha p}\beta\sin\beta t|<10^{-12}$)"}}});
  return all.in_order();
}

namespace {

// ---- proofs -----------------------------------------------------------------------------------------------

/// Proofs of the claims on zeros of a coordinate. At the example v = alpha p, so that it is zero at pi/(2
/// beta).
Provables proofs_at_zeros(const ProvableClaims<AtZeroOf>& table) {
  auto zeros =
      for_all<AtZeroOf>({"alpha", "beta", "p", "v", "t"}, "first [pairing | turned_pair alpha beta p v t]",
                        "it holds wherever a coordinate is zero", {-1, 2, 1, -1, pi / 4});
  zeros.given = {not_zero(zeros.any.beta.expression()), zeros.any.at(zeros.any.t).expression() == 0};
  const AtZeroOf<Shortened> example{-1, 2, 1, -1, pi / 4};
  Provables all = table.proofs("3.9", zeros);
  for (Provable& proof : all)
    for (Lemma& lemma : proof.lemmas)
      if (lemma.name == "printed_differs")
        lemma.follows.push_back(near(example.at(example.t).expression(), 0, 1e-10));
  return all;
}

/// Proofs that coordinates are zero at the corrected times, which are within half a turn.
Provables proofs_of_arrivals() {
  const auto one = lettered<AtZeroOf>({"alpha", "beta", "p", "v", "t"});
  const Shortened p1 = Shortened::letter("p1"), p2 = Shortened::letter("p2"), s = Shortened::letter("s");
  const auto arrives = [&](const std::string& reading, const std::string& letters, const Proposition& away,
                           const Shortened& time, const std::vector<Two<Shortened>>& starts) -> Lemma {
    Lemma lemma{reading, letters, {positive({one.beta})[0], away}, {}, "arriving beta"};
    for (const auto& [p, v] : starts) {
      const AtZeroOf<Shortened> start{one.alpha, one.beta, p, v, time};
      lemma.follows.push_back(start.at(time).expression() == 0);
    }
    for (const Proposition& within : positive({time, pi_of<Shortened>() / one.beta - time}))
      lemma.follows.push_back(within);
    return lemma;
  };
  const TypesetIn<Shortened> in_line{
      {R"(\alpha)", one.alpha}, {R"(\beta)", one.beta}, {"p", {p1, p2}}, {"v", {s * p1, s * p2}}, {"t", 0}};
  const Shortened of_both = recorded_text(of_products, in_line)[0];
  const auto both_arrive = [&](const std::string& claim, const std::string& reading) -> Provable {
    return {claim,
            "both coordinates are zero at the corrected time, between 0 and pi/beta",
            {arrives(reading, "(alpha beta p1 p2 s : R)", positive({p1 * p1 + p2 * p2})[0], of_both,
                     {{p1, s * p1}, {p2, s * p2}})}};
  };
  const auto time = [](const std::string& text, const AtZeroOf<Shortened>& x) -> Shortened {
    return recorded_text(text, x.typeset())[0];
  };
  const Shortened first = time(principal, {-1, 2, 1, 0, 0});
  return {
      {"3.9-arrival_time",
       "the coordinate is zero at the corrected time, between 0 and pi/beta; the printed one is negative at "
       "an example",
       {arrives("corrected", "(alpha beta p v : R)", not_zero(one.p.expression()), time(as_cotangent, one),
                {{one.p, one.v}}),
        {"printed_differs", "", {}, {above((-first).expression(), 0.5)}, "interval"}},
       0.5},
      both_arrive("3.9-first_equation_suffices", "corrected"),
      both_arrive("3.9-finite_time", "printed")};
}

/// Proofs that the solutions satisfy the equation and the initial conditions.
Provables proofs_of_solutions() {
  const Shortened m = Shortened::letter("m"), c = Shortened::letter("c"), a = Shortened::letter("a"),
                  p = Shortened::letter("p"), v = Shortened::letter("v"), t = Shortened::letter("t"),
                  root = sqrt(a * a - 4 * m * c), r1 = (-a + root) / (2 * m), r2 = (-a - root) / (2 * m),
                  k1 = (v - r2 * p) / (r1 - r2), turns = 4 * m * c - a * a, alpha = -a / (2 * m),
                  beta = sqrt(turns) / (2 * m);
  const auto solved = [&](const std::string& name, std::vector<Proposition> given, const std::string& x,
                          const std::string& tactic) -> Lemma {
    const std::string rate = R"(\frac{d}{dt}()" + x + ")",
                      second = R"(\frac{d}{dt}\left()" + rate + R"(\right))";
    const auto value = [&](const std::string& text, const Shortened& time) {
      const TypesetIn<Shortened> letters{
          {"m", m},           {"c", c},    {"a", a},    {"p", p},    {"v", v},        {"t", time},
          {R"(\dot t)", 1.0}, {"r_1", r1}, {"r_2", r2}, {"K_1", k1}, {"K_2", p - k1}, {R"(\alpha)", alpha},
          {R"(\beta)", beta}};
      return recorded_text("$" + text + "$", letters)[0];
    };
    return {name,
            "(m c a p v t : R)",
            std::move(given),
            {value("m" + second + "+a" + rate + "+c(" + x + ")", t) == Expression(0),
             value(x, 0.0) == p.expression(), value(rate, 0.0) == v.expression()},
            tactic};
  };
  const auto thrown_at = [](const Shortened& time) {
    const TypesetIn<Shortened> letters{
        {"r_1", -1.0}, {"r_2", -4.0}, {"K_1", Shortened(-5) / 3}, {"K_2", Shortened(8) / 3}, {"t", time}};
    return recorded_text(two_exponentials, letters)[0];
  };
  const std::string exponentials = two_exponentials.substr(1, two_exponentials.size() - 2);
  const Expression passing = log(Expression(8) / 5) / 3, late = -thrown_at(1.0);
  return {
      {"3.9-two_exponentials",
       "where the roots differ it solves the equation from any start; at a double root the other form does",
       {solved("corrected", positive({m, a * a - 4 * m * c}), exponentials, "damped"),
        solved("double_root", {positive({m})[0], (a * a).expression() == (4 * m * c).expression()},
               R"((p+(v-\alpha p)t)e^{\alpha t})", "twice")}},
      {"3.9-damped_oscillation",
       "it holds for any ball",
       {solved("printed", positive({m, turns}), damped_oscillation, "damped")}},
      {"3.9-overdamped_never_arrives",
       "the ball thrown at the origin is there at ln(8/5)/3, to ten digits, and beyond it at 1",
       {{"corrected", "", {}, {above(passing, 0), near(thrown_at(passing), 0, 1e-10)}, "interval"},
        {"printed_differs", "", {}, {above(late, 0.5)}, "interval"}},
       0.5}};
}

}  // namespace

Provable proof_of_negative_roots(const ForAll<PolynomialOf>& all) {
  const auto& s = all.any;
  const auto first = s.root(1), second = s.root(-1);
  const Shortened square = s.a * s.a - 4 * s.m * s.c;
  const auto lemma = [&](const std::string& name, const Proposition& where, const auto& imaginary) -> Lemma {
    std::vector<Proposition> given = all.given, follows = positive({-first[0], -second[0]});
    given.push_back(where);
    for (const Shortened& part : {first[1], second[1]}) follows.push_back(imaginary(part.expression()));
    return {name, all.letters, given, follows, "signs_of_the_parts m c a"};
  };
  return {"3.9-negative_roots",
          "both parts are as stated for any ball",
          {lemma("real", {square.expression().coq() + " >= 0"},
                 [](const Expression& x) { return x == Expression(0); }),
           lemma("complex", positive({4 * s.m * s.c - s.a * s.a})[0], not_zero)},
          0,
          all.preamble};
}

Provables proofs() {
  Claims claims("3.9");
  Tables tables{claims};
  for (auto* section : provable_sections) section(tables);
  auto motion = for_all<MotionOf>("any_motion", "it holds for any ball");
  motion.given = positive({motion.any.m, 4 * motion.any.m * motion.any.c - motion.any.a * motion.any.a});
  ForAll<InLineOf> in_line{{motion.any}, "(m c a p1 p2 s t : R)", motion.given, "damped", motion.says};
  in_line.any.v1 = Shortened::letter("s") * in_line.any.p1;
  in_line.any.v2 = Shortened::letter("s") * in_line.any.p2;
  auto polynomial = for_all<PolynomialOf>("by_parts_of_the_root m c a", motion.says, {1, 3, 2, 1, 1});
  polynomial.given = positive({polynomial.any.m, polynomial.any.c, polynomial.any.a});
  polynomial.preamble = coq_source({"parts"});
  Provables all = tables.motion.proofs("3.9", motion);
  for (Provables& more : std::array{tables.in_line.proofs("3.9", in_line), proofs_of_solutions(),
                                    proofs_at_zeros(tables.zeros), proofs_of_arrivals()})
    append(all, std::move(more));
  for (Provable& proof : all) proof.preamble = coq_source({"damped"});
  append(all, tables.polynomial.proofs("3.9", polynomial));
  append(all, {proof_of_negative_roots(polynomial)});
  return all;
}

std::vector<Root> roots() {
  using F = Frictions;
  constexpr double second = 1;
  const double critical = 2 * sqrt(F::m * F::c), stronger = 2 * critical, strong = 10 * critical;
  const Motion at_rest = weak(1, 0, 0, 0).motion, across = weak(0, 1, 0, 0).motion,
               away = weak(1, 2, 1, 2).motion;
  const auto& [m, c, a, p1, p2, v1, v2] = static_cast<const Ball&>(away);
  const double alpha = at_rest.alpha(), by_formula = std::atan(-at_rest.beta() / -alpha) / at_rest.beta();
  return {
      {"the double root",
       filled(
           R"(A door closer with the friction $2\sqrt{mc}$ shuts the door fastest without swinging, but )"
           R"(solving for $K_1$ and $K_2$ gives NaN for its position. For $m=@1$, $c=@1$ the door, let go )"
           R"(at rest, is at @2 of its start after @1 s.)",
           {F::m, F::c, F::left_after(critical, second), second})},
      {"a fast throw",
       filled(
           R"(A game that rules the hit out for strong friction lets a ball through its goal unseen. Thrown )"
           R"(from $p$ with $v=@1p$ at $m=@1$, $c=@1$, $a=@1$, it passes after @3 s, at @2 $|p|$ a second.)",
           {throw_in.v1 / throw_in.p1, throw_in.m, throw_in.c, throw_in.a, throw_in.passage(),
            throw_in.speed()})},
      {"too much friction",
       filled(
           R"(More friction does not bring the ball home sooner. For $m=@1$, $c=@1$, let go at rest, it is )"
           R"(within @1 of its way after @2 s with $a=@1$, after @2 s with $a=@1$, and after @2 s with )"
           R"($a=@2$.)",
           {F::m, F::c, F::nearly, F::home_after(critical), critical, F::home_after(stronger), stronger,
            F::home_after(strong), strong})},
      {"the first equation alone",
       filled(R"(A ball that swings along the $x_2$-axis gets NaN for its time. Let go at rest with $m=@1$, )"
              R"($c=@1$, $a=@1$, it reaches the origin after @3 s all the same.)",
              {m, c, a, across.t})},
      {"the arctangent's branch",
       filled(R"(For $m=@1$, $c=@1$, $a=@1$ and a start at rest the formula gives $@3$ s, not @3 s. A game )"
              R"(that schedules the hit for that moment puts it into the past, and the event never fires.)",
              {m, c, a, by_formula, at_rest.t})},
      {"a zero denominator",
       filled(R"(With $m=@1$, $c=@1$, $a=@1$ and $v=@1\,p$ the ball is at the origin after @3 s. The result )"
              R"(of a program that divides depends on how it treats $p_1/0$.)",
              {m, c, a, alpha, weak(1, 0, alpha, 0).motion.t})},
      {"a ball that turns back",
       filled(
           R"(With $m=@1$, $c=@1$, $a=@1$, a ball sent off from $(@1,@1)$ m at $(@1,@1)$ m/s is back at the origin )"
           R"(after @3 s: a game that tests $p\cdot v<0$ leaves this hit out.)",
           {m, c, a, p1, p2, v1, v2, away.t})}};
}

}  // namespace oddity::ex03_09
