#pragma once

#include "chapters/02_basic_concepts/shared/bodies.hpp"
#include "reference/reference.hpp"

/// The lamina x^2 <= y <= 1, left <= x <= 1: its inertia by columns, by rows, along its edge and from points.
namespace oddity::lamina {

using namespace bodies;

using std::abs, std::sqrt;
using InPlane = std::function<double(double x, double y)>;

inline double parabola(double x) { return x * x; }
inline double top(double) { return 1; }

/// x from `left` to 1, y from the parabola to the top.
inline Integral columns(const Rule& rule, const InPlane& f, double left) {
  return nested(rule, f, left, 1, parabola, top);
}

/// y from 0 to 1, x between the ends of the row; or, `by_root`, over u = sqrt(y), dy = 2 u du.
inline Integral rows(const Rule& rule, const InPlane& f, double left, bool by_root) {
  const auto weighted = [&](double u, double x) { return by_root ? 2 * u * f(x, u * u) : f(x, u); };
  const Bound right_end = [=](double u) { return by_root ? u : sqrt(u); };
  const Bound left_end = [=](double u) { return by_root ? -u : -sqrt(u); };
  const double corner = by_root ? abs(left) : left * left;
  Integral sum{0, 0, 0};
  if (corner < 1)
    sum = nested(
        rule, weighted, corner, 1, [=](double) { return left; }, right_end);
  if (left < 0) sum = sum + nested(rule, weighted, 0, corner, left_end, right_end);
  return sum;
}

struct Lamina {
  double left, z, rho;
  Six at(double x, double y) const { return inertia_of(rho, {x, y, z}); }
  /// The integrals of at() from 0 to x.
  Six primitive(double x, double y) const {
    const double cube = x * x * x / 3;
    return {rho * x * (y * y + z * z), rho * (cube + x * z * z), rho * (cube + x * y * y),
            rho * x * x * y / 2,       rho * x * x * z / 2,      rho * x * y * z};
  }
};

/// Green's theorem: the integral of f is that of Q dy around the edge, dQ/dx = f. The top has dy = 0; the
/// parabola has dy = 2 x dx.
inline Integral edge(const Rule& rule, const Lamina& l, std::size_t k) {
  const double corner = l.left * l.left;
  const Integral below = rule([&](double x) { return 2 * x * l.primitive(x, x * x)[k]; }, l.left, 1);
  if (!(corner < 1)) return below;
  return below + rule([&](double y) { return -l.primitive(l.left, y)[k]; }, corner, 1);
}

inline Quantity inertia(std::string name, std::string says, const Lamina& l, double seed,
                        const Reference& truth) {
  Quantity q = quantity(std::move(name), "", std::move(says), truth("02_13_lamina", {l.left, l.z, l.rho}),
                        {1e-10 * l.rho, "ten decimals for a unit density"});
  const auto component = [l](std::size_t k) { return [l, k](double x, double y) { return l.at(x, y)[k]; }; };
  const auto add = [&](const std::string& model, const auto& integrate, const std::string& algorithm,
                       Rule (*rule)(double), const std::string& too_slow = "") {
    const Knob knob = algorithm == "Simpson"          ? doubling("panels", 2, 7)
                      : algorithm == "Gauss-Legendre" ? doubling("points", 1, 5)
                                                      : tolerances();
    const auto run = [=](double setting) {
      return all_of(6, [&](std::size_t k) { return integrate(rule(setting), k); });
    };
    q.add({model, algorithm, knob, run, too_slow.empty() ? Outcome::ok : Outcome::inaccurate, too_slow});
  };
  const auto by_columns = [=](const Rule& rule, std::size_t k) {
    return columns(rule, component(k), l.left);
  };
  const auto by_rows = [=](const Rule& rule, std::size_t k) {
    return rows(rule, component(k), l.left, false);
  };
  const auto by_root = [=](const Rule& rule, std::size_t k) {
    return rows(rule, component(k), l.left, true);
  };
  const auto by_edge = [=](const Rule& rule, std::size_t k) { return edge(rule, l, k); };
  const std::string low_order = "the error shrinks as h^4: too slow for ten decimals at 128 panels";
  const std::string no_slope = "the width of a row, 2 sqrt(y), has no derivative at the vertex";
  add("columns", by_columns, "QAGS", qags_rule);
  add("columns", by_columns, "CQUAD", cquad_rule);
  add("columns", by_columns, "Gauss-Legendre", gauss_rule);
  add("columns", by_columns, "Simpson", simpson_rule, low_order);
  add("rows", by_rows, "QAGS", qags_rule);
  add("rows", by_rows, "CQUAD", cquad_rule);
  add("rows", by_rows, "Gauss-Legendre", gauss_rule, no_slope);
  add("rows", by_rows, "Simpson", simpson_rule, no_slope);
  add("rows by sqrt(y)", by_root, "Gauss-Legendre", gauss_rule);
  add("edge alone", by_edge, "QAGS", qags_rule);
  add("edge alone", by_edge, "Gauss-Legendre", gauss_rule);
  add("edge alone", by_edge, "Simpson", simpson_rule, low_order);
  add_box_methods<2>(q, {256, 1024, 4096, 16384, 65536}, seed, [l](const std::array<double, 2>& u) {
    const double width = 1 - l.left, x = l.left + width * u[0];
    Six f{};
    if (x * x <= u[1]) f = l.at(x, u[1]);
    for (double& each : f) each *= width;
    return f;
  });
  return q;
}

}  // namespace oddity::lamina
