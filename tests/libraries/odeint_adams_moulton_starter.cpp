#include <boost/numeric/odeint/stepper/adams_bashforth_moulton.hpp>
#include <boost/version.hpp>
#include <cmath>

#include "report/verify/catch.hpp"
#include "tests/libraries/shown.hpp"

TEST_CASE("Odeint's Adams-Bashforth-Moulton has its starter's order", "[libraries]") {
  using State = std::array<double, 2>;
  const Shown shown{"odeint_adams_moulton_starter", BOOST_LIB_VERSION};
  const auto error = [](auto stepper, int n) {
    State x{1, 0};
    double worst = 0;
    for (int i = 0; i < n; ++i) {
      const double h = 5.0 / n, t = i * h;
      stepper.do_step([](const State& y, State& dydt, double) { dydt = {y[1], -y[0]}; }, x, t, h);
      worst = std::max(worst, std::hypot(x[0] - std::cos(t + h), x[1] + std::sin(t + h)));
    }
    return worst;
  };
  const auto check = [&](auto stepper) {
    const double order = std::log2(error(stepper, 40) / error(stepper, 80));
    shown.check("order 5 to six steps and to eight", std::abs(order - 5) < 0.2, order);
  };
  check(boost::numeric::odeint::adams_bashforth_moulton<6, State>());
  check(boost::numeric::odeint::adams_bashforth_moulton<8, State>());
}
