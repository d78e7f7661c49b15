#pragma once

#include <array>
#include <numbers>
#include <tuple>
#include <type_traits>

#include "chapters/02_basic_concepts/shared/matrices.hpp"
#include "chapters/numbers.hpp"

/// A curve on the unit sphere with its frame R = [r u r x u], u = r'/|r'|. The frame has the angular velocity
/// w, and an orientation is integrated by R' = Skew(w) R.
namespace oddity::curve_on_sphere {

using space::Matrix, space::Motion, space::Vector;

/// The first of the exercise's parameters: the curve's own time advances at `pace` units a second.
template <class T>
struct Given {
  T pace;
};

inline constexpr auto position = [](const auto& t) {
  using T = std::decay_t<decltype(t)>;
  const T height = t * t, flat = T(1.0) - height, turn = T(std::numbers::pi) * t;
  return Vector<T>{flat * cos(turn), flat * sin(turn), height} / sqrt(flat * flat + height * height);
};

/// The curve's motion, from that of n = ((1 - t^2) cos(pi t), (1 - t^2) sin(pi t), t^2) and n's length s.
template <class T>
Motion<T> motion(const T& t) {
  const T pi = T(std::numbers::pi), height = t * t, flat = 1 - height, c = cos(pi * t), s = sin(pi * t);
  const T along = -2 * t, across = pi * flat, bent = -2 - pi * across, turned = 2 * pi * along;
  const Vector<T> n{flat * c, flat * s, height}, n_dot{along * c - across * s, along * s + across * c, 2 * t},
      n_dot_dot{bent * c - turned * s, bent * s + turned * c, T(2)};
  const T size = length(n);
  const Vector<T> r = n / size;
  const T size_dot = dot(r, n_dot);
  const Vector<T> v = (n_dot - size_dot * r) / size;
  const T size_dot_dot = dot(v, n_dot) + dot(r, n_dot_dot);
  return {r, v, (n_dot_dot - 2 * size_dot * v - size_dot_dot * r) / size};
}

/// w along r x u and along r: r' = w x r and (r x u).u' = w.r.
template <class T>
Vector<T> angular_velocity(const Motion<T>& m) {
  return cross(m.r, m.v) + dot(m.r, cross(m.v, m.a)) / dot(m.v, m.v) * m.r;
}

/// The listing's UDot and W, in its arithmetic; `mended`: with A.Dot(U) in place of R.Dot(U).
template <class T>
Vector<T> listed_u_dot(const Motion<T>& m, bool mended) {
  const T speed = length(m.v);
  const Vector<T> U = m.v / speed;
  return (m.a - dot(mended ? m.a : m.r, U) * U) / speed;
}
template <class T>
Vector<T> listed_w(const Motion<T>& m, const Vector<T>& UDot) {
  const Vector<T>&R = m.r, &V = m.v, U = V / length(V), RxU = cross(R, U), RxUDot = cross(R, UDot);
  return {-(V[1] * R[2] + UDot[1] * U[2] + RxUDot[1] * RxU[2]),
          V[0] * R[2] + UDot[0] * U[2] + RxUDot[0] * RxU[2],
          -(V[0] * R[1] + UDot[0] * U[1] + RxUDot[0] * RxU[1])};
}

template <class T>
struct Frame {
  Given<T> p;
  std::array<T, 9> at(const T& t) const {
    const Motion<T> m = motion<T>(p.pace * t);
    const Vector<T> u = unit(m.v);
    return Matrix<T>::columns(m.r, u, cross(m.r, u)).e;
  }
};

/// The largest entry of R^T R - I; NaN if one is NaN.
template <class T>
T departure(const Matrix<T>& R) {
  T most(0), nothing(0);
  for (const T& x : transpose(R) * R - space::identity<T>()) {
    most = select(abs(x) > most, T(abs(x)), most);
    nothing += 0 * x;
  }
  return most + nothing;
}

/// w at the time t: the frame's, or the printed listing's.
template <class T>
struct Turning {
  Given<T> p;
  bool listed = false;
  static constexpr std::array<std::size_t, 0> velocities{};  // w is a function of time
  template <class X>
  Vector<X> w(const X& t) const {
    const Motion<X> m = motion<X>(p.pace * t);
    return p.pace * (listed ? listed_w(m, listed_u_dot(m, false)) : angular_velocity(m));
  }
};

/// R, row by row. The conserved quantity is |R^T R - I|, the departure from a rotation.
template <class T>
struct AsMatrix : Turning<T> {
  using State = std::array<T, 9>;
  State start() const { return space::identity<T>().e; }
  template <class X>
  void operator()(const std::array<X, 9>& x, std::array<X, 9>& dxdt, const X& t) const {
    dxdt = (skew(this->w(t)) * Matrix<X>{x}).e;
  }
  std::array<T, 9> observe(const State& x, const T&) const { return x; }
  std::array<Conserved<T>, 1> conserved(const State& x, const T&) const {
    return {{{departure(Matrix<T>{x}), T(1)}}};
  }
};

/// q with q' = (0, w) q / 2, converted to a matrix by the formula for unit quaternions.
template <class T>
struct AsQuaternion : Turning<T> {
  using State = space::Quaternion<T>;
  State start() const { return {T(1), T(0), T(0), T(0)}; }
  template <class X>
  void operator()(const std::array<X, 4>& q, std::array<X, 4>& dqdt, const X& t) const {
    const Vector<X> v{q[1], q[2], q[3]}, half = X(0.5) * this->w(t), turned = q[0] * half + cross(half, v);
    dqdt = {-dot(half, v), turned[0], turned[1], turned[2]};
  }
  std::array<T, 9> observe(const State& q, const T&) const { return space::matrix(q).e; }
  std::array<Conserved<T>, 1> conserved(const State& q, const T&) const {
    return {{{departure(space::matrix(q)), T(1)}}};
  }
};

/// From the simplest to the richest.
template <class T>
auto models(const Given<T>& p) {
  return std::tuple{AsMatrix<T>{{p, true}}, Frame<T>{p}, AsMatrix<T>{{p}}, AsQuaternion<T>{{p}}};
}

}  // namespace oddity::curve_on_sphere
