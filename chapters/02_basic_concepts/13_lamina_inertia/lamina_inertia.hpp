#pragma once

#include "chapters/02_basic_concepts/shared/bodies.hpp"

/// The lamina x^2 <= y <= 1, left <= x <= 1, and its inertia by columns and by rows; shared by 2.13's files.
namespace oddity::lamina_inertia {

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
  Integral sum;
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

std::vector<Claim> claims(double seed);
Provables proofs();

}  // namespace oddity::lamina_inertia
