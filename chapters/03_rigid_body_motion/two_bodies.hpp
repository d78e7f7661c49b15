#pragma once

// The models of exercise 3.27.

#include <complex>
#include <numbers>

#include "chapters/03_rigid_body_motion/kepler.hpp"
#include "chapters/scene.hpp"
#include "chapters/stops.hpp"
#include "solvers/ode/events.hpp"

namespace oddity::two_bodies {

struct Bodies {
  double G, m1, m2, r0, r0_dot, phi0, phi0_dot;

  std::vector<double> inputs() const { return {G, m1, m2, r0, r0_dot, phi0, phi0_dot}; }
  /// The second body seen from the first: one body about a fixed sun of the mass of both.
  kepler::Start relative() const { return {G, m1 + m2, r0, r0_dot, phi0, phi0_dot}; }
};

/// (r, u, phi), as published. What is conserved is the energy per reduced mass; beta cannot drift.
struct Published : Bodies {
  using State = std::array<double, 3>;
  State start() const { return {r0, r0_dot, phi0}; }
  double beta() const { return r0 * r0 * phi0_dot; }
  double gamma() const { return G * (m1 + m2); }
  void operator()(const State& x, State& dxdt, double) const {
    const double r2 = x[0] * x[0];
    dxdt = {x[1], beta() * beta() / (r2 * x[0]) - gamma() / r2, beta() / r2};
  }
  std::array<double, 2> observe(const State& x, double) const {
    return {x[0] * std::cos(x[2]), x[0] * std::sin(x[2])};
  }
  OneConserved conserved(const State& x, double) const {
    return energy_of(x[1] * x[1] / 2 + beta() * beta() / (2 * x[0] * x[0]), -gamma() / x[0]);
  }
};

/// (x1, y1, x2, y2 and their rates), the centre of mass at rest in the origin.
struct BothBodies : Bodies {
  using State = std::array<double, 8>;
  using Half = std::array<double, 4>;
  State start() const {
    const auto p = relative().position(), v = relative().velocity();
    const double a = -m2 / (m1 + m2), b = m1 / (m1 + m2);
    return {a * p[0], a * p[1], b * p[0], b * p[1], a * v[0], a * v[1], b * v[0], b * v[1]};
  }
  void acceleration(const Half& q, Half& a) const {
    const double dx = q[2] - q[0], dy = q[3] - q[1], square = dx * dx + dy * dy;
    const double pull = G / (square * std::sqrt(square));
    a = {m2 * pull * dx, m2 * pull * dy, -m1 * pull * dx, -m1 * pull * dy};
  }
  void operator()(const State& x, State& dxdt, double) const {
    Half a{};
    acceleration({x[0], x[1], x[2], x[3]}, a);
    dxdt = {x[4], x[5], x[6], x[7], a[0], a[1], a[2], a[3]};
  }
  std::array<double, 2> observe(const State& x, double) const { return {x[2] - x[0], x[3] - x[1]}; }
  /// The energy and the angular momentum about the centre of mass.
  std::array<Conserved, 2> conserved(const State& x, double) const {
    const double kinetic = (m1 * (x[4] * x[4] + x[5] * x[5]) + m2 * (x[6] * x[6] + x[7] * x[7])) / 2;
    const double turning = m1 * (x[0] * x[5] - x[1] * x[4]) + m2 * (x[2] * x[7] - x[3] * x[6]);
    const double most = m1 * std::hypot(x[0], x[1]) * std::hypot(x[4], x[5]) +
                        m2 * std::hypot(x[2], x[3]) * std::hypot(x[6], x[7]);
    return {{{kinetic - G * m1 * m2 / std::hypot(x[2] - x[0], x[3] - x[1]), kinetic}, {turning, most}}};
  }
};

/// x + i y = w^2 and dt = r ds turn the relative motion into w'' = (E/2) w, E the energy per reduced mass
/// [Levi-Civita 1920]: nothing is singular at r = 0. The state is (w, w', t).
struct LeviCivita {
  using State = std::array<double, 5>;
  double half_energy;

  void operator()(const State& x, State& dxdt, double) const {
    dxdt = {x[2], x[3], half_energy * x[0], half_energy * x[1], x[0] * x[0] + x[1] * x[1]};
  }
};

/// By Kepler's equation at every stop. Throws std::domain_error when the orbit is no ellipse.
inline Answer by_kepler(const kepler::Start& start, const Horizon& horizon) {
  const kepler::Ellipse orbit(start);
  Answer answer;
  std::vector<double> seen;
  std::array<double, 2> now{};
  const auto solve = [&](double, double t) {
    const double M = orbit.mean_anomaly(t);
    const auto E = kepler::newton(orbit.e, std::abs(M), std::numbers::pi, 50);
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

/// Equal steps of s up to each stop; the last part's length by Newton's method, dt/ds being r, kept inside
/// the step that passes the stop.
inline Answer by_levi_civita(const kepler::Start& start, const Horizon& horizon, double step) {
  const LeviCivita model{start.energy() / 2};
  const auto p = start.position(), v = start.velocity();
  const auto w = std::sqrt(std::complex(p[0], p[1])), rate = std::conj(w) * std::complex(v[0], v[1]) / 2.0;
  LeviCivita::State x{w.real(), w.imag(), rate.real(), rate.imag(), 0};
  Answer answer;
  std::vector<double> seen;
  const auto advance = [&](double s) {
    const auto part = ode::integrate<ode::RungeKutta4>(model, x, 0, s, s);
    answer.evaluations += part.evaluations;
    return part.value;
  };
  const auto fail = [&](Ending ending, const char* message) {
    answer.ending = ending;
    answer.message = message;
    return false;
  };
  const auto go_on = [&](double, double stop) {
    auto next = advance(step);
    while (next[4] < stop) {
      if (answer.evaluations > ode::budget)
        return fail(Ending::stalled, "the budget of evaluations is spent");
      x = next;
      next = advance(step);
    }
    if (!ode::finite(next)) return fail(Ending::non_finite, "the state is not finite");
    double least = 0, most = step, s = step * (stop - x[4]) / (next[4] - x[4]);
    for (int newton = 0; newton < 60; ++newton) {
      next = advance(s);
      const double late = next[4] - stop;
      if (std::abs(late) <= 1e-15 * stop) {
        x = next;
        return true;
      }
      (late < 0 ? least : most) = s;
      s -= late / (next[0] * next[0] + next[1] * next[1]);
      if (!(s > least && s < most)) s = (least + most) / 2;
    }
    return fail(Ending::stalled, "the time of the stop is not met");
  };
  through_times(horizon, go_on, [&](double) {
    seen.push_back(x[0] * x[0] - x[1] * x[1]);
    seen.push_back(2 * x[0] * x[1]);
  });
  answer.value = Value(std::move(seen));
  return answer;
}

}  // namespace oddity::two_bodies
