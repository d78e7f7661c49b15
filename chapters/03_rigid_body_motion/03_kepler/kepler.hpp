#pragma once

#include <boost/math/special_functions/gamma.hpp>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

#include "chapters/03_rigid_body_motion/03_kepler/models.hpp"
#include "chapters/exercise.hpp"
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

/// The terms of the series in Bessel functions decrease as the powers of this number [Watson, Bessel
/// Functions, 1944, 8.7].
inline double power_of_terms(double e) {
  const double root = std::sqrt((1 - e) * (1 + e));
  return e * std::exp(root) / (1 + root);
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

/// The power series in e: E = M + sum of e^n/n! d^(n-1)/dM^(n-1) sin^n M, with the powers of the sine as sums
/// of sines. Converges for all M only up to laplace_limit().
inline Solved<double> lagrange_series(double e, double M, int terms) {
  double E = M;
  const auto log_factorial = [](int n) { return boost::math::lgamma(n + 1.0); };
  for (int n = 1; n <= terms; ++n)
    for (int k = 0; 2 * k < n; ++k) {
      const double size = n * std::log(e) - (n - 1) * std::numbers::ln2 + (n - 1) * std::log(n - 2 * k) -
                          log_factorial(k) - log_factorial(n - k);
      E += (k % 2 ? -1 : 1) * std::exp(size) * std::sin((n - 2 * k) * M);
    }
  return {E, static_cast<long>(terms) * (terms + 1) / 2};
}

// ---- the claims of exercise 3.3 ---------------------------------------------------------------------------

/// Checked on random orbits.
std::vector<Claim> claims(double seed);
std::vector<Root> roots();

// Tactics and lemmas of in_coq.cpp: a moment's distance, the characteristic roots, a circle, bounds; then
// motion by Newton's law and the constants of its path, an ellipse and its turn, the time by the angle.
extern const char* const by_distance;
extern const char* const by_factors;
extern const char* const by_circle;
extern const char* const by_bounds;
extern const char* const orbits_in_coq;
std::string turns_in_coq();
std::string times_in_coq();

}  // namespace oddity::kepler
