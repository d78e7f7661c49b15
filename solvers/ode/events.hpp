#pragma once

#include <array>
#include <functional>

#include "solvers/ode/integrate.hpp"

namespace oddity::ode {

template <class State>
struct Event {
  double time = 0;
  State state{};
};

namespace detail {

template <std::size_t n>
using Step = bool(const AnySystem<n>&, std::array<double, n>& x, double t, double h, double setting,
                  long& evaluations);

template <std::size_t n>
Solved<Event<std::array<double, n>>> find_event(
    const AnySystem<n>& system, Integrate<n>& integrate, Step<n>& step, const std::array<double, n>& start,
    double t0, double t1, double setting,
    const std::function<double(const std::array<double, n>&, double)>& g);

}  // namespace detail

/// The first time after t0 and up to t1 at which g(x, t), continuous, becomes zero or changes its sign, and
/// the state there. Each step is sampled inside by its cubic, so that a double crossing is seen when it lasts
/// a quarter of a step; the time is then found by Brent's method on states that the algorithm itself computes
/// from the step's start (by one step of its plain stepper where it has one), and is as good as they are:
/// there is no error estimate. `raised` when g keeps its sign; the value then is t1 and the state there.
template <class Algorithm, class System, std::size_t n, class G>
Solved<Event<std::array<double, n>>> find_event(const System& system, const std::array<double, n>& start,
                                                double t0, double t1, double setting, const G& g) {
  static_assert(is_precompiled<std::array<double, n>>);
  const Adapted<AnySystem<n>, const System&> any(system);
  return detail::find_event<n>(any, integrate_precompiled<Algorithm, n>, step_precompiled<Algorithm, n>,
                               start, t0, t1, setting, g);
}

}  // namespace oddity::ode
