#include <boost/numeric/odeint/stepper/adams_bashforth.hpp>
#include <boost/version.hpp>
#include <cmath>

#include "report/verify/catch.hpp"
#include "tests/libraries/shown.hpp"

TEST_CASE("Odeint's Adams-Bashforth of its default starter has order 1 in place", "[libraries]") {
  using State = std::array<double, 2>;
  const Shown shown{"odeint_adams_bashforth_in_place", BOOST_LIB_VERSION};
  const auto oscillator = [](const State& x, State& dxdt, double) { dxdt = {x[1], -x[0]}; };
  const auto error = [&](double end, int n, bool in_place) {
    boost::numeric::odeint::adams_bashforth<4, State> stepper;
    State x{1, 0};
    const double h = end / n;
    for (int i = 0; i < n; ++i) {
      const State before = x;
      if (in_place)
        stepper.do_step(oscillator, x, i * h, h);
      else
        stepper.do_step(oscillator, before, i * h, x, h);
    }
    return std::hypot(x[0] - std::cos(end), x[1] + std::sin(end));
  };
  const double order = std::log2(error(2, 200, true) / error(2, 400, true));
  shown.check("has order 1 in place", std::abs(order - 1) < 0.05, order);
  CHECK(std::abs(std::log2(error(2, 200, false) / error(2, 400, false)) - 4) < 0.05);
  const double in_place = error(0.1, 1, true), otherwise = error(0.1, 1, false);
  shown.check("by more than 0.1 in place", in_place > 0.1, in_place);
  shown.check("by less than 1e-7 otherwise", otherwise < 1e-7, otherwise);
}
