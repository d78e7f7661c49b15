#pragma once

#include "solvers/gsl.hpp"
#include "solvers/solved.hpp"

namespace oddity {

/// f'(x) by central differences of step h. Truncation shrinks as h^2 (h^4), rounding grows as eps/h.
inline Solved<double> central_difference_2(FunctionOfOne f, double x, double h) {
  return {(f(x + h) - f(x - h)) / (2 * h), 2};
}
inline Solved<double> central_difference_4(FunctionOfOne f, double x, double h) {
  return {(8 * (f(x + h) - f(x - h)) - (f(x + 2 * h) - f(x - 2 * h))) / (12 * h), 4};
}

}  // namespace oddity
