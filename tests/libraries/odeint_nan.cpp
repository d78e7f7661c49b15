#include <boost/numeric/odeint/integrate/integrate_adaptive.hpp>
#include <boost/numeric/odeint/stepper/bulirsch_stoer.hpp>
#include <boost/numeric/odeint/stepper/controlled_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/generation.hpp>
#include <boost/version.hpp>
#include <cmath>

#include "report/verify/catch.hpp"
#include "tests/libraries/shown.hpp"

TEST_CASE("Odeint's controlled steps take NaN for no error", "[libraries]") {
  namespace odeint = boost::numeric::odeint;
  using State = std::array<double, 1>;
  const Shown shown{"odeint_nan", BOOST_LIB_VERSION};
  const auto end = [](auto stepper) {
    State x{1};
    odeint::integrate_adaptive(
        stepper, [](const State& y, State& dydt, double) { dydt[0] = y[0] * y[0]; }, x, 0.0, 2.0, 0.01);
    return x[0];
  };
  const std::string words = "returns normally, with NaN";
  for (double x : {end(odeint::make_controlled(1e-6, 1e-6, odeint::runge_kutta_cash_karp54<State>())),
                   end(odeint::make_controlled(1e-6, 1e-6, odeint::runge_kutta_dopri5<State>())),
                   end(odeint::make_controlled(1e-6, 1e-6, odeint::runge_kutta_fehlberg78<State>())),
                   end(odeint::bulirsch_stoer<State>(1e-6, 1e-6))})
    shown.check(words, std::isnan(x), x);
}
