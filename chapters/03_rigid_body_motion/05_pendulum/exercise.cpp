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
#include "chapters/03_rigid_body_motion/05_pendulum/pendulum.hpp"
#include "chapters/energies.hpp"
#include "chapters/expect_failure.hpp"
#include "chapters/foreseen.hpp"
#include "chapters/in_float.hpp"
#include "chapters/scene.hpp"
#include "reference/text.hpp"
#include "solvers/quadrature.hpp"
#include "solvers/turns.hpp"

namespace oddity {

namespace ex03_05 {

using std::cos, std::sin, std::sqrt, std::numbers::pi;

constexpr Parameter parameters[] = {
    {"a", book_angle, "rad", "angle at release", 1e-3, 3.14},
    {"L", 1, "m", "length", 1e-3, 1e5},
    {"g", 9.81, "m/s^2", "gravity", 1e-3, 1e4},
};

// ---- the integral -----------------------------------------------------------------------------------------

auto singular_integrand(double a) {
  return [a](double t) { return 1 / sqrt(cos(t) - cos(a)); };
}

/// Whether the remainder is real.
bool has_remainder(double a) { return cos(a) > 0; }

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
