#pragma once

#include <array>

#include "chapters/numbers.hpp"

/// A point that slides without friction on the surface x3 = h(x1, x2) under gravity. A surface offers
/// height(x1, x2), generic in its number type; gradient(x); bend(x, v) = v^T (Hessian of h) v; and for
/// momenta turn(x, v) = (Hessian of h) v.
namespace oddity::height_field {

using Pair = std::array<double, 2>;

/// (x1, x2, x1', x2').
template <class Surface>
struct InPlane {
  using State = std::array<double, 4>;
  Surface surface;
  double g;
  State first;

  State start() const { return first; }
  void operator()(const State& x, State& dxdt, double) const {
    const Pair n = surface.gradient({x[0], x[1]});
    const double push = (g + surface.bend({x[0], x[1]}, {x[2], x[3]})) / (1 + n[0] * n[0] + n[1] * n[1]);
    dxdt = {x[2], x[3], -push * n[0], -push * n[1]};
  }
  std::array<double, 3> observe(const State& x, double) const {
    return {x[0], x[1], surface.height(x[0], x[1])};
  }
  auto conserved(const State& x, double) const {
    const Pair n = surface.gradient({x[0], x[1]});
    const double rise = n[0] * x[2] + n[1] * x[3];
    return energy_of((x[2] * x[2] + x[3] * x[3] + rise * rise) / 2, g * surface.height(x[0], x[1]));
  }
};

/// (x1, x2, p1, p2) with the momenta p = x' + (grad h . x') grad h: Hamilton's equations.
template <class Surface>
struct Momenta {
  using State = std::array<double, 4>;
  Surface surface;
  double g;
  State first;

  State start() const {
    const Pair n = surface.gradient({first[0], first[1]});
    const double rise = n[0] * first[2] + n[1] * first[3];
    return {first[0], first[1], first[2] + rise * n[0], first[3] + rise * n[1]};
  }
  Pair velocity(const State& x, const Pair& n) const {
    const double rise = (n[0] * x[2] + n[1] * x[3]) / (1 + n[0] * n[0] + n[1] * n[1]);
    return {x[2] - rise * n[0], x[3] - rise * n[1]};
  }
  void operator()(const State& x, State& dxdt, double) const {
    const Pair q{x[0], x[1]}, n = surface.gradient(q), v = velocity(x, n), turn = surface.turn(q, v);
    const double rise = n[0] * v[0] + n[1] * v[1];
    dxdt = {v[0], v[1], rise * turn[0] - g * n[0], rise * turn[1] - g * n[1]};
  }
  std::array<double, 3> observe(const State& x, double) const {
    return {x[0], x[1], surface.height(x[0], x[1])};
  }
  auto conserved(const State& x, double) const {
    const Pair v = velocity(x, surface.gradient({x[0], x[1]}));
    return energy_of((v[0] * x[2] + v[1] * x[3]) / 2, g * surface.height(x[0], x[1]));
  }
};

}  // namespace oddity::height_field
