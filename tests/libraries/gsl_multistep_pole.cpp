#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>
#include <gsl/gsl_version.h>

#include "report/verify/catch.hpp"
#include "tests/libraries/shown.hpp"

TEST_CASE("GSL's multistep methods leave a growing solution at a loose tolerance", "[libraries]") {
  const Shown shown{"gsl_multistep_pole", gsl_version};
  gsl_odeiv2_system system{[](double, const double x[], double dxdt[], void*) -> int {
                             dxdt[0] = x[0] * x[0];
                             return GSL_SUCCESS;
                           },
                           [](double, const double x[], double* by_x, double by_t[], void*) -> int {
                             *by_x = 2 * x[0], by_t[0] = 0;
                             return GSL_SUCCESS;
                           },
                           1, nullptr};
  gsl_error_handler_t* const handler = gsl_set_error_handler_off();
  for (const auto* type : {gsl_odeiv2_step_msadams, gsl_odeiv2_step_msbdf}) {
    gsl_odeiv2_driver* driver = gsl_odeiv2_driver_alloc_y_new(&system, type, 1e-3, 0.1, 0.1);
    double t = 0, x[] = {1};
    while (x[0] <= 1e15 && gsl_odeiv2_evolve_apply(driver->e, driver->c, driver->s, &system, &t, 2,
                                                   &driver->h, x) == GSL_SUCCESS) {
    }
    gsl_odeiv2_driver_free(driver);
    shown.check("At a tolerance of 0.1 x is beyond 1e15 before t = 0.85", x[0] > 1e15 && t < 0.85, t);
  }
  gsl_set_error_handler(handler);
  const double solution = 1 / (1 - 0.85);
  shown.check("where it should be below 7", solution < 7, solution);
}
