#pragma once

#include <string_view>

#include "solvers/ode/facts.hpp"
#include "solvers/ode/sundials_driver.hpp"

namespace oddity::ode {

/// SUNDIALS's Adams method of variable step and order 1 to 12, in Nordsieck's form, its corrector solved by
/// functional iteration. For smooth problems that are not stiff and expensive to evaluate.
struct CvodeAdams : detail::Sundials<detail::SundialsMethod::adams> {
  static constexpr std::string_view name = "CVODE Adams";
  static constexpr Facts facts{.library = Facts::sundials, .history = true};
};

}  // namespace oddity::ode
