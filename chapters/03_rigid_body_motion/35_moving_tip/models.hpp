#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <tuple>

#include "chapters/03_rigid_body_motion/33_heavy_top/models.hpp"

/// The models of exercise 3.35, the top of 3.33 with a moving tip: the models of 3.33 that support it, and
/// two more.
namespace oddity::moving_tip {

using heavy_top::AxisAndMomentum, heavy_top::EulerAngles, heavy_top::RigidBody, heavy_top::Vector;

/// The exercise's parameters: those of 3.33, and the tip's amplitude and frequency A and lambda.
template <class T>
struct Given : heavy_top::Top<T> {};

/// The top with its tip at rest: the solution's proposal for the axis.
template <class T>
heavy_top::Top<T> with_fixed_tip(heavy_top::Top<T> top) {
  top.A = T(0);
  return top;
}

/// Near the vertical, z = d_x + i d_y: z'' - i a z' - alpha z = (m l A lambda^2/mu1) sin(lambda t). NaN where
/// |z| > 1.
template <class T>
struct SmallTilt {
  heavy_top::Top<T> p;
  Vector<T> at(const T& t) const {
    const T a = p.a(), alpha = p.alpha(), square = p.lambda * p.lambda;
    // The response to the shaking: (f + b) sin(lambda t) + i (b - f) cos(lambda t).
    const T kick = p.m * p.l * p.A * square / p.mu1 / 2;
    const T f = kick / (-square + a * p.lambda - alpha), b = kick / (-square - a * p.lambda - alpha);
    // The rest of the initial state, rotating with a/2: y = exp(-i a t/2) (z - response), y'' = (alpha -
    // a^2/4) y.
    const AxisAndMomentum<T> model{p};
    typename AxisAndMomentum<T>::State rate;
    model(model.start(), rate, T(0));
    const T x = p.axis()[0], y = p.axis()[1] - (b - f);
    const T dx = rate[0] - p.lambda * (f + b) + a / 2 * y, dy = rate[1] - a / 2 * x;
    const T stiffness = a * a / 4 - alpha, n = sqrt(abs(stiffness));
    const auto swings = stiffness > T(0);
    const T even = select(swings, T(cos(n * t)), T(cosh(n * t))),
            odd = select(swings, T(sin(n * t)), T(sinh(n * t))) / n;
    const T u = x * even + dx * odd, v = y * even + dy * odd, C = cos(a / 2 * t), S = sin(a / 2 * t);
    const T now_x = C * u - S * v + (f + b) * sin(p.lambda * t),
            now_y = S * u + C * v + (b - f) * cos(p.lambda * t);
    return {now_x, now_y, sqrt(1 - (now_x * now_x + now_y * now_y))};
  }
};

/// The motion with the tip fixed, and its response to the shaking to first order in A: (d, L, delta d, delta
/// L).
template <class T>
struct FirstOrderInA {
  heavy_top::Top<T> p;
  using State = std::array<T, 12>;
  State start() const {
    State x;
    x.fill(T(0));
    const auto fixed = AxisAndMomentum<T>{p}.start();
    std::copy(fixed.begin(), fixed.end(), x.begin());
    return x;
  }
  template <class X>
  void operator()(const std::array<X, 12>& x, std::array<X, 12>& dxdt, const X& t) const {
    const Vector<X> d{x[0], x[1], x[2]}, L{x[3], x[4], x[5]}, dd{x[6], x[7], x[8]}, dL{x[9], x[10], x[11]};
    const Vector<X> weight{X(0), X(0), X(-p.m * p.g)}, push{-p.m * p.tip_acceleration(t), X(0), X(0)};
    const Vector<X> turn = cross(L, d), pull = cross(d, weight), turn_1 = cross(dL, d), turn_2 = cross(L, dd),
                    pull_1 = cross(dd, weight), pull_2 = cross(d, push);
    for (std::size_t i = 0; i < 3; ++i) {
      dxdt[i] = turn[i] / p.mu1;
      dxdt[3 + i] = p.l * pull[i];
      dxdt[6 + i] = (turn_1[i] + turn_2[i]) / p.mu1;
      dxdt[9 + i] = p.l * (pull_1[i] + pull_2[i]);
    }
  }
  Vector<T> observe(const State& x, const T&) const {
    const Vector<T> d{x[0] + x[6], x[1] + x[7], x[2] + x[8]};
    const T size = sqrt(dot(d, d));
    return {d[0] / size, d[1] / size, d[2] / size};
  }
  Vector<T> turning(const State& x, const T& t) const {
    return heavy_top::turning_of<T>(observe(x, t), {x[3] + x[9], x[4] + x[10], x[5] + x[11]}, p.spin(),
                                    p.mu1);
  }
};

/// From the simplest to the richest.
template <class T>
auto models(const Given<T>& p) {
  return std::tuple{AxisAndMomentum<T>{with_fixed_tip<T>(p)},
                    SmallTilt<T>{p},
                    FirstOrderInA<T>{p},
                    EulerAngles<T>{p},
                    RigidBody<T>{p},
                    AxisAndMomentum<T>{p}};
}

}  // namespace oddity::moving_tip
