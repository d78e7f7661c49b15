// Exercise 3.5: the quarter period of a pendulum released at rest from the angle a, in units of sqrt(L/2g),
// and the pendulum itself.
//   I(a) = int_0^a dt / sqrt(cos t - cos a) = sqrt(2) K(k), k = sin(a/2)   by sin(t/2) = k sin u
//   [DLMF 19.2.8].
// The reference is the arithmetic-geometric mean, which no method below uses. The swing's reference is
// Jacobi's cd. The book splits off the last eps of the integral, and integrates the rest by Simpson's rule.
// In the last eps cos t - cos a is nearly s u - c u^2/2, with u = a - t, s = sin a, c = cos a. [DLMF] NIST
// Digital Library of Mathematical Functions.

#include <cmath>
#include <numbers>

#include "chapters/03_rigid_body_motion/05_pendulum/drawing.hpp"
#include "chapters/03_rigid_body_motion/05_pendulum/models.hpp"
#include "chapters/claims.hpp"
#include "chapters/energies.hpp"
#include "chapters/expect_failure.hpp"
#include "chapters/foreseen.hpp"
#include "chapters/in_float.hpp"
#include "chapters/provable.hpp"
#include "chapters/scene.hpp"
#include "reference/text.hpp"
#include "solvers/quadrature.hpp"
#include "solvers/turns.hpp"

namespace oddity {

namespace ex03_05 {

using std::cos, std::sin, std::sqrt, std::numbers::pi;

constexpr double book_angle = pi / 6;
constexpr double book_epsilon = 1e-8;

/// The remainder of the integral beyond a - epsilon.
template <class T>
T to_leading_order(const T& a) {
  return 2 * sqrt(book_epsilon / sin(a));
}
constexpr int book_panels = 1024;

constexpr Parameter parameters[] = {
    {"a", book_angle, "rad", "angle at release", 1e-3, 3.14},
    {"L", 1, "m", "length", 1e-3, 1e5},
    {"g", 9.81, "m/s^2", "gravity", 1e-3, 1e4},
};

// ---- the integral -----------------------------------------------------------------------------------------

auto singular_integrand(double a) {
  return [a](double t) { return 1 / sqrt(cos(t) - cos(a)); };
}

/// The integrand after sin(t/2) = k sin(u): smooth on [0, pi/2].
template <class T>
auto legendre_integrand(const T& a) {
  const T k = sin(a / 2), root = sqrt(T(2));
  return [k, root](const T& u) { return root / sqrt(1 - k * k * sin(u) * sin(u)); };
}

/// The book's integral over the last epsilon, to leading order.
double remainder(double a, double epsilon) {
  return sqrt(2 / cos(a)) * (pi / 2 - std::asin(1 - epsilon * cos(a) / sin(a)));
}

/// Whether the remainder is real.
bool has_remainder(double a) { return cos(a) > 0; }

/// The listing's arithmetic, in the listing's order; `shift` is subtracted from the cosine.
double listed_integral(double a, double shift, int panels) {
  const double amax = a - book_epsilon, h = amax / panels;
  double sum = 1 / sqrt(cos(0.0) - shift) + 1 / sqrt(cos(amax) - shift);
  for (int i = 1; i < panels; ++i) sum += (i & 1 ? 4.0 : 2.0) / sqrt(cos(i * h) - shift);
  return sum * (h / 3.0);
}

Quantity quarter_period(double a, const Reference& truth) {
  const Known known = truth("03_05_quarter_period", {a});
  constexpr double milliseconds_a_year = 365.25 * 86400 * 1e3, need = 1e-10;
  Quantity quarter =
      quantity("quarter_period", "sqrt(L/2g)", "time from release to the lowest point", known,
               {need, filled("ten decimals: @1 ms a year", {need / known.value[0] * milliseconds_a_year})});
  const Resolution panels = doubling("panels", 4, 9), points = doubling("points", 2, 6);
  Resolution to_roundoff = tolerances();
  to_roundoff.settings.push_back(1e-13);
  const auto raw = singular_integrand(a);
  const auto smooth = legendre_integrand(a);
  const std::string as_printed = "singular integrand", substituted = "Legendre's substitution";
  const std::string loses_digits = R"($\cos t-\cos a$ cancels at the singular end)";
  const bool listed_root = cos(a - book_epsilon) > a, remains = has_remainder(a);

  // Legendre's integrand has the period pi, and is infinite at pi/2 + i apart. The modulus k is rounded.
  constexpr double known_to = 10;
  const double apart = std::acosh(1 / sin(a / 2)), rounded = 0x1p-52 / (cos(a / 2) * cos(a / 2)),
               most = panels.settings.back();
  const auto smoothed = [&](const std::string& model, std::string algorithm, const Resolution& resolution,
                            double folds, const std::function<Answer(double)>& run) {
    quarter.add(expecting(
        foreseen(within_factor(known_to, std::exp(-folds) + rounded), need),
        filled(R"(released nearly upright: the integrand is a narrow peak, and $1-k^2=@1$ has lost digits)",
               {cos(a / 2) * cos(a / 2)}),
        {model, std::move(algorithm), resolution, run}));
  };
  constexpr double without_error = std::numeric_limits<double>::infinity();
  smoothed("elliptic K", "std::comp_ellint_1", no_resolution(), without_error, [a](double) {
    return Answer{std::numbers::sqrt2 * std::comp_ellint_1(sin(a / 2)), 1};
  });
  quarter.add(left_to_chance(
      {as_printed, "QAG", tolerances(), [=](double e) { return answer(qag(raw, 0, a, e)); },
       Outcome::non_finite,
       R"(bisection alone walks into the singular end, where $\cos t-\cos a$ rounds to zero)"}));
  quarter.add(
      left_to_chance({as_printed, "QAGS", to_roundoff, [=](double e) { return answer(qags(raw, 0, a, e)); },
                      Outcome::raised, loses_digits + ": GSL reports roundoff"}));
  quarter.add(left_to_chance({as_printed, "QAGP", to_roundoff,
                              [=](double e) {
                                return answer(qagp(raw, {0, a}, e));
                              },
                              Outcome::raised, loses_digits + ": GSL reports roundoff"}));
  quarter.add(left_to_chance({as_printed, "CQUAD", tolerances(),
                              [=](double e) { return answer(cquad(raw, 0, a, e)); }, Outcome::stalled,
                              loses_digits + ", and the end itself is left out"}));
  quarter.add({"listing as printed", "Simpson", doubling("panels", 64, 6),
               [=](double n) {
                 return Answer{listed_integral(a, a, static_cast<int>(n)) + remainder(a, book_epsilon),
                               static_cast<long>(n) + 1};
               },
               listed_root ? Outcome::inaccurate : Outcome::non_finite,
               "it subtracts the angle where the text subtracts the angle's cosine"});
  quarter.add({"listing with the text's integrand", "Simpson", doubling("panels", 64, 6),
               [=](double n) {
                 return Answer{listed_integral(a, cos(a), static_cast<int>(n)) + remainder(a, book_epsilon),
                               static_cast<long>(n) + 1};
               },
               remains ? Outcome::inaccurate : Outcome::non_finite,
               remains ? filled("Simpson's rule cannot follow the integrand to $@1$ of its singularity",
                                {book_epsilon})
                       : R"(the remainder divides by $\sqrt{\cos a}$, and $\cos a<0$)"});
  smoothed(substituted, "Simpson", panels, 2 * most * apart,
           [=](double k) { return answer(simpson(smooth, 0, pi / 2, static_cast<int>(k))); });
  smoothed(substituted, "trapezoid", panels, 4 * most * apart,
           [=](double k) { return answer(trapezoid(smooth, 0, pi / 2, static_cast<int>(k))); });
  smoothed(substituted, "Gauss-Legendre", points, 2 * points.settings.back() * sqrt(4 * apart / pi),
           [=](double k) { return answer(gauss_legendre(smooth, 0, pi / 2, static_cast<int>(k))); });
  smoothed(substituted, "QAGS", tolerances(), without_error,
           [=](double e) { return answer(qags(smooth, 0, pi / 2, e)); });
  return quarter;
}

// ---- the pendulum -----------------------------------------------------------------------------------------

Quantity swing(const Parameters& p, const Horizon& horizon, const Reference& truth) {
  using namespace pendulum;
  const Given<double> given{p["a"], p["L"], p["g"]};
  constexpr double need = 1e-6;
  Quantity angle = quantity("swing", "rad", "angle at " + times_up_to(horizon),
                            trajectory(truth, "03_05_swing", {given.a, given.L, given.g}, horizon),
                            {need, filled("@1 seconds of arc", {3600 * need / degree})});
  SceneMethods(angle, horizon, halving("step", 0.125, 9), tolerances())
      .closed_form("small angle", SmallAngle<double>{given}, Outcome::inaccurate,
                   "the period grows with the amplitude")
      .closed_form("amplitude-corrected", AmplitudeCorrected<double>{given}, Outcome::inaccurate,
                   "terms of order $a^4$ in the frequency and of order $a^3$ in the shape are left out")
      .closed_form("Jacobi's function by its Fourier series", FourierSeries<double>(given))
      .by_engine_integrators("one angle", OneAngle<double>{given}, Outcome::drifted, Outcome::inaccurate)
      .by_remaining_integrators(
          "one angle", OneAngle<double>{given},
          {{"linearly implicit Euler", Outcome::drifted, "a first-order method that damps every swing"}})
      .by_engine_integrators("Cartesian with constraint", CartesianWithConstraint<double>{given},
                             Outcome::inaccurate, Outcome::inaccurate);
  expect_failure(angle, "Cartesian with constraint", "semi-implicit Euler", Outcome::drifted,
                 "first-order, and not symplectic where the rod's force depends on the velocity");
  const Told turns_over_the_top = Told::Seen([](const Quantity&, const Trial& broken, const Trial&) {
    const Value& angles = broken.answer.value;
    return angles.size() == 0 ? std::nan("")
                              : std::floor((std::abs(angles[angles.size() - 1]) + pi) / (2 * pi));
  });
  angle.add(Breakdown{
      "Explicit Euler gains energy swing after swing: at @2 steps a second the pendulum, let go at "
      "@3 degrees, has turned over the top @2 times within @2 seconds. The cure is any method "
      "whose region of stability reaches up the imaginary axis; classical Runge-Kutta follows the swing at "
      "@3 steps a second.",
      "one angle, explicit Euler",
      0.125,
      Outcome::diverged,
      "one angle, Runge-Kutta 4",
      0.015625,
      {steps_in_one(Side::broken), given.a / degree, turns_over_the_top, horizon.end,
       steps_in_one(Side::cured)}});
  return with_float(std::move(angle), horizon, given,
                    {"small angle", "amplitude-corrected", "Jacobi's function by its Fourier series",
                     "one angle", "Cartesian with constraint"});
}

/// A rod of 1.5 times the length, hinged at its end, which has the same equation of motion.
engines::Staging staging(const Parameters& p) {
  using namespace engines;
  const double a = p["a"], L = p["L"], d = 0.75 * L, across = 0.1875 * L * L;
  Body rod{1, {across, 0.01 * L * L, across}};
  rod.start.position = {d * sin(a), -d * cos(a), 0};
  rod.start.orientation = about({0, 0, 1}, a);
  return {{.gravity = {0, -p["g"], 0}, .bodies = {rod}, .joints = {{Joint::hinge}}},
          [](std::span<const State> seen, double) {
            return std::vector{std::atan2(seen[0].position[0], -seen[0].position[1])};
          }};
}

/// Energy of the bob, from the rod's angle.
Energy energy(const Parameters& p, std::span<const double> x) {
  const double half = std::sin(x[0] / 2), speed = p["L"] * x[1];
  return energy_seen(speed * speed / 2, 2 * p["g"] * p["L"] * half * half);
}

Scene scene() {
  return {
      .motion = swing,
      .horizon = 10,
      .game_tolerance = degree,
      .sweep_parameter = "a",
      .sweep_values = {0.125, 0.5, 1, 2, 3},
      .perturbed_parameters = {"a", "L"},
      .axes = {{"theta"}, "s", {{"rad", {0}}}},
      .listing = {{"chapters/03_rigid_body_motion/05_pendulum/models.hpp"},
                  {{"small angle", "pendulum::SmallAngle<double>{{a, L, g}}"},
                   {"amplitude-corrected", "pendulum::AmplitudeCorrected<double>{{a, L, g}}"},
                   {"Jacobi's function by its Fourier series", "pendulum::FourierSeries<double>({a, L, g})"},
                   {"one angle", "pendulum::OneAngle<double>{{a, L, g}}"},
                   {"Cartesian with constraint", "pendulum::CartesianWithConstraint<double>{{a, L, g}}"}}},
      .draw = pendulum::draw<Parameters>,
      .staging = staging,
      .laws = {energy},
  };
}

// ---- the claims -------------------------------------------------------------------------------------------

const std::string to_epsilon = R"(\int_0^{a-\epsilon}\frac{d\psi}{\sqrt{\cos\psi-\cos a}})";

/// The integral's tolerance in QAG.
constexpr double by_qag = 1e-13;

/// The integral from a - to until a - from, by psi = a - s^2, with the difference of the cosines as a
/// product.
double part_of_integral(double from, double to) {
  const double a = book_angle;
  const auto smooth = [a](double s) {
    return s == 0 ? 2 / sqrt(sin(a)) : 2 * s / sqrt(2 * sin(a - s * s / 2) * sin(s * s / 2));
  };
  return qag(smooth, sqrt(from), sqrt(to), by_qag).value;
}

/// Error of the remainder from a few roundings of the arc sine's argument, which is nearly 1.
double roundings_of_remainder(double epsilon) {
  constexpr double roundings = 4, unit = 0x1p-53;
  const double slope = 1 / sqrt(2 * epsilon * cos(book_angle) / sin(book_angle));
  return sqrt(2 / cos(book_angle)) * slope * roundings * unit;
}

/// A point that splits the integral, with the integral up to it.
struct Cut {
  double epsilon, first_part;
  explicit Cut(double at) : epsilon(at), first_part(part_of_integral(at, book_angle)) {}
  TypesetLetters typeset() const {
    return {{R"(\epsilon)", epsilon}, {"a", book_angle}, {to_epsilon, first_part}};
  }
  Tolerance tolerance(double) const {
    const double next_term = std::pow(epsilon, 2.5) / (30 * sqrt(sin(book_angle)));
    constexpr double quadratures = 10 * by_qag;
    return {
        2 * next_term + quadratures + roundings_of_remainder(epsilon),
        R"(twice the first term left out, $\epsilon^{5/2}/(30\sqrt{\sin a})$, with the quadrature's error )"
        R"(and roundings under the arc sine's root)"};
  }
  std::string where() const { return R"($\epsilon$ = )" + format_shortest(epsilon); }
};

/// A node of the listing's sum.
struct Node {
  double psi;
  TypesetLetters typeset() const { return {{R"(\psi)", psi}}; }
  std::string where() const { return R"($\psi$ = )" + format_shortest(psi); }
};

std::vector<Node> nodes() {
  std::vector<Node> all;
  for (int i = 1; i < book_panels; ++i) all.push_back({i * (book_angle - book_epsilon) / book_panels});
  return all;
}

std::vector<Claim> claims(const Reference& truth) {
  Claims claims("3.5");
  const double a = book_angle, listed = listed_integral(a, a, book_panels);

  const auto split = [](const std::string& factor, const std::string& quarter) {
    return "$" + to_epsilon + "+" + factor + R"(\left()" + quarter +
           R"(-\sin^{-1}\left(1-\frac{\epsilon\cos a}{\sin a}\right)\right)$)";
  };
  const std::string root = R"(\sqrt{\frac2{\cos a}})";
  claims.formula<Cut>(
      "split_formula", 1273, R"($T\approx)" + split(root, "2").substr(1) + R"(, $a=\pi/6$)",
      {Cut(1e-2), Cut(1e-3), Cut(book_epsilon)},
      {.quantity = R"($I(a)$, cut at $a-\epsilon$)",
       .truth = {R"($\sqrt2\,K$ by the arithmetic-geometric mean)",
                 [whole = truth("03_05_quarter_period", {a}).value](const Cut&) { return whole; }},
       .printed = {split(root, "2")},
       .meant = {split(root, R"(\frac\pi2)")},
       .near_misses = {{split(R"(\frac{\sqrt2}{\cos a})", R"(\frac\pi2)")}},
       .why = filled(
           R"(The $\pi$ of $\pi/2$ and the fraction bars are lost: without them, the remainder does not )"
           R"(vanish with $\epsilon$, and the time is @2 too long. The listing has `HALF_PI`, and )"
           R"($\sqrt{2/\cos a}$.)",
           {sqrt(2 / cos(a)) * (2 - pi / 2)})});

  const auto shifted = [](double psi) { return 1 / sqrt(cos(psi) - book_angle); };
  const auto by_rule = [&](const std::string& rule, const Solved<double>& sum) {
    return Reading{rule,
                   {{"the listing's sum, weights 4 and 2 in turn,",
                     {"in the listing's arithmetic", listed},
                     {rule + " for the same integrand", sum.value},
                     rounding(listed, book_panels)}}};
  };
  claims.add(
      "simpson", 1307, R"(The listing integrates over $[0,\pi/6-\epsilon]$ by Simpson's rule.)",
      {.printed = by_rule("Simpson's rule", simpson(shifted, 0, a - book_epsilon, book_panels)),
       .near_misses = {by_rule("the trapezoid rule", trapezoid(shifted, 0, a - book_epsilon, book_panels)),
                       by_rule(R"(Simpson's rule over $[0,\pi/6]$)", simpson(shifted, 0, a, book_panels))}});

  const auto argument = [](const std::string& text, double subtracted) {
    return Formula<Node>{text, [=](const Node& n) { return cos(n.psi) - subtracted; }};
  };
  claims.formula<Node>(
      "listing_integrand", 1331,
      R"(The listing's `arg = Mathd::Cos(angle) - initialAngle` is the text's $\cos\psi-\cos(\pi/6)$.)",
      nodes(),
      {.quantity = "the root's argument at a node",
       .truth = {R"(the difference as a product, $2\sin\frac{\pi/6+\psi}2\sin\frac{\pi/6-\psi}2$)",
                 [a](const Node& n) { return 2 * sin((a + n.psi) / 2) * sin((a - n.psi) / 2); }},
       .printed = argument("`Mathd::Cos(angle) - initialAngle`", a),
       .corrected = argument("`Mathd::Cos(angle) - Mathd::Cos(initialAngle)`", cos(a)),
       .near_misses = {argument("`Mathd::Cos(angle) - Mathd::Sin(initialAngle)`", sin(a))},
       .kind = Fault::listing,
       .root = "angle for its cosine",
       .why = filled(R"(`initialAngle` is $\pi/6=@3$, but $\cos(\pi/6)=@3$ belongs there. `fmin` and )"
                     R"(`fmax` (lines 1315, 1317) have the same slip.)",
                     {a, cos(a)})});

  claims.statement<Node>(
      "positive_root", 1333, "The argument of the root is positive at every node.", nodes(),
      {.printed = {R"($\cos\psi-\pi/6>0$)"}, .near_misses = {{R"($\cos\psi-\cos(\pi/12)>0$)"}}});

  const auto last = [&](const std::string& text, double from) {
    return Reading{
        text,
        {{"the listing's `remainder`",
          {R"($\sqrt{2/\cos a}\,(\pi/2-\arcsin(1-\epsilon\cos a/\sin a))$)", remainder(a, book_epsilon)},
          {"QAG of the text's integrand, $\\psi=a-s^2$", part_of_integral(0, from)},
          {roundings_of_remainder(book_epsilon),
           "the roundings of $1-\\epsilon\\cos a/\\sin a$ under the arc sine's root"}}}};
  };
  claims.add("remainder_interval", 1357,
             R"(The remainder is the term of $[\pi/6-\epsilon,\pi/6]$, for the text's integrand.)",
             {.printed = last(R"(from $\pi/6-\epsilon$ on)", book_epsilon),
              .near_misses = {last(R"(from $\pi/6-1.001\,\epsilon$ on)", 1.001 * book_epsilon)}});

  claims.number("listing_output", 1373, "The listing computes `pendulumTime` = 0.800275.",
                {.truth = {"the listing's arithmetic", listed + remainder(a, book_epsilon)},
                 .printed = "0.800275",
                 .near_misses = {"0.800276"}});

  claims.number(
      "value", 1373,
      R"(The value of `pendulumTime` (our reading: of the integral from $30^\circ$) is 0.800275.)",
      {.truth = {R"($\sqrt2\,K(\sin\frac{\pi}{12})$ by the arithmetic-geometric mean)",
                 truth("03_05_quarter_period", {a}).value},
       .printed = "0.800275",
       .corrected = "2.260114",
       .near_misses = {"2.260115"},
       .kind = Fault::listing,
       .root = "angle for its cosine",
       .why = R"(The listing subtracts `initialAngle` where the text's integrand has $\cos(\pi/6)$. It )"
              R"(integrates $1/\sqrt{\cos\psi-\pi/6}$, which is finite on all of $[0,\pi/6]$, and adds a )"
              R"(remainder for a singularity that is not there. To replace the one term is not enough: )"
              R"(Simpson's rule then takes the integrand next to its singularity (see the methods below).)"});

  const Route tail{R"($2\sqrt{\epsilon/\sin a}$, the remainder to leading order)", to_leading_order(a)};
  claims.add(
      "remainder", 1373, "The value of the remainder is 0.000282.",
      {.printed = {"0.000282", {as_written("the remainder", "0.000282", tail)}},
       .meant = {"0.000282..., cut off", {as_cut_off("the remainder", "0.000282", tail)}},
       .near_misses = {{"0.000281..., cut off", {as_cut_off("the remainder", "0.000281", tail)}},
                       {"0.000284", {as_written("the remainder", "0.000284", tail)}}},
       .why = filled(
           "The remainder is @5...: the digits printed are cut off, not rounded. Those of the time, @7, "
           "are the same either way. The listing adds the unrounded remainder; its time is not "
           "affected.",
           {tail.value[0], listed + remainder(a, book_epsilon)}),
       .kind = Fault::number});
  return claims.in_order();
}

Provables proofs() {
  const Expression whole = integral(legendre_integrand(pi_in_coq() / 6), 0, pi_in_coq() / 2, "u"),
                   tail = to_leading_order(pi_in_coq() / 6);
  return {
      {"3.5-value",
       "Legendre's integral from 30 degrees is the corrected value to its last digit, and 1.4 above the printed one",
       {{.name = "corrected", .follows = {near(whole, 2.260114, 5e-7)}, .tactic = "integral"},
        {.name = "printed_differs", .follows = {apart(whole, 0.800275, 1.4)}, .tactic = "integral"}},
       1.4},
      {"3.5-remainder",
       "the remainder to leading order begins with 0.000282, and is 0.00000084 above that",
       {{.name = "meant", .follows = {near(tail, 0.0002825, 5e-7)}, .tactic = "interval"},
        {.name = "printed_differs", .follows = {apart(tail, 0.000282, 8.4e-7)}, .tactic = "interval"}},
       8.4e-7}};
}

std::vector<Root> roots() {
  constexpr double length = 1, g = 9.81;
  const double a = book_angle, unit = sqrt(length / (2 * g)),
               quarter = std::numbers::sqrt2 * std::comp_ellint_1(sin(a / 2)),
               published = listed_integral(a, a, book_panels) + remainder(a, book_epsilon);
  const double come = a - pendulum::FourierSeries<double>({a, length, g}).at(unit * published)[0];
  return {
      {"angle for its cosine",
       filled(
           R"(A pendulum of @1 m takes @3 s to its lowest point, $\sqrt2\,K(\sin@2^\circ)=@7$ units of )"
           R"($\sqrt{L/2g}$, not @3 s: an engine that takes the published number as its cue strikes when the bob )"
           R"(has come @2 of its @2 degrees.)",
           {length, unit * quarter, a / 2 / degree, quarter, unit * published, come / degree, a / degree})}};
}

Findings study(const Parameters& p, const Reference& truth) {
  Quantity quarter = quarter_period(p["a"], truth);
  const double at_end = singular_integrand(p["a"])(p["a"] - book_epsilon);
  if (has_remainder(p["a"]))
    quarter.add(Breakdown{
        "With the text's integrand the listing is still wrong. One panel of Simpson's rule takes the "
        "integrand at $@1$ from its singularity, where it is @5, and so adds @2 to the time. The "
        "substitution removes the singularity, and @2 panels of the trapezoid rule are enough.",
        "listing with the text's integrand, Simpson",
        book_panels,
        Outcome::inaccurate,
        "Legendre's substitution, trapezoid",
        16,
        {book_epsilon, at_end, at_end * (p["a"] - book_epsilon) / book_panels / 3, setting_of(Side::cured)}});
  return {
      claims(truth),
      {quarter, motion(scene(), p, truth)},
      roots(),
      R"(The integral and the way around its singular end are right; {{angle for its cosine|the listing subtracts an angle instead of its cosine, so its number is wrong}}.)"};
}

}  // namespace ex03_05

Exercise exercise_3_5() {
  using namespace ex03_05;
  return {"Pendulum from 30 degrees",
          "How long does a pendulum, let go at rest from the angle $a$, take to its lowest point? Evaluate "
          "$I(a)=\\int_0^a d\\psi/\\sqrt{\\cos\\psi-\\cos a}$, whose integrand is infinite at its end.",
          parameters,
          scene(),
          study,
          proofs,
          Expected::in_whole_ranges};
}

}  // namespace oddity
