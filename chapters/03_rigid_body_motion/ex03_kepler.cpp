// Exercise 3.3: the planet's path from (r0, theta0) with (r0', theta0'). The book reduces the motion to one
// equation for the angle, (7), by the potential as a function of the angle, (3):
//   V = -GM/r = c0 sin(theta) + c1 cos(theta) - G^2 M^4/alpha^2,   theta' = alpha V^2/(G^2 M^3),
//   alpha = M r0^2 theta0'.
// kepler_claims.hpp judges the derivation against Newton's law, kepler.hpp has the models. The reference is
// Kepler's equation in universal variables and the Taylor series of the Cartesian equations, in 60 digits.

#ifdef __GNUC__  // of a state of one number, GCC sees that Odeint copies steppers with their scratch
                 // unwritten
#pragma GCC diagnostic ignored "-Wuninitialized"
#endif

#include "chapters/03_rigid_body_motion/kepler.hpp"
#include "chapters/03_rigid_body_motion/kepler_claims.hpp"
#include "chapters/scene.hpp"

namespace oddity {

namespace {

using namespace kepler;

constexpr double four_pi_squared = 39.47841760435743;

constexpr Parameter parameters[] = {
    {"G", four_pi_squared, "AU^3/(yr^2 solar mass)", "constant of gravitation", 4, 400},
    {"M", 1, "solar mass", "mass of the sun", 0.1, 4},
    {"r0", 1, "AU", "distance at the start", 0.25, 4},
    {"r0_dot", 0.09375, "AU/yr", "its rate", -6, 6},
    {"theta0", 1.75, "rad", "angle at the start", -10, 10},
    {"theta0_dot", 6.25, "rad/yr", "its rate", 0.1, 20},
};

constexpr Start eccentric{four_pi_squared, 1, 1.75, 1.7862, -2, 0.8943};
constexpr Start very_eccentric{four_pi_squared, 2, 1.75, -3.28124, 0.75, 0.409303};

std::vector<double> inputs(const Start& s) { return {s.G, s.M, s.r0, s.r0_dot, s.theta0, s.theta0_dot}; }

// ---- the path
// -------------------------------------------------------------------------------------------------

template <class Solve>
Answer by_keplers_equation(const Start& start, const Horizon& horizon, const Solve& solve) {
  const Ellipse orbit(start);
  Answer answer;
  std::vector<double> seen;
  const auto times = horizon.times();
  for (std::size_t i = 1; i < times.size(); ++i) {
    const double M = orbit.mean_anomaly(times[i]);
    const Solved<double> E = solve(orbit.e, abs(M));
    answer.evaluations += E.evaluations;
    if (!E.reached()) answer.ending = E.ending;
    for (double x : orbit.at_eccentric_anomaly(std::copysign(E.value, M))) seen.push_back(x);
  }
  answer.value = Value(std::move(seen));
  return answer;
}

/// How the methods of equal steps end at the finest one, and why some fail.
struct EqualSteps {
  Outcome euler, runge_kutta;
  std::string why;
};

template <class Model>
void integrated(Ladder& ladder, const std::string& name, const Model& model, const EqualSteps& steps) {
  const std::string order = "its order is too low for this need at this step";
  ladder.by<ode::ExplicitEuler>(name, model, steps.euler, order)
      .template by<ode::RungeKutta4>(name, model, steps.runge_kutta,
                                     steps.runge_kutta == Outcome::ok ? "" : steps.why)
      .template by<ode::DormandPrince54>(name, model)
      .template by<ode::Fehlberg78>(name, model)
      .template by<ode::BulirschStoer>(name, model);
  if constexpr (Partitioned<Model>)
    ladder.template by<ode::SymplecticEuler>(name, model, Outcome::inaccurate, order)
        .template by<ode::VelocityVerlet>(name, model, Outcome::inaccurate, order)
        .template by<ode::CashKarp54>(name, model);
}

struct Expected {
  EqualSteps angle, distance, polar, cartesian;
};

Quantity path(const std::string& name, std::string says, const Start& s, const Reference& truth, Knob steps,
              const Expected& expected) {
  const Horizon horizon{2};
  Quantity where = quantity(name, "AU", "position after 0.5, 1, 1.5 and 2 yr, " + std::move(says),
                            trajectory(truth, "03_03_orbit", inputs(s), horizon),
                            {1e-6, "150 km, an 85th of the Earth's diameter"});
  const auto solved = [&](std::string algorithm, auto solve) {
    where.add({"Kepler's equation", std::move(algorithm), no_knob(),
               [=](double) { return by_keplers_equation(s, horizon, solve); }});
  };
  solved("Newton from pi", [](double e, double M) { return newton(e, M, pi, 50); });
  solved("Newton from M + 0.85 e", [](double e, double M) { return newton(e, M, M + 0.85 * e, 50); });
  solved("Brent", [](double e, double M) { return bracketed(e, M, 1e-14); });
  Ladder ladder(where, horizon, std::move(steps), tolerances());
  ladder.by<ode::DormandPrince54>("equation (7) as printed", OneAngleAsPrinted(s), Outcome::inaccurate,
                                  "V0 has the wrong sign, and the perihelion is not at theta = 0");
  integrated(ladder, "equation (7)", OneAngle(s, -s.mu() / s.r0), expected.angle);
  integrated(ladder, "equation (2)", Distance{s}, expected.distance);
  integrated(ladder, "polar", Polar{s}, expected.polar);
  integrated(ladder, "Cartesian", Cartesian{s}, expected.cartesian);
  where.add(
      Breakdown{"With (4) and (5) as printed the curve drawn is an ellipse of the right size and the wrong "
                "orientation, and the planet comes to a halt on it.",
                "equation (7) as printed, Dormand-Prince 5(4)", 1e-12, Outcome::inaccurate,
                "equation (7), Dormand-Prince 5(4)", 1e-12});
  return where;
}

std::vector<Quantity> paths(const Start& asked, const Reference& truth) {
  using enum Outcome;
  const EqualSteps fine{inaccurate, ok, ""};
  const std::string why = "equal steps are too long at the perihelion";
  Quantity earth = path("path", "near the Earth's orbit unless asked otherwise", asked, truth,
                        halving("step", 0.125, 9), {fine, fine, fine, {drifted, ok, ""}});
  Quantity comet = path("eccentric_path", "e = 0.9", eccentric, truth, halving("step", 0x1p-4, 10),
                        {fine, fine, fine, {drifted, ok, why}});
  Quantity grazer = path("very_eccentric_path", "e = 0.99, two solar masses", very_eccentric, truth,
                         halving("step", 0x1p-6, 10), {fine, fine, fine, {drifted, ok, why}});
  return {earth, comet, grazer};
}

Findings study(const Parameters& p, const Reference& truth) {
  const Start asked{p["G"], p["M"], p["r0"], p["r0_dot"], p["theta0"], p["theta0_dot"]};
  return {kepler::claims(), paths(asked, truth)};
}

}  // namespace

Exercise exercise_3_3() { return {"Kepler's orbit in polar coordinates", "", parameters, true, study}; }

}  // namespace oddity
