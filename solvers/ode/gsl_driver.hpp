#pragma once

#include <memory>
#include <string_view>

#include "solvers/ode/counted_problem.hpp"

namespace oddity::ode {

namespace detail {

enum class GslStep { rk8pd, msadams, msbdf, bsimp };

/// GSL's step, step control and evolution, behind raw pointers.
class GslDriver {
 public:
  GslDriver(GslStep, std::size_t n, double tolerance, double first_step);
  ~GslDriver();
  GslDriver(GslDriver&&) noexcept;

  /// Makes one accepted step from t, not beyond t1. Returns the error's message, or null.
  const char* advance(const RawProblem&, double* x, double& t, double t1);
  /// Makes one step of h without step control; x is not finite if it fails.
  void plain_step(const RawProblem&, double* x, double t, double h);

 private:
  struct Driver;
  std::unique_ptr<Driver> driver_;
};

/// An algorithm of GSL under GSL's own driver. GSL integrates through a NaN, as its step control treats it as
/// zero error. Here a derivative that is not finite fails the step, and GSL halves it.
template <GslStep step>
struct Gsl {
  static constexpr Kind kind = Kind::self_stepping;
  static constexpr double first_step = 1e-3;  ///< fraction of the whole span
  template <class State, class System>
  static auto stepper(const System& system, long& evaluations, double tolerance, double first) {
    return Driven<GslDriver, System, State>{{system, evaluations},
                                            GslDriver(step, std::tuple_size_v<State>, tolerance, first)};
  }
};

/// An algorithm of GSL without its step control.
template <class State, GslStep step>
struct PlainGsl {
  template <class System>
  void do_step(const System& system, State& x, double t, double h) {
    const CountedProblem<System, State> problem{system, evaluations};
    driver.plain_step(problem.view(), x.data(), t, h);
  }
  long evaluations = 0;
  GslDriver driver{step, std::tuple_size_v<State>, 1, 1};
};

}  // namespace detail

}  // namespace oddity::ode
