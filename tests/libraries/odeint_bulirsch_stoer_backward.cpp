#include <boost/numeric/odeint/integrate/integrate_adaptive.hpp>
#include <boost/numeric/odeint/stepper/bulirsch_stoer.hpp>
#include <boost/version.hpp>
#include <cmath>

#include "report/verify/catch.hpp"
#include "tests/libraries/shown.hpp"

TEST_CASE("Odeint's Bulirsch-Stoer is expensive backward in time", "[libraries]") {
  namespace odeint = boost::numeric::odeint;
  using State = std::array<double, 2>;
  const Shown shown{"odeint_bulirsch_stoer_backward", BOOST_LIB_VERSION};
  // d/dt (angle, speed), times `direction`: -1 reverses time.
  const auto evaluations = [](double direction, double end) {
    long calls = 0;
    State x{0.5, 0};
    odeint::integrate_adaptive(
        odeint::bulirsch_stoer<State>(1e-12, 1e-12),
        [&](const State& y, State& dydt, double) {
          ++calls;
          dydt = {direction * y[1], direction * -9.81 * std::sin(y[0])};
        },
        x, 0.0, end, end / 100);
    return static_cast<double>(calls);
  };
  const double backward = evaluations(1, -10) / evaluations(1, 10);
  shown.check("takes more than 150 times the evaluations", backward > 150, backward);
  shown.check("10 s of a pendulum at a tolerance of 1e-12", backward > 150, backward);
  CHECK(evaluations(-1, 10) == evaluations(1, 10));
}
