#pragma once

#include <memory>
#include <string_view>

#include "solvers/ode/counted_problem.hpp"

namespace oddity::ode {

namespace detail {

enum class SundialsMethod { adams, bdf, zonneveld, verner };

/// CVODE and ARKODE's ERKStep, behind raw pointers.
class SundialsDriver {
 public:
  SundialsDriver(SundialsMethod, std::size_t n, double tolerance);
  ~SundialsDriver();
  SundialsDriver(SundialsDriver&&) noexcept;

  /// Makes one accepted step from t, not beyond t1. Returns the error's message, or null.
  const char* advance(const RawProblem&, double* x, double& t, double t1);
  /// Makes one step of h of an ARKODE method without step control; x is not finite if it fails.
  void plain_step(const RawProblem&, double* x, double t, double h);

 private:
  struct Driver;
  std::unique_ptr<Driver> driver_;
};

/// An algorithm of SUNDIALS under its own driver, which also chooses the first step.
template <SundialsMethod method>
struct Sundials {
  static constexpr Kind kind = Kind::self_stepping;
  static constexpr double first_step = 0;
  template <class State, class System>
  static auto stepper(const System& system, long& evaluations, double tolerance, double) {
    return Driven<SundialsDriver, System, State>{{system, evaluations},
                                                 SundialsDriver(method, std::tuple_size_v<State>, tolerance)};
  }
};

/// A driver's method without its step control.
template <class State, SundialsMethod method>
struct PlainSundials {
  template <class System>
  void do_step(const System& system, State& x, double t, double h) {
    const CountedProblem<System, State> problem{system, evaluations};
    driver.plain_step(problem.view(), x.data(), t, h);
  }
  long evaluations = 0;
  SundialsDriver driver{method, std::tuple_size_v<State>, 1};
};

}  // namespace detail

}  // namespace oddity::ode
