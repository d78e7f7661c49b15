// The quadrature rules one by one: exactness, order, singular integrands with a closed form, and how each
// ends when it fails. P_n is the Legendre polynomial: its integral over [-1, 1] is zero for n > 0, and a rule
// of degree d integrates P_d to zero and P_(d+1) to something else.

#include <numbers>
#include <string>

#include "solvers/quadrature.hpp"
#include "tests/catch.hpp"
#include "tests/fit.hpp"
#include "tests/near.hpp"

using namespace oddity;
using std::numbers::e, std::numbers::pi;

namespace {

constexpr double no_number = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

auto legendre(int n) {
  return [n](double x) { return std::legendre(static_cast<unsigned>(n), x); };
}

struct Adaptive {
  std::string name;
  std::function<Integral(FunctionOfOne, double a, double b, double tolerance)> run;
};

Integral qagp_of_the_ends(FunctionOfOne f, double a, double b, double tolerance) {
  return qagp(f, {a, b}, tolerance);
}

const std::vector<Adaptive>& adaptive_rules() {
  static const std::vector<Adaptive> rules{
      {"QAG", qag}, {"QAGS", qags}, {"QAGP", qagp_of_the_ends}, {"CQUAD", cquad}};
  return rules;
}

double exponential(double x) { return std::exp(x); }
double inverse_root(double x) { return 1 / std::sqrt(x); }
double logarithm(double x) { return std::log(x); }
double pole(double x) { return 1 / x; }

/// A normal distribution of width 1e-4 about 0.31416: its integral over [0, 1] is 1.
double spike(double x) {
  const double u = (x - 0.31416) / 1e-4;
  return std::exp(-u * u / 2) / (1e-4 * std::sqrt(2 * pi));
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

TEST_CASE("Gauss-Legendre keeps all digits at sizes that GSL has no table for", "[solvers]") {
  for (int n = 10; n <= 200; ++n) {
    INFO(n << " points");
    CHECK(near_ulps(gauss_legendre(exponential, 0, 1, n).value, e - 1, 16));
  }
  CHECK(near_ulps(gauss_legendre(exponential, 0, 1, 1001).value, e - 1, 64));
}

TEST_CASE("Gauss-Legendre's error on x^(2n) is the one of theory", "[solvers]") {
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
  // The slope makes the estimate relative to it, so that QAG accepts whatever its first application gives.
  const auto once = [](int degree) {
    return qag([p = legendre(degree)](double x) { return p(x) + 1000 * x; }, -1, 1, infinity);
  };
  for (int degree = 1; degree <= 31; ++degree) CHECK(near(once(degree).value, 0, 1e-12));
  CHECK(std::abs(once(32).value) > 1e-3);
  CHECK(once(32).evaluations == 21);
}

TEST_CASE("the trapezoid rule has order 2 and Simpson's order 4, by panels + 1 evaluations", "[solvers]") {
  std::vector<double> steps, trapezoid_errors, simpson_errors;
  for (int panels : {8, 16, 32, 64}) {
    const Integral second = trapezoid(exponential, 0, 1, panels), fourth = simpson(exponential, 0, 1, panels);
    CHECK(second.evaluations == panels + 1);
    CHECK(fourth.evaluations == panels + 1);
    steps.push_back(1.0 / panels);
    trapezoid_errors.push_back(std::abs(second.value - (e - 1)));
    simpson_errors.push_back(std::abs(fourth.value - (e - 1)));
  }
  CHECK(near(slope(steps, trapezoid_errors), 2, 0.01));
  CHECK(near(slope(steps, simpson_errors), 4, 0.01));
}

TEST_CASE("an integral changes its sign with its direction, and is zero over nothing", "[solvers]") {
  for (const auto& [name, run] : adaptive_rules()) {
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
  for (const auto& [name, run] : adaptive_rules()) {
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

TEST_CASE("QAGP with the point of a kink or a logarithm given needs no search", "[solvers]") {
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
  for (const auto& [name, run] : adaptive_rules()) {
    INFO(name);
    const Integral integral = run(wave, 0, 1, 1e-12);
    CHECK(integral.reached());
    CHECK(near(integral.value, std::sin(100.0) / 100, 1e-15));
    CHECK(within(static_cast<double>(integral.evaluations), 400, 2000));
  }
}

// ---- nested -----------------------------------------------------------------------------------------------

TEST_CASE("nested rules count every innermost evaluation", "[solvers]") {
  const auto rule = [](int n) {
    return [n](FunctionOfOne f, double a, double b) { return gauss_legendre(f, a, b, n); };
  };
  const auto zero = [](double) { return 0.0; };
  const auto one = [](double) { return 1.0; };
  const auto area = nested(
      rule(5), [](double x, double y) { return x * y; }, 0, 1, zero, one);
  CHECK(near_ulps(area.value, 0.25, 4));
  CHECK(area.evaluations == 25);
  const auto volume = nested(
      rule(4), [](double x, double y, double z) { return x * y * z; }, 0, 1, zero, one,
      [](double, double) { return 0.0; }, [](double, double) { return 1.0; });
  CHECK(near_ulps(volume.value, 0.125, 4));
  CHECK(volume.evaluations == 64);
}

TEST_CASE("a tetrahedron's volume and moments are exact with enough Gauss points, not with fewer",
          "[solvers]") {
  // x, y, z >= 0, x + y + z <= 1: volume 1/6, integral of x y z 1/720 (Dirichlet).
  const auto over_tetrahedron = [](const auto& f, int points) {
    return nested([points](FunctionOfOne g, double a, double b) { return gauss_legendre(g, a, b, points); },
                  f, 0, 1, [](double) { return 0.0; }, [](double x) { return 1 - x; },
                  [](double, double) { return 0.0; }, [](double x, double y) { return 1 - x - y; });
  };
  const auto one = [](double, double, double) { return 1.0; };
  const auto product = [](double x, double y, double z) { return x * y * z; };
  CHECK(near_ulps(over_tetrahedron(one, 2).value, 1.0 / 6, 4));
  CHECK(std::abs(over_tetrahedron(one, 1).value - 1.0 / 6) > 1e-2);
  CHECK(near_ulps(over_tetrahedron(product, 3).value, 1.0 / 720, 8));
  CHECK(std::abs(over_tetrahedron(product, 2).value - 1.0 / 720) > 1e-6);
  CHECK(over_tetrahedron(product, 3).evaluations == 27);
}

TEST_CASE("the volume of the ball by nested QAGS", "[solvers]") {
  const auto root = [](double x) { return std::sqrt(std::max(x, 0.0)); };
  const auto ball = nested(
      [](FunctionOfOne f, double a, double b) { return qags(f, a, b, 1e-9); },
      [](double, double, double) { return 1.0; }, -1, 1, [=](double x) { return -root(1 - x * x); },
      [=](double x) { return root(1 - x * x); }, [=](double x, double y) { return -root(1 - x * x - y * y); },
      [=](double x, double y) { return root(1 - x * x - y * y); });
  CHECK(ball.reached());
  CHECK(near(ball.value, 4 * pi / 3, 1e-8));
  CHECK(ball.evaluations % 21 == 0);
  CHECK(ball.evaluations > 21 * 21 * 21);
}

TEST_CASE("an inner integral that fails makes the outer one fail, and says so", "[solvers]") {
  const auto rule = [](FunctionOfOne f, double a, double b) { return qags(f, a, b, 1e-10); };
  const auto area = nested(
      rule, [](double, double y) { return 1 / y; }, 0, 1, [](double) { return 0.0; },
      [](double) { return 1.0; });
  CHECK_FALSE(area.reached());
  CHECK(area.message.find("inner integral") == 0);
}

// ---- endings ----------------------------------------------------------------------------------------------

TEST_CASE("an integrand that is NaN, somewhere or everywhere, never reaches", "[solvers]") {
  const auto everywhere = [](double) { return no_number; };
  const auto in_a_part = [](double x) { return std::sqrt(x - 0.3); };
  const auto in_the_middle = [](double x) { return x == 0.5 ? no_number : 1.0; };
  for (const auto& [name, run] : adaptive_rules()) {
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

TEST_CASE("a divergent integral is never reached", "[solvers]") {
  const auto square = [](double x) { return 1 / x / x; };
  for (const auto& [name, run] : adaptive_rules()) {
    INFO(name);
    CHECK_FALSE(run(pole, 0, 1, 1e-10).reached());
    CHECK_FALSE(run(pole, -1, 1, 1e-10).reached());
    CHECK_FALSE(run(pole, -1, 2, 1e-10).reached());
    CHECK_FALSE(run(square, 0, 1, 1e-10).reached());
  }
  CHECK(qags(square, 0, 1, 1e-10).ending == Ending::raised);
  CHECK(qag(pole, 0, 1, 1e-10).ending == Ending::stalled);
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
  for (const auto& [name, run] : adaptive_rules()) {
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

TEST_CASE("a tolerance that cannot be met is no success", "[solvers]") {
  for (const auto& [name, run] : adaptive_rules()) {
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

TEST_CASE("limits that are not finite never reach", "[solvers]") {
  for (const auto& [name, run] : adaptive_rules()) {
    INFO(name);
    CHECK_FALSE(run(exponential, 0, infinity, 1e-10).reached());
    CHECK_FALSE(run(exponential, no_number, 1, 1e-10).reached());
  }
  CHECK_FALSE(simpson(exponential, 0, infinity, 8).reached());
  CHECK_FALSE(gauss_legendre(exponential, no_number, 1, 8).reached());
}

TEST_CASE("settings that make no rule are refused", "[solvers]") {
  for (int panels : {-2, 0, 1, 3}) CHECK(simpson(exponential, 0, 1, panels).ending == Ending::raised);
  for (int panels : {-1, 0}) CHECK(trapezoid(exponential, 0, 1, panels).ending == Ending::raised);
  for (int points : {-1, 0}) CHECK(gauss_legendre(exponential, 0, 1, points).ending == Ending::raised);
  CHECK(qagp(exponential, {}, 1e-10).ending == Ending::raised);
  CHECK(qagp(exponential, {0}, 1e-10).ending == Ending::raised);
  CHECK(qagp(exponential, {0, 1, 0.5}, 1e-10).ending == Ending::raised);
}
