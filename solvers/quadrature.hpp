#pragma once

#include <functional>
#include <vector>

#include "solvers/gsl.hpp"
#include "solvers/solved.hpp"

/// Integrals over a finite interval. The adaptive rules take one tolerance, absolute and relative (the larger
/// counts). They end `raised` with GSL's message if it reports an error. They end `stalled` if their estimate
/// stays above the tolerance, even where GSL calls that a success, and `non_finite` if the result is not
/// finite.
///
///   const Integral area = qags([](double x) { return 1 / std::sqrt(x); }, 0, 1, 1e-10);
///   if (area.reached()) std::cout << area.value << " +- " << area.error_estimate;  // 2
namespace oddity {

using Integral = Solved<double>;

/// Adaptive Gauss-Kronrod, 21 points. For smooth or mildly difficult integrands.
Integral qag(FunctionOfOne f, double a, double b, double tolerance);
/// Adaptive Gauss-Kronrod with Wynn's epsilon extrapolation. For integrable singularities, preferably at the
/// ends.
Integral qags(FunctionOfOne f, double a, double b, double tolerance);
/// QAGS with known points of difficulty: `points` are the ends and the points between, ascending.
Integral qagp(FunctionOfOne f, std::vector<double> points, double tolerance);
/// Doubly adaptive Clenshaw-Curtis. Evaluates the ends. Leaves out points where f is infinite, and ends where
/// it is NaN. A NaN inside ends `non_finite`, a million evaluations `stalled`.
Integral cquad(FunctionOfOne f, double a, double b, double tolerance);

/// Fixed Gauss-Legendre with n >= 1 points: exact for polynomials up to degree 2n-1. No error estimate.
Integral gauss_legendre(FunctionOfOne f, double a, double b, int points);
/// Composite Simpson with an even number of panels, error C h^4. Evaluates the ends. No error estimate.
Integral simpson(FunctionOfOne f, double a, double b, int panels);
/// Composite trapezoid, error C h^2. Evaluates the ends. No error estimate.
Integral trapezoid(FunctionOfOne f, double a, double b, int panels);

/// A rule with its setting bound: integrates f over [a, b].
using Rule = std::function<Integral(FunctionOfOne f, double a, double b)>;
using Bound = std::function<double(double)>;

/// The integral of f(x, y) over a <= x <= b, low(x) <= y <= high(x), the rule nested in itself.
Integral nested(const Rule& rule, const std::function<double(double, double)>& f, double a, double b,
                const Bound& low, const Bound& high);

/// The integral of f(x, y, z) over a <= x <= b, low(x) <= y <= high(x), bottom(x, y) <= z <= top(x, y).
Integral nested(const Rule& rule, const std::function<double(double, double, double)>& f, double a, double b,
                const Bound& low, const Bound& high, const std::function<double(double, double)>& bottom,
                const std::function<double(double, double)>& top);

}  // namespace oddity
