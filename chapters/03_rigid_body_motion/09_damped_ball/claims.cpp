// The claims of exercise 3.9. The equations are derived from L = m|x'|^2/2 - c|x|^2/2 and Rayleigh's
// dissipation a|x'|^2/2 by dual numbers. The published solutions are substituted in the differential
// equation, with their derivatives by dual numbers. Letters: r1 > r2 are the real roots of m r^2 + a r + c;
// alpha, beta are the parts of the complex ones.

#include <algorithm>
#include <cmath>
#include <complex>
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

/// The characteristic polynomial's coefficients, its roots by the text, and any number r.
template <class T>
struct PolynomialOf {
  T m, c, a, r;
  PolynomialOf() = default;
  explicit PolynomialOf(Random& random)
      : m(random.between(0.1, 3)),
        c(random.between(0.1, 3)),
        a(random.between(0.1, 9)),
        r(random.between(-3, 3)) {}
  std::array<T*, 4> letters() { return {&m, &c, &a, &r}; }
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
  /// The real part of m (r - r1) (r - r2); the imaginary part is zero.
  T by_roots() const {
    const ComplexOf<T> x = root(1), y = root(-1);
    return m * ((r - x.re) * (r - y.re) - x.im * y.im);
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

/// The book's two exponentials as a function of the time.
template <class T>
auto two_exponentials(const T& m, const T& c, const T& a, const T& p, const T& v) {
  const T root = sqrt(a * a - 4 * m * c), r1 = (-a + root) / (2 * m), r2 = (-a - root) / (2 * m);
  const T k1 = (v - r2 * p) / (r1 - r2);
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

/// Constants of the solution for two real roots; the mass is 1, the spring 4.
struct Constants {
  double a, k1, k2;
  explicit Constants(Random& random)
      : a(random.between(4.1, 20)), k1(random.magnitude(1e-3, 1e3)), k2(random.magnitude(1e-3, 1e3)) {}
  std::string where() const {
    return "$a$ = " + format_significant(a, 4) + ", $K_1$ = " + format_significant(k1, 4) +
           ", $K_2$ = " + format_significant(k2, 4);
  }
  TypesetLetters typeset() const { return {{"x(100)", at(100)}, {"x(500)", at(500)}}; }
  double at(double t) const {
    const double root = sqrt(a * a - 16);
    return k1 * std::exp((-a + root) / 2 * t) + k2 * std::exp((-a - root) / 2 * t);
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
  double speed() const {  ///< relative to |p|, when it passes the origin
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

/// A ball that does not start towards the origin; the mass is 1, the spring 4.
template <class T>
struct AsideOf {
  T p1, p2, v1, v2, a, t;
  AsideOf() = default;
  explicit AsideOf(Random& random) {
    const auto p = random.point(2), v = random.point(2);
    p1 = p[0], p2 = p[1], v1 = v[0], v2 = v[1];
    a = random.between(0.1, 3.5);
    t = random.between(0.1, 6);
  }
  std::array<T*, 6> letters() { return {&a, &t, &p1, &p2, &v1, &v2}; }
  TypesetIn<T> typeset() const {
    return {{"a", a}, {"t", t}, {"p_1", p1}, {"p_2", p2}, {"v_1", v1}, {"v_2", v2}};
  }
  std::string where() const {
    return "$a$ = " + format_significant(a, 4) + ", $t$ = " + format_significant(t, 4);
  }
  T momentum() const {
    const auto x1 = damped_oscillation(1, 4, a, p1, v1), x2 = damped_oscillation(1, 4, a, p2, v2);
    return x1(t) * derivative(x2, t) - x2(t) * derivative(x1, t);
  }
};
using Aside = AsideOf<double>;

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

  explicit Tables(Claims& claims)
      : anywhere(claims),
        polynomial(claims),
        oscillation(claims),
        start(claims),
        under_damped(claims),
        vectors(claims),
        pairs(claims),
        aside(claims) {}
};

ProvableFormula<OverDampedOf> two_exponentials_put_in() {
  return put_in<OverDampedOf>("the two exponentials, differentiated by dual numbers",
                              [](const auto& s) { return two_exponentials(s.m, s.c, s.a, s.p, s.v); });
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
      "characteristic_polynomial", 1453, "The characteristic polynomial is $mr^2+ar+{}$, and no more",
      polynomials,
      {.quantity = "the polynomial at any $r$",
       .truth = {"$m(r-r_1)(r-r_2)$ with the roots that the text has",
                 [](const auto& s) { return s.by_roots(); }},
       .printed = "$mr^2+ar$",
       .meant = "$mr^2+ar+c$",
       .kind = Fault::formula,
       .why = "The last coefficient, $c$, is missing after its plus sign; the roots that follow have it."});
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
  claims.add(
      "two_exponentials", 1469, "The general solution for real roots is $x=K_1e^{r_1t}+K_2e^{r_2t}$",
      {.printed = {R"($K_1e^{r_1t}+K_2e^{r_2t}$, for $r_1=r_2$ as well)",
                   {at_double_root("two exponentials", TwoExponentials<double>{critical}.at(1))}},
       .corrected =
           {R"($K_1e^{r_1t}+K_2e^{r_2t}$ for $r_1\ne r_2$, and $(K_1+K_2t)\,e^{rt}$ for a double root $r$)",
            {compare<OverDamped>(put_in_quantity, two_exponentials_put_in(), as_asked<OverDampedOf>,
                                 draw<OverDamped>(200, seed)),
             at_double_root("the limit of the two regimes", OneForm<double>{critical}.at(1))}},
       .in_view = {"where the roots differ",
                   {compare<OverDamped>(put_in_quantity, two_exponentials_put_in(), as_asked<OverDampedOf>,
                                        draw<OverDamped>(200, seed))}},
       .near_misses = {{"$(p+vt)\\,e^{rt}$ for a double root $r$",
                        {at_double_root("$(p+vt)\\,e^{-2t}$",
                                        {std::exp(-2.0) * (1 + 0.0), std::exp(-2.0) * (0.5 + 1.5)})}}},
       .why =
           R"(Case 1 includes $a^2=4mc$, where both exponentials are the same function: two starting values )"
           R"(cannot be met, and the formulas for $K_1$ and $K_2$ divide by zero. With roots that differ by )"
           R"(very little the two exponentials are still right, but they are large and of opposite sign, and )"
           R"(their sum loses digits (see `near_critical`).)",
       .kind = Fault::left_out,
       .root = "the double root"});

  claims.statement<Constants>(
      "limit", 1471,
      "Whatever $K_1$ and $K_2$, $x(t)$ tends to zero (our check: at $t=500$, with $m=1$ and $c=4$)",
      next<Constants>(random, 200),
      {.printed = {"$|x(500)|<10^{-12}$"},
       .near_misses = {{R"(without the spring, $c=0$, $|x(500)|<10^{-12}$)",
                        [](const Constants& s) { return abs(s.k1 + s.k2 * std::exp(-s.a * 500)) < 1e-12; }},
                       {"$|x(100)|<10^{-12}$"}}});

  const Passing throw_in;
  const Ball& thrown = throw_in.ball;
  const auto& [r1, r2, k1, k2] = throw_in.terms;
  const auto passes = [&](std::string text, double time) -> Reading {
    return {std::move(text),
            {{"$x$ at $t=" + format_significant(time, 3) + "$",
              {"closed form", OneForm<double>{thrown}.at(time)},
              {"the origin", {0, 0}},
              rounding(2),
              2}}};
  };
  claims.add(
      "overdamped_never_arrives", 1477,
      "With real roots the ball reaches the origin after an infinite time (our reading: and not before)",
      {.printed = {"$|x|>0$ for all $t$",
                   {no_violations(
                       "$x_1(1)$ has changed its sign: the origin is passed by then",
                       OneForm<double>{thrown}.at(1)[0] < 0, 1,
                       filled("$m=@1$, $c=@1$, $a=@1$, $p=(@1,@1)$, $v=@1p$",
                              {thrown.m, thrown.c, thrown.a, thrown.p1, thrown.p2, throw_in.factor()}))}},
       .corrected = passes("a ball thrown at the origin faster than $|r_2||p|$ passes it once, at "
                           "$e^{(r_1-r_2)t}=-K_2/K_1$",
                           throw_in.time()),
       .near_misses = {passes("at $e^{(r_1-r_2)t}=-K_1/K_2$", std::log(-k1 / k2) / (r1 - r2)),
                       passes("at $e^{r_1t}=-K_2/K_1$", std::log(-k2 / k1) / r1)},
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
      "With real roots, the larger the friction, the sooner the ball is nearly at the origin",
      next<Frictions>(random, 100),
      {.printed = {filled("the distance left after @1 s, let go at rest, falls with $a$",
                          {Frictions::seconds}),
                   [](const Frictions& s) { return s.left(s.b) < s.left(s.a); }},
       .corrected = {R"(it grows with $a$ beyond the critical $2\sqrt{mc}$)",
                     [](const Frictions& s) { return s.left(s.b) > s.left(s.a); }},
       .near_misses = {{"it grows with $a$ from a fifteenth of that on",
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
  tables.oscillation.formula(
      "arrival_conditions", 1501,
      R"(A coordinate is zero where $K_1\cos\beta t+K_2\sin\beta t$ is, as the exponential is not zero for finite time)",
      samples,
      {.quantity = R"($x/e^{\alpha t}$)",
       .truth = {R"($x$, divided by its exponential)",
                 [](const auto& s) {
                   return oscillation(s.alpha, s.beta, s.k1, s.k2)(s.t) / exp(s.alpha * s.t);
                 }},
       .printed = R"($K_1\cos\beta t+K_2\sin\beta t$)"});
  tables.start.formula("constants", 1489,
                       R"($x(0)=p$ and $\dot x(0)=v$ lead to $K_1=p$, $K_2=(v-\alpha p)/\beta$)", starts,
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
/// there, divided by the slope.
struct Passage {
  double time;
  Tolerance known;
};

/// First positive time at the origin, found by marching and bisection on the projection along p.
Passage first_passage(const Ball& b) {
  const auto x = [&](double t) {
    const auto at = OneForm<double>{b}.at(t);
    return at[0] * b.p1 + at[1] * b.p2;
  };
  const double rate = sqrt(b.c / b.m), step = 1e-3 / rate;
  double t = 0;
  while (x(t) * x(t + step) > 0) t += step;
  double low = t, high = t + step;
  for (int i = 0; i < 60; ++i) (x(low) * x((low + high) / 2) > 0 ? low : high) = (low + high) / 2;
  const double slope = b.p1 * derivative(damped_oscillation(b.m, b.c, b.a, b.p1, b.v1), low) +
                       b.p2 * derivative(damped_oscillation(b.m, b.c, b.a, b.p2, b.v2), low);
  const double terms =
      abs(b.p1) * (abs(b.p1) + abs(b.v1) / rate) + abs(b.p2) * (abs(b.p2) + abs(b.v2) / rate);
  return {low, rounding(low + terms / abs(slope))};
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

/// A ball at p whose velocity is `speed` times p, with any friction below the critical.
Start start_at(Random& any, double p1, double p2, double speed) {
  const double m = any.between(0.3, 3), c = any.between(0.3, 4),
               a = 2 * sqrt(m * c) * any.between(0.03, 0.95);
  return {{m, c, a, p1, p2, speed * p1, speed * p2},
          "$m$ = " + format_significant(m, 4) + ", $c$ = " + format_significant(c, 4) +
              ", $a$ = " + format_significant(a, 4) + ", $p$ = (" + format_significant(p1, 4) + ", " +
              format_significant(p2, 4) + "), $v$ = " + format_significant(speed, 4) + " $p$"};
}

double forward(double angle) { return angle < 0 ? angle + pi : angle; }

void parallel(Tables& tables, const std::vector<Vectors>& samples) {
  tables.vectors.formula(
      "parallel", 1515,
      R"($p$ and $(v-\alpha p)/\beta$ are parallel when $p$ and $v$ are (the text's parenthesis does not )"
      R"(close))",
      samples,
      {.quantity = R"($\beta$ times the vectors' product)",
       .truth = {R"($\beta\,p\times(v-\alpha p)/\beta$)",
                 [](const auto& s) {
                   return s.beta * (s.p1 * ((s.v2 - s.alpha * s.p2) / s.beta) -
                                    s.p2 * ((s.v1 - s.alpha * s.p1) / s.beta));
                 }},
       .printed = "$p_1v_2-p_2v_1$"});
}

const std::string printed_pair = R"($(p_1,\ v_1-\alpha p_1\beta)\cdot(\cos\beta t,\ \sin\beta t)=0$)",
                  pair = R"($(p_1,\ (v_1-\alpha p_1)/\beta)\cdot(\cos\beta t,\ \sin\beta t)=0$)";

void arrivals(Claims& claims, double seed) {
  // In all directions; some are along an axis, so the other coordinate is always zero.
  std::vector<Start> directions;
  Random any(seed);
  for (int i = 0; i < 60; ++i) {
    const double s = any.between(-2, 2), angle = any.between(0, 2 * pi);
    const double p1 = i % 3 == 0 ? 0 : std::cos(angle), p2 = i % 3 == 1 ? 0 : std::sin(angle);
    directions.push_back(start_at(any, p1, p2, s));
  }
  const Formula<Start> by_bisection{R"(the sign change of $x\cdot p$, by bisection)",
                                    [](const Start& s) { return s.found.time; }};
  const std::string when = "first time at the origin",
                    as_cotangent =
                        R"($t=\frac1\beta\left(\frac\pi2+\tan^{-1}\frac{v_1-\alpha p_1}{\beta p_1}\right)$)";
  claims.formula<Start>(
      "first_equation_suffices", 1515,
      "For $p$ and $v$ parallel the two equations are one, and the first can be solved for the time",
      directions,
      {.quantity = when,
       .truth = by_bisection,
       .printed = {as_cotangent},
       .corrected =
           {R"($t=\frac1\beta\left(\frac\pi2+\tan^{-1}\frac{(v-\alpha p)\cdot p}{\beta\,p\cdot p}\right)$)"},
       .in_view = {"where $p_1$ is not zero", [](const Start& s) { return s.ball.p1 != 0; }},
       .kind = Fault::left_out,
       .root = "the first equation alone",
       .why = R"(Where $p_1=v_1=0$ the first equation reads $0=0$, and the arctangent is of $0/0$. With the )"
              R"(products by $p$ no direction is special.)"});

  std::vector<Start> oblique;
  any = Random(seed);
  for (int i = 0; i < 50; ++i) {
    const double s = any.between(-2, 2), p1 = any.magnitude(0.2, 2), p2 = any.magnitude(0.2, 2);
    oblique.push_back(start_at(any, p1, p2, s));
  }
  claims.formula<Start>(
      "arrival_time", 1517,
      R"(For $p$ and $v$ parallel the ball is at the origin at $t=\frac1\beta\tan^{-1}\frac{-\beta )"
      R"(p_1}{v_1-\alpha p_1}$)",
      oblique,
      {.quantity = when,
       .truth = by_bisection,
       .printed = {R"($t=\frac1\beta\tan^{-1}\frac{-\beta p_1}{v_1-\alpha p_1}$)"},
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
    Ball ball = start.ball;
    if (i % 5 == 0) ball.v1 = start.alpha() * p;
    on_axis.push_back({ball, start.told + (i % 5 == 0 ? R"(, but $v=\alpha p$)" : "")});
  }
  claims.formula<Start>(
      "arrival_quotient", 1517,
      R"(The quotient in the arrival's arctangent, $-\beta p_1/(v_1-\alpha p_1)$, is a number (our reading: )"
      R"(unless it is $0/0$))",
      on_axis,
      {.quantity = when,
       .truth = by_bisection,
       .printed =
           {R"($t=\frac1\beta\tan^{-1}\frac{-\beta p_1}{v_1-\alpha p_1}$, plus $\pi/\beta$ where negative; no number for $v_1=\alpha p_1$)",
            [](const Start& s) {
              const double x = s.ball.v1 - s.alpha() * s.ball.p1;
              return x == 0 ? std::numeric_limits<double>::quiet_NaN()
                            : forward(std::atan(-s.beta() * s.ball.p1 / x)) / s.beta();
            }},
       .corrected = {as_cotangent},
       .in_view = {R"(where $v_1$ is not $\alpha p_1$)",
                   [](const Start& s) { return s.ball.v1 != s.alpha() * s.ball.p1; }},
       .kind = Fault::left_out,
       .root = "a zero denominator",
       .why =
           R"(For $v_1=\alpha p_1$ the denominator is zero: the ball then moves towards the origin just so fast )"
           R"(that $x$ is a pure cosine but for its decay, and arrives at $t=\pi/(2\beta)$. The inverse )"
           R"(cotangent $\frac\pi2+\tan^{-1}$ divides by $\beta p_1$, and needs no $\pi/\beta$ to be added either.)"});

  const auto passing = [](std::string text, const std::vector<Start>& balls) -> Reading {
    WorstSample worst(R"($x$ at the first sign change of $x\cdot p$)", "closed form", "the origin");
    for (const auto& [b, where, passage] : balls) {
      const auto [time, known] = passage;
      const double speed = std::hypot(derivative(damped_oscillation(b.m, b.c, b.a, b.p1, b.v1), time),
                                      derivative(damped_oscillation(b.m, b.c, b.a, b.p2, b.v2), time));
      worst.add(OneForm<double>{b}.at(time), {0, 0},
                {known.allowed * speed, "the way that the ball goes in the uncertainty of its passage"},
                std::hypot(b.p1, b.p2), where);
    }
    return {std::move(text), {worst.check()}};
  };
  const Ball away = weak(1, 2, 1, 2), aside = weak(1, 2, 1, 1);
  const Reading returns = passing("$p$ and $v$ parallel, in either direction", {{away, "$v=p$"}});
  claims.add("finite_time", 1525, "For $p$ and $v$ parallel the ball reaches the origin in finite time",
             {.printed = passing("it passes through the origin", directions),
              .near_misses = {passing("so it does for any $v$", {{aside, "$v=(1,1)$"}})}});
  claims.add(
      "velocity_points_to_origin", 1525,
      "A ball that reaches the origin has a velocity that points to the origin at the start",
      {.printed = {R"($p\cdot v<0$ in every start that arrives)",
                   {no_violations(filled(R"($p\cdot v\ge0$ though the ball arrives, $p=(@1,@1)$, $v=p$)",
                                         {away.p1, away.p2}),
                                  returns.holds(), 1)}},
       .corrected = returns,
       .near_misses = {passing("any direction", {{aside, "$v=(1,1)$"}})},
       .why =
           "Parallel is enough: a ball that moves straight away from the origin turns round and comes back "
           "through it.",
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
      "turned_pair", 1537,
      R"(Where a coordinate is zero, the pair $(p_i,\;(v_i-\alpha p_i)/\beta)$ is along $(-\sin\beta )"
      R"(t,\cos\beta t)$)",
      starts,
      {.quantity = R"(the pair's product with $(\cos\beta t,\ \sin\beta t)$)",
       .truth = {"zero", [](const AtOrigin&) { return 0.0; }},
       .printed = {printed_pair},
       .meant = {pair},
       .changes_that_hold = "a factor of zero may have any size and sign",
       .kind = Fault::lost_typography,
       .why = filled(
           "The fraction bar is lost in the text at hand, here and in line 1529; lines 1505 and 1511 have "
           "it. For $m=@1$, $c=@1$, $a=@1$ and $p=@1$ at rest the pair is $(@1,@2)$, and $(@1,@2)$ with the "
           "product.",
           {b.m, b.c, b.a, b.p1, b.p1, -at_rest.alpha() * b.p1 / at_rest.beta(), b.p1,
            -at_rest.alpha() * b.p1 * at_rest.beta()})});
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
  tables.aside.formula("not_parallel_never", 1541,
                       "For $p$ and $v$ not parallel the ball never reaches the origin in finite time",
                       samples,
                       {.quantity = R"($x_1\dot x_2-x_2\dot x_1$ at $t$, for $m=1$ and $c=4$)",
                        .truth = {"the closed form, differentiated by dual numbers",
                                  [](const auto& s) { return s.momentum(); }},
                        .printed = "$e^{-at}(p_1v_2-p_2v_1)$"});
}

void comes_to_rest(Claims& claims, const std::vector<UnderDamped>& samples) {
  const auto near_zero = [](std::string text, double friction) -> Statement<UnderDamped> {
    return {std::move(text), [friction](const UnderDamped& s) {
              const double t = 80 * s.m / s.a;
              return abs(damped_oscillation(s.m, s.c, friction * s.a, s.p, s.v)(t)) < 1e-12;
            }};
  };
  claims.statement<UnderDamped>(
      "infinite_time", 1541,
      R"(The ball reaches the origin in infinite time, since $e^{\alpha t}$ tends to zero for $\alpha<0$ (our )"
      R"(check: at $t=40/|\alpha|$))",
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
  parallel(tables, draw<Vectors>(200, seed));
  arrivals(all, seed);
  not_parallel(tables, draw<Pairs>(200, seed), next<Aside>(random, 200));
  comes_to_rest(all, draw<UnderDamped>(200, seed));
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

constexpr const char* damped_in_coq = R"(
Local Open Scope R_scope.
Lemma root_of : forall x, x > 0 -> sqrt x > 0 /\ sqrt x * sqrt x = x.
Proof. intros x P. split; [now apply sqrt_lt_R0 | apply sqrt_sqrt; lra]. Qed.
Ltac damped :=
  rewrite ?exp_0, ?cos_0, ?sin_0;
  match goal with P : ?d > 0 |- context [sqrt ?d] =>
    let Q := fresh in let e := fresh in let r := fresh in
    destruct (root_of d P) as [Q e]; generalize dependent (sqrt d); intros r Q e;
    field [e]; repeat split; nra
  end.
Ltac turning :=
  match goal with |- exp ?y * _ = exp ?x * (_ * cos ?z + _) * _ - _ =>
    let e := fresh in let f := fresh in
    assert (e : exp y = exp x * exp x) by (rewrite <- exp_plus; f_equal; field); rewrite e; clear e;
    assert (f : sin z * sin z = 1 - cos z * cos z)
      by (pose proof (sin2_cos2 z) as f; unfold Rsqr in f; lra);
    generalize dependent (sin z); intro; generalize (cos z); intros;
    match goal with P : _ > 0 |- context [sqrt ?d] =>
      assert (sqrt d > 0) by (apply sqrt_lt_R0; lra); field [f]; lra
    end
  end.
Ltac twice :=
  rewrite ?exp_0;
  match goal with P : ?m > 0, Q : ?a * ?a = 4 * ?m * ?c |- _ =>
    assert (c = a * a / (4 * m)) by (rewrite Q; field; lra); subst c; field; lra
  end.
Ltac pairing :=
  match goal with Z : exp ?y * _ = 0 |- _ =>
    pose proof (exp_pos y); apply Rmult_integral in Z; destruct Z as [Z | Z]; first [exact Z | lra]
  end.
)";

Provable proof_of_pair() {
  const auto letter = Shortened::letter;
  const Shortened alpha = letter("alpha"), beta = letter("beta"), p = letter("p"), v = letter("v"),
                  t = letter("t");
  const auto product = [](const std::string& text, const Shortened& of_alpha, const Shortened& of_beta,
                          const Shortened& of_p, const Shortened& of_v, const Shortened& at) {
    return recorded_text(
        text, {{R"(\alpha)", of_alpha}, {R"(\beta)", of_beta}, {"p_1", of_p}, {"v_1", of_v}, {"t", at}})[0];
  };
  const Lemma turned{"meant",
                     "(alpha beta p v t : R)",
                     {oscillation(alpha, beta, p, (v - alpha * p) / beta)(t).expression() == Expression(0)},
                     {product(pair, alpha, beta, p, v, t) == Expression(0)},
                     "pairing"};
  // alpha = -1, beta = 2 and v = alpha p: a cosine, zero at pi/4
  const Shortened quarter = pi_of<Shortened>() / 4;
  const auto cosine = oscillation<Shortened>(-1, 2, 1, 0);
  const Lemma off{"printed_differs",
                  "",
                  {},
                  {near(cosine(quarter).expression(), 0, 1e-10),
                   apart(product(printed_pair, -1, 2, 1, -1, quarter), 0, 0.99)},
                  "interval"};
  return {"3.9-turned_pair",
          "as meant it holds wherever a coordinate is zero; as printed it is off at an example",
          {turned, off},
          0.99,
          damped_in_coq};
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

/// The real and the imaginary part of the square root of a number; one of them is zero.
constexpr const char* parts_in_coq = R"(
Lemma parts : forall d, let x := sqrt ((Rabs d + d) / 2) in let y := sqrt ((Rabs d - d) / 2) in
  x * x = d + y * y /\ x * y = 0 /\ 0 <= x /\ 0 <= y /\ (d >= 0 -> y = 0) /\ (d < 0 -> x = 0).
Proof.
  intros d x y. unfold x, y. unfold Rabs. destruct (Rcase_abs d).
  - replace ((- d + d) / 2) with 0 by field. replace ((- d - d) / 2) with (- d) by field.
    rewrite sqrt_0, sqrt_sqrt by lra. pose proof (sqrt_pos (- d)). repeat split; lra.
  - replace ((d + d) / 2) with d by field. replace ((d - d) / 2) with 0 by field.
    rewrite sqrt_0, sqrt_sqrt by lra. pose proof (sqrt_pos d). repeat split; lra.
Qed.
Ltac by_parts_of_the_root m c a :=
  destruct (parts (a * a - 4 * m * c)) as [square [product _]];
  set (x := sqrt ((Rabs (a * a - 4 * m * c) + (a * a - 4 * m * c)) / 2)) in *;
  set (y := sqrt ((Rabs (a * a - 4 * m * c) - (a * a - 4 * m * c)) / 2)) in *; clearbody x y;
  field [square product]; lra.
)";

Provables table_of_roots(const ProvableClaims<PolynomialOf>& table, const ForAll<PolynomialOf>& all) {
  Provables proved = table.proofs("3.9", all);
  for (Provable& proof : proved) proof.preamble = parts_in_coq;
  return proved;
}

Provables proofs() {
  Claims claims("3.9");
  Tables tables(claims);
  equations(tables, {});
  characteristic_roots(tables.polynomial, {});
  oscillations(tables, {}, {}, {});
  parallel(tables, {});
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
  auto polynomial = any<PolynomialOf>({"m", "c", "a", "r"}, "by_parts_of_the_root m c a");
  const auto& k = polynomial.any;
  polynomial.given = positive({k.m, k.c, k.a});
  polynomial.example.m = 1, polynomial.example.c = 3, polynomial.example.a = 2, polynomial.example.r = 1;
  for (Provable& proof : table_of_roots(tables.polynomial, polynomial)) all.push_back(std::move(proof));
  take(tables.oscillation,
       any<OscillationOf>({"alpha", "beta", "k1", "k2", "t"}, "field; try apply Rgt_not_eq, exp_pos"));
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
  auto aside = any<AsideOf>({"a", "t", "p1", "p2", "v1", "v2"}, "turning");
  aside.given = positive({16 - aside.any.a * aside.any.a});
  take(tables.aside, aside);
  for (Provable& proof : by_hand()) {
    proof.preamble = damped_in_coq;
    all.push_back(std::move(proof));
  }
  all.push_back(proof_of_pair());
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
           R"(A door closer with the friction $2\sqrt{mc}$, which shuts it fastest without swinging, gets NaN for its )"
           R"(position; for $m=@1$, $c=@1$ the door, let go at rest, is at @2 of its start after @1 s.)",
           {F::m, F::c, F::left_after(critical, second), second})},
      {"a fast throw",
       filled(
           R"(A game that rules the hit out for strong friction lets a ball, thrown from $p$ with $v=@1p$ at $m=@1$, )"
           R"($c=@1$, $a=@1$, through its goal after @3 s, at @2 $|p|$ a second, unseen.)",
           {thrown.factor(), thrown.ball.m, thrown.ball.c, thrown.ball.a, thrown.time(), thrown.speed()})},
      {"too much friction",
       filled(
           R"(Whoever turns the friction up to have the ball home sooner waits longer: for $m=@1$, $c=@1$ it is within )"
           R"(@1 of its way after @2 s with $a=@1$, after @2 s with $a=@1$, and after @2 s with $a=@2$.)",
           {F::m, F::c, F::nearly, F::home_after(critical), critical, F::home_after(stronger), stronger,
            F::home_after(strong), strong})},
      {"the first equation alone",
       filled(
           R"(A ball that swings along the $x_2$-axis gets NaN for its time: let go at rest with $m=@1$, $c=@1$, )"
           R"($a=@1$ it reaches the origin after @3 s all the same.)",
           {m, c, a, across.found.time})},
      {"the arctangent's branch",
       filled(
           R"(For $m=@1$, $c=@1$, $a=@1$ and a start at rest the formula says $@3$ s, not @3 s: a game that )"
           R"(schedules the hit for that moment has it in the past, and the event never fires.)",
           {m, c, a, by_formula, at_rest.found.time})},
      {"a zero denominator",
       filled(
           R"(With $m=@1$, $c=@1$, $a=@1$ and $v=@1\,p$ the ball is at the origin after @3 s, and a program that )"
           R"(divides depends on what it makes of $p_1/0$.)",
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
