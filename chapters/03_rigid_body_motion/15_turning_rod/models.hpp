#pragma once

#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "chapters/numbers.hpp"

/// A mass on a rod that turns about the x3-axis at 45 degrees to it, starting in the (x1, x3)-plane, and a
/// spring from (c, 0, 0) to the mass: its models, whose observables are the position.
///   s  distance from the origin along the rod (the book's lambda)    w  angular speed of the rod
///   K  stiffness and  ell  rest length of the spring                 r  length of the spring
namespace oddity::turning_rod {

inline const double root_half = std::sqrt(0.5);

struct Spring {
  double c, K, ell;
  /// The energy when the other end is at x.
  template <class T>
  T energy(const std::array<T, 3>& x) const {
    using std::sqrt;
    const T stretch = sqrt((x[0] - c) * (x[0] - c) + x[1] * x[1] + x[2] * x[2]) - ell;
    return 0.5 * K * stretch * stretch;
  }
};

struct Rod {
  double m, c, K, w, s0;
  double ell = std::sqrt(s0 * s0 - std::numbers::sqrt2 * c * s0 + c * c);

  std::array<double, 3> place(double s, double t) const {
    const double across = root_half * s;
    return {across * std::cos(w * t), across * std::sin(w * t), across};
  }
};

struct NoSpring : Rod {
  std::array<double, 3> at(double t) const { return place(s0 * std::cosh(w * root_half * t), t); }
};

/// The spring's fixed end at the origin: linear.
struct EndOnTheAxis : Rod {
  std::array<double, 3> at(double t) const {
    const double pull = K / m - w * w / 2, rest = K / m * s0 / pull, frequency = std::sqrt(std::abs(pull));
    return place(rest + (s0 - rest) * (pull > 0 ? std::cos(frequency * t) : std::cosh(frequency * t)), t);
  }
};

/// The spring a bar of its rest length: the distance along the rod is a matter of geometry. Raised where the
/// bar does not reach the rod.
struct RigidSpring : Rod {
  std::array<double, 3> at(double t) const {
    const double p = c * root_half * std::cos(w * t), square = ell * ell - c * c + p * p;
    if (square < 0) throw std::domain_error("a bar as long as the spring does not reach the rod");
    return place(p + std::sqrt(square), t);
  }
};

/// (s, s').
struct AlongTheRod : Rod {
  using State = std::array<double, 2>;
  State start() const { return {s0, 0}; }
  double acceleration(double s, double t) const {
    const double p = c * root_half * std::cos(w * t);
    const double r = std::sqrt(s * s - 2 * p * s + c * c);
    return w * w / 2 * s - K / m * (1 - ell / r) * (s - p);
  }
  void operator()(const State& x, State& dxdt, double t) const { dxdt = {x[1], acceleration(x[0], t)}; }
  std::array<double, 3> observe(const State& x, double t) const { return place(x[0], t); }
};

/// (s, s', work): for the rod the spring's end turns, and does this work; the energy seen from the rod less
/// it is conserved.
struct AlongTheRodWithWork : Rod {
  using State = std::array<double, 3>;
  State start() const { return {s0, 0, 0}; }
  double length(double s, double t) const {
    return std::sqrt(s * s - std::numbers::sqrt2 * c * std::cos(w * t) * s + c * c);
  }
  void operator()(const State& x, State& dxdt, double t) const {
    const double pull = K * (1 - ell / length(x[0], t));
    dxdt = {x[1], AlongTheRod{*this}.acceleration(x[0], t),
            pull * c * root_half * x[0] * w * std::sin(w * t)};
  }
  std::array<double, 3> observe(const State& x, double t) const { return place(x[0], t); }
  auto conserved(const State& x, double t) const {
    const double stretch = length(x[0], t) - ell;
    return energy_of(m * x[1] * x[1] / 2, K * stretch * stretch / 2 - m * w * w * x[0] * x[0] / 4 - x[2]);
  }
};

/// (s, y, s', y', work) in the plane that turns with the rod and holds it and the horizontal across it:
/// centrifugal and Coriolis force, and the rod's push across that keeps y without acceleration. The spring's
/// end turns backward, and does the work.
struct InTheTurningPlane : Rod {
  using State = std::array<double, 5>;
  State start() const { return {s0, 0, 0, 0, 0}; }
  /// From the spring's end to (s, y): along the rod, across it, and out of the plane.
  std::array<double, 3> spring(double s, double y, double t) const {
    const double p = root_half * c * std::cos(w * t);
    return {s - p, y + c * std::sin(w * t), p};
  }
  void operator()(const State& x, State& dxdt, double t) const {
    const auto d = spring(x[0], x[1], t);
    const double pull = -K / m * (1 - ell / std::sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]));
    const double along = pull * d[0] + w * w / 2 * x[0] + 2 * w * root_half * x[3];
    const double across = pull * d[1] + w * w * x[1] - 2 * w * root_half * x[2], push = -across;
    const double C = std::cos(w * t), S = std::sin(w * t);
    const double by_end = -m * pull * c * w * (root_half * S * (d[0] - d[2]) + C * d[1]);
    dxdt = {x[2], x[3], along, across + push, by_end + m * push * x[3]};
  }
  std::array<double, 3> observe(const State& x, double t) const {
    const auto r = place(x[0], t);
    return {r[0] - x[1] * std::sin(w * t), r[1] + x[1] * std::cos(w * t), r[2]};
  }
  auto conserved(const State& x, double t) const {
    const auto d = spring(x[0], x[1], t);
    const double stretch = std::sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]) - ell;
    const double speeds = x[2] * x[2] + x[3] * x[3], turned = x[0] * x[0] / 2 + x[1] * x[1];
    return energy_of(m * speeds / 2, K * stretch * stretch / 2 - m * w * w * turned / 2 - x[4]);
  }
  double off_constraint(const State& x, double) const { return std::abs(x[1]); }
};

/// (x, x', work): two forces normal to the rod keep x . n1 and x . n2 without acceleration, and do this work.
struct CartesianWithConstraints : Rod {
  using State = std::array<double, 7>;
  State start() const { return {root_half * s0, 0, root_half * s0, 0, root_half * s0 * w, 0, 0}; }
  void operator()(const State& x, State& dxdt, double t) const {
    const double C = std::cos(w * t), S = std::sin(w * t), h = root_half;
    const double y = x[0] - c, pull = -K / m * (1 - ell / std::sqrt(y * y + x[1] * x[1] + x[2] * x[2]));
    const std::array f{pull * y, pull * x[1], pull * x[2]};
    const double m1 = S * f[0] - C * f[1] + 2 * w * (C * x[3] + S * x[4]) + w * w * (C * x[1] - S * x[0]);
    const double m2 =
        h * (f[2] - C * f[0] - S * f[1] + 2 * w * (S * x[3] - C * x[4]) + w * w * (C * x[0] + S * x[1]));
    const std::array n{-S * m1 + h * C * m2, C * m1 + h * S * m2, -h * m2};
    dxdt = {x[3],
            x[4],
            x[5],
            f[0] + n[0],
            f[1] + n[1],
            f[2] + n[2],
            m * (n[0] * x[3] + n[1] * x[4] + n[2] * x[5])};
  }
  std::array<double, 3> observe(const State& x, double) const { return {x[0], x[1], x[2]}; }
  auto conserved(const State& x, double) const {
    return energy_of(m * (x[3] * x[3] + x[4] * x[4] + x[5] * x[5]) / 2,
                     Spring{c, K, ell}.energy(observe(x, 0)) - x[6]);
  }
  /// From the rod: across it in the level, and in its upright plane.
  double off_constraint(const State& x, double t) const {
    const double C = std::cos(w * t), S = std::sin(w * t), outward = C * x[0] + S * x[1];
    return std::hypot(C * x[1] - S * x[0], root_half * (outward - x[2]));
  }
};

/// (lambda, lambda'), the listing's arithmetic; `factor` is what it multiplies the time by inside the cosine.
struct AsListed : Rod {
  using State = std::array<double, 2>;
  double factor = root_half;
  State start() const { return {s0, 0}; }
  void operator()(const State& state, State& output, double time) const {
    const double tmp0 = c * root_half * std::cos(factor * time);
    const double tmp1 = state[0] - tmp0;
    const double tmp2 = state[0] - 2.0 * tmp0;
    const double tmp3 = state[0] * tmp2 + c * c;
    const double tmp4 = 1.0 - ell * (1 / std::sqrt(tmp3));
    output = {state[1], std::numbers::pi * std::numbers::pi / 32.0 * state[0] - K / m * tmp4 * tmp1};
  }
  std::array<double, 3> observe(const State& x, double t) const { return place(x[0], t); }
};

/// With the rest length sqrt((b-c)^2 + c^2), the rod's turning mended.
inline AsListed listed_with_other_rest_length(const Rod& rod) {
  const double b = root_half * rod.s0;
  AsListed other_length{rod, std::numbers::pi / 4};
  other_length.ell = std::hypot(b - rod.c, rod.c);
  return other_length;
}

}  // namespace oddity::turning_rod
