#pragma once

#include "solvers/gsl.hpp"
#include "solvers/solved.hpp"

/// Roots of a function of one number.
///
///   const Solved<double> root = brent([](double x) { return std::cos(x) - x; }, 0, 1, 1e-12);
///   if (root.reached()) std::cout << root.value;  // 0.739085
namespace oddity {

/// A root of f in [a, b] by GSL's Brent-Dekker, for continuous f with f(a) and f(b) of opposite sign (or
/// zero). Ends when the bracket is no wider than `tolerance` or contains no number inside; its width is the
/// error estimate. `raised` if there is no bracket, f is not finite, or the sign changes at a pole; `stalled`
/// after 200 iterations. A jump across zero counts as a root.
Solved<double> brent(FunctionOfOne f, double a, double b, double tolerance);

}  // namespace oddity
