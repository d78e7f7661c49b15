#pragma once

// A top made of point masses: energies, forces and equations of motion from the points' positions alone,
// by dual numbers. Rings of equally spaced points about the third body axis, the tip at the body's origin.

#include <algorithm>
#include <numbers>
#include <vector>

#include "chapters/03_rigid_body_motion/33_heavy_top/models.hpp"
#include "chapters/03_rigid_body_motion/shared/lagrange.hpp"
#include "chapters/claims.hpp"
#include "reference/text.hpp"
#include "solvers/dual.hpp"

namespace oddity::top {

using heavy_top::Matrix, heavy_top::Vector, heavy_top::rotation;

struct Point {
  double m;
  Vector<double> x;
};

/// T and V of the points, for angles q = (theta, phi, psi), rates v and time t.
struct Points {
  std::vector<Point> points;
  double g, A, lambda;

  template <class X>
  std::array<X, 3> position(const Point& p, const Matrix<X>& r, const X& t) const {
    using std::sin;
    std::array<X, 3> at;
    for (std::size_t i = 0; i < 3; ++i) at[i] = r[i][0] * p.x[0] + r[i][1] * p.x[1] + r[i][2] * p.x[2];
    at[0] = at[0] + A * sin(lambda * t);
    return at;
  }
  template <class X>
  X kinetic(const std::array<X, 3>& q, const std::array<X, 3>& v, const X& t) const {
    using D = Dual<X>;
    const auto r = rotation(D(q[0], v[0]), D(q[1], v[1]), D(q[2], v[2]));
    X twice(0.0);
    for (const Point& p : points)
      for (const D& x : position(p, r, D(t, X(1.0)))) twice = twice + p.m * x.slope * x.slope;
    return 0.5 * twice;
  }
  template <class X>
  X potential(const std::array<X, 3>& q, const X& t) const {
    const auto r = rotation(q[0], q[1], q[2]);
    X sum(0.0);
    for (const Point& p : points) sum = sum + p.m * g * position(p, r, t)[2];
    return sum;
  }
};

/// A random top at a random instant of a motion with random accelerations, away from the vertical.
struct Sample {
  Points body;
  Vector<double> q, v, a;
  double t;
  double m = 0, l = 0, mu1 = 0, mu3 = 0;
  Vector<double> truth;    ///< the accelerations of Lagrange's equations
  Vector<double> kinetic;  ///< d/dt dT/dv - dT/dq along the accelerations a

  explicit Sample(Random& random, double shake = 0)
      : body{{}, random.between(1, 10), shake * random.between(0.1, 1), random.between(0.5, 4)},
        q{random.between(-3, 3), random.between(0.3, 2.8), random.between(-3, 3)},
        v(random.point(3)),
        a(random.point(3)),
        t(random.between(0, 5)) {
    for (int corners : {1, 3, 4}) {
      const double height = random.between(0.2, 1.5), mass = random.between(0.2, 1),
                   radius = corners == 1 ? 0 : random.between(0.2, 1), turned = random.between(0, 3);
      for (int i = 0; i < corners; ++i) {
        const double angle = turned + 2 * std::numbers::pi * i / corners;
        body.points.push_back({mass, {radius * std::cos(angle), radius * std::sin(angle), height}});
        m += mass;
        l += mass * height;
        mu3 += mass * radius * radius;
        mu1 += mass * (radius * radius / 2 + height * height);
      }
    }
    l /= m;
    const auto of_motion = [this](const auto& x, const auto& dx, const auto& s) {
      return body.kinetic(x, dx, s);
    };
    const auto lagrangian = [this](const auto& x, const auto& dx, const auto& s) {
      return body.kinetic(x, dx, s) - body.potential(x, s);
    };
    kinetic = lagrange_left_side(of_motion, q, v, a, t);
    truth = lagrange_accelerations(lagrangian, q, v, {}, t);
  }

  /// R^T R' of the motion, in which the angular velocity in body coordinates stands.
  Matrix<double> body_spin() const {
    using D = Dual<double>;
    const auto r = rotation(D(q[0], v[0]), D(q[1], v[1]), D(q[2], v[2]));
    Matrix<double> w{};
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j)
        for (std::size_t k = 0; k < 3; ++k) w[i][j] += r[k][i].value * r[k][j].slope;
    return w;
  }
  Vector<double> body_rates() const {
    const auto w = body_spin();
    return {w[2][1], w[0][2], w[1][0]};
  }
  heavy_top::Top<double> top() const {
    return {m, l, mu1, mu3, body.g, q[0], q[1], q[2], v[0], v[1], v[2], body.A, body.lambda};
  }

  /// By how much the equations for the accelerations, once solved, enlarge roundings.
  double conditioning() const { return 1 / (std::sin(q[1]) * std::sin(q[1])); }
  /// The terms of lengths, rates, energies and forces, added up, and the accelerations that they make.
  double size() const {
    const double sine = std::sin(q[1]), shaken = body.A * body.lambda * (1 + body.lambda);
    const double rates = 1 + dot(v, v) + std::sqrt(dot(a, a));
    const double terms =
        1 + l + body.A + (mu1 + mu3) * rates + m * (l + 1) * (body.g + shaken + shaken * shaken);
    return terms + (terms + std::sqrt(dot(truth, truth))) / (std::min({1.0, mu1, mu3}) * sine * sine);
  }
  std::string where() const {
    return R"($\theta,\phi,\psi$ = )" + format_significant(q[0], 4) + ", " + format_significant(q[1], 4) +
           ", " + format_significant(q[2], 4) + R"(, $\ell$ = )" + format_significant(l, 4) +
           R"(, $\mu_1$ = )" + format_significant(mu1, 4) + R"(, $\mu_3$ = )" + format_significant(mu3, 4);
  }
};

/// The time derivative, along the motion with the accelerations a, of f(q, v).
template <class F>
double rate_of(const Sample& s, const Vector<double>& a, const F& f) {
  std::array<Dual<double>, 3> q, v;
  for (std::size_t i = 0; i < 3; ++i) {
    q[i] = {s.q[i], s.v[i]};
    v[i] = {s.v[i], a[i]};
  }
  return f(q, v).slope;
}

/// The derivative of f(q, v) by the k-th angle, or by its rate.
template <class F>
double by_angle(const Sample& s, std::size_t k, const F& f, bool rate = false) {
  std::array<Dual<double>, 3> q, v;
  for (std::size_t i = 0; i < 3; ++i) {
    q[i] = {s.q[i], i == k && !rate ? 1.0 : 0.0};
    v[i] = {s.v[i], i == k && rate ? 1.0 : 0.0};
  }
  return f(q, v).slope;
}

/// A hundred tops; `shake` is the tip's largest amplitude.
inline std::vector<Sample> random_tops(double seed, double shake = 0) {
  Random random(seed);
  std::vector<Sample> tops;
  for (int i = 0; i < 100; ++i) tops.emplace_back(random, shake);
  return tops;
}

}  // namespace oddity::top
