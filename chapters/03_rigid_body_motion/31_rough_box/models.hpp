#pragma once

#include <array>
#include <cstddef>
#include <string_view>
#include <tuple>

#include "chapters/numbers.hpp"

/// The models of exercise 3.31: a box that slides and rotates on a rough level plane.
namespace oddity::rough_box {

template <class T>
using Three = std::array<T, 3>;

/// The base of a box, 2a by 2b, under uniform pressure.
template <class T>
struct Contact {
  T a, b;

  T gyration() const { return sqrt((a * a + b * b) / 3); }

  /// Means over the base of the unit velocity n and its moment rho x n, if the center moves with (u, v) along
  /// the base's axes and rotates with w. Zero at rest.
  template <class X>
  Three<X> means(const X& u, const X& v, const X& w) const {
    return as_function("friction(u, v, w)", Three<X>{u, v, w},
                       [&](const Three<X>& moving) { return by_place(moving[0], moving[1], moving[2]); });
  }

  /// By points if c, the instantaneous center, is far outside the base; otherwise by corners.
  template <class X>
  Three<X> by_place(const X& u, const X& v, const X& w) const {
    const X slide = sqrt(u * u + v * v), turn = abs(w) * select(a < b, b, a);
    return either(
        slide + turn > X(1e-100),
        [&] {
          return either(
              slide > 6 * turn, [&] { return by_points(u, v, w); }, [&] { return by_corners(u, v, w); });
        },
        [] {
          return Three<X>{X(0), X(0), X(0)};
        });
  }

  /// About c the velocity is w k x (rho - c). By the divergence theorem, the integrals of the distance r from
  /// c and of its gradient are those of r along the four edges. So they are differences of primitives at the
  /// corners.
  template <class X>
  Three<X> by_corners(const X& u, const X& v, const X& w) const {
    const X cx = -v / w, cy = u / w;
    const Three<X> sums = sum_over(w, corners, [&](const std::array<X, 2>& side) {
      const X px = a * side[0] - cx, py = b * side[1] - cy, sign = side[0] * side[1];
      const X x = sign * primitive(px, py), y = sign * primitive(py, px);
      return Three<X>{x, y, px * x + py * y};
    });
    const X over = select(w > X(0), X(1), X(-1)) / (4 * a * b);
    return {-over * sums[1], over * sums[0], over * (sums[2] / 3 + cx * sums[0] + cy * sums[1])};
  }

  /// Eight by eight Gauss-Legendre points: exact to rounding if c is far outside the base, where the edges'
  /// terms cancel.
  template <class X>
  Three<X> by_points(const X& u, const X& v, const X& w) const {
    return sum_over(w, gauss_points, [&](const std::array<X, 2>& along) {
      const X px = a * along[0], vy = v + w * px;
      return sum_over(w, gauss_points, [&](const std::array<X, 2>& across) {
        const X py = b * across[0], vx = u - w * py;
        const X part = along[1] * across[1] / 4 / sqrt(vx * vx + vy * vy);
        return Three<X>{part * vx, part * vy, part * (px * vy - py * vx)};
      });
    });
  }

 private:
  /// Places from -1 to 1, and weights.
  static constexpr std::array<std::array<double, 2>, 8> gauss_points{
      {{-0.9602898564975363, 0.1012285362903763},
       {-0.7966664774136267, 0.2223810344533745},
       {-0.5255324099163290, 0.3137066458778873},
       {-0.1834346424956498, 0.3626837833783620},
       {0.1834346424956498, 0.3626837833783620},
       {0.5255324099163290, 0.3137066458778873},
       {0.7966664774136267, 0.2223810344533745},
       {0.9602898564975363, 0.1012285362903763}}};

  static constexpr std::array<std::array<double, 2>, 4> corners{{{-1, -1}, {1, -1}, {-1, 1}, {1, 1}}};

  /// An integral of sqrt(k^2 + y^2) over y.
  template <class X>
  static X primitive(const X& k, const X& y) {
    const X r = sqrt(k * k + y * y), distance = abs(k);
    return either(
        distance > X(0),
        [&] {
          const X arsinh = log((abs(y) + r) / distance);
          return X((y * r + k * k * select(y < X(0), X(-arsinh), arsinh)) / 2);
        },
        [&] { return X(y * r / 2); });
  }
};

/// The exercise's parameters: a box on a level plane of friction mu; it starts along its own axes.
template <class T>
struct Given {
  Contact<T> foot;
  T mu, g, u0, v0, w0;

  T J() const { return foot.gyration() * foot.gyration(); }
  template <class X>
  X speed(const X& u, const X& v, const X& w) const {
    return sqrt(u * u + v * v + J() * w * w);
  }
  /// Accelerations in space of the box at the angle theta.
  template <class X>
  Three<X> friction(const X& theta, const X& u, const X& v, const X& w) const {
    const X C = cos(theta), S = sin(theta);
    const Three<X> e = foot.means(X(C * u + S * v), X(C * v - S * u), w);
    const T most = -mu * g;
    return {most * (C * e[0] - S * e[1]), most * (S * e[0] + C * e[1]), most / J() * e[2]};
  }
  T sliding_time() const { return hypot(u0, v0) / (mu * g); }
  T spinning_time() const {
    return abs(w0) / abs(friction(T(0), T(0), T(0), select(abs(w0) > T(0), w0, T(1)))[2]);
  }
  /// An upper bound of the motion's duration.
  T long_enough() const { return T(1.5) * (sliding_time() + spinning_time()); }
};

/// Sliding and spinning, each alone and at a steady deceleration to rest.
template <class T>
struct Uncoupled {
  Given<T> p;
  Three<T> at(const T& t) const {
    const auto way = [&](const T& speed, const T& rest) {
      const T on = select(rest < t, rest, t);
      return select(rest > T(0), T(speed * on * (1 - on / (2 * rest))), T(0));
    };
    const T slide = p.sliding_time(), spin = p.spinning_time();
    return {way(p.u0, slide), way(p.v0, slide), way(p.w0, spin)};
  }
};

inline constexpr std::string_view kink =
    "where the instantaneous center crosses an edge of the foot, friction has no second derivative";

/// (x, y, theta, u, v, w) in time; `softness` replaces v/|v| by v/sqrt(v^2 + softness^2).
template <class T>
struct InTime {
  Given<T> p;
  T softness = T(0);
  static constexpr std::string_view not_analytic = kink;

  using State = std::array<T, 6>;
  State start() const { return {T(0), T(0), T(0), p.u0, p.v0, p.w0}; }
  Three<T> observe(const State& x, const T&) const { return {x[0], x[1], x[2]}; }
  template <class X>
  void operator()(const std::array<X, 6>& x, std::array<X, 6>& dxdt, const X&) const {
    const Three<X> f = p.friction(x[2], x[3], x[4], x[5]);
    const X share = either(
        softness > T(0),
        [&] {
          const X now = p.speed(x[3], x[4], x[5]);
          return X(now / sqrt(now * now + softness * softness));
        },
        [] { return X(1); });
    dxdt = {x[3], x[4], x[5], f[0] * share, f[1] * share, f[2] * share};
  }
  T speed(const State& x) const { return p.speed(x[3], x[4], x[5]); }
  /// Deceleration of a moving box, from its rates.
  T braking(const State& x, const State& rate) const {
    return -(x[3] * rate[3] + x[4] * rate[4] + p.J() * x[5] * rate[5]) / speed(x);
  }
  /// Time to rest at a steady deceleration from now on.
  T time_left(const State& x, const State& rate) const { return speed(x) / braking(x, rate); }
  /// The state at rest after that time.
  State coasted(const State& x, const State& rate) const {
    const T left = time_left(x, rate);
    return {x[0] + x[3] * left / 2, x[1] + x[4] * left / 2, x[2] + x[5] * left / 2, T(0), T(0), T(0)};
  }
};

/// In time until a two-thousandth of the speed remains, then at a steady deceleration to rest.
template <class T>
struct UntilRest : InTime<T> {
  using MovesAs = InTime<T>;
  using typename InTime<T>::State;
  std::array<T, 1> guards(const State& x, const T&) const {
    return {this->speed(x) - T(5e-4) * this->speed(this->start())};
  }
  Happening<State> at_event(std::size_t, const State& x, const T& t) const {
    State rate;
    (*this)(x, rate, t);
    return {this->coasted(x, rate), true};
  }
};

/// In time by its own steps, each of which tests whether friction can stop the box within it.
template <class T>
struct WithStickTest : InTime<T> {
  bool by_midpoint;  ///< otherwise by semi-implicit Euler
  using typename InTime<T>::State;

  WithStickTest(const Given<T>& given, bool midpoint) : InTime<T>{given}, by_midpoint(midpoint) {}
  /// Makes a step with the right side `rates`, which may count calls. Returns whether the box rests from then
  /// on.
  template <class Rates>
  bool step(const Rates& rates, State& x, T t, T h) const {
    const T now = this->speed(x);
    if (now == T(0)) return true;
    State rate{}, middle{};
    rates(x, rate, t);
    if (now <= h * this->braking(x, rate)) {
      x = this->coasted(x, rate);
      return true;
    }
    if (by_midpoint) {
      for (std::size_t i = 0; i < 6; ++i) middle[i] = x[i] + h / 2 * rate[i];
      rates(middle, rate, t + h / 2);
      for (std::size_t i = 0; i < 6; ++i) x[i] += h * rate[i];
    } else {
      for (std::size_t i = 3; i < 6; ++i) x[i] += h * rate[i];
      for (std::size_t i = 0; i < 3; ++i) x[i] += h * x[i + 3];
    }
    return false;
  }
};

/// (x, y, theta, u, v, w, t) in the stretched time s, dt = speed ds: rest comes about as exp(-mu g s).
template <class T>
struct Stretched {
  Given<T> p;
  static constexpr std::string_view not_analytic = kink;

  using State = std::array<T, 7>;
  State start() const { return {T(0), T(0), T(0), p.u0, p.v0, p.w0, T(0)}; }
  T end() const { return 45 / (p.mu * p.g); }
  Three<T> observe(const State& x, const T&) const { return {x[0], x[1], x[2]}; }
  template <class X>
  void operator()(const std::array<X, 7>& x, std::array<X, 7>& dxds, const X&) const {
    const X now = p.speed(x[3], x[4], x[5]);
    const Three<X> f = p.friction(x[2], x[3], x[4], x[5]);
    dxds = {now * x[3], now * x[4], now * x[5], now * f[0], now * f[1], now * f[2], now};
  }
};

/// From the simplest to the richest.
template <class T>
auto models(const Given<T>& p) {
  return std::tuple{Uncoupled<T>{p}, InTime<T>{p, T(0.01)}, InTime<T>{p}, UntilRest<T>{{p}}, Stretched<T>{p}};
}

}  // namespace oddity::rough_box
