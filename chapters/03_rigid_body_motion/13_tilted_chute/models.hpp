#pragma once

#include <array>
#include <tuple>

#include "chapters/03_rigid_body_motion/05_pendulum/models.hpp"
#include "chapters/03_rigid_body_motion/shared/height_field_models.hpp"

/// The models of exercise 3.13: a ball in a cylindrical chute with a tilted axis. The observables are the
/// position.
namespace oddity::tilted_chute {

/// Radius R; the axis falls by H over its length L. e = (c, 0, -s) down the axis, n = (s, 0, c) normal to it.
template <class T>
struct Chute {
  T R, L, H;

  T c() const { return sqrt((L - H) * (L + H)) / L; }
  T s() const { return H / L; }

  /// The point at the distance `along` down the axis and the angle phi about it.
  template <class X>
  std::array<X, 3> position(const X& along, const X& phi) const {
    const X up = R * (1 - cos(phi));
    return {along * c() + up * s(), R * sin(phi), up * c() - along * s()};
  }

  // The chute as a height field.
  template <class X>
  X height(const X& x1, const X& x2) const {
    return (R - s() * x1 - sqrt(R * R - x2 * x2)) / c();
  }
  template <class X>
  X depth(const X& x2) const {
    return sqrt((R - x2) * (R + x2));
  }
  template <class X>
  std::array<X, 2> gradient(const std::array<X, 2>& x) const {
    return {X(-s() / c()), x[1] / (depth(x[1]) * c())};
  }
  template <class X>
  std::array<X, 2> turn(const std::array<X, 2>& x, const std::array<X, 2>& v) const {
    const X d = depth(x[1]);
    return {X(0), R * R * v[1] / (d * d * d * c())};
  }
  template <class X>
  X bend(const std::array<X, 2>& x, const std::array<X, 2>& v) const {
    return v[1] * turn(x, v)[1];
  }
};

/// The exercise's parameters: released at the angle phi from the lowest line, with the speed u down the axis.
template <class T>
struct Given {
  T R, L, H, g, phi, u;

  Chute<T> chute() const { return {R, L, H}; }
  T along(const T& t) const { return u * t + g * chute().s() * t * t / 2; }
  T square() const { return g * chute().c() / R; }
};

/// The book's model: x2 = 0.
template <class T>
struct CenterLine {
  Given<T> p;
  std::array<T, 3> at(const T& t) const {
    const Chute<T> chute = p.chute();
    const T theta = asin(p.H / p.L), zero(0);
    const T x1 = chute.position(zero, p.phi)[0] + p.u * chute.c() * t + p.g * sin(2 * theta) / 4 * t * t;
    return {x1, zero, chute.height(x1, zero)};
  }
};

template <class T>
struct SmallAngle {
  Given<T> p;
  std::array<T, 3> at(const T& t) const {
    return p.chute().position(p.along(t), T(p.phi * cos(sqrt(p.square()) * t)));
  }
};

/// Exact: the angle is a pendulum's.
template <class T>
struct EllipticAngle {
  Given<T> p;
  pendulum::FourierSeries<T> angle;

  explicit EllipticAngle(const Given<T>& given)
      : p(given), angle({given.phi, given.R, given.g * given.chute().c()}) {}
  std::array<T, 3> at(const T& t) const { return p.chute().position(p.along(t), angle.at(t)[0]); }
};

/// (phi, phi'), with the distance along the axis in closed form.
template <class T>
struct Angle {
  Given<T> p;
  using State = std::array<T, 2>;
  State start() const { return {p.phi, T(0)}; }
  template <class X>
  void operator()(const std::array<X, 2>& x, std::array<X, 2>& dxdt, const X&) const {
    dxdt = {x[1], -p.square() * sin(x[0])};
  }
  template <class X>
  void acceleration(const std::array<X, 1>& q, std::array<X, 1>& dv) const {
    dv = {-p.square() * sin(q[0])};
  }
  std::array<T, 3> observe(const State& x, const T& t) const { return p.chute().position(p.along(t), x[0]); }
  auto conserved(const State& x, const T&) const {
    return energy_of<T>(x[1] * x[1] / 2, p.square() * (1 - cos(x[0])));
  }
};

template <class T>
using InPlane = height_field::InPlane<T, Chute<T>>;
template <class T>
InPlane<T> in_plane(const Given<T>& p) {
  const Chute<T> chute = p.chute();
  const auto x = chute.position(T(0), p.phi);
  return {chute, p.g, {x[0], x[1], p.u * chute.c(), T(0)}};
}

/// (x1, x2, x3, x1', x2', x3') with the chute's force towards its axis.
template <class T>
struct InSpace {
  Given<T> p;
  using State = std::array<T, 6>;
  State start() const {
    const Chute<T> chute = p.chute();
    const auto x = chute.position(T(0), p.phi);
    return {x[0], x[1], x[2], p.u * chute.c(), T(0), -p.u * chute.s()};
  }
  template <class X>
  void operator()(const std::array<X, 6>& x, std::array<X, 6>& dxdt, const X&) const {
    const T c = p.chute().c(), s = p.chute().s();
    const X z = x[2] - p.R / c;
    const X way = c * x[0] - s * z, speed = c * x[3] - s * x[5];
    const X n1 = x[0] - way * c, n2 = x[1], n3 = z + way * s;
    const X w1 = x[3] - speed * c, w2 = x[4], w3 = x[5] + speed * s;
    const X m = (p.g * n3 - w1 * w1 - w2 * w2 - w3 * w3) / (n1 * n1 + n2 * n2 + n3 * n3);
    dxdt = {x[3], x[4], x[5], m * n1, m * n2, m * n3 - p.g};
  }
  std::array<T, 3> observe(const State& x, const T&) const { return {x[0], x[1], x[2]}; }
  auto conserved(const State& x, const T&) const {
    return energy_of<T>((x[3] * x[3] + x[4] * x[4] + x[5] * x[5]) / 2, p.g * x[2]);
  }
  /// Deviation from the distance R to the axis.
  std::array<T, 1> constraints(const State& x, const T&) const {
    const T c = p.chute().c(), s = p.chute().s(), z = x[2] - p.R / c, way = c * x[0] - s * z;
    return {hypot(hypot(x[0] - way * c, x[1]), z + way * s) - p.R};
  }
};

/// From the simplest to the richest.
template <class T>
auto models(const Given<T>& p) {
  return std::tuple{CenterLine<T>{p}, SmallAngle<T>{p}, EllipticAngle<T>(p),
                    Angle<T>{p},      in_plane(p),      InSpace<T>{p}};
}

}  // namespace oddity::tilted_chute
