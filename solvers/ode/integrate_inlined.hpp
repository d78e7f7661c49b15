#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <string>
#include <type_traits>
#include <utility>

#include "solvers/ode/integrate.hpp"
#include "solvers/ode/steps_in.hpp"
#include "solvers/stop.hpp"

/// The loop that drives every algorithm through the times, compiled into its caller.
namespace oddity::ode {

namespace detail {

/// The message `what`, with the time.
std::string at_time(const char* what, double t);

template <class State>
bool fail(Trajectory<State>& solved, Ending ending, const char* what, double t) {
  solved.ending = ending;
  solved.message = at_time(what, t);
  return false;
}

template <class State>
bool check_budget(long evaluations, Trajectory<State>& solved, double t) {
  check_stop_at_times();
  return evaluations <= most_evaluations ||
         fail(solved, Ending::stalled, "the budget of evaluations is spent", t);
}

/// Type of the time in a right-hand side: float if the state is in float.
template <class State>
using TimeOf = std::conditional_t<std::is_same_v<typename State::value_type, float>, float, double>;

/// Steppers that can be copied with all their memory: these are kept in registers, and their steps can be
/// repeated.
template <class DoStep>
constexpr bool copied = std::is_copy_assignable_v<DoStep>;

/// Makes steps first to last of size h. A separate function, so that the code around its loop takes no
/// registers.
template <class DoStep, class State>
[[gnu::noinline]] void steps_in_registers(DoStep& do_step, State& x, double t0, double h, long first,
                                          long last) {
  using Time = TimeOf<State>;
  std::conditional_t<copied<DoStep>, DoStep, DoStep&> step = do_step;
  State now = x;
  for (long i = first; i < last; ++i)
    step(now, static_cast<Time>(t0 + static_cast<double>(i) * h), static_cast<Time>(h));
  x = now;
  if constexpr (copied<DoStep>) do_step = step;
}

/// Makes steps of equal size from t0 to t1, no longer than `step`; false if the integration is over. The
/// state is stepped in a local copy, which the compiler can keep in registers. Counts steps and computes
/// their times in double: a state in float sees time and step rounded to float, and its time does not drift.
/// Checks the state after every 16 steps. Copyable steppers make 256 at once; if these end in a state that is
/// not finite, or beyond the budget, they are repeated by 16.
template <class DoStep, class State, class OnStep>
[[gnu::always_inline]] inline bool equal_steps(DoStep& do_step, State& x, double t0, double t1, double step,
                                               long& evaluations, Trajectory<State>& solved,
                                               const OnStep& on_step) {
  const double count = steps_in(t0, t1, step);
  if (!(count <= static_cast<double>(most_evaluations)))
    return fail(solved, Ending::stalled, "the step would take more steps than the budget allows", t0);
  const auto n = static_cast<long>(count);
  using Time = TimeOf<State>;
  const double h = (t1 - t0) / count;
  const auto time_of = [=](long i) { return i == n ? t1 : t0 + static_cast<double>(i) * h; };
  State now = x;
  bool by_many = copied<DoStep> && std::is_same_v<OnStep, NeverStop>;
  for (long i = 0; i < n;) {
    if constexpr (copied<DoStep> && std::is_same_v<OnStep, NeverStop>) {
      if (by_many) {
        const long end = std::min(i + 256, n), evaluations_before = evaluations;
        const DoStep step_before = do_step;
        State after = now;
        steps_in_registers(do_step, after, t0, h, i, end);
        by_many = finite(after) && evaluations <= most_evaluations;
        if (by_many)
          now = after, i = end;
        else
          evaluations = evaluations_before, do_step = step_before;
        continue;
      }
    }
    const long end = std::min(i + 16, n);
    if constexpr (std::is_same_v<OnStep, NeverStop>) {
      steps_in_registers(do_step, now, t0, h, i, end);
      i = end;
    } else {
      for (; i < end; ++i) {
        const State before = now;
        do_step(now, static_cast<Time>(time_of(i)), static_cast<Time>(h));
        if (on_step(time_of(i), before, time_of(i + 1), now)) return x = now, false;
      }
    }
    if (!check_budget(evaluations, solved, time_of(i))) return x = now, false;
    if (!finite(now)) return x = now, fail(solved, Ending::non_finite, "the state is not finite", time_of(i));
  }
  x = now;
  return true;
}

/// Makes steps chosen by the stepper's error control from t to t1. `h` is the step to try; its size carries
/// over from call to call.
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
    if (from + tried == from) return fail(solved, Ending::stalled, "the step became too small", t);
    if (!try_step(x, t, tried)) {
      h = tried;
      if (++rejected > 500) return fail(solved, Ending::stalled, "500 rejected steps", t);
      if (!check_budget(evaluations, solved, t)) return false;
      continue;
    }
    rejected = 0;
    if (last) t = t1;
    h = last && std::abs(h) > std::abs(tried) ? h : tried;
    if (!check_budget(evaluations, solved, t)) return false;
    if (!finite(x)) return fail(solved, Ending::non_finite, "the state is not finite", t);
    if (on_step(from, before, t, x)) return false;
  }
  return true;
}

/// Makes steps chosen by a library's driver from t to t1. advance(x, t, t1) makes one of them, not beyond t1,
/// and returns the error's message, or null.
template <class Advance, class State, class OnStep>
bool driven_steps(Advance& advance, State& x, double t, double t1, const long& evaluations,
                  Trajectory<State>& solved, const OnStep& on_step) {
  while (t != t1) {
    const State before = x;
    const double from = t;
    const char* error = advance(x, t, t1);
    if (error) x = before, t = from;
    if (!check_budget(evaluations, solved, t)) return false;
    if (!finite(x)) return fail(solved, Ending::non_finite, "the state is not finite", t);
    if (!error && t == from) error = "the step became too small";
    if (error) return fail(solved, Ending::stalled, error, t);
    if (on_step(from, before, t, x)) return false;
  }
  return true;
}

/// The first step that a controlled algorithm tries: a part of the whole span, but enough to move the time.
double first_step(std::span<const double> times, double part);

/// Message for invalid times, step or tolerance; null if all are valid.
const char* invalid_arguments(std::span<const double> times, double setting);

/// A system whose evaluations are counted.
template <class System, class State>
struct Counted {
  const System& system;
  long& evaluations;

  void operator()(const State& x, State& dxdt, TimeOf<State> t) const {
    ++evaluations;
    system(x, dxdt, t);
  }
};

/// A step of an algorithm without memory.
template <class Algorithm, class System>
struct StepAlone {
  const System* system;

  template <class State, class Time>
  void operator()(State& x, Time t, Time h) const {
    Algorithm::template stepper<State>().do_step(*system, x, t, h);
  }
};

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

template <class Algorithm, class System, class State, class OnStep>
Trajectory<State> integrate_inlined(const System& system, const State& start, std::span<const double> times,
                                    double setting, const OnStep& on_step) {
  Trajectory<State> solved;
  if (const char* what = detail::invalid_arguments(times, setting)) {
    solved.ending = Ending::raised;
    solved.message = what;
    return solved;
  }
  long evaluations = 0;  // a local, as it stays in a register
  const detail::Counted<System, State> counted{system, evaluations};
  if constexpr (Algorithm::kind == Kind::fixed) {
    const auto by = [&](auto& do_step) {
      detail::through(
          times, start, solved, [&](State & x, double t0, double t1) __attribute__((always_inline)) {
            return detail::equal_steps(do_step, x, t0, t1, setting, evaluations, solved, on_step);
          });
    };
    if constexpr (requires { &Algorithm::recurrence; }) {  // a multistep method
      auto stepper = Algorithm::template stepper<State>();
      auto do_step = [&](State& x, auto t, auto h) { stepper.do_step(counted, x, t, h); };
      by(do_step);
    } else {
      detail::StepAlone<Algorithm, detail::Counted<System, State>> do_step{&counted};
      by(do_step);
    }
  } else if constexpr (holds_system(Algorithm::kind)) {
    auto stepper = Algorithm::template stepper<State>(system, evaluations);
    detail::through(
        times, start, solved, [&](State & x, double t0, double t1) __attribute__((always_inline)) {
          return detail::equal_steps(stepper, x, t0, t1, setting, evaluations, solved, on_step);
        });
  } else if constexpr (Algorithm::kind == Kind::self_stepping) {
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

}  // namespace oddity::ode
