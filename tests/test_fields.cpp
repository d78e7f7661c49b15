// Chapter 5: how lines of index calculus are typeset, and what flows out of a cube around the origin.

#include <numbers>

#include "chapters/05_fluids_and_gases/03_inverse_square_field/inverse_square_field.hpp"
#include "chapters/05_fluids_and_gases/shared/proof.hpp"
#include "reference/reference.hpp"
#include "tests/catch.hpp"
#include "tests/near.hpp"

using namespace oddity;

TEST_CASE("a line is typeset with every digit as an index once", "[5.7]") {
  const fields::Names names{{"curl_f", "C"}, {"e0", "E"}};
  CHECK(fields::typeset("phi (f2,1 - f1,2) + phi,1 f2", names) ==
        R"(\varphi\,(f_{2,1}-f_{1,2})+\varphi_{,1}\,f_{2})");
  CHECK(fields::typeset("- curl_f0 e01 + f0,12", names) == R"(-C_{0}\,E_{1}+f_{0,12})");
}

TEST_CASE("a cube of any size is around the origin", "[5.3]") {
  for (double h : {0.1, 10.0}) {
    const Quantity q = ex05_03::cube_flux(h, Reference::nothing());
    const Method& gauss = q.methods.front();
    CHECK(near(gauss.run(gauss.knob.settings.back()).value[0], 4 * std::numbers::pi, 1e-12));
  }
}
