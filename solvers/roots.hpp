#pragma once

#include "solvers/gsl.hpp"
#include "solvers/solved.hpp"

namespace oddity {

/// A root of f in [a, b] by GSL's Brent-Dekker, f being continuous and f(a) and f(b) of opposite sign (or
/// zero). Ends when the bracket is no wider than `tolerance` or holds no number inside; its width is the
/// error estimate. `raised` when there is no bracket, when f is not finite, or when the sign changes at a
/// pole; `stalled` after 200 iterations. A jump across zero counts as a root.
Solved<double> brent(FunctionOfOne f, double a, double b, double tolerance);

}  // namespace oddity
