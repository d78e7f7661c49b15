#include <boost/numeric/odeint/integrate/integrate_adaptive.hpp>
#include <boost/numeric/odeint/stepper/generation/generation_runge_kutta_dopri5.hpp>
#include <boost/version.hpp>
#include <cmath>

#include "report/verify/catch.hpp"
#include "tests/libraries/shown.hpp"

TEST_CASE("without one of its headers Odeint's make_controlled is another function", "[libraries]") {
  namespace odeint = boost::numeric::odeint;
  // A state that no other file uses, since with all headers the same function has another definition.
  struct State : std::array<double, 2> {};
  using Stepper = odeint::runge_kutta_dopri5<State, double, State, double, odeint::array_algebra>;
  using Controlled = odeint::controlled_runge_kutta<Stepper>;
  const Shown shown{"odeint_make_controlled", BOOST_LIB_VERSION};
  constexpr double tolerance = 1e-4;
  const auto steps = [](const Controlled& stepper) {
    State x{{0.5, 0}};
    return static_cast<double>(odeint::integrate_adaptive(
        stepper,
        [](const State& y, State& dydt, double) { dydt[0] = y[1], dydt[1] = -9.81 * std::sin(y[0]); }, x, 0.0,
        1.0, 0.01));
  };
  const double made = steps(odeint::make_controlled(tolerance, tolerance, Stepper()));
  const double built = steps(Controlled(Controlled::error_checker_type(tolerance, tolerance),
                                        Controlled::step_adjuster_type(), Stepper()));
  const std::string words = "at 1e-4 takes more than 1000 times the steps";
  shown.check(words, made > 1000 * built, made / built);
  shown.check("takes the relative tolerance for the largest step", std::abs(made * tolerance - 1) < 0.01,
              made);
}
