#pragma once

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <tuple>
#include <type_traits>

#include "chapters/modes.hpp"
#include "chapters/numbers.hpp"

/// The models of exercise 3.25: n masses on massless rods that hang from a pivot at (0, h). Rod k has the
/// angle theta_k from the downward vertical, and mu_k is the mass from k on.
namespace oddity::chain {

// ---- accelerations, for any containers of the constants and of the angles ---------------------------------

/// r theta'' from Newton's law for each mass and the rods' tensions. The second derivative of each rod's
/// length is a row of a tridiagonal system.
template <class Numbers, class Lengths, class G, class Angles>
void across_by_tensions(const Numbers& inverse_mass, const Lengths& r, const G& g, const Angles& theta,
                        const Angles& omega, Angles& alpha) {
  using X = std::decay_t<decltype(theta[0])>;
  const std::size_t n = theta.size();
  const X gravity = X(g);
  // Sines and cosines first, so that all later values stay in registers if n is known.
  Angles normal = theta;
  const X across = -gravity * sin(theta[0]), along = gravity * cos(theta[0]);
  for (std::size_t k = 1; k < n; ++k) {
    const X turn = theta[k] - theta[k - 1];
    normal[k] = inverse_mass[k - 1] * sin(turn);
    alpha[k] = inverse_mass[k - 1] * cos(turn);  // couples k to its predecessor
  }
  Angles diagonal = theta, tension = theta;
  diagonal[0] = X(inverse_mass[0]);
  tension[0] = X(r[0]) * omega[0] * omega[0] + along;
  for (std::size_t k = 1; k < n; ++k) {
    const X factor = alpha[k] / diagonal[k - 1];
    diagonal[k] = X(inverse_mass[k] + inverse_mass[k - 1]) - factor * alpha[k];
    tension[k] = X(r[k]) * omega[k] * omega[k] + factor * tension[k - 1];
  }
  for (std::size_t k = n; k-- > 0;) {
    if (k + 1 < n) tension[k] += alpha[k + 1] * tension[k + 1];
    tension[k] /= diagonal[k];
  }
  for (std::size_t k = 0; k < n; ++k) {
    alpha[k] = k == 0 ? across : -tension[k - 1] * normal[k];
    if (k + 1 < n) alpha[k] += tension[k + 1] * normal[k + 1];
  }
}

/// theta'' by the tensions: nine multiplications, four divisions, a sine and a cosine per link.
template <class Lengths, class G, class Angles>
void by_tensions(const Lengths& m, const Lengths& r, const G& g, const Angles& theta, const Angles& omega,
                 Angles& alpha) {
  using X = std::decay_t<decltype(theta[0])>;
  Angles inverse_mass = theta;
  for (std::size_t k = 0; k < theta.size(); ++k) inverse_mass[k] = X(1) / X(m[k]);
  across_by_tensions(inverse_mass, r, g, theta, omega, alpha);
  for (std::size_t k = 0; k < theta.size(); ++k) alpha[k] /= X(r[k]);
}

/// Row i of the dense equations, sum over j of M_ij theta_j'' = f_i: the pattern for n masses.
template <class Lengths, class G, class Angles, class X>
void dense_row(std::size_t i, const Lengths& mu, const Lengths& r, const G& g, const Angles& theta,
               const Angles& omega, X* M, X& f) {
  f = -X(mu[i] * g * r[i]) * sin(theta[i]);
  for (std::size_t j = 0; j < theta.size(); ++j) {
    const X weight = X(mu[std::max(i, j)] * r[i] * r[j]);
    const X turn = theta[i] - theta[j];
    M[j] = weight * cos(turn);
    f -= weight * sin(turn) * omega[j] * omega[j];
  }
}

/// theta'' from the dense mass matrix by Gaussian elimination. M is positive definite and needs no pivoting;
/// only its upper half is stored. A sine and a cosine per link; those of differences follow by the addition
/// theorem.
template <std::size_t n, class T, class X>
void by_mass_matrix(const std::array<T, n>& mu, const std::array<T, n>& r, const T& g,
                    const std::array<X, n>& theta, const std::array<X, n>& omega, std::array<X, n>& alpha) {
  std::array<std::array<X, n>, n> M;
  std::array<X, n> across, down, square;
  for (std::size_t i = 0; i < n; ++i) {
    across[i] = r[i] * sin(theta[i]);
    down[i] = r[i] * cos(theta[i]);
    square[i] = omega[i] * omega[i];
    alpha[i] = -(mu[i] * g) * across[i];
    M[i][i] = X(mu[i] * r[i] * r[i]);
    for (std::size_t k = 0; k < i; ++k) {
      M[k][i] = mu[i] * (down[i] * down[k] + across[i] * across[k]);
      const X turning = mu[i] * (across[i] * down[k] - down[i] * across[k]);
      alpha[i] -= turning * square[k];
      alpha[k] += turning * square[i];
    }
  }
  for (std::size_t k = 0; k < n; ++k)
    for (std::size_t i = k + 1; i < n; ++i) {
      const X factor = M[k][i] / M[k][k];
      for (std::size_t j = i; j < n; ++j) M[i][j] -= factor * M[k][j];
      alpha[i] -= factor * alpha[k];
    }
  for (std::size_t i = n; i-- > 0;) {
    for (std::size_t j = i + 1; j < n; ++j) alpha[i] -= M[i][j] * alpha[j];
    alpha[i] /= M[i][i];
  }
}

// ---- the triple pendulum ----------------------------------------------------------------------------------

/// The exercise's parameters.
template <class T>
struct Given {
  std::array<T, 3> m, r;
  T g, h;
  std::array<T, 3> theta, omega;

  /// (x1, y1, ..., x3, y3) of a state whose first three components are the angles.
  template <class State>
  auto positions(const State& x) const {
    using X = std::decay_t<decltype(x[0])>;
    std::array<X, 6> all;
    X across = X(0), up = X(h);
    for (std::size_t k = 0; k < 3; ++k) {
      all[2 * k] = across += X(r[k]) * sin(x[k]);
      all[2 * k + 1] = up -= X(r[k]) * cos(x[k]);
    }
    return all;
  }
};

enum class Equations { dense, tensions };

/// Constants of the equations that depend only on masses and lengths.
template <class T, Equations how>
struct Links;
template <class T>
struct Links<T, Equations::dense> {
  std::array<T, 3> mass_from_here_on;
  explicit Links(const Given<T>& p) : mass_from_here_on{p.m[0] + p.m[1] + p.m[2], p.m[1] + p.m[2], p.m[2]} {}
};
template <class T>
struct Links<T, Equations::tensions> {
  std::array<T, 3> inverse_mass, inverse_length;
  explicit Links(const Given<T>& p)
      : inverse_mass{1 / p.m[0], 1 / p.m[1], 1 / p.m[2]},
        inverse_length{1 / p.r[0], 1 / p.r[1], 1 / p.r[2]} {}
};

/// (theta1..3, theta1'..3').
template <class T, Equations how>
struct Angles {
  Given<T> p;
  Links<T, how> links = Links<T, how>(p);
  /// One SIMD register per number: all tensions are in use at once, and two registers each would spill.
  static constexpr bool fills_registers = how == Equations::tensions;
  using State = std::array<T, 6>;
  State start() const { return {p.theta[0], p.theta[1], p.theta[2], p.omega[0], p.omega[1], p.omega[2]}; }
  template <class X>
  void operator()(const std::array<X, 6>& x, std::array<X, 6>& dxdt, const X&) const {
    const std::array<X, 3> q{x[0], x[1], x[2]}, v{x[3], x[4], x[5]};
    std::array<X, 3> a{};
    if constexpr (how == Equations::dense) {
      by_mass_matrix(links.mass_from_here_on, p.r, p.g, q, v, a);
    } else if constexpr (std::same_as<X, T>) {
      across_by_tensions(links.inverse_mass, p.r, p.g, q, v, a);
      for (std::size_t k = 0; k < 3; ++k) a[k] *= links.inverse_length[k];
    } else {  // a number type with more digits computes its own reciprocals
      by_tensions(p.m, p.r, p.g, q, v, a);
    }
    dxdt = {x[3], x[4], x[5], a[0], a[1], a[2]};
  }
  std::array<T, 6> observe(const State& x, const T&) const { return p.positions(x); }
  /// The energy, with heights relative to the pivot.
  auto conserved(const State& x, const T&) const {
    T kinetic(0), potential(0), vx(0), vy(0), y(0);
    for (std::size_t k = 0; k < 3; ++k) {
      vx += p.r[k] * x[k + 3] * cos(x[k]);
      vy += p.r[k] * x[k + 3] * sin(x[k]);
      y -= p.r[k] * cos(x[k]);
      kinetic += p.m[k] * (vx * vx + vy * vy) / 2;
      potential += p.m[k] * p.g * y;
    }
    return energy_of<T>(kinetic, potential);
  }
};

/// Small angles: K = diag(mu_i g r_i), M_ij = mu_max(i,j) r_i r_j.
template <class T>
struct Modes {
  using Matrix = std::array<std::array<T, 3>, 3>;
  Given<T> p;
  NormalModes<T, 3> small;

  explicit Modes(const Given<T>& given)
      : p(given), small(stiffness(given), mass_matrix(given), given.theta, given.omega) {}
  std::array<T, 6> at(const T& t) const { return p.positions(small.at(t)); }

  static Matrix stiffness(const Given<T>& p) {
    const auto mu = Links<T, Equations::dense>(p).mass_from_here_on;
    Matrix K{};
    for (std::size_t i = 0; i < 3; ++i) K[i][i] = mu[i] * p.g * p.r[i];
    return K;
  }
  static Matrix mass_matrix(const Given<T>& p) {
    const auto mu = Links<T, Equations::dense>(p).mass_from_here_on;
    Matrix M{};
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) M[i][j] = mu[std::max(i, j)] * p.r[i] * p.r[j];
    return M;
  }
};

/// From the simplest to the richest.
template <class T>
auto models(const Given<T>& p) {
  return std::tuple{Angles<T, Equations::dense>{p}, Angles<T, Equations::tensions>{p}};
}

}  // namespace oddity::chain
