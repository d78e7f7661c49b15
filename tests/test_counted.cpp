#include <thread>

#include "report/verify/catch.hpp"
#include "solvers/counted.hpp"

using namespace oddity;

using Real = Counted<double>;

TEST_CASE("every operation on counted numbers is counted by its kind", "[counted]") {
  const Real a = 3, b = 2;
  const Operations all = operations_of([&] { return (a + b) * (a - b) / sqrt(a) + sin(b) * -a; });
  CHECK(all.additions == 3);
  CHECK(all.multiplications == 2);
  CHECK(all.divisions == 1);
  CHECK(all.functions == 2);
  CHECK(all.all_but_additions() == 5);
}

TEST_CASE("counted numbers have the values of plain ones", "[counted]") {
  Real x = 7;
  x /= Real(2);
  x -= Real(0.5);
  CHECK(x.value() == 3);
  CHECK(floor(x / Real(2)).value() == 1);
  CHECK(hypot(Real(3), Real(4)).value() == 5);
  CHECK((Real(3) * Real(4)).value() == 12);
  CHECK((x > Real(2) && x == Real(3)));
}

TEST_CASE("a count neither includes another thread's operations nor loses those around it", "[counted]") {
  const Real a = 3;
  const Operations outer = operations_of([&] {
    const Real before = a * a;
    std::thread([&] { static_cast<void>(a * a * a); }).join();
    const Operations inner = operations_of([&] { return before * before * before; });
    CHECK(inner.multiplications == 2);
  });
  CHECK(outer.multiplications == 1);
}
