#include "chapters/09_calculus/01_point_triangle/point_triangle.hpp"
#include "tests/catch.hpp"
#include "tests/near.hpp"

using namespace oddity;

TEST_CASE("on a triangle its quadratic is rounded to below zero, and no distance is", "[9.1]") {
  const ex09_01::Triangle<double> w{{{{1, 2, -1}, {4, 3, 0}, {0, 4, 1}}}};
  int below = 0;
  for (int i = 1; i < 20; ++i)
    for (int j = 1; i + j < 20; ++j) {
      const auto p = w.at(i / 20.0, j / 20.0);
      const ex09_01::Quadratic<double> q(w, p);
      const auto place = ex09_01::by_regions(q);
      below += q(place.s, place.t) < 0;
      CHECK(within(ex09_01::quadratic_distance(w, p), 0, 1e-7));  // the root of roundings
    }
  CHECK(below > 0);
}
