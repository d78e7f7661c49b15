#include <boost/numeric/odeint/stepper/base/symplectic_rkn_stepper_base.hpp>
#include <boost/numeric/odeint/stepper/symplectic_rkn_sb3a_m4_mclachlan.hpp>
#include <boost/version.hpp>

#include "report/verify/catch.hpp"
#include "tests/libraries/shown.hpp"

TEST_CASE("Odeint's McLachlan 4 asks for a force that it does not use", "[libraries]") {
  using Half = std::array<double, 1>;
  const Shown shown{"odeint_mclachlan", BOOST_LIB_VERSION};
  const auto step = [&](double fifth_force) {
    int calls = 0;
    Half q{1}, v{0};
    boost::numeric::odeint::symplectic_rkn_sb3a_m4_mclachlan<Half>().do_step(
        [&](const Half& x, Half& a) { a[0] = ++calls == 5 ? fifth_force : -x[0]; },
        std::pair(std::ref(q), std::ref(v)), 0.0, 0.1);
    shown.check("asks for the forces 5 times per step", calls == 5, calls);
    return std::pair(q[0], v[0]);
  };
  const auto with = step(1e6), without = step(0);
  shown.check("the last answer has the weight zero", with == without, with.second - without.second);
}
