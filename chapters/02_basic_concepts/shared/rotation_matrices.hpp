#pragma once

#include "chapters/02_basic_concepts/shared/space.hpp"

/// Rotations as matrices, unit quaternions and rotation vectors.
namespace oddity::space {

/// Rodrigues' matrix of the unit axis D and the angle.
template <class T>
Matrix<T> rodrigues(const Vector<T>& D, const T& angle) {
  using std::cos, std::sin;
  const Matrix<T> S = skew(D);
  return identity<T>() + sin(angle) * S + (T(1.0) - cos(angle)) * (S * S);
}

template <class T>
Quaternion<T> quaternion(const Vector<T>& D, const T& angle) {
  using std::cos, std::sin;
  const T half = T(0.5) * angle, s = sin(half);
  return {cos(half), s * D[0], s * D[1], s * D[2]};
}
/// The vector part of 2 q' q*.
template <class T>
Vector<T> turning(const Quaternion<Dual<T>>& q) {
  const T w = q[0].value, w_dot = q[0].slope;
  const Vector<T> v{q[1].value, q[2].value, q[3].value}, v_dot{q[1].slope, q[2].slope, q[3].slope};
  return T(2.0) * (w * v_dot - w_dot * v - cross(v_dot, v));
}

/// The vector along the axis of a rotation, as long as its angle in [0, pi].
inline Vector3 rotation_vector(const Matrix3& R) {
  const Vector3 s = unskew(R);
  const double sine = length(s), cosine = (R(0, 0) + R(1, 1) + R(2, 2) - 1) / 2;
  return sine == 0 ? s : std::atan2(sine, cosine) / sine * s;
}

/// The matrix of a rotation vector: the inverse of the above, for any angle.
inline Matrix3 exponential(const Vector3& turn) {
  const double angle = length(turn);
  return angle == 0 ? identity() : rodrigues(turn / angle, angle);
}

}  // namespace oddity::space
