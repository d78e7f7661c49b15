#include <boost/numeric/odeint/integrate/integrate_adaptive.hpp>
#include <boost/numeric/odeint/stepper/controlled_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/generation.hpp>
#include <boost/version.hpp>
#include <cmath>

#include "report/verify/catch.hpp"
#include "tests/libraries/shown.hpp"

TEST_CASE("Odeint's Fehlberg 7(8) sees no error where the right-hand side depends only on time",
          "[libraries]") {
  namespace odeint = boost::numeric::odeint;
  using State = std::array<double, 1>;
  const Shown shown{"odeint_fehlberg78", BOOST_LIB_VERSION};
  const auto error = [](double tolerance) {
    State x{0};
    odeint::integrate_adaptive(
        odeint::make_controlled(tolerance, tolerance, odeint::runge_kutta_fehlberg78<State>()),
        [](const State&, State& dxdt, double t) { dxdt[0] = std::cos(t); }, x, 0.0, 10.0, 0.01);
    return std::abs(x[0] - std::sin(10));
  };
  const std::string words = "errs by more than 1e-5 at every tolerance from 0.01 to 1e-12, the same";
  for (double tolerance : {1e-2, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12})
    shown.check(words, error(tolerance) > 1e-5 && error(tolerance) == error(1e-2), error(tolerance));
}
