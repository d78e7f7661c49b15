#pragma once

// The models of exercise 3.25: n masses on massless rods that hang from a pivot at (0, h), theta_k the angle
// of rod k from the downward vertical, mu_k the mass from k on. Every formula is generic in its number type
// and in the containers of its angles (std::array or std::vector).

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <type_traits>
#include <vector>

#include "chapters/numbers.hpp"

namespace oddity::chain {

// ---- accelerations ----------------------------------------------------------------------------------------

/// theta'' from Newton's law for each mass and the rods' tensions: each rod's length, twice differentiated,
/// is a row of a tridiagonal system. Nine multiplications, four divisions, a sine and a cosine per link.
template <class Lengths, class Angles>
void by_tensions(const Lengths& m, const Lengths& r, double g, const Angles& theta, const Angles& omega,
                 Angles& alpha) {
  using std::cos, std::sin;
  using T = std::decay_t<decltype(theta[0])>;
  const std::size_t n = theta.size();
  const T gravity = static_cast<T>(g), one = static_cast<T>(1.0);
  Angles diagonal = theta, tension = theta, across = theta, light = theta;
  for (std::size_t k = 0; k < n; ++k) {
    light[k] = one / static_cast<T>(m[k]);
    diagonal[k] = k == 0 ? light[0] : light[k] + light[k - 1];
    tension[k] = static_cast<T>(r[k]) * omega[k] * omega[k];
    if (k == 0) {
      tension[0] += gravity * cos(theta[0]);
      continue;
    }
    const T turn = theta[k] - theta[k - 1], beside = light[k - 1] * cos(turn),
            factor = beside / diagonal[k - 1];
    across[k] = light[k - 1] * sin(turn);
    diagonal[k] -= factor * beside;
    tension[k] += factor * tension[k - 1];
    alpha[k] = beside;  // kept for the way back
  }
  for (std::size_t k = n; k-- > 0;) {
    if (k + 1 < n) tension[k] += alpha[k + 1] * tension[k + 1];
    tension[k] /= diagonal[k];
  }
  for (std::size_t k = 0; k < n; ++k) {
    T push = k == 0 ? -gravity * sin(theta[0]) : -tension[k - 1] * across[k];
    if (k + 1 < n) push += tension[k + 1] * across[k + 1];
    alpha[k] = push / static_cast<T>(r[k]);
  }
}

/// Row i of the dense equations, sum over j of M_ij theta_j'' = f_i: the pattern for n masses.
template <class Lengths, class Angles, class T>
void dense_row(std::size_t i, const Lengths& mu, const Lengths& r, double g, const Angles& theta,
               const Angles& omega, T* M, T& f) {
  using std::cos, std::sin;
  f = -static_cast<T>(mu[i] * g * r[i]) * sin(theta[i]);
  for (std::size_t j = 0; j < theta.size(); ++j) {
    const T weight = static_cast<T>(mu[std::max(i, j)] * r[i] * r[j]);
    const T turn = theta[i] - theta[j];
    M[j] = weight * cos(turn);
    f -= weight * sin(turn) * omega[j] * omega[j];
  }
}

/// theta'' from the dense mass matrix by Gauss's elimination: M is positive definite and needs no pivots.
template <std::size_t N, class T>
void by_mass_matrix(const std::array<double, N>& mu, const std::array<double, N>& r, double g,
                    const std::array<T, N>& theta, const std::array<T, N>& omega, std::array<T, N>& alpha) {
  std::array<std::array<T, N>, N> M;
  for (std::size_t i = 0; i < N; ++i) dense_row(i, mu, r, g, theta, omega, M[i].data(), alpha[i]);
  for (std::size_t k = 0; k < N; ++k)
    for (std::size_t i = k + 1; i < N; ++i) {
      const T factor = M[i][k] / M[k][k];
      for (std::size_t j = k + 1; j < N; ++j) M[i][j] -= factor * M[k][j];
      alpha[i] -= factor * alpha[k];
    }
  for (std::size_t i = N; i-- > 0;) {
    for (std::size_t j = i + 1; j < N; ++j) alpha[i] -= M[i][j] * alpha[j];
    alpha[i] /= M[i][i];
  }
}

// ---- the triple pendulum ----------------------------------------------------------------------------------

using Three = std::array<double, 3>;

struct Triple {
  Three m, r;
  double g, h;
  Three theta, omega;

  std::vector<double> inputs() const {
    std::vector<double> all;
    for (const Three& x : {m, r}) all.insert(all.end(), x.begin(), x.end());
    all.push_back(g);
    all.push_back(h);
    for (const Three& x : {theta, omega}) all.insert(all.end(), x.begin(), x.end());
    return all;
  }
};

/// (x1, y1, ..., x3, y3) of a state whose first three components are the angles.
template <class State>
auto positions(const Triple& c, const State& x) {
  using std::cos, std::sin;
  using T = std::decay_t<decltype(x[0])>;
  std::array<T, 6> all;
  T across = static_cast<T>(0.0), up = static_cast<T>(c.h);
  for (std::size_t k = 0; k < 3; ++k) {
    all[2 * k] = across += static_cast<T>(c.r[k]) * sin(x[k]);
    all[2 * k + 1] = up -= static_cast<T>(c.r[k]) * cos(x[k]);
  }
  return all;
}

/// The kinetic and the potential energy, the heights counted from the pivot.
inline auto energy(const Triple& c, const std::array<double, 6>& x) {
  double kinetic = 0, potential = 0, vx = 0, vy = 0, y = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    vx += c.r[k] * x[k + 3] * std::cos(x[k]);
    vy += c.r[k] * x[k + 3] * std::sin(x[k]);
    y -= c.r[k] * std::cos(x[k]);
    kinetic += c.m[k] * (vx * vx + vy * vy) / 2;
    potential += c.m[k] * c.g * y;
  }
  return energy_of(kinetic, potential);
}

enum class Equations { dense, tensions };

/// (theta1..3, theta1'..3') in any number type.
template <Equations how>
struct Angles : Triple {
  using State = std::array<double, 6>;
  State start() const { return {theta[0], theta[1], theta[2], omega[0], omega[1], omega[2]}; }
  template <class T, class Time>
  void operator()(const std::array<T, 6>& x, std::array<T, 6>& dxdt, const Time&) const {
    const std::array<T, 3> q{x[0], x[1], x[2]}, v{x[3], x[4], x[5]};
    std::array<T, 3> a{};
    if constexpr (how == Equations::dense)
      by_mass_matrix(Three{m[0] + m[1] + m[2], m[1] + m[2], m[2]}, r, g, q, v, a);
    else
      by_tensions(m, r, g, q, v, a);
    dxdt = {x[3], x[4], x[5], a[0], a[1], a[2]};
  }
  std::array<double, 6> observe(const State& x, double) const { return positions(*this, x); }
  auto conserved(const State& x, double) const { return energy(*this, x); }
};

}  // namespace oddity::chain
