#pragma once

#include <cstddef>

#include "chapters/02_basic_concepts/shared/matrices.hpp"
#include "solvers/dual.hpp"

/// Derivatives of vectors and matrices by dual numbers.
namespace oddity::space {

template <class T>
Vector<T> value_of(const Vector<Dual<T>>& a) {
  return {a[0].value, a[1].value, a[2].value};
}
template <class T>
Vector<T> slope_of(const Vector<Dual<T>>& a) {
  return {a[0].slope, a[1].slope, a[2].slope};
}
template <class T>
Matrix<T> value_of(const Matrix<Dual<T>>& a) {
  Matrix<T> out;
  for (std::size_t i = 0; i < 9; ++i) out.e[i] = a.e[i].value;
  return out;
}
template <class T>
Matrix<T> slope_of(const Matrix<Dual<T>>& a) {
  Matrix<T> out;
  for (std::size_t i = 0; i < 9; ++i) out.e[i] = a.e[i].slope;
  return out;
}

/// r'(t) of a curve that is generic in its number type.
template <class Curve, class T>
Vector<T> derivative_of(const Curve& r, const T& t) {
  return slope_of(r(Dual<T>(t, T(1.0))));
}

/// The motion along a curve r(t) that is generic in its number type.
template <class Curve, class T>
Motion<T> motion_of(const Curve& r, const T& t) {
  using D = Dual<T>;
  const Vector<Dual<D>> at = r(Dual<D>(D(t, T(1.0)), D(1.0)));
  return {value_of(value_of(at)), slope_of(value_of(at)), slope_of(slope_of(at))};
}

}  // namespace oddity::space
