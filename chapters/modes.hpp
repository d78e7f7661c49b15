#pragma once

#include <array>
#include <cstddef>

#include "chapters/numbers.hpp"

/// Small oscillations in closed form.
namespace oddity {

/// Solves M x'' + K x = 0 from x and v, for symmetric matrices with M positive definite: each mode oscillates
/// independently. The Cholesky factor of M reduces the two matrices to one symmetric matrix, which Jacobi
/// rotations diagonalize.
template <class T, std::size_t n>
class NormalModes {
 public:
  using Vector = std::array<T, n>;
  using Matrix = std::array<Vector, n>;

  NormalModes(const Matrix& K, const Matrix& M, const Vector& x, const Vector& v) {
    factor(M);
    Matrix A = divided(transposed(divided(K))), axes{};
    for (std::size_t i = 0; i < n; ++i) axes[i][i] = T(1);
    for (int sweep = 0; sweep < 30 && rotated(A, axes); ++sweep) continue;
    for (std::size_t k = 0; k < n; ++k) {
      w_[k] = sqrt(A[k][k]);
      shapes_[k] = axes[k];
      for (std::size_t i = n; i-- > 0;) {
        for (std::size_t j = i + 1; j < n; ++j) shapes_[k][i] -= factor_[j][i] * shapes_[k][j];
        shapes_[k][i] /= factor_[i][i];
      }
      cosine_[k] = along(axes[k], x);
      sine_[k] = along(axes[k], v) / w_[k];
    }
  }

  Vector at(const T& t) const {
    Vector x{};
    for (std::size_t k = 0; k < n; ++k) {
      const T now = cosine_[k] * cos(w_[k] * t) + sine_[k] * sin(w_[k] * t);
      for (std::size_t i = 0; i < n; ++i) x[i] += now * shapes_[k][i];
    }
    return x;
  }

 private:
  /// Cholesky factor: M = L L^T.
  void factor(const Matrix& M) {
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j <= i; ++j) {
        T rest = M[i][j];
        for (std::size_t k = 0; k < j; ++k) rest -= factor_[i][k] * factor_[j][k];
        factor_[i][j] = i == j ? sqrt(rest) : rest / factor_[j][j];
      }
  }
  /// L^-1 A.
  Matrix divided(Matrix A) const {
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t column = 0; column < n; ++column) {
        for (std::size_t k = 0; k < i; ++k) A[i][column] -= factor_[i][k] * A[k][column];
        A[i][column] /= factor_[i][i];
      }
    return A;
  }
  static Matrix transposed(const Matrix& A) {
    Matrix B;
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j) B[i][j] = A[j][i];
    return B;
  }
  /// One rotation in each plane in which A is not diagonal to rounding; false if there is no such plane. The
  /// rows of `axes` are rotated too.
  static bool rotated(Matrix& A, Matrix& axes) {
    bool turned = false;
    for (std::size_t p = 0; p < n; ++p)
      for (std::size_t q = p + 1; q < n; ++q) {
        if (abs(A[p][q]) <= T(unit_roundoff<T>) * sqrt(abs(A[p][p] * A[q][q]))) continue;
        turned = true;
        const T slope = (A[q][q] - A[p][p]) / (2 * A[p][q]),
                tangent = copysign(T(1), slope) / (abs(slope) + sqrt(slope * slope + 1)),
                cosine = 1 / sqrt(tangent * tangent + 1), sine = tangent * cosine;
        const auto turn = [&](T& a, T& b) {
          const T old = a;
          a = cosine * old - sine * b;
          b = sine * old + cosine * b;
        };
        for (std::size_t k = 0; k < n; ++k) turn(A[k][p], A[k][q]);
        for (std::size_t k = 0; k < n; ++k) turn(A[p][k], A[q][k]), turn(axes[p][k], axes[q][k]);
      }
    return turned;
  }
  /// Component of x along the mode of this axis: axis . L^T x.
  T along(const Vector& axis, const Vector& x) const {
    T sum(0);
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j <= i; ++j) sum += factor_[i][j] * axis[j] * x[i];
    return sum;
  }

  Matrix factor_{}, shapes_{};
  Vector w_{}, cosine_{}, sine_{};
};

}  // namespace oddity
