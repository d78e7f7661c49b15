#include "chapters/06_physics_engines/03_moving_spheres/moving_spheres.hpp"
#include "chapters/06_physics_engines/shared/bins.hpp"
#include "chapters/contents.hpp"
#include "report/verify/catch.hpp"

using namespace oddity;

TEST_CASE("the factored test of a sphere and a bin finds the same as whole numbers", "[6.1]") {
  using namespace bins;
  const Grid grid{1, 8};
  std::vector<Lattice> spheres = edge_cases(grid.half);
  for (const Lattice& s : random_spheres(1, 40, grid.half, 2)) spheres.push_back(s);
  for (const Lattice& s : spheres) {
    INFO(s.where());
    CHECK(hits(s.sphere(), grid, every_bin, touches_factored).ids == exact_ids(s, grid, hit_exactly));
  }
}

TEST_CASE("the widened range has one more bin at either end", "[6.1]") {
  using namespace bins;
  const Grid grid{0.5, 16};
  for (const Lattice& lattice : random_spheres(1, 40, 8, 2)) {
    INFO(lattice.where());
    const Sphere s = lattice.sphere(grid.h);
    for (double x : s.c) {
      CHECK(reach_widened(x, s.r, grid).low == reach(x, s.r, grid).low - 1);
      CHECK(reach_widened(x, s.r, grid).high == reach(x, s.r, grid).high + 1);
    }
  }
}

TEST_CASE("2^31 is the first index that does not fit in 32 bits", "[6.1]") {
  using namespace bins;
  const Grid grid{1, 8};
  CHECK(reach_converted_first(0x1p31 - 1, 0, grid).high == 7);
  CHECK(reach_converted_first(0x1p31, 0, grid).high == -9);
}

TEST_CASE("ranges of bins do not depend on the unit of length", "[6.1]") {
  using namespace bins;
  const Grid grid{1, 16}, quarters{0.25, 16};
  for (const auto range : {reach, reach_by_floor, reach_by_truncation, reach_converted_first, reach_widened})
    for (double x : {-3.5, -1.0, 0.25, 2.0, 6.75})
      for (double r : {0.5, 1.25, 4.0}) {
        const Span one = range(x, r, grid), other = range(x / 4, r / 4, quarters);
        INFO("x = " << x << ", r = " << r);
        CHECK(other.low == one.low);
        CHECK(other.high == one.high);
      }
}

TEST_CASE("spheres that meet after millions of frames are looked at in one million", "[6.3]") {
  const auto moving = std::ranges::find(registry(), Number{6, 3}, &Entry::number);
  Parameters p(moving->exercise.parameters);
  p.set("v1x", 1e-6);
  p.set("v2x", 0);
  p.set("v2y", 0);
  const auto contact = ex06_03::first_contact(p);
  REQUIRE(contact);
  const auto looked = std::ranges::find(contact->methods, "looked at in every frame", &Method::algorithm);
  REQUIRE(looked != contact->methods.end());
  CHECK(looked->run(0).evaluations <= 1'000'001);
}
