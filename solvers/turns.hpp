#pragma once

#include <cmath>

#include "solvers/world.hpp"

/// Vectors, rotations by unit quaternions, and points of bodies.
namespace oddity::engines {

inline Vector operator+(const Vector& a, const Vector& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
inline Vector operator-(const Vector& a, const Vector& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
inline Vector operator*(double s, const Vector& a) { return {s * a[0], s * a[1], s * a[2]}; }
inline double dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// Rotation by an angle [rad] about a unit vector.
inline Quaternion about(const Vector& axis, double angle) {
  const double s = std::sin(angle / 2);
  return {std::cos(angle / 2), s * axis[0], s * axis[1], s * axis[2]};
}
inline Quaternion inverse(const Quaternion& q) { return {q[0], -q[1], -q[2], -q[3]}; }
/// Rotation by b, then by a.
inline Quaternion product(const Quaternion& a, const Quaternion& b) {
  return {a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3],
          a[0] * b[1] + a[1] * b[0] + a[2] * b[3] - a[3] * b[2],
          a[0] * b[2] - a[1] * b[3] + a[2] * b[0] + a[3] * b[1],
          a[0] * b[3] + a[1] * b[2] - a[2] * b[1] + a[3] * b[0]};
}
inline Vector turned(const Quaternion& q, const Vector& a) {
  const Vector u{q[1], q[2], q[3]}, twice = 2.0 * cross(u, a);
  return a + q[0] * twice + cross(u, twice);
}

/// A point that is fixed to a body, or to the ground.
struct Point {
  int body;
  Vector in_body;

  Point(const World& world, int of, const Vector& at) : body(of), in_body(at) {
    if (body == ground) return;
    const State& start = world.bodies[static_cast<std::size_t>(body)].start;
    in_body = turned(inverse(start.orientation), at - start.position);
  }
  Vector at(const State& s) const { return s.position + turned(s.orientation, in_body); }
  Vector now(const std::vector<State>& states) const {
    return body == ground ? in_body : at(states[static_cast<std::size_t>(body)]);
  }
};

}  // namespace oddity::engines
