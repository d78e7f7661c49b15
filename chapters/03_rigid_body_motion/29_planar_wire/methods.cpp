// The quantities of exercise 3.29: mass and inertia of a wire, and its fall.

#include <array>
#include <cmath>
#include <string>

#include "chapters/03_rigid_body_motion/29_planar_wire/planar_wire.hpp"
#include "chapters/scene.hpp"
#include "solvers/quadrature.hpp"

namespace oddity::ex03_29 {

/// From antiderivatives of the moments, for uniform density.
Inertia by_primitives(const Wire& w) {
  const double q = w.q;
  if (w.shape == Shape::straight)
    return planar_wire::about_center<double>(w.d0 * q, w.d0 * q * q / 2, 0, w.d0 * q * q * q / 3);
  if (w.shape == Shape::semicircle) {
    const double m = std::numbers::pi * q * w.d0;
    return planar_wire::about_center<double>(m, 0, 2 * q * q * w.d0, m * q * q);
  }
  return planar_wire::inertia_of_parabola(q, w.d0);
}

namespace {

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
  answer.value = planar_wire::about_center<double>(m0, mx, my, m2);
  return answer;
}

/// Adds the usual rules for a curve's parametrization.
template <class Position, class Stretch>
void add_rules(Quantity& quantity, const std::string& name, double a, double b, double d0, const Position& at,
               const Stretch& stretch, std::array<Outcome, 3> expected, const std::string& why = {}) {
  const auto row = [&](const std::string& algorithm, const Resolution& resolution, Outcome outcome,
                       auto rule) {
    quantity.add({name, algorithm, resolution,
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
Quantity inertia(const std::string& name, const Wire& w, const Reference& truth) {
  Quantity quantity =
      oddity::quantity(name, "kg, m, m, kg m^2", R"($\mu_0$, the center of mass and $\mu_2$ of the )" + name,
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
      {Outcome::non_finite, Outcome::inaccurate, ok}, "$ds/dx$ is infinite at both ends");
  return quantity;
}

}  // namespace

std::vector<Quantity> inertias(const Given& given, const Reference& truth) {
  Quantity semicircle = inertia("semicircle", {Shape::semicircle, given.q, given.d, 0}, truth);
  semicircle.add(
      Breakdown{"As a graph over $x$ the half circle has vertical ends, where $ds/dx$ is infinite. A rule "
                "that takes the ends fails, and Gauss and Legendre's is off by @1 with @2 points. By the "
                "angle the integrands are smooth.",
                "as a graph over x, Gauss-Legendre",
                64,
                Outcome::inaccurate,
                "by the angle, Gauss-Legendre",
                16,
                {error_of(Side::broken), setting_of(Side::broken)}});
  return {inertia("straight wire", {Shape::straight, given.q, given.d, 0}, truth), semicircle,
          inertia("parabola", {Shape::parabola, given.q, given.d, 0}, truth)};
}

Quantity fall(const Given& given, const Horizon& horizon, const Reference& truth) {
  const Known known =
      trajectory(truth, "03_29_fall", {given.q, given.d, given.u, given.v, given.w, given.g}, horizon);
  const auto wire = planar_wire::thrown(given);
  Quantity q =
      quantity("fall", "m", "position of the wire's first end at four times", known, {1e-6, "a micrometre"});
  SceneMethods(q, horizon, halving("step", 0.125, 10), tolerances())
      .closed_form("center alone", planar_wire::PointMass<double>{wire}, Outcome::inaccurate,
                   "the wire turns")
      .closed_form("free fall", planar_wire::FreeFall<double>{wire})
      .by_engine_integrators("x, y, theta", planar_wire::Generalized<double>{wire})
      .by_remaining_integrators("x, y, theta", planar_wire::Generalized<double>{wire},
                                {{"linearly implicit Euler", Outcome::inaccurate,
                                  "its order is too low for this need at this step"}})
      .by_engine_integrators("two particles and a rod", planar_wire::TwoParticles<double>{wire},
                             Outcome::inaccurate);
  return q;
}

}  // namespace oddity::ex03_29
