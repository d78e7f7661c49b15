#pragma once

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "chapters/exercise.hpp"
#include "solvers/linear.hpp"
#include "solvers/ode/algorithms.hpp"
#include "solvers/ode/integrate.hpp"

/// A rigid body under an impulse: the velocities after it, and the motion while a short force acts.
namespace oddity::ex06_05 {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using Eigen::VectorXd;

inline Vector3d cross(const Vector3d& a, const Vector3d& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// The inverse by cofactors.
inline Matrix3d inverse(const Matrix3d& a) {
  Matrix3d rows;
  rows.row(0) = cross(a.col(1), a.col(2));
  rows.row(1) = cross(a.col(2), a.col(0));
  rows.row(2) = cross(a.col(0), a.col(1));
  return rows / rows.row(0).dot(a.col(0));
}

/// J^-1 L by elimination.
inline Vector3d turned(const Matrix3d& inertia, const Vector3d& momentum) {
  return solve(Factorization::partial_pivot_lu, inertia, momentum).value;
}

template <class T>
struct BodyOf {
  T mass;
  Eigen::Matrix<T, 3, 3> inertia;  ///< about the center of mass, in the world's axes
  Eigen::Matrix<T, 3, 1> center, v, w;
};
using Body = BodyOf<double>;

/// The impulse f N shared by two points: the fraction `first` at P0, the rest at P1.
struct Contact {
  Vector3d p0, p1, impulse;
  double first = 0.5;
};

/// (v, two columns of the orientation, angular momentum about the center); time in units of the pulse.
struct Pulse {
  using State = std::array<double, 12>;
  Body body;
  Contact hit;
  double length;
  Matrix3d inverse_inertia = inverse(body.inertia);

  static Vector3d part(const State& x, std::size_t from) { return {x[from], x[from + 1], x[from + 2]}; }
  static Matrix3d orientation(const State& x) {
    Matrix3d r;
    r.col(0) = part(x, 3);
    r.col(1) = part(x, 6);
    r.col(2) = cross(part(x, 3), part(x, 6));
    return r;
  }
  State start() const {
    const Vector3d l = body.inertia * body.w;
    return {body.v[0], body.v[1], body.v[2], 1, 0, 0, 0, 1, 0, l[0], l[1], l[2]};
  }
  Vector3d angular_velocity(const State& x) const {
    const Matrix3d r = orientation(x);
    return r * (inverse_inertia * (r.transpose() * part(x, 9)));
  }
  /// The force rises and falls as 630 t^4 (1 - t)^4, whose integral is 1; its points move with the body.
  void operator()(const State& x, State& dxdt, double t) const {
    const Matrix3d r = orientation(x);
    const double bump = t * t * (1 - t) * (1 - t);
    const Vector3d force = 630 * bump * bump * hit.impulse;
    const Vector3d torque = hit.first * cross(r * (hit.p0 - body.center), force) +
                            (1 - hit.first) * cross(r * (hit.p1 - body.center), force);
    const Vector3d w = length * angular_velocity(x);
    const Vector3d parts[] = {force / body.mass, cross(w, part(x, 3)), cross(w, part(x, 6)), torque};
    for (std::size_t k = 0; k < 12; ++k) dxdt[k] = parts[k / 3][static_cast<long>(k % 3)];
  }
};

/// (v+, w+) after a pulse of this length, by Runge-Kutta steps of 1/128 of it.
inline Solved<std::array<double, 6>> after_pulse(const Body& body, const Contact& hit, double length) {
  const Pulse pulse{body, hit, length};
  const auto end = ode::integrate<ode::RungeKutta4>(pulse, pulse.start(), 0, 1, 1.0 / 128);
  const Vector3d w = pulse.angular_velocity(end.value);
  return {{end.value[0], end.value[1], end.value[2], w[0], w[1], w[2]},
          end.evaluations,
          std::numeric_limits<double>::quiet_NaN(),
          0,
          end.ending,
          end.message};
}

inline Matrix3d box_inertia(double mass, double a, double b, double c) {
  return mass / 12 * Vector3d(b * b + c * c, a * a + c * c, a * a + b * b).asDiagonal().toDenseMatrix();
}

std::vector<Claim> claims(double seed);
Provables proofs();
std::vector<Root> roots(const Parameters&, const Quantity& patch);

}  // namespace oddity::ex06_05
