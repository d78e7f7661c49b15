#pragma once

#include <cmath>

#include "solvers/gsl.hpp"
#include "solvers/solved.hpp"

namespace oddity {

namespace detail {

inline Solved<double> difference(double value, long evaluations) {
  Solved<double> slope{value, evaluations};
  if (!std::isfinite(value)) {
    slope.ending = Ending::non_finite;
    slope.message = "the difference is not finite";
  }
  return slope;
}

}  // namespace detail

/// f'(x) by central differences of step h. Truncation shrinks as h^2 (h^4), rounding grows as eps/h.
inline Solved<double> central_difference_2(FunctionOfOne f, double x, double h) {
  return detail::difference((f(x + h) - f(x - h)) / (2 * h), 2);
}
inline Solved<double> central_difference_4(FunctionOfOne f, double x, double h) {
  return detail::difference((8 * (f(x + h) - f(x - h)) - (f(x + 2 * h) - f(x - 2 * h))) / (12 * h), 4);
}

}  // namespace oddity
