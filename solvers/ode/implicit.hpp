#pragma once

#include <cstddef>
#include <memory>

/// Odeint's implicit steppers keep their states in uBLAS and compile only as C++17 (with Boost 1.74). This is
/// the seam: raw pointers on this side, Odeint behind it in implicit.cpp.
namespace oddity::ode::detail {

/// An initial value problem of n unknowns; `jacobian` fills d(dxdt)/dx by rows, and d(dxdt)/dt.
struct ImplicitProblem {
  std::size_t n;
  const void* object;
  void (*rhs)(const void* object, const double* x, double* dxdt, double t);
  void (*jacobian)(const void* object, const double* x, double* matrix, double* dfdt, double t);
};

/// Rosenbrock's method of order 4 with Odeint's step control.
class Rosenbrock {
 public:
  Rosenbrock(std::size_t n, double tolerance);
  ~Rosenbrock();
  Rosenbrock(Rosenbrock&&) noexcept;

  /// Whether the step was accepted; x, t and h are Odeint's to change.
  bool try_step(const ImplicitProblem&, double* x, double& t, double& h);

 private:
  struct Stepper;
  std::unique_ptr<Stepper> stepper_;
};

/// One step of the backward Euler method, its equation solved by one Newton step. Odeint would iterate, but
/// from the second iteration on it factorizes the matrix that it has factorized before.
void implicit_euler_step(const ImplicitProblem&, double* x, double t, double h);

}  // namespace oddity::ode::detail
