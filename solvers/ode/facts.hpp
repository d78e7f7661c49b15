#pragma once

#include <limits>
#include <string_view>

namespace oddity::ode {

/// Facts that an algorithm's type does not show. The tests measure order, evaluations and limits.
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
  int evaluations = 0;    ///< right-hand sides, or forces, per step; 0: it depends
  bool jacobian = false;  ///< takes a Jacobian, in each step or now and then
  bool history = false;   ///< uses several past steps
  bool in_page = true;    ///< false: left out of the page's module, for the size of its code
  /// Its error estimate is zero for unknowns whose rates depend on time alone, whatever the tolerance.
  bool blind_to_time = false;
  /// The largest h |lambda| at which y' = lambda y does not grow, on the negative real and on the imaginary
  /// axis, by theory; 0: none. Not applicable without a fixed step, or, for partitioned algorithms, to
  /// damping.
  double real_limit = not_applicable, imaginary_limit = not_applicable;
  std::string_view theory = "no fixed step";  ///< source of the limits

  /// Whether the page's module includes it. CMake reads the same facts from the header.
  constexpr bool runs_in_page() const { return in_page && (library == odeint || library == own); }
};

}  // namespace oddity::ode
