#pragma once

// The methods of exercise 3.27 that do not take equal steps in time.

#include <array>
#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

#include "chapters/03_rigid_body_motion/03_kepler/kepler.hpp"
#include "chapters/03_rigid_body_motion/27_two_bodies/models.hpp"
#include "chapters/scene.hpp"
#include "chapters/stops.hpp"
#include "solvers/ode/events.hpp"

namespace oddity::two_bodies {

/// x + i y = w^2 and dt = r ds turn the relative motion into w'' = (E/2) w, E the energy per reduced mass
/// [Levi-Civita 1920]: nothing is singular at r = 0. The state is (w, w', t).
struct LeviCivita {
  using State = std::array<double, 5>;
  double half_energy;

  void operator()(const State& x, State& dxdt, double) const {
    dxdt = {x[2], x[3], half_energy * x[0], half_energy * x[1], x[0] * x[0] + x[1] * x[1]};
  }
};

using Bodies = Given<double>;

/// By Kepler's equation at every stop. Throws std::domain_error when the orbit is no ellipse.
inline Answer by_kepler(const kepler::Start& start, const Horizon& horizon) {
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
