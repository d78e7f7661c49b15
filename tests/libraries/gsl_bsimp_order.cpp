#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>
#include <gsl/gsl_version.h>

#include "report/verify/catch.hpp"
#include "tests/libraries/shown.hpp"

namespace {

int rhs(double, const double x[], double dxdt[], void* calls) {
  ++*static_cast<long*>(calls);
  dxdt[0] = x[1], dxdt[1] = -x[0];
  return GSL_SUCCESS;
}

int jacobian(double, const double[], double* by_x, double by_t[], void*) {
  by_x[0] = by_x[3] = by_t[0] = by_t[1] = 0, by_x[1] = 1, by_x[2] = -1;
  return GSL_SUCCESS;
}

}  // namespace

TEST_CASE("GSL's bsimp has one order for all tolerances", "[libraries]") {
  const Shown shown{"gsl_bsimp_order", gsl_version};
  long calls = 0;
  gsl_odeiv2_system oscillator{rhs, jacobian, 2, &calls};
  double x[] = {1, 0}, error[2];
  gsl_odeiv2_step* step = gsl_odeiv2_step_alloc(gsl_odeiv2_step_bsimp, 2);
  gsl_odeiv2_step_apply(step, 0, 1, x, error, nullptr, nullptr, &oscillator);
  const unsigned order = gsl_odeiv2_step_order(step);
  gsl_odeiv2_step_free(step);
  shown.check("12, at 139 evaluations per step", order == 12 && calls == 139, static_cast<double>(calls));
  const auto cost = [&](double tolerance) {
    gsl_odeiv2_driver* driver =
        gsl_odeiv2_driver_alloc_y_new(&oscillator, gsl_odeiv2_step_bsimp, 0.01, tolerance, tolerance);
    double t = 0, y[] = {1, 0};
    calls = 0;
    CHECK(gsl_odeiv2_driver_apply(driver, &t, 10, y) == GSL_SUCCESS);
    gsl_odeiv2_driver_free(driver);
    return calls;
  };
  const double ratio = static_cast<double>(cost(0.01)) / static_cast<double>(cost(1e-6));
  shown.check("A tolerance of 0.01 costs as many evaluations as one of 1e-6", ratio == 1, ratio);
}
