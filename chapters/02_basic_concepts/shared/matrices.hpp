#pragma once

#include <array>
#include <cstddef>

#include "chapters/numbers.hpp"

/// Vectors and matrices of three-dimensional space over any number type, and quaternions.
namespace oddity::space {

template <class T>
struct Vector {
  std::array<T, 3> e{};

  T& operator[](std::size_t i) { return e[i]; }
  const T& operator[](std::size_t i) const { return e[i]; }
  auto begin() const { return e.begin(); }
  auto end() const { return e.end(); }

  friend Vector operator+(const Vector& a, const Vector& b) {
    return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
  }
  friend Vector operator-(const Vector& a, const Vector& b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
  }
  friend Vector operator-(const Vector& a) { return {-a[0], -a[1], -a[2]}; }
  friend Vector operator*(const T& s, const Vector& a) { return {s * a[0], s * a[1], s * a[2]}; }
  friend Vector operator/(const Vector& a, const T& s) { return {a[0] / s, a[1] / s, a[2] / s}; }
};
using Vector3 = Vector<double>;

template <class T>
T dot(const Vector<T>& a, const Vector<T>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
template <class T>
Vector<T> cross(const Vector<T>& a, const Vector<T>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
template <class T>
T length(const Vector<T>& a) {
  return sqrt(dot(a, a));
}
template <class T>
Vector<T> unit(const Vector<T>& a) {
  return a / length(a);
}

/// Row by row.
template <class T>
struct Matrix {
  std::array<T, 9> e{};

  const T& operator()(std::size_t i, std::size_t j) const { return e[3 * i + j]; }
  Vector<T> column(std::size_t j) const { return {e[j], e[3 + j], e[6 + j]}; }
  auto begin() const { return e.begin(); }
  auto end() const { return e.end(); }

  friend Matrix operator+(Matrix a, const Matrix& b) {
    for (std::size_t i = 0; i < 9; ++i) a.e[i] = a.e[i] + b.e[i];
    return a;
  }
  friend Matrix operator-(const Matrix& a, const Matrix& b) { return a + T(-1.0) * b; }
  friend Matrix operator*(const T& s, Matrix a) {
    for (T& x : a.e) x = s * x;
    return a;
  }
  friend Vector<T> operator*(const Matrix& a, const Vector<T>& v) {
    Vector<T> out;
    for (std::size_t i = 0; i < 3; ++i) out[i] = a(i, 0) * v[0] + a(i, 1) * v[1] + a(i, 2) * v[2];
    return out;
  }
  friend Matrix operator*(const Matrix& a, const Matrix& b) {
    return columns(a * b.column(0), a * b.column(1), a * b.column(2));
  }
  static Matrix columns(const Vector<T>& a, const Vector<T>& b, const Vector<T>& c) {
    return {a[0], b[0], c[0], a[1], b[1], c[1], a[2], b[2], c[2]};
  }
};
using Matrix3 = Matrix<double>;

template <class T>
Matrix<T> transpose(const Matrix<T>& m) {
  return {m.e[0], m.e[3], m.e[6], m.e[1], m.e[4], m.e[7], m.e[2], m.e[5], m.e[8]};
}
template <class T>
T determinant(const Matrix<T>& m) {
  return dot(m.column(0), cross(m.column(1), m.column(2)));
}
template <class T = double>
Matrix<T> identity() {
  return {T(1.0), T(0.0), T(0.0), T(0.0), T(1.0), T(0.0), T(0.0), T(0.0), T(1.0)};
}
/// a b^T.
template <class T>
Matrix<T> outer(const Vector<T>& a, const Vector<T>& b) {
  return Matrix<T>::columns(b[0] * a, b[1] * a, b[2] * a);
}
/// The matrix of v -> w x v.
template <class T>
Matrix<T> skew(const Vector<T>& w) {
  const T o(0.0);
  return {o, -w[2], w[1], w[2], o, -w[0], -w[1], w[0], o};
}
/// The w of a matrix's skew-symmetric part.
template <class T>
Vector<T> unskew(const Matrix<T>& m) {
  return T(0.5) * Vector<T>{m(2, 1) - m(1, 2), m(0, 2) - m(2, 0), m(1, 0) - m(0, 1)};
}

/// Position, velocity and acceleration.
template <class T>
struct Motion {
  Vector<T> r, v, a;
};

/// (w, x, y, z).
template <class T>
using Quaternion = std::array<T, 4>;

/// The matrix of a unit quaternion.
template <class T>
Matrix<T> matrix(const Quaternion<T>& q) {
  const T two(2.0), one(1.0);
  const auto& [w, x, y, z] = q;
  return {one - two * (y * y + z * z), two * (x * y - w * z),       two * (x * z + w * y),
          two * (x * y + w * z),       one - two * (x * x + z * z), two * (y * z - w * x),
          two * (x * z - w * y),       two * (y * z + w * x),       one - two * (x * x + y * y)};
}

}  // namespace oddity::space
