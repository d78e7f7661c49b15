#pragma once

#include <limits>
#include <string_view>

namespace oddity::ode {

/// What an algorithm's type does not say by itself. The tests measure its order, its evaluations and its
/// limits.
struct Facts {
  static constexpr double everywhere = std::numeric_limits<double>::infinity();
  static constexpr double not_applicable = std::numeric_limits<double>::quiet_NaN();
  static constexpr std::string_view odeint = "Boost.Odeint", gsl = "GSL", sundials = "SUNDIALS",
                                    own = "our own";
  static constexpr std::string_view polynomial =
      "roots of |R(z)| = 1, R the stability polynomial of the tableau";
  static constexpr std::string_view trace = "half the trace of the step's matrix is -1";
  static constexpr std::string_view characteristic = "largest root of the characteristic polynomial";

  std::string_view library;
  bool in_float = false;  ///< compiled for states of float too
  int evaluations = 0;    ///< of the right-hand side, or of the forces, a step; 0: it depends
  bool jacobian = false;  ///< and a Jacobian, in each step or now and then
  bool history = false;   ///< it goes on from several steps past
  /// Its error estimate is zero for what changes at a rate of time alone, whatever the tolerance.
  bool blind_to_time = false;
  /// The largest h |lambda| at which y' = lambda y does not grow, on the negative real and on the imaginary
  /// axis, by theory: 0: none. It does not apply without a fixed step, or, partitioned, to damping.
  double real_limit = not_applicable, imaginary_limit = not_applicable;
  std::string_view theory = "no fixed step";  ///< where the limits come from
};

}  // namespace oddity::ode
