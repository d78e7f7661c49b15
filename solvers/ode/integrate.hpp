#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <span>
#include <string_view>
#include <type_traits>
#include <vector>

#include "solvers/ode/any_system.hpp"
#include "solvers/ode/unknowns.hpp"
#include "solvers/solved.hpp"

/// Initial value problems over Boost.Odeint, GSL and SUNDIALS. States are std::array<double, N>; a system is
/// called as system(x, dxdt, t). A partitioned system has x = (q, v) with q' = v and also offers
/// system.acceleration(q, a): forces that depend on positions alone.
///
/// An algorithm is a type of this folder. Its `setting` is a step (fixed, partitioned) or a tolerance,
/// absolute and relative (controlled, self-stepping). Time may run backward. No algorithm hangs or returns
/// NaN as a success. A state that is not finite ends `non_finite`. A step too small to move the time, or a
/// spent budget, ends `stalled`.
///
///   const auto swing = [](const auto& x, auto& dxdt, const auto&) { dxdt = {x[1], -x[0]}; };
///   const std::array times{0.0, 1.0, 2.0};
///
///   const auto path = integrate<RungeKutta4>(swing, std::array{1.0, 0.0}, times, 0.01);
///   if (path.reached()) std::cout << path.value.back()[0];  // cos(2)
namespace oddity::ode {

/// A velocities-first algorithm steps the velocities, and then the other unknowns. A self-stepping one has
/// its own driver, which chooses its steps and repeats those that fail.
enum class Kind {
  fixed,
  partitioned,
  velocities_first,
  controlled,
  implicit_fixed,
  implicit_controlled,
  self_stepping
};

/// Its stepper is constructed with the system, because it needs more than the rates.
constexpr bool holds_system(Kind kind) {
  return kind == Kind::partitioned || kind == Kind::velocities_first || kind == Kind::implicit_fixed;
}

/// The setting is a tolerance, not a step.
constexpr bool has_tolerance(Kind kind) {
  return kind == Kind::controlled || kind == Kind::implicit_controlled || kind == Kind::self_stepping;
}

/// The most evaluations of the right-hand side that one integration may take. An EvaluationLimit lowers it on
/// its thread while it lives.
constexpr long budget = 20'000'000;
inline thread_local long most_evaluations = budget;

class EvaluationLimit {
 public:
  explicit EvaluationLimit(double most) : before_(most_evaluations) {
    if (most < static_cast<double>(before_)) most_evaluations = static_cast<long>(most);
  }
  EvaluationLimit(const EvaluationLimit&) = delete;
  EvaluationLimit& operator=(const EvaluationLimit&) = delete;
  ~EvaluationLimit() { most_evaluations = before_; }

 private:
  long before_;
};

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

/// A reference to a function like NeverStop of any type; or none.
template <std::size_t n>
class Watch {
 public:
  using State = std::array<double, n>;

  Watch() = default;
  template <class OnStep>
  explicit Watch(const OnStep& on_step)
      : object_(&on_step),
        call_([](const void* object, double t0, const State& x0, double t1, const State& x1) {
          return (*static_cast<const OnStep*>(object))(t0, x0, t1, x1);
        }) {}

  bool operator()(double t0, const State& x0, double t1, const State& x1) const {
    return call_ && call_(object_, t0, x0, t1, x1);
  }

 private:
  const void* object_ = nullptr;
  bool (*call_)(const void*, double, const State&, double, const State&) = nullptr;
};

/// Every algorithm is compiled once for each number of unknowns that a model has, in the solvers' own files,
/// and sees a system as AnySystem. A caller needs only its declaration (algorithms.hpp). CMake reads the
/// numbers from the declarations `using State = std::array<T, 4>` of the chapters.
template <class State>
inline constexpr bool is_precompiled = false;
#define ODDITY_IS_PRECOMPILED(n, value) \
  template <>                           \
  inline constexpr bool is_precompiled<std::array<double, n>> = value;
ODDITY_FOR_UNKNOWNS(ODDITY_IS_PRECOMPILED, true)
#undef ODDITY_IS_PRECOMPILED

template <class Algorithm, std::size_t n>
Trajectory<std::array<double, n>> integrate_precompiled(const AnySystem<n>& system,
                                                        const std::array<double, n>& start,
                                                        std::span<const double> times, double setting,
                                                        const Watch<n>& watch);

/// Makes one step of h, by the algorithm's plain stepper if it has one; false if it did not reach t + h.
template <class Algorithm, std::size_t n>
bool step_precompiled(const AnySystem<n>& system, std::array<double, n>& x, double t, double h,
                      double setting, long& evaluations);

/// The system with its series, so that states inside a step need no new expansion; null: the algorithm has no
/// series.
template <class Algorithm, std::size_t n>
std::unique_ptr<const AnySystem<n>> with_series_precompiled(const AnySystem<n>& system, double setting);

/// Like `integrate`, with system and algorithm always compiled into one: for the innermost loop of a game.
template <class Algorithm, class System, class State, class OnStep = NeverStop>
Trajectory<State> integrate_inlined(const System& system, const State& start, std::span<const double> times,
                                    double setting, const OnStep& on_step = {});

/// Facts of an algorithm for callers that do not see its type.
struct AlgorithmInfo {
  std::string_view name;
  Kind kind;
  bool by_series = false;      ///< uses series of an analytic system: a state inside a step needs no new one
  bool blind_to_time = false;  ///< see Facts
};
template <class Algorithm>
AlgorithmInfo info();

/// The states at `times`, which may go back and forth; the first is the time of `start`. The value ends with
/// the last state reached. Throws std::logic_error for a partitioned algorithm on a system that is not
/// partitioned.
template <class Algorithm, class System, class State, class OnStep = NeverStop>
Trajectory<State> integrate(const System& system, const State& start, std::span<const double> times,
                            double setting, const OnStep& on_step = {}) {
  if constexpr (is_precompiled<State>) {
    constexpr std::size_t n = std::tuple_size_v<State>;
    const Adapted<AnySystem<n>, const System&> any(system);
    if constexpr (std::is_same_v<OnStep, NeverStop>)
      return integrate_precompiled<Algorithm, n>(any, start, times, setting, Watch<n>());
    else
      return integrate_precompiled<Algorithm, n>(any, start, times, setting, Watch<n>(on_step));
  } else {
    return integrate_inlined<Algorithm>(system, start, times, setting, on_step);
  }
}

template <std::size_t n>
using Integrate = Trajectory<std::array<double, n>>(const AnySystem<n>& system,
                                                    const std::array<double, n>& start,
                                                    std::span<const double> times, double setting,
                                                    const Watch<n>& watch);

/// The algorithm of this name. Throws std::logic_error if there is no such algorithm.
template <std::size_t n>
Integrate<n>& precompiled(std::string_view algorithm);

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
