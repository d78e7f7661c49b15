#pragma once

#include <cmath>
#include <numbers>
#include <vector>

#include "chapters/03_rigid_body_motion/29_planar_wire/models.hpp"
#include "chapters/exercise.hpp"
#include "solvers/quadrature.hpp"

/// Exercise 3.29's curves, methods and claims.
namespace oddity::ex03_29 {

using Given = planar_wire::Given<double>;
using Point = planar_wire::Point<double>;
using Inertia = planar_wire::Inertia<double>;

enum class Shape { straight, semicircle, parabola };

/// A wire of size q: from (0, 0) to (q, 0); the upper half circle of radius q; y = x^2 from 0 to q. Its
/// density is d0 (1 + k s/L) at the arc length s from its start.
struct Wire {
  Shape shape = Shape::straight;
  double q = 1, d0 = 1, k = 0;

  double end() const { return shape == Shape::semicircle ? std::numbers::pi : q; }
  Point point(double u) const {
    switch (shape) {
      case Shape::straight:
        return {u, 0};
      case Shape::semicircle:
        return {q * std::cos(u), q * std::sin(u)};
      case Shape::parabola:
        return {u, u * u};
    }
    return {};
  }
  /// ds/du
  double stretch(double u) const {
    return shape == Shape::straight ? 1 : shape == Shape::semicircle ? q : std::sqrt(1 + 4 * u * u);
  }
  double arc_length(double u) const {
    return shape == Shape::straight     ? u
           : shape == Shape::semicircle ? q * u
                                        : u * std::sqrt(1 + 4 * u * u) / 2 + std::asinh(2 * u) / 4;
  }
  double density(double u) const { return d0 * (1 + k * arc_length(u) / arc_length(end())); }

  /// The integral of f(u) ds by Gauss-Legendre with 32 points.
  template <class F>
  double along(const F& f) const {
    return gauss_legendre([&](double u) { return f(u) * stretch(u); }, 0, end(), 32).value;
  }
  template <class F>
  double over_mass(const F& f) const {
    return along([&](double u) { return f(u) * density(u); });
  }
  Point center() const {
    const double mass = over_mass([](double) { return 1; });
    return {over_mass([&](double u) { return point(u)[0]; }) / mass,
            over_mass([&](double u) { return point(u)[1]; }) / mass};
  }
};

/// From antiderivatives of the moments, for uniform density.
Inertia by_primitives(const Wire&);

Quantity fall(const Given&, const Horizon&, const Reference&);
/// Inertias of the three wires.
std::vector<Quantity> inertias(const Given&, const Reference&);
std::vector<Claim> claims(double seed);
Provables proofs();
std::vector<Root> roots();

}  // namespace oddity::ex03_29
