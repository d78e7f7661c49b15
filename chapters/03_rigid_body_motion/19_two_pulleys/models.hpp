#pragma once

// The models of exercise 3.19.

#include <array>
#include <cmath>

#include "chapters/03_rigid_body_motion/shared/pair.hpp"
#include "chapters/numbers.hpp"

namespace oddity::two_pulleys {

struct Pulleys {
  double m2, m3, I1, I2, R1, R2, c1, c2, L1, L2, K1, K2, g, y2, y3, v2, v3;

  double turn1() const { return I1 / (R1 * R1); }
  double turn2() const { return I2 / (R2 * R2); }
  template <class T>
  T stretch1(const Two<T>& y) const {
    return y[0] + (K1 - L1);
  }
  template <class T>
  T stretch2(const Two<T>& y) const {
    return y[1] - 2.0 * y[0] + (K2 - L2);
  }
};

struct KineticEnergy : Pulleys {
  template <class T>
  T operator()(const Two<T>&, const Two<T>& v) const {
    const T turn1 = v[0] / R1, turn2 = (v[1] - v[0]) / R2;
    return 0.5 * (m2 * v[0] * v[0] + I1 * turn1 * turn1 + m3 * v[1] * v[1] + I2 * turn2 * turn2);
  }
};

struct PotentialEnergy : Pulleys {
  template <class T>
  T operator()(const Two<T>& y, const Two<T>&) const {
    const T s1 = stretch1(y), s2 = stretch2(y);
    return 0.5 * (c1 * s1 * s1 + c2 * s2 * s2) - g * (m2 * y[0] + m3 * y[1]);
  }
};

inline auto energy(const Pulleys& p, const Pair& y, const Pair& v) {
  return energy_of(KineticEnergy{p}(y, v), PotentialEnergy{p}(y, v));
}

/// M a = force in the two depths.
inline Pair solve_for_accelerations(const Pulleys& p, const Pair& force) {
  const double t = p.turn2(), small = p.m2 + p.turn1() + t, large = p.m3 + t, det = small * large - t * t;
  return {(large * force[0] + t * force[1]) / det, (t * force[0] + small * force[1]) / det};
}

/// The depths alone; `lever` is what the second spring's pull counts on the small pulley: twice, and not at
/// all in the published equations.
struct TwoCoordinates : Pulleys {
  double lever = 2;
  using State = std::array<double, 4>;
  State start() const { return {y2, y3, v2, v3}; }
  void acceleration(const Pair& y, Pair& a) const {
    const double pull1 = c1 * stretch1(y), pull2 = c2 * stretch2(y);
    a = solve_for_accelerations(*this, {m2 * g - pull1 + lever * pull2, m3 * g - pull2});
  }
  void operator()(const State& x, State& dxdt, double) const {
    Pair a;
    acceleration({x[0], x[1]}, a);
    dxdt = {x[2], x[3], a[0], a[1]};
  }
  Pair observe(const State& x, double) const { return {x[0], x[1]}; }
  auto conserved(const State& x, double) const { return energy(*this, {x[0], x[1]}, {x[2], x[3]}); }
};

/// Depths and pulley angles, free of one another; the ropes' tensions on the far sides of the pulleys keep
/// them from slipping. The springs are known by the rope that has run over their pulley.
struct FourCoordinates : Pulleys {
  using State = std::array<double, 8>;
  State start() const { return {y2, y3, y2 / R1, (y3 - y2) / R2, v2, v3, v2 / R1, (v3 - v2) / R2}; }
  void acceleration(const std::array<double, 4>& x, std::array<double, 4>& a) const {
    const double pull1 = c1 * (R1 * x[2] + K1 - L1), pull2 = c2 * (R2 * x[3] - x[0] + K2 - L2);
    const double b1 = R1 * R1 / I1, b2 = R2 * R2 / I2;
    const double a11 = b1 + 1 / m2, a12 = -1 / m2, a22 = b2 + 1 / m3 + 1 / m2;
    const double f1 = b1 * pull1 + g + pull2 / m2, f2 = (b2 - 1 / m2) * pull2, det = a11 * a22 - a12 * a12;
    const double t1 = (a22 * f1 - a12 * f2) / det, t2 = (a11 * f2 - a12 * f1) / det;
    a = {g + (pull2 + t2 - t1) / m2, g - t2 / m3, R1 * (t1 - pull1) / I1, R2 * (t2 - pull2) / I2};
  }
  void operator()(const State& x, State& dxdt, double) const {
    std::array<double, 4> a;
    acceleration({x[0], x[1], x[2], x[3]}, a);
    dxdt = {x[4], x[5], x[6], x[7], a[0], a[1], a[2], a[3]};
  }
  Pair observe(const State& x, double) const { return {x[0], x[1]}; }
  auto conserved(const State& x, double) const { return energy(*this, {x[0], x[1]}, {x[4], x[5]}); }
  /// What the ropes have slipped on their pulleys.
  double off_constraint(const State& x, double) const {
    return std::hypot(x[0] - R1 * x[2], x[1] - x[0] - R2 * x[3]);
  }
};

}  // namespace oddity::two_pulleys
