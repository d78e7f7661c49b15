#pragma once

#include <array>
#include <functional>
#include <limits>
#include <span>
#include <string_view>
#include <vector>

#include "solvers/ode/integrate.hpp"

/// Motions with events: the states at the requested times, and the times at which a guard falls through zero.
///
///   const bouncing_ball::Ball<double> ball{{1, 9.81, 0.7}};  // has guards() and at_event().
///   const auto motion = integrate_with_events<RungeKutta4>(ball, ball.start(), times, 0.01);
///   for (const auto& event : motion.events) std::cout << event.time << "\n";
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
using Keep = std::unique_ptr<const AnySystem<n>>(const AnySystem<n>&, double setting);

template <std::size_t n>
Solved<Event<std::array<double, n>>> find_event(
    const AnySystem<n>& system, Keep<n>& keep, Integrate<n>& integrate, Step<n>& step,
    const std::array<double, n>& start, double t0, double t1, double setting,
    const std::function<double(const std::array<double, n>&, double)>& g);

}  // namespace detail

/// The first time after t0 and up to t1 at which g(x, t), continuous, becomes zero or changes its sign, and
/// the state there. Each step is sampled inside by its cubic: a double crossing is found if it lasts a
/// quarter of a step. Brent's method then finds the time, on states that the algorithm itself computes from
/// the step's start (by one step of its plain stepper if it has one). The time has their accuracy, without an
/// error estimate. `raised` if g keeps its sign; the value is then t1 and the state there.
template <class Algorithm, class System, std::size_t n, class G>
Solved<Event<std::array<double, n>>> find_event(const System& system, const std::array<double, n>& start,
                                                double t0, double t1, double setting, const G& g) {
  static_assert(is_precompiled<std::array<double, n>>);
  const Adapted<AnySystem<n>, const System&> any(system);
  return detail::find_event<n>(any, with_series_precompiled<Algorithm, n>,
                               integrate_precompiled<Algorithm, n>, step_precompiled<Algorithm, n>, start, t0,
                               t1, setting, g);
}

// ---- a system's own events --------------------------------------------------------------------------------

/// One of a system's guards has fallen through zero at `time`, and the event takes the state from `before` to
/// `after`.
template <class State>
struct Happened {
  std::size_t guard = 0;
  double time = 0;
  State before{}, after{};
};

constexpr std::size_t every_event = std::numeric_limits<std::size_t>::max();

template <class State>
struct MotionWithEvents {
  Trajectory<State> trajectory;
  std::vector<Happened<State>> events = {};
};

/// The states at `times`, which go forward, by the algorithm of this name. When a guard falls through zero
/// the system's event happens, and the algorithm restarts without its history. If the motion ends, its state
/// stays the same at all later times. Events are found as by find_event. A guard that is zero at the start
/// counts as above it, as does one whose event does not pass: if it then falls, it happens again at once.
/// After an event that passes, the guard has to rise before it can fall again. A system without guards moves
/// as by `integrate`. `watch` is called after each step, and for the part of a step that ends in an event.
///
/// `chattering`: 16 events for each guard in a row, in which the time moves by no more than 64 of its
/// roundings. Floating point cannot separate their times any more, and no step leads beyond them. The flights
/// of a ball that comes to rest shrink geometrically, and the rest of their sum is of that size. The state
/// and the last event are those of the end. A model that puts the state back onto the guard exactly gets
/// there to all digits. If the state is off by d, the last flights have height d.
///
/// `grazing`: inside a step, the guard has a minimum closer to zero than the step's own error of it. This
/// error is the tolerance, or else the difference between one step and two of half the size. The algorithm
/// cannot decide then whether the event happens, and the rest of the motion depends on it.
template <std::size_t n>
MotionWithEvents<std::array<double, n>> integrate_with_events(std::string_view algorithm,
                                                              const AnySystem<n>& system,
                                                              const std::array<double, n>& start,
                                                              std::span<const double> times, double setting,
                                                              const Watch<n>& watch = {},
                                                              std::size_t most_events = every_event);

template <class Algorithm, class System, std::size_t n>
MotionWithEvents<std::array<double, n>> integrate_with_events(const System& system,
                                                              const std::array<double, n>& start,
                                                              std::span<const double> times, double setting,
                                                              std::size_t most_events = every_event) {
  const Adapted<AnySystem<n>, const System&> any(system);
  return integrate_with_events<n>(info<Algorithm>().name, any, start, times, setting, {}, most_events);
}

/// The first event after t0 and up to t1; `raised` if none happens, with t1 and the state there.
template <class Algorithm, class System, std::size_t n>
Solved<Happened<std::array<double, n>>> first_event(const System& system, const std::array<double, n>& start,
                                                    double t0, double t1, double setting) {
  const std::array times{t0, t1};
  const auto motion = integrate_with_events<Algorithm>(system, start, times, setting, 1);
  const auto& end = motion.trajectory;
  Solved<Happened<std::array<double, n>>> first{{}, end.evaluations};
  if (!motion.events.empty()) {
    first.value = motion.events[0];
  } else {
    if (end.reached()) first.value = {0, t1, end.value.back(), end.value.back()};
    first.ending = end.reached() ? Ending::raised : end.ending;
    first.message = end.reached() ? "the event does not happen in the time given" : end.message;
  }
  return first;
}

}  // namespace oddity::ode
