// The claims of exercise 3.9. The equations are derived from L = m|x'|^2/2 - c|x|^2/2 and Rayleigh's
// dissipation a|x'|^2/2 by dual numbers. The published solutions are substituted in the differential
// equation, with their derivatives by dual numbers. Arrivals are found along the equation's Taylor series.
// Letters: r1 > r2 are the real roots of m r^2 + a r + c; alpha, beta are the parts of the complex ones.

#include <algorithm>
#include <cmath>
#include <complex>
#include <concepts>
#include <numbers>

#include "chapters/03_rigid_body_motion/09_damped_ball/damped_ball.hpp"
#include "chapters/03_rigid_body_motion/shared/lagrange.hpp"
#include "chapters/provable_claims.hpp"
#include "reference/text.hpp"
#include "solvers/dual.hpp"

namespace oddity::ex03_09 {

using namespace damped_ball;
using std::abs, std::sqrt, std::numbers::pi;

/// Draws the next samples from a stream shared by all claims.
template <class Sample>
std::vector<Sample> next(Random& random, int count) {
  std::vector<Sample> samples;
  for (int i = 0; i < count; ++i) samples.emplace_back(random);
  return samples;
}

// ---- the equation and its solutions -----------------------------------------------------------------------

/// A ball at any position, with any velocity.
template <class T>
struct AnywhereOf {
  T m, c, a, x1, x2, v1, v2;
  AnywhereOf() = default;
  explicit AnywhereOf(Random& random)
      : m(random.between(0.1, 3)), c(random.between(0.1, 3)), a(random.between(0.1, 3)) {
    const auto x = random.point(3), v = random.point(3);
    x1 = x[0], x2 = x[1], v1 = v[0], v2 = v[1];
  }
  std::array<T*, 7> letters() { return {&m, &c, &a, &x1, &x2, &v1, &v2}; }
  TypesetIn<T> typeset() const {
    return {{"m", m},
            {"c", c},
            {"a", a},
            {"x", {x1, x2}},
            {R"(\dot x)", {v1, v2}},
            {R"(\ddot x)", accelerations()}};
  }
  std::string where() const { return "$a$ = " + format_significant(a, 4); }
  /// The forces of spring and friction, from the potential and Rayleigh's dissipation.
  Two<T> forces() const {
    const auto potential = [this](const auto& q1, const auto& q2) { return 0.5 * c * (q1 * q1 + q2 * q2); };
    const Two<T> friction = friction_by_dissipation();
    using Along = Dual<T>;
    const T one = 1;
    return {friction[0] - potential(Along(x1, one), Along(x2)).slope,
            friction[1] - potential(Along(x1), Along(x2, one)).slope};
  }
  Two<T> friction_by_dissipation() const {
    const auto dissipation = [this](const auto& u1, const auto& u2) { return 0.5 * a * (u1 * u1 + u2 * u2); };
    using Along = Dual<T>;
    const T one = 1;
    return {-dissipation(Along(v1, one), Along(v2)).slope, -dissipation(Along(v1), Along(v2, one)).slope};
  }
  /// The accelerations by Lagrange's equations with friction.
  Two<T> accelerations() const {
    const auto lagrangian = [this]<class X>(const Two<X>& q, const Two<X>& u) {
      return X(m / 2) * (u[0] * u[0] + u[1] * u[1]) - X(c / 2) * (q[0] * q[0] + q[1] * q[1]);
    };
    return lagrange_accelerations(lagrangian, Two<T>{x1, x2}, Two<T>{v1, v2}, friction_by_dissipation());
  }
};
using Anywhere = AnywhereOf<double>;

/// Re and Im.
template <class T>
struct ComplexOf {
  T re, im;
  friend ComplexOf operator+(const ComplexOf& a, const ComplexOf& b) { return {a.re + b.re, a.im + b.im}; }
  friend ComplexOf operator*(const ComplexOf& a, const ComplexOf& b) {
    return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
  }
  friend ComplexOf operator*(const T& a, const ComplexOf& b) { return {a * b.re, a * b.im}; }
};

/// The characteristic polynomial's coefficients, its roots by the text, any number r, and a time.
template <class T>
struct PolynomialOf {
  T m, c, a, r, t;
  PolynomialOf() = default;
  explicit PolynomialOf(Random& random)
      : m(random.between(0.1, 3)),
        c(random.between(0.1, 3)),
        a(random.between(0.1, 9)),
        r(random.between(-3, 3)),
        t(random.between(0, 2)) {}
  std::array<T*, 5> letters() { return {&m, &c, &a, &r, &t}; }
  std::string where() const {
    return "$m$ = " + format_significant(m, 4) + ", $c$ = " + format_significant(c, 4) +
           ", $a$ = " + format_significant(a, 4);
  }
  TypesetIn<T> typeset() const {
    return {{"m", m}, {"c", c}, {"a", a}, {"r", r}, {R"(\mathrm{Re}\,r)", {root(1).re, root(-1).re}}};
  }
  ComplexOf<T> root(double sign, double factor = 4) const {
    const T square = a * a - factor * m * c, size = abs(square);
    return {(-a + sign * sqrt((size + square) / 2)) / (2 * m), sign * sqrt((size - square) / 2) / (2 * m)};
  }
  /// m x'' + a x' + c x of x = e^(rt), over x.
  T of_exponential() const {
    const auto x = [this](const auto& at) { return exp(r * at); };
    return (m * second_derivative(x, t) + a * derivative(x, t) + c * x(t)) / x(t);
  }
  auto sum_and_product(double factor) const {
    const auto r1 = root(1, factor), r2 = root(-1, factor), sum = r1 + r2, product = r1 * r2;
    return values(sum.re, product.re, sum.im, product.im);
  }
};
using Polynomial = PolynomialOf<double>;

/// One coordinate from p with velocity v, at a later time; friction is a fraction of the critical one.
template <class T>
struct Coordinate {
  T m, c, p, v, a, t;
  Coordinate() = default;
  Coordinate(Random& random, double least, double most)
      : m(random.between(0.3, 3)),
        c(random.between(0.3, 3)),
        p(random.between(-2, 2)),
        v(random.between(-2, 2)),
        a(2 * sqrt(m * c) * random.between(least, most)),
        t(random.between(0.1, 5)) {}
  std::array<T*, 6> letters() { return {&m, &c, &a, &p, &v, &t}; }
  TypesetIn<T> typeset() const {
    return {{"m", m},
            {"c", c},
            {"a", a},
            {"p", p},
            {"v", v},
            {"t", t},
            {R"(\beta)", sqrt(4 * m * c - a * a) / (2 * m)}};
  }
  std::string where() const {
    return "$m$ = " + format_significant(m, 4) + ", $c$ = " + format_significant(c, 4) +
           ", $a$ = " + format_significant(a, 4) + ", $t$ = " + format_significant(t, 4);
  }
};
template <class T>
struct OverDampedOf : Coordinate<T> {
  OverDampedOf() = default;
  explicit OverDampedOf(Random& random) : Coordinate<T>(random, 1.1, 3) {}
};
using OverDamped = OverDampedOf<double>;
template <class T>
struct UnderDampedOf : Coordinate<T> {
  UnderDampedOf() = default;
  explicit UnderDampedOf(Random& random) : Coordinate<T>(random, 0.05, 0.9) {}
};
using UnderDamped = UnderDampedOf<double>;

/// The book's two exponentials as a function of the time. sign = 1: K1 = (v - r2 p)/(r1 - r2).
template <class T>
auto two_exponentials(const T& m, const T& c, const T& a, const T& p, const T& v, double sign = 1) {
  const T root = sqrt(a * a - 4 * m * c), r1 = (-a + root) / (2 * m), r2 = (-a - root) / (2 * m);
  const T k1 = (v - sign * r2 * p) / (r1 - r2);
  return [=](const auto& t) { return k1 * exp(r1 * t) + (p - k1) * exp(r2 * t); };
}

/// exp(alpha t) (K1 cos(beta t) + K2 sin(beta t)).
template <class T>
auto oscillation(const T& alpha, const T& beta, const T& k1, const T& k2) {
  return [=](const auto& t) { return exp(alpha * t) * (k1 * cos(beta * t) + k2 * sin(beta * t)); };
}

/// sign = 1: the published K2 = (v - alpha p)/beta.
template <class T>
auto damped_oscillation(const std::type_identity_t<T>& m, const std::type_identity_t<T>& c, const T& a,
                        const T& p, const T& v, double sign = 1) {
  const T alpha = -a / (2 * m), beta = sqrt(4 * m * c - a * a) / (2 * m);
  return oscillation(alpha, beta, p, T((v - sign * alpha * p) / beta));
}

/// A solution substituted in the differential equation and in the initial conditions.
template <template <class> class Of, class Form>
ProvableFormula<Of> put_in(std::string text, const Form& form) {
  return {std::move(text),
          [form]<class T>(const Of<T>& s) {
            const auto x = form(s);
            return values(s.m * second_derivative(x, s.t) + s.a * derivative(x, s.t) + s.c * x(s.t), x(T(0)),
                          derivative(x, T(0)));
          },
          [form](const Of<double>& s) {
            const auto x = form(s);
            return abs(s.m * second_derivative(x, s.t)) + abs(s.a * derivative(x, s.t)) + abs(s.c * x(s.t));
          }};
}
const std::string put_in_quantity = R"($(m\ddot x+a\dot x+cx,\;x(0),\;\dot x(0))$)";
template <template <class> class Of>
const ProvableFormula<Of> as_asked{"$(0,p,v)$", [](const auto& s) { return values(0, s.p, s.v); }};

/// One coordinate and its rate.
struct Moving {
  double x, rate;
};

/// A coordinate a time later, by the Taylor series of the differential equation, which knows no roots.
Moving later(const Ball& b, const Moving& now, double time) {
  constexpr int terms = 30;
  double term = now.x, next = now.rate * time;
  Moving then{term + next, now.rate};
  for (int n = 2; n < terms; ++n) {
    const double after = -(b.a * time * (n - 1) * next + b.c * time * time * term) / (b.m * n * (n - 1));
    term = next, next = after;
    then.x += next;
    then.rate += n * next / time;
  }
  return then;
}

/// Motion after any time, in steps of at most half a radian of the undamped spring.
Moving long_after(const Ball& b, Moving now, double time) {
  const int steps = 1 + static_cast<int>(2 * time * sqrt(b.c / b.m));
  for (int i = 0; i < steps; ++i) now = later(b, now, time / steps);
  return now;
}

/// A ball thrown from 1 with the velocity -u, its friction critical or more; u on either side of both roots.
struct Throw {
  Ball ball{};
  double u, slow, fast;  ///< -slow and -fast are the roots

  explicit Throw(Random& random) {
    const double m = random.between(0.3, 3), c = random.between(0.3, 3),
                 part = random.unit() < 0.2 ? 1 : random.between(1.02, 3), a = 2 * sqrt(m * c) * part,
                 w = sqrt(c / m * (part * part - 1));
    slow = a / (2 * m) - w, fast = a / (2 * m) + w;
    u = fast * (random.unit() < 0.5 ? random.between(1.05, 3) : random.between(-1, 0.95));
    ball = {m, c, a, 1, 0, -u, 0};
  }
  std::string where() const {
    return "$m$ = " + format_significant(ball.m, 4) + ", $c$ = " + format_significant(ball.c, 4) +
           ", $a$ = " + format_significant(ball.a, 4) + ", $u$ = " + format_significant(u, 4);
  }
  /// Changes of the coordinate's sign until long after the last that there may be.
  int passages() const {
    const double step = 0.1 * sqrt(ball.m / ball.c);
    int count = 0;
    Moving now{ball.p1, ball.v1};
    for (int i = 0; i < 300; ++i) {
      const Moving next = later(ball, now, step);
      if (now.x * next.x < 0) ++count;
      now = next;
    }
    return count;
  }
};

/// Two real roots' constants; the mass is 1, the spring 4.
struct Constants {
  double a, k1, k2;
  explicit Constants(Random& random)
      : a(random.between(4.1, 20)), k1(random.magnitude(1e-3, 1e3)), k2(random.magnitude(1e-3, 1e3)) {}
  std::string where() const {
    return "$a$ = " + format_significant(a, 4) + ", $K_1$ = " + format_significant(k1, 4) +
           ", $K_2$ = " + format_significant(k2, 4);
  }
  TypesetLetters typeset() const { return {{"x(500)", at(500)}, {"K_1", k1}}; }
  /// K1 exp(r1 t) + K2 exp(r2 t), each root times its sign.
  double at(double t, double sign1 = 1, double sign2 = 1) const {
    const double root = sqrt(a * a - 16);
    return k1 * std::exp(sign1 * (-a + root) / 2 * t) + k2 * std::exp(sign2 * (-a - root) / 2 * t);
  }
};

/// An overdamped ball thrown towards the origin, and its first coordinate's K1 exp(r1 t) + K2 exp(r2 t).
struct Passing {
  Ball ball{1, 4, 5, 1, 2, -9, -18};
  struct Terms {
    double r1, r2, k1, k2;
  } terms;

  Passing() {
    const auto& [m, c, a, p1, p2, v1, v2] = ball;
    const double root = sqrt(a * a - 4 * m * c), r1 = (-a + root) / (2 * m), r2 = (-a - root) / (2 * m),
                 k1 = (v1 - r2 * p1) / (r1 - r2);
    terms = {r1, r2, k1, p1 - k1};
  }
  double factor() const { return ball.v1 / ball.p1; }  ///< v = factor() p
  double time() const { return std::log(-terms.k2 / terms.k1) / (terms.r1 - terms.r2); }
  double speed() const {  ///< at the origin, in |p| a second
    const auto& [r1, r2, k1, k2] = terms;
    return abs(k1 * r1 * std::exp(r1 * time()) + k2 * r2 * std::exp(r2 * time())) / abs(ball.p1);
  }
};

/// Strong friction, and stronger friction.
struct Frictions {
  double a, b;
  explicit Frictions(Random& random) : a(random.between(4.5, 60)), b(a * random.between(1.05, 3)) {}
  std::string where() const {
    return "$a$ = " + format_significant(a, 4) + " and " + format_significant(b, 4);
  }
  static constexpr double m = 1, c = 4, seconds = 5, nearly = 0.01;
  /// Distance from the origin of a ball some seconds after its release at rest.
  static double left(double friction) { return left_after(friction, seconds); }
  static double left_after(double friction, double t) {
    return abs(OneForm<double>{{m, c, friction, 1, 1, 0, 0}}.at(t)[0]);
  }
  /// The time to come near the origin, for strong friction.
  static double home_after(double friction) {
    double early = 0, late = 1000;
    for (int i = 0; i < 60; ++i) {
      const double t = (early + late) / 2;
      (left_after(friction, t) > nearly ? early : late) = t;
    }
    return late;
  }
};

/// K1 and K2 of the oscillation, and a time.
template <class T>
struct OscillationOf {
  T alpha, beta, k1, k2, t;
  OscillationOf() = default;
  explicit OscillationOf(Random& random)
      : alpha(-random.unit()),
        beta(random.between(0.1, 3)),
        k1(random.between(-2, 2)),
        k2(random.between(-2, 2)),
        t(random.between(0, 5)) {}
  std::array<T*, 5> letters() { return {&alpha, &beta, &k1, &k2, &t}; }
  TypesetIn<T> typeset() const {
    return {{R"(\alpha)", alpha}, {R"(\beta)", beta}, {"K_1", k1}, {"K_2", k2}, {"t", t}};
  }
  std::string where() const { return "$t$ = " + format_significant(t, 4); }
};
using Oscillation = OscillationOf<double>;

template <class T>
struct StartOfOneOf {
  T alpha, beta, p, v;
  StartOfOneOf() = default;
  explicit StartOfOneOf(Random& random)
      : alpha(-random.unit()),
        beta(random.between(0.1, 3)),
        p(random.between(-2, 2)),
        v(random.between(-2, 2)) {}
  std::array<T*, 4> letters() { return {&alpha, &beta, &p, &v}; }
  TypesetIn<T> typeset() const { return {{R"(\alpha)", alpha}, {R"(\beta)", beta}, {"p", p}, {"v", v}}; }
  std::string where() const {
    return R"($\alpha$ = )" + format_significant(alpha, 4) + R"(, $\beta$ = )" + format_significant(beta, 4);
  }
  /// K1 and K2 from the linear equations x(0) = p and x'(0) = v.
  std::array<T, 2> constants() const {
    const auto cosine = oscillation(alpha, beta, T(1), T(0)), sine = oscillation(alpha, beta, T(0), T(1));
    const T c = cosine(T(0)), s = sine(T(0)), c_rate = derivative(cosine, T(0)),
            s_rate = derivative(sine, T(0));
    const T determinant = c * s_rate - s * c_rate;
    return {(p * s_rate - s * v) / determinant, (c * v - p * c_rate) / determinant};
  }
};
using StartOfOne = StartOfOneOf<double>;

/// Any two vectors, and any real and imaginary part of a root.
template <class T>
struct VectorsOf {
  T p1, p2, v1, v2, alpha, beta;
  VectorsOf() = default;
  explicit VectorsOf(Random& random) {
    const auto p = random.point(2), v = random.point(2);
    p1 = p[0], p2 = p[1], v1 = v[0], v2 = v[1];
    alpha = -random.between(0.05, 2);
    beta = random.between(0.1, 2);
  }
  std::array<T*, 6> letters() { return {&p1, &p2, &v1, &v2, &alpha, &beta}; }
  TypesetIn<T> typeset() const { return {{"p_1", p1}, {"p_2", p2}, {"v_1", v1}, {"v_2", v2}}; }
  std::string where() const {
    return "$p$ = (" + format_significant(p1, 4) + ", " + format_significant(p2, 4) + "), $v$ = (" +
           format_significant(v1, 4) + ", " + format_significant(v2, 4) + ")";
  }
};
using Vectors = VectorsOf<double>;

/// A ball that does not start towards the origin, with any friction below the critical.
template <class T>
struct AsideOf {
  T m, c, a, t, p1, p2, v1, v2;
  AsideOf() = default;
  explicit AsideOf(Random& random)
      : m(random.between(0.3, 3)),
        c(random.between(0.3, 3)),
        a(2 * sqrt(m * c) * random.between(0.05, 0.9)),
        t(random.between(0.1, 6)) {
    const auto p = random.point(2), v = random.point(2);
    p1 = p[0], p2 = p[1], v1 = v[0], v2 = v[1];
  }
  std::array<T*, 8> letters() { return {&m, &c, &a, &t, &p1, &p2, &v1, &v2}; }
  TypesetIn<T> typeset() const {
    return {{"m", m}, {"a", a}, {"t", t}, {"p_1", p1}, {"p_2", p2}, {"v_1", v1}, {"v_2", v2}};
  }
  std::string where() const {
    return "$m$ = " + format_significant(m, 4) + ", $c$ = " + format_significant(c, 4) +
           ", $a$ = " + format_significant(a, 4) + ", $t$ = " + format_significant(t, 4);
  }
  T momentum() const {
    const auto x1 = damped_oscillation(m, c, a, p1, v1), x2 = damped_oscillation(m, c, a, p2, v2);
    return x1(t) * derivative(x2, t) - x2(t) * derivative(x1, t);
  }
};
using Aside = AsideOf<double>;

/// A ball with v = s p, its friction below the critical, and a time.
template <class T>
struct InLineOf {
  T m, c, a, t, p1, p2, s;
  InLineOf() = default;
  explicit InLineOf(Random& random)
      : m(random.between(0.3, 3)),
        c(random.between(0.3, 3)),
        a(2 * sqrt(m * c) * random.between(0.05, 0.9)),
        t(random.between(0.1, 6)),
        p1(random.magnitude(0.2, 2)),
        p2(random.magnitude(0.2, 2)),
        s(random.between(-2, 2)) {}
  std::array<T*, 7> letters() { return {&m, &c, &a, &t, &p1, &p2, &s}; }
  T alpha() const { return -a / (2 * m); }
  T beta() const { return sqrt(4 * m * c - a * a) / (2 * m); }
  /// Numbers by the equation, letters by its solution.
  T coordinate(const T& p) const {
    if constexpr (std::same_as<T, double>)
      return long_after({m, c, a, p, 0, s * p, 0}, {p, s * p}, t).x;
    else
      return damped_oscillation(m, c, a, p, T(s * p))(t);
  }
  TypesetIn<T> typeset() const {
    return {{R"(\alpha)", alpha()},
            {R"(\beta)", beta()},
            {"p_1", p1},
            {"p_2", p2},
            {"v_1", s * p1},
            {"v_2", s * p2},
            {"x_1", coordinate(p1)},
            {"x_2", coordinate(p2)}};
  }
  std::string where() const {
    return "$a$ = " + format_significant(a, 4) + ", $t$ = " + format_significant(t, 4) +
           ", $v$ = " + format_significant(s, 4) + " $p$";
  }
  /// Size of the terms that cancel in the products of both pairs (p, k), k = (v - alpha p)/beta, and of x and
  /// p.
  double size() const { return 2 * abs(p1 * p2) * (1 + (abs(s) + abs(alpha())) / beta()); }
};
using InLine = InLineOf<double>;

/// The pairs (p_i, k_i) of both coordinates, and the angle beta t.
template <class T>
struct PairsOf {
  T p1, p2, k1, k2, angle;
  PairsOf() = default;
  explicit PairsOf(Random& random) : angle(random.between(-pi, pi)) {
    const auto p = random.point(2), k = random.point(2);
    p1 = p[0], p2 = p[1], k1 = k[0], k2 = k[1];
  }
  std::array<T*, 5> letters() { return {&p1, &p2, &k1, &k2, &angle}; }
  TypesetIn<T> typeset() const {
    return {{"p_1", p1}, {"p_2", p2}, {"k_1", k1}, {"k_2", k2}, {R"(\beta t)", angle}};
  }
  std::string where() const { return R"($\beta t$ = )" + format_significant(angle, 4); }
};
using Pairs = PairsOf<double>;

/// The claims with proofs.
struct Tables {
  ProvableClaims<AnywhereOf> anywhere;
  ProvableClaims<PolynomialOf> polynomial;
  ProvableClaims<OscillationOf> oscillation;
  ProvableClaims<StartOfOneOf> start;
  ProvableClaims<UnderDampedOf> under_damped;
  ProvableClaims<VectorsOf> vectors;
  ProvableClaims<PairsOf> pairs;
  ProvableClaims<AsideOf> aside;
  ProvableClaims<InLineOf> in_line;

  explicit Tables(Claims& claims)
      : anywhere(claims),
        polynomial(claims),
        oscillation(claims),
        start(claims),
        under_damped(claims),
        vectors(claims),
        pairs(claims),
        aside(claims),
        in_line(claims) {}
};

ProvableFormula<OverDampedOf> two_exponentials_put_in(double sign = 1) {
  return put_in<OverDampedOf>("the two exponentials, differentiated by dual numbers", [sign](const auto& s) {
    return two_exponentials(s.m, s.c, s.a, s.p, s.v, sign);
  });
}

void equations(Tables& tables, const std::vector<Anywhere>& samples) {
  tables.anywhere.formula(
      "generalized_forces", 1439,
      R"(The generalized forces of spring and friction are $-cx-a\dot x$ for each coordinate)", samples,
      {.quantity = R"($(F_{x_1},F_{x_2})$)",
       .truth = {"the spring's potential and Rayleigh's dissipation by dual numbers",
                 [](const auto& s) { return s.forces(); }},
       .printed = R"($-cx-a\dot x$)"});
  tables.anywhere.formula("equations", 1449, R"(Each coordinate obeys $m\ddot x+a\dot x+cx=0$)", samples,
                          {.quantity = R"($m\ddot x+a\dot x+cx$, the accelerations by Lagrange's equations)",
                           .truth = {"zero", []<class T>(const AnywhereOf<T>&) { return values(T(0)); }},
                           .printed = R"($m\ddot x+a\dot x+cx=0$)",
                           .changes_that_hold = "a factor of zero may have any size and sign"});
}

void characteristic_roots(ProvableClaims<PolynomialOf>& table, const std::vector<Polynomial>& polynomials) {
  using OfPolynomial = ProvableFormula<PolynomialOf>;
  table.formula(
      "characteristic_polynomial", 1453,
      "The characteristic polynomial is $mr^2+ar+{}=0$ (our reading of the dangling plus: nothing follows it)",
      polynomials,
      {.quantity = "the polynomial at any $r$",
       .truth = {R"($e^{-rt}(m\ddot x+a\dot x+cx)$ of $x=e^{rt}$, by dual numbers)",
                 [](const auto& s) { return s.of_exponential(); }},
       .printed = "$mr^2+ar$",
       .meant = "$mr^2+ar+c$",
       .kind = Fault::formula,
       .why = "The last coefficient, $c$, is missing after its plus sign; the roots that follow show it."});
  const auto roots_with = [](std::string text, double factor) -> OfPolynomial {
    return {std::move(text), [=](const auto& s) { return s.sum_and_product(factor); },
            [](const Polynomial& s) { return s.a * s.a / (s.m * s.m) + 1; }};
  };
  table.formula("roots", 1455,
                R"(The roots of the characteristic polynomial are $(-a\pm\sqrt{a^2-4mc})/(2m)$)", polynomials,
                {.quantity = "the roots' sum and product, real and imaginary parts",
                 .truth = {"the coefficients: $-a/m$ and $c/m$, both real",
                           [](const auto& s) { return values(-s.a / s.m, s.c / s.m, 0, 0); }},
                 .printed = roots_with(R"(of $(-a\pm\sqrt{a^2-4mc})/(2m)$)", 4),
                 .near_misses = {roots_with(R"(of $(-a\pm\sqrt{a^2-2mc})/(2m)$)", 2)}});
}

void solutions(Claims& claims, const std::vector<Polynomial>& polynomials, double seed, Random& random) {
  const auto both = [](const Polynomial& s, const auto& has) { return has(s.root(1)) && has(s.root(-1)); };
  const auto are_zeros = [=](const Polynomial& s) {
    return both(s, [&](const auto& root) {
      const std::complex<double> r(root.re, root.im);
      // the roundings of -a and the square root, which may cancel, change r by roundings of a/m; the slope is
      // at most a
      const double terms = s.m * std::norm(r) + s.a * abs(r) + s.c + s.a * s.a / s.m;
      return abs((s.m * r + s.a) * r + s.c) <= rounding(terms).allowed;
    });
  };
  const auto negative = [=](const Polynomial& s) { return both(s, [](const auto& r) { return r.re < 0; }); };
  const auto are_real = [=](const Polynomial& s) { return both(s, [](const auto& r) { return r.im == 0; }); };
  std::vector<Polynomial> with_double_root = polynomials;
  with_double_root.emplace_back();
  with_double_root.back().m = 1, with_double_root.back().c = with_double_root.back().a = 4;
  claims.statement<Polynomial>(
      "negative_roots", 1461,
      R"(Both roots are real and negative when $a^2-4mc\ge0$, and complex with negative real parts when )"
      R"($a^2-4mc<0$)",
      with_double_root,
      {.printed = {"the text's roots are zeros of the polynomial, and are such",
                   [=](const Polynomial& s) {
                     return are_zeros(s) && negative(s) && are_real(s) == (s.a * s.a - 4 * s.m * s.c >= 0);
                   }},
       .near_misses = {
           {R"(roots with $\mathrm{Re}\,r>0$)",
            [=](const Polynomial& s) { return both(s, [](const auto& r) { return r.re > 0; }); }},
           {"real and negative for any $a$", [=](const Polynomial& s) { return negative(s) && are_real(s); }},
           {"real when $a^2-2mc\\ge0$",
            [=](const Polynomial& s) { return are_real(s) == (s.a * s.a - 2 * s.m * s.c >= 0); }}}});

  const Ball critical{1, 4, 4, 1, 0.5, 0, 1.5};
  const auto at_double_root = [&](const std::string& by, const Value& x) {
    return Check{"$x(1)$ at $a^2=4mc$",
                 {by, x},
                 {"$e^{rt}(p+(v-rp)t)$, $r=-2$",
                  {std::exp(-2.0) * (1 + 2 * 1.0), std::exp(-2.0) * (0.5 + (1.5 + 1) * 1.0)}},
                 rounding(1)};
  };
  const auto in_equation = [&](double sign) {
    return compare<OverDamped>(put_in_quantity, two_exponentials_put_in(sign), as_asked<OverDampedOf>,
                               draw<OverDamped>(200, seed));
  };
  claims.add(
      "two_exponentials", 1469, "The general solution for real roots is $x=K_1e^{r_1t}+K_2e^{r_2t}$",
      {.printed = {R"($K_1e^{r_1t}+K_2e^{r_2t}$, for $r_1=r_2$ as well)",
                   {at_double_root("two exponentials", TwoExponentials<double>{critical}.at(1))}},
       .corrected =
           {R"($K_1e^{r_1t}+K_2e^{r_2t}$ for $r_1\ne r_2$, and $(K_1+K_2t)\,e^{rt}$ for a double root $r$)",
            {in_equation(1),
             at_double_root("the limit of the two regimes", OneForm<double>{critical}.at(1))}},
       .in_view = {"where the roots differ", {in_equation(1)}},
       .near_misses = {{"$K_1=(v+r_2p)/(r_1-r_2)$ for $r_1\\ne r_2$", {in_equation(-1)}},
                       {"$(p+vt)\\,e^{rt}$ for a double root $r$",
                        {at_double_root("$(p+vt)\\,e^{-2t}$",
                                        {std::exp(-2.0) * (1 + 0.0), std::exp(-2.0) * (0.5 + 1.5)})}}},
       .why =
           R"(Case 1 includes $a^2=4mc$, where both exponentials are the same function: two starting values )"
           R"(cannot be met, as solving for $K_1$ and $K_2$ divides by $r_1-r_2=0$. With roots that differ by )"
           R"(very little the two exponentials are still right, but they are large and of opposite sign, and )"
           R"(their sum loses digits (see `near_critical`).)",
       .kind = Fault::left_out,
       .root = "the double root"});

  claims.statement<Constants>(
      "limit", 1471,
      "With real roots $x=K_1e^{r_1t}+K_2e^{r_2t}$ tends to zero, whatever $K_1$ and $K_2$ (our check: at "
      "$t=500$, with $m=1$ and $c=4$)",
      next<Constants>(random, 200),
      {.printed = {"$|x(500)|<10^{-12}$"},
       .near_misses = {{R"($|x(500)|<10^{-12}$ of $x=K_1e^{-r_1t}+K_2e^{r_2t}$)",
                        [](const Constants& s) { return abs(s.at(500, -1)) < 1e-12; }},
                       {R"($|x(500)|<10^{-12}$ of $x=K_1e^{r_1t}+K_2e^{-r_2t}$)",
                        [](const Constants& s) { return abs(s.at(500, 1, -1)) < 1e-12; }},
                       {"$|x(500)-K_1|<10^{-12}$"}}});

  const Passing throw_in;
  const Ball &thrown = throw_in.ball, at_double{1, 4, 4, 1, 2, -5, -10};
  const auto& [r1, r2, k1, k2] = throw_in.terms;
  const auto at_origin = [](const Ball& ball, double time) -> Check {
    return {"$x$ at $t=" + format_significant(time, 3) + "$",
            {"closed form", OneForm<double>{ball}.at(time)},
            {"the origin", {0, 0}},
            rounding(2),
            2};
  };
  const auto counted = [seed](const std::string& text, double Throw::*threshold) {
    return in_all<Throw>(text, draw<Throw>(200, seed),
                         [=](const Throw& s) { return s.passages() == (s.u > s.*threshold ? 1 : 0); });
  };
  claims.add(
      "overdamped_never_arrives", 1477,
      R"(With real roots the ball reaches the origin after an infinite time (our reading: and, for $p\ne0$, not )"
      R"(before))",
      {.printed = {"$|x|>0$ for all $t$",
                   {no_violations(
                       "$x_1(1)$ has changed its sign: the origin is passed by then",
                       OneForm<double>{thrown}.at(1)[0] < 0, 1,
                       filled("$m=@1$, $c=@1$, $a=@1$, $p=(@1,@1)$, $v=@1p$",
                              {thrown.m, thrown.c, thrown.a, thrown.p1, thrown.p2, throw_in.factor()}))}},
       .corrected = {R"(with $v=-up$, $p\ne0$, the ball passes the origin once for $u>|r_2|$, at )"
                     R"($e^{(r_1-r_2)t}=-K_2/K_1$, or at $t=1/(u+r)$ for a double root $r$, and else never)",
                     {at_origin(thrown, throw_in.time()), at_origin(at_double, 1.0 / (5 - 2)),
                      counted("once for $u>|r_2|$, else never", &Throw::fast)}},
       .near_misses = {{"at $e^{(r_1-r_2)t}=-K_1/K_2$", {at_origin(thrown, std::log(-k1 / k2) / (r1 - r2))}},
                       {"at $e^{r_1t}=-K_2/K_1$", {at_origin(thrown, std::log(-k2 / k1) / r1)}},
                       {"at $t=1/(u-r)$ for a double root", {at_origin(at_double, 1.0 / (5 + 2))}},
                       {"once for $u>|r_1|$", {counted("once for $u>|r_1|$, else never", &Throw::slow)}}},
       .why = filled(
           R"(With $p$ and $v$ parallel both coordinates vanish together once if $v$ points to the origin and )"
           R"($|v|>|r_2||p|$. For $m=@1$, $c=@1$, $a=@1$ the roots are $@1$ and $@1$; from $p$ with $v=@1p$, )"
           R"($x=(K_1e^{r_1t}+K_2e^{r_2t})\,p$ with $K_1=@3$ and $K_2=@3$ is zero at )"
           R"($t=\ln(-K_2/K_1)/(r_1-r_2)=@3$.)",
           {thrown.m, thrown.c, thrown.a, r1, r2, throw_in.factor(), k1 / thrown.p1, k2 / thrown.p1,
            throw_in.time()}),
       .kind = Fault::counterexample,
       .root = "a fast throw"});

  claims.statement<Frictions>(
      "larger_friction_sooner", 1477,
      filled(
          "With real roots, the larger the friction, the sooner the ball is nearly at the origin (our check: "
          "the distance left after @1 s from rest, with $m=@1$ and $c=@1$)",
          {Frictions::seconds, Frictions::m, Frictions::c}),
      next<Frictions>(random, 100),
      {.printed = {"let go at rest, the distance left falls with $a$",
                   [](const Frictions& s) { return s.left(s.b) < s.left(s.a); }},
       .corrected = {R"(let go at rest, the distance left grows with $a$ beyond the critical $2\sqrt{mc}$)",
                     [](const Frictions& s) { return s.left(s.b) > s.left(s.a); }},
       .near_misses =
           {{R"(let go at rest, the distance left grows with $a$ beyond a fifteenth of $2\sqrt{mc}$)",
             [](const Frictions& s) { return s.left(s.b / 15) > s.left(s.a / 15); }}},
       .kind = Fault::counterexample,
       .root = "too much friction",
       .why =
           R"(Beyond critical damping the slow root $r_1=-2c/(a+\sqrt{a^2-4mc})$ goes to zero as $-c/a$: )"
           R"(the spring draws the ball through honey. The rate of decay is greatest at $a=2\sqrt{mc}$.)"});
}

void oscillations(Tables& tables, const std::vector<Oscillation>& samples,
                  const std::vector<StartOfOne>& starts, const std::vector<UnderDamped>& under_damped) {
  tables.oscillation.formula(
      "derivative", 1487,
      R"($\dot x=e^{\alpha t}(-\beta K_1\sin\beta t+\beta K_2\cos\beta t)+\alpha e^{\alpha )"
      R"(t}(K_1\cos\beta t+K_2\sin\beta t)$)",
      samples,
      {.quantity = R"(the derivative of $x=e^{\alpha t}(K_1\cos\beta t+K_2\sin\beta t)$)",
       .truth = {"$x$ by dual numbers",
                 [](const auto& s) { return derivative(oscillation(s.alpha, s.beta, s.k1, s.k2), s.t); }},
       .printed = R"($e^{\alpha t}(-\beta K_1\sin\beta t+\beta K_2\cos\beta t))"
                  R"(+\alpha e^{\alpha t}(K_1\cos\beta t+K_2\sin\beta t)$)"});
  tables.oscillation.formula("start_values", 1489,
                             R"($x(0)=p$ and $\dot x(0)=v$ lead to $p=K_1$, $v=\beta K_2+\alpha K_1$)",
                             samples,
                             {.quantity = R"($(x(0),\dot x(0))$)",
                              .truth = {"$x$ by dual numbers",
                                        []<class T>(const OscillationOf<T>& s) {
                                          const auto x = oscillation(s.alpha, s.beta, s.k1, s.k2);
                                          return values(x(T(0)), derivative(x, T(0)));
                                        }},
                              .printed = R"($(K_1,\ \beta K_2+\alpha K_1)$)"});
  tables.start.formula(
      "constants", 1489,
      R"(The solution of $p=K_1$, $v=\beta K_2+\alpha K_1$ is $K_1=p$, $K_2=(v-\alpha p)/\beta$)", starts,
      {.quantity = "$(K_1,K_2)$",
       .truth = {R"(the equations $x(0)=p$, $\dot x(0)=v$, by dual numbers)",
                 [](const auto& s) { return s.constants(); }},
       .printed = R"($(p,\ (v-\alpha p)/\beta)$)"});
  const auto oscillates = [](std::string text, double sign) {
    return put_in<UnderDampedOf>(
        std::move(text), [sign](const auto& s) { return damped_oscillation(s.m, s.c, s.a, s.p, s.v, sign); });
  };
  tables.under_damped.formula(
      "damped_oscillation", 1491,
      R"(For complex roots $x=e^{\alpha t}\big(p\cos\beta t+\frac{v-\alpha p}\beta\sin\beta t\big)$, )"
      R"(with $\alpha=-a/(2m)$ and $\beta=\sqrt{4mc-a^2}/(2m)$)",
      under_damped,
      {.quantity = put_in_quantity,
       .truth = as_asked<UnderDampedOf>,
       .printed = oscillates(
           R"(those of $x=e^{\alpha t}\big(p\cos\beta t+\frac{v-\alpha p}\beta\sin\beta t\big)$)", 1),
       .near_misses = {oscillates(
           R"(those of $x=e^{\alpha t}\big(p\cos\beta t+\frac{v+\alpha p}\beta\sin\beta t\big)$)", -1)}});
}

// ---- the arrival ------------------------------------------------------------------------------------------

/// The time when a ball is at the origin, and its uncertainty in double: roundings of the terms that cancel
/// there, divided by the slope. No number if it is not there.
struct Passage {
  double time;
  Tolerance known;
  double speed = 0;
};

/// First positive time at the origin, found by marching along p for half a turn, and by bisection. For a ball
/// that does not turn, the search takes fifty times as long as the spring alone takes for a radian.
Passage first_passage(const Ball& b) {
  const double rate = sqrt(b.c / b.m), step = 0.5 / rate, beta = sqrt(4 * b.m * b.c - b.a * b.a) / (2 * b.m),
               end = beta > 0 ? pi / beta : 50 / rate, size = std::hypot(b.p1, b.p2);
  Moving now{b.p1 * b.p1 + b.p2 * b.p2, b.p1 * b.v1 + b.p2 * b.v2};
  double start = 0;
  for (; now.x * later(b, now, step).x > 0; start += step) {
    if (start > end) return {std::numeric_limits<double>::quiet_NaN(), exact()};
    now = later(b, now, step);
  }
  double low = 0, high = step;
  for (int i = 0; i < 60; ++i)
    (now.x * later(b, now, (low + high) / 2).x > 0 ? low : high) = (low + high) / 2;
  const double slope = abs(later(b, now, high).rate), time = start + high,
               terms =
                   abs(b.p1) * (abs(b.p1) + abs(b.v1) / rate) + abs(b.p2) * (abs(b.p2) + abs(b.v2) / rate);
  return {time, rounding(time + terms / slope), slope / size};
}

/// An underdamped ball with p and v parallel.
struct Start {
  Ball ball;
  std::string told;
  Passage found = first_passage(ball);

  double alpha() const { return -ball.a / (2 * ball.m); }
  double beta() const { return sqrt(4 * ball.m * ball.c - ball.a * ball.a) / (2 * ball.m); }
  std::string where() const { return told; }
  TypesetLetters typeset() const {
    const auto& [m, c, a, p1, p2, v1, v2] = ball;
    return {{R"(\alpha)", alpha()}, {R"(\beta)", beta()}, {"p", {p1, p2}},
            {"v", {v1, v2}},        {"p_1", p1},          {"v_1", v1},
            {"t", found.time}};
  }
  Tolerance tolerance(double) const { return found.known; }
};
/// The ball of the examples, with little friction.
constexpr Ball weak(double p1, double p2, double v1, double v2) { return {1, 4, 0.4, p1, p2, v1, v2}; }

/// Such a ball at the time of its passage.
struct AtOrigin : Start {
  Tolerance tolerance(double size) const {
    return {beta() * found.known.allowed * size + rounding(size).allowed,
            "the passage's uncertainty, as an angle, and 64 roundings"};
  }
};

/// The ball with the velocity `speed` times p.
Start moving_at(const Ball& b, double speed) {
  return {{b.m, b.c, b.a, b.p1, b.p2, speed * b.p1, speed * b.p2},
          "$m$ = " + format_significant(b.m, 4) + ", $c$ = " + format_significant(b.c, 4) +
              ", $a$ = " + format_significant(b.a, 4) + ", $p$ = (" + format_significant(b.p1, 4) + ", " +
              format_significant(b.p2, 4) + "), $v$ = " + format_significant(speed, 4) + " $p$"};
}

/// A ball at p whose velocity is `speed` times p, with any friction below the critical.
Start start_at(Random& any, double p1, double p2, double speed) {
  const double m = any.between(0.3, 3), c = any.between(0.3, 4),
               a = 2 * sqrt(m * c) * any.between(0.03, 0.95);
  return moving_at({m, c, a, p1, p2, 0, 0}, speed);
}

void parallel(Tables& tables, const std::vector<Vectors>& samples, const std::vector<InLine>& in_line) {
  tables.vectors.formula(
      "parallel", 1515,
      R"($p$ and $(v-\alpha p)/\beta$ are parallel exactly when $p$ and $v$ are, as the products of both pairs )"
      R"(differ by the factor $\beta\ne0$ alone (the text's parenthesis does not close))",
      samples,
      {.quantity = R"($\beta$ times the vectors' product)",
       .truth = {R"($\beta\,p\times(v-\alpha p)/\beta$)",
                 [](const auto& s) {
                   return s.beta * (s.p1 * ((s.v2 - s.alpha * s.p2) / s.beta) -
                                    s.p2 * ((s.v1 - s.alpha * s.p1) / s.beta));
                 }},
       .printed = "$p_1v_2-p_2v_1$"});
  const ProvableFormula<InLineOf> zero{"zero", []<class T>(const InLineOf<T>&) { return values(T(0)); }};
  tables.in_line.formula(
      "one_equation", 1515,
      R"(With complex roots, and $p$ and $v$ parallel, the two conditions are one equation: the pairs )"
      R"($(p_i,\ (v_i-\alpha p_i)/\beta)$ of $i=1$ and 2 are parallel)",
      in_line,
      {.quantity = R"(the pairs' product)",
       .truth = zero,
       .printed = R"($p_1\frac{v_2-\alpha p_2}\beta-p_2\frac{v_1-\alpha p_1}\beta=0$)",
       .changes_that_hold = "a factor of zero may have any size and sign"});
  tables.in_line.formula(
      "pulled_directly", 1525,
      R"(With complex roots, and $p$ and $v$ parallel, the ball is pulled directly to the )"
      R"(origin (our reading: it stays on the line through $p$ and the origin))",
      in_line,
      {.quantity = R"($x\times p$ at any time, $x$ by the equation's Taylor series)",
       .truth = zero,
       .printed = "$x_1p_2-x_2p_1=0$",
       .changes_that_hold = "a factor of zero may have any size and sign"});
}

const std::string
    conditions = R"($p\cos\beta t+\frac{v-\alpha p}\beta\sin\beta t=0$)",
    printed_product = R"($(\cos\beta t,\ \sin\beta t)\cdot(p_1,\ v_1-\alpha p_1\beta)=0$)",
    product = R"($(\cos\beta t,\ \sin\beta t)\cdot(p_1,\ (v_1-\alpha p_1)/\beta)=0$)",
    printed_pair = R"($(p_1,\ v_1-\alpha p_1\beta)$)", pair = R"($(p_1,\ (v_1-\alpha p_1)/\beta)$)",
    as_cotangent = R"($t=\frac1\beta\left(\frac\pi2+\tan^{-1}\frac{v_1-\alpha p_1}{\beta p_1}\right)$)",
    of_products =
        R"($t=\frac1\beta\left(\frac\pi2+\tan^{-1}\frac{(v-\alpha p)\cdot p}{\beta\,p\cdot p}\right)$)",
    principal = R"($t=\frac1\beta\tan^{-1}\frac{-\beta p_1}{v_1-\alpha p_1}$)";

/// lambda (-sin(beta t), cos(beta t)) where x is zero, which makes x' = beta e^(alpha t) lambda.
template <class T>
std::array<T, 2> turned(const T& alpha, const T& beta, const T& p, const T& v, const T& t) {
  const T lambda =
      derivative(oscillation(alpha, beta, p, T((v - alpha * p) / beta)), t) / (beta * exp(alpha * t));
  return {-lambda * sin(beta * t), lambda * cos(beta * t)};
}

/// In all directions, some along an axis, where the other coordinate is zero for ever.
std::vector<AtOrigin> in_all_directions(double seed) {
  std::vector<AtOrigin> all;
  Random any(seed);
  for (int i = 0; i < 60; ++i) {
    const double s = any.between(-2, 2), angle = any.between(0, 2 * pi);
    const double p1 = i % 3 == 0 ? 0 : std::cos(angle), p2 = i % 3 == 1 ? 0 : std::sin(angle);
    all.push_back({start_at(any, p1, p2, s)});
  }
  return all;
}

const Formula<Start> by_bisection{"the integrated motion's first sign change along $p$, by bisection",
                                  [](const Start& s) { return s.found.time; }};
const std::string when = "first time at the origin";

void arrivals(Claims& claims, double seed) {
  const std::vector<AtOrigin> there = in_all_directions(seed);
  const std::vector<Start> directions(there.begin(), there.end());
  claims.formula<AtOrigin>(
      "arrival_conditions", 1501,
      R"(With complex roots the ball is at the origin where $p_i\cos\beta t+\frac{v_i-\alpha p_i}\beta\sin\beta t=0$ )"
      R"(for $i=1$ and 2, as the exponential is not zero for finite time)",
      there,
      {.quantity = "the left sides where the integrated motion is at the origin",
       .truth = {"zero", [](const AtOrigin&) { return 0.0; }},
       .printed = {conditions},
       .changes_that_hold = "a factor of zero may have any size and sign"});
  claims.formula<Start>(
      "first_equation_suffices", 1515,
      R"(With complex roots, and $p\ne0$ and $v$ parallel, the first condition can be solved for the time (our )"
      R"(reading: the first $t>0$))",
      directions,
      {.quantity = when,
       .truth = by_bisection,
       .printed = {"the first condition alone, solved for $t$ by the inverse cotangent",
                   [](const Start& s) {
                     const auto& [m, c, a, p1, p2, v1, v2] = s.ball;
                     return (pi / 2 + std::atan((v1 - s.alpha() * p1) / (s.beta() * p1))) / s.beta();
                   }},
       .corrected = {of_products},
       .in_view = {"where $p_1$ is not zero", [](const Start& s) { return s.ball.p1 != 0; }},
       .kind = Fault::left_out,
       .root = "the first equation alone",
       .why =
           R"(Where $p_1=v_1=0$ the first condition reads $0=0$ and does not determine the time. With the )"
           R"(products by $p\ne0$ no direction is special.)"});

  std::vector<Start> oblique;
  Random any(seed);
  for (int i = 0; i < 50; ++i) {
    const double s = any.between(-2, 2), p1 = any.magnitude(0.2, 2), p2 = any.magnitude(0.2, 2);
    oblique.push_back(start_at(any, p1, p2, s));
  }
  claims.formula<Start>(
      "arrival_time", 1517,
      R"(With complex roots, and $p$ and $v$ parallel, $p_1\ne0$, the ball is at the origin at )"
      R"($t=\frac1\beta\tan^{-1}\frac{-\beta p_1}{v_1-\alpha p_1}$ (our reading: the principal value, and the )"
      R"(first $t>0$))",
      oblique,
      {.quantity = when,
       .truth = by_bisection,
       .printed = {principal},
       .corrected = {as_cotangent},
       .kind = Fault::formula,
       .root = "the arctangent's branch",
       .why =
           R"(The arctangent's principal value is negative whenever $(v_1-\alpha p_1)/p_1>0$, which includes )"
           R"(every ball let go at rest or moving away: the formula then names a time before the start. The )"
           R"(first arrival is $\pi/\beta$ later.)"});

  std::vector<Start> on_axis;
  any = Random(seed);
  for (int i = 0; i < 50; ++i) {
    const double s = any.between(-2, 2), p = any.magnitude(0.2, 2);
    const Start start = start_at(any, p, 0, s);
    on_axis.push_back(i % 5 == 0 ? moving_at(start.ball, start.alpha()) : start);
  }
  const auto denominator = [](const Start& s) { return s.ball.v1 - s.alpha() * s.ball.p1; };
  const auto is_number = [=](const Start& s) {
    return std::isfinite(-s.beta() * s.ball.p1 / denominator(s));
  };
  const auto arrives_at = [](const Start& s, double time) {
    return abs(s.found.time - time) <= s.found.known.allowed;
  };
  const auto after_quarter = [=](const Start& s) { return arrives_at(s, pi / (2 * s.beta())); };
  claims.statement<Start>(
      "arrival_quotient", 1517,
      R"(With complex roots, and $p$ and $v$ parallel, $p_1\ne0$, the quotient in the arrival's arctangent is a )"
      R"(number)",
      on_axis,
      {.printed = {R"($-\beta p_1/(v_1-\alpha p_1)$ is a number)", is_number},
       .corrected = {R"($-\beta p_1/(v_1-\alpha p_1)$ is a number where $v_1\ne\alpha p_1$, and )"
                     R"($(v_1-\alpha p_1)/(\beta p_1)$ everywhere)",
                     [=](const Start& s) {
                       const double cotangent = denominator(s) / (s.beta() * s.ball.p1);
                       return is_number(s) != after_quarter(s) &&
                              arrives_at(s, (pi / 2 + std::atan(cotangent)) / s.beta());
                     }},
       .in_view =
           {R"(where the integrated motion is not at the origin at $\pi/(2\beta)$, so that $v_1\ne\alpha p_1$)",
            [=](const Start& s) { return !after_quarter(s); }},
       .near_misses = {{R"($-\beta p_1/(v_1-\alpha p_1)$ is a number where $v_1\ne0$)",
                        [=](const Start& s) { return is_number(s) == (s.ball.v1 != 0); }}},
       .kind = Fault::left_out,
       .root = "a zero denominator",
       .why =
           R"(For $v_1=\alpha p_1$ the denominator is zero: the ball then moves towards the origin just so fast )"
           R"(that $x$ is a pure cosine except for its decay, and arrives at $t=\pi/(2\beta)$. The inverse )"
           R"(cotangent $\frac\pi2+\tan^{-1}$ divides by $\beta p_1$, and needs no $\pi/\beta$ to be added either.)"});

  const auto passing = [](std::string text, const std::vector<Start>& balls) -> Reading {
    WorstSample worst("$x$ at the integrated motion's first sign change along $p$", "closed form",
                      "the origin");
    for (const auto& [b, where, passage] : balls)
      worst.add(OneForm<double>{b}.at(passage.time), {0, 0},
                {passage.known.allowed * passage.speed,
                 "the way that the ball goes in the uncertainty of its passage"},
                std::hypot(b.p1, b.p2), where);
    return {std::move(text), {worst.check()}};
  };
  const Ball away = weak(1, 2, 1, 2), aside = weak(1, 2, 1, 1);
  std::vector<Start> either = directions;
  for (const Ball& ball : {away, weak(1, 2, 0, 0), weak(1, 2, -1, -2)})
    either.push_back(moving_at(ball, ball.v1));
  claims.add(
      "finite_time", 1525,
      R"(With complex roots, and $p\ne0$ and $v$ parallel, the ball reaches the origin in finite time)",
      {.printed = passing("it passes through the origin", directions),
       .near_misses = {passing("so it does for any $v$", {{aside, "$v=(1,1)$"}}),
                       passing("so it does with real roots", {{{1, 4, 5, 1, 2, 0, 0}, "$a=5$, at rest"}})}});
  claims.add(
      "velocity_points_to_origin", 1525,
      "With complex roots, a ball that reaches the origin has a velocity that points to the origin at the start",
      {.printed = {R"($p\cdot v<0$ in every start that arrives)",
                   {no_violations(filled(R"($p\cdot v\ge0$ though the ball arrives, $p=(@1,@1)$, $v=p$)",
                                         {away.p1, away.p2}),
                                  passing("", {{away, "$v=p$"}}).holds(), 1)}},
       .corrected = passing(
           R"(each start with $v$ parallel to $p\ne0$ arrives, in either direction, or with $v=0$)", either),
       .near_misses = {passing("any direction", {{aside, "$v=(1,1)$"}})},
       .why =
           R"(With complex roots and $p\ne0$, parallel is enough: a ball that moves straight away from the origin )"
           R"(turns round and comes back through it.)",
       .kind = Fault::counterexample,
       .root = "a ball that turns back"});

  const Start at_rest{weak(1, 0, 0, 0), ""};
  const Ball& b = at_rest.ball;
  std::vector<AtOrigin> starts;
  any = Random(seed);
  for (int i = 0; i < 100; ++i) {
    const double s = any.between(-2, 2), p = any.magnitude(0.2, 2);
    starts.push_back({start_at(any, p, 0, s)});
  }
  claims.formula<AtOrigin>(
      "dot_product", 1531,
      R"(Where $x_1$ is zero, $(\cos\beta t,\ \sin\beta t)\cdot(p_1,\ (v_1-\alpha p_1)/\beta)=0$ (the text has $i$ )"
      R"(for 1 and 2))",
      starts,
      {.quantity = R"(the pair's product with $(\cos\beta t,\ \sin\beta t)$)",
       .truth = {"zero", [](const AtOrigin&) { return 0.0; }},
       .printed = {printed_product},
       .meant = {product},
       .changes_that_hold = "a factor of zero may have any size and sign",
       .kind = Fault::lost_typography,
       .why = filled(
           "The fraction bar is lost in the text at hand, here and in line 1537; lines 1505 and 1511 show "
           "it. For $m=@1$, $c=@1$, $a=@1$ and $p=@1$ at rest the pair is $(@1,@2)$, and $(@1,@2)$ with the "
           "product.",
           {b.m, b.c, b.a, b.p1, b.p1, -at_rest.alpha() * b.p1 / at_rest.beta(), b.p1,
            -at_rest.alpha() * b.p1 * at_rest.beta()})});
  claims.formula<AtOrigin>(
      "turned_pair", 1537,
      R"(Where $x_1$ is zero, $(p_1,\ (v_1-\alpha p_1)/\beta)=\lambda_1(-\sin\beta t,\ \cos\beta t)$ (the text has $i$ )"
      R"(for 1 and 2))",
      starts,
      {.quantity = "the pair",
       .truth = {R"($\lambda_1(-\sin\beta t,\ \cos\beta t)$, $\lambda_1=\dot x_1/(\beta e^{\alpha t})$)",
                 [](const AtOrigin& s) {
                   return turned(s.alpha(), s.beta(), s.ball.p1, s.ball.v1, s.found.time);
                 }},
       .printed = {printed_pair},
       .meant = {pair},
       .kind = Fault::lost_typography,
       .why =
           "The fraction bar is lost in the text at hand, here and in line 1531; lines 1505 and 1511 show it."});
}

void not_parallel(Tables& tables, const std::vector<Pairs>& pairs, const std::vector<Aside>& samples) {
  tables.pairs.formula(
      "both_zero_parallel", 1541,
      R"(Where both coordinates are zero, $p$ and $(v-\alpha p)/\beta$ are parallel (the text has `beta` )"
      R"(for the letter))",
      pairs,
      {.quantity = R"($p_1k_2-p_2k_1$, $k=(v-\alpha p)/\beta$)",
       .truth = {"the vectors' product", [](const auto& s) { return s.p1 * s.k2 - s.p2 * s.k1; }},
       .printed = R"($(p_1\cos\beta t+k_1\sin\beta t)(k_2\cos\beta t-p_2\sin\beta t))"
                  R"(-(p_2\cos\beta t+k_2\sin\beta t)(k_1\cos\beta t-p_1\sin\beta t)$)"});
  tables.aside.formula(
      "not_parallel_never", 1541,
      R"(With complex roots, and $p$ and $v$ not parallel, the ball never reaches the origin in finite time )"
      R"((our check: $x_1\dot x_2-x_2\dot x_1$, which is zero there, is $e^{-at/m}(p_1v_2-p_2v_1)\ne0$))",
      samples,
      {.quantity = R"($x_1\dot x_2-x_2\dot x_1$ at $t$)",
       .truth = {"the closed form, differentiated by dual numbers",
                 [](const auto& s) { return s.momentum(); }},
       .printed = "$e^{-at/m}(p_1v_2-p_2v_1)$"});
}

void comes_to_rest(Claims& claims, const std::vector<Aside>& samples) {
  const auto near_zero = [](std::string text, double friction) -> Statement<Aside> {
    return {std::move(text), [friction](const Aside& s) {
              const double t = 80 * s.m / s.a, a = friction * s.a;
              return std::hypot(damped_oscillation(s.m, s.c, a, s.p1, s.v1)(t),
                                damped_oscillation(s.m, s.c, a, s.p2, s.v2)(t)) < 1e-12;
            }};
  };
  claims.statement<Aside>(
      "infinite_time", 1541,
      R"(With complex roots, and $p$ and $v$ not parallel, the ball reaches the origin in infinite time, since )"
      R"($e^{\alpha t}$ tends to zero for $\alpha<0$ (our check: at $t=40/|\alpha|$))",
      samples,
      {.printed = near_zero(R"($|x|<10^{-12}$ at $t=40/|\alpha|$)", 1),
       .near_misses = {near_zero(R"($|x|<10^{-12}$ then without friction, $\alpha=0$)", 0)}});
}

std::vector<Claim> claims(double seed) {
  Claims all("3.9");
  Random random(seed + 1);
  Tables tables(all);
  equations(tables, draw<Anywhere>(200, seed));
  const auto polynomials = next<Polynomial>(random, 300);
  characteristic_roots(tables.polynomial, polynomials);
  solutions(all, polynomials, seed, random);
  oscillations(tables, next<Oscillation>(random, 200), draw<StartOfOne>(200, seed),
               draw<UnderDamped>(200, seed));
  parallel(tables, draw<Vectors>(200, seed), draw<InLine>(200, seed));
  arrivals(all, seed);
  const auto aside = next<Aside>(random, 200);
  not_parallel(tables, draw<Pairs>(200, seed), aside);
  comes_to_rest(all, aside);
  return all.in_order();
}

namespace {

template <template <class> class Of>
ForAll<Of> any(const std::vector<std::string>& names, const std::string& tactic) {
  return {.any = lettered<Of>(names),
          .letters = quantified(names),
          .tactic = tactic,
          .says = "it holds for any ball"};
}

/// Assumes that all are above zero.
std::vector<Proposition> positive(std::initializer_list<Shortened> all) {
  std::vector<Proposition> given;
  for (const Shortened& x : all) given.push_back(above(x.expression(), 0));
  return given;
}

/// A coordinate at a time.
struct AtTime {
  Shortened alpha = Shortened::letter("alpha"), beta = Shortened::letter("beta"), p = Shortened::letter("p"),
            v = Shortened::letter("v"), t = Shortened::letter("t");

  Expressions of(const std::string& text) const {
    return recorded_text(
        text,
        {{R"(\alpha)", alpha}, {R"(\beta)", beta}, {"p_1", p}, {"v_1", v}, {"p", p}, {"v", v}, {"t", t}});
  }
  Proposition is_zero() const {
    return oscillation(alpha, beta, p, (v - alpha * p) / beta)(t).expression() == Expression(0);
  }
  Expressions turned() const { return detail::recorded_value(ex03_09::turned(alpha, beta, p, v, t)); }
};

/// Proofs of the claims on zeros of a coordinate.
Provables proofs_at_zeros() {
  const AtTime any, cosine{-1, 2, 1, -1, pi_of<Shortened>() / 4};  // v = alpha p: zero at pi/(2 beta)
  const std::string letters = "(alpha beta p v t : R)";
  const auto off = [&](const Expression& printed, const Expression& is) -> Lemma {
    return {"printed_differs",
            "",
            {},
            {near(oscillation<Shortened>(-1, 2, 1, 0)(cosine.t).expression(), 0, 1e-10),
             apart(printed, is, 0.99)},
            "interval"};
  };
  const std::string as_meant =
      "as meant it holds wherever a coordinate is zero; as printed it is off at an example";
  return {{"3.9-arrival_conditions",
           "it holds wherever a coordinate is zero",
           {{"printed", letters, {any.is_zero()}, {any.of(conditions)[0] == Expression(0)}, "pairing"}}},
          {"3.9-dot_product",
           as_meant,
           {{"meant", letters, {any.is_zero()}, {any.of(product)[0] == Expression(0)}, "pairing"},
            off(cosine.of(printed_product)[0], 0)},
           0.99},
          {"3.9-turned_pair",
           as_meant,
           {{"meant",
             letters,
             {not_zero(any.beta.expression()), any.is_zero()},
             equal(any.of(pair), any.turned()),
             "turned_pair alpha beta p v t"},
            off(cosine.of(printed_pair)[1], cosine.turned()[1])},
           0.99}};
}

/// Proofs that coordinates are zero at the corrected times, which are within half a turn.
Provables proofs_of_arrivals() {
  AtTime one;
  const Shortened p1 = Shortened::letter("p1"), p2 = Shortened::letter("p2"), s = Shortened::letter("s");
  const auto within = [&](std::vector<Proposition> zeros, const Shortened& time) {
    zeros.push_back(above(time.expression(), 0));
    zeros.push_back(above((pi_of<Shortened>() / one.beta - time).expression(), 0));
    return zeros;
  };
  const Proposition turns = above(one.beta.expression(), 0);
  one.t = one.of(as_cotangent)[0];
  const Lemma of_one{"corrected",
                     "(alpha beta p v : R)",
                     {turns, not_zero(one.p.expression())},
                     within({one.is_zero()}, one.t),
                     "arriving beta"};
  const AtTime at_rest{-1, 2, 1, 0, {}};
  const Lemma early{"printed_differs",
                    "",
                    {},
                    {above((-Shortened(at_rest.of(principal)[0])).expression(), 0.5)},
                    "interval"};

  const Shortened time = recorded_text(of_products, {{R"(\alpha)", one.alpha},
                                                     {R"(\beta)", one.beta},
                                                     {"p", {p1, p2}},
                                                     {"v", {s * p1, s * p2}},
                                                     {"t", 0}})[0];
  const auto zero = [&](const Shortened& p) { return AtTime{one.alpha, one.beta, p, s * p, time}.is_zero(); };
  const auto of_both = [&](const std::string& reading) -> Lemma {
    return {reading,
            "(alpha beta p1 p2 s : R)",
            {turns, above((p1 * p1 + p2 * p2).expression(), 0)},
            within({zero(p1), zero(p2)}, time),
            "arriving beta"};
  };
  const std::string both_zero = "both coordinates are zero at the corrected time, between 0 and pi/beta";
  return {
      {"3.9-arrival_time",
       "the coordinate is zero at the corrected time, between 0 and pi/beta; the printed one is negative at "
       "an example",
       {of_one, early},
       0.5},
      {"3.9-first_equation_suffices", both_zero, {of_both("corrected")}},
      {"3.9-finite_time", both_zero, {of_both("printed")}}};
}

Provables by_hand() {
  auto over = any<OverDampedOf>({"m", "c", "a", "p", "v", "t"}, "damped");
  const auto& s = over.any;
  over.given = positive({s.m, s.a * s.a - 4 * s.m * s.c});
  const Lemma solves{"corrected", over.letters, over.given,
                     equal(two_exponentials_put_in().recorded(s), as_asked<OverDampedOf>.recorded(s)),
                     over.tactic};

  const auto doubled = put_in<OverDampedOf>("", [](const auto& b) {
    return [=, r = -b.a / (2 * b.m)](const auto& t) { return (b.p + (b.v - r * b.p) * t) * exp(r * t); };
  });
  const Lemma double_root{
      "double_root",
      over.letters,
      {above(s.m.expression(), 0), (s.a * s.a).expression() == (4 * s.m * s.c).expression()},
      equal(doubled.recorded(s), as_asked<OverDampedOf>.recorded(s)),
      "twice"};
  const auto thrown = two_exponentials<Shortened>(1, 4, 5, 1, -9);
  const Expression passing = log(Expression(8) / 5) / 3;
  const Lemma passes{"corrected",
                     "",
                     {},
                     {above(passing, 0), near(thrown(Shortened(passing)).expression(), 0, 1e-10)},
                     "interval"},
      passed{"printed_differs", "", {}, {above((-thrown(Shortened(1))).expression(), 0.5)}, "interval"};
  return {
      {"3.9-two_exponentials",
       "where the roots differ it solves the equation from any start; at a double root the other form does",
       {solves, double_root}},
      {"3.9-overdamped_never_arrives",
       "the ball thrown at the origin is there at ln(8/5)/3, to ten digits, and beyond it at 1",
       {passes, passed},
       0.5}};
}

}  // namespace

Provable proof_of_negative_roots(const ForAll<PolynomialOf>& all) {
  const auto& s = all.any;
  const auto first = s.root(1), second = s.root(-1);
  const Shortened square = s.a * s.a - 4 * s.m * s.c;
  const auto lemma = [&](const std::string& name, const Proposition& where, const auto& imaginary) -> Lemma {
    std::vector<Proposition> given = all.given;
    given.push_back(where);
    return {name,
            all.letters,
            given,
            {above((-first.re).expression(), 0), above((-second.re).expression(), 0),
             imaginary(first.im.expression()), imaginary(second.im.expression())},
            "signs_of_the_parts m c a"};
  };
  return {"3.9-negative_roots",
          "both parts are as stated for any ball",
          {lemma("real", {square.expression().coq() + " >= 0"},
                 [](const Expression& x) { return x == Expression(0); }),
           lemma("complex", above((4 * s.m * s.c - s.a * s.a).expression(), 0), not_zero)}};
}

Provables table_of_roots(const ProvableClaims<PolynomialOf>& table, const ForAll<PolynomialOf>& all) {
  Provables proved = table.proofs("3.9", all);
  proved.push_back(proof_of_negative_roots(all));
  for (Provable& proof : proved) proof.preamble = parts_in_coq;
  return proved;
}

Provables proofs() {
  Claims claims("3.9");
  Tables tables(claims);
  equations(tables, {});
  characteristic_roots(tables.polynomial, {});
  oscillations(tables, {}, {}, {});
  parallel(tables, {}, {});
  not_parallel(tables, {}, {});
  Provables all;
  const auto take = [&](const auto& table, const auto& letters) {
    for (Provable& proof : table.proofs("3.9", letters)) {
      proof.preamble = damped_in_coq;
      all.push_back(std::move(proof));
    }
  };
  auto anywhere =
      any<AnywhereOf>({"m", "c", "a", "x1", "x2", "v1", "v2"}, "field; repeat split; apply Rgt_not_eq; nra");
  anywhere.given = positive({anywhere.any.m});
  take(tables.anywhere, anywhere);
  auto polynomial = any<PolynomialOf>({"m", "c", "a", "r", "t"}, "by_parts_of_the_root m c a");
  const auto& k = polynomial.any;
  polynomial.given = positive({k.m, k.c, k.a});
  polynomial.example.m = 1, polynomial.example.c = 3, polynomial.example.a = 2,
  polynomial.example.r = polynomial.example.t = 1;
  for (Provable& proof : table_of_roots(tables.polynomial, polynomial)) all.push_back(std::move(proof));
  take(tables.oscillation,
       any<OscillationOf>({"alpha", "beta", "k1", "k2", "t"}, "rewrite ?exp_0, ?cos_0, ?sin_0; field"));
  auto start =
      any<StartOfOneOf>({"alpha", "beta", "p", "v"}, "rewrite ?exp_0, ?cos_0, ?sin_0; field; trivial");
  start.given = {not_zero(start.any.beta.expression())};
  take(tables.start, start);
  const std::vector<std::string> letters{"m", "c", "a", "p", "v", "t"};
  auto under = any<UnderDampedOf>(letters, "damped");
  under.given = positive({under.any.m, 4 * under.any.m * under.any.c - under.any.a * under.any.a});
  take(tables.under_damped, under);
  auto vectors = any<VectorsOf>({"p1", "p2", "v1", "v2", "alpha", "beta"}, "field; trivial");
  vectors.given = {not_zero(vectors.any.beta.expression())};
  take(tables.vectors, vectors);
  take(tables.pairs, any<PairsOf>({"p1", "p2", "k1", "k2", "z"}, by_angles({"z"}, "ring")));
  auto aside = any<AsideOf>({"m", "c", "a", "t", "p1", "p2", "v1", "v2"}, "turning");
  aside.given = positive({aside.any.m, 4 * aside.any.m * aside.any.c - aside.any.a * aside.any.a});
  take(tables.aside, aside);
  auto in_line = any<InLineOf>({"m", "c", "a", "t", "p1", "p2", "s"}, "damped");
  in_line.given =
      positive({in_line.any.m, 4 * in_line.any.m * in_line.any.c - in_line.any.a * in_line.any.a});
  take(tables.in_line, in_line);
  for (const auto& some : {by_hand(), proofs_at_zeros(), proofs_of_arrivals()})
    for (Provable proof : some) {
      proof.preamble = damped_in_coq;
      all.push_back(std::move(proof));
    }
  return all;
}

std::vector<Root> roots() {
  using F = Frictions;
  constexpr double second = 1;
  const double critical = 2 * sqrt(F::m * F::c), stronger = 2 * critical, strong = 10 * critical;
  const Passing thrown;
  const Start at_rest{weak(1, 0, 0, 0), ""}, across{weak(0, 1, 0, 0), ""};
  const double alpha = at_rest.alpha();
  const Start cosine{weak(1, 0, alpha, 0), ""}, away{weak(1, 2, 1, 2), ""};
  const auto& [m, c, a, p1, p2, v1, v2] = away.ball;
  const double by_formula = std::atan(-at_rest.beta() / -alpha) / at_rest.beta();
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
           {thrown.factor(), thrown.ball.m, thrown.ball.c, thrown.ball.a, thrown.time(), thrown.speed()})},
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
              {m, c, a, across.found.time})},
      {"the arctangent's branch",
       filled(R"(For $m=@1$, $c=@1$, $a=@1$ and a start at rest the formula gives $@3$ s, not @3 s. A game )"
              R"(that schedules the hit for that moment puts it into the past, and the event never fires.)",
              {m, c, a, by_formula, at_rest.found.time})},
      {"a zero denominator",
       filled(R"(With $m=@1$, $c=@1$, $a=@1$ and $v=@1\,p$ the ball is at the origin after @3 s. The result )"
              R"(of a program that divides depends on how it treats $p_1/0$.)",
              {m, c, a, alpha, cosine.found.time})},
      {"a ball that turns back",
       filled(
           R"(With $m=@1$, $c=@1$, $a=@1$, a ball sent off from $(@1,@1)$ m at $(@1,@1)$ m/s is back at the origin )"
           R"(after @3 s: a game that tests $p\cdot v<0$ leaves this hit out.)",
           {m, c, a, p1, p2, v1, v2, away.found.time})}};
}

}  // namespace oddity::ex03_09

namespace oddity {

Provables proofs_3_9() { return ex03_09::proofs(); }

}  // namespace oddity
