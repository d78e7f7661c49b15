#pragma once

#include <numbers>

#include "chapters/02_basic_concepts/shared/bodies.hpp"
#include "reference/reference.hpp"

/// The half disc x^2 + y^2 <= 1, y >= 0 with the density exp(k x): its center of mass and how it balances
/// there.
namespace oddity::disc {

using namespace bodies;

using std::cos, std::sin, std::sqrt, std::numbers::pi;

using Moments = std::array<double, 3>;  // mass, and the first moments in x and y

inline Moments moments_of(double density, double x, double y) { return {density, density * x, density * y}; }

inline Integral by_columns(const Rule& rule, double k, std::size_t which) {
  return nested(
      rule, [=](double x, double y) { return moments_of(std::exp(k * x), x, y)[which]; }, -1, 1,
      [](double) { return 0.0; }, [](double x) { return sqrt(std::max(0.0, 1 - x * x)); });
}

/// Columns at x = sin u, as high as cos u and cos u du wide.
inline Integral by_sine(const Rule& rule, double k, std::size_t which) {
  return nested(
      rule, [=](double u, double y) { return cos(u) * moments_of(std::exp(k * sin(u)), sin(u), y)[which]; },
      -pi / 2, pi / 2, [](double) { return 0.0; }, [](double u) { return cos(u); });
}

inline Integral by_sectors(const Rule& rule, double k, std::size_t which) {
  return nested(
      rule,
      [=](double t, double r) {
        return r * moments_of(std::exp(k * r * cos(t)), r * cos(t), r * sin(t))[which];
      },
      0, pi, [](double) { return 0.0; }, [](double) { return 1.0; });
}

/// The center of mass, and the moments over mass about four lines through the true center, 45 degrees apart.
inline Quantity half_disc(double k, double phi, double seed, const Reference& truth) {
  const Known known = truth("02_09_half_disc", {k});
  const double mass = known.value[0], x = known.value[1], y = known.value[2];
  Quantity q{"half_disc",
             "m",
             "center of mass; first moment over mass about four lines through the true center",
             {known.source + "; zero", {x, y, 0, 0, 0, 0}},
             known.error / mass + 1e-15,
             {1e-10, "a tenth of a nanometre"},
             {},
             {}};
  const auto seen = [=](Answer a) {
    const double dx = a.value[1] - a.value[0] * x, dy = a.value[2] - a.value[0] * y;
    std::vector<double> all{a.value[1] / a.value[0], a.value[2] / a.value[0]};
    for (int j = 0; j < 4; ++j)
      all.push_back((cos(phi + j * pi / 4) * dy - sin(phi + j * pi / 4) * dx) / mass);
    a.value = all;
    a.error_estimate *= 2 / mass;
    return a;
  };
  const auto add = [&](const std::string& model, auto integral, const std::string& algorithm,
                       const Knob& knob, Rule (*rule)(double), const std::string& why = "") {
    q.add({model, algorithm, knob,
           [=](double setting) {
             return seen(all_of(3, [&](std::size_t which) { return integral(rule(setting), k, which); }));
           },
           why.empty() ? Outcome::ok : Outcome::inaccurate, why});
  };
  const Knob points = doubling("points", 4, 4), panels = doubling("panels", 8, 5);
  const std::string vertical = "the columns' height has a vertical tangent at both ends";
  add("columns", by_columns, "QAGS", tolerances(), qags_rule);
  add("columns", by_columns, "Gauss-Legendre", points, gauss_rule, vertical);
  add("columns", by_columns, "Simpson", panels, simpson_rule, vertical);
  add("columns at x = sin u", by_sine, "CQUAD", tolerances(), cquad_rule);
  add("columns at x = sin u", by_sine, "Gauss-Legendre", points, gauss_rule);
  add("columns at x = sin u", by_sine, "Simpson", panels, simpson_rule,
      "its error shrinks as h^4: too slow for ten digits at 128 panels");
  add("sectors", by_sectors, "QAGS", tolerances(), qags_rule);
  add("sectors", by_sectors, "Gauss-Legendre", points, gauss_rule);
  const std::size_t smooth = q.methods.size();
  add_box_methods<2>(q, {1024, 4096, 16384, 65536}, seed, [k](const std::array<double, 2>& u) {
    const double at = 2 * u[0] - 1;
    return at * at + u[1] * u[1] > 1 ? Moments{} : moments_of(2 * std::exp(k * at), at, u[1]);
  });
  for (std::size_t i = smooth; i < q.methods.size(); ++i)
    q.methods[i].run = [seen, run = q.methods[i].run](double n) { return seen(run(n)); };
  q.add(Breakdown{
      "32 Gauss points a side, exact to rounding over x = sin u, keep five digits over x: the half "
      "disc ends in vertical tangents.",
      "columns, Gauss-Legendre", 32, Outcome::inaccurate, "columns at x = sin u, Gauss-Legendre", 32});
  return q;
}

}  // namespace oddity::disc
