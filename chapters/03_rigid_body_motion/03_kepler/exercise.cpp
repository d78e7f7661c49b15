// Exercise 3.3: the planet's path from (r0, theta0) with (r0', theta0'). The book reduces the motion to one
// equation for the angle, (7), by the potential as a function of the angle, (3):
//   V = -GM/r = c0 sin(theta) + c1 cos(theta) - G^2 M^4/alpha^2,   theta' = alpha V^2/(G^2 M^3),
//   alpha = M r0^2 theta0'.
// claims.cpp checks the derivation by Newton's law; models.hpp contains the models. The reference is Kepler's
// equation in universal variables and the Taylor series of the Cartesian equations, in 60 digits.

#include "chapters/03_rigid_body_motion/03_kepler/drawing.hpp"
#include "chapters/03_rigid_body_motion/03_kepler/kepler.hpp"
#include "chapters/energies.hpp"
#include "chapters/in_float.hpp"
#include "chapters/scene.hpp"
#include "reference/text.hpp"
#include "solvers/ode/events.hpp"
#include "solvers/quadrature.hpp"

namespace oddity {

namespace ex03_03 {

using namespace kepler;
using std::numbers::pi;

constexpr Parameter parameters[] = {
    {"G", near_earth.G, "AU^3/(yr^2 solar mass)", "constant of gravitation", 1e-3, 1e5},
    {"M", near_earth.M, "solar mass", "mass of the sun", 1e-6, 1e3},
    {"r0", near_earth.r0, "AU", "distance at the start", 1e-3, 1e3},
    {"r0_dot", near_earth.r0_dot, "AU/yr", "its rate", -1e3, 1e3},
    {"theta0", near_earth.theta0, "rad", "angle at the start", -10, 10},
    {"theta0_dot", near_earth.theta0_dot, "rad/yr", "its rate", 1e-5, 1e5},
    {"seed", 1, "", "seed of the random orbits", 0, 1e6, whole_number},
    {"e", 0.5, "", "eccentricity, for Kepler's equation alone", 0, 0.999},
    {"mean", 1, "rad", "mean anomaly, for Kepler's equation alone", 0, 3.14159},
};

std::vector<double> inputs(const Start& s) { return {s.G, s.M, s.r0, s.r0_dot, s.theta0, s.theta0_dot}; }

// ---- the path ---------------------------------------------------------------------------------------------

/// Ends as `raised` unless the orbit is an ellipse.
template <class Solve>
Answer by_keplers_equation(const Start& start, const Horizon& horizon, const Solve& solve) {
  const Ellipse<double> orbit = ellipse(start);
  return observe_at_times(horizon, [&](double t, Answer& answer) {
    const double M = orbit.mean_anomaly(t);
    const Solved<double> E = solve(orbit.e, abs(M));
    answer.evaluations += E.evaluations;
    answer.ending = E.ending;
    answer.message = E.message;
    return orbit.at_eccentric_anomaly(std::copysign(E.value, M));
  });
}

/// Expected outcomes of fixed-step methods at the finest setting.
struct EqualSteps {
  Outcome euler = Outcome::inaccurate, runge_kutta = Outcome::ok;
};

template <class Model>
void integrated(SceneMethods& methods, const std::string& name, const Model& model, const EqualSteps& equal) {
  const std::string order = "its order is too low for this need at this step";
  methods.by<ode::ExplicitEuler>(name, model, equal.euler, order)
      .template by<ode::RungeKutta4>(
          name, model, equal.runge_kutta,
          equal.runge_kutta == Outcome::ok ? "" : "even these steps are too long at the perihelion")
      .template by<ode::DormandPrince54>(name, model)
      .template by<ode::Fehlberg78>(name, model);
  if constexpr (ode::Partitioned<Model, typename Model::State>)
    methods.template by<ode::SymplecticEuler>(name, model, Outcome::inaccurate, order)
        .template by<ode::VelocityVerlet>(name, model, Outcome::inaccurate, order)
        .template by<ode::BulirschStoer>(name, model);
}

struct AtFinest {
  EqualSteps angle = {}, distance = {}, polar = {}, cartesian = {};
};

constexpr double kilometers_per_au = 149597870.7, earths_diameter = 12742;  // km

Quantity path(const std::string& name, const std::string& says, const Start& s, const Horizon& horizon,
              const Reference& truth, const Resolution& steps, const AtFinest& expected) {
  Quantity where =
      quantity(name, "AU", "position at " + times_up_to(horizon, "yr") + ", " + says,
               trajectory(truth, "03_03_orbit", inputs(s), horizon),
               {1e-6, filled("@3 km, 1/@2 of the Earth's diameter",
                             {1e-6 * kilometers_per_au, earths_diameter / (1e-6 * kilometers_per_au)})});
  const auto solved = [&](std::string algorithm, auto solve) {
    Method method{"Kepler's equation", std::move(algorithm), no_resolution(),
                  [=](double) { return by_keplers_equation(s, horizon, solve); }};
    method.places_and_rates = [=](double) {
      const Ellipse<double> orbit = ellipse(s);
      return places_and_rates_of(AtTimes{[&](double t) {
                                   const double M = orbit.mean_anomaly(t);
                                   const double E = solve(orbit.e, abs(M)).value;
                                   return orbit.at_eccentric_anomaly(std::copysign(E, M));
                                 }},
                                 horizon);
    };
    where.add(std::move(method));
  };
  solved("Newton from pi", [](double e, double M) { return by_newton(e, M, pi, 50); });
  solved("Newton from M + 0.85 e", [](double e, double M) { return by_newton(e, M, M + 0.85 * e, 50); });
  solved("Brent", [](double e, double M) { return bracketed(e, M, 1e-14); });
  SceneMethods methods(where, horizon, steps, tolerances());
  methods.by<ode::Fehlberg78>("equation (7) as printed", OneAngleAsPrinted<double>(s), Outcome::inaccurate,
                              R"($V_0$ has the wrong sign, and the perihelion is not at $\theta=0$)");
  integrated(methods, "equation (7)", OneAngle<double>(s), expected.angle);
  integrated(methods, "equation (2)", Distance<double>{s}, expected.distance);
  integrated(methods, "polar", Polar<double>{s}, expected.polar);
  integrated(methods, "Cartesian", Cartesian<double>{s}, expected.cartesian);
  return where;
}

Start asked(const Parameters& p) {
  return {p["G"], p["M"], p["r0"], p["r0_dot"], p["theta0"], p["theta0_dot"]};
}

Quantity planet(const Parameters& p, const Horizon& horizon, const Reference& truth) {
  const Start s = asked(p);
  const Resolution steps = halving("step", 0.125, 9);
  Quantity where = path("path", "near the Earth's orbit unless asked otherwise", s, horizon, truth, steps,
                        {{}, {}, {}, {Outcome::drifted, Outcome::ok}});
  SceneMethods(where, horizon, steps, tolerances())
      .by<ode::CashKarp54>("Cartesian", Cartesian<double>{s})
      .by_remaining_integrators(
          "Cartesian", Cartesian<double>{s},
          {{"modified midpoint", Outcome::inaccurate, "its order is too low for this need at this step"},
           {"linearly implicit Euler", Outcome::drifted,
            "a first-order method that loses energy: the planet spirals in"}});
  return with_float(std::move(where), horizon, s,
                    {"", "Kepler's equation, Newton from M + 0.85 e", "equation (7)", "equation (2)", "polar",
                     "Cartesian"});
}

Energy energy(const Parameters& p, std::span<const double> x) { return orbit_energy(p["G"] * p["M"], x); }

std::string_view kind(const Parameters& p) { return asked(p).energy() < 0 ? "an ellipse" : "a hyperbola"; }

/// Time in years instead of seconds. From the aphelion the angle's rate determines the eccentricity: 0.1,
/// 0.5, 0.9, 0.975, 0.99. The tolerance is one degree of the Earth's orbit, in AU.
Scene scene() {
  return {
      .motion = planet,
      .horizon = 2,
      .game_tolerance = degree,
      .sweep_parameter = "theta0_dot",
      .sweep_values = {5.95, 4.45, 2, 1, 0.63},
      .perturbed_parameters = {"r0", "theta0", "theta0_dot"},
      .axes = {{"x", "y"}, "yr", {{"AU", {0, 1}}}},
      .listing = {{"chapters/03_rigid_body_motion/03_kepler/models.hpp"},
                  {{"Kepler's equation, Newton from M + 0.85 e",
                    "kepler::ByKeplersEquation<double>({G, M, r0, r0_dot, theta0, theta0_dot})"},
                   {"equation (7) as printed",
                    "kepler::OneAngleAsPrinted<double>({G, M, r0, r0_dot, theta0, theta0_dot})"},
                   {"equation (7)", "kepler::OneAngle<double>({G, M, r0, r0_dot, theta0, theta0_dot})"},
                   {"equation (2)", "kepler::Distance<double>{{G, M, r0, r0_dot, theta0, theta0_dot}}"},
                   {"polar", "kepler::Polar<double>{{G, M, r0, r0_dot, theta0, theta0_dot}}"},
                   {"Cartesian", "kepler::Cartesian<double>{{G, M, r0, r0_dot, theta0, theta0_dot}}"}}},
      .draw = kepler::draw<Parameters>,
      .laws = {energy},
      .faulted = {"equation (7) as printed"},
      .kind = kind,
  };
}

std::vector<Quantity> paths(const Parameters& p, const Reference& truth) {
  using enum Outcome;
  const Horizon horizon{scene().horizon};
  Quantity earth = motion(scene(), p, truth);
  earth.add(
      {"With (4) and (5) as printed the ellipse drawn has the right size and the wrong orientation, and the "
       "planet comes to a halt on it. The square in (7) hides the sign of $V_0$ at the start.",
       "equation (7) as printed, Fehlberg 7(8)", 1e-12, inaccurate, "equation (7), Fehlberg 7(8)", 1e-12});
  earth.add(
      {"Explicit Euler spirals out: within @1 years, at @4 steps a year, the planet is up to @1 AU from its "
       "place. Runge-Kutta 4, with four evaluations per step instead of one, keeps it within $@1$ AU.",
       "Cartesian, explicit Euler",
       0x1p-11,
       drifted,
       "Cartesian, Runge-Kutta 4",
       0x1p-11,
       {horizon.end, steps_in_one(Side::broken), error_of(Side::broken), error_of(Side::cured)}});
  earth.add(
      {"On (7), which has energy and angular momentum built in, explicit Euler cannot leave the orbit. It is "
       "up to $@1$ AU off along it, more than the tolerance. A higher order pays at once.",
       "equation (7), explicit Euler",
       0x1p-11,
       inaccurate,
       "equation (7), Runge-Kutta 4",
       0x1p-4,
       {error_of(Side::broken)}});

  Quantity comet = path("eccentric_path", "$e=0.9$", eccentric, horizon, truth, halving("step", 0x1p-4, 10),
                        {{}, {drifted, ok}, {non_finite, ok}, {drifted, ok}});
  comet.add(
      {"With @3 equal steps a year the planet turns too far within a step at the perihelion, and is thrown "
       "out. Step control puts the steps where they are needed.",
       "Cartesian, Runge-Kutta 4",
       0x1p-8,
       drifted,
       "Cartesian, Fehlberg 7(8)",
       1e-12,
       {steps_in_one(Side::broken)}});

  Quantity grazer = path("very_eccentric_path", "$e=0.99$, two solar masses", very_eccentric, horizon, truth,
                         halving("step", 0x1p-6, 10),
                         {{}, {diverged, inaccurate}, {non_finite, inaccurate}, {diverged, inaccurate}});
  grazer.add(
      {"Even @5 equal steps a year are too long for the perihelion. Kepler's equation has none to follow.",
       "Cartesian, Runge-Kutta 4",
       0x1p-15,
       inaccurate,
       "Kepler's equation, Newton from pi",
       0,
       {steps_in_one(Side::broken)}});
  grazer.add(
      {"Equation (2) meets its singularity at $r=0$ likewise. Equation (7), which has none, holds at the "
       "same equal steps.",
       "equation (2), Runge-Kutta 4", 0x1p-15, inaccurate, "equation (7), Runge-Kutta 4", 0x1p-15});
  return {earth, comet, grazer};
}

// ---- Kepler's equation ------------------------------------------------------------------------------------

Quantity eccentric_anomaly(const std::string& name, const std::string& says, double e, double M,
                           const Reference& truth) {
  using enum Outcome;
  const Known root = truth("03_03_eccentric_anomaly", {e, M});
  Quantity E = quantity(name, "rad", R"($E$ with $E-e\sin E=M$, )" + says, root,
                        {1e-12, filled("@2 m on the Earth's orbit", {1e-12 * 1e3 * kilometers_per_au})});
  const auto add = [&](std::string algorithm, const Resolution& resolution, auto solve,
                       const Foreseen& expected = {ok}, std::string why = {}) {
    E.add(expecting(expected, std::move(why),
                    {"Kepler's equation", std::move(algorithm), resolution,
                     [=](double n) { return answer(solve(static_cast<int>(n))); }}));
  };
  const Resolution iterations = doubling("iterations", 1, 5), many = doubling("iterations", 1, 8),
                   terms = doubling("terms", 2, 7);
  const auto finest = [](const Resolution& resolution) {
    return static_cast<int>(resolution.settings.back());
  };
  const auto ends = [&](const Estimate& error) {
    return foreseen(error, E.need.allowed, size_of(root.value));
  };
  const double first = M + e * sin(M) / (1 - e * cos(M));  // where the tangent at M leads
  add(
      "Newton from M", iterations, [=](int n) { return by_newton(e, M, M, n); },
      first <= pi ? Foreseen{ok} : Foreseen{stalled, false},
      R"($1-e\cos M$ is small: the first step goes beyond $\pi$, and the iterates wander)");
  add("Newton from pi", iterations, [=](int n) { return by_newton(e, M, pi, n); });
  add("Newton from M + 0.85 e", iterations, [=](int n) { return by_newton(e, M, M + 0.85 * e, n); });
  add(
      "fixed point", many, [=](int n) { return fixed_point(e, M, n); },
      ends(error_of_fixed_point(e, M, root.value[0], finest(many))),
      filled(R"(each iteration multiplies the error by $e\cos E=@3$)", {e * cos(root.value[0])}));
  add(
      "Bessel functions", terms, [=](int n) { return bessel_series(e, M, n); },
      ends(error_of_bessel_series(e, M, finest(terms))),
      filled("its terms fall by @1 % each", {100 * (1 - power_of_terms(e))}));
  add(
      "power series in e", terms, [=](int n) { return lagrange_series(e, M, n); },
      ends(error_of_lagrange_series(e, M, finest(terms))),
      filled("it may diverge beyond Laplace's limit, $e=@4$, and falls slowly before it", {laplace_limit()}));
  E.add({"Kepler's equation", "Brent", tolerances(), [=](double t) { return answer(bracketed(e, M, t)); }});
  return E;
}

std::vector<Quantity> eccentric_anomalies(const Parameters& p, const Reference& truth) {
  Quantity easy = eccentric_anomaly(
      "eccentric_anomaly", "$e=" + format_shortest(p["e"]) + "$, $M=" + format_shortest(p["mean"]) + "$",
      p["e"], p["mean"], truth);
  Quantity hard =
      eccentric_anomaly("eccentric_anomaly_past_perihelion", "$e=0.99$, $M=1/16$", 0.99, 0.0625, truth);
  const auto iterate = [](int n) { return by_newton(0.99, 0.0625, 0.0625, n).value; };
  hard.add({R"(Newton's method from $E=M$ goes to $@2$, $@2$, $@3$, ... and has not come back after @2 )"
            R"(iterations. From $\pi$, where the function is convex all the way down to the root, it cannot )"
            R"(overshoot.)",
            "Kepler's equation, Newton from M",
            16,
            Outcome::stalled,
            "Kepler's equation, Newton from pi",
            16,
            {iterate(1), iterate(2), iterate(3), setting_of(Side::broken)}});
  hard.add(
      {"The power series in the eccentricity may diverge for $e>@4$ (Laplace's limit). A bracket always "
       "holds: the root is between $M$ and $M+e$.",
       "Kepler's equation, power series in e",
       128,
       Outcome::diverged,
       "Kepler's equation, Brent",
       1e-12,
       {laplace_limit()}});
  return {easy, hard};
}

// ---- the period -------------------------------------------------------------------------------------------

/// Integrates until the angle has advanced by a turn. The event's bracket contains no information on the
/// integration's error.
template <class Algorithm, class Model>
Answer turn_by(const Model& model, std::size_t angle, double limit, double setting) {
  const double sense = model.p.theta0_dot < 0 ? -1 : 1;
  const auto turned = [&](const typename Model::State& x, double) {
    return sense * (x[angle] - model.p.theta0) - 2 * pi;
  };
  const auto event = ode::find_event<Algorithm>(model, model.start(), 0, limit, setting, turned);
  return {event.value.time, event.evaluations, std::numeric_limits<double>::quiet_NaN(), 0,
          event.ending,     event.message};
}

Quantity period(const std::string& name, const std::string& says, const Start& s, const Reference& truth) {
  constexpr double need = 1e-9, seconds_per_year = 365.25 * 86400;
  Quantity T = quantity(name, "yr", "period, " + says, truth("03_03_period", inputs(s)),
                        {need, filled("@1 s", {need * seconds_per_year})});
  const Ellipse<double> orbit = ellipse(s);
  const OneAngle<double> seven(s);
  const auto slowness = [=](double theta) {
    std::array<double, 1> rate{};
    seven.operator()<double>({theta}, rate, 0);
    return 1 / abs(rate[0]);
  };
  const auto third_law = [=](double a) { return Answer{2 * pi * std::pow(a, 1.5) / sqrt(s.mu()), 1}; };
  T.add({"Kepler's third law", "a = half the axis", no_resolution(),
         [=](double) { return third_law(orbit.a); }});
  T.add({"Kepler's third law", "a = the axis", no_resolution(),
         [=](double) { return third_law(2 * orbit.a); }, Outcome::inaccurate,
         "the law is about half the axis"});
  T.add({"turn of equation (7)", "trapezoid", doubling("panels", 4, 9),
         [=](double n) { return answer(trapezoid(slowness, 0, 2 * pi, static_cast<int>(n))); }});
  T.add({"turn of equation (7)", "Simpson", doubling("panels", 4, 11),
         [=](double n) { return answer(simpson(slowness, 0, 2 * pi, static_cast<int>(n))); }});
  T.add({"turn of equation (7)", "QAG", tolerances(),
         [=](double t) { return answer(qag(slowness, 0, 2 * pi, t)); }});
  const double limit = 1.5 * 2 * pi / orbit.n;
  T.add({"polar", "Fehlberg 7(8)", tolerances(),
         [=](double t) { return turn_by<ode::Fehlberg78>(Polar<double>{s}, 1, limit, t); }});
  return T;
}

Findings study(const Parameters& p, const Reference& truth) {
  const Start start = asked(p);
  std::vector<Quantity> all = paths(p, truth);
  const auto append = [&](const std::vector<Quantity>& more) {
    all.insert(all.end(), more.begin(), more.end());
  };
  append(eccentric_anomalies(p, truth));
  if (start.energy() < 0) {
    append({period("period", "near the Earth's unless asked otherwise", start, truth)});
    all.back().for_own_parameters = true;
  }
  append({period("period_eccentric", "$e=0.9$", eccentric, truth),
          period("period_very_eccentric", "$e=0.99$", very_eccentric, truth)});
  return {
      kepler::claims(p["seed"]), all, kepler::roots(),
      R"(The derivation of the orbit is right, the formulas for a program are not: {{sign of the potential at the start|the constants have the wrong sign of the potential}}, and {{angle from the axis for the angle from the perihelion|the distance is taken at the wrong angle}}. {{the sun's mass for the planet's|Momentum and energy have the sun's mass}}, {{any orbit for an eccentric one|a direct solver is blamed for any orbit}}, and {{rest}} are cases left out.)"};
}

}  // namespace ex03_03

Exercise exercise_3_3() {
  using namespace ex03_03;
  return {
      "Kepler's orbit in polar coordinates",
      "Compute the planet's path $(r(t),\\theta(t))$ from $r_0,r_0',\\theta_0,\\theta_0'$: reduce the motion "
      "to one equation for $\\theta$ by writing the potential $V=-GM/r$ as a function of the angle, and "
      "solve it numerically.",
      parameters,
      scene(),
      study,
      proofs,
      Expected::in_whole_ranges};
}

}  // namespace oddity
