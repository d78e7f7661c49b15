#pragma once

#include <string_view>

#include "solvers/ode/facts.hpp"
#include "solvers/ode/sundials_driver.hpp"

namespace oddity::ode {

/// SUNDIALS's backward differentiation of variable step and order 1 to 5, its corrector solved by Newton
/// iterations: for stiff problems. Takes a Jacobian now and then: by dual numbers (n evaluations) if the
/// system is Differentiable, else by central differences (2 n).
struct CvodeBdf : detail::Sundials<detail::SundialsMethod::bdf> {
  static constexpr std::string_view name = "CVODE BDF";
  static constexpr Facts facts{.library = Facts::sundials, .jacobian = true, .history = true};
};

}  // namespace oddity::ode
