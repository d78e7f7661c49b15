#pragma once

#include <stdexcept>

#include "solvers/ode/integrate_inlined.hpp"

namespace oddity::ode {

template <class Algorithm, std::size_t n>
Trajectory<std::array<double, n>> integrate_precompiled(const AnySystem<n>& system,
                                                        const std::array<double, n>& start,
                                                        std::span<const double> times, double setting,
                                                        const Watch<n>& watch) {
  if constexpr (Algorithm::kind == Kind::partitioned && n % 2 == 1)
    throw std::logic_error("an odd number of unknowns cannot be partitioned");
  else
    return integrate_inlined<Algorithm>(system, start, times, setting, watch);
}

template <class Algorithm, std::size_t n>
bool step_precompiled(const AnySystem<n>& system, std::array<double, n>& x, double t, double h,
                      double setting, long& evaluations) {
  using State = std::array<double, n>;
  const detail::Counted<AnySystem<n>, State> counted{system, evaluations};
  if constexpr (Algorithm::kind == Kind::fixed) {
    Algorithm::template stepper<State>().do_step(counted, x, t, h);
  } else if constexpr (holds_system(Algorithm::kind)) {
    Algorithm::template stepper<State>(system, evaluations)(x, t, h);
  } else if constexpr (requires { typename Algorithm::template Plain<State>; }) {
    typename Algorithm::template Plain<State>().do_step(counted, x, t, h);
  } else {
    const std::array times{t, t + h};
    const auto part = integrate_precompiled<Algorithm, n>(system, x, times, setting, {});
    evaluations += part.evaluations;
    x = part.value.back();
    return part.reached();
  }
  return true;
}

template <class Algorithm>
concept by_series = requires {
  typename Algorithm::template WithSeries<2>;
};

template <class Algorithm, std::size_t n>
std::unique_ptr<const AnySystem<n>> with_series_precompiled([[maybe_unused]] const AnySystem<n>& system,
                                                            [[maybe_unused]] double setting) {
  if constexpr (by_series<Algorithm>)
    return std::make_unique<const typename Algorithm::template WithSeries<n>>(system, setting);
  else
    return nullptr;
}

template <class Algorithm>
AlgorithmInfo info() {
  return {Algorithm::name, Algorithm::kind, by_series<Algorithm>, Algorithm::facts.blind_to_time};
}

#define ODDITY_PRECOMPILE_FOR(n, Algorithm)                                                                 \
  template Trajectory<std::array<double, n>> integrate_precompiled<Algorithm, n>(                           \
      const AnySystem<n>&, const std::array<double, n>&, std::span<const double>, double, const Watch<n>&); \
  template bool step_precompiled<Algorithm, n>(const AnySystem<n>&, std::array<double, n>&, double, double, \
                                               double, long&);                                              \
  template std::unique_ptr<const AnySystem<n>> with_series_precompiled<Algorithm, n>(const AnySystem<n>&,   \
                                                                                     double);
#define ODDITY_PRECOMPILE(Algorithm)                    \
  ODDITY_FOR_UNKNOWNS(ODDITY_PRECOMPILE_FOR, Algorithm) \
  template AlgorithmInfo info<Algorithm>();

}  // namespace oddity::ode
