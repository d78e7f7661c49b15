#pragma once

// The curves and quantities of exercise 3.29.

#include <array>
#include <cmath>
#include <numbers>
#include <string>

#include "chapters/03_rigid_body_motion/29_planar_wire/models.hpp"
#include "chapters/scene.hpp"
#include "solvers/dual.hpp"
#include "solvers/quadrature.hpp"

namespace oddity::planar_wire {

enum class Shape { straight, semicircle, parabola };

/// A wire of the size q: from (0, 0) to (q, 0); the upper half circle of radius q; y = x^2 from 0 to q. Its
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

  /// The integral of f(u) ds by Gauss and Legendre with 32 points.
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

/// By the primitives of the moments, the density uniform.
inline Inertia by_primitives(const Wire& w) {
  const double q = w.q;
  if (w.shape == Shape::straight) return about_center(w.d0 * q, w.d0 * q * q / 2, 0, w.d0 * q * q * q / 3);
  if (w.shape == Shape::semicircle) {
    const double m = std::numbers::pi * q * w.d0;
    return about_center(m, 0, 2 * q * q * w.d0, m * q * q);
  }
  return inertia_of_parabola(q, w.d0);
}

// ---- the inertia as a quantity ----------------------------------------------------------------------------

/// The four moments by a rule over [a, b] in a parameter u of the curve.
template <class Rule, class Position, class Stretch>
Answer inertia_by(const Rule& rule, double a, double b, double d0, const Position& at,
                  const Stretch& stretch) {
  Answer answer;
  const auto moment = [&](const auto& f) {
    const Integral integral = rule(
        [&](double u) {
          const Point p = at(u);
          return f(p[0], p[1]) * d0 * stretch(u);
        },
        a, b);
    answer.evaluations += integral.evaluations;
    if (!integral.reached()) answer.ending = integral.ending, answer.message = integral.message;
    return integral.value;
  };
  const double m0 = moment([](double, double) { return 1.0; });
  const double mx = moment([](double x, double) { return x; }),
               my = moment([](double, double y) { return y; });
  const double m2 = moment([](double x, double y) { return x * x + y * y; });
  answer.value = about_center(m0, mx, my, m2);
  return answer;
}

/// The usual rules for a curve's parametrization.
template <class Position, class Stretch>
void add_rules(Quantity& quantity, const std::string& name, double a, double b, double d0, const Position& at,
               const Stretch& stretch, std::array<Outcome, 3> expected, const std::string& why = {}) {
  const auto row = [&](const std::string& algorithm, const Knob& knob, Outcome outcome, auto rule) {
    quantity.add({name, algorithm, knob,
                  [=](double setting) {
                    const auto set = [=](const auto& f, double from, double to) {
                      return rule(f, from, to, setting);
                    };
                    return inertia_by(set, a, b, d0, at, stretch);
                  },
                  outcome, outcome == Outcome::ok ? "" : why});
  };
  row("Simpson", doubling("panels", 2, 10), expected[0], [](const auto& f, double from, double to, double n) {
    return simpson(f, from, to, static_cast<int>(n));
  });
  row("Gauss-Legendre", doubling("points", 1, 7), expected[1],
      [](const auto& f, double from, double to, double n) {
        return gauss_legendre(f, from, to, static_cast<int>(n));
      });
  row("QAGS", tolerances(), expected[2],
      [](const auto& f, double from, double to, double e) { return qags(f, from, to, e); });
}

/// mu0, the center of mass and mu2 of a uniform wire.
inline Quantity inertia(const std::string& name, const Wire& w, const Reference& truth) {
  Quantity quantity =
      oddity::quantity(name, "kg, m, m, kg m^2", "mu0, the center of mass and mu2 of the " + name,
                       truth("03_29_inertia", {static_cast<double>(w.shape), w.q, w.d0}), {});
  quantity.need = {1e-10 * size_of(quantity.reference.value), "ten digits of the largest"};
  const std::string by_x = "as a graph over x";
  const auto own = [w](double u) { return w.point(u); };
  const auto stretch = [w](double u) { return w.stretch(u); };
  constexpr auto ok = Outcome::ok;
  if (w.shape != Shape::semicircle) {
    add_rules(quantity, by_x, 0, w.end(), w.d0, own, stretch, {ok, ok, ok});
    return quantity;
  }
  add_rules(quantity, "by the angle", 0, w.end(), w.d0, own, stretch, {ok, ok, ok});
  add_rules(
      quantity, by_x, -w.q, w.q, w.d0,
      [w](double x) {
        return Point{x, std::sqrt(w.q * w.q - x * x)};
      },
      [w](double x) { return w.q / std::sqrt(w.q * w.q - x * x); },
      {Outcome::non_finite, Outcome::inaccurate, ok}, "ds/dx is infinite at both ends");
  return quantity;
}

// ---- the falling wire -------------------------------------------------------------------------------------

inline Quantity fall(const Wire& wire, const Thrown& thrown, const Horizon& horizon, const Reference& truth) {
  const Known known =
      trajectory(truth, "03_29_fall", {wire.q, wire.d0, thrown.u, thrown.v, thrown.w, thrown.g}, horizon);
  Quantity q =
      quantity("fall", "m", "position of the wire's first end at four times", known, {1e-6, "a micrometre"});
  Ladder(q, horizon, halving("step", 0.125, 10), tolerances())
      .closed_form("center alone", PointMass{thrown}, Outcome::inaccurate, "the wire turns")
      .closed_form("free fall", FreeFall{thrown})
      .by_common("x, y, theta", Generalized{thrown})
      .by_others("x, y, theta", Generalized{thrown},
                 {{"linearly implicit Euler", Outcome::inaccurate,
                   "its order is too low for this need at this step"}})
      .by_common("two particles and a rod", TwoParticles{thrown}, Outcome::inaccurate);
  return q;
}

}  // namespace oddity::planar_wire
