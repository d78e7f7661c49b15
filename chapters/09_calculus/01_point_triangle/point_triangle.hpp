#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "chapters/exercise.hpp"
#include "chapters/numbers.hpp"

/// The point of a triangle closest to a point, by several algorithms, generic in the number type.
namespace oddity::ex09_01 {

template <class T>
using Vec = std::array<T, 3>;

template <class T>
Vec<T> operator+(const Vec<T>& a, const Vec<T>& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
template <class T>
Vec<T> operator-(const Vec<T>& a, const Vec<T>& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
template <class T>
Vec<T> operator*(const T& k, const Vec<T>& a) {
  return {k * a[0], k * a[1], k * a[2]};
}
template <class T>
T length(const Vec<T>& a) {
  using std::sqrt;
  return sqrt(dot(a, a));
}

template <class T>
struct Triangle {
  std::array<Vec<T>, 3> v;
  Vec<T> at(const T& s, const T& t) const { return v[0] + s * (v[1] - v[0]) + t * (v[2] - v[0]); }
};

/// f(s, t) = a00 s^2 + 2 a01 s t + a11 t^2 + 2 b0 s + 2 b1 t + c.
template <class T>
struct Quadratic {
  T a00, a01, a11, b0, b1, c;

  Quadratic(const std::array<T, 6>& k) : a00(k[0]), a01(k[1]), a11(k[2]), b0(k[3]), b1(k[4]), c(k[5]) {}
  Quadratic(const Triangle<T>& w, const Vec<T>& p) {
    const Vec<T> e1 = w.v[1] - w.v[0], e2 = w.v[2] - w.v[0], d = w.v[0] - p;
    a00 = dot(e1, e1), a01 = dot(e1, e2), a11 = dot(e2, e2);
    b0 = dot(e1, d), b1 = dot(e2, d), c = dot(d, d);
  }
  T determinant() const { return a00 * a11 - a01 * a01; }
  /// Its unconstrained minimum, times the determinant.
  std::array<T, 2> least_of_all() const { return {a01 * b1 - a11 * b0, a01 * b0 - a00 * b1}; }
  T operator()(const T& s, const T& t) const {
    return (a00 * s + b0 + b0) * s + (a11 * t + b1 + b1) * t + (a01 + a01) * s * t + c;
  }
};

template <class T>
struct Place {
  T s, t;
  int region;  ///< region of the unconstrained minimum: 0 inside, then 1 to 6 around the triangle
};

/// n/d clamped to [0, 1], divided only if needed.
template <class T>
T fraction(const T& n, const T& d) {
  return n <= T(0.0) ? T(0.0) : n >= d ? T(1.0) : n / d;
}

/// The minimum over s, t >= 0, s + t <= 1. The position of the unconstrained minimum decides which edges can
/// contain it [Schneider and Eberly, Geometric Tools for Computer Graphics, 2003, 10.3.2].
template <class T>
Place<T> by_regions(const Quadratic<T>& q) {
  const T zero = 0.0, one = 1.0;
  const T det = q.determinant();
  const auto [s, t] = q.least_of_all();
  const auto on_s = [&](int region) { return Place<T>{fraction(T(-q.b0), q.a00), zero, region}; };
  const auto on_t = [&](int region) { return Place<T>{zero, fraction(T(-q.b1), q.a11), region}; };
  const auto on_slant = [&](int region) {
    const T u = fraction(T(q.a11 + q.b1 - q.a01 - q.b0), T(q.a00 - q.a01 - q.a01 + q.a11));
    return Place<T>{u, one - u, region};
  };
  if (s + t <= det) {
    if (s < zero) {
      if (t < zero) return q.b0 < zero ? on_s(4) : on_t(4);
      return on_t(3);
    }
    if (t < zero) return on_s(5);
    return {s / det, t / det, 0};
  }
  if (s < zero) return q.a11 + q.b1 > q.a01 + q.b0 ? on_slant(2) : on_t(2);
  if (t < zero) return q.a00 + q.b0 > q.a01 + q.b1 ? on_slant(6) : on_s(6);
  return on_slant(1);
}

/// Takes the regions at the corners for the corners: the mistake that the sub-cases avoid.
template <class T>
Place<T> by_regions_without_sub_cases(const Quadratic<T>& q) {
  const Place<T> place = by_regions(q);
  if (place.region == 2) return {0.0, 1.0, 2};
  if (place.region == 4) return {0.0, 0.0, 4};
  if (place.region == 6) return {1.0, 0.0, 6};
  return place;
}

/// The square root of the quadratic's minimum.
template <class T>
T quadratic_distance(const Triangle<T>& w, const Vec<T>& p) {
  using std::sqrt;
  const Quadratic<T> q(w, p);
  const Place<T> place = by_regions(q);
  const T squared = q(place.s, place.t);
  return squared < T(0.0) ? T(0.0) : sqrt(squared);
}

/// The distance to the point at the minimum's parameters.
template <class T>
T region_distance(const Triangle<T>& w, const Vec<T>& p) {
  const Place<T> place = by_regions(Quadratic<T>(w, p));
  return length(w.at(place.s, place.t) - p);
}

/// Voronoi regions of vertices, edges and face [Ericson, Real-Time Collision Detection, 2005, 5.1.5].
template <class T>
T voronoi_distance(const Triangle<T>& w, const Vec<T>& p) {
  const T zero = 0.0;
  const auto& [a, b, c] = w.v;
  const Vec<T> ab = b - a, ac = c - a;
  const T d1 = dot(ab, p - a), d2 = dot(ac, p - a);
  if (d1 <= zero && d2 <= zero) return length(p - a);
  const T d3 = dot(ab, p - b), d4 = dot(ac, p - b);
  if (d3 >= zero && d4 <= d3) return length(p - b);
  const T vc = d1 * d4 - d3 * d2;
  if (vc <= zero && d1 >= zero && d3 <= zero) return length(w.at(d1 / (d1 - d3), zero) - p);
  const T d5 = dot(ab, p - c), d6 = dot(ac, p - c);
  if (d6 >= zero && d5 <= d6) return length(p - c);
  const T vb = d5 * d2 - d1 * d6;
  if (vb <= zero && d2 >= zero && d6 <= zero) return length(w.at(zero, d2 / (d2 - d6)) - p);
  const T va = d3 * d6 - d5 * d4;
  if (va <= zero && d4 >= d3 && d5 >= d6) {
    const T u = (d4 - d3) / ((d4 - d3) + (d5 - d6));
    return length(b + u * (c - b) - p);
  }
  const T sum = va + vb + vc;
  return length(w.at(vb / sum, vc / sum) - p);
}

template <class T>
T segment_distance(const Vec<T>& a, const Vec<T>& b, const Vec<T>& p) {
  const Vec<T> e = b - a;
  return length(a + fraction(dot(e, p - a), dot(e, e)) * e - p);
}

template <class T>
T edges_distance(const Triangle<T>& w, const Vec<T>& p) {
  const auto& [a, b, c] = w.v;
  return std::min({segment_distance(a, b, p), segment_distance(b, c, p), segment_distance(c, a, p)},
                  [](const T& x, const T& y) { return x < y; });
}

/// The distance to the plane if the foot of the perpendicular is on the inner side of all edges, otherwise to
/// the nearest edge.
template <class T>
T plane_distance(const Triangle<T>& w, const Vec<T>& p) {
  using std::abs;
  const auto& [a, b, c] = w.v;
  const Vec<T> n = cross(b - a, c - a);
  const auto inner = [&](const Vec<T>& from, const Vec<T>& to) {
    return dot(cross(n, to - from), p - from) > T(0.0);
  };
  if (!(inner(a, b) && inner(b, c) && inner(c, a))) return edges_distance(w, p);
  const T above = dot(n, p - a);
  return (above < T(0.0) ? -above : above) / length(n);
}

/// Least squares by modified Gram-Schmidt, with the point appended to the edges as a third column, so that s
/// and t keep their digits in thin triangles. Then the nearest edge, if it is nearer or s and t lie outside.
template <class T>
T orthogonal_distance(const Triangle<T>& w, const Vec<T>& p) {
  const T zero = 0.0;
  const Vec<T> e1 = w.v[1] - w.v[0], e2 = w.v[2] - w.v[0], y = p - w.v[0];
  const T r00 = length(e1);
  const T nearest = edges_distance(w, p);
  if (!(r00 > zero)) return nearest;
  const Vec<T> q1 = (T(1.0) / r00) * e1;
  const T r01 = dot(q1, e2), y0 = dot(q1, y);
  const Vec<T> rest = e2 - r01 * q1;
  const T r11 = length(rest);
  if (!(r11 > zero)) return nearest;
  const T t = dot((T(1.0) / r11) * rest, y - y0 * q1) / r11;
  const T s = (y0 - r01 * t) / r00;
  if (!(s >= zero && t >= zero && s + t <= T(1.0))) return nearest;
  const T inside = length(w.at(s, t) - p);
  return inside < nearest ? inside : nearest;
}

/// Computes relative to P, in units of the power of two below the largest coordinate, and scales back.
template <class T>
T scaled_distance(const Triangle<T>& w, const Vec<T>& p) {
  double largest = 0;
  for (const Vec<T>& vertex : w.v)
    for (const T& x : vertex - p) largest = std::max(largest, std::abs(static_cast<double>(x)));
  if (!(largest > 0) || !std::isfinite(largest)) return T(largest);
  const int exponent = std::ilogb(largest);
  Triangle<T> near;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t a = 0; a < 3; ++a)
      near.v[i][a] = std::ldexp(static_cast<double>(w.v[i][a] - p[a]), -exponent);
  return T(std::ldexp(static_cast<double>(orthogonal_distance(near, Vec<T>{})), exponent));
}

// ---- iterations -------------------------------------------------------------------------------------------

template <class T, class F>
T golden_section(const F& f, T a, T b, int steps) {
  const T share = 0.6180339887498949;
  T x = b - share * (b - a), y = a + share * (b - a), fx = f(x), fy = f(y);
  for (int i = 0; i < steps; ++i) {
    if (fx < fy) {
      b = y, y = x, fy = fx;
      x = b - share * (b - a), fx = f(x);
    } else {
      a = x, x = y, fx = fy;
      y = a + share * (b - a), fy = f(y);
    }
  }
  return std::min({fx, fy, f(a), f(b)}, [](const T& u, const T& v) { return u < v; });
}

template <class T>
T golden_distance(const Triangle<T>& w, const Vec<T>& p, int steps) {
  using std::sqrt;
  const auto best = [&](const T& s) {
    const auto f = [&](const T& t) {
      const Vec<T> d = w.at(s, t) - p;
      return dot(d, d);
    };
    return golden_section<T>(f, T(0.0), T(1.0) - s, steps);
  };
  return sqrt(golden_section<T>(best, T(0.0), T(1.0), steps));
}

/// The minimum over a triangular grid of points, n per edge.
template <class T>
T sampled_distance(const Triangle<T>& w, const Vec<T>& p, int n) {
  using std::sqrt;
  T least = std::numeric_limits<double>::infinity();
  const double h = 1.0 / n;
  for (int i = 0; i <= n; ++i)
    for (int j = 0; i + j <= n; ++j) {
      const Vec<T> d = w.at(i * h, j * h) - p;
      const T squared = dot(d, d);
      if (squared < least) least = squared;
    }
  return sqrt(least);
}

/// Steepest descent on the quadratic, projected back to the domain after each step.
template <class T>
T gradient_distance(const Triangle<T>& w, const Vec<T>& p, int steps) {
  const Quadratic<T> q(w, p);
  const T zero = 0.0, one = 1.0, rate = one / (q.a00 + q.a11);
  T s = 1.0 / 3, t = 1.0 / 3;
  for (int i = 0; i < steps; ++i) {
    const T ds = q.a00 * s + q.a01 * t + q.b0, dt = q.a01 * s + q.a11 * t + q.b1;
    const T u = s - rate * ds, v = t - rate * dt;
    s = u < zero ? zero : u, t = v < zero ? zero : v;
    if (s + t > one) {
      s = fraction(T((u - v + one) * T(0.5)), one);
      t = one - s;
    }
  }
  return length(w.at(s, t) - p);
}

std::vector<Claim> claims(double seed);
Provables proofs();

}  // namespace oddity::ex09_01
