#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>
#include <gsl/gsl_version.h>

#include <cmath>

#include "report/verify/catch.hpp"
#include "tests/libraries/shown.hpp"

TEST_CASE("GSL's step control takes NaN for no error", "[libraries]") {
  const Shown shown{"gsl_nan", gsl_version};
  gsl_odeiv2_system system{[](double, const double x[], double dxdt[], void*) -> int {
                             dxdt[0] = std::sqrt(x[0]) - 1;
                             return GSL_SUCCESS;
                           },
                           [](double, const double x[], double* by_x, double by_t[], void*) -> int {
                             *by_x = 0.5 / std::sqrt(x[0]), by_t[0] = 0;
                             return GSL_SUCCESS;
                           },
                           1, nullptr};
  for (const auto* type : {gsl_odeiv2_step_rk8pd, gsl_odeiv2_step_bsimp}) {
    gsl_odeiv2_driver* driver = gsl_odeiv2_driver_alloc_y_new(&system, type, 1e-3, 1e-6, 1e-6);
    double t = 0, x[] = {0.5};
    const int status = gsl_odeiv2_driver_apply(driver, &t, 5, x);
    gsl_odeiv2_driver_free(driver);
    shown.check("return success, with NaN", status == GSL_SUCCESS && std::isnan(x[0]), x[0]);
  }
}
