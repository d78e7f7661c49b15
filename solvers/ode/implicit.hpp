#pragma once

#include <memory>

#include "solvers/ode/raw_problem.hpp"

/// Odeint's implicit steppers keep their states in uBLAS and compile only as C++17 (with Boost 1.74). Only
/// implicit.cpp includes them.
namespace oddity::ode::detail {

/// Rosenbrock's method of order 4 with Odeint's step control.
class Rosenbrock {
 public:
  Rosenbrock(std::size_t n, double tolerance);
  ~Rosenbrock();
  Rosenbrock(Rosenbrock&&) noexcept;

  /// Whether the step was accepted. Odeint updates x, t and h.
  bool try_step(const RawProblem&, double* x, double& t, double& h);

 private:
  struct Stepper;
  std::unique_ptr<Stepper> stepper_;
};

/// One step of the backward Euler method, its equation solved by one Newton step. Odeint could iterate, but
/// from the second iteration on it factorizes a matrix that is already factorized.
void implicit_euler_step(const RawProblem&, double* x, double t, double h);

}  // namespace oddity::ode::detail
