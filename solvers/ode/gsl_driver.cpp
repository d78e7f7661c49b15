#include "solvers/ode/gsl_driver.hpp"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>

#include <cmath>
#include <exception>
#include <limits>
#include <new>

#include "solvers/gsl.hpp"

namespace oddity::ode::detail {

namespace {

/// GSL stops at GSL_EBADFUNC, and halves the step at any other error.
int status_of(Call call) {
  return call == Call::ok ? GSL_SUCCESS : call == Call::not_finite ? GSL_FAILURE : GSL_EBADFUNC;
}

using Guarded = GuardedProblem<status_of>;

int rhs(double t, const double x[], double dxdt[], void* guarded) {
  return static_cast<Guarded*>(guarded)->call(
      [&](const RawProblem& p) { return p.rhs(p.object, x, dxdt, t); });
}

int jacobian(double t, const double x[], double* matrix, double dfdt[], void* guarded) {
  return static_cast<Guarded*>(guarded)->call(
      [&](const RawProblem& p) { return p.jacobian(p.object, x, matrix, dfdt, t); });
}

const gsl_odeiv2_step_type* type_of(GslStep step) {
  switch (step) {
    case GslStep::rk8pd:
      return gsl_odeiv2_step_rk8pd;
    case GslStep::msadams:
      return gsl_odeiv2_step_msadams;
    case GslStep::msbdf:
      return gsl_odeiv2_step_msbdf;
    case GslStep::bsimp:
      break;
  }
  return gsl_odeiv2_step_bsimp;
}

}  // namespace

struct GslDriver::Driver {
  gsl_odeiv2_system system;
  gsl_odeiv2_driver* gsl;
  double h;
  Guarded guarded = {};

  Driver(GslStep step, std::size_t n, double tolerance, double first_step)
      : system{rhs, jacobian, n, nullptr},
        gsl((disable_gsl_abort(),
             gsl_odeiv2_driver_alloc_y_new(&system, type_of(step), first_step, tolerance, tolerance))),
        h(first_step) {
    if (!gsl) throw std::bad_alloc();
  }
  ~Driver() { gsl_odeiv2_driver_free(gsl); }
  Driver(const Driver&) = delete;

  void take(const RawProblem& problem) {
    guarded = {&problem};
    system.params = &guarded;
  }
  void face(double direction) {
    if (direction * h > 0) return;
    h = -h;
    gsl_odeiv2_driver_reset(gsl);
  }
};

GslDriver::GslDriver(GslStep step, std::size_t n, double tolerance, double first_step)
    : driver_(new Driver(step, n, tolerance, first_step)) {}
GslDriver::~GslDriver() = default;
GslDriver::GslDriver(GslDriver&&) noexcept = default;

const char* GslDriver::advance(const RawProblem& problem, double* x, double& t, double t1) {
  driver_->take(problem);
  driver_->face(t1 - t);
  // GSL reaches t1 exactly only if the step would go beyond.
  const bool last = std::abs(driver_->h) >= std::abs(t1 - t);
  const double beyond = 2 * (t1 - t);
  double tried = last ? beyond : driver_->h;
  const auto& gsl = *driver_->gsl;
  const int status = gsl_odeiv2_evolve_apply(gsl.e, gsl.c, gsl.s, &driver_->system, &t, t1, &tried, x);
  driver_->guarded.rethrow();
  if (tried != beyond) driver_->h = tried;
  return status == GSL_SUCCESS ? nullptr : "GSL found no step small enough";
}

void GslDriver::plain_step(const RawProblem& problem, double* x, double t, double h) {
  driver_->take(problem);
  const auto& gsl = *driver_->gsl;
  const int status = gsl_odeiv2_step_apply(gsl.s, t, h, x, gsl.e->yerr, nullptr, nullptr, &driver_->system);
  driver_->guarded.rethrow();
  if (status != GSL_SUCCESS) x[0] = std::numeric_limits<double>::quiet_NaN();
}

}  // namespace oddity::ode::detail
