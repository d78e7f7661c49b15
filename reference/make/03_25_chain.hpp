#pragma once

#include <cstddef>
#include <vector>

#include "reference/truth.hpp"

/// A hanging chain of n point masses on massless rods, by two independent sets of equations: angles with the
/// dense mass matrix, and Cartesian coordinates with the tensions. theta is measured from the downward
/// vertical.
namespace oddity::truth {

struct ChainData {
  Numbers m, r;
  Number g, h;
};

/// (theta, omega): M(theta) theta'' = f, M_ij = mu_max(i,j) r_i r_j cos(theta_i - theta_j), with mu_k the
/// mass from k on. Gaussian elimination without pivoting (M is positive definite).
struct ChainAngles {
  const ChainData& c;

  template <class T>
  std::vector<T> operator()(const std::vector<T>& x, const T&) const {
    const std::size_t n = c.m.size();
    Numbers mu = c.m;
    for (std::size_t k = n - 1; k-- > 0;) mu[k] += mu[k + 1];
    std::vector<T> f, C, S;
    for (std::size_t i = 0; i < n; ++i) {
      const T angle = x[i];  // a single argument for the compiler, which halves the time
      C.push_back(cos(angle));
      S.push_back(sin(angle));
      f.push_back(S[i] * Number(-mu[i] * c.g * c.r[i]));
    }
    std::vector<std::vector<T>> M(n);
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j) {
        const Number weight = mu[i > j ? i : j] * c.r[i] * c.r[j];
        M[i].push_back((C[i] * C[j] + S[i] * S[j]) * weight);
        if (i != j) f[i] = f[i] - (S[i] * C[j] - C[i] * S[j]) * weight * (x[n + j] * x[n + j]);
      }
    for (std::size_t k = 0; k < n; ++k)
      for (std::size_t i = k + 1; i < n; ++i) {
        const T factor = M[i][k] / M[k][k];
        for (std::size_t j = k; j < n; ++j) M[i][j] = M[i][j] - factor * M[k][j];
        f[i] = f[i] - factor * f[k];
      }
    std::vector<T> dxdt(x.begin() + static_cast<std::ptrdiff_t>(n), x.end());
    for (std::size_t i = n; i-- > 0;) {
      for (std::size_t j = i + 1; j < n; ++j) f[i] = f[i] - M[i][j] * f[j];
      f[i] = f[i] / M[i][i];
    }
    dxdt.insert(dxdt.end(), f.begin(), f.end());
    return dxdt;
  }

  /// (x_1, y_1, ..., x_n, y_n).
  Numbers positions(const Numbers& x) const {
    Numbers all;
    Number across = 0, up = c.h;
    for (std::size_t k = 0; k < c.m.size(); ++k) {
      across += c.r[k] * sin(x[k]);
      up -= c.r[k] * cos(x[k]);
      all.push_back(across);
      all.push_back(up);
    }
    return all;
  }
};

/// (d_1, ..., d_n, d_1', ..., d_n'), with d_k = (x, y) of mass k relative to mass k-1. With s_k the tension
/// over the length, each rod's length differentiated twice is a row of a tridiagonal system.
struct ChainTensions {
  const ChainData& c;

  Numbers start(const std::vector<double>& theta, const std::vector<double>& omega) const {
    Numbers x;
    for (std::size_t k = 0; k < c.m.size(); ++k) {
      x.push_back(c.r[k] * sin(Number(theta[k])));
      x.push_back(-c.r[k] * cos(Number(theta[k])));
    }
    for (std::size_t k = 0; k < c.m.size(); ++k) {
      x.push_back(-x[2 * k + 1] * omega[k]);
      x.push_back(x[2 * k] * omega[k]);
    }
    return x;
  }

  template <class T>
  std::vector<T> operator()(const std::vector<T>& x, const T&) const {
    const std::size_t n = c.m.size();
    const auto dot = [&](std::size_t a, std::size_t b) {
      return x[2 * a] * x[2 * b] + x[2 * a + 1] * x[2 * b + 1];
    };
    const auto weight = [&](std::size_t k) { return Number(1 / c.m[k]); };
    std::vector<T> diagonal, right;
    for (std::size_t k = 0; k < n; ++k) {
      const Number both = k == 0 ? weight(0) : Number(weight(k) + weight(k - 1));
      diagonal.push_back(dot(k, k) * both);
      const T speed = dot(n + k, n + k);
      right.push_back(k == 0 ? speed - x[1] * c.g : speed);
      if (k == 0) continue;
      const T coupling = dot(k, k - 1) * weight(k - 1), factor = coupling / diagonal[k - 1];
      diagonal[k] = diagonal[k] - factor * coupling;
      right[k] = right[k] + factor * right[k - 1];
    }
    std::vector<T> s = right;
    for (std::size_t k = n; k-- > 0;)
      s[k] = k + 1 == n ? right[k] / diagonal[k]
                        : (right[k] + dot(k, k + 1) * weight(k) * s[k + 1]) / diagonal[k];
    std::vector<T> dxdt(x.begin() + static_cast<std::ptrdiff_t>(2 * n), x.end());
    for (std::size_t k = 0; k < n; ++k)
      for (std::size_t i = 0; i < 2; ++i) {
        T a = -(s[k] * x[2 * k + i] * (k == 0 ? weight(0) : Number(weight(k) + weight(k - 1))));
        if (k + 1 < n) a = a + s[k + 1] * x[2 * k + 2 + i] * weight(k);
        if (k > 0) a = a + s[k - 1] * x[2 * k - 2 + i] * weight(k - 1);
        if (k == 0 && i == 1) a = a - c.g;
        dxdt.push_back(a);
      }
    return dxdt;
  }

  Numbers positions(const Numbers& x) const {
    Numbers all{x[0], Number(c.h + x[1])};
    for (std::size_t k = 1; k < c.m.size(); ++k)
      for (std::size_t i = 0; i < 2; ++i) all.push_back(Number(all[2 * k - 2 + i] + x[2 * k + i]));
    return all;
  }
};

/// Start from a table's row: m1 m2 m3 r1 r2 r3 g h theta1 theta2 theta3 omega1 omega2 omega3.
struct TripleStart {
  ChainData chain;
  std::vector<double> theta, omega;

  explicit TripleStart(const std::vector<double>& in)
      : chain{{in[0], in[1], in[2]}, {in[3], in[4], in[5]}, in[6], in[7]},
        theta(in.begin() + 8, in.begin() + 11),
        omega(in.begin() + 11, in.begin() + 14) {}

  Numbers angles() const {
    Numbers x(theta.begin(), theta.end());
    x.insert(x.end(), omega.begin(), omega.end());
    return x;
  }
};

}  // namespace oddity::truth
