// Exercise 3.23: a massless bar turns about the origin. At r it carries a mass m, at s it rests on a spring
// of constant c and rest length ell based at (s, -h). What is its equation of motion, and when is it at rest
// level?
//   m r^2 theta'' + m g r cos theta + c (1 - ell/d) (s^2 (1 - cos) sin + s (h + s sin) cos) = 0.
//   d^2 = s^2 (cos theta - 1)^2 + (h + s sin theta)^2.
// The energies are compared with the work of the forces in the plane, the equation with the Lagrangian,
// differentiated by dual numbers, and with the moments of the forces. Small oscillations have the frequency
// (s/r) sqrt(c/m), which depends neither on gravity nor on the spring's length.

#include "chapters/03_rigid_body_motion/23_spring_bar/drawing.hpp"
#include "chapters/03_rigid_body_motion/23_spring_bar/spring_bar.hpp"
#include "chapters/expect_failure.hpp"

#include <cmath>
#include <numbers>
#include <string>

#include "chapters/in_float.hpp"
#include "chapters/scene.hpp"
#include "solvers/counted_calls.hpp"
#include "solvers/differences.hpp"
#include "solvers/dual.hpp"
#include "solvers/ode/events.hpp"
#include "solvers/turns.hpp"

namespace oddity {

namespace ex03_23 {

using namespace spring_bar;

constexpr Parameter parameters[] = {
    {"m", usual.m, "kg", "mass", 1e-3, 1e5},
    {"r", usual.r, "m", "where the mass is on the bar", 1e-3, 1e4},
    {"s", usual.s, "m", "where the spring is on the bar", 1e-3, 1e4},
    {"c", usual.c, "N/m", "spring constant", 1e-3, 1e6},
    {"h", usual.h, "m", "depth of the spring's foot", 1e-3, 1e4},
    {"g", usual.g, "m/s^2", "gravity", 0, 1e4},
    {"ell", usual.ell, "m", "rest length of the spring", 1e-3, 1e4},
    {"theta0", usual.theta0, "rad", "angle at the start", -3.14, 3.14},
    {"w0", usual.w0, "rad/s", "angular speed at the start", -1e3, 1e3},
    {"seed", 23, "", "seed of the random samples", 0, 1e9, whole_number},
};

// ---- the quantities ---------------------------------------------------------------------------------------

Given<double> asked(const Parameters& p) {
  return {p["m"], p["r"], p["s"], p["c"], p["h"], p["g"], p["ell"], p["theta0"], p["w0"]};
}

Known true_swing(const Given<double>& b, const Horizon& horizon, const Reference& truth) {
  return trajectory(truth, "03_23_swing", {b.m, b.r, b.s, b.c, b.h, b.g, b.ell, b.theta0, b.w0}, horizon);
}

Quantity swing(const Parameters& p, const Horizon& horizon, const Reference& truth) {
  const Given<double> bar = asked(p);
  Quantity mass = quantity("swing", "m", "position of the mass at four times",
                           true_swing(bar, horizon, truth), {1e-6, "a micrometre"});
  SceneMethods(mass, horizon, halving("step", 0.125, 10), tolerances())
      .closed_form(
          "small oscillation", SmallOscillation<double>{bar}, Outcome::inaccurate,
          "the frequency depends on the amplitude, and the spring resists differently above and below")
      .by_engine_integrators("one angle", OneAngle<double>{bar}, Outcome::drifted)
      .by_remaining_integrators(
          "one angle", OneAngle<double>{bar},
          {{"linearly implicit Euler", Outcome::drifted, "a first-order method that damps every swing"}})
      .by_engine_integrators("Cartesian with constraint", CartesianWithConstraint<double>{bar},
                             Outcome::drifted);
  expect_failure(mass, "Cartesian with constraint", "semi-implicit Euler", Outcome::inaccurate,
                 "first-order; its energy error stays bounded");
  return with_float(std::move(mass), horizon, bar,
                    {"small oscillation", "one angle", "Cartesian with constraint"});
}

Quantity stiff_swing(const Given<double>& bar, const Reference& truth) {
  const Horizon horizon{1};
  Quantity mass = quantity("stiff", "m", "position on a stiff spring at " + times_up_to(horizon),
                           true_swing(bar, horizon, truth), {1e-6, "a micrometre"});
  const std::string one = "one angle", damps = "stable at every step, but it takes the swing's energy away";
  SceneMethods(mass, horizon, halving("step", 0.0625, 11), tolerances(2, 10))
      .by<ode::ExplicitEuler>(one, OneAngle<double>{bar}, Outcome::drifted, "it gains energy")
      .by<ode::VelocityVerlet>(one, OneAngle<double>{bar}, Outcome::inaccurate,
                               "its order is too low for this need at this step")
      .by<ode::RungeKutta4>(one, OneAngle<double>{bar})
      .by<ode::Fehlberg78>(one, OneAngle<double>{bar})
      .by<ode::ImplicitEuler>(one, OneAngle<double>{bar}, Outcome::drifted, damps)
      .by<ode::Rosenbrock4>(one, OneAngle<double>{bar});
  return mass;
}

/// A whole period of the swing that passes theta = 0 with the speed w amplitude. The spring's rest length
/// balances the bar there, since otherwise the swing would be about another angle.
Answer frequency_by_events(Given<double> bar, double amplitude) {
  bar.ell = bar.h + bar.m * bar.g * bar.r / (bar.c * bar.s);
  bar.w0 = amplitude * bar.frequency();
  const OneAngle<double> one{bar};
  OneAngle<double>::State state{0, bar.w0};
  Answer answer;
  double t = 0;
  for (int half = 0; half < 2; ++half) {
    const auto crossing =
        ode::find_event<ode::Fehlberg78>(one, state, t, t + 5 / bar.frequency(), 1e-13,
                                         [](const OneAngle<double>::State& x, double) { return x[0]; });
    answer.evaluations += crossing.evaluations;
    answer.ending = crossing.ending;
    answer.message = crossing.message;
    t = crossing.value.time;
    state = {0, crossing.value.state[1]};
  }
  answer.value = 2 * std::numbers::pi / t;
  return answer;
}

Quantity small_frequency(const Given<double>& bar, const Reference& truth) {
  Quantity w = quantity("frequency", "rad/s", R"(angular frequency of small oscillations about $\theta=0$)",
                        truth("03_23_frequency", {bar.m, bar.r, bar.s, bar.c, bar.h, bar.g, bar.ell}),
                        {1e-6 * bar.frequency(), "a millionth of it"});
  const auto of = [bar](double curvature) { return std::sqrt(curvature / (bar.m * bar.r * bar.r)); };
  const auto V = [bar](const auto& q) { return bar.potential(q); };
  const auto slope = [V](double q) { return derivative(V, q); };
  w.add({"curvature of V", "nested dual numbers", no_resolution(), [=](double) {
           return Answer{of(second_derivative(V, 0.0)), 1};
         }});
  w.add({"curvature of V", "second difference", halving("step", 0.125, 9), [=](double h) {
           long calls = 0;
           const auto at = counted_calls(V, calls);
           const double second = (at(h) - 2 * at(0.0) + at(-h)) / (h * h);
           return Answer{of(second), calls};
         }});
  w.add({"slope of V' by dual numbers", "central difference, order 2", halving("step", 0.125, 9),
         [=](double h) { return answer(central_difference_2(slope, 0, h), of); }});
  w.add({"slope of V' by dual numbers", "central difference, order 4", halving("step", 0.125, 9),
         [=](double h) { return answer(central_difference_4(slope, 0, h), of); }});
  w.add({"one angle", "Fehlberg 7(8), a period by events", halving("amplitude", 0.125, 9),
         [=](double amplitude) { return frequency_by_events(bar, amplitude); }});
  return w;
}

/// A rod with the same first and second moments about the hinge as the mass on its bar.
engines::Staging staging(const Parameters& p) {
  using namespace engines;
  const spring_bar::Given<double> bar = asked(p);
  const double r = bar.r, across = bar.m * r * r / 4;
  Body rod{4 * bar.m / 3, {0.01 * bar.m * r * r, across, across}};
  rod.start.position = {0.75 * r * cos(bar.theta0), 0.75 * r * sin(bar.theta0), 0};
  rod.start.orientation = about({0, 0, 1}, bar.theta0);
  rod.start.spin = {0, 0, bar.w0};
  rod.start.velocity = cross(rod.start.spin, rod.start.position);
  const Vector pulled{bar.s * cos(bar.theta0), bar.s * sin(bar.theta0), 0};
  return {{.gravity = {0, -bar.g, 0},
           .bodies = {rod},
           .joints = {{Joint::hinge}},
           .springs = {{.at = {bar.s, -bar.h, 0}, .end = pulled, .stiffness = bar.c, .rest = bar.ell}}},
          [r](std::span<const State> seen, double) {
            const auto [x, y, z] = seen[0].position;
            return std::vector{r * x / hypot(x, y), r * y / hypot(x, y)};
          }};
}

Energy energy(const Parameters& p, std::span<const double> x) {
  const auto conserved = CartesianWithConstraint<double>{asked(p)}.conserved({x[0], x[1], x[2], x[3]}, 0);
  return {conserved[0].value, conserved[0].moving};
}

/// Distance from the mass's circle.
double off(const Parameters& p, std::span<const double> x, double) {
  return std::abs(std::hypot(x[0], x[1]) - p["r"]);
}

Scene scene() {
  return {
      .motion = swing,
      .horizon = 4,
      .game_tolerance = centimeter,
      .sweep_parameter = "c",
      .sweep_values = {20, 50, 100, 300, 1000, 2500},
      .perturbed_parameters = {"theta0", "m", "h"},
      .axes = {{"x", "y"}, "s", {{"m", {0, 1}}}},
      .listing = {{"chapters/03_rigid_body_motion/23_spring_bar/models.hpp"},
                  {{"small oscillation",
                    "spring_bar::SmallOscillation<double>{{m, r, s, c, h, g, ell, theta0, w0}}"},
                   {"one angle", "spring_bar::OneAngle<double>{{m, r, s, c, h, g, ell, theta0, w0}}"},
                   {"Cartesian with constraint",
                    "spring_bar::CartesianWithConstraint<double>{{m, r, s, c, h, g, ell, theta0, w0}}"}}},
      .draw = spring_bar::draw<Parameters>,
      .staging = staging,
      .laws = {energy, off},
  };
}

Findings study(const Parameters& p, const Reference& truth) {
  const Given<double> bar = asked(p);
  Quantity mass = motion(scene(), p, truth);
  mass.add(
      Breakdown{"Explicit Euler gains energy swing after swing: at @2 steps a second the bar turns over and "
                "over. Classical Runge-Kutta follows it at @3 steps a second.",
                "one angle, explicit Euler",
                0.125,
                Outcome::drifted,
                "one angle, Runge-Kutta 4",
                0.00390625,
                {steps_in_one(Side::broken), steps_in_one(Side::cured)}});
  Given<double> stiff = bar;
  constexpr double stronger = 1000;
  stiff.c = stronger * bar.c;
  stiff.ell = stiff.balancing_rest_length();
  Quantity fast = stiff_swing(stiff, truth);
  fast.add(
      Breakdown{"A spring @4 times as strong swings @2 times a second; explicit steps longer than "
                R"($2/\omega$ to $2\sqrt2/\omega$ throw the bar around. Step control finds the step by )"
                "itself.",
                "one angle, Runge-Kutta 4",
                0.0625,
                Outcome::drifted,
                "one angle, Fehlberg 7(8)",
                1e-10,
                {stronger, stiff.frequency() / (2 * std::numbers::pi)}});
  return {claims(p["seed"]), {small_frequency(bar, truth), mass, fast}};
}

}  // namespace ex03_23

Exercise exercise_3_23() {
  using namespace ex03_23;
  return {
      "Bar on a spring",
      "A light bar, hinged at one end, carries a mass $m$ at the distance $r$. At the distance $s$ it rests "
      "on a spring whose foot is $h$ below the level bar. What is its equation of motion, and when is it in "
      "equilibrium at $\\theta=0$?",
      parameters,
      scene(),
      study,
      proofs};
}

}  // namespace oddity
