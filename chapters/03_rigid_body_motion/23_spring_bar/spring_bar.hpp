#pragma once

// The quantities of exercise 3.23.

#include <cmath>
#include <numbers>
#include <string>

#include "chapters/03_rigid_body_motion/23_spring_bar/models.hpp"
#include "chapters/03_rigid_body_motion/shared/lagrangian.hpp"
#include "chapters/scene.hpp"
#include "solvers/counted_calls.hpp"
#include "solvers/differences.hpp"
#include "solvers/ode/events.hpp"

namespace oddity::spring_bar {

inline Known true_swing(const Given<double>& b, const Horizon& horizon, const Reference& truth) {
  return trajectory(truth, "03_23_swing", {b.m, b.r, b.s, b.c, b.h, b.g, b.ell, b.theta0, b.w0}, horizon);
}

inline Quantity swing(const Given<double>& bar, const Horizon& horizon, const Reference& truth) {
  Quantity mass = quantity("swing", "m", "position of the mass at four times",
                           true_swing(bar, horizon, truth), {1e-6, "a micrometre"});
  Ladder(mass, horizon, halving("step", 0.125, 10), tolerances())
      .closed_form("small oscillation", SmallOscillation<double>{bar}, Outcome::inaccurate,
                   "the frequency depends on the amplitude, and the spring is softer above than below")
      .by_common("one angle", OneAngle<double>{bar}, Outcome::drifted)
      .by_others("one angle", OneAngle<double>{bar},
                 {{"linearly implicit Euler", Outcome::drifted, "of order 1, and it damps every swing"}})
      .by_common("Cartesian with constraint", CartesianWithConstraint<double>{bar}, Outcome::drifted);
  return mass;
}

inline Quantity stiff_swing(const Given<double>& bar, const Reference& truth) {
  const Horizon horizon{1};
  Quantity mass = quantity("stiff", "m", "position after 0.25, 0.5, 0.75 and 1 s on a stiff spring",
                           true_swing(bar, horizon, truth), {1e-6, "a micrometre"});
  const std::string one = "one angle", damps = "stable at every step, but it takes the swing's energy away";
  Ladder(mass, horizon, halving("step", 0.0625, 11), tolerances(2, 10))
      .by<ode::ExplicitEuler>(one, OneAngle<double>{bar}, Outcome::drifted, "it gains energy at every step")
      .by<ode::VelocityVerlet>(one, OneAngle<double>{bar}, Outcome::inaccurate,
                               "its order is too low for this need at this step")
      .by<ode::RungeKutta4>(one, OneAngle<double>{bar})
      .by<ode::Fehlberg78>(one, OneAngle<double>{bar})
      .by<ode::ImplicitEuler>(one, OneAngle<double>{bar}, Outcome::drifted, damps)
      .by<ode::Rosenbrock4>(one, OneAngle<double>{bar});
  return mass;
}

/// A whole period of the swing that passes theta = 0 with the speed w amplitude.
inline Answer frequency_by_events(Given<double> bar, double amplitude) {
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

inline Quantity small_frequency(const Given<double>& bar, const Reference& truth) {
  Quantity w = quantity("frequency", "rad/s", "angular frequency of small oscillations about theta = 0",
                        truth("03_23_frequency", {bar.m, bar.r, bar.s, bar.c, bar.h, bar.g, bar.ell}),
                        {1e-6 * bar.frequency(), "a millionth of it"});
  const auto of = [bar](double curvature) { return std::sqrt(curvature / (bar.m * bar.r * bar.r)); };
  const auto V = [bar](const auto& q) { return bar.potential(q); };
  const auto slope = [V](double q) { return derivative(V, q); };
  w.add({"curvature of V", "nested dual numbers", no_knob(), [=](double) {
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

}  // namespace oddity::spring_bar
