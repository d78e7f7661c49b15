#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <type_traits>

#include "chapters/02_basic_concepts/shared/rotation_matrices.hpp"
#include "chapters/numbers.hpp"

/// A curve on the unit sphere with its frame R = [r u r x u], u = r'/|r'|, the frame's angular velocity w,
/// and an orientation carried along R' = Skew(w) R.
namespace oddity::curve_on_sphere {

using namespace space;

inline constexpr auto position = [](const auto& t) {
  using std::cos, std::sin, std::sqrt;
  using T = std::decay_t<decltype(t)>;
  const T height = t * t, flat = T(1.0) - height, turn = T(std::numbers::pi) * t;
  return Vector<T>{flat * cos(turn), flat * sin(turn), height} / sqrt(flat * flat + height * height);
};

template <class T>
Matrix<T> frame(const T& t) {
  const Vector<T> r = position(t), u = unit(derivative_of(position, t));
  return Matrix<T>::columns(r, u, cross(r, u));
}

/// w along r x u and along r: r' = w x r and (r x u).u' = w.r.
inline Vector3 angular_velocity(const Motion& m) {
  return cross(m.r, m.v) + dot(m.r, cross(m.v, m.a)) / dot(m.v, m.v) * m.r;
}

/// The listing's UDot and W, in its arithmetic; `mended`: with A.Dot(U) in the place of R.Dot(U).
inline Vector3 listed_u_dot(const Motion& m, bool mended) {
  const double speed = length(m.v);
  const Vector3 U = m.v / speed;
  return (m.a - dot(mended ? m.a : m.r, U) * U) / speed;
}
inline Vector3 listed_w(const Motion& m, const Vector3& UDot) {
  const Vector3 &R = m.r, &V = m.v, U = V / length(V), RxU = cross(R, U), RxUDot = cross(R, UDot);
  return {-(V[1] * R[2] + UDot[1] * U[2] + RxUDot[1] * RxU[2]),
          +(V[0] * R[2] + UDot[0] * U[2] + RxUDot[0] * RxU[2]),
          -(V[0] * R[1] + UDot[0] * U[1] + RxUDot[0] * RxU[1])};
}

/// The curve is run through at `pace` units of its time a second.
struct Frame {
  double pace;
  std::array<double, 9> at(double t) const { return frame(pace * t).e; }
};

/// The largest entry of R^T R - I.
inline double departure(const Matrix3& R) {
  double most = 0;
  for (double x : transpose(R) * R - identity()) {
    if (std::isnan(x)) return x;
    most = std::max(most, std::abs(x));
  }
  return most;
}

/// w at the time t: the frame's, or the printed listing's.
struct Turning {
  double pace;
  bool listed = false;
  Vector3 w(double t) const {
    const Motion m = motion_of(position, pace * t);
    return pace * (listed ? listed_w(m, listed_u_dot(m, false)) : angular_velocity(m));
  }
};

/// R, row by row. What is conserved is |R^T R - I|, the departure from a rotation.
struct AsMatrix : Turning {
  using State = std::array<double, 9>;
  State start() const { return identity().e; }
  void operator()(const State& x, State& dxdt, double t) const { dxdt = (skew(w(t)) * Matrix3{x}).e; }
  std::array<double, 9> observe(const State& x, double) const { return x; }
  std::array<Conserved<double>, 1> conserved(const State& x, double) const { return {{{departure(Matrix3{x}), 1}}}; }
};

/// q with q' = (0, w) q / 2, read as a matrix by the formula for unit quaternions.
struct AsQuaternion : Turning {
  using State = Quaternion<double>;
  State start() const { return {1, 0, 0, 0}; }
  void operator()(const State& q, State& dqdt, double t) const {
    const Vector3 v{q[1], q[2], q[3]}, half = 0.5 * w(t), turned = q[0] * half + cross(half, v);
    dqdt = {-dot(half, v), turned[0], turned[1], turned[2]};
  }
  std::array<double, 9> observe(const State& q, double) const { return matrix(q).e; }
  std::array<Conserved<double>, 1> conserved(const State& q, double) const { return {{{departure(matrix(q)), 1}}}; }
};

}  // namespace oddity::curve_on_sphere
