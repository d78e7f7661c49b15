#pragma once

#include <cstddef>
#include <exception>

/// Interface of raw pointers between templates and the libraries that are compiled separately. C++17, as
/// implicit.cpp is.
namespace oddity::ode::detail {

/// Outcome of a call of the right-hand side.
enum class Call { ok, not_finite, budget_spent };

/// An initial value problem of n unknowns. `jacobian` fills d(dxdt)/dx by rows and, unless it is null,
/// d(dxdt)/dt.
struct RawProblem {
  std::size_t n;
  const void* object;
  Call (*rhs)(const void* object, const double* x, double* dxdt, double t);
  Call (*jacobian)(const void* object, const double* x, double* matrix, double* dfdt, double t);
};

/// A problem that is called through C, which exceptions must not cross: they are kept for later. `status_of`
/// gives the library's status for a Call; an exception ends the integration like a spent budget.
template <int (*status_of)(Call)>
struct GuardedProblem {
  const RawProblem* problem = nullptr;
  std::exception_ptr thrown = {};

  template <class F>
  int call(const F& f) noexcept {
    try {
      return status_of(f(*problem));
    } catch (...) {
      thrown = std::current_exception();
      return status_of(Call::budget_spent);
    }
  }
  void rethrow() const {
    if (thrown) std::rethrow_exception(thrown);
  }
};

/// The Jacobian of problem.rhs by central differences, good to ten digits: 2 n evaluations, and two more for
/// dfdt unless it is null. Stops at the first call that is not ok.
Call differences(const RawProblem& problem, const double* x, double* matrix, double* dfdt, double t);

}  // namespace oddity::ode::detail
