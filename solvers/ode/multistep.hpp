#pragma once

#include <cmath>
#include <complex>
#include <vector>

namespace oddity::ode {

/// What a multistep method makes of y' = lambda y, z = h lambda: y[n+1] = c[0] y[n] + c[1] y[n-1] + ...
using Recurrence = std::vector<std::complex<double>>;

namespace detail {

/// An Odeint multistep method whose history starts anew when the step changes: Odeint would go on as if the
/// past steps had been as long as this one. A step that differs by rounding alone is the same.
template <class Multistep>
struct Restarting {
  Multistep multistep;
  double last = 0;

  template <class System, class State>
  void do_step(const System& system, State& x, double t, double h) {
    if (std::abs(h - last) > 1e-10 * std::abs(h)) {
      multistep.reset();
      last = h;
    }
    multistep.do_step(std::cref(system), x, t, h);
  }
};

}  // namespace detail

}  // namespace oddity::ode
