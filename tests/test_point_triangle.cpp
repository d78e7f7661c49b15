#include "chapters/09_calculus/01_point_triangle/point_triangle.hpp"
#include "report/verify/catch.hpp"
#include "tests/near.hpp"

using namespace oddity;

TEST_CASE("on a triangle the quadratic is rounded to below zero, but no distance is", "[9.1]") {
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

TEST_CASE("scaled distances are found for a speck from afar, and for a triangle on the other side", "[9.1]") {
  const ex09_01::Vec<double> far{3e10, 4e10, 0};
  const ex09_01::Triangle<double> speck{{{{1e-300, 0, 0}, {0, 1e-300, 0}, {0, 0, 1e-300}}}};
  CHECK(near(ex09_01::scaled_distance(speck, far) / 5e10, 1, 1e-15));
  const ex09_01::Triangle<double> opposite{{{{1e200, 0, 0}, {1e200, 1, 0}, {1e200, 0, 1}}}};
  CHECK(near(ex09_01::scaled_distance(opposite, ex09_01::Vec<double>{-1e200, 0, 0}) / 2e200, 1, 1e-15));
}

TEST_CASE("the golden section finds the least value anywhere", "[9.1]") {
  for (double least : {-1.0, -0.9, -0.5, 0.1, 0.5, 1.2, 1.9, 2.0}) {
    INFO(least);
    const auto f = [=](double x) { return 7 + (x - least) * (x - least); };
    CHECK(near(ex09_01::golden_section<double>(f, -1, 2, 40), 7, 1e-14));
    // Three steps leave an interval of 0.71. Two of its four points are up to 0.27 apart, and the least value
    // is between them.
    CHECK(ex09_01::golden_section<double>(f, -1, 2, 3) < 7 + 0.136 * 0.136);
  }
}
