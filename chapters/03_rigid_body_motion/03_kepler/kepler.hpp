#pragma once

#include <algorithm>
#include <boost/math/special_functions/gamma.hpp>
#include <cmath>
#include <complex>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

#include "chapters/03_rigid_body_motion/03_kepler/models.hpp"
#include "chapters/exercise.hpp"
#include "chapters/foreseen.hpp"
#include "solvers/roots.hpp"
#include "solvers/solved.hpp"

/// Methods to solve Kepler's equation.
namespace oddity::kepler {

using Start = Given<double>;

/// G times the mass of the sun, in AU^3/yr^2.
inline constexpr double four_pi_squared = 39.47841760435743;
/// Initial conditions of the scenes.
inline constexpr Start near_earth{four_pi_squared, 1, 1, 0.09375, 1.75, 6.25};
inline constexpr Start eccentric{four_pi_squared, 1, 1.75, 1.7862, -2, 0.8943};
inline constexpr Start very_eccentric{four_pi_squared, 2, 1.75, -3.28124, 0.75, 0.409303};

/// Throws std::domain_error unless the orbit is an ellipse.
inline Ellipse<double> ellipse(const Start& start) {
  if (!(start.energy() < 0)) throw std::domain_error("the orbit is no ellipse: the start is too fast");
  return Ellipse<double>(start);
}

// ---- Kepler's equation E - e sin E = M, 0 <= M <= pi ------------------------------------------------------

/// Newton's method from E0; `stalled` if the last of this many corrections is not small.
inline Solved<double> by_newton(double e, double M, double E0, int iterations) {
  const auto found = newton(e, M, E0, iterations);
  Solved<double> E{found.E, found.corrections};
  if (found.settled) return E;
  E.ending = Ending::stalled;
  E.message = "Newton's method has not settled";
  return E;
}

/// E <- M + e sin E; each iteration multiplies its error by e cos E.
inline Solved<double> fixed_point(double e, double M, int iterations) {
  double E = M;
  for (int i = 0; i < iterations; ++i) E = M + e * std::sin(E);
  return {E, iterations};
}

/// The root is between M and M + e for 0 <= M <= pi.
inline Solved<double> bracketed(double e, double M, double tolerance) {
  return brent([=](double E) { return E - e * std::sin(E) - M; }, M, M + e, tolerance);
}

/// E = M + sum of (2/n) J_n(n e) sin(n M) [Watson, Theory of Bessel Functions, 17.2].
inline Solved<double> bessel_series(double e, double M, int terms) {
  double E = M;
  for (int n = 1; n <= terms; ++n) E += 2.0 / n * std::cyl_bessel_j(n, n * e) * std::sin(n * M);
  return {E, terms};
}

/// Error of fixed_point(), which each iteration multiplies by e cos E, between M and the root.
inline Estimate error_of_fixed_point(double e, double M, double root, int iterations) {
  const double first = std::cos(M), last = std::cos(root);
  const auto after = [&](double cosine) {
    return std::abs(root - M) * std::pow(e * std::abs(cosine), iterations);
  };
  return {first * last > 0 ? after(std::min(std::abs(first), std::abs(last))) / 2 : 0, after(last),
          2 * after(std::max(std::abs(first), std::abs(last)))};
}

/// The terms of the series in Bessel functions decrease as the powers of this number [Watson, Bessel
/// Functions, 1944, 8.7].
inline double power_of_terms(double e) {
  const double root = std::sqrt((1 - e) * (1 + e));
  return e * std::exp(root) / (1 + root);
}

/// Error of bessel_series(): J_n(n e) is at most about power_of_terms(e)^n/sqrt(2 pi n sqrt(1 - e^2)), and
/// the sines of n M may be zero.
inline Estimate error_of_bessel_series(double e, double M, int terms) {
  const double n = terms + 1, power = power_of_terms(e);
  const double rest = std::sqrt(2 / std::numbers::pi) * std::pow(power, n) * std::pow(n, -1.5) *
                      std::pow((1 - e) * (1 + e), -0.25) /
                      std::sqrt(1 - 2 * power * std::cos(M) + power * power);
  return {0, rest, 3 * rest};
}

/// The eccentricity up to which the power series in e converges for all M, where e exp(root)/(1 + root) = 1
/// with root = sqrt(1 + e^2).
inline double laplace_limit() {
  double below = 0, above = 1;
  while (true) {
    const double e = (below + above) / 2, root = std::sqrt(1 + e * e);
    if (e == below || e == above) return e;
    (e * std::exp(root) < 1 + root ? below : above) = e;
  }
}

/// The eccentricity nearest to zero, a complex one, at which E is singular for this M: there 1 = e cos E, and
/// so E - tan E = M. Up to its size the power series in e converges.
inline std::complex<double> singular_eccentricity(double M) {
  constexpr double middle = std::numbers::pi / 2;
  constexpr int ways = 200, corrections = 8;
  std::complex<double> E(middle, 1.2);  // near the solution of the middle M, and led from there
  for (int way = 0; way <= ways; ++way)
    for (int i = 0; i < corrections; ++i) {
      const auto tangent = std::tan(E);
      E += (E - tangent - (middle + (M - middle) * way / ways)) / (tangent * tangent);
    }
  return 1.0 / std::cos(E);
}

/// The logarithm of a term of the power series, without its sine: of e^n, and of the sine of n - 2k times M.
inline double log_of_term(double e, int n, int k) {
  const auto log_factorial = [](int i) { return boost::math::lgamma(i + 1.0); };
  return n * std::log(e) - (n - 1) * std::numbers::ln2 + (n - 1) * std::log(n - 2 * k) - log_factorial(k) -
         log_factorial(n - k);
}

/// The power series in e: E = M + sum of e^n/n! d^(n-1)/dM^(n-1) sin^n M, with the powers of the sine as sums
/// of sines. Converges for all M only up to laplace_limit().
inline Solved<double> lagrange_series(double e, double M, int terms) {
  double E = M;
  for (int n = 1; n <= terms; ++n)
    for (int k = 0; 2 * k < n; ++k)
      E += (k % 2 ? -1 : 1) * std::exp(log_of_term(e, n, k)) * std::sin((n - 2 * k) * M);
  return {E, static_cast<long>(terms) * (terms + 1) / 2};
}

/// Error of lagrange_series(), from the first term left out. The coefficients of a square root at the
/// singular eccentricity s and its conjugate are about i/sqrt(2 pi) n^(-3/2) s^-n. The roundings are those of
/// the largest terms, which cancel.
inline Estimate error_of_lagrange_series(double e, double M, int terms) {
  constexpr double next_order = 0.1, roundings = 10;
  const int n = terms + 1;
  const std::complex<double> ratio = e / singular_eccentricity(M),
                             rest = std::complex<double>(0, std::sqrt(2 / std::numbers::pi)) *
                                    std::pow(n, -1.5) * std::pow(ratio, n) / (1.0 - ratio);
  double rounded = 0;
  for (int i = 1; i <= terms; ++i)
    for (int k = 0; 2 * k < i; ++k) rounded = std::max(rounded, 0x1p-53 * i * std::exp(log_of_term(e, i, k)));
  const double size = std::abs(rest.real()), unsure = next_order * std::abs(rest) + roundings * rounded;
  return {std::max(0.0, size - unsure), size + rounded, size + unsure};
}

// ---- the claims of exercise 3.3 ---------------------------------------------------------------------------

/// Checked on random orbits.
std::vector<Claim> claims(double seed);
Provables proofs();
std::vector<Root> roots();

// Tactics of tactics.cpp: a moment's distance, the characteristic roots, a circle, bounds.
extern const char* const by_distance;
extern const char* const by_factors;
extern const char* const by_circle;
extern const char* const by_bounds;

}  // namespace oddity::kepler
