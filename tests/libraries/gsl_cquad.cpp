#include <gsl/gsl_errno.h>
#include <gsl/gsl_integration.h>
#include <gsl/gsl_version.h>

#include <cmath>
#include <limits>

#include "report/verify/catch.hpp"
#include "tests/libraries/shown.hpp"

namespace {

struct Result {
  int status;
  double error, estimate;
};

Result cquad(double (*f)(double, void*), void* with, double a, double b, double truth) {
  gsl_set_error_handler_off();
  gsl_integration_cquad_workspace* workspace = gsl_integration_cquad_workspace_alloc(1000);
  const gsl_function function{f, with};
  double value = 0, estimate = 0;
  const int status =
      gsl_integration_cquad(&function, a, b, 1e-10, 1e-10, workspace, &value, &estimate, nullptr);
  gsl_integration_cquad_workspace_free(workspace);
  return {status, std::abs(value - truth), estimate};
}

}  // namespace

TEST_CASE("GSL's CQUAD reports success whatever its estimate is", "[libraries]") {
  const Shown shown{"gsl_cquad", gsl_version};
  const auto spike = [](double x, void*) { return 1 / std::sqrt(std::abs(x - 0.3)); };
  const Result missed = cquad(spike, nullptr, 0, 1, 2 * (std::sqrt(0.3) + std::sqrt(0.7)));
  shown.check(
      "1/sqrt|x - 0.3| over [0, 1] to 1e-10 ends with success, with an error and an estimate above 1e-8",
      missed.status == GSL_SUCCESS && missed.error > 1e-8 && missed.estimate > 1e-8, missed.error);
  const auto growing = [](double x, void*) { return std::exp(x); };
  const Result backward = cquad(growing, nullptr, 1, 0, 1 - std::exp(1));
  shown.check("From 1 to 0 its estimate is below zero", backward.estimate < 0, backward.estimate);
  long calls = 0;
  const auto pole = [](double x, void* count) {  // ends with the largest number
    return ++*static_cast<long*>(count) > 1'000'000 ? std::numeric_limits<double>::max() : 1 / x;
  };
  cquad(pole, &calls, -1, 2, 0);
  shown.check("takes more than 1,000,000 evaluations of 1/x over [-1, 2]", calls > 1'000'000,
              static_cast<double>(calls));
}
