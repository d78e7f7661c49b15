#pragma once

#include <string_view>

#include "solvers/ode/facts.hpp"
#include "solvers/ode/gsl_driver.hpp"

namespace oddity::ode {

/// Backward differentiation of variable step and order 1 to 5, its corrector solved by up to three Newton
/// iterations: for stiff problems. Two to four evaluations per step, and now and then a Jacobian and the time
/// derivative. These are by dual numbers (n + 1 evaluations) if the system is Differentiable, else by central
/// differences (2 n + 2).
struct Msbdf : detail::Gsl<detail::GslStep::msbdf> {
  static constexpr std::string_view name = "GSL msbdf";
  static constexpr Facts facts{.library = Facts::gsl, .jacobian = true, .history = true};
};

}  // namespace oddity::ode
