#pragma once

#include <cstddef>
#include <exception>

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

/// A problem on its way through C, which an exception must not pass through: it is kept for later.
/// `status_of` is what the library calls a Call; a throw ends it as a spent budget does.
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
/// dfdt unless it is null. The first call that was not ok ends it.
Call differences(const RawProblem& problem, const double* x, double* matrix, double* dfdt, double t);

}  // namespace oddity::ode::detail
