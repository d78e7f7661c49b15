#pragma once

#include <array>
#include <cmath>
#include <optional>

#include "solvers/ode/integrate.hpp"
#include "solvers/roots.hpp"

namespace oddity::ode {

template <class State>
struct Event {
  double time = 0;
  State state{};
};

namespace detail {

/// The cubic through two states with their derivatives, at the fraction s of the step h between them.
template <class State>
State hermite(const State& x0, const State& d0, const State& x1, const State& d1, double h, double s) {
  const double a = (1 + 2 * s) * (1 - s) * (1 - s), b = s * (1 - s) * (1 - s) * h;
  const double c = s * s * (3 - 2 * s), d = -s * s * (1 - s) * h;
  State x{};
  for (std::size_t i = 0; i < x.size(); ++i) x[i] = a * x0[i] + b * d0[i] + c * x1[i] + d * d1[i];
  return x;
}

}  // namespace detail

/// The first time after t0 and up to t1 at which g(x, t) changes its sign, and the state there. Each step is
/// sampled inside by its cubic, so that a double crossing is seen when it lasts a quarter of a step; the time
/// is then found by Brent's method on states that the algorithm itself computes within the step.
/// `error_estimate` is the width of the last bracket. `raised` when g keeps its sign.
template <class Algorithm, class System, class State, class G>
Solved<Event<State>> find_event(const System& system, const State& start, double t0, double t1,
                                double setting, const G& g) {
  constexpr int samples = 4;
  Solved<Event<State>> event;
  long inside = 0;
  bool found = false;
  double before = g(start, t0);

  const auto refine = [&](double t, const State& x, double a, double b) {
    const auto state_after = [&](double s) {
      if (s == 0) return x;
      const auto part =
          integrate<Algorithm>(system, x, t, t + s, has_tolerance(Algorithm::kind) ? setting : std::abs(s));
      inside += part.evaluations;
      return part.value;
    };
    const auto miss = [&](double s) { return g(state_after(s), t + s); };
    const Solved<double> root = brent(miss, a, b, 4e-16 * (1 + std::abs(t)));
    event.value = {t + root.value, state_after(root.value)};
    event.error_estimate = root.error_estimate;
    event.ending = root.ending;
    event.message = root.message;
  };

  const auto watch = [&](double t, const State& x, double t_next, const State& x_next) {
    const double h = t_next - t;
    State d0{}, d1{};
    system(x, d0, t);
    system(x_next, d1, t_next);
    inside += 2;
    double left = 0;
    for (int k = 1; k <= samples; ++k) {
      const double s = static_cast<double>(k) / samples;
      const State y = k == samples ? x_next : detail::hermite(x, d0, x_next, d1, h, s);
      const double now = g(y, t + s * h);
      if (before * now < 0 || (now == 0 && before != 0)) {
        found = true;
        refine(t, x, left * h, s * h);
        if (!event.reached() && x_next != x) refine(t, x, 0, h);
        return true;
      }
      if (now != 0) before = now;
      left = s;
    }
    return false;
  };

  const std::array times{t0, t1};
  const auto trajectory = integrate<Algorithm>(system, start, std::span<const double>(times), setting, watch);
  event.evaluations = trajectory.evaluations + inside;
  if (found) return event;
  event.ending = trajectory.reached() ? Ending::raised : trajectory.ending;
  event.message = trajectory.reached() ? "the event does not happen in the time given" : trajectory.message;
  return event;
}

}  // namespace oddity::ode
