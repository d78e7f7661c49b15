#include <boost/numeric/odeint/stepper/adams_bashforth.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta4.hpp>
#include <boost/version.hpp>
#include <cmath>

#include "report/verify/catch.hpp"
#include "tests/libraries/shown.hpp"

TEST_CASE("Odeint's Adams-Bashforth keeps its history when its step changes", "[libraries]") {
  namespace odeint = boost::numeric::odeint;
  using State = std::array<double, 2>;
  using Stepper = odeint::adams_bashforth<4, State, double, State, double, odeint::array_algebra,
                                          odeint::default_operations, odeint::initially_resizer,
                                          odeint::runge_kutta4<State>>;
  const Shown shown{"odeint_adams_bashforth_new_step", BOOST_LIB_VERSION};
  const auto error = [](int n, bool anew) {  // one second in n steps, and one in 2 n
    Stepper stepper;
    State x{1, 0};
    double t = 0;
    for (double h : {1.0 / n, 0.5 / n}) {
      if (anew) stepper.reset();
      for (const double end = t + 1; t < end - h / 2; t += h)
        stepper.do_step([](const State& y, State& dydt, double) { dydt = {y[1], -y[0]}; }, x, t, h);
    }
    return std::hypot(x[0] - std::cos(2), x[1] + std::sin(2));
  };
  const double order = std::log2(error(80, false) / error(160, false));
  shown.check("four steps have order 2", std::abs(order - 2) < 0.05, order);
  CHECK(std::abs(std::log2(error(80, true) / error(160, true)) - 4) < 0.2);
}
