#pragma once

#include <array>
#include <tuple>

#include "chapters/numbers.hpp"

/// The models of exercise 3.15: a mass on a rod that rotates about the x3-axis at 45 degrees to it, starting
/// in the (x1, x3)-plane. A spring joins (c, 0, 0) to the mass. The observables are its position.
///   s  distance from the origin along the rod (the book's lambda)    w  angular speed of the rod
///   K  stiffness and  ell  rest length of the spring                 r  its length
namespace oddity::turning_rod {

template <class T>
T root_half() {
  return T(std::numbers::sqrt2 / 2);
}

/// The exercise's parameters; s0 is the initial s.
template <class T>
struct Given {
  T m, c, K, w, s0;

  /// The spring's initial length.
  T spring() const { return sqrt(s0 * s0 - T(std::numbers::sqrt2) * c * s0 + c * c); }
};

template <class T>
struct Rod : Given<T> {
  T ell = this->spring(), pull = this->K / this->m, foot = this->c * root_half<T>();

  /// The spring's fixed end projected on the rod.
  template <class X>
  X end_along(const X& t) const {
    return foot * cos(this->w * t);
  }
  /// The spring's length with the mass at s and its end projected to p.
  template <class X>
  X length(const X& s, const X& p) const {
    return sqrt(s * s - 2 * p * s + this->c * this->c);
  }
  /// s'' there, if the spring's length is r.
  template <class X>
  X acceleration(const X& s, const X& p, const X& r) const {
    return this->w * this->w / 2 * s - pull * (1 - ell / r) * (s - p);
  }

  std::array<T, 3> place(const T& s, const T& t) const {
    const T across = root_half<T>() * s;
    return {across * cos(this->w * t), across * sin(this->w * t), across};
  }
  /// The spring's energy when the mass is at x.
  template <class X>
  X energy(const std::array<X, 3>& x) const {
    const X stretch = sqrt((x[0] - this->c) * (x[0] - this->c) + x[1] * x[1] + x[2] * x[2]) - ell;
    return this->K / 2 * stretch * stretch;
  }
};

template <class T>
struct NoSpring {
  Rod<T> rod;
  std::array<T, 3> at(const T& t) const { return rod.place(rod.s0 * cosh(rod.w * root_half<T>() * t), t); }
};

/// The spring's fixed end moved to the origin: linear.
template <class T>
struct EndOnTheAxis {
  Rod<T> rod;
  std::array<T, 3> at(const T& t) const {
    const auto& [m, c, K, w, s0] = static_cast<const Given<T>&>(rod);
    const T pull = K / m - w * w / 2, rest = K / m * s0 / pull, frequency = sqrt(abs(pull));
    const T swung = cos(frequency * t), flown = cosh(frequency * t);
    return rod.place(rest + (s0 - rest) * select(pull > T(0), swung, flown), t);
  }
};

/// The spring replaced by a bar of its rest length: geometry alone determines the distance along the rod. NaN
/// if the bar does not reach the rod.
template <class T>
struct RigidSpring {
  Rod<T> rod;
  template <class X>
  X along(const X& t) const {
    const X p = rod.end_along(t);
    return p + sqrt(rod.ell * rod.ell - rod.c * rod.c + p * p);
  }
  std::array<T, 3> at(const T& t) const { return rod.place(along(t), t); }
};

/// (lambda, lambda') in the listing's arithmetic; `factor` multiplies the time inside the cosine.
template <class T>
struct AsListed {
  Rod<T> rod;
  T factor = root_half<T>();
  using State = std::array<T, 2>;
  State start() const { return {rod.s0, T(0)}; }
  template <class X>
  void operator()(const std::array<X, 2>& state, std::array<X, 2>& output, const X& time) const {
    const X tmp0 = rod.foot * cos(factor * time);
    const X tmp1 = state[0] - tmp0;
    const X tmp2 = state[0] - 2 * tmp0;
    const X tmp3 = state[0] * tmp2 + rod.c * rod.c;
    const X tmp4 = 1 - rod.ell * (1 / sqrt(tmp3));
    const T pi = T(std::numbers::pi);
    output = {state[1], pi * pi / 32 * state[0] - rod.pull * tmp4 * tmp1};
  }
  std::array<T, 3> observe(const State& x, const T& t) const { return rod.place(x[0], t); }
};

/// With the rest length sqrt((b-c)^2 + c^2), and the rod's rotation corrected.
template <class T>
AsListed<T> listed_with_other_rest_length(const Given<T>& p) {
  const T b = root_half<T>() * p.s0;
  return {{p, hypot(b - p.c, p.c)}, T(std::numbers::pi) / 4};
}

/// (s, s').
template <class T>
struct AlongTheRod {
  Rod<T> rod;
  using State = std::array<T, 2>;
  State start() const { return {rod.s0, T(0)}; }
  template <class X>
  void operator()(const std::array<X, 2>& x, std::array<X, 2>& dxdt, const X& t) const {
    const X p = rod.end_along(t);
    dxdt = {x[1], rod.acceleration(x[0], p, rod.length(x[0], p))};
  }
  std::array<T, 3> observe(const State& x, const T& t) const { return rod.place(x[0], t); }
};

/// (s, s', work). In the rod's frame the spring's end rotates and does this work; the energy in this frame
/// minus the work is conserved.
template <class T>
struct AlongTheRodWithWork {
  Rod<T> rod;
  using State = std::array<T, 3>;
  State start() const { return {rod.s0, T(0), T(0)}; }
  template <class X>
  void operator()(const std::array<X, 3>& x, std::array<X, 3>& dxdt, const X& t) const {
    const X p = rod.end_along(t), r = rod.length(x[0], p);
    dxdt = {x[1], rod.acceleration(x[0], p, r),
            rod.K * (1 - rod.ell / r) * rod.foot * x[0] * rod.w * sin(rod.w * t)};
  }
  std::array<T, 3> observe(const State& x, const T& t) const { return rod.place(x[0], t); }
  auto conserved(const State& x, const T& t) const {
    const T stretch = rod.length(x[0], rod.end_along(t)) - rod.ell;
    return energy_of<T>(rod.m * x[1] * x[1] / 2,
                        rod.K * stretch * stretch / 2 - rod.m * rod.w * rod.w * x[0] * x[0] / 4 - x[2]);
  }
};

/// (s, y, s', y', work) in the rotating plane of the rod and the horizontal across it, with centrifugal and
/// Coriolis forces. The rod's force across it keeps y'' zero. The spring's end rotates backward and does the
/// work.
template <class T>
struct InTheTurningPlane {
  Rod<T> rod;
  using State = std::array<T, 5>;
  State start() const { return {rod.s0, T(0), T(0), T(0), T(0)}; }
  /// From the spring's end to (s, y): along the rod, across it, and out of the plane, for the cosine C and
  /// the sine S of the rotation.
  template <class X>
  std::array<X, 3> spring(const X& s, const X& y, const X& C, const X& S) const {
    const X p = rod.foot * C;
    return {s - p, y + rod.c * S, p};
  }
  template <class X>
  void operator()(const std::array<X, 5>& x, std::array<X, 5>& dxdt, const X& t) const {
    const T w = rod.w;
    const X C = cos(w * t), S = sin(w * t);
    const auto d = spring(x[0], x[1], C, S);
    const X pull = -rod.pull * (1 - rod.ell / sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]));
    const X along = pull * d[0] + w * w / 2 * x[0] + 2 * w * root_half<T>() * x[3];
    const X across = pull * d[1] + w * w * x[1] - 2 * w * root_half<T>() * x[2], push = -across;
    const X by_end = -rod.m * pull * rod.c * w * (root_half<T>() * S * (d[0] - d[2]) + C * d[1]);
    dxdt = {x[2], x[3], along, across + push, by_end + rod.m * push * x[3]};
  }
  std::array<T, 3> observe(const State& x, const T& t) const {
    const auto r = rod.place(x[0], t);
    return {r[0] - x[1] * sin(rod.w * t), r[1] + x[1] * cos(rod.w * t), r[2]};
  }
  auto conserved(const State& x, const T& t) const {
    const T C = cos(rod.w * t), S = sin(rod.w * t);
    const auto d = spring(x[0], x[1], C, S);
    const T stretch = sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]) - rod.ell;
    const T speeds = x[2] * x[2] + x[3] * x[3], turned = x[0] * x[0] / 2 + x[1] * x[1];
    return energy_of<T>(rod.m * speeds / 2,
                        rod.K * stretch * stretch / 2 - rod.m * rod.w * rod.w * turned / 2 - x[4]);
  }
  std::array<T, 1> constraints(const State& x, const T&) const { return {x[1]}; }
};

/// (x, x', work): two forces normal to the rod keep the second derivatives of x . n1 and x . n2 zero and do
/// this work.
template <class T>
struct CartesianWithConstraints {
  Rod<T> rod;
  using State = std::array<T, 7>;
  State start() const {
    return {root_half<T>() * rod.s0,
            T(0),
            root_half<T>() * rod.s0,
            T(0),
            root_half<T>() * rod.s0 * rod.w,
            T(0),
            T(0)};
  }
  template <class X>
  void operator()(const std::array<X, 7>& x, std::array<X, 7>& dxdt, const X& t) const {
    const T w = rod.w, h = root_half<T>();
    const X C = cos(w * t), S = sin(w * t);
    const X y = x[0] - rod.c, pull = -rod.pull * (1 - rod.ell / sqrt(y * y + x[1] * x[1] + x[2] * x[2]));
    const std::array<X, 3> f{pull * y, pull * x[1], pull * x[2]};
    const X m1 = S * f[0] - C * f[1] + 2 * w * (C * x[3] + S * x[4]) + w * w * (C * x[1] - S * x[0]);
    const X m2 =
        h * (f[2] - C * f[0] - S * f[1] + 2 * w * (S * x[3] - C * x[4]) + w * w * (C * x[0] + S * x[1]));
    const std::array<X, 3> n{-S * m1 + h * C * m2, C * m1 + h * S * m2, -h * m2};
    dxdt = {x[3],
            x[4],
            x[5],
            f[0] + n[0],
            f[1] + n[1],
            f[2] + n[2],
            rod.m * (n[0] * x[3] + n[1] * x[4] + n[2] * x[5])};
  }
  std::array<T, 3> observe(const State& x, const T&) const { return {x[0], x[1], x[2]}; }
  auto conserved(const State& x, const T& t) const {
    return energy_of<T>(rod.m * (x[3] * x[3] + x[4] * x[4] + x[5] * x[5]) / 2,
                        rod.energy(observe(x, t)) - x[6]);
  }
  /// Distance from the rod: across it horizontally, and in its vertical plane.
  std::array<T, 2> constraints(const State& x, const T& t) const {
    const T C = cos(rod.w * t), S = sin(rod.w * t), outward = C * x[0] + S * x[1];
    return {C * x[1] - S * x[0], root_half<T>() * (outward - x[2])};
  }
};

/// From the simplest to the richest.
template <class T>
auto models(const Given<T>& p) {
  const Rod<T> rod{p};
  return std::tuple{NoSpring<T>{rod},
                    EndOnTheAxis<T>{rod},
                    RigidSpring<T>{rod},
                    AsListed<T>{rod},
                    listed_with_other_rest_length(p),
                    AlongTheRod<T>{rod},
                    AlongTheRodWithWork<T>{rod},
                    InTheTurningPlane<T>{rod},
                    CartesianWithConstraints<T>{rod}};
}

}  // namespace oddity::turning_rod
