#pragma once

#include <array>

#include "chapters/numbers.hpp"

/// A point that slides without friction on the surface x3 = h(x1, x2) under gravity. A surface offers
/// functions generic in the number type: height(x1, x2), gradient(x) and bend(x, v) = v^T (Hessian of h) v.
/// For momenta it also offers turn(x, v) = (Hessian of h) v.
namespace oddity::height_field {

/// (x1, x2, x1', x2').
template <class T, class Surface>
struct InPlane {
  using State = std::array<T, 4>;
  Surface surface;
  T g;
  State first;

  State start() const { return first; }
  template <class X>
  void operator()(const std::array<X, 4>& x, std::array<X, 4>& dxdt, const X&) const {
    const std::array<X, 2> q{x[0], x[1]}, n = surface.gradient(q);
    const X bend = surface.bend(q, std::array<X, 2>{x[2], x[3]});
    const X push = (g + bend) / (1 + n[0] * n[0] + n[1] * n[1]);
    dxdt = {x[2], x[3], -push * n[0], -push * n[1]};
  }
  std::array<T, 3> observe(const State& x, const T&) const {
    return {x[0], x[1], surface.height(x[0], x[1])};
  }
  auto conserved(const State& x, const T&) const {
    const std::array<T, 2> n = surface.gradient(std::array<T, 2>{x[0], x[1]});
    const T rise = n[0] * x[2] + n[1] * x[3];
    return energy_of<T>((x[2] * x[2] + x[3] * x[3] + rise * rise) / 2, g * surface.height(x[0], x[1]));
  }
};

/// (x1, x2, p1, p2) with the momenta p = x' + (grad h . x') grad h: Hamilton's equations.
template <class T, class Surface>
struct Momenta {
  using State = std::array<T, 4>;
  Surface surface;
  T g;
  State first;

  State start() const {
    const std::array<T, 2> n = surface.gradient(std::array<T, 2>{first[0], first[1]});
    const T rise = n[0] * first[2] + n[1] * first[3];
    return {first[0], first[1], first[2] + rise * n[0], first[3] + rise * n[1]};
  }
  template <class X>
  std::array<X, 2> velocity(const std::array<X, 4>& x, const std::array<X, 2>& n) const {
    const X rise = (n[0] * x[2] + n[1] * x[3]) / (1 + n[0] * n[0] + n[1] * n[1]);
    return {x[2] - rise * n[0], x[3] - rise * n[1]};
  }
  template <class X>
  void operator()(const std::array<X, 4>& x, std::array<X, 4>& dxdt, const X&) const {
    const std::array<X, 2> q{x[0], x[1]}, n = surface.gradient(q), v = velocity(x, n),
                                          turn = surface.turn(q, v);
    const X rise = n[0] * v[0] + n[1] * v[1];
    dxdt = {v[0], v[1], rise * turn[0] - g * n[0], rise * turn[1] - g * n[1]};
  }
  std::array<T, 3> observe(const State& x, const T&) const {
    return {x[0], x[1], surface.height(x[0], x[1])};
  }
  auto conserved(const State& x, const T&) const {
    const std::array<T, 2> v = velocity(x, surface.gradient(std::array<T, 2>{x[0], x[1]}));
    return energy_of<T>((v[0] * x[2] + v[1] * x[3]) / 2, g * surface.height(x[0], x[1]));
  }
};

}  // namespace oddity::height_field
