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

#define ODDITY_PRECOMPILE_FOR(n, Algorithm)                                                          \
  template Trajectory<std::array<double, n>> integrate_precompiled<Algorithm, n>(                    \
      const AnySystem<n>&, const std::array<double, n>&, std::span<const double>, double, const Watch<n>&);
#define ODDITY_PRECOMPILE(Algorithm) ODDITY_FOR_UNKNOWNS(ODDITY_PRECOMPILE_FOR, Algorithm)

}  // namespace oddity::ode
