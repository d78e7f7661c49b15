#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>
#include <gsl/gsl_version.h>

#include <cmath>

#include "report/verify/catch.hpp"
#include "tests/libraries/shown.hpp"

TEST_CASE("the error of GSL's bsimp is many tolerances where its steps are long", "[libraries]") {
  const Shown shown{"gsl_bsimp_error", gsl_version};
  gsl_odeiv2_system system{[](double t, const double x[], double dxdt[], void*) -> int {
                             dxdt[0] = x[0] * std::cos(t);
                             return GSL_SUCCESS;
                           },
                           [](double t, const double x[], double* by_x, double by_t[], void*) -> int {
                             *by_x = std::cos(t), by_t[0] = -x[0] * std::sin(t);
                             return GSL_SUCCESS;
                           },
                           1, nullptr};
  gsl_odeiv2_driver* driver = gsl_odeiv2_driver_alloc_y_new(&system, gsl_odeiv2_step_bsimp, 8e-3, 1e-6, 1e-6);
  double t = 0, x[] = {1}, longest = 0;
  while (t < 8) {
    const double before = t;
    REQUIRE(gsl_odeiv2_evolve_apply(driver->e, driver->c, driver->s, &system, &t, 8, &driver->h, x) ==
            GSL_SUCCESS);
    longest = std::max(longest, t - before);
  }
  gsl_odeiv2_driver_free(driver);
  const double tolerances = std::abs(x[0] - std::exp(std::sin(8))) / 1e-6;
  shown.check("errs by more than 100 tolerances", tolerances > 100, tolerances);
  shown.check("a step is longer than half the motion's period", longest > std::acos(-1), longest);
}
