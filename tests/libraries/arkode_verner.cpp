#ifdef ODDITY_SUNDIALS
#include <arkode/arkode_erkstep.h>
#include <nvector/nvector_serial.h>

#include <cmath>

#include "report/verify/catch.hpp"
#include "tests/libraries/shown.hpp"

TEST_CASE("ARKODE's Verner has order 3", "[libraries]") {
  const Shown shown{"arkode_verner", SUNDIALS_VERSION};
  const auto error = [](int n) {
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
    void* erk = ERKStepCreate(oscillator, 0, x, context);
    ERKStepSetTableNum(erk, ARKODE_VERNER_8_5_6);
    ERKStepSetFixedStep(erk, 5.0 / n);
    ERKStepSetStopTime(erk, 5);
    double t = 0;
    CHECK(ERKStepEvolve(erk, 5, x, &t, ARK_NORMAL) >= 0);
    const double missed = std::hypot(value[0] - std::cos(5), value[1] + std::sin(5));
    ERKStepFree(&erk);
    N_VDestroy(x);
    SUNContext_Free(&context);
    return missed;
  };
  const double order = std::log2(error(64) / error(128));
  shown.check("has order 3 of 6", std::abs(order - 3) < 0.2, order);
}
#endif
