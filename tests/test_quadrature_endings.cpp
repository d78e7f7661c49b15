// Endings of the quadrature rules when they fail, and integrands that deceive them.

#include <numbers>

#include "report/verify/catch.hpp"
#include "tests/near.hpp"
#include "tests/quadrature_rules.hpp"

using namespace oddity;
using namespace rules;
using std::numbers::e, std::numbers::pi;

namespace {

/// A normal distribution of width 1e-4 about 0.31416: its integral over [0, 1] is 1.
double spike(double x) {
  const double u = (x - 0.31416) / 1e-4;
  return std::exp(-u * u / 2) / (1e-4 * std::sqrt(2 * pi));
}

}  // namespace

TEST_CASE("an integrand that is NaN, somewhere or everywhere, gives no result", "[solvers]") {
  const auto everywhere = [](double) { return no_number; };
  const auto in_a_part = [](double x) { return std::sqrt(x - 0.3); };
  const auto in_the_middle = [](double x) { return x == 0.5 ? no_number : 1.0; };
  for (const auto& [name, run] : adaptive()) {
    INFO(name);
    CHECK(run(everywhere, 0, 1, 1e-10).ending == Ending::non_finite);
    CHECK(run(in_a_part, 0, 1, 1e-10).ending == Ending::non_finite);
    CHECK_FALSE(run(in_the_middle, 0, 1, 1e-10).reached());
  }
  CHECK(gauss_legendre(in_a_part, 0, 1, 5).ending == Ending::non_finite);
  CHECK(simpson(in_a_part, 0, 1, 4).ending == Ending::non_finite);
  CHECK(trapezoid(in_a_part, 0, 1, 4).ending == Ending::non_finite);
}

TEST_CASE("CQUAD leaves out an end where the integrand is 0/0 or infinite; Simpson's rule does not",
          "[solvers]") {
  const auto sinc = [](double x) { return std::sin(x) / x; };
  const Integral integral = cquad(sinc, 0, pi, 1e-12);
  CHECK(integral.reached());
  CHECK(near(integral.value, 1.8519370519824662, 1e-14));  // Si(pi)
  CHECK(simpson(sinc, 0, pi, 8).ending == Ending::non_finite);
  CHECK(trapezoid(inverse_root, 0, 1, 8).ending == Ending::non_finite);
}

TEST_CASE("a divergent integral gives no result", "[solvers]") {
  const auto square = [](double x) { return 1 / x / x; };
  for (const auto& [name, run] : adaptive()) {
    INFO(name);
    CHECK_FALSE(run(pole, 0, 1, 1e-10).reached());
    CHECK_FALSE(run(pole, -1, 1, 1e-10).reached());
    CHECK_FALSE(run(pole, -1, 2, 1e-10).reached());
    CHECK_FALSE(run(square, 0, 1, 1e-10).reached());
  }
  CHECK(qags(square, 0, 1, 1e-10).ending == Ending::raised);
  CHECK(qag(pole, 0, 1, 1e-10).ending == Ending::stalled);
  CHECK(qag(pole, 0, 1, 1e-10).message.find("exceeded max") != std::string::npos);
}

TEST_CASE("CQUAD has a budget", "[solvers]") {
  const Integral integral = cquad(pole, -1, 2, 1e-10);
  CHECK(integral.ending == Ending::stalled);
  CHECK(integral.message == "the budget of evaluations is spent");
  CHECK(integral.evaluations == 1'000'000);
}

TEST_CASE("CQUAD's success with a useless estimate is a stall, in either direction", "[solvers]") {
  const auto both_ends = [](double x) { return 1 / std::sqrt(1 - x * x); };
  for (const Integral& integral : {cquad(both_ends, -1, 1, 1e-13), cquad(both_ends, 1, -1, 1e-13)}) {
    CHECK(integral.ending == Ending::stalled);
    CHECK(integral.error_estimate > 1e-8);
    CHECK(near(std::abs(integral.value), pi, 1e-7));
  }
}

TEST_CASE("every adaptive rule is deceived by a spike between its first nodes", "[solvers]") {
  for (const auto& [name, run] : adaptive()) {
    INFO(name);
    const Integral integral = run(spike, 0, 1, 1e-10);
    CHECK(integral.reached());
    CHECK(near(integral.value, 0, 1e-12));
    CHECK(integral.evaluations <= 33);
  }
  const Integral told = qagp(spike, {0, 0.3132, 0.31416, 0.3151, 1}, 1e-10);
  CHECK(told.reached());
  CHECK(near(told.value, 1, 1e-10));
}

TEST_CASE("QAGS is deceived in the last digits by two singular ends", "[solvers]") {
  const Integral integral = qags([](double x) { return 1 / std::sqrt(1 - x * x); }, -1, 1, 1e-13);
  CHECK(integral.reached());
  CHECK(integral.error_estimate < std::abs(integral.value - pi));
  CHECK(near(integral.value, pi, 3e-13));
}

TEST_CASE("a tolerance that cannot be met gives no success", "[solvers]") {
  for (const auto& [name, run] : adaptive()) {
    INFO(name);
    for (double tolerance : {0.0, -1.0}) {
      CHECK(run(exponential, 0, 1, tolerance).ending == Ending::raised);
      CHECK(run(exponential, 0, 1, tolerance).evaluations == 0);
    }
    for (double tolerance : {1e-20, 1e-300, no_number}) {
      const Integral integral = run(exponential, 0, 1, tolerance);
      CHECK_FALSE(integral.reached());
      CHECK(near_ulps(integral.value, e - 1, 2));
    }
  }
}

TEST_CASE("limits that are not finite give no result", "[solvers]") {
  for (const auto& [name, run] : adaptive()) {
    INFO(name);
    CHECK_FALSE(run(exponential, 0, infinity, 1e-10).reached());
    CHECK_FALSE(run(exponential, no_number, 1, 1e-10).reached());
  }
  CHECK_FALSE(simpson(exponential, 0, infinity, 8).reached());
  CHECK_FALSE(gauss_legendre(exponential, no_number, 1, 8).reached());
}

TEST_CASE("invalid settings of a rule are refused", "[solvers]") {
  for (int panels : {-2, 0, 1, 3}) CHECK(simpson(exponential, 0, 1, panels).ending == Ending::raised);
  for (int panels : {-1, 0}) CHECK(trapezoid(exponential, 0, 1, panels).ending == Ending::raised);
  for (int points : {-1, 0}) CHECK(gauss_legendre(exponential, 0, 1, points).ending == Ending::raised);
  CHECK(qagp(exponential, {}, 1e-10).ending == Ending::raised);
  CHECK(qagp(exponential, {0}, 1e-10).ending == Ending::raised);
  CHECK(qagp(exponential, {0, 1, 0.5}, 1e-10).ending == Ending::raised);
}

TEST_CASE("an integrand's exception passes through every rule, and the next integral is right", "[solvers]") {
  const auto thrower = [](double x) -> double {
    if (x > 0.7) throw std::domain_error("beyond 0.7");
    return x;
  };
  const auto half = [](double x) { return x; };
  for (const auto& [name, run] : adaptive()) {
    INFO(name);
    CHECK_THROWS_WITH(run(thrower, 0, 1, 1e-10), "beyond 0.7");
    CHECK(near(run(half, 0, 1, 1e-10).value, 0.5, 1e-12));
  }
  long calls = 0;
  const auto pole_then_exception = [&](double x) {
    if (++calls > 1000) throw std::domain_error("enough");
    return 1 / (x - 0.3);
  };
  CHECK_THROWS_WITH(cquad(pole_then_exception, -1, 2, 1e-10), "enough");
  CHECK_THROWS_WITH(gauss_legendre(thrower, 0, 1, 5), "beyond 0.7");
  CHECK_THROWS_WITH(simpson(thrower, 0, 1, 4), "beyond 0.7");
}
