#include "solvers/roots.hpp"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_roots.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>

namespace oddity {

namespace {

Solved<double> failed(Solved<double> root, Ending ending, std::string message) {
  root.ending = ending;
  root.message = std::move(message);
  return root;
}

}  // namespace

Solved<double> brent(FunctionOfOne f, double a, double b, double tolerance) {
  disable_gsl_abort();
  if (b < a) std::swap(a, b);
  double size_at_ends = 0;
  const auto watched = [&](double x) {
    const double y = f(x);
    if (x == a || x == b) size_at_ends = std::max(size_at_ends, std::abs(y));
    return y;
  };
  CountedFunction counted{watched};
  gsl_function function{&CountedFunction::call, &counted};
  const std::unique_ptr<gsl_root_fsolver, Free<gsl_root_fsolver_free>> solver(
      allocated(gsl_root_fsolver_alloc(gsl_root_fsolver_brent)));
  Solved<double> root{std::numeric_limits<double>::quiet_NaN()};
  const int set = gsl_root_fsolver_set(solver.get(), &function, a, b);
  counted.rethrow();
  if (set != GSL_SUCCESS) {
    root.evaluations = counted.calls;
    return failed(root, Ending::raised, std::string("no bracket: ") + gsl_strerror(set));
  }
  for (int i = 0; i < 200; ++i) {
    const int status = gsl_root_fsolver_iterate(solver.get());
    counted.rethrow();
    const double low = gsl_root_fsolver_x_lower(solver.get());
    const double high = gsl_root_fsolver_x_upper(solver.get());
    root.value = gsl_root_fsolver_root(solver.get());
    root.evaluations = counted.calls;
    root.error_estimate = high - low;
    if (status != GSL_SUCCESS) return failed(root, Ending::raised, gsl_strerror(status));
    if (!(high - low <= tolerance) && std::nextafter(low, high) < high) continue;
    if (low == high) return root;
    const double miss = watched(root.value);
    ++root.evaluations;
    if (std::abs(miss) <= size_at_ends) return root;
    return failed(root, Ending::raised, "f changes its sign at a pole and not at a root");
  }
  return failed(root, Ending::stalled, "the bracket is still wider than the tolerance after 200 iterations");
}

}  // namespace oddity
