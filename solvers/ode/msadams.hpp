#pragma once

#include <string_view>

#include "solvers/ode/facts.hpp"
#include "solvers/ode/gsl_driver.hpp"

namespace oddity::ode {

/// Adams's method of variable step and order 1 to 12, in Nordsieck's form, its corrector solved by up to
/// three functional iterations. For smooth problems that are not stiff and expensive to evaluate. Two to four
/// evaluations per step.
struct Msadams : detail::Gsl<detail::GslStep::msadams> {
  static constexpr std::string_view name = "GSL msadams";
  static constexpr Facts facts{.library = Facts::gsl, .history = true};
};

}  // namespace oddity::ode
