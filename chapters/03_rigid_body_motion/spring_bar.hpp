#pragma once

// The models and quantities of exercise 3.23.

#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "chapters/03_rigid_body_motion/lagrangian.hpp"
#include "chapters/scene.hpp"
#include "solvers/differences.hpp"
#include "solvers/ode/events.hpp"

namespace oddity::spring_bar {

/// A bar without mass that turns about the origin, a mass m at the distance r, and at the distance s a spring
/// of constant c and rest length ell that stands on (s, -h). It starts at theta0 with angular speed w0.
struct Bar {
  double m, r, s, c, h, g, ell, theta0, w0;

  /// Twice differentiable in q by dual numbers; built from the positions alone.
  template <class Q>
  Q potential(const Q& q) const {
    using std::cos, std::sin, std::sqrt;
    const Q dx = s * cos(q) - s, dy = s * sin(q) + h;
    const Q stretch = sqrt(dx * dx + dy * dy) - ell;
    return m * g * r * sin(q) + 0.5 * c * stretch * stretch;
  }
  std::array<double, 2> position(double angle) const { return {r * std::cos(angle), r * std::sin(angle)}; }
  /// At theta = 0, where the spring is upright: V'' = c s^2 whatever h, ell and g are.
  double frequency() const { return s / r * std::sqrt(c / m); }
  /// The rest length for which theta = 0 is an equilibrium.
  double balancing_rest_length() const { return h + m * g * r / (c * s); }
};

// ---- the models -------------------------------------------------------------------------------------------

/// The equation linearized about theta = 0.
struct SmallOscillation : Bar {
  std::array<double, 2> at(double t) const {
    const double w = frequency(), middle = -(m * g * r + c * s * (h - ell)) / (c * s * s);
    return position(middle + (theta0 - middle) * std::cos(w * t) + w0 / w * std::sin(w * t));
  }
};

/// (theta, theta').
struct OneAngle : Bar {
  using State = std::array<double, 2>;
  State start() const { return {theta0, w0}; }
  template <class Q>
  Q acceleration_at(const Q& q) const {
    using std::cos, std::sin, std::sqrt;
    const Q dx = s * cos(q) - s, dy = s * sin(q) + h;
    const Q pull = c * (1.0 - ell / sqrt(dx * dx + dy * dy));
    return -(m * g * r * cos(q) + pull * (dy * s * cos(q) - dx * s * sin(q))) / (m * r * r);
  }
  template <class X, class T>
  void operator()(const X& x, X& dxdt, const T&) const {
    dxdt = {x[1], acceleration_at(x[0])};
  }
  void acceleration(const std::array<double, 1>& q, std::array<double, 1>& a) const {
    a = {acceleration_at(q[0])};
  }
  std::array<double, 2> observe(const State& x, double) const { return position(x[0]); }
  OneConserved conserved(const State& x, double) const {
    return energy_of(m * r * r * x[1] * x[1] / 2, potential(x[0]));
  }
};

/// (x, y, x', y') of the mass; the spring's force reaches it through the lever, s/r of it, and the bar holds
/// it by x^2 + y^2 = r^2, twice differentiated.
struct CartesianWithConstraint : Bar {
  using State = std::array<double, 4>;
  State start() const {
    return {r * std::cos(theta0), r * std::sin(theta0), -r * w0 * std::sin(theta0),
            r * w0 * std::cos(theta0)};
  }
  /// Force on the mass over m, without the bar's hold.
  std::array<double, 2> pushed(double x, double y) const {
    const double lever = s / r, dx = lever * x - s, dy = lever * y + h;
    const double pull = -lever * c / m * (1 - ell / std::hypot(dx, dy));
    return {pull * dx, pull * dy - g};
  }
  void operator()(const State& x, State& dxdt, double) const {
    const auto f = pushed(x[0], x[1]);
    const double hold = (x[2] * x[2] + x[3] * x[3] + f[0] * x[0] + f[1] * x[1]) / (x[0] * x[0] + x[1] * x[1]);
    dxdt = {x[2], x[3], f[0] - hold * x[0], f[1] - hold * x[1]};
  }
  std::array<double, 2> observe(const State& x, double) const { return {x[0], x[1]}; }
  OneConserved conserved(const State& x, double) const {
    const double stretch = std::hypot(s / r * x[0] - s, s / r * x[1] + h) - ell;
    return energy_of(m * (x[2] * x[2] + x[3] * x[3]) / 2, m * g * x[1] + c * stretch * stretch / 2);
  }
};

// ---- the quantities ---------------------------------------------------------------------------------------

inline Known true_swing(const Bar& b, const Horizon& horizon, const Reference& truth) {
  return trajectory(truth, "03_23_swing", {b.m, b.r, b.s, b.c, b.h, b.g, b.ell, b.theta0, b.w0}, horizon);
}

inline Quantity swing(const Bar& bar, const Horizon& horizon, const Reference& truth) {
  Quantity mass = quantity("swing", "m", "position of the mass at four times",
                           true_swing(bar, horizon, truth), {1e-6, "a micrometre"});
  Ladder(mass, horizon, halving("step", 0.125, 10), tolerances())
      .closed_form("small oscillation", SmallOscillation{bar}, Outcome::inaccurate,
                   "the frequency depends on the amplitude, and the spring is softer above than below")
      .by_common("one angle", OneAngle{bar}, Outcome::drifted)
      .by_others("one angle", OneAngle{bar},
                 {{"linearly implicit Euler", Outcome::drifted, "of order 1, and it damps every swing"}})
      .by_common("Cartesian with constraint", CartesianWithConstraint{bar}, Outcome::drifted);
  return mass;
}

inline Quantity stiff_swing(const Bar& bar, const Reference& truth) {
  const Horizon horizon{1};
  Quantity mass = quantity("stiff", "m", "position after 0.25, 0.5, 0.75 and 1 s on a stiff spring",
                           true_swing(bar, horizon, truth), {1e-6, "a micrometre"});
  const std::string one = "one angle", damps = "stable at every step, but it takes the swing's energy away";
  Ladder(mass, horizon, halving("step", 0.0625, 11), tolerances(2, 10))
      .by<ode::ExplicitEuler>(one, OneAngle{bar}, Outcome::drifted, "it gains energy at every step")
      .by<ode::VelocityVerlet>(one, OneAngle{bar}, Outcome::inaccurate,
                               "its order is too low for this need at this step")
      .by<ode::RungeKutta4>(one, OneAngle{bar})
      .by<ode::Fehlberg78>(one, OneAngle{bar})
      .by<ode::ImplicitEuler>(one, OneAngle{bar}, Outcome::drifted, damps)
      .by<ode::Rosenbrock4>(one, OneAngle{bar});
  return mass;
}

/// A whole period of the swing that passes theta = 0 with the speed w amplitude.
inline Answer frequency_by_events(Bar bar, double amplitude) {
  bar.w0 = amplitude * bar.frequency();
  const OneAngle one{bar};
  OneAngle::State state{0, bar.w0};
  Answer answer;
  double t = 0;
  for (int half = 0; half < 2; ++half) {
    const auto crossing = ode::find_event<ode::Fehlberg78>(
        one, state, t, t + 5 / bar.frequency(), 1e-13, [](const OneAngle::State& x, double) { return x[0]; });
    answer.evaluations += crossing.evaluations;
    answer.ending = crossing.ending;
    answer.message = crossing.message;
    t = crossing.value.time;
    state = {0, crossing.value.state[1]};
  }
  answer.value = 2 * std::numbers::pi / t;
  return answer;
}

inline Quantity small_frequency(const Bar& bar, const Reference& truth) {
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
           return Answer{of((V(h) - 2 * V(0.0) + V(-h)) / (h * h)), 3};
         }});
  w.add({"slope of V' by dual numbers", "central difference, order 2", halving("step", 0.125, 9),
         [=](double h) {
           return Answer{of(central_difference_2(slope, 0, h).value), 2};
         }});
  w.add({"slope of V' by dual numbers", "central difference, order 4", halving("step", 0.125, 9),
         [=](double h) {
           return Answer{of(central_difference_4(slope, 0, h).value), 4};
         }});
  w.add({"one angle", "Fehlberg 7(8), a period by events", halving("amplitude", 0.125, 9),
         [=](double amplitude) { return frequency_by_events(bar, amplitude); }});
  return w;
}

}  // namespace oddity::spring_bar
