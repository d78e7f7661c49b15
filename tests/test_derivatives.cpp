// Dual numbers compared with closed derivatives at random points, and orders of differences.

#include "chapters/random.hpp"
#include "report/study/fit.hpp"
#include "report/verify/catch.hpp"
#include "solvers/differences.hpp"
#include "solvers/dual.hpp"
#include "tests/near.hpp"

using namespace oddity;
using std::cos, std::sin, std::exp, std::log, std::sqrt, std::tan, std::pow;

namespace {

/// Compares f' and f'' by dual numbers with their closed forms at random points between low and high.
template <class F, class First, class Second>
void check_derivatives(const F& f, const First& first, const Second& second, double low, double high) {
  Random random(1);
  for (int i = 0; i < 100; ++i) {
    const double x = random.between(low, high);
    CHECK(near(derivative(f, x), first(x), 1e-14 * (1 + std::abs(first(x)))));
    CHECK(near(second_derivative(f, x), second(x), 1e-13 * (1 + std::abs(second(x)))));
    CHECK(near_ulps(f(Dual<double>(x, 1.0)).value, f(x), 4));
  }
}

}  // namespace

TEST_CASE("dual numbers: the square root", "[solvers]") {
  check_derivatives([](auto x) { return sqrt(x); }, [](double x) { return 0.5 / sqrt(x); },
                    [](double x) { return -0.25 / (x * sqrt(x)); }, 0.1, 10);
}

TEST_CASE("dual numbers: sine, cosine and tangent", "[solvers]") {
  check_derivatives([](auto x) { return sin(x); }, [](double x) { return cos(x); },
                    [](double x) { return -sin(x); }, -10, 10);
  check_derivatives([](auto x) { return cos(x); }, [](double x) { return -sin(x); },
                    [](double x) { return -cos(x); }, -10, 10);
  check_derivatives([](auto x) { return tan(x); }, [](double x) { return 1 / (cos(x) * cos(x)); },
                    [](double x) { return 2 * tan(x) / (cos(x) * cos(x)); }, -1.4, 1.4);
}

TEST_CASE("dual numbers: the exponential and the logarithm", "[solvers]") {
  check_derivatives([](auto x) { return exp(x); }, [](double x) { return exp(x); },
                    [](double x) { return exp(x); }, -3, 3);
  check_derivatives([](auto x) { return log(x); }, [](double x) { return 1 / x; },
                    [](double x) { return -1 / (x * x); }, 0.1, 10);
}

TEST_CASE("dual numbers: the inverse sine and cosine", "[solvers]") {
  const auto root = [](double x) { return sqrt((1 - x) * (1 + x)); };
  check_derivatives([](auto x) { return asin(x); }, [=](double x) { return 1 / root(x); },
                    [=](double x) { return x / (root(x) * root(x) * root(x)); }, -0.9, 0.9);
  check_derivatives([](auto x) { return acos(x); }, [=](double x) { return -1 / root(x); },
                    [=](double x) { return -x / (root(x) * root(x) * root(x)); }, -0.9, 0.9);
}

TEST_CASE("dual numbers: the angle of a point, in all four quadrants", "[solvers]") {
  // Along (2 cos t, 3 sin t) the angle's slope is 6 / r^2.
  check_derivatives([](auto t) { return atan2(3 * sin(t), 2 * cos(t)); },
                    [](double t) { return 6 / (4 * cos(t) * cos(t) + 9 * sin(t) * sin(t)); },
                    [](double t) {
                      const double square = 4 * cos(t) * cos(t) + 9 * sin(t) * sin(t);
                      return -6 * 10 * sin(t) * cos(t) / (square * square);
                    },
                    -3.1, 3.1);
}

TEST_CASE("dual numbers: constant powers", "[solvers]") {
  for (double n : {-1.5, -1.0, 0.5, 1.0, 2.0, 3.0, 7.25})
    check_derivatives([n](auto x) { return pow(x, n); }, [n](double x) { return n * pow(x, n - 1); },
                      [n](double x) { return n * (n - 1) * pow(x, n - 2); }, 0.3, 3);
}

TEST_CASE("dual numbers: whole powers are differentiated at zero too", "[solvers]") {
  const auto power = [](int n) { return [n](auto x) { return pow(x, n); }; };
  CHECK(derivative(power(0), 0.0) == 0);
  CHECK(derivative(power(1), 0.0) == 1);
  CHECK(derivative(power(2), 0.0) == 0);
  CHECK(second_derivative(power(1), 0.0) == 0);
  CHECK(second_derivative(power(2), 0.0) == 2);
  CHECK(second_derivative(power(3), 0.0) == 0);
}

TEST_CASE("dual numbers: products, quotients and compounds", "[solvers]") {
  check_derivatives([](auto x) { return x * sin(x); }, [](double x) { return sin(x) + x * cos(x); },
                    [](double x) { return 2 * cos(x) - x * sin(x); }, -3, 3);
  check_derivatives([](auto x) { return sin(x) / x; }, [](double x) { return cos(x) / x - sin(x) / (x * x); },
                    [](double x) { return -sin(x) / x - 2 * cos(x) / (x * x) + 2 * sin(x) / (x * x * x); }, 1,
                    4);
  check_derivatives([](auto x) { return -exp(-x * x) + 3 - x; },
                    [](double x) { return 2 * x * exp(-x * x) - 1; },
                    [](double x) { return (2 - 4 * x * x) * exp(-x * x); }, -2, 2);
}

TEST_CASE("dual numbers: a distance, and the inverse hyperbolic sine", "[solvers]") {
  // Along (3 t, t^2 + 1) the distance's slope is (9 t + 2 t (t^2 + 1)) / r.
  const auto slope = [](double t) { return (9 * t + 2 * t * (t * t + 1)) / std::hypot(3 * t, t * t + 1); };
  check_derivatives(
      [](auto t) { return hypot(3 * t, t * t + 1); }, slope,
      [=](double t) { return (11 + 6 * t * t - slope(t) * slope(t)) / std::hypot(3 * t, t * t + 1); }, 0.5,
      3);
  const auto root = [](double x) { return sqrt(1 + x * x); };
  check_derivatives([](auto x) { return asinh(x); }, [=](double x) { return 1 / root(x); },
                    [=](double x) { return -x / (root(x) * root(x) * root(x)); }, -3, 3);
}

TEST_CASE("dual numbers: sizes and remainders, between their kinks and jumps", "[solvers]") {
  for (const double x : {-2.5, -0.5, 0.5, 2.5}) {
    const auto size = abs(Dual<double>(x, 3));
    CHECK(size.value == std::abs(x));
    CHECK(size.slope == (x < 0 ? -3 : 3));
  }
  const auto rest = remainder(Dual<double>(7.25, 1), Dual<double>(2, 0.5));  // 7.25 - 4 times 2
  CHECK(rest.value == -0.75);
  CHECK(rest.slope == -1);
}

TEST_CASE("dual numbers: assignment operators, signs and order", "[solvers]") {
  const auto f = [](auto x) {
    auto y = x;
    y += x;
    y *= x;
    y -= 1.0;
    y /= x;
    return +y;  // 2x - 1/x
  };
  check_derivatives(
      f, [](double x) { return 2 + 1 / (x * x); }, [](double x) { return -2 / (x * x * x); }, 1, 3);
  const Dual<double> low(1, 5), high(2, -5);
  CHECK(low < high);
  CHECK(high > low);
  CHECK_FALSE(low > high);
}

TEST_CASE("dual numbers nest: the fourth derivative of x^5", "[solvers]") {
  const auto f = [](auto x) { return x * x * x * x * x; };
  const auto second = [&](const auto& x) {
    return derivative([&](const auto& y) { return derivative(f, y); }, x);
  };
  const auto third = [&](const auto& x) { return derivative(second, x); };
  CHECK(near_ulps(derivative(third, 1.5), 120 * 1.5, 4));
}

// ---- differences ------------------------------------------------------------------------------------------

TEST_CASE("central differences are of order 2 and 4 until rounding takes over", "[solvers]") {
  const auto f = [](double x) { return exp(sin(x)); };
  const double x = 0.7, exact = cos(x) * exp(sin(x));
  std::vector<double> steps, second, fourth;
  for (double h : {0.1, 0.05, 0.025, 0.0125}) {
    steps.push_back(h);
    second.push_back(std::abs(central_difference_2(f, x, h).value - exact));
    fourth.push_back(std::abs(central_difference_4(f, x, h).value - exact));
  }
  CHECK(near(power_law(steps, second).exponent, 2, 0.02));
  CHECK(near(power_law(steps, fourth).exponent, 4, 0.05));
  CHECK(central_difference_2(f, x, 0.1).evaluations == 2);
  CHECK(central_difference_4(f, x, 0.1).evaluations == 4);
  CHECK(std::abs(central_difference_2(f, x, 1e-5).value - exact) < 1e-9);
  CHECK(std::abs(central_difference_2(f, x, 1e-13).value - exact) > 1e-5);
  CHECK(std::abs(central_difference_4(f, x, 1e-13).value - exact) > 1e-5);
}

TEST_CASE("central differences are exact on x^2 and x^4, not on x^3 and x^5", "[solvers]") {
  const auto power = [](int n) { return [n](double x) { return std::pow(x, n); }; };
  CHECK(near_ulps(central_difference_2(power(2), 1.5, 0.25).value, 3, 1));
  CHECK(near_ulps(central_difference_2(power(3), 1.5, 0.25).value, 3 * 1.5 * 1.5 + 0.25 * 0.25, 1));
  CHECK(near_ulps(central_difference_4(power(4), 1.5, 0.25).value, 4 * pow(1.5, 3), 2));
  CHECK(near_ulps(central_difference_4(power(5), 1.5, 0.25).value, 5 * pow(1.5, 4) - 4 * pow(0.25, 4), 2));
}

TEST_CASE("a difference that is not finite does not reach", "[solvers]") {
  for (auto difference : {central_difference_2, central_difference_4}) {
    CHECK(difference([](double x) { return log(x); }, 0, 0.1).ending == Ending::non_finite);
    CHECK(difference([](double x) { return x; }, 1, 0).ending == Ending::non_finite);
  }
}
