#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

#include "chapters/03_rigid_body_motion/25_chain/models.hpp"

/// Chains of any number of links, in motion.
namespace oddity::chain {

/// The angles and their rates. Numbers is a vector of double or of counting numbers.
template <class Numbers>
struct Motion {
  Numbers theta, omega;
};

/// One step h of Runge-Kutta 4 with the accelerations from the rods' tensions. Work and memory are
/// proportional to the number of links.
template <class Numbers>
void runge_kutta_4(const Numbers& m, const Numbers& r, double g, Motion<Numbers>& x, double h) {
  const std::size_t n = m.size();
  Motion<Numbers> sum = x, at = x;
  Numbers alpha = x.theta;
  constexpr double weights[] = {1.0 / 6, 1.0 / 3, 1.0 / 3, 1.0 / 6}, parts[] = {0.5, 0.5, 1, 0};
  for (std::size_t stage = 0; stage < 4; ++stage) {
    by_tensions(m, r, g, at.theta, at.omega, alpha);
    for (std::size_t k = 0; k < n; ++k) {
      const double rate = at.omega[k];
      sum.theta[k] += h * weights[stage] * rate;
      sum.omega[k] += h * weights[stage] * alpha[k];
      at.theta[k] = x.theta[k] + h * parts[stage] * rate;
      at.omega[k] = x.omega[k] + h * parts[stage] * alpha[k];
    }
  }
  x = sum;
}

/// The largest zero of the Laguerre polynomial of degree n, by bisection. It is the largest eigenvalue of the
/// recurrence's matrix, with 2 k + 1 on the diagonal and k off it; eigenvalues below a number are counted.
/// Small oscillations of n equal links have squared angular frequencies of g/r times its zeros [Daniel
/// Bernoulli 1732; Szego, Orthogonal Polynomials, 1939, 6.31: below 4 n + 2].
inline double largest_laguerre_zero(int n) {
  const auto all_below = [n](double x) {
    double pivot = 1 - x;
    for (int k = 1; k < n && pivot < 0; ++k) pivot = 2 * k + 1 - x - static_cast<double>(k) * k / pivot;
    return pivot < 0;
  };
  double low = 0, high = 4.0 * n + 2;
  while (high - low > 1e-13 * high) (all_below((low + high) / 2) ? high : low) = (low + high) / 2;
  return high;
}

/// The largest step for which no small oscillation of n equal links grows under Runge-Kutta 4. It is stable
/// to h w = sqrt(8), and the fastest w is sqrt(g/r) times the root of that zero. In the limit h = sqrt(2 r/(n
/// g)).
inline double stable_step_of_links(int n, double g, double r) {
  return std::sqrt(8 * r / (g * largest_laguerre_zero(n)));
}

/// The factor by which small oscillations of n equal links grow in some steps of Runge-Kutta 4, from speeds
/// that excite every mode.
inline double growth_of_links(int n, double g, double r, double step, int steps) {
  using Numbers = std::vector<double>;
  const auto links = static_cast<std::size_t>(n);
  constexpr double little = 1e-30;  // so small that sines equal their angles and squares vanish
  const Numbers m(links, 1.0), lengths(links, r);
  Motion<Numbers> x{Numbers(links), Numbers(links)};
  for (std::size_t k = 0; k < links; ++k)
    x.omega[k] = little * (k % 2 == 0 ? 1 : -1) * (1.0 + static_cast<double>(k % 3));
  const auto size = [&] {
    double sum = 0;
    for (std::size_t k = 0; k < links; ++k)
      sum += g / r * static_cast<double>(links - k) * x.theta[k] * x.theta[k] + x.omega[k] * x.omega[k];
    return std::sqrt(sum);
  };
  const double before = size();
  for (int i = 0; i < steps; ++i) runge_kutta_4(m, lengths, g, x, step);
  return size() / before;
}

}  // namespace oddity::chain
