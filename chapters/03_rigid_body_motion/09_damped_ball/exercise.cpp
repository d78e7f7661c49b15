// Exercise 3.9: a ball in the plane on a spring of constant c with viscous friction a: when does it reach the
// origin?
//   m x'' + a x' + c x = 0 in each coordinate; with h = a/(2m), d = h^2 - c/m
//   x = exp(-h t) (p C + (v + h p) S),   C, S = cosh and sinh/w, or cos and sin/w, or 1 and t, w = sqrt|d|
// The equations are derived again from L = m|x'|^2/2 - c|x|^2/2 and Rayleigh's dissipation a|x'|^2/2 by dual
// numbers; the published solutions are put into the differential equation, their derivatives taken by dual
// numbers. Letters: r1 > r2 the real roots of m r^2 + a r + c; alpha, beta the parts of the complex ones.

#include <cmath>
#include <complex>
#include <numbers>

#include "chapters/03_rigid_body_motion/09_damped_ball/damped_ball.hpp"
#include "chapters/03_rigid_body_motion/shared/lagrangian.hpp"
#include "chapters/random.hpp"
#include "reference/text.hpp"
#include "solvers/dual.hpp"

namespace oddity {

namespace ex03_09 {

using namespace damped_ball;

constexpr Parameter parameters[] = {
    {"m", 1, "kg", "mass", 1e-2, 1e2},
    {"c", 4, "N/m", "spring constant", 1e-3, 1e4},
    {"a", 0.4, "N s/m", "viscous friction", 0, 1e3},
    {"p1", 1, "m", "position at the start", -1e3, 1e3},
    {"p2", 0.5, "m", "position at the start", -1e3, 1e3},
    {"v1", 0, "m/s", "velocity at the start", -1e3, 1e3},
    {"v2", 1.5, "m/s", "velocity at the start", -1e3, 1e3},
    {"seed", 39, "", "of the random samples", 0, 1e9, whole_number},
};

// ---- the claims -------------------------------------------------------------------------------------------

/// m x'' + a x' + c x against zero, and x(0), x'(0) against p, v, at random times and parameters.
/// form(m, c, a, p, v) returns x as a generic function of the time.
template <class Form>
Check solves(const std::string& formula, double seed, bool overdamped, const Form& form) {
  Random random(seed);
  Worst worst("(m x'' + a x', x(0), x'(0))", formula + ", differentiated by dual numbers", "(-c x, p, v)");
  const auto left = [&](const std::array<double, 6>& letters) {
    const auto [m, c, a, p, v, t] = letters;
    const auto x = form(m, c, a, p, v);
    return Value{m * second_derivative(x, t) + a * derivative(x, t), x(0.0), derivative(x, 0.0)};
  };
  const auto right = [&](const std::array<double, 6>& letters) {
    const auto [m, c, a, p, v, t] = letters;
    return Value{-c * form(m, c, a, p, v)(t), p, v};
  };
  for (int i = 0; i < 200; ++i) {
    const double m = random.between(0.3, 3), c = random.between(0.3, 3), p = random.between(-2, 2),
                 v = random.between(-2, 2);
    const double a = 2 * std::sqrt(m * c) * (overdamped ? random.between(1.1, 3) : random.between(0.05, 0.9));
    const double t = random.between(0.1, 5);
    see(worst, left, right, std::array{m, c, a, p, v, t},
        "m = " + rounded(m, 4) + ", c = " + rounded(c, 4) + ", a = " + rounded(a, 4) +
            ", t = " + rounded(t, 4));
  }
  return worst.check();
}

constexpr auto two_exponentials(double sign) {
  return [sign](double m, double c, double a, double p, double v) {
    const double root = std::sqrt(a * a - sign * 4 * m * c), r1 = (-a + root) / (2 * m),
                 r2 = (-a - root) / (2 * m);
    const double k1 = (v - r2 * p) / (r1 - r2);
    return [=](const auto& t) {
      using std::exp;
      return k1 * exp(r1 * t) + (p - k1) * exp(r2 * t);
    };
  };
}

/// sign = 1: the published K2 = (v - alpha p)/beta.
constexpr auto damped_oscillation(double sign) {
  return [sign](double m, double c, double a, double p, double v) {
    const double alpha = -a / (2 * m), beta = std::sqrt(4 * m * c - a * a) / (2 * m);
    return [=](const auto& t) {
      using std::cos, std::exp, std::sin;
      return exp(alpha * t) * (p * cos(beta * t) + (v - sign * alpha * p) / beta * sin(beta * t));
    };
  };
}

/// The accelerations that the energies imply, against those of the text with friction = 1.
Check equations(double seed, double friction) {
  Random random(seed);
  Worst worst("m x''", "from L and Rayleigh's dissipation, by dual numbers", "-c x - a x'");
  const auto derived = [](const std::array<double, 7>& letters) {
    const auto [m, c, a, x1, x2, v1, v2] = letters;
    const auto lagrangian = [m = m, c = c, v1 = v1, v2 = v2](const auto& q1, const auto& q2) {
      return 0.5 * m * (v1 * v1 + v2 * v2) - 0.5 * c * (q1 * q1 + q2 * q2);
    };
    const auto dissipation = [a = a](const auto& u1, const auto& u2) {
      return 0.5 * a * (u1 * u1 + u2 * u2);
    };
    using D = Dual<double>;
    return Value{lagrangian(D(x1, 1), D(x2)).slope - dissipation(D(v1, 1), D(v2)).slope,
                 lagrangian(D(x1), D(x2, 1)).slope - dissipation(D(v1), D(v2, 1)).slope};
  };
  const auto text = [=](const std::array<double, 7>& letters) {
    const auto [m, c, a, x1, x2, v1, v2] = letters;
    return Value{-c * x1 - friction * a * v1, -c * x2 - friction * a * v2};
  };
  for (int i = 0; i < 200; ++i) {
    const double m = random.between(0.1, 3), c = random.between(0.1, 3), a = random.between(0.1, 3);
    const auto [x1, x2, unused] = random.point(3);
    const auto [v1, v2, unused_too] = random.point(3);
    see(worst, derived, text, std::array{m, c, a, x1, x2, v1, v2}, "a = " + rounded(a, 4));
  }
  return worst.check();
}

/// When a ball is at the origin, and how well doubles can tell: the terms of the coordinate that is zero
/// there, by its slope.
struct Passage {
  double time;
  Tolerance known;
};

/// First positive time at which the ball of an under-damped start with p and v parallel is at the origin,
/// found by marching and bisection on the way along p.
Passage first_passage(const Ball& b) {
  const auto x = [&](double t) {
    const auto at = OneForm<double>{b}.at(t);
    return at[0] * b.p1 + at[1] * b.p2;
  };
  const double step = 1e-3 * std::sqrt(b.m / b.c);
  double t = 0;
  while (x(t) * x(t + step) > 0) t += step;
  double low = t, high = t + step;
  for (int i = 0; i < 60; ++i) (x(low) * x((low + high) / 2) > 0 ? low : high) = (low + high) / 2;
  const double rate = std::sqrt(b.c / b.m);
  const auto form = damped_oscillation(1);
  const double slope = b.p1 * derivative(form(b.m, b.c, b.a, b.p1, b.v1), low) +
                       b.p2 * derivative(form(b.m, b.c, b.a, b.p2, b.v2), low);
  const double terms = std::abs(b.p1) * (std::abs(b.p1) + std::abs(b.v1) / rate) +
                       std::abs(b.p2) * (std::abs(b.p2) + std::abs(b.v2) / rate);
  return {low, rounding(low + terms / std::abs(slope))};
}

enum class Branch { principal, forward, forward_unsigned };

Check passage(double seed, Branch branch, const std::string& formula) {
  Random random(seed);
  Worst worst("first time at the origin", formula, "the sign change of x.p, by bisection");
  for (int i = 0; i < 50; ++i) {
    const double s = random.between(-2, 2), p = random.between(0.2, 2);
    const Ball b{1, random.between(1, 4), random.between(0.1, 0.9), p, 2 * p, s * p, 2 * s * p};
    const double alpha = -b.a / 2, beta = std::sqrt(4 * b.c - b.a * b.a) / 2;
    double angle = std::atan(-beta * b.p1 / (b.v1 - alpha * b.p1));
    if (branch == Branch::forward_unsigned) angle = -angle;
    if (branch != Branch::principal && angle < 0) angle += std::numbers::pi;
    const Passage found = first_passage(b);
    worst.see(angle / beta, found.time, found.known, found.time,
              "v = " + rounded(s, 4) + " p, a = " + rounded(b.a, 4));
  }
  return worst.check();
}

/// The way along which the displayed arctangent is taken: the first coordinate, the one across p, or p.
enum class Way { first, across, along };

/// Starts in all directions, some of them along an axis, where the other coordinate is zero for ever.
Reading passage_in_any_direction(std::string text, double seed, Way way) {
  Random random(seed);
  Worst worst("first time at the origin", text, "the sign change of x.p, by bisection");
  for (int i = 0; i < 60; ++i) {
    const double s = random.between(-2, 2), angle = random.between(0, 2 * std::numbers::pi);
    const double p1 = i % 3 == 0 ? 0 : std::cos(angle), p2 = i % 3 == 1 ? 0 : std::sin(angle);
    const Ball b{1, random.between(1, 4), random.between(0.1, 0.9), p1, p2, s * p1, s * p2};
    const double alpha = -b.a / 2, beta = std::sqrt(4 * b.c - b.a * b.a) / 2;
    const std::array u = way == Way::along    ? std::array{p1, p2}
                         : way == Way::across ? std::array{-p2, p1 + p2}
                                              : std::array{1.0, 0.0};
    const double p = u[0] * p1 + u[1] * p2, v = u[0] * b.v1 + u[1] * b.v2;
    double turned = std::atan(-beta * p / (v - alpha * p));
    if (turned < 0) turned += std::numbers::pi;
    const Passage found = first_passage(b);
    worst.see(turned / beta, found.time, found.known, found.time,
              "p = (" + rounded(p1, 4) + ", " + rounded(p2, 4) + "), v = " + rounded(s, 4) + " p");
  }
  return {std::move(text), {worst.check()}};
}

/// The product p x (v - alpha p)/beta against that of p and `of` in place of v, over random starts.
Reading parallel(std::string text, double seed, double with_p) {
  Random random(seed);
  Worst worst("beta p x (v - alpha p)/beta", "the text's vectors", text);
  const auto of_text = [](const std::array<double, 6>& letters) {
    const auto [p1, p2, v1, v2, alpha, beta] = letters;
    return Value(beta * (p1 * ((v2 - alpha * p2) / beta) - p2 * ((v1 - alpha * p1) / beta)));
  };
  const auto other = [=](const std::array<double, 6>& letters) {
    return Value(letters[0] * (letters[3] + with_p * letters[0]) -
                 letters[1] * (letters[2] + with_p * letters[1]));
  };
  for (int i = 0; i < 200; ++i) {
    const auto [p1, p2, unused] = random.point(2);
    const auto [v1, v2, unused_too] = random.point(2);
    const double alpha = -random.between(0.05, 2), beta = random.between(0.1, 2);
    see(worst, of_text, other, std::array{p1, p2, v1, v2, alpha, beta},
        "p = (" + rounded(p1, 4) + ", " + rounded(p2, 4) + "), v = (" + rounded(v1, 4) + ", " +
            rounded(v2, 4) + ")");
  }
  return {std::move(text), {worst.check()}};
}

std::vector<Claim> claims(double seed) {
  Claim motion{"3.9-equations", 1449, "each coordinate obeys m x'' + a x' + c x = 0"};
  motion.printed = {"m x'' = -c x - a x'", {equations(seed, 1)}};
  motion.near_misses = {{"the factor 1/2 of the dissipation kept", {equations(seed, 0.5)}},
                        {"friction that drives", {equations(seed, -1)}}};

  Random random(seed + 1);
  Worst vieta("(sum, product) of the roots by (-a/m, c/m)", "the published roots", "Vieta"),
      other_root("(sum, product) of the roots by (-a/m, c/m)", "roots with a^2 - 2 m c", "Vieta");
  Worst no_c("m r^2 + a r at the published roots", "as the text has the polynomial", "zero"),
      with_c("m r^2 + a r at the published roots", "m r^2 + a r", "-c"),
      minus_c("m r^2 + a r at the published roots", "m r^2 + a r", "c");
  long wrong_signs = 0, positive = 0;
  for (int i = 0; i < 300; ++i) {
    const double m = random.between(0.1, 3), c = random.between(0.1, 3), a = random.between(0.1, 9),
                 d = a * a - 4 * m * c;
    const std::complex<double> root = std::sqrt(std::complex<double>(d)), r1 = (-a + root) / (2 * m),
                               r2 = (-a - root) / (2 * m);
    const std::string where = "m = " + rounded(m, 4) + ", c = " + rounded(c, 4) + ", a = " + rounded(a, 4);
    vieta.see({(r1 + r2).real(), (r1 * r2).real()}, {-a / m, c / m}, (a / m) * (a / m) + 1, where);
    const std::complex<double> wrong = std::sqrt(std::complex<double>(a * a - 2 * m * c));
    const std::complex<double> product = (-a + wrong) * (-a - wrong) / (4 * m * m);
    other_root.see({-a / m, product.real()}, {-a / m, c / m}, (a / m) * (a / m) + 1, where);
    const std::complex<double> p = m * r1 * r1 + a * r1;
    no_c.see({p.real(), p.imag()}, {0, 0}, a * a / m + c, where);
    with_c.see({p.real(), p.imag()}, {-c, 0}, a * a / m + c, where);
    minus_c.see({p.real(), p.imag()}, {c, 0}, a * a / m + c, where);
    wrong_signs +=
        d >= 0 ? !(r1.real() < 0 && r2.real() < 0 && r1.imag() == 0) : !(r1.real() < 0 && r1.imag() != 0);
    positive += !(r1.real() > 0);
  }
  Claim polynomial{"3.9-characteristic_polynomial", 1453,
                   "the characteristic polynomial is m r^2 + a r + (nothing)"};
  polynomial.printed = {"m r^2 + a r = 0", {no_c.check()}};
  polynomial.meant = {"m r^2 + a r + c = 0", {with_c.check()}};
  polynomial.near_misses = {{"m r^2 + a r - c = 0", {minus_c.check()}}};
  polynomial.why =
      "The last coefficient, $c$, is missing after its plus sign; the roots that follow have it.";

  Claim roots{"3.9-roots", 1455, "the roots are (-a +- sqrt(a^2 - 4 m c))/(2 m)"};
  roots.printed = {"sum -a/m, product c/m", {vieta.check()}};
  roots.near_misses = {{"a^2 - 2 m c under the root", {other_root.check()}}};

  Claim signs{"3.9-negative_roots", 1461,
              "the roots are real and negative, or complex with negative real part"};
  signs.printed = {"Re r < 0", {never("a root with a real part that is not negative", wrong_signs, 300)}};
  signs.near_misses = {{"Re r > 0", {never("a root with a real part that is not positive", positive, 300)}}};

  Claim overdamped{"3.9-two_exponentials", 1469,
                   "for real roots x = K1 exp(r1 t) + K2 exp(r2 t) is the general solution"};
  const Ball critical{1, 4, 4, 1, 0.5, 0, 1.5};
  const double t = 1;
  const Route with_t{"exp(r t) (p + (v - r p) t), r = -2",
                     {std::exp(-2.0) * (1 + 2 * 1.0), std::exp(-2.0) * (0.5 + (1.5 + 1) * 1.0)}};
  const auto at_double_root = [&](const std::string& by, const Value& x) {
    return Check{"x(1) at a^2 = 4 m c", {by, x}, with_t, rounding(1)};
  };
  overdamped.printed = {"for all real roots, the double one included",
                        {at_double_root("two exponentials", TwoExponentials<double>{critical}.at(t))}};
  overdamped.corrected = {"for r1 != r2; for a double root r, (K1 + K2 t) exp(r t)",
                          {solves("two exponentials", seed, true, two_exponentials(1)),
                           at_double_root("the limit of the two regimes", OneForm<double>{critical}.at(t))}};
  overdamped.near_misses = {
      {"for a double root r, (p + v t) exp(r t)",
       {at_double_root("(p + v t) exp(-2 t)", {std::exp(-2.0) * (1 + 0.0), std::exp(-2.0) * (0.5 + 1.5)})}}};
  overdamped.why =
      "Case 1 includes $a^2 = 4mc$, where both exponentials are the same function: two starting values "
      "cannot be met, and the formulas for "
      "$K_1$ and $K_2$ divide by zero: a door closer set to close as fast as it can without swinging gets no "
      "number for its position. The critically damped ball follows $(K_1 + K_2 t)\\,e^{rt}$. With roots that "
      "differ by very little the two exponentials are still right, but they are large and of opposite sign, "
      "and "
      "their sum loses digits (see `near_critical`).";

  Claim limit{"3.9-limit", 1471, "whatever K1 and K2, x tends to zero"};
  long far = 0, near = 0, held = 0;
  for (int i = 0; i < 200; ++i) {
    const double a = random.between(4.1, 20), k1 = random.magnitude(1e-3, 1e3),
                 k2 = random.magnitude(1e-3, 1e3), root = std::sqrt(a * a - 16);
    const auto x = [&](double s) {
      return k1 * std::exp((-a + root) / 2 * s) + k2 * std::exp((-a - root) / 2 * s);
    };
    far += !(std::abs(x(500)) < 1e-12);
    near += !(std::abs(x(100)) < 1e-12);
    held += !(std::abs(k1 + k2 * std::exp(-a * 500)) < 1e-12);
  }
  limit.printed = {"|x(500)| < 1e-12", {never("|x(500)| >= 1e-12 for |K| up to 1000", far, 200)}};
  limit.near_misses = {{"without the spring", {never("|x(500)| >= 1e-12 for c = 0", held, 200)}},
                       {"already at t = 100", {never("|x(100)| >= 1e-12", near, 200)}}};

  Claim never_reached{"3.9-overdamped_never_arrives", 1477,
                      "with real roots the ball reaches the origin only after infinite time"};
  const Ball thrown{1, 4, 5, 1, 2, -9, -18};
  const double passes = std::log(8.0 / 5.0) / 3;
  const auto at_origin = [&](const std::string& when, double time) {
    return Check{"x at t = " + when,
                 {"closed form", OneForm<double>{thrown}.at(time)},
                 {"the origin", {0, 0}},
                 rounding(2),
                 2};
  };
  never_reached.printed = {
      "|x| > 0 for all t",
      {never("the origin is passed by t = 1: x1(1) has changed its sign",
             OneForm<double>{thrown}.at(1)[0] < 0, 1, "m = 1, c = 4, a = 5, p = (1, 2), v = -9 p")}};
  never_reached.corrected = {
      "a ball thrown at the origin faster than |r2| |p| passes it once, at exp((r1 - r2) t) = -K2/K1",
      {at_origin("ln(8/5)/3", passes)}};
  never_reached.near_misses = {{"at exp((r1 - r2) t) = K2/K1", {at_origin("-ln(8/5)/3", -passes)}},
                               {"at exp(r1 t) = -K2/K1", {at_origin("ln(8/5)", 3 * passes)}}};
  never_reached.why =
      "With $p$ and $v$ parallel both coordinates vanish together once if $v$ points to the origin and $|v| "
      "> |r_2||p|$. For $m=1$, "
      "$c=4$, $a=5$ the roots are $-1$ and $-4$; from $p$ with $v=-9p$, $x = \\frac13(-5e^{-t} + "
      "8e^{-4t})\\,p$ is zero at $t = \\frac13\\ln\\frac85 = 0.157$. A game that rules the hit out for "
      "strong "
      "friction lets this ball go through its goal at 4.3 $|p|$ a second, unseen.";

  Claim sooner{"3.9-larger_friction_sooner", 1477,
               "the larger the friction a, the sooner the ball is nearly at the origin"};
  long slower = 0, faster = 0, below = 0;
  for (int i = 0; i < 100; ++i) {
    const double a = random.between(4.5, 60), b = a * random.between(1.05, 3);
    const Ball one{1, 4, a, 1, 1, 0, 0}, other{1, 4, b, 1, 1, 0, 0};
    slower += !(OneForm<double>{other}.at(5)[0] < OneForm<double>{one}.at(5)[0]);
    faster += !(OneForm<double>{other}.at(5)[0] > OneForm<double>{one}.at(5)[0]);
    const Ball light{1, 4, a / 15, 1, 1, 0, 0}, heavier{1, 4, b / 15, 1, 1, 0, 0};
    below += !(std::abs(OneForm<double>{heavier}.at(5)[0]) > std::abs(OneForm<double>{light}.at(5)[0]));
  }
  sooner.printed = {"x(5) falls with a",
                    {never("more friction leaves the ball farther away at t = 5", slower, 100)}};
  sooner.corrected = {"x(5) grows with a beyond the critical 2 sqrt(m c)",
                      {never("more friction leaves the ball nearer at t = 5", faster, 100)}};
  sooner.near_misses = {{"|x(5)| grows with a from a fifteenth of that on",
                         {never("more friction leaves the ball nearer at t = 5", below, 100)}}};
  sooner.why =
      "Beyond critical damping the slow root $r_1 = -2c/(a+\\sqrt{a^2-4mc})$ goes to zero as $-c/a$: the "
      "spring "
      "draws the ball through honey. For $m=1$, $c=4$ a ball let go at rest is within a hundredth of its way "
      "from the origin after 3.3 s with the critical friction $a=2\\sqrt{mc}=4$, after 8.7 s with $a=8$, and "
      "after 46 s "
      "with $a=40$. The rate of decay is greatest at $a=2\\sqrt{mc}$.";

  Claim solution{"3.9-damped_oscillation", 1491,
                 "x = exp(alpha t)(p cos(beta t) + (v - alpha p)/beta sin(beta t)), alpha = -a/(2m), beta = "
                 "sqrt(4mc - a^2)/(2m)"};
  solution.printed = {"as stated", {solves("the published x(t)", seed, false, damped_oscillation(1))}};
  solution.near_misses = {
      {"(v + alpha p)/beta", {solves("(v + alpha p)/beta", seed, false, damped_oscillation(-1))}}};

  Claim slope{"3.9-derivative", 1487,
              "x' = exp(alpha t)(-beta K1 sin + beta K2 cos) + alpha exp(alpha t)(K1 cos + K2 sin)"};
  Worst by_hand("x'", "the published derivative", "dual numbers"),
      no_alpha("x'", "without its last term", "dual numbers");
  using Five = std::array<double, 5>;  // alpha, beta, K1, K2, t
  const auto by_dual_numbers = [](const Five& letters) {
    const auto x = [&](const auto& u) {
      const auto& [alpha, beta, k1, k2, unused] = letters;
      return exp(alpha * u) * (k1 * cos(beta * u) + k2 * sin(beta * u));
    };
    return Value(derivative(x, letters[4]));
  };
  const auto published = [](double last) {
    return [last](const Five& letters) {
      const auto [alpha, beta, k1, k2, time] = letters;
      const double e = std::exp(alpha * time), co = std::cos(beta * time), si = std::sin(beta * time);
      return Value(e * (-beta * k1 * si + beta * k2 * co) + last * alpha * e * (k1 * co + k2 * si));
    };
  };
  for (int i = 0; i < 200; ++i) {
    const Five letters{-random.unit(), random.between(0.1, 3), random.between(-2, 2), random.between(-2, 2),
                       random.between(0, 5)};
    see(by_hand, published(1), by_dual_numbers, letters, "t = " + rounded(letters[4], 4));
    see(no_alpha, published(0), by_dual_numbers, letters, "t = " + rounded(letters[4], 4));
  }
  slope.printed = {"as stated", {by_hand.check()}};
  slope.near_misses = {{"without alpha exp(alpha t) (...)", {no_alpha.check()}}};

  Claim constants{"3.9-constants", 1489, "x(0) = p and x'(0) = v lead to K1 = p and K2 = (v - alpha p)/beta"};
  const auto starts = [&](const std::string& text, double sign) {
    Random samples(seed);
    Worst worst("(x(0), x'(0))", "x with " + text + ", differentiated by dual numbers", "(p, v)");
    const auto at_start = [sign](const std::array<double, 4>& letters) {
      const auto x = [&](const auto& u) {
        const auto& [alpha, beta, p, v] = letters;
        using std::cos, std::exp, std::sin;
        return exp(alpha * u) * (p * cos(beta * u) + (v - sign * alpha * p) / beta * sin(beta * u));
      };
      return Value{x(0.0), derivative(x, 0.0)};
    };
    const auto start = [](const std::array<double, 4>& letters) { return Value{letters[2], letters[3]}; };
    for (int i = 0; i < 200; ++i) {
      const std::array letters{-samples.unit(), samples.between(0.1, 3), samples.between(-2, 2),
                               samples.between(-2, 2)};
      see(worst, at_start, start, letters,
          "alpha = " + rounded(letters[0], 4) + ", beta = " + rounded(letters[1], 4));
    }
    return Reading{text, {worst.check()}};
  };
  constants.printed = starts("K2 = (v - alpha p)/beta", 1);
  constants.near_misses = {starts("K2 = v/beta", 0)};

  Claim arrival{"3.9-arrival_time", 1517,
                "for p and v parallel the ball is at the origin at t = atan(-beta p1/(v1 - alpha p1))/beta"};
  arrival.printed = {"the principal value", {passage(seed, Branch::principal, "atan(...)/beta")}};
  arrival.corrected = {"plus pi/beta where the arctangent is negative",
                       {passage(seed, Branch::forward, "atan(...)/beta, forward in time")}};
  arrival.near_misses = {{"the sign inside dropped",
                          {passage(seed, Branch::forward_unsigned, "atan(+...)/beta, forward in time")}}};
  arrival.why =
      "The arctangent's principal value is negative whenever $(v_1-\\alpha p_1)/p_1 > 0$, which includes "
      "every ball let go at rest or moving away: "
      "the formula then names a time before the start. The first arrival is $\\pi/\\beta$ later. For $m=1$, "
      "$c=4$, $a=0.4$ and a start at rest it says $-0.739$ for $0.840$: a game that schedules the hit for "
      "that moment has it in the past, and the event never fires.";

  const auto quotient = [&](std::string text, const auto& angle_of) {
    Random samples(seed);
    Worst worst("first time at the origin", text, "the sign change of x.p, by bisection");
    for (int i = 0; i < 50; ++i) {
      const double p = samples.magnitude(0.2, 2), a = samples.between(0.1, 0.9), c = samples.between(1, 4),
                   alpha = -a / 2, beta = std::sqrt(4 * c - a * a) / 2,
                   v = i % 5 == 0 ? alpha * p : samples.between(-2, 2);
      const Ball b{1, c, a, p, 0, v, 0};
      const Passage found = first_passage(b);
      worst.see(angle_of(beta * p, v - alpha * p) / beta, found.time, found.known, found.time,
                "p = " + rounded(p, 4) + ", v - alpha p = " + rounded(v - alpha * p, 4));
    }
    return Reading{std::move(text), {worst.check()}};
  };
  Claim exists{"3.9-arrival_quotient", 1517,
               "the arrival's arctangent is of a quotient, which any p1 and v1 have, where it is not 0/0"};
  exists.printed = quotient("-beta p1/(v1 - alpha p1), no number for v1 = alpha p1", [](double y, double x) {
    const double angle = x == 0 ? std::numeric_limits<double>::quiet_NaN() : std::atan(-y / x);
    return angle < 0 ? angle + std::numbers::pi : angle;
  });
  exists.corrected =
      quotient("the angle from 0 to pi of the pair (-(v1 - alpha p1), beta p1), p1 > 0 or both signs changed",
               [](double y, double x) { return std::atan2(std::abs(y), y > 0 ? -x : x); });
  exists.near_misses = {quotient("the angle of (v1 - alpha p1, beta p1)",
                                 [](double y, double x) { return std::atan2(std::abs(y), y > 0 ? x : -x); })};
  exists.why =
      "For $v_1=\\alpha p_1$ the denominator is zero: the ball then moves towards the origin just so fast "
      "that "
      "$x$ is a pure cosine but for its decay, and arrives at $t=\\pi/(2\\beta)$. A program that divides "
      "depends on what it makes of $p_1/0$; the angle of the pair needs no division, and no $\\pi/\\beta$ to "
      "be "
      "added either.";

  Claim first{"3.9-first_equation_suffices", 1515,
              "for p and v parallel the two equations are one, and the first can be solved for the time"};
  first.printed = passage_in_any_direction("atan(-beta p1/(v1 - alpha p1))/beta, plus pi/beta where negative",
                                           seed, Way::first);
  first.corrected = passage_in_any_direction(
      "atan(-beta p.p/((v - alpha p).p))/beta, plus pi/beta where negative", seed, Way::along);
  first.near_misses = {passage_in_any_direction(
      "the same with the products by (-p2, p1 + p2), which is across p for p1 = 0", seed, Way::across)};
  first.why =
      "Where $p_1=v_1=0$ the first equation reads $0=0$, and the arctangent is of $0/0$: a ball that swings "
      "along "
      "the $x_2$-axis gets no time at all, though it reaches the origin like any other. With the products by "
      "$p$, "
      "$t=\\frac1\\beta\\tan^{-1}\\frac{-\\beta\\,p\\cdot p}{(v-\\alpha p)\\cdot p}$, no direction is "
      "special.";

  Claim same{
      "3.9-parallel", 1515,
      "p and (v - alpha p)/beta are parallel when p and v are (the text's parenthesis does not close)"};
  same.printed = parallel("p x v", seed, 0);
  same.near_misses = {parallel("p x (v + p turned by a right angle)", seed, 1)};

  Claim pointing{"3.9-velocity_points_to_origin", 1525,
                 "what happens physically is that the velocity points to the origin at the start"};
  const Ball away{1, 4, 0.4, 1, 2, 1, 2};
  const auto [w1, w2] = OneForm<double>{away}.at(first_passage(away).time);
  const Ball aside{1, 4, 0.4, 1, 2, 1, 1};
  const auto back = [&](const std::string& what, const Ball& ball) {
    const auto [time, known] = first_passage(ball);
    const auto form = damped_oscillation(1);
    const double speed = std::hypot(derivative(form(ball.m, ball.c, ball.a, ball.p1, ball.v1), time),
                                    derivative(form(ball.m, ball.c, ball.a, ball.p2, ball.v2), time));
    return Check{what,
                 {"closed form", OneForm<double>{ball}.at(time)},
                 {"the origin", {0, 0}},
                 {known.allowed * speed, "the way that the ball goes in the uncertainty of its passage"},
                 std::hypot(ball.p1, ball.p2)};
  };
  pointing.printed = {
      "p.v < 0 in every start that arrives",
      {never("p.v >= 0 though the ball arrives: p = (1, 2), v = p", size_of({w1, w2}) < 1e-9, 1)}};
  pointing.corrected = {"p and v parallel, in either direction",
                        {back("x at the first sign change of x.p, v = p", away)}};
  pointing.near_misses = {{"any direction", {back("x at the first sign change of x.p, v = (1, 1)", aside)}}};
  pointing.why =
      "Parallel is enough: a ball moving straight away from the origin turns round and comes back through "
      "it; with $m=1$, $c=4$, $a=0.4$ and $v=p$, that is (1, 2) metres and metres a second, after 1.06 s. A "
      "game that "
      "tests $p\\cdot v<0$ leaves this hit out.";

  Claim turned{
      "3.9-turned_pair", 1537,
      "where a coordinate is zero, (p_i, v_i - alpha p_i beta) = lambda_i (-sin(beta t), cos(beta t))"};
  const auto along = [&](std::string text, int power, double sign) {
    Random samples(seed);
    Worst worst("the pair less its part along (-sin(beta t), cos(beta t))", text, "zero");
    for (int i = 0; i < 100; ++i) {
      const double p = samples.between(0.2, 2), v = samples.between(-2, 2);
      const Ball b{1, samples.between(1, 4), samples.between(0.1, 0.9), p, 0, v, 0};
      const double alpha = -b.a / 2, beta = std::sqrt(4 * b.c - b.a * b.a) / 2;
      const Passage found = first_passage(b);
      const double at = beta * found.time;
      const double second = power < 0 ? (v - alpha * p) / beta : v - alpha * p * beta;
      const double c = std::cos(at), s = sign * std::sin(at), part = -p * s + second * c;
      const double size = p + std::abs(second);
      const Tolerance turned_by{beta * found.known.allowed * size + rounding(size).allowed,
                                "the passage's uncertainty, as an angle, and 64 roundings"};
      worst.see({p + part * s, second - part * c}, {0, 0}, turned_by, size,
                "p = " + rounded(p, 4) + ", v = " + rounded(v, 4));
    }
    return Reading{std::move(text), {worst.check()}};
  };
  turned.printed = along("(p, v - alpha p beta), as a product", 1, 1);
  turned.meant = along("(p, (v - alpha p)/beta)", -1, 1);
  turned.near_misses = {along("lambda (sin(beta t), cos(beta t))", -1, -1)};
  turned.why =
      "The fraction bar is lost in the text at hand, here and in line 1529; lines 1505 and 1511 have it. For "
      "$m=1$, $c=4$, $a=0.4$ and $p=1$ at rest the pair is $(1,0.10)$, and $(1,0.40)$ with the product.";

  Claim misses{"3.9-not_parallel_never", 1541,
               "for p and v not parallel the ball never reaches the origin in finite time"};
  Worst momentum("x1 x2' - x2 x1' after t", "along the closed form", "exp(-a t/m) (p1 v2 - p2 v1)"),
      steady("x1 x2' - x2 x1' after t", "along the closed form", "p1 v2 - p2 v1, without loss");
  using Six = std::array<double, 6>;  // a, t, p1, p2, v1, v2
  const auto along_the_form = [](const Six& letters) {
    const auto [a, time, p1, p2, v1, v2] = letters;
    const auto x1 = damped_oscillation(1)(1, 4, a, p1, v1), x2 = damped_oscillation(1)(1, 4, a, p2, v2);
    return Value(x1(time) * derivative(x2, time) - x2(time) * derivative(x1, time));
  };
  const auto decayed = [](double rate) {
    return [rate](const Six& letters) {
      const auto [a, time, p1, p2, v1, v2] = letters;
      return Value(std::exp(-rate * a * time) * (p1 * v2 - p2 * v1));
    };
  };
  for (int i = 0; i < 200; ++i) {
    const auto [p1, p2, u1] = random.point(2);
    const auto [v1, v2, u2] = random.point(2);
    const double a = random.between(0.1, 3.5), t_later = random.between(0.1, 6);
    const Six letters{a, t_later, p1, p2, v1, v2};
    const std::string where = "a = " + rounded(a, 4) + ", t = " + rounded(t_later, 4);
    see(momentum, along_the_form, decayed(1), letters, where);
    see(steady, along_the_form, decayed(0), letters, where);
  }
  misses.printed = {"the angular momentum decays but is never zero", {momentum.check()}};
  misses.near_misses = {{"the angular momentum is conserved", {steady.check()}}};

  return {motion,    polynomial, roots, signs, overdamped, limit,  never_reached, sooner, slope,
          constants, solution,   same,  first, arrival,    exists, pointing,      turned, misses};
}

Ball asked(const Parameters& p) { return {p["m"], p["c"], p["a"], p["p1"], p["p2"], p["v1"], p["v2"]}; }

Quantity position(const Parameters& p, const Horizon& horizon, const Reference& truth) {
  return path("path", "position at " + times_up_to(horizon), asked(p), horizon, truth);
}

Scene scene() {
  return {position,
          5,
          centimeter,
          "a",
          {0.4, 4, 40, 200, 1000},
          {"p1", "p2", "v2"},
          {{"x", "y"}, "s", {{"m", {0, 1}}}},
          {{"chapters/03_rigid_body_motion/09_damped_ball/models.hpp"},
           {{"closed form, one for all regimes", "damped_ball::OneForm<double>{{m, c, a, p1, p2, v1, v2}}"},
            {"two exponentials", "damped_ball::TwoExponentials<double>{{m, c, a, p1, p2, v1, v2}}"},
            {"plane", "damped_ball::Plane<double>{{m, c, a, p1, p2, v1, v2}}"},
            {"plane, with the work", "damped_ball::PlaneWithWork<double>{{m, c, a, p1, p2, v1, v2}}"}}}};
}

Findings study(const Parameters& p, const Reference& truth) {
  const Horizon horizon{scene().horizon};
  const Ball ball = asked(p);
  Ball near_critical = ball, stiff = ball;
  near_critical.a = 2 * std::sqrt(ball.m * ball.c) * (1 + 1e-13);
  stiff.a = 20 * std::sqrt(ball.m * ball.c);
  Quantity fast = path("stiff", "the same with ten times the critical friction", stiff, horizon, truth);
  fast.add(
      Breakdown{"The fast root is near -40: explicit Euler diverges for steps above 0.05, though the motion "
                "that is left is slow. "
                "Rosenbrock's method takes its steps from the motion.",
                "plane, explicit Euler", 0.125, Outcome::diverged, "plane, Rosenbrock 4", 1e-11});
  std::vector<Quantity> quantities{motion(scene(), p, truth),
                                   near_critical_path(near_critical, horizon, truth), fast,
                                   stability_limit(stiff)};
  if (const double critical = 2 * std::sqrt(ball.m * ball.c);
      ball.a < 0.9 * critical && (ball.p1 != 0 || ball.p2 != 0))
    quantities.push_back(first_arrival({ball.m, ball.c, ball.a, ball.p1, ball.p2, 0, 0}));
  return {claims(p["seed"]), quantities};
}

}  // namespace ex03_09

Exercise exercise_3_9() {
  using namespace ex03_09;
  return {"Ball on a spring with friction",
          "A ball in the plane is held by a spring of constant $c$ to the origin and slowed by viscous "
          "friction $a$. Solve for its motion; when does "
          "it reach the origin?",
          parameters, scene(), study};
}

}  // namespace oddity
