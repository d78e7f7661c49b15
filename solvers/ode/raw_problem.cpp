#include "solvers/ode/raw_problem.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace oddity::ode::detail {

Call differences(const RawProblem& problem, const double* x, double* matrix, double* dfdt, double t) {
  constexpr double relative = 6e-6;  // the cube root of rounding
  const std::size_t n = problem.n;
  std::vector<double> y(x, x + n), above(n), below(n);
  const auto rhs = [&](std::vector<double>& dxdt, double time) {
    return problem.rhs(problem.object, y.data(), dxdt.data(), time);
  };
  for (std::size_t column = 0; column < n; ++column) {
    const double here = x[column], h = relative * std::max(1.0, std::abs(here));
    const double high = here + h, low = here - h;
    y[column] = high;
    if (const Call call = rhs(above, t); call != Call::ok) return call;
    y[column] = low;
    if (const Call call = rhs(below, t); call != Call::ok) return call;
    y[column] = here;
    for (std::size_t i = 0; i < n; ++i) matrix[i * n + column] = (above[i] - below[i]) / (high - low);
  }
  if (!dfdt) return Call::ok;
  const double h = std::max(relative, 1e-10 * std::abs(t)), high = t + h, low = t - h;
  if (const Call call = rhs(above, high); call != Call::ok) return call;
  if (const Call call = rhs(below, low); call != Call::ok) return call;
  for (std::size_t i = 0; i < n; ++i) dfdt[i] = (above[i] - below[i]) / (high - low);
  return Call::ok;
}

}  // namespace oddity::ode::detail
