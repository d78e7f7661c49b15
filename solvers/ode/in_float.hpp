#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string_view>

#include "solvers/ode/integrate.hpp"

/// The explicit algorithms of fixed step in float, as games compute. Each is compiled once for each number of
/// unknowns, as in double. Algorithms with a tolerance, implicit ones and those of GSL and SUNDIALS are in
/// double only.
namespace oddity::ode {

template <std::size_t n>
using IntegrateInFloat = Trajectory<std::array<float, n>>(const AnySystem<n, float>& system,
                                                          const std::array<float, n>& start,
                                                          std::span<const double> times, double step);

/// The algorithm of this name in float; null if it is in double only.
template <std::size_t n>
IntegrateInFloat<n>* in_float(std::string_view algorithm);

}  // namespace oddity::ode
