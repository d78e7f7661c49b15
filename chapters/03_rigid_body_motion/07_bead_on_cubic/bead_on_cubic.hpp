#pragma once

#include <array>
#include <cmath>

#include "chapters/03_rigid_body_motion/07_bead_on_cubic/models.hpp"
#include "chapters/03_rigid_body_motion/shared/lagrangian.hpp"
#include "chapters/03_rigid_body_motion/shared/listed_runge_kutta.hpp"
#include "chapters/scene.hpp"
#include "reference/text.hpp"
#include "solvers/dual.hpp"
#include "solvers/ode/events.hpp"
#include "solvers/quadrature.hpp"
#include "solvers/roots.hpp"

/// A bead on a cubic: its Lagrangian from the curve alone, and the quantities of exercise 3.7.
namespace oddity::bead_on_cubic {

// ---- the Lagrangian ---------------------------------------------------------------------------------------

/// The bead's velocity for q' = v.
template <class T>
std::array<T, 3> velocity(const T& q, const T& v) {
  const auto x = curve(Dual<T>(q, v));
  return {x[0].slope, x[1].slope, x[2].slope};
}

/// The bead's acceleration for q' = v, q'' = a.
inline std::array<double, 3> acceleration(double q, double v, double a) {
  const auto u = velocity(Dual<double>(q, v), Dual<double>(v, a));
  return {u[0].slope, u[1].slope, u[2].slope};
}

struct KineticEnergy {
  double m;
  template <class T>
  T operator()(const T& q, const T& v, const T&) const {
    const auto u = velocity(q, v);
    return 0.5 * m * (u[0] * u[0] + u[1] * u[1] + u[2] * u[2]);
  }
};

struct Lagrangian {
  double m, g;
  template <class T>
  T operator()(const T& q, const T& v, const T& t) const {
    return KineticEnergy{m}(q, v, t) - m * g * curve(q)[2];
  }
};

// ---- random states ----------------------------------------------------------------------------------------

/// A bead somewhere on the curve, and any q''.
struct Sample {
  double m, g, q, v, a;
  explicit Sample(Random& random)
      : m(std::abs(random.magnitude(0.1, 10))),
        g(std::abs(random.magnitude(0.1, 10))),
        q(random.magnitude(0.01, 2)),
        v(random.magnitude(0.01, 3)),
        a(random.magnitude(0.01, 3)) {}
  std::array<double*, 5> letters() { return {&m, &g, &q, &v, &a}; }
  std::string where() const {
    return "m = " + shortest(m) + ", g = " + shortest(g) + ", q = " + shortest(q) + ", q' = " + shortest(v) +
           ", q'' = " + shortest(a);
  }
  KineticEnergy T() const { return {m}; }
  Lagrangian L() const { return {m, g}; }
  /// The true acceleration, from the Lagrangian.
  std::array<double, 3> acceleration() const {
    return bead_on_cubic::acceleration(q, v, lagrange_acceleration(L(), q, v));
  }
  /// x'' = q'' from gravity and the wire's two forces.
  double by_forces() const {
    const auto x = curve(q), u = velocity(q, v);
    const std::array state{x[0], x[1], x[2], u[0], u[1], u[2]};
    auto rate = state;
    CartesianWithConstraints<double>{{q, g}}(state, rate, 0.0);
    return rate[3];
  }
};

// ---- the methods ---------------------------------------------------------------------------------------

/// Longer than any arrival takes: at rest the bead is heaviest, and int_0^1 ds / std::sqrt(1 - s^3) = 1.402.
inline double latest(const Given<double>& bead) {
  return 1.5 * std::sqrt(metric(bead.q0) / (2 * bead.g * bead.q0));
}

/// The time at which a model's x changes its sign, and the state there.
template <class Algorithm, class Model>
Solved<ode::Event<typename Model::State>> event_of(const Model& model, double setting) {
  const auto x = [&](const typename Model::State& s, double t) { return model.observe(s, t)[0]; };
  return ode::find_event<Algorithm>(model, model.start(), 0, latest(model.p), setting, x);
}

template <class Algorithm, class Model>
void add_event(Quantity& arrival, const std::string& name, const Model& model, Outcome expected = Outcome::ok,
               const std::string& why = {}) {
  const auto run = [model](double setting) {
    Answer time = answer(event_of<Algorithm>(model, setting), [](const auto& event) { return event.time; });
    time.error_estimate = std::numeric_limits<double>::quiet_NaN();  // it is the last bracket's alone
    return time;
  };
  const Knob steps = halving("step", latest(model.p) / 32, 8);
  const ode::Brief algorithm = ode::brief<Algorithm>();
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

inline const std::string stuck = "energy in q", regular = "energy in u", one = "one coordinate",
                         cartesian = "Cartesian with constraints", raw = "energy integral over q",
                         substituted = "energy integral over u";
inline const std::string fehlberg{ode::brief<ode::Fehlberg78>().name};

inline void add_integrals(Quantity& arrival, const Given<double>& bead) {
  const double q0 = bead.q0;
  const auto over_q = [=](double q) { return 1 / EnergyInQ<double>{bead}.speed(q); };
  const auto over_u = [=](double u) { return EnergyInU<double>{bead}.seconds_per_u(u); };
  const auto panels = [](double n) { return static_cast<int>(n); };
  arrival.add({raw, "Gauss-Legendre", doubling("points", 4, 8),
               [=](double n) { return answer(gauss_legendre(over_q, 0, q0, panels(n))); },
               Outcome::inaccurate, "no polynomial follows the infinite end"});
  arrival.add({raw, "QAG", tolerances(), [=](double e) { return answer(qag(over_q, 0, q0, e)); },
               Outcome::non_finite,
               "bisection alone walks into the infinite end, where q0^3 - q^3 rounds to 0"});
  arrival.add({raw, "CQUAD", tolerances(), [=](double e) { return answer(cquad(over_q, 0, q0, e)); },
               Outcome::stalled, "q0^3 - q^3 cancels at the infinite end, and the end itself is left out"});
  arrival.add({raw, "QAGS", tolerances(), [=](double e) { return answer(qags(over_q, 0, q0, e)); }});
  arrival.add({substituted, "Simpson", doubling("panels", 4, 9),
               [=](double n) { return answer(simpson(over_u, 0, 1, panels(n))); }});
  arrival.add({substituted, "Gauss-Legendre", doubling("points", 4, 5),
               [=](double n) { return answer(gauss_legendre(over_u, 0, 1, panels(n))); }});
  arrival.add({substituted, "QAGS", tolerances(), [=](double e) { return answer(qags(over_u, 0, 1, e)); }});
}

inline Quantity arrival(const Given<double>& bead, const Reference& truth) {
  Quantity time = quantity("arrival", "s", "time from release to the origin",
                           truth("03_07_arrival", {bead.q0, bead.g}), {});
  time.need = {4e-10 * time.reference.value[0], "nine decimals of the book's case"};
  add_integrals(time, bead);
  add_event<ode::RungeKutta4>(time, regular, EnergyInU<double>{bead});
  add_event<ode::Fehlberg78>(time, regular, EnergyInU<double>{bead});
  add_events(time, one, OneCoordinate<double>{bead});
  add_event<ode::Fehlberg78>(time, cartesian, CartesianWithConstraints<double>{bead});
  add_event<ode::Fehlberg78>(time, stuck, EnergyInQ<double>{bead}, Outcome::raised,
                             "q = q0 for ever solves it too, and that is the solution taken");
  time.add(
      Breakdown{"The time's integrand is infinite at the release, and bisection goes there until it "
                "divides by zero. In u, with q = q0 (1 - u^2), it is smooth: 16 points give twelve digits.",
                raw + ", QAG", 1e-10, Outcome::non_finite, substituted + ", Gauss-Legendre", 16});
  time.add(Breakdown{
      "Energy alone, q' = -sqrt(...), lets a bead at rest stay at rest: the event never comes. In u "
      "the same level is regular at the release, and the bead leaves.",
      stuck + ", " + fehlberg, 1e-12, Outcome::raised, regular + ", " + fehlberg, 1e-12});
  return time;
}

/// The position from the energy integral over u: Brent's method on a Gauss rule.
inline Answer by_inverted_integral(const EnergyInU<double>& bead, const Horizon& horizon, int points) {
  return observe_at_times(horizon, [&](double t, Answer& answer) {
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
  });
}

inline Quantity slide(const Given<double>& bead, const Horizon& horizon, const Reference& truth) {
  Quantity position = quantity("slide", "m", "position at " + times_up_to(horizon),
                               trajectory(truth, "03_07_slide", {bead.q0, bead.g}, horizon), {});
  position.need = {1e-7 * size_of(position.reference.value), "a ten-millionth of the farthest coordinate"};
  Ladder(position, horizon, halving("step", 0.125, 9), tolerances())
      .closed_form("straight tangent", StraightTangent<double>{bead}, Outcome::inaccurate,
                   "the curve bends away")
      .by<ode::Fehlberg78>(stuck, EnergyInQ<double>{bead}, Outcome::inaccurate, "the bead never moves")
      .by_few(regular, EnergyInU<double>{bead})
      .by_common(one, OneCoordinate<double>{bead})
      .by_others(one, OneCoordinate<double>{bead},
                 {{"linearly implicit Euler", Outcome::inaccurate,
                   "its order is too low for this need at this step"}})
      .by_common(cartesian, CartesianWithConstraints<double>{bead});
  position.add({substituted, "Gauss-Legendre, inverted by Brent", doubling("points", 4, 6), [=](double n) {
                  return by_inverted_integral(EnergyInU<double>{bead}, horizon, static_cast<int>(n));
                }});
  position.add(
      Breakdown{"Energy alone, q' = -sqrt(...), lets a bead at rest stay at rest; the second-order "
                "equation does not.",
                stuck + ", " + fehlberg, 1e-12, Outcome::inaccurate, one + ", " + fehlberg, 1e-12});
  return position;
}

// ---- the book's run ---------------------------------------------------------------------------------------

inline constexpr double book_step = 0.001;
inline constexpr int book_steps = 2500;

/// The states (q, q') of the book's run.
inline std::vector<OneCoordinate<double>::State> book_run() {
  const OneCoordinate<double> bead{{1, 1}};
  std::vector<OneCoordinate<double>::State> run{bead.start()};
  double t = 0;
  for (int i = 0; i < book_steps; ++i) {
    auto state = run.back();
    listed_step(bead, state, t, book_step);
    run.push_back(state);
  }
  return run;
}

/// The states at t = 1, 2, ..., 1000, the run gone on with.
inline std::vector<OneCoordinate<double>::State> long_run() {
  const OneCoordinate<double> bead{{1, 1}};
  return ode::integrate<ode::DormandPrince54>(bead, bead.start(), Horizon{1000, 1000}.times(), 1e-10).value;
}

}  // namespace oddity::bead_on_cubic
