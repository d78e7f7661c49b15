// The quantities of exercise 3.7. The energy equation also has the constant solution q = q0, and the
// integrand for the time is infinite at q0; q = q0 (1 - u^2) avoids both.

#include "chapters/03_rigid_body_motion/07_bead_on_cubic/bead_on_cubic.hpp"
#include "solvers/quadrature.hpp"
#include "solvers/roots.hpp"

namespace oddity::ex03_07 {

using namespace bead_on_cubic;

template <class Algorithm, class Model>
void add_event(Quantity& arrival, const std::string& name, const Model& model, Outcome expected = Outcome::ok,
               const std::string& why = {}) {
  const auto run = [model](double setting) {
    return answer(event_of<Algorithm>(model, setting), [](const auto& event) { return event.time; });
  };
  const Resolution steps = halving("step", latest(model.p) / 32, 8);
  const ode::AlgorithmInfo algorithm = ode::info<Algorithm>();
  arrival.add({name, std::string(algorithm.name), ode::has_tolerance(algorithm.kind) ? tolerances() : steps,
               run, expected, why});
}

template <class Model>
void add_events(Quantity& arrival, const std::string& name, const Model& model) {
  add_event<ode::ExplicitEuler>(arrival, name, model, Outcome::inaccurate,
                                "its order is too low for this need at this step");
  add_event<ode::RungeKutta4>(arrival, name, model);
  add_event<ode::CashKarp54>(arrival, name, model);
  add_event<ode::DormandPrince54>(arrival, name, model);
  add_event<ode::Fehlberg78>(arrival, name, model);
  add_event<ode::BulirschStoer>(arrival, name, model);
}

const std::string stuck = "energy in q", regular = "energy in u", one = "one coordinate",
                  cartesian = "Cartesian with constraints", raw = "energy integral over q",
                  substituted = "energy integral over u";
const std::string fehlberg{ode::info<ode::Fehlberg78>().name};

void add_integrals(Quantity& arrival, const Given<double>& bead) {
  const double q0 = bead.q0;
  const auto over_q = [=](double q) { return 1 / EnergyInQ<double>{bead}.speed(q); };
  const auto over_u = [=](double u) { return EnergyInU<double>{bead}.seconds_per_u(u); };
  const auto panels = [](double n) { return static_cast<int>(n); };
  arrival.add({raw, "Gauss-Legendre", doubling("points", 4, 8),
               [=](double n) { return answer(gauss_legendre(over_q, 0, q0, panels(n))); },
               Outcome::inaccurate, "no polynomial follows the infinite end"});
  arrival.add({raw, "QAG", tolerances(), [=](double e) { return answer(qag(over_q, 0, q0, e)); },
               Outcome::non_finite,
               "bisection alone walks into the infinite end, where $q_0^3-q^3$ rounds to 0"});
  arrival.add({raw, "CQUAD", tolerances(), [=](double e) { return answer(cquad(over_q, 0, q0, e)); },
               Outcome::stalled, "$q_0^3-q^3$ cancels at the infinite end, and the end itself is left out"});
  arrival.add({raw, "QAGS", tolerances(), [=](double e) { return answer(qags(over_q, 0, q0, e)); }});
  arrival.add({substituted, "Simpson", doubling("panels", 4, 9),
               [=](double n) { return answer(simpson(over_u, 0, 1, panels(n))); }});
  arrival.add({substituted, "Gauss-Legendre", doubling("points", 4, 5),
               [=](double n) { return answer(gauss_legendre(over_u, 0, 1, panels(n))); }});
  arrival.add({substituted, "QAGS", tolerances(), [=](double e) { return answer(qags(over_u, 0, 1, e)); }});
}

Quantity arrival(const Given<double>& bead, const Reference& truth) {
  Quantity time = quantity("arrival", "s", "time from release to the origin",
                           truth("03_07_arrival", {bead.q0, bead.g}), {});
  time.need = {4e-10 * time.reference.value[0], "nine decimals of the book's case"};
  add_integrals(time, bead);
  add_event<ode::RungeKutta4>(time, regular, EnergyInU<double>{bead});
  add_event<ode::Fehlberg78>(time, regular, EnergyInU<double>{bead});
  add_events(time, one, OneCoordinate<double>{bead});
  add_event<ode::Fehlberg78>(time, cartesian, CartesianWithConstraints<double>{bead});
  add_event<ode::Fehlberg78>(time, stuck, EnergyInQ<double>{bead}, Outcome::raised,
                             "$q=q_0$ for ever solves it too, and that is the solution taken");
  time.add(
      Breakdown{"The time's integrand is infinite at the release, and bisection goes there until it "
                "divides by zero. In $u$, with $q=q_0(1-u^2)$, it is smooth: @2 points are enough.",
                raw + ", QAG",
                1e-10,
                Outcome::non_finite,
                substituted + ", Gauss-Legendre",
                16,
                {setting_of(Side::cured)}});
  time.add(Breakdown{
      R"(Energy alone, $\dot q=-\sqrt{\ldots}$, lets a bead at rest stay at rest: the event never comes. )"
      R"(In $u$ the same level is regular at the release, and the bead leaves.)",
      stuck + ", " + fehlberg, 1e-12, Outcome::raised, regular + ", " + fehlberg, 1e-12});
  return time;
}

/// The position at a time from the energy integral over u, by Brent's method on a Gauss rule.
std::array<double, 3> by_inverted_integral(const EnergyInU<double>& bead, double t, int points,
                                           Answer& answer) {
  const auto late = [&](double u) {
    const auto time = gauss_legendre([&](double s) { return bead.seconds_per_u(s); }, 0, u, points);
    answer.evaluations += time.evaluations;
    return time.value - t;
  };
  double most = 1;
  while (late(most) < 0) most *= 2;
  const auto u = brent(late, 0, most, 1e-14);
  answer.ending = u.ending;
  answer.message = u.message;
  return bead.observe({u.value}, t);
}

Quantity slide(const Given<double>& bead, const Horizon& horizon, const Reference& truth) {
  Quantity position = quantity("slide", "m", "position at " + times_up_to(horizon),
                               trajectory(truth, "03_07_slide", {bead.q0, bead.g}, horizon), {});
  position.need = {1e-7 * size_of(position.reference.value), "a ten-millionth of the farthest coordinate"};
  SceneMethods(position, horizon, halving("step", 0.125, 9), tolerances())
      .closed_form("straight tangent", StraightTangent<double>{bead}, Outcome::inaccurate,
                   "the curve bends away")
      .by<ode::Fehlberg78>(stuck, EnergyInQ<double>{bead}, Outcome::inaccurate, "the bead never moves")
      .by_core_integrators(regular, EnergyInU<double>{bead})
      .by_engine_integrators(one, OneCoordinate<double>{bead})
      .by_remaining_integrators(one, OneCoordinate<double>{bead},
                                {{"linearly implicit Euler", Outcome::inaccurate,
                                  "its order is too low for this need at this step"}})
      .by_engine_integrators(cartesian, CartesianWithConstraints<double>{bead});
  const auto inverted = [bead](double n, double t, Answer& answer) {
    return by_inverted_integral(EnergyInU<double>{bead}, t, static_cast<int>(n), answer);
  };
  Method by_brent{substituted, "Gauss-Legendre, inverted by Brent", doubling("points", 4, 6), [=](double n) {
                    return observe_at_times(horizon,
                                            [&](double t, Answer& answer) { return inverted(n, t, answer); });
                  }};
  by_brent.places_and_rates = [=](double n) {
    Answer uncounted;
    return places_and_rates_of(AtTimes{[&](double t) { return inverted(n, t, uncounted); }}, horizon);
  };
  position.add(std::move(by_brent));
  position.add(Breakdown{
      R"(Energy alone, $\dot q=-\sqrt{\ldots}$, lets a bead at rest stay at rest; the second-order )"
      R"(equation does not.)",
      stuck + ", " + fehlberg, 1e-12, Outcome::inaccurate, one + ", " + fehlberg, 1e-12});
  return position;
}

}  // namespace oddity::ex03_07
