#include "chapters/03_rigid_body_motion/25_chain/chain.hpp"
#include "solvers/counted.hpp"
#include "tests/catch.hpp"

using namespace oddity;

TEST_CASE("a chain's accelerations cost the same for each link beyond the first", "[chain]") {
  const auto cost = [](int n) {
    const ex03_25::Pattern p(n);
    const auto counted = [](const std::vector<double>& x) {
      return std::vector<Counted<double>>(x.begin(), x.end());
    };
    auto alpha = counted(p.theta);
    return operations_of([&] {
      chain::by_tensions(counted(p.m), counted(p.r), 9.81, counted(p.theta), counted(p.omega), alpha);
      return alpha[0];
    });
  };
  const Operations ten = cost(10), eleven = cost(11);
  CHECK(eleven.multiplications - ten.multiplications == 9);
  CHECK(eleven.divisions - ten.divisions == 4);
  CHECK(eleven.functions - ten.functions == 2);
}
