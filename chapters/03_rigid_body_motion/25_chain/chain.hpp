#pragma once

// What the models of exercise 3.25 are judged by: its equations for n masses, solved by libraries, and the
// normal modes of three.

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <vector>

#include "chapters/03_rigid_body_motion/25_chain/models.hpp"
#include "chapters/scene.hpp"
#include "solvers/dual.hpp"
#include "solvers/linear.hpp"

namespace oddity::chain {

template <class Lengths>
Lengths mass_from_here_on(Lengths m) {
  for (std::size_t k = m.size() - 1; k-- > 0;) m[k] += m[k + 1];
  return m;
}

/// theta'' from the dense mass matrix for any n, by one of the library's factorizations.
inline Solved<Eigen::VectorXd> by_factorization(Factorization how, const std::vector<double>& m,
                                                const std::vector<double>& r, double g,
                                                const std::vector<double>& theta,
                                                const std::vector<double>& omega) {
  const auto n = static_cast<Eigen::Index>(m.size());
  const auto mu = mass_from_here_on(m);
  Eigen::MatrixXd M(n, n);
  Eigen::VectorXd f(n);
  for (Eigen::Index i = 0; i < n; ++i)
    dense_row(static_cast<std::size_t>(i), mu, r, g, theta, omega, M.col(i).data(), f(i));
  return solve(how, M, f);
}

/// K e = w^2 M e at small angles: K = diag(mu_i g r_i), M_ij = mu_max(i,j) r_i r_j.
struct NormalModes : Triple {
  Eigen::Vector3d w, cosine, sine;
  Eigen::Matrix3d shape;

  explicit NormalModes(const Triple& triple) : Triple(triple) {
    Eigen::Matrix3d M, K = Eigen::Matrix3d::Zero();
    const auto mu = mass_from_here_on(std::vector<double>(m.begin(), m.end()));
    for (int i = 0; i < 3; ++i) {
      const auto a = static_cast<std::size_t>(i);
      K(i, i) = mu[a] * g * r[a];
      for (int j = 0; j < 3; ++j)
        M(i, j) = mu[static_cast<std::size_t>(std::max(i, j))] * r[a] * r[static_cast<std::size_t>(j)];
    }
    const Modes all = modes(K, M);
    w = all.squares.cwiseSqrt();
    shape = all.shapes;
    cosine = shape.transpose() * M * Eigen::Map<const Eigen::Vector3d>(theta.data());
    sine = (shape.transpose() * M * Eigen::Map<const Eigen::Vector3d>(omega.data())).cwiseQuotient(w);
  }
  std::array<double, 6> at(double t) const {
    const Eigen::Vector3d now =
        shape * (cosine.array() * (w.array() * t).cos() + sine.array() * (w.array() * t).sin()).matrix();
    return positions(*this, Three{now(0), now(1), now(2)});
  }
};

// ---- a chain of n -----------------------------------------------------------------------------------------

/// n links whose masses, lengths, angles and speeds run through dyadic patterns.
struct Pattern {
  std::vector<double> m, r, theta, omega;

  explicit Pattern(int n) {
    for (int k = 0; k < n; ++k) {
      m.push_back(1 + k % 4 / 4.0);
      r.push_back(1 + k % 3 / 4.0);
      theta.push_back(k * 37 % 64 / 32.0 - 1);
      omega.push_back(k * 29 % 64 / 32.0 - 1);
    }
  }
};

/// The first, the middle and the last.
template <class Accelerations>
Value chosen(const Accelerations& alpha, int n) {
  const auto i = static_cast<decltype(alpha.size())>(n);
  return {alpha[0], alpha[(i - 1) / 2], alpha[i - 1]};
}

}  // namespace oddity::chain
