#pragma once

#include <array>
#include <cmath>
#include <string>

#include "chapters/02_basic_concepts/shared/vectors.hpp"
#include "chapters/exercise.hpp"
#include "chapters/random.hpp"
#include "solvers/quadrature.hpp"

/// Integrals over plane and solid bodies: the rules by name, several integrals as one answer, and points in a
/// box around the body.
namespace oddity::bodies {

using namespace basic_vectors;

// ---- center of mass ---------------------------------------------------------------------------------------

/// The center of particles with a mass m at r, updated by the lever rule for each particle.
template <class Particles>
Vector center_by_lever_rule(const Particles& particles) {
  Vector center{};
  double mass = 0;
  for (const auto& p : particles) {
    mass += p.m;
    center = center + p.m / mass * (p.r - center);
  }
  return center;
}

// ---- inertia ----------------------------------------------------------------------------------------------

/// Ixx, Iyy, Izz and the products of inertia Ixy, Ixz, Iyz; the off-diagonal elements of the inertia tensor
/// are -Ixy, -Ixz, -Iyz.
using Six = std::array<double, 6>;
constexpr const char* inertia_names[] = {"Ixx", "Iyy", "Izz", "Ixy", "Ixz", "Iyz"};

/// The six components of a mass at r.
inline Six inertia_of(double mass, const Vector& r) {
  const auto [x, y, z] = r;
  return {mass * (y * y + z * z), mass * (x * x + z * z), mass * (x * x + y * y),
          mass * x * y,           mass * x * z,           mass * y * z};
}

/// Component k of a unit mass at r from the angular momentum J w = r x (w x r): Ixx = ex . J ex, Ixy = -ex .
/// J ey.
template <class T>
T inertia_component(std::size_t k, const std::array<T, 3>& r) {
  constexpr std::size_t turned[] = {0, 1, 2, 1, 2, 2}, seen[] = {0, 1, 2, 0, 0, 1};
  std::array<T, 3> axis{};
  axis[turned[k]] = 1.0;
  return (k < 3 ? 1.0 : -1.0) * cross(r, cross(axis, r))[seen[k]];
}
inline double inertia_by_definition(std::size_t k, const Vector& r) { return inertia_component(k, r); }

// ---- rules ------------------------------------------------------------------------------------------------

inline Rule gauss_rule(double points) {
  return [n = static_cast<int>(points)](FunctionOfOne f, double a, double b) {
    return gauss_legendre(f, a, b, n);
  };
}
inline Rule simpson_rule(double panels) {
  return [n = static_cast<int>(panels)](FunctionOfOne f, double a, double b) { return simpson(f, a, b, n); };
}
inline Rule trapezoid_rule(double panels) {
  return
      [n = static_cast<int>(panels)](FunctionOfOne f, double a, double b) { return trapezoid(f, a, b, n); };
}
inline Rule qags_rule(double tolerance) {
  return [=](FunctionOfOne f, double a, double b) { return qags(f, a, b, tolerance); };
}
inline Rule cquad_rule(double tolerance) {
  return [=](FunctionOfOne f, double a, double b) { return cquad(f, a, b, tolerance); };
}

/// The integral over two parts; its ending is that of the first failure.
inline Integral operator+(Integral a, const Integral& b) {
  a.value += b.value;
  a.evaluations += b.evaluations;
  a.error_estimate += b.error_estimate;
  if (a.reached()) {
    a.ending = b.ending;
    a.message = b.message;
  }
  return a;
}

/// `count` integrals, integrate(0), integrate(1), ..., as one answer: their total work, the largest error
/// estimate and the first failure.
template <class Integrate>
Answer all_of(std::size_t count, const Integrate& integrate) {
  Answer all{Value(std::vector<double>(count)), 0, 0};
  for (std::size_t k = 0; k < count; ++k) {
    const Integral one = integrate(k);
    all.value[k] = one.value;
    all.evaluations += one.evaluations;
    if (!(one.error_estimate <= all.error_estimate)) all.error_estimate = one.error_estimate;
    if (all.reached()) {
      all.ending = one.ending;
      all.message = one.message;
    }
  }
  return all;
}

// ---- points in a box --------------------------------------------------------------------------------------

/// The digits of i in the base, mirrored at the point (van der Corput sequence).
inline double mirrored(long i, int base) {
  double x = 0;
  for (double digit = 1.0 / base; i > 0; i /= base, digit /= base) x += digit * static_cast<double>(i % base);
  return x;
}

enum class Points { random, halton, cells };

/// The integral of f, which returns an array of components and is zero outside the body, over the unit box of
/// `dimension`. Random points estimate the error as four standard errors of the worst component.
template <std::size_t dimension, class F>
Answer over_unit_box(Points kind, long n, double seed, const F& f) {
  using Point = std::array<double, dimension>;
  constexpr int bases[] = {2, 3, 5};
  Random random(seed);
  const long side = std::lround(std::pow(static_cast<double>(n), 1.0 / dimension));
  if (kind == Points::cells) n = static_cast<long>(std::pow(static_cast<double>(side), dimension) + 0.5);
  decltype(f(Point{})) sum{}, squares{};
  for (long i = 0; i < n; ++i) {
    Point x;
    long cell = i;
    for (std::size_t k = 0; k < dimension; ++k, cell /= side)
      x[k] = kind == Points::random   ? random.unit()
             : kind == Points::halton ? mirrored(i + 1, bases[k])
                                      : (static_cast<double>(cell % side) + 0.5) / static_cast<double>(side);
    const auto at = f(x);
    for (std::size_t k = 0; k < at.size(); ++k) {
      sum[k] += at[k];
      squares[k] += at[k] * at[k];
    }
  }
  const double count = static_cast<double>(n);
  Answer all{sum, n * static_cast<long>(sum.size())};
  double variance = 0;
  for (std::size_t k = 0; k < sum.size(); ++k) {
    all.value[k] = sum[k] / count;
    variance = std::max(variance, squares[k] / count - all.value[k] * all.value[k]);
  }
  if (kind == Points::random) all.error_estimate = 4 * std::sqrt(variance / count);
  return all;
}

/// Adds the three choices of points as methods that are too inaccurate to pass.
template <std::size_t dimension, class F>
void add_box_methods(Quantity& quantity, const std::vector<double>& samples, double seed, const F& f) {
  const auto add = [&](Points kind, const std::string& name, const std::string& why) {
    quantity.add({"points in a box", name, Resolution{"samples", samples},
                  [=](double n) { return over_unit_box<dimension>(kind, static_cast<long>(n), seed, f); },
                  Outcome::inaccurate, why});
  };
  add(Points::random, "Monte Carlo", "the error shrinks as the root of the number of samples");
  add(Points::halton, "Halton", "the body's edge cuts through evenly spread points");
  add(Points::cells, "square cells", "the body's edge becomes a staircase of cells");
}

}  // namespace oddity::bodies
