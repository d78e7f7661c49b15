#ifdef ODDITY_SUNDIALS
#include <cvode/cvode.h>
#include <nvector/nvector_serial.h>
#include <sunlinsol/sunlinsol_dense.h>
#include <sunmatrix/sunmatrix_dense.h>

#include <cmath>

#include "report/verify/catch.hpp"
#include "tests/libraries/shown.hpp"

TEST_CASE("the error of CVODE's BDF is many tolerances", "[libraries]") {
  const Shown shown{"cvode_error", SUNDIALS_VERSION};
  const auto tolerances = [] {
    constexpr double tolerance = 1e-10;
    SUNContext context = nullptr;
    SUNContext_Create(nullptr, &context);
    N_Vector x = N_VNew_Serial(2, context);
    double* const value = N_VGetArrayPointer(x);
    value[0] = 1, value[1] = 0;
    const auto oscillator = [](double, N_Vector y, N_Vector dydt, void*) {
      N_VGetArrayPointer(dydt)[0] = N_VGetArrayPointer(y)[1];
      N_VGetArrayPointer(dydt)[1] = -N_VGetArrayPointer(y)[0];
      return 0;
    };
    void* cvode = CVodeCreate(CV_BDF, context);
    CVodeInit(cvode, oscillator, 0, x);
    CVodeSStolerances(cvode, tolerance, tolerance);
    CVodeSetMaxNumSteps(cvode, 100'000);
    CVodeSetStopTime(cvode, 10);
    SUNMatrix matrix = SUNDenseMatrix(2, 2, context);
    SUNLinearSolver linear = SUNLinSol_Dense(x, matrix, context);
    CVodeSetLinearSolver(cvode, linear, matrix);
    double t = 0;
    CHECK(CVode(cvode, 10, x, &t, CV_NORMAL) >= 0);
    const double error = std::hypot(value[0] - std::cos(10), value[1] + std::sin(10));
    CVodeFree(&cvode);
    SUNLinSolFree(linear);
    SUNMatDestroy(matrix);
    N_VDestroy(x);
    SUNContext_Free(&context);
    return error / tolerance;
  };
  const double bdf = tolerances();
  shown.check("1e-10 it errs by more than 100 tolerances", bdf > 100, bdf);
}
#endif
