// Empty if CMake did not find SUNDIALS.
#ifdef ODDITY_SUNDIALS

#include "solvers/ode/sundials_driver.hpp"

#include <arkode/arkode_erkstep.h>
#include <cvode/cvode.h>
#include <nvector/nvector_serial.h>
#include <sunlinsol/sunlinsol_dense.h>
#include <sunmatrix/sunmatrix_dense.h>
#include <sunnonlinsol/sunnonlinsol_fixedpoint.h>

#include <algorithm>
#include <exception>
#include <limits>
#include <new>
#include <vector>

namespace oddity::ode::detail {

namespace {

/// SUNDIALS stops at a negative status, and shortens the step at a positive one.
int status_of(Call call) { return call == Call::ok ? 0 : call == Call::not_finite ? 1 : -1; }

using Guarded = GuardedProblem<status_of>;

int rhs(double t, N_Vector x, N_Vector dxdt, void* guarded) {
  return static_cast<Guarded*>(guarded)->call([&](const RawProblem& p) {
    return p.rhs(p.object, N_VGetArrayPointer(x), N_VGetArrayPointer(dxdt), t);
  });
}

int jacobian(double t, N_Vector x, N_Vector, SUNMatrix matrix, void* guarded, N_Vector, N_Vector, N_Vector) {
  return static_cast<Guarded*>(guarded)->call([&](const RawProblem& p) {
    std::vector<double> rows(p.n * p.n);
    const Call call = p.jacobian(p.object, N_VGetArrayPointer(x), rows.data(), nullptr, t);
    for (std::size_t i = 0; i < p.n; ++i)
      for (std::size_t j = 0; j < p.n; ++j)
        SUNDenseMatrix_Column(matrix, static_cast<long>(j))[i] = rows[i * p.n + j];
    return call;
  });
}

void silent(int, const char*, const char*, char*, void*) {}

template <class T>
T* made(T* object) {
  if (!object) throw std::bad_alloc();
  return object;
}

/// The method of SUNDIALS's table with the end of the step as one more stage. ERKStep (6.4) takes the last
/// stage at the end of the step for the next step's first. In Verner's method that stage is a different
/// state, which reduces the order from 6 to 3 (llnl/sundials#311). The added stage is the end itself, and
/// costs nothing.
ARKodeButcherTable with_its_end(ARKODE_ERKTableID id) {
  const ARKodeButcherTable given = made(ARKodeButcherTable_LoadERK(id));
  const int stages = given->stages;
  const ARKodeButcherTable table = made(ARKodeButcherTable_Alloc(stages + 1, SUNTRUE));
  table->q = given->q;
  table->p = given->p;
  for (int i = 0; i < stages; ++i) {
    std::copy_n(given->A[i], stages, table->A[i]);
    table->A[stages][i] = given->b[i];
  }
  std::copy_n(given->b, stages, table->b);
  std::copy_n(given->c, stages, table->c);
  std::copy_n(given->d, stages, table->d);
  table->c[stages] = 1;
  ARKodeButcherTable_Free(given);
  return table;
}

}  // namespace

struct SundialsDriver::Driver {
  SundialsMethod method;
  std::size_t n;
  double tolerance;
  SUNContext context = nullptr;
  N_Vector x = nullptr;
  SUNMatrix matrix = nullptr;
  SUNLinearSolver linear = nullptr;
  SUNNonlinearSolver nonlinear = nullptr;
  void* memory = nullptr;
  double direction = 0;
  Guarded guarded = {};

  Driver(SundialsMethod m, std::size_t unknowns, double tol) : method(m), n(unknowns), tolerance(tol) {
    SUNContext_Create(nullptr, &context);
    x = made(N_VNew_Serial(static_cast<long>(n), context));
  }
  ~Driver() {
    if (cvode())
      CVodeFree(&memory);
    else if (memory)
      ERKStepFree(&memory);
    if (nonlinear) SUNNonlinSolFree(nonlinear);
    if (linear) SUNLinSolFree(linear);
    if (matrix) SUNMatDestroy(matrix);
    N_VDestroy(x);
    SUNContext_Free(&context);
  }
  Driver(const Driver&) = delete;

  bool cvode() const { return method == SundialsMethod::adams || method == SundialsMethod::bdf; }

  /// Starts at t with the state in x; called again whenever time is reversed.
  void start(double t) {
    if (!cvode())
      start_erkstep(t);
    else if (memory)
      CVodeReInit(memory, t, x);
    else
      start_cvode(t);
  }

  /// Created again each time: ERKStepReInit does not reverse time.
  void start_erkstep(double t) {
    if (memory) ERKStepFree(&memory);
    memory = made(ERKStepCreate(rhs, t, x, context));
    ERKStepSetErrHandlerFn(memory, silent, nullptr);
    ERKStepSStolerances(memory, tolerance, tolerance);
    const ARKodeButcherTable table = method == SundialsMethod::verner
                                         ? with_its_end(ARKODE_VERNER_8_5_6)
                                         : made(ARKodeButcherTable_LoadERK(ARKODE_ZONNEVELD_5_3_4));
    ERKStepSetTable(memory, table);
    ARKodeButcherTable_Free(table);
  }

  void start_cvode(double t) {
    const bool stiff = method == SundialsMethod::bdf;
    memory = made(CVodeCreate(stiff ? CV_BDF : CV_ADAMS, context));
    CVodeSetErrHandlerFn(memory, silent, nullptr);
    CVodeInit(memory, rhs, t, x);
    CVodeSStolerances(memory, tolerance, tolerance);
    if (stiff) {
      const auto size = static_cast<long>(n);
      matrix = made(SUNDenseMatrix(size, size, context));
      linear = made(SUNLinSol_Dense(x, matrix, context));
      CVodeSetLinearSolver(memory, linear, matrix);
      CVodeSetJacFn(memory, jacobian);
    } else {
      nonlinear = made(SUNNonlinSol_FixedPoint(x, 0, context));
      CVodeSetNonlinearSolver(memory, nonlinear);
    }
  }
};

SundialsDriver::SundialsDriver(SundialsMethod method, std::size_t n, double tolerance)
    : driver_(new Driver(method, n, tolerance)) {}
SundialsDriver::~SundialsDriver() = default;
SundialsDriver::SundialsDriver(SundialsDriver&&) noexcept = default;

const char* SundialsDriver::advance(const RawProblem& problem, double* x, double& t, double t1) {
  Driver& driver = *driver_;
  driver.guarded = {&problem};
  double* state = N_VGetArrayPointer(driver.x);
  if ((t1 - t) * driver.direction <= 0) {
    driver.direction = t1 - t;
    std::copy_n(x, driver.n, state);
    driver.start(t);
  }
  const auto step = [&](auto set_problem, auto set_stop, auto evolve, int one_step) {
    set_problem(driver.memory, &driver.guarded);
    const int status = set_stop(driver.memory, t1);
    return status < 0 ? status : evolve(driver.memory, t1, driver.x, &t, one_step);
  };
  const int status = driver.cvode()
                         ? step(CVodeSetUserData, CVodeSetStopTime, CVode, CV_ONE_STEP)
                         : step(ERKStepSetUserData, ERKStepSetStopTime, ERKStepEvolve, ARK_ONE_STEP);
  driver.guarded.rethrow();
  std::copy_n(state, driver.n, x);
  return status >= 0 ? nullptr : "SUNDIALS found no step small enough";
}

void SundialsDriver::plain_step(const RawProblem& problem, double* x, double t, double h) {
  Driver& driver = *driver_;
  driver.guarded = {&problem};
  double* state = N_VGetArrayPointer(driver.x);
  std::copy_n(x, driver.n, state);
  driver.start(t);
  ERKStepSetUserData(driver.memory, &driver.guarded);
  ERKStepSetFixedStep(driver.memory, h);
  const int status = ERKStepEvolve(driver.memory, t + h, driver.x, &t, ARK_ONE_STEP);
  driver.guarded.rethrow();
  std::copy_n(state, driver.n, x);
  if (status < 0) x[0] = std::numeric_limits<double>::quiet_NaN();
}

}  // namespace oddity::ode::detail

#endif
