// Exercise 3.5: the quarter period of a pendulum let go at rest from the angle a, in units of sqrt(L/2g), and
// the pendulum itself.
//   I(a) = int_0^a dt / sqrt(cos t - cos a) = sqrt(2) K(k), k = sin(a/2)   by sin(t/2) = k sin u
//   [DLMF 19.2.8]
// The reference is the arithmetic-geometric mean; no method below uses it. The swing's reference is Jacobi's
// cd. The book splits off the last eps of the integral, where cos t - cos a is nearly s u - c u^2/2 in u = a
// - t, s = sin a, c = cos a, and takes the rest by Simpson's rule. [DLMF] NIST Digital Library of
// Mathematical Functions.

#include <cmath>
#include <numbers>

#include "chapters/03_rigid_body_motion/pendulum_models.hpp"
#include "chapters/scene.hpp"
#include "reference/text.hpp"
#include "solvers/quadrature.hpp"

namespace oddity {

namespace ex03_05 {

using std::cos, std::sin, std::sqrt, std::numbers::pi;

constexpr double book_angle = pi / 6;
constexpr double book_epsilon = 1e-8;
constexpr int book_panels = 1024;

constexpr Parameter parameters[] = {
    {"a", book_angle, "rad", "angle at release", 1e-3, 3.14},
    {"L", 1, "m", "length", 1e-3, 1e3},
    {"g", 9.81, "m/s^2", "gravity", 1e-3, 1e3},
};

// ---- the integral -----------------------------------------------------------------------------------------

auto singular_integrand(double a) {
  return [a](double t) { return 1 / sqrt(cos(t) - cos(a)); };
}

/// The integrand after sin(t/2) = k sin(u): smooth on [0, pi/2].
auto legendre_integrand(double a) {
  const double k = sin(a / 2);
  return [k](double u) { return std::numbers::sqrt2 / sqrt(1 - k * k * sin(u) * sin(u)); };
}

/// The book's integral over the last epsilon, to leading order.
double remainder(double a, double epsilon) {
  return sqrt(2 / cos(a)) * (pi / 2 - std::asin(1 - epsilon * cos(a) / sin(a)));
}

/// The listing's arithmetic, in the listing's order; `shift` is what it subtracts from the cosine.
double listed_integral(double a, double shift, int panels) {
  const double amax = a - book_epsilon, h = amax / panels;
  double sum = 1 / sqrt(cos(0.0) - shift) + 1 / sqrt(cos(amax) - shift);
  for (int i = 1; i < panels; ++i) sum += (i & 1 ? 4.0 : 2.0) / sqrt(cos(i * h) - shift);
  return sum * (h / 3.0);
}

Quantity quarter_period(double a, const Reference& truth) {
  Quantity quarter =
      quantity("quarter_period", "sqrt(L/2g)", "time from release to the lowest point",
               truth("03_05_quarter_period", {a}), {1e-10, "ten decimals: one millisecond a year"});
  const Knob panels = doubling("panels", 4, 9), points = doubling("points", 2, 6);
  const auto raw = singular_integrand(a);
  const auto smooth = legendre_integrand(a);
  const std::string as_it_stands = "singular integrand", substituted = "Legendre's substitution";
  const std::string loses_digits = "cos t - cos a cancels at the singular end";

  quarter.add({"elliptic K", "std::comp_ellint_1", no_knob(), [a](double) {
                 return Answer{std::numbers::sqrt2 * std::comp_ellint_1(sin(a / 2)), 1};
               }});
  quarter.add({as_it_stands, "QAG", tolerances(), [=](double e) { return answer(qag(raw, 0, a, e)); },
               Outcome::non_finite,
               "bisection alone walks into the singular end, where cos t - cos a rounds to zero"});
  quarter.add({as_it_stands, "QAGS", tolerances(), [=](double e) { return answer(qags(raw, 0, a, e)); },
               Outcome::raised, loses_digits + ": GSL reports roundoff"});
  quarter.add({as_it_stands, "QAGP", tolerances(),
               [=](double e) {
                 return answer(qagp(raw, {0, a}, e));
               },
               Outcome::raised, loses_digits + ": GSL reports roundoff"});
  quarter.add({as_it_stands, "CQUAD", tolerances(), [=](double e) { return answer(cquad(raw, 0, a, e)); },
               Outcome::stalled, loses_digits + ", and the end itself is left out"});
  quarter.add({"listing as printed", "Simpson", doubling("panels", 64, 6),
               [=](double n) {
                 return Answer{listed_integral(a, a, static_cast<int>(n)) + remainder(a, book_epsilon),
                               static_cast<long>(n) + 1};
               },
               Outcome::inaccurate, "it subtracts the angle where the text subtracts the angle's cosine"});
  quarter.add({"listing with the text's integrand", "Simpson", doubling("panels", 64, 6),
               [=](double n) {
                 return Answer{listed_integral(a, cos(a), static_cast<int>(n)) + remainder(a, book_epsilon),
                               static_cast<long>(n) + 1};
               },
               Outcome::inaccurate, "Simpson's rule cannot follow the integrand to 1e-8 of its singularity"});
  quarter.add({substituted, "Simpson", panels,
               [=](double n) { return answer(simpson(smooth, 0, pi / 2, static_cast<int>(n))); }});
  quarter.add({substituted, "trapezoid", panels,
               [=](double n) { return answer(trapezoid(smooth, 0, pi / 2, static_cast<int>(n))); }});
  quarter.add({substituted, "Gauss-Legendre", points,
               [=](double n) { return answer(gauss_legendre(smooth, 0, pi / 2, static_cast<int>(n))); }});
  quarter.add(
      {substituted, "QAGS", tolerances(), [=](double e) { return answer(qags(smooth, 0, pi / 2, e)); }});
  return quarter;
}

// ---- the pendulum -----------------------------------------------------------------------------------------

Quantity swing(const Parameters& p, const Horizon& horizon, const Reference& truth) {
  using namespace pendulum;
  const Pendulum pendulum{p["a"], p["L"], p["g"]};
  Quantity angle = quantity("swing", "rad", "angle at " + times_up_to(horizon),
                            trajectory(truth, "03_05_swing", {pendulum.a, pendulum.L, pendulum.g}, horizon),
                            {1e-6, "a fifth of a second of arc"});
  Ladder(angle, horizon, halving("step", 0.125, 9), tolerances())
      .closed_form("small angle", SmallAngle{pendulum}, Outcome::inaccurate,
                   "the period grows with the amplitude")
      .closed_form("amplitude-corrected", AmplitudeCorrected{pendulum}, Outcome::inaccurate,
                   "terms of order a^4 in the frequency and of order a^3 in the shape are left out")
      .closed_form("Jacobi's function by its Fourier series", FourierSeries{pendulum})
      .by_common("one angle", OneAngle{pendulum}, Outcome::drifted, Outcome::inaccurate)
      .by_others("one angle", OneAngle{pendulum},
                 {{"linearly implicit Euler", Outcome::drifted, "of order 1, and it damps every swing"}})
      .by_common("Cartesian with constraint", CartesianWithConstraint{pendulum}, Outcome::inaccurate,
                 Outcome::inaccurate);
  angle.add(
      Breakdown{"Explicit Euler gains energy at every step: at eight steps a second the pendulum, let go at "
                "30 degrees, has "
                "turned over the top seven times within ten seconds. The cure is any method whose stability "
                "reaches up the "
                "imaginary axis; classical Runge-Kutta follows the swing at sixty-four steps a second.",
                "one angle, explicit Euler", 0.125, Outcome::diverged, "one angle, Runge-Kutta 4", 0.015625});
  return angle;
}

Scene scene() {
  return {swing,
          10,
          degree,
          "a",
          {0.125, 0.5, 1, 2, 3},
          {"a", "L"},
          {{"theta"}, "s", {{"rad", {0}}}},
          {{"chapters/03_rigid_body_motion/pendulum_models.hpp"},
           {{"small angle", "pendulum::SmallAngle{{a, L, g}}"},
            {"amplitude-corrected", "pendulum::AmplitudeCorrected{{a, L, g}}"},
            {"Jacobi's function by its Fourier series", "pendulum::FourierSeries{{a, L, g}}"},
            {"one angle", "pendulum::OneAngle{{a, L, g}}"},
            {"Cartesian with constraint", "pendulum::CartesianWithConstraint{{a, L, g}}"}}}};
}

// ---- the claims -------------------------------------------------------------------------------------------

/// The formula with the remainder, its integral by a rule that is exact to rounding at these epsilons.
Check split_formula(const std::string& as, double (*tail)(double, double), const Reference& truth) {
  const double a = book_angle;
  Worst worst("I at eps = 1e-2, 1e-3", as, "elliptic K by the arithmetic-geometric mean");
  for (double epsilon : {1e-2, 1e-3}) {
    const double next_term = std::pow(epsilon, 2.5) / (30 * sqrt(sin(a)));
    worst.see(qag(singular_integrand(a), 0, a - epsilon, 1e-13).value + tail(a, epsilon),
              truth("03_05_quarter_period", {a}).value,
              {2 * next_term + 1e-12, "twice the first term left out, eps^(5/2) / (30 sqrt(sin a))"}, 1,
              "eps = " + shortest(epsilon));
  }
  return worst.check();
}

double remainder_root_of_2_alone(double a, double epsilon) { return remainder(a, epsilon) / sqrt(cos(a)); }
double remainder_without_pi(double a, double epsilon) {
  return sqrt(2 / cos(a)) * (2 - std::asin(1 - epsilon * cos(a) / sin(a)));
}

std::vector<Claim> claims(const Reference& truth) {
  const Known quarter = truth("03_05_quarter_period", {book_angle});
  const Route agm{"sqrt(2) K(sin(pi/12)) by the arithmetic-geometric mean", quarter.value};
  const double listed = listed_integral(book_angle, book_angle, book_panels);
  const double listed_tail = remainder(book_angle, book_epsilon);

  Claim split{"3.5-split_formula", 1273,
              "the integral is about that to a - eps plus sqrt(2/cos a) (2 - asin(1 - eps cos a / sin a))"};
  split.printed = {"2 - asin(...)",
                   {split_formula("QAG plus the remainder without its pi", remainder_without_pi, truth)}};
  split.meant = {"pi/2 - asin(...)", {split_formula("QAG plus the remainder", remainder, truth)}};
  split.why =
      "The $\\pi$ of $\\pi/2$ and the fraction bars are lost: read as it stands, the remainder does not "
      "vanish "
      "with $\\epsilon$, and the time is 0.65 too long. The listing has `HALF_PI`, and $\\sqrt{2/\\cos a}$.";
  split.near_misses = {{"sqrt(2)/cos a before the bracket",
                        {split_formula("QAG plus sqrt(2)/cos a (...)", remainder_root_of_2_alone, truth)}}};

  Claim output{"3.5-listing_output", 1373, "the listing computes pendulumTime = 0.800275"};
  output.printed = {"0.800275",
                    {{"pendulumTime",
                      {"as printed", 0.800275},
                      {"the listing's arithmetic", listed + listed_tail},
                      printed_decimals(6)}}};
  output.near_misses = {{"0.800276",
                         {{"pendulumTime",
                           {"last digit off by one", 0.800276},
                           {"the listing's arithmetic", listed + listed_tail},
                           printed_decimals(6)}}}};

  Claim value{"3.5-value", 1373, "0.800275 is the integral from 30 degrees"};
  const auto integral_is = [&](const std::string& as, double x) {
    return Check{"the integral", {as, x}, agm, printed_decimals(6)};
  };
  value.printed = {"the integral is 0.800275", {integral_is("as printed", 0.800275)}};
  value.corrected = {"the integral is 2.260114", {integral_is("corrected", 2.260114)}};
  value.near_misses = {{"2.260115", {integral_is("last digit one up", 2.260115)}}};
  value.why =
      "The listing subtracts `initialAngle` where the text's integrand has $\\cos(\\pi/6)$: it integrates "
      "$1/\\sqrt{\\cos\\psi-\\pi/6}$, which is finite everywhere, and adds a remainder for a singularity "
      "that is "
      "not there. The quarter period is $\\sqrt2\\,K(\\sin 15^\\circ) = 2.260114$, almost three times as "
      "long: a "
      "pendulum of one metre takes 0.510 s to its lowest point, not 0.181 s. To replace the one term is not "
      "enough: Simpson's rule then meets the singularity (see the methods below).";

  Claim tail{"3.5-remainder", 1373, "the remainder is 0.000282"};
  const Route tail_by_series{"2 sqrt(eps/sin a), the remainder to leading order",
                             2 * sqrt(book_epsilon / sin(book_angle))};
  tail.printed = {"0.000282 to 6 decimals",
                  {{"remainder", {"as printed", 0.000282}, tail_by_series, printed_decimals(6)}}};
  tail.meant = {"0.000282..., cut off and not rounded",
                {{"remainder + half a unit",
                  {"as printed, at the middle of what the digits leave open", 0.0002825},
                  tail_by_series,
                  printed_decimals(6)}}};
  tail.corrected = {"0.000283",
                    {{"remainder", {"corrected", 0.000283}, tail_by_series, printed_decimals(6)}}};
  tail.near_misses = {
      {"0.000281, cut off",
       {{"remainder + half a unit", {"the digit before", 0.0002815}, tail_by_series, printed_decimals(6)}}}};
  tail.why =
      "The remainder is 0.00028284...: the digits printed are cut off, where those of the time are rounded. "
      "No "
      "digit of the time depends on it.";

  Claim rule{"3.5-simpson", 1307, "the listing integrates by Simpson's rule"};
  const double amax = book_angle - book_epsilon;
  const auto shifted = [](double t) { return 1 / sqrt(cos(t) - book_angle); };
  const Route as_listed{"the listing's sum, weights 4 and 2 in turn", listed};
  rule.printed = {"weights 1, 4, 2, ..., 4, 1",
                  {{"integral",
                    as_listed,
                    {"composite Simpson of the same integrand", simpson(shifted, 0, amax, book_panels).value},
                    rounding(listed, book_panels)}}};
  rule.near_misses = {{"the trapezoid rule",
                       {{"integral",
                         as_listed,
                         {"composite trapezoid", trapezoid(shifted, 0, amax, book_panels).value},
                         rounding(listed, book_panels)}}}};

  Claim positive{"3.5-positive_root", 1333, "the argument of the root is positive at every node"};
  long violations = 0;
  const double h = (book_angle - book_epsilon) / book_panels;
  for (int i = 1; i < book_panels; ++i) violations += !(cos(i * h) - book_angle > 0);
  positive.printed = {"arg > 0.0", {never("cos(angle) - initialAngle > 0", violations, book_panels - 1)}};
  long touching = 0;
  for (int i = 1; i <= book_panels; ++i)
    touching += !(cos(i * book_angle / book_panels) - cos(book_angle) > 0);
  positive.near_misses = {{"arg > 0.0 with the text's cosine, up to the angle itself",
                           {never("cos(angle) - cos(initialAngle) > 0", touching, book_panels)}}};

  return {split, rule, positive, output, value, tail};
}

Findings study(const Parameters& p, const Reference& truth) {
  Quantity quarter = quarter_period(p["a"], truth);
  quarter.add(
      Breakdown{"With the text's integrand the listing is still wrong: one panel of Simpson's rule takes the "
                "integrand at 1e-8 from its singularity, where it is 14142, with full weight. The "
                "substitution removes the singularity, and 16 panels of the trapezoid rule give every digit.",
                "listing with the text's integrand, Simpson", 1024, Outcome::inaccurate,
                "Legendre's substitution, trapezoid", 16});
  return {claims(truth), {quarter, motion(scene(), p, truth)}};
}

}  // namespace ex03_05

Exercise exercise_3_5() {
  using namespace ex03_05;
  return {"Pendulum from 30 degrees",
          "How long does a pendulum, let go at rest from the angle $a$, take to its lowest point? Evaluate "
          "$I(a)=\\int_0^a d\\psi/\\sqrt{\\cos\\psi-\\cos a}$, whose integrand is infinite at its end.",
          parameters, scene(), study};
}

}  // namespace oddity
