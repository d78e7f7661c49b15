#pragma once

#include <cmath>
#include <complex>
#include <type_traits>
#include <vector>

namespace oddity::ode {

/// What a multistep method makes of y' = lambda y, z = h lambda: y[n+1] = c[0] y[n] + c[1] y[n-1] + ...
using Recurrence = std::vector<std::complex<double>>;

namespace detail {

/// An Odeint multistep method whose history starts anew when the step changes: Odeint would go on as if the
/// past steps had been as long as this one. A step that differs by rounding alone, of float or of the times
/// in double, is the same.
template <class Multistep>
struct Restarting {
  Multistep multistep;
  double last = 0;

  template <class System, class State, class Time>
  void do_step(const System& system, State& x, Time t, Time h) {
    constexpr double rounding = std::is_same_v<Time, float> ? 0x1p-22 : 1e-10;
    const double step = h;
    if (std::abs(step - last) > rounding * std::abs(step)) {
      multistep.reset();
      last = step;
    }
    multistep.do_step(std::cref(system), x, t, h);
  }
};

}  // namespace detail

}  // namespace oddity::ode
