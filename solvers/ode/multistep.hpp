#pragma once

#include <cmath>
#include <complex>
#include <type_traits>
#include <vector>

namespace oddity::ode {

/// Recurrence of a multistep method for y' = lambda y, z = h lambda: y[n+1] = c[0] y[n] + c[1] y[n-1] + ...
using Recurrence = std::vector<std::complex<double>>;

namespace detail {

/// An Odeint multistep method that restarts its history when the step changes. Odeint itself would treat the
/// past steps as if they had the new length. Steps that differ by rounding only, of float or of the times in
/// double, count as equal.
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
