// Quadrature rules nested in themselves, in two and three dimensions.

#include <numbers>

#include "report/verify/catch.hpp"
#include "solvers/quadrature.hpp"
#include "tests/near.hpp"

using namespace oddity;
using std::numbers::pi;

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
  CHECK(ball.message.empty());
  CHECK(near(ball.value, 4 * pi / 3, 1e-8));
  CHECK(ball.evaluations % 21 == 0);
  CHECK(ball.evaluations > 21 * 21 * 21);
}

TEST_CASE("an inner integral that fails makes the outer one fail, with a message", "[solvers]") {
  const auto rule = [](FunctionOfOne f, double a, double b) { return qags(f, a, b, 1e-10); };
  const auto area = nested(
      rule, [](double, double y) { return 1 / y; }, 0, 1, [](double) { return 0.0; },
      [](double) { return 1.0; });
  CHECK_FALSE(area.reached());
  CHECK(area.message.find("inner integral") == 0);
}
