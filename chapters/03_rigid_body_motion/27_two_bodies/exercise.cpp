// Exercise 3.27: two bodies of masses m1 and m2 that attract each other, as the first-order system
//   r' = u,  u' = beta^2/r^3 - gamma/r^2,  phi' = beta/r^2,   beta = r0^2 phi0', gamma = G (m1 + m2)
// claims.cpp derives the equations. References: Kepler's equation in universal variables, confirmed by Taylor
// series of both bodies.

#include "chapters/03_rigid_body_motion/27_two_bodies/two_bodies.hpp"

#include <array>
#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

#include "chapters/03_rigid_body_motion/03_kepler/kepler.hpp"
#include "chapters/03_rigid_body_motion/27_two_bodies/drawing.hpp"
#include "chapters/energies.hpp"
#include "chapters/in_float.hpp"
#include "chapters/scene.hpp"
#include "chapters/stops.hpp"
#include "solvers/ode/events.hpp"

namespace oddity {

namespace ex03_27 {

using namespace two_bodies;
using enum Outcome;

constexpr Parameter parameters[] = {
    {"G", usual.G, "m^3/(kg s^2)", "constant of gravity", 1e-12, 1e6},
    {"m1", usual.m1, "kg", "mass of the first body", 1e-6, 1e31},
    {"m2", usual.m2, "kg", "mass of the second body", 1e-6, 1e31},
    {"r0", usual.r0, "m", "distance at the start", 1e-3, 1e13},
    {"r0_dot", usual.r0_dot, "m/s", "its rate at the start", -1e6, 1e6},
    {"phi0", usual.phi0, "rad", "angle at the start", -7, 7},
    {"phi0_dot", usual.phi0_dot, "rad/s", "its rate at the start", 1e-9, 1e3},
    {"seed", 327, "", "seed of the random samples", 0, 1e9, whole_number},
};

// ---- methods that do not take equal steps in time ---------------------------------------------------------

/// x + i y = w^2 and dt = r ds transform the relative motion into w'' = (E/2) w, where E is the energy per
/// reduced mass [Levi-Civita 1920]. Nothing is singular at r = 0. The state is (w, w', t).
struct LeviCivita {
  using State = std::array<double, 5>;
  double half_energy;
  double stop;  ///< the time at which the motion ends

  std::array<double, 1> guards(const State& x, double) const { return {stop - x[4]}; }
  Happening<State> at_event(std::size_t, State x, double) const {
    x[4] = stop;
    return {x, true};
  }
  void operator()(const State& x, State& dxdt, double) const {
    dxdt = {x[2], x[3], half_energy * x[0], half_energy * x[1], x[0] * x[0] + x[1] * x[1]};
  }
};

/// Solves Kepler's equation at every stop. Throws std::domain_error if the orbit is not an ellipse.
Answer by_kepler(const kepler::Start& start, const Horizon& horizon) {
  const auto orbit = kepler::ellipse(start);
  Answer answer;
  std::vector<double> seen;
  std::array<double, 2> now{};
  const auto solve = [&](double, double t) {
    const double M = orbit.mean_anomaly(t);
    const auto E = kepler::by_newton(orbit.e, std::abs(M), std::numbers::pi, 50);
    answer.evaluations += E.evaluations;
    answer.ending = E.ending;
    answer.message = E.message;
    now = orbit.at_eccentric_anomaly(std::copysign(E.value, M));
    return E.reached();
  };
  through_times(horizon, solve, [&](double) { seen.insert(seen.end(), now.begin(), now.end()); });
  answer.value = Value(std::move(seen));
  return answer;
}

/// Equal steps of s up to each stop; optionally with the rates after each position.
Answer by_levi_civita(const kepler::Start& start, const Horizon& horizon, double step, bool with_rates) {
  const auto p = start.position(), v = start.velocity();
  const auto w = std::sqrt(std::complex(p[0], p[1])), rate = std::conj(w) * std::complex(v[0], v[1]) / 2.0;
  LeviCivita::State x{w.real(), w.imag(), rate.real(), rate.imag(), 0};
  Answer answer;
  std::vector<double> seen;
  const auto go_on = [&](double, double stop) {
    const LeviCivita model{start.energy() / 2, stop};
    const auto found = ode::first_event<ode::RungeKutta4>(model, x, 0, 0x1p23 * step, step);
    answer.evaluations += found.evaluations;
    answer.ending = found.ending;
    answer.message = found.message;
    x = found.value.after;
    return found.reached();
  };
  through_times(horizon, go_on, [&](double) {
    seen.push_back(x[0] * x[0] - x[1] * x[1]);
    seen.push_back(2 * x[0] * x[1]);
    if (!with_rates) return;
    const auto velocity = 2.0 * std::complex(x[2], x[3]) / std::conj(std::complex(x[0], x[1]));
    seen.push_back(velocity.real());
    seen.push_back(velocity.imag());
  });
  answer.value = Value(std::move(seen));
  return answer;
}

// ---- the path ---------------------------------------------------------------------------------------------

struct Expected {
  Outcome euler, euler_of_both, symplectic, verlet, runge_kutta;
};

Quantity path(const std::string& name, const std::string& says, const Bodies& b, const Horizon& horizon,
              const Reference& truth, Resolution steps, const Expected& expected) {
  const kepler::Start s = b.relative();
  const bool ellipse = s.energy() < 0;
  const std::string order = "its order is too low for this need at this step",
                    steep = "equal steps in time are too long where the bodies meet",
                    published = "(r, u, phi)", both = "two bodies";
  Quantity q = quantity(name, "m", "the second body seen from the first at four times, " + says,
                        trajectory(truth, "03_27_two_bodies", inputs(b), horizon), {need, "a micrometre"});
  Method by_newton{"Kepler's equation",   "Newton from pi",
                   no_resolution(),       [=](double) { return by_kepler(s, horizon); },
                   ellipse ? ok : raised, ellipse ? "" : "the orbit is no ellipse"};
  by_newton.places_and_rates = [=](double) {
    const auto orbit = kepler::ellipse(s);
    return places_and_rates_of(AtTimes{[&](double t) {
                                 const double M = orbit.mean_anomaly(t);
                                 const auto E = kepler::by_newton(orbit.e, std::abs(M), std::numbers::pi, 50);
                                 return orbit.at_eccentric_anomaly(std::copysign(E.value, M));
                               }},
                               horizon);
  };
  q.add(std::move(by_newton));
  Method levi_civita{"Levi-Civita's coordinates", "Runge-Kutta 4 in fictitious time", steps,
                     [=](double step) { return by_levi_civita(s, horizon, step, false); }};
  levi_civita.places_and_rates = [=](double step) { return by_levi_civita(s, horizon, step, true).value; };
  q.add(std::move(levi_civita));
  const std::string why = expected.runge_kutta == ok ? "" : steep;
  SceneMethods(q, horizon, std::move(steps), tolerances(4, 12))
      .by<ode::ExplicitEuler>(published, Published<double>{b}, expected.euler, order)
      .by<ode::RungeKutta4>(published, Published<double>{b}, expected.runge_kutta, why)
      .by<ode::DormandPrince54>(published, Published<double>{b})
      .by<ode::Fehlberg78>(published, Published<double>{b})
      .by<ode::ExplicitEuler>(both, BothBodies<double>{b}, expected.euler_of_both, order)
      .by<ode::SymplecticEuler>(both, BothBodies<double>{b}, expected.symplectic, order)
      .by<ode::VelocityVerlet>(both, BothBodies<double>{b}, expected.verlet,
                               expected.verlet == ok ? "" : order)
      .by<ode::RungeKutta4>(both, BothBodies<double>{b}, expected.runge_kutta, why)
      .by<ode::DormandPrince54>(both, BothBodies<double>{b})
      .by<ode::Fehlberg78>(both, BothBodies<double>{b})
      .by<ode::BulirschStoer>(both, BothBodies<double>{b});
  return q;
}

Bodies asked(const Parameters& p) {
  return {p["G"], p["m1"], p["m2"], p["r0"], p["r0_dot"], p["phi0"], p["phi0_dot"]};
}

Quantity path_of(const Parameters& p, const Horizon& horizon, const Reference& truth) {
  const Resolution steps = halving("step", 0x1p-4, 9);
  Quantity q =
      path("path", "as asked", asked(p), horizon, truth, steps, {inaccurate, inaccurate, inaccurate, ok, ok});
  SceneMethods(q, horizon, steps, tolerances(4, 12))
      .by_remaining_integrators(
          "two bodies", BothBodies<double>{asked(p)},
          {{"linearly implicit Euler", inaccurate, "a first-order method: the orbit shrinks"}});
  return with_float(std::move(q), horizon, asked(p),
                    {"Kepler's equation, Newton from pi", "(r, u, phi)", "", "two bodies"});
}

Energy energy(const Parameters& p, std::span<const double> x) {
  return orbit_energy(p["G"] * (p["m1"] + p["m2"]), x);
}

std::string_view kind(const Parameters& p) {
  return asked(p).relative().energy() < 0 ? "an ellipse" : "a hyperbola";
}

Scene scene() {
  return {
      .motion = path_of,
      .horizon = seconds,
      .game_tolerance = centimeter,
      .sweep_parameter = "phi0_dot",
      .sweep_values = {1.7, 1.5, 1, 0.5, 0.25, 0.17},
      .perturbed_parameters = {"r0", "r0_dot", "phi0_dot"},
      .axes = {{"x", "y"}, "s", {{"m", {0, 1}}}},
      .listing = {{"chapters/03_rigid_body_motion/27_two_bodies/models.hpp"},
                  {{"Kepler's equation, Newton from pi",
                    "two_bodies::ByKeplersEquation<double>({G, m1, m2, r0, r0_dot, phi0, phi0_dot})"},
                   {"(r, u, phi)", "two_bodies::Published<double>{{G, m1, m2, r0, r0_dot, phi0, phi0_dot}}"},
                   {"two bodies", "two_bodies::BothBodies<double>{{G, m1, m2, r0, r0_dot, phi0, phi0_dot}}"}},
                  {{"Levi-Civita's coordinates", "which needs Newton's method for the time of every frame"}}},
      .draw = two_bodies::draw<Parameters>,
      .laws = {energy},
      .kind = kind,
  };
}

/// The period of phi, compared with Kepler's third law for the sum of the masses.
Quantity period(const Bodies& b) {
  constexpr double digits = 1e-8;
  const kepler::Start s = b.relative();
  const double a = -s.mu() / (2 * s.energy()), turn = 2 * std::numbers::pi * a * std::sqrt(a / s.mu());
  Quantity q{"period",
             "s",
             R"(time of a whole turn of $\varphi$)",
             {R"(Kepler's third law, $2\pi\sqrt{a^3/(G(m_1+m_2))}$)", turn},
             1e-14 * turn,
             {digits * turn, "eight digits"}};
  q.add({"(r, u, phi)", "Fehlberg 7(8), event phi = phi0 + 2 pi", tolerances(6, 12), [=](double tolerance) {
           const OneTurn<double> model{{b}};
           return answer(ode::first_event<ode::Fehlberg78>(model, model.start(), 0, 3 * turn, tolerance),
                         [](const auto& event) { return event.time; });
         }});
  const double longer = std::sqrt(1 + b.m2 / b.m1);
  const bool matters = longer - 1 > digits;
  q.add({"heavy first body at rest", "Kepler's third law with m1 alone", no_resolution(),
         [=](double) {
           return Answer{turn * longer, 1};
         },
         matters ? inaccurate : ok, matters ? "the first body moves as well" : ""});
  if (!matters) return q;
  return q.add(Breakdown{
      R"(With the first body held still $\gamma$ is $G m_1$: the same ellipse's period is too long by )"
      R"(the factor $\sqrt{1+m_2/m_1}$, here @3.)",
      "heavy first body at rest, Kepler's third law with m1 alone",
      0,
      inaccurate,
      "(r, u, phi), Fehlberg 7(8), event phi = phi0 + 2 pi",
      1e-12,
      {longer}});
}

Findings study(const Parameters& p, const Reference& truth) {
  Bodies eccentric = usual, near_collision = usual;
  eccentric.phi0_dot = 0.5;
  near_collision.phi0_dot = 0x1p-5;
  const auto eccentricity = [](const Bodies& b) { return kepler::ellipse(b.relative()).e; };
  const Horizon horizon{scene().horizon};
  Quantity hit =
      path("near_collision", filled("$e=@4$", {eccentricity(near_collision)}), near_collision, horizon, truth,
           halving("step", 0x1p-5, 9), {diverged, diverged, diverged, diverged, diverged});
  const kepler::Start apart = near_collision.relative();
  const double spin = near_collision.r0 * near_collision.r0 * near_collision.phi0_dot, mu = apart.mu(),
               nearest = spin * spin / (mu + std::sqrt(mu * mu + 2 * apart.energy() * spin * spin));
  hit.add(
      Breakdown{"The bodies, let go at @2 m/s, pass each other at $@1$ of their first distance and at @3 "
                R"(m/s: equal steps of time jump over it. In Levi-Civita's coordinates, with $dt = r\,ds$, )"
                "the same motion is a harmonic oscillator, and equal steps of $s$ do.",
                "two bodies, Runge-Kutta 4",
                0x1p-13,
                diverged,
                "Levi-Civita's coordinates, Runge-Kutta 4 in fictitious time",
                0x1p-8,
                {std::hypot(near_collision.r0_dot, spin / near_collision.r0), nearest / near_collision.r0,
                 spin / nearest}});
  std::vector<Quantity> all{
      motion(scene(), p, truth),
      path("eccentric_path", filled("$e=@2$", {eccentricity(eccentric)}), eccentric, horizon, truth,
           halving("step", 0x1p-5, 9), {drifted, drifted, inaccurate, inaccurate, ok}),
      hit};
  if (const Bodies bodies = asked(p); bodies.relative().energy() < 0) all.push_back(period(bodies));
  return {claims(p["seed"], truth), all};
}

}  // namespace ex03_27

Exercise exercise_3_27() {
  using namespace ex03_27;
  return {
      "Two bodies by distance and angle",
      "Two bodies attract each other by gravity. Write their motion as a first-order system in the distance "
      "$r$, its rate $u$ and the angle $\\varphi$, ready to be integrated.",
      parameters,
      scene(),
      study,
      proofs};
}

}  // namespace oddity
