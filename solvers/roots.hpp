#pragma once

#include "solvers/gsl.hpp"
#include "solvers/solved.hpp"

namespace oddity {

/// A root of f in [a, b] by GSL's Brent-Dekker, f(a) and f(b) being of opposite sign (or zero). Ends when the
/// bracket is narrower than `tolerance`, which is also the error estimate; `raised` when there is no bracket,
/// `stalled` after 200 iterations.
Solved<double> brent(FunctionOfOne f, double a, double b, double tolerance);

}  // namespace oddity
