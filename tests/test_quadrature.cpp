// The quadrature rules one by one: exactness, order, and integrands with a closed form. P_n is the Legendre
// polynomial: its integral over [-1, 1] is zero for n > 0. A rule of degree d integrates P_d to zero, and
// P_(d+1) to another value.

#include <numbers>

#include "report/study/fit.hpp"
#include "report/verify/catch.hpp"
#include "tests/near.hpp"
#include "tests/quadrature_rules.hpp"

using namespace oddity;
using namespace rules;
using std::numbers::e;

namespace {

auto legendre(int n) {
  return [n](double x) { return std::legendre(static_cast<unsigned>(n), x); };
}

}  // namespace

// ---- exactness and order ----------------------------------------------------------------------------------

TEST_CASE("Gauss-Legendre with n points is exact to degree 2n-1 and no further", "[solvers]") {
  for (int n : {1, 2, 3, 5, 8, 10, 16, 20, 32, 37, 48, 64, 100, 150}) {
    INFO(n << " points");
    for (int degree = 1; degree < 2 * n; degree += std::max(1, n / 8))
      CHECK(near(gauss_legendre(legendre(degree), -1, 1, n).value, 0, 1e-14));
    CHECK(std::abs(gauss_legendre(legendre(2 * n), -1, 1, n).value) > 1e-3);
    CHECK(gauss_legendre(legendre(2), -1, 1, n).evaluations == n);
  }
}

TEST_CASE("Gauss-Legendre keeps all digits at sizes for which GSL has no table", "[solvers]") {
  for (int n = 10; n <= 200; ++n) {
    INFO(n << " points");
    CHECK(near_ulps(gauss_legendre(exponential, 0, 1, n).value, e - 1, 16));
  }
  CHECK(near_ulps(gauss_legendre(exponential, 0, 1, 1001).value, e - 1, 64));
}

TEST_CASE("Gauss-Legendre's error on x^(2n) agrees with theory", "[solvers]") {
  // Over [0, 1]: (n!)^4 / ((2n+1) ((2n)!)^2) [Abramowitz, Stegun 25.4.30].
  for (int n = 1; n <= 5; ++n) {
    const double error =
        std::pow(std::tgamma(n + 1), 4) / ((2 * n + 1) * std::pow(std::tgamma(2 * n + 1), 2));
    const auto power = [n](double x) { return std::pow(x, 2 * n); };
    CHECK(near(1.0 / (2 * n + 1) - gauss_legendre(power, 0, 1, n).value, error, 1e-15));
  }
}

TEST_CASE("Simpson's rule is exact to degree 3 and the trapezoid rule to degree 1, no further", "[solvers]") {
  const auto power = [](int n) { return [n](double x) { return std::pow(x, n); }; };
  for (int n = 0; n <= 3; ++n) CHECK(near_ulps(simpson(power(n), 0, 1, 2).value, 1.0 / (n + 1), 1));
  CHECK(near_ulps(simpson(power(4), 0, 1, 2).value, 1.0 / 5 + 1.0 / 120, 1));
  for (int n = 0; n <= 1; ++n) CHECK(near_ulps(trapezoid(power(n), 0, 1, 1).value, 1.0 / (n + 1), 1));
  CHECK(near_ulps(trapezoid(power(2), 0, 1, 1).value, 1.0 / 3 + 1.0 / 6, 1));
}

TEST_CASE("one application of Gauss-Kronrod's 21 points is exact to degree 31 and no further", "[solvers]") {
  // The slope makes the estimate relative to it, so that QAG accepts its first application.
  const auto once = [](int degree) {
    return qag([p = legendre(degree)](double x) { return p(x) + 1000 * x; }, -1, 1, infinity);
  };
  for (int degree = 1; degree <= 31; ++degree) CHECK(near(once(degree).value, 0, 1e-12));
  CHECK(std::abs(once(32).value) > 1e-3);
  CHECK(once(32).evaluations == 21);
}

TEST_CASE("the trapezoid rule has order 2 and Simpson's order 4, with panels + 1 evaluations", "[solvers]") {
  std::vector<double> steps, trapezoid_errors, simpson_errors;
  for (int panels : {8, 16, 32, 64}) {
    const Integral second = trapezoid(exponential, 0, 1, panels), fourth = simpson(exponential, 0, 1, panels);
    CHECK(second.evaluations == panels + 1);
    CHECK(fourth.evaluations == panels + 1);
    steps.push_back(1.0 / panels);
    trapezoid_errors.push_back(std::abs(second.value - (e - 1)));
    simpson_errors.push_back(std::abs(fourth.value - (e - 1)));
  }
  CHECK(near(power_law(steps, trapezoid_errors).exponent, 2, 0.01));
  CHECK(near(power_law(steps, simpson_errors).exponent, 4, 0.01));
}

TEST_CASE("an integral changes its sign with its direction, and is zero over an empty interval",
          "[solvers]") {
  for (const auto& [name, run] : adaptive()) {
    INFO(name);
    CHECK(run(exponential, 1, 1, 1e-10).value == 0);
    if (name == "QAGP") continue;  // its points ascend
    CHECK(run(exponential, 1, 0, 1e-10).value == -run(exponential, 0, 1, 1e-10).value);
  }
  CHECK(near_ulps(simpson(exponential, 1, 0, 8).value, -simpson(exponential, 0, 1, 8).value, 4));
  CHECK(near_ulps(gauss_legendre(exponential, 1, 0, 8).value, 1 - e, 4));
}

// ---- closed forms -----------------------------------------------------------------------------------------

TEST_CASE("a smooth integrand costs one application of an adaptive rule", "[solvers]") {
  for (const auto& [name, run] : adaptive()) {
    INFO(name);
    const Integral integral = run(exponential, 0, 1, 1e-10);
    CHECK(integral.reached());
    CHECK(near_ulps(integral.value, e - 1, 2));
    CHECK(integral.evaluations == (name == "CQUAD" ? 33 : 21));
    CHECK(integral.error_estimate < 1e-13);
  }
}

TEST_CASE("QAGS extrapolates singular ends: 231 evaluations at any tolerance", "[solvers]") {
  for (double tolerance : {1e-7, 1e-10, 1e-13}) {
    const Integral root = qags(inverse_root, 0, 1, tolerance), log = qags(logarithm, 0, 1, tolerance);
    CHECK(root.reached());
    CHECK(near(root.value, 2, 4e-15));
    CHECK(root.evaluations == 231);
    CHECK(log.reached());
    CHECK(near(log.value, -1, 1e-15));
    CHECK(log.evaluations == 231);
  }
}

TEST_CASE("QAG and CQUAD bisect a singular end, at ten times the cost", "[solvers]") {
  for (auto rule : {qag, cquad}) {
    const Integral integral = rule(inverse_root, 0, 1, 1e-10);
    CHECK(integral.reached());
    CHECK(near(integral.value, 2, 2e-10));
    CHECK(within(static_cast<double>(integral.evaluations), 1000, 3000));
  }
}

TEST_CASE("QAGP needs no search if the point of a kink or a logarithm is given", "[solvers]") {
  const auto kink = [](double x) { return std::abs(x - 0.3); };
  const auto log = [](double x) { return std::log(std::abs(x - 0.3)); };
  const double kink_area = (0.3 * 0.3 + 0.7 * 0.7) / 2;
  const double log_area = 0.3 * std::log(0.3) + 0.7 * std::log(0.7) - 1;

  const Integral known_kink = qagp(kink, {0, 0.3, 1}, 1e-10);
  CHECK(near_ulps(known_kink.value, kink_area, 2));
  CHECK(known_kink.evaluations == 42);
  CHECK(qags(kink, 0, 1, 1e-10).evaluations == 357);

  const Integral known_log = qagp(log, {0, 0.3, 1}, 1e-10);
  CHECK(near_ulps(known_log.value, log_area, 8));
  CHECK(known_log.evaluations == 462);
}

TEST_CASE("an oscillating integrand costs evaluations and keeps its digits", "[solvers]") {
  const auto wave = [](double x) { return std::cos(100 * x); };
  for (const auto& [name, run] : adaptive()) {
    INFO(name);
    const Integral integral = run(wave, 0, 1, 1e-12);
    CHECK(integral.reached());
    CHECK(near(integral.value, std::sin(100.0) / 100, 1e-15));
    CHECK(within(static_cast<double>(integral.evaluations), 400, 2000));
  }
}
