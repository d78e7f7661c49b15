#pragma once

#include <array>
#include <tuple>

#include "chapters/modes.hpp"
#include "chapters/numbers.hpp"

/// The models of exercise 3.19. A pulley of mass m2 at the depth y2 is held by a spring and a rope over a
/// fixed pulley. A mass m3 at the depth y3 is held by another spring and a rope over the first pulley.
namespace oddity::two_pulleys {

template <class T>
struct Given {
  T m2, m3, I1, I2, R1, R2, c1, c2, L1, L2, K1, K2, g, y2, y3, v2, v3;

  T inertia_over_square_1() const { return I1 / (R1 * R1); }
  T inertia_over_square_2() const { return I2 / (R2 * R2); }
  template <class X>
  X stretch1(const std::array<X, 2>& y) const {
    return y[0] + (K1 - L1);
  }
  template <class X>
  X stretch2(const std::array<X, 2>& y) const {
    return y[1] - 2 * y[0] + (K2 - L2);
  }
  template <class X>
  X kinetic_energy(const std::array<X, 2>& v) const {
    const X first = v[0] / R1, second = (v[1] - v[0]) / R2;
    return (m2 * v[0] * v[0] + I1 * first * first + m3 * v[1] * v[1] + I2 * second * second) / 2;
  }
  template <class X>
  X potential_energy(const std::array<X, 2>& y) const {
    const X s1 = stretch1(y), s2 = stretch2(y);
    return (c1 * s1 * s1 + c2 * s2 * s2) / 2 - g * (m2 * y[0] + m3 * y[1]);
  }
  /// Accelerations of the two depths for generalized forces on them.
  template <class X>
  std::array<X, 2> accelerations(const std::array<X, 2>& force) const {
    const T t = inertia_over_square_2(), small = m2 + inertia_over_square_1() + t, large = m3 + t,
            det = small * large - t * t;
    return {(large * force[0] + t * force[1]) / det, (t * force[0] + small * force[1]) / det};
  }
  using Matrix = std::array<std::array<T, 2>, 2>;
  Matrix mass_matrix() const {
    const T t = inertia_over_square_2();
    return {{{m2 + inertia_over_square_1() + t, -t}, {-t, m3 + t}}};
  }
  Matrix stiffness() const { return {{{c1 + 4 * c2, -2 * c2}, {-2 * c2, c2}}}; }
  /// The depths at rest: c2 (S2 - L2) = m3 g, c1 (S1 - L1) = (m2 + 2 m3) g.
  std::array<T, 2> at_rest() const {
    const T down = L1 - K1 + (m2 + 2 * m3) * g / c1;
    return {down, L2 - K2 + m3 * g / c2 + 2 * down};
  }
};

/// Oscillations about the depths at rest in the directions that diagonalize both matrices.
template <class T>
struct Modes {
  std::array<T, 2> rest;
  NormalModes<T, 2> about_rest;

  explicit Modes(const Given<T>& p)
      : rest(p.at_rest()),
        about_rest(p.stiffness(), p.mass_matrix(), {p.y2 - rest[0], p.y3 - rest[1]}, {p.v2, p.v3}) {}
  std::array<T, 2> at(const T& t) const {
    const auto x = about_rest.at(t);
    return {rest[0] + x[0], rest[1] + x[1]};
  }
};

/// (y2, y3, y2', y3'). `lever` is the factor of the second spring's pull on the small pulley: 2, and 0 in the
/// published equations.
template <class T>
struct TwoCoordinates {
  Given<T> p;
  T lever = T(2);
  using State = std::array<T, 4>;
  State start() const { return {p.y2, p.y3, p.v2, p.v3}; }
  template <class X>
  void acceleration(const std::array<X, 2>& y, std::array<X, 2>& a) const {
    const X pull1 = p.c1 * p.stretch1(y), pull2 = p.c2 * p.stretch2(y);
    a = p.accelerations(std::array<X, 2>{p.m2 * p.g - pull1 + lever * pull2, p.m3 * p.g - pull2});
  }
  template <class X>
  void operator()(const std::array<X, 4>& x, std::array<X, 4>& dxdt, const X&) const {
    std::array<X, 2> a;
    acceleration(std::array<X, 2>{x[0], x[1]}, a);
    dxdt = {x[2], x[3], a[0], a[1]};
  }
  std::array<T, 2> observe(const State& x, const T&) const { return {x[0], x[1]}; }
  auto conserved(const State& x, const T&) const {
    return energy_of<T>(p.kinetic_energy(std::array{x[2], x[3]}), p.potential_energy(std::array{x[0], x[1]}));
  }
};

/// Depths and pulley angles as independent coordinates; the ropes' tensions on the far sides of the pulleys
/// keep them from slipping. The springs' lengths follow from the rope that has run over their pulley.
template <class T>
struct FourCoordinates {
  Given<T> p;
  using State = std::array<T, 8>;
  State start() const {
    return {p.y2, p.y3, p.y2 / p.R1, (p.y3 - p.y2) / p.R2, p.v2, p.v3, p.v2 / p.R1, (p.v3 - p.v2) / p.R2};
  }
  template <class X>
  void acceleration(const std::array<X, 4>& x, std::array<X, 4>& a) const {
    const X pull1 = p.c1 * (p.R1 * x[2] + p.K1 - p.L1), pull2 = p.c2 * (p.R2 * x[3] - x[0] + p.K2 - p.L2);
    const T b1 = p.R1 * p.R1 / p.I1, b2 = p.R2 * p.R2 / p.I2;
    const T a11 = b1 + 1 / p.m2, a12 = -1 / p.m2, a22 = b2 + 1 / p.m3 + 1 / p.m2, det = a11 * a22 - a12 * a12;
    const X f1 = b1 * pull1 + p.g + pull2 / p.m2, f2 = (b2 - 1 / p.m2) * pull2;
    const X t1 = (a22 * f1 - a12 * f2) / det, t2 = (a11 * f2 - a12 * f1) / det;
    a = {p.g + (pull2 + t2 - t1) / p.m2, p.g - t2 / p.m3, p.R1 * (t1 - pull1) / p.I1,
         p.R2 * (t2 - pull2) / p.I2};
  }
  template <class X>
  void operator()(const std::array<X, 8>& x, std::array<X, 8>& dxdt, const X&) const {
    std::array<X, 4> a;
    acceleration(std::array<X, 4>{x[0], x[1], x[2], x[3]}, a);
    dxdt = {x[4], x[5], x[6], x[7], a[0], a[1], a[2], a[3]};
  }
  std::array<T, 2> observe(const State& x, const T&) const { return {x[0], x[1]}; }
  auto conserved(const State& x, const T&) const {
    return energy_of<T>(p.kinetic_energy(std::array{x[4], x[5]}), p.potential_energy(std::array{x[0], x[1]}));
  }
  /// Slip of the ropes on their pulleys.
  std::array<T, 2> constraints(const State& x, const T&) const {
    return {x[0] - p.R1 * x[2], x[1] - x[0] - p.R2 * x[3]};
  }
};

/// From the simplest to the richest.
template <class T>
auto models(const Given<T>& p) {
  return std::tuple{TwoCoordinates<T>{p, T(0)}, TwoCoordinates<T>{p}, FourCoordinates<T>{p}};
}

}  // namespace oddity::two_pulleys
