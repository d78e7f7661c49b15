#pragma once

#include "formula/matrix.hpp"

/// Quaternions as vectors of four, the first of which is the cosine of half the angle.
namespace oddity::problem {

template <class T>
formula::Matrix<T> vector_part(const formula::Matrix<T>& q) {
  return {{q.entries[1], q.entries[2], q.entries[3]}};
}

/// The product p q: the turn q, and then p.
template <class T>
formula::Matrix<T> composed(const formula::Matrix<T>& p, const formula::Matrix<T>& q) {
  const T &a = p.entries[0], &b = q.entries[0];
  const formula::Matrix<T> u = vector_part(p), v = vector_part(q);
  const formula::Matrix<T> sum = added(scaled_from_left(a, v), scaled(u, b), false);
  return joined({{a * b - dot_of(u, v)}}, added(sum, cross_of(u, v), false));
}

template <class T>
formula::Matrix<T> conjugate(const formula::Matrix<T>& q) {
  return joined({{q.entries[0]}}, negated(vector_part(q)));
}

/// The vector part of q v q*: v turned by q, times the square of q's length.
template <class T>
formula::Matrix<T> turned(const formula::Matrix<T>& q, const formula::Matrix<T>& v) {
  const T& a = q.entries[0];
  const formula::Matrix<T> u = vector_part(q);
  const formula::Matrix<T> along =
      added(scaled_from_left(a * a - dot_of(u, u), v), scaled_from_left(T(2) * dot_of(u, v), u), false);
  return added(along, scaled_from_left(T(2) * a, cross_of(u, v)), false);
}

}  // namespace oddity::problem
