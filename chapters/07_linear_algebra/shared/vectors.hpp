#pragma once

#include <array>

#include "chapters/numbers.hpp"

/// Vectors of three components, generic in the number type.
namespace oddity::vectors {

template <class T>
using Vector3 = std::array<T, 3>;

template <class T>
Vector3<T> operator+(const Vector3<T>& a, const Vector3<T>& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
template <class T>
Vector3<T> operator-(const Vector3<T>& a, const Vector3<T>& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
template <class T>
Vector3<T> operator-(const Vector3<T>& a) {
  return {-a[0], -a[1], -a[2]};
}
template <class T>
Vector3<T> operator*(const T& x, const Vector3<T>& a) {
  return {x * a[0], x * a[1], x * a[2]};
}
/// a . b x c.
template <class T>
T triple(const Vector3<T>& a, const Vector3<T>& b, const Vector3<T>& c) {
  return dot(a, cross(b, c));
}

template <class T, class From>
Vector3<T> cast(const Vector3<From>& a) {
  return {static_cast<T>(a[0]), static_cast<T>(a[1]), static_cast<T>(a[2])};
}

}  // namespace oddity::vectors
