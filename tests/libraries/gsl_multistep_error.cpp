#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>
#include <gsl/gsl_version.h>

#include <cmath>

#include "report/verify/catch.hpp"
#include "tests/libraries/shown.hpp"

TEST_CASE("the error of GSL's multistep methods is many tolerances", "[libraries]") {
  const Shown shown{"gsl_multistep_error", gsl_version};
  gsl_odeiv2_system oscillator{[](double, const double x[], double dxdt[], void*) -> int {
                                 dxdt[0] = x[1], dxdt[1] = -x[0];
                                 return GSL_SUCCESS;
                               },
                               [](double, const double[], double* by_x, double by_t[], void*) -> int {
                                 by_x[0] = by_x[3] = by_t[0] = by_t[1] = 0, by_x[1] = 1, by_x[2] = -1;
                                 return GSL_SUCCESS;
                               },
                               2, nullptr};
  const auto tolerances = [&](const gsl_odeiv2_step_type* type) {
    constexpr double tolerance = 1e-11;
    gsl_odeiv2_driver* driver = gsl_odeiv2_driver_alloc_y_new(&oscillator, type, 0.01, tolerance, tolerance);
    double t = 0, x[] = {1, 0};
    CHECK(gsl_odeiv2_driver_apply(driver, &t, 10, x) == GSL_SUCCESS);
    gsl_odeiv2_driver_free(driver);
    return std::hypot(x[0] - std::cos(10), x[1] + std::sin(10)) / tolerance;
  };
  const double adams = tolerances(gsl_odeiv2_step_msadams), bdf = tolerances(gsl_odeiv2_step_msbdf),
               rk8pd = tolerances(gsl_odeiv2_step_rk8pd);
  shown.check("1e-11 msadams errs by more than 200 tolerances", adams > 200, adams);
  shown.check("msbdf by more than 500", bdf > 500, bdf);
  shown.check("rk8pd by less than 1", rk8pd < 1, rk8pd);
}
