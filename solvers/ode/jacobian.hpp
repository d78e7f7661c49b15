#pragma once

#include <array>
#include <concepts>
#include <tuple>

#include "solvers/dual.hpp"

namespace oddity::ode {

/// A system whose right-hand side is generic in its number type, and so can be differentiated exactly. For
/// all others, central differences give the Jacobian (raw_problem.hpp).
template <class System, class State>
concept Differentiable = requires(const System& system,
                                  const std::array<Dual<double>, std::tuple_size_v<State>>& x,
                                  std::array<Dual<double>, std::tuple_size_v<State>>& dxdt, Dual<double> t) {
  system(x, dxdt, t);
};

/// Writes d(dxdt)/dx by rows into `matrix` and, unless it is null, d(dxdt)/dt into `dfdt`, exact to rounding.
/// Returns the number of evaluations: n, or n + 1.
template <class System, class State>
long jacobian(const System& system, const State& x, double* matrix, double* dfdt, double t) {
  constexpr std::size_t n = std::tuple_size_v<State>;
  const std::size_t columns = dfdt ? n + 1 : n;
  for (std::size_t column = 0; column < columns; ++column) {
    std::array<Dual<double>, n> y{}, dydt{};
    for (std::size_t i = 0; i < n; ++i) y[i] = Dual<double>(x[i], i == column ? 1.0 : 0.0);
    system(y, dydt, Dual<double>(t, column == n ? 1.0 : 0.0));
    for (std::size_t i = 0; i < n; ++i) (column == n ? dfdt[i] : matrix[i * n + column]) = dydt[i].slope;
  }
  return static_cast<long>(columns);
}

}  // namespace oddity::ode
