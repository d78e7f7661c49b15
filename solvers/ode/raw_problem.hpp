#pragma once

#include <cstddef>

/// The seam between templates and the libraries that are compiled on their own: raw pointers. C++17, as
/// implicit.cpp is.
namespace oddity::ode::detail {

/// What a library is told of a call of the right-hand side.
enum class Call { ok, not_finite, budget_spent };

/// An initial value problem of n unknowns. `jacobian` fills d(dxdt)/dx by rows and, unless it is null,
/// d(dxdt)/dt.
struct RawProblem {
  std::size_t n;
  const void* object;
  Call (*rhs)(const void* object, const double* x, double* dxdt, double t);
  Call (*jacobian)(const void* object, const double* x, double* matrix, double* dfdt, double t);
};

/// The Jacobian of problem.rhs by central differences, good to ten digits: 2 n evaluations, and two more for
/// dfdt unless it is null. The first call that was not ok ends it.
Call differences(const RawProblem& problem, const double* x, double* matrix, double* dfdt, double t);

}  // namespace oddity::ode::detail
