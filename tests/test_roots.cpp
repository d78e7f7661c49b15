#include "report/verify/catch.hpp"
#include "solvers/roots.hpp"
#include "tests/near.hpp"

using namespace oddity;

namespace {

constexpr double no_number = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

double cosine_minus_x(double x) { return std::cos(x) - x; }
constexpr double cosine_root = 0.73908513321516064166;

}  // namespace

TEST_CASE("Brent's method finds a simple root to the last digit, from either side", "[solvers]") {
  for (double tolerance : {1e-12, 0.0, -1.0, no_number}) {
    for (const auto& root :
         {brent(cosine_minus_x, 0, 1, tolerance), brent(cosine_minus_x, 1, 0, tolerance)}) {
      CHECK(root.reached());
      CHECK(near_ulps(root.value, cosine_root, 2));
      CHECK(root.evaluations < 12);
    }
  }
}

TEST_CASE("Brent's error estimate bounds the error at every tolerance", "[solvers]") {
  const auto cube = [](double x) { return (x - 0.1) * (x - 0.1) * (x - 0.1); };
  for (double tolerance : {1e-2, 1e-4, 1e-8, 1e-12}) {
    for (const auto& root : {brent(cube, -1, 2, tolerance), brent(cosine_minus_x, 0, 1, tolerance)}) {
      const double exact = root.value < 0.5 ? 0.1 : cosine_root;
      CHECK(root.reached());
      CHECK(root.error_estimate <= tolerance);
      CHECK(std::abs(root.value - exact) <= root.error_estimate + 1e-16);
    }
  }
}

TEST_CASE("a flat root costs more than bisection's 2 evaluations a bit, and no more than 130", "[solvers]") {
  const auto cube = [](double x) { return x * x * x; };
  const auto root = brent(cube, -1, 2, 1e-12);
  CHECK(root.reached());
  CHECK(near(root.value, 0, 1e-12));
  CHECK(within(static_cast<double>(root.evaluations), 80, 135));
}

TEST_CASE("a root at an end of the bracket is found there", "[solvers]") {
  const auto identity = [](double x) { return x; };
  CHECK(brent(identity, 0, 1, 1e-12).value == 0);
  CHECK(brent(identity, -1, 0, 1e-12).value == 0);
  CHECK(brent(identity, 0, 0, 1e-12).value == 0);
  CHECK(brent(identity, 0, 1, 1e-12).evaluations == 2);
}

TEST_CASE("without a bracket Brent's method raises", "[solvers]") {
  const auto positive = [](double x) { return x * x + 1; };
  const auto root = brent(positive, 0, 1, 1e-12);
  CHECK(root.ending == Ending::raised);
  CHECK(root.message.find("no bracket") == 0);
  CHECK(root.evaluations == 2);
  CHECK(brent(positive, 1, 1, 1e-12).ending == Ending::raised);
}

TEST_CASE("NaN and infinity raise", "[solvers]") {
  const auto half = [](double x) { return x < 0.3 ? 1 : no_number; };
  const auto inside = [](double x) { return x == 0 ? -1 : x == 1 ? 1 : no_number; };
  const auto identity = [](double x) { return x; };
  CHECK(brent(half, 0, 1, 1e-12).ending == Ending::raised);
  CHECK(brent(inside, 0, 1, 1e-12).ending == Ending::raised);
  CHECK(brent(identity, -infinity, 1, 1e-12).ending == Ending::raised);
  CHECK(brent(identity, no_number, 1, 1e-12).ending == Ending::raised);
}

TEST_CASE("a change of sign at a pole is not a root", "[solvers]") {
  const auto pole = [](double x) { return 1 / (x - 0.3); };
  CHECK(brent(pole, 0, 1, 1e-12).ending == Ending::raised);
  CHECK(brent([](double x) { return std::tan(x); }, 1, 2, 1e-12).ending == Ending::raised);
}

TEST_CASE("a jump across zero counts as a root", "[solvers]") {
  const auto root = brent([](double x) { return x < 0.3 ? -1.0 : 1.0; }, 0, 1, 1e-12);
  CHECK(root.reached());
  CHECK(near(root.value, 0.3, 1e-12));
}

TEST_CASE("a bracket that does not close in 200 iterations stalls", "[solvers]") {
  const auto root = brent([](double x) { return x * x * x; }, -1, 2, 0);
  CHECK(root.ending == Ending::stalled);
  CHECK(near(root.value, 0, 1e-15));
}

TEST_CASE("an exception of the function passes through Brent's method, from an end and from inside",
          "[solvers]") {
  const auto at_an_end = [](double) -> double { throw std::domain_error("nowhere"); };
  const auto inside = [](double x) -> double {
    if (x > 0 && x < 1) throw std::domain_error("nothing inside");
    return x - 0.5;
  };
  CHECK_THROWS_WITH(brent(at_an_end, 0, 1, 1e-12), "nowhere");
  CHECK_THROWS_WITH(brent(inside, 0, 1, 1e-12), "nothing inside");
}
