#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "solvers/solved.hpp"

/// Initial value problems over Boost.Odeint, GSL and SUNDIALS. States are std::array<double, N>; a system is
/// called as system(x, dxdt, t). A partitioned system has x = (q, v) with q' = v and also offers
/// system.acceleration(q, a): forces that depend on positions alone.
///
/// An algorithm is a type of this folder. Its `setting` is a step (fixed, partitioned) or a tolerance,
/// absolute and relative (controlled, driven). Time may run backward. No algorithm hangs or returns NaN as a
/// success: a state that is not finite ends `non_finite`, a step too small to move the time or a spent budget
/// ends `stalled`.
namespace oddity::ode {

/// A driven algorithm is a library's own driver, which chooses its steps and repeats those that fail.
enum class Kind { fixed, partitioned, controlled, implicit_fixed, implicit_controlled, driven };

/// The setting is a tolerance, not a step.
constexpr bool has_tolerance(Kind kind) {
  return kind == Kind::controlled || kind == Kind::implicit_controlled || kind == Kind::driven;
}

/// Most evaluations of the right-hand side that one integration may take.
constexpr long budget = 20'000'000;

template <class State>
bool finite(const State& x) {
  double sum = 0;
  for (double component : x) sum += component * 0.0;
  return sum == 0.0;
}

/// States at the given times.
template <class State>
using Trajectory = Solved<std::vector<State>>;

/// Called after each step with its two ends; true ends the integration there.
struct NeverStop {
  template <class State>
  bool operator()(double, const State&, double, const State&) const {
    return false;
  }
};

namespace detail {

template <class State>
bool fail(Trajectory<State>& solved, Ending ending, std::string message) {
  solved.ending = ending;
  solved.message = std::move(message);
  return false;
}

inline std::string at(double t) { return "at t = " + std::to_string(t); }

template <class State>
bool check_budget(long evaluations, Trajectory<State>& solved, double t) {
  return evaluations <= budget ||
         fail(solved, Ending::stalled, "the budget of evaluations is spent " + at(t));
}

/// Steps of equal size from t0 to t1, no longer than `step`; false when the integration is over. The state is
/// stepped in a local copy, which the compiler can keep in registers.
template <class DoStep, class State, class OnStep>
[[gnu::always_inline]] inline bool equal_steps(DoStep& do_step, State& x, double t0, double t1, double step,
                                               const long& evaluations, Trajectory<State>& solved,
                                               const OnStep& on_step) {
  const double count = std::max(1.0, std::ceil(std::abs(t1 - t0) / step * (1 - 1e-12)));
  if (!(count <= static_cast<double>(budget)))
    return fail(solved, Ending::stalled, "the step would take more steps than the budget allows");
  const auto n = static_cast<long>(count);
  const double h = (t1 - t0) / count;
  const auto time_of = [=](long i) { return i == n ? t1 : t0 + static_cast<double>(i) * h; };
  State now = x;
  for (long i = 0; i < n;) {
    for (const long end = std::min(i + 16, n); i < end; ++i) {
      if constexpr (std::is_same_v<OnStep, NeverStop>) {
        do_step(now, t0 + static_cast<double>(i) * h, h);
      } else {
        const State before = now;
        do_step(now, time_of(i), h);
        if (on_step(time_of(i), before, time_of(i + 1), now)) return x = now, false;
      }
    }
    if (!finite(now))
      return x = now, fail(solved, Ending::non_finite, "the state is not finite " + at(time_of(i)));
    if (!check_budget(evaluations, solved, time_of(i))) return x = now, false;
  }
  x = now;
  return true;
}

/// Steps chosen by the stepper's error control from t to t1; `h` is the step to try, its size goes on from
/// call to call.
template <class TryStep, class State, class OnStep>
bool controlled_steps(TryStep& try_step, State& x, double t, double t1, double& h, const long& evaluations,
                      Trajectory<State>& solved, const OnStep& on_step) {
  int rejected = 0;
  h = std::copysign(h, t1 - t);
  while (t != t1) {
    const bool last = std::abs(h) >= std::abs(t1 - t);
    double tried = last ? t1 - t : h;
    const State before = x;
    const double from = t;
    if (from + tried == from) return fail(solved, Ending::stalled, "the step became too small " + at(t));
    if (!try_step(x, t, tried)) {
      h = tried;
      if (++rejected > 500) return fail(solved, Ending::stalled, "500 rejected steps " + at(t));
      if (!check_budget(evaluations, solved, t)) return false;
      continue;
    }
    rejected = 0;
    if (last) t = t1;
    h = last && std::abs(h) > std::abs(tried) ? h : tried;
    if (!finite(x)) return fail(solved, Ending::non_finite, "the state is not finite " + at(t));
    if (on_step(from, before, t, x)) return false;
    if (!check_budget(evaluations, solved, t)) return false;
  }
  return true;
}

/// Steps that a library's driver chooses, from t to t1: advance(x, t, t1) makes one of them, not beyond t1,
/// and says what went wrong, or null.
template <class Advance, class State, class OnStep>
bool driven_steps(Advance& advance, State& x, double t, double t1, const long& evaluations,
                  Trajectory<State>& solved, const OnStep& on_step) {
  while (t != t1) {
    const State before = x;
    const double from = t;
    const char* trouble = advance(x, t, t1);
    if (trouble) x = before, t = from;
    if (!check_budget(evaluations, solved, t)) return false;
    if (!finite(x)) return fail(solved, Ending::non_finite, "the state is not finite " + at(t));
    if (!trouble && t == from) trouble = "the step became too small";
    if (trouble) return fail(solved, Ending::stalled, trouble + (" " + at(t)));
    if (on_step(from, before, t, x)) return false;
  }
  return true;
}

/// The step that a controlled algorithm tries first: a part of the whole span, but enough to move the time.
inline double first_step(std::span<const double> times, double part) {
  const auto [low, high] = std::ranges::minmax(times);
  return std::max((high - low) * part, 0x1p-50 * std::max(std::abs(low), std::abs(high)));
}

/// Advances x from times[0] through all of them by advance(x, t0, t1), keeping the states.
template <class State, class Advance>
[[gnu::always_inline]] inline void through(std::span<const double> times, State x, Trajectory<State>& solved,
                                           const Advance& advance) {
  solved.value.push_back(x);
  for (std::size_t i = 1; i < times.size(); ++i) {
    const bool on = times[i] == times[i - 1] || advance(x, times[i - 1], times[i]);
    solved.value.push_back(x);
    if (!on) return;
  }
}

}  // namespace detail

/// The states at `times`, the first of which is the start's; they may go back and forth. The value ends with
/// the last state reached.
template <class Algorithm, class System, class State, class OnStep = NeverStop>
Trajectory<State> integrate(const System& system, const State& start, std::span<const double> times,
                            double setting, const OnStep& on_step = {}) {
  Trajectory<State> solved;
  if (!(setting > 0 && std::isfinite(setting))) {
    detail::fail(solved, Ending::raised, "the step or tolerance must be positive and finite");
    return solved;
  }
  if (times.empty() || !std::ranges::all_of(times, [](double t) { return std::isfinite(t); })) {
    detail::fail(solved, Ending::raised, "there must be times, and they must be finite");
    return solved;
  }
  long evaluations = 0;  // not `solved`'s: a local stays in a register
  const auto counted = [&system, &evaluations](const State& x, State& dxdt, double t) {
    ++evaluations;
    system(x, dxdt, t);
  };
  if constexpr (Algorithm::kind == Kind::fixed) {
    auto stepper = Algorithm::template stepper<State>();
    auto do_step = [&](State& x, double t, double h) { stepper.do_step(counted, x, t, h); };
    detail::through(
        times, start, solved, [&](State & x, double t0, double t1) __attribute__((always_inline)) {
          return detail::equal_steps(do_step, x, t0, t1, setting, evaluations, solved, on_step);
        });
  } else if constexpr (Algorithm::kind == Kind::partitioned || Algorithm::kind == Kind::implicit_fixed) {
    auto stepper = Algorithm::template stepper<State>(system, evaluations);
    detail::through(
        times, start, solved, [&](State & x, double t0, double t1) __attribute__((always_inline)) {
          return detail::equal_steps(stepper, x, t0, t1, setting, evaluations, solved, on_step);
        });
  } else if constexpr (Algorithm::kind == Kind::driven) {
    auto advance = Algorithm::template stepper<State>(system, evaluations, setting,
                                                      detail::first_step(times, Algorithm::first_step));
    detail::through(times, start, solved, [&](State& x, double t0, double t1) {
      return detail::driven_steps(advance, x, t0, t1, evaluations, solved, on_step);
    });
  } else {
    const auto controlled = [&](auto&& try_step) {
      double h = detail::first_step(times, Algorithm::first_step);
      detail::through(times, start, solved, [&](State& x, double t0, double t1) {
        return detail::controlled_steps(try_step, x, t0, t1, h, evaluations, solved, on_step);
      });
    };
    if constexpr (Algorithm::kind == Kind::controlled) {
      auto stepper = Algorithm::template stepper<State>(setting);
      controlled([&](State& x, double& t, double& h) {
        return stepper.try_step(counted, x, t, h) == Algorithm::success;
      });
    } else {
      auto stepper = Algorithm::template stepper<State>(system, evaluations, setting);
      controlled([&](State& x, double& t, double& h) { return stepper(x, t, h); });
    }
  }
  solved.evaluations = evaluations;
  return solved;
}

/// The state at t1 alone.
template <class Algorithm, class System, class State>
Solved<State> integrate(const System& system, const State& start, double t0, double t1, double setting) {
  const std::array times{t0, t1};
  auto trajectory = integrate<Algorithm>(system, start, std::span<const double>(times), setting);
  return {trajectory.value.empty() ? start : trajectory.value.back(),
          trajectory.evaluations,
          trajectory.error_estimate,
          trajectory.drift,
          trajectory.ending,
          trajectory.message};
}

}  // namespace oddity::ode
