#pragma once

#include <string_view>

#include "solvers/ode/facts.hpp"
#include "solvers/ode/gsl_driver.hpp"

namespace oddity::ode {

/// Bader and Deuflhard's extrapolation of the linearly implicit midpoint rule: for stiff problems to high
/// accuracy. Each step takes a Jacobian and the time derivative: by dual numbers (n + 1 evaluations) if the
/// system is Differentiable, else by central differences (2 n + 2).
struct Bsimp : detail::Gsl<detail::GslStep::bsimp> {
  static constexpr std::string_view name = "GSL bsimp";
  static constexpr int order = 12;
  static constexpr Facts facts{.library = Facts::gsl, .jacobian = true};
  /// The method without its step control.
  template <class State>
  using Plain = detail::PlainGsl<State, detail::GslStep::bsimp>;
};

}  // namespace oddity::ode
