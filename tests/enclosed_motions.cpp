// Motions in balls. Compiled like the generators in balls (tests/CMakeLists.txt).

#include "reference/enclosures/motion.hpp"
#include "report/verify/catch.hpp"

using namespace oddity::truth;

namespace {

double radius_of(const Ball& x) { return greatest_size(x - midpoint(x)); }
bool holds(const Ball& x, const Ball& exact) { return arb_overlaps(x.data(), exact.data()) != 0; }

const auto oscillator = [](const auto& x, const auto&) { return std::vector{x[1], -x[0]}; };
const auto with_a_pole = [](const auto& x, const auto&) { return std::vector{x[0] * x[0]}; };

}  // namespace

TEST_CASE("an oscillation is enclosed for fifty turns, and backwards", "[enclosures]") {
  Ball::bits = 256;
  for (double t : {1.0, 314.0, -20.0}) {
    const Numbers x = solve_taylor(oscillator, {1, 0}, 0, t, 46);
    CHECK(holds(x[0], cos(Ball(t))));
    CHECK(holds(x[1], -sin(Ball(t))));
    CHECK(radius_of(x[0]) < 1e-40);
    CHECK_FALSE(holds(x[0], cos(Ball(t)) + Ball(1e-39)));
  }
}

TEST_CASE("a box of starts is enclosed by a box of ends that is hardly larger than needed", "[enclosures]") {
  Ball::bits = 256;
  const Numbers start{within(Ball(1), Ball(1e-12)), within(Ball(0), Ball(1e-12))};
  const Numbers x = TaylorProblem(oscillator, 2).solve(start, 0, 100, 30);
  for (double dx : {-1e-12, 1e-12})
    for (double dv : {-1e-12, 1e-12})
      CHECK(holds(x[0], cos(Ball(100)) * (1 + Ball(dx)) + sin(Ball(100)) * Ball(dv)));
  CHECK(radius_of(x[0]) > 1e-12);
  CHECK(radius_of(x[0]) < 3e-12);
}

TEST_CASE("beyond a pole no result is given, and results near it are right", "[enclosures]") {
  Ball::bits = 256;
  CHECK(holds(solve_taylor(with_a_pole, {1}, 0, 0.75, 46)[0], Ball(4)));
  CHECK_THROWS_AS(solve_taylor(with_a_pole, {1}, 0, 2, 20), Undecided);
}

TEST_CASE("balls that overlap are not compared", "[enclosures]") {
  const Ball third = Ball(1) / 3;
  CHECK_THROWS_AS(third < Ball(1) / 3, Undecided);
  CHECK_THROWS_AS(third * 3 == Ball(1), Undecided);
  CHECK(third < Ball(0.34));
  CHECK_THROWS_AS(Ball(1) / (third * 3 - 1), Undecided);
  CHECK_THROWS_AS(sqrt(Ball(-1)), Undecided);
  CHECK_THROWS_AS(decimal("1.2.3"), std::invalid_argument);
}
