#pragma once

// The models of exercise 3.31.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <type_traits>

namespace oddity::rough_box {

template <class T>
using Three = std::array<T, 3>;

/// A dual number's value.
template <class T>
double number(const T& x) {
  if constexpr (std::is_arithmetic_v<T>)
    return x;
  else
    return number(x.value);
}

/// The foot of a box, 2a by 2b, under uniform pressure.
struct Contact {
  double a, b;

  double gyration() const { return std::sqrt((a * a + b * b) / 3); }

  /// The means over the foot of the unit velocity n and of its moment rho x n, when the centre moves with
  /// (u, v) along the foot's axes and turns with w. Zero at rest.
  template <class T>
  Three<T> means(const T& u, const T& v, const T& w) const {
    const double slide = std::hypot(number(u), number(v)), turn = std::abs(number(w)) * std::max(a, b);
    if (slide + turn < 1e-100) return {T(0.0), T(0.0), T(0.0)};
    return slide > 6 * turn ? by_points(u, v, w) : by_edges(u, v, w);
  }

  /// About the instantaneous centre c the velocity is w k x (rho - c); the integrals of the distance r from
  /// c and of its gradient are, by the divergence theorem, those of r along the four edges.
  template <class T>
  Three<T> by_edges(const T& u, const T& v, const T& w) const {
    const T cx = -v / w, cy = u / w;
    const T right = a - cx, left = -a - cx, top = b - cy, bottom = -b - cy;
    const T on_right = along_edge(right, bottom, top), on_left = along_edge(left, bottom, top);
    const T on_top = along_edge(top, left, right), on_bottom = along_edge(bottom, left, right);
    const T x = on_right - on_left, y = on_top - on_bottom;
    const T r = (right * on_right - left * on_left + top * on_top - bottom * on_bottom) / 3.0;
    const double over = (number(w) > 0 ? 1 : -1) / (4 * a * b);
    return {-over * y, over * x, over * (r + cx * x + cy * y)};
  }

  /// Eight by eight points of Gauss and Legendre: exact to rounding when c is far outside the foot, where the
  /// edges' terms cancel.
  template <class T>
  Three<T> by_points(const T& u, const T& v, const T& w) const {
    constexpr std::array x{0.1834346424956498, 0.5255324099163290, 0.7966664774136267, 0.9602898564975363};
    constexpr std::array weight{0.3626837833783620, 0.3137066458778873, 0.2223810344533745,
                                0.1012285362903763};
    using std::sqrt;
    Three<T> mean{T(0.0), T(0.0), T(0.0)};
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t j = 0; j < 4; ++j)
        for (const double px : {-a * x[i], a * x[i]})
          for (const double py : {-b * x[j], b * x[j]}) {
            const T vx = u - w * py, vy = v + w * px;
            const T part = weight[i] * weight[j] / 4 / sqrt(vx * vx + vy * vy);
            mean[0] += part * vx;
            mean[1] += part * vy;
            mean[2] += part * (px * vy - py * vx);
          }
    return mean;
  }

 private:
  /// The integral of sqrt(k^2 + y^2) over y.
  template <class T>
  static T along_edge(const T& k, const T& y1, const T& y2) {
    using std::log, std::sqrt;
    const auto primitive = [&](const T& y) -> T {
      const T r = sqrt(k * k + y * y);
      if (number(k) == 0) return y * r / 2.0;
      const T size = number(y) < 0 ? -y : y, distance = number(k) < 0 ? -k : k;
      const T arsinh = log((size + r) / distance);
      return (y * r + k * k * (number(y) < 0 ? -arsinh : arsinh)) / 2.0;
    };
    return primitive(y2) - primitive(y1);
  }
};

/// A box on a level plane of friction mu; it starts along its own axes.
struct Box : Contact {
  double mu, g, u0, v0, w0;

  double J() const { return gyration() * gyration(); }
  template <class T>
  T speed(const T& u, const T& v, const T& w) const {
    using std::sqrt;
    return sqrt(u * u + v * v + J() * w * w);
  }
  /// Accelerations in space of the box at the angle theta.
  template <class T>
  Three<T> friction(const T& theta, const T& u, const T& v, const T& w) const {
    using std::cos, std::sin;
    const T C = cos(theta), S = sin(theta);
    const auto e = means(T(C * u + S * v), T(C * v - S * u), w);
    const double most = -mu * g;
    return {most * (C * e[0] - S * e[1]), most * (S * e[0] + C * e[1]), most / J() * e[2]};
  }
  double sliding_time() const { return std::hypot(u0, v0) / (mu * g); }
  double spinning_time() const {
    return std::abs(w0) / std::abs(friction(0.0, 0.0, 0.0, w0 == 0 ? 1.0 : w0)[2]);
  }
  /// Longer than the motion lasts.
  double long_enough() const { return 1.5 * (sliding_time() + spinning_time()); }
};

/// Sliding and spinning, each alone and at a steady deceleration until it is over.
struct Uncoupled : Box {
  Three<double> at(double t) const {
    const auto way = [t](double speed, double rest) {
      const double on = std::min(t, rest);
      return rest > 0 ? speed * on * (1 - on / (2 * rest)) : 0.0;
    };
    const double slide = sliding_time(), spin = spinning_time();
    return {way(u0, slide), way(v0, slide), way(w0, spin)};
  }
};

/// (x, y, theta, u, v, w) in time; `softness` replaces v/|v| by v/sqrt(v^2 + softness^2).
struct InTime : Box {
  using State = std::array<double, 6>;
  double softness = 0;
  State start() const { return {0, 0, 0, u0, v0, w0}; }
  Three<double> observe(const State& x, double) const { return {x[0], x[1], x[2]}; }
  template <class X, class T>
  void operator()(const X& x, X& dxdt, const T&) const {
    using std::sqrt;
    auto f = friction(x[2], x[3], x[4], x[5]);
    if (softness > 0) {
      const auto now = speed(x[3], x[4], x[5]);
      const auto share = now / sqrt(now * now + softness * softness);
      for (auto& component : f) component = component * share;
    }
    dxdt = {x[3], x[4], x[5], f[0], f[1], f[2]};
  }
};

/// (x, y, theta, u, v, w, t) in the stretched time s, dt = speed ds: rest is approached as exp(-mu g s).
struct Stretched : Box {
  using State = std::array<double, 7>;
  State start() const { return {0, 0, 0, u0, v0, w0, 0}; }
  double end() const { return 45 / (mu * g); }
  void operator()(const State& x, State& dxds, double) const {
    const double now = speed(x[3], x[4], x[5]);
    const auto f = friction(x[2], x[3], x[4], x[5]);
    dxds = {now * x[3], now * x[4], now * x[5], now * f[0], now * f[1], now * f[2], now};
  }
};

}  // namespace oddity::rough_box
