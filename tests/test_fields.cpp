// Chapter 5: typesetting of lines of index calculus, and flux out of a cube around the origin.

#include <algorithm>
#include <numbers>

#include "chapters/05_fluids_and_gases/03_inverse_square_field/inverse_square_field.hpp"
#include "chapters/05_fluids_and_gases/shared/proof.hpp"
#include "chapters/contents.hpp"
#include "reference/reference.hpp"
#include "report/verify/catch.hpp"
#include "tests/complaint.hpp"
#include "tests/near.hpp"

using namespace oddity;

TEST_CASE("a line is typeset with every digit as an index once", "[5.7]") {
  const fields::Names names{{"curl_f", "C"}, {"e0", "E"}};
  CHECK(fields::typeset("phi (f2,1 - f1,2) + phi,1 f2", names) ==
        R"(\varphi\,(f_{2,1}-f_{1,2})+\varphi_{,1}\,f_{2})");
  CHECK(fields::typeset("- curl_f0 e01 + f0,12", names) == R"(-C_{0}\,E_{1}+f_{0,12})");
}

TEST_CASE("a letter without a name in TeX is typeset as itself, and only digits are its indices", "[5.7]") {
  CHECK(fields::typeset("f2,1 e", {{"e0", "E"}}) == R"(f_{2,1}\,e)");
  CHECK(fields::typeset("phi", {}) == R"(\varphi)");
  CHECK(fields::typeset("div", {}) == "div");
}

TEST_CASE("a product of sums is read as the sum of its products, and an unclosed one is refused", "[5.7]") {
  fields::Sample symbols;
  for (const char* name : {"a", "b", "c", "d"}) symbols.put(name, 1);
  const fields::Terms all = fields::read_terms("a (b - c) d - b", symbols);
  REQUIRE(all.size() == 3);
  CHECK(all[0].factors == std::vector<std::size_t>{0, 1, 3});
  CHECK(all[1].sign == -1);
  CHECK(all[1].factors == std::vector<std::size_t>{0, 2, 3});
  CHECK(all[2].sign == -1);
  CHECK(all[2].factors == std::vector<std::size_t>{1});
  for (const char* ill : {"a (b - c", "a (b d", "a b)", "a z"})
    CHECK_THROWS(fields::read_terms(ill, symbols));
}

TEST_CASE("the field of 5.3 is refused only at the origin", "[5.3]") {
  const Exercise& exercise = std::ranges::find(registry(), Number{5, 3}, &Entry::number)->exercise;
  const Reference truth(std::string(ODDITY_SOURCE) + "/reference");
  Parameters p(exercise.parameters);
  p.set("x1", 0), p.set("x2", 0), p.set("x0", 1);
  CHECK_NOTHROW(exercise.study(p, truth));
  p.set("x0", 0);
  CHECK(complaint([&] { exercise.study(p, truth); }) == "x / |x|^3 is not defined at x = 0");
}

TEST_CASE("a cube of any size is around the origin", "[5.3]") {
  for (double h : {0.1, 10.0}) {
    const Quantity q = ex05_03::cube_flux(h, Reference::nothing());
    const Method& gauss = q.methods.front();
    CHECK(near(gauss.run(gauss.resolution.settings.back()).value[0], 4 * std::numbers::pi, 1e-12));
  }
}
