#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "chapters/exercise.hpp"

/// A tetrahedron, an affine map, and barycentric coordinates by volumes.
namespace oddity::ex08_05 {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using Eigen::VectorXd;

template <class T>
using Vector = Eigen::Matrix<T, 3, 1>;

template <class T>
Vector<T> cross(const Vector<T>& a, const Vector<T>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

template <class T>
T triple(const Vector<T>& a, const Vector<T>& b, const Vector<T>& c) {
  return a.dot(cross(b, c));
}

template <class T>
struct TetrahedronOf {
  std::array<Vector<T>, 4> p;

  Vector<T> edge(std::size_t i) const { return p[i] - p[0]; }
  Eigen::Matrix<T, 3, 3> edges() const {
    Eigen::Matrix<T, 3, 3> v;
    v << edge(1), edge(2), edge(3);
    return v;
  }
};
using Tetrahedron = TetrahedronOf<double>;

template <class T>
struct AffineOf {
  Vector<T> a;
  T b;
  T operator()(const Vector<T>& p) const { return a.dot(p) + b; }
};
using Affine = AffineOf<double>;

/// (c1, c2, c3) from the volumes of the tetrahedra between P and the faces.
template <class T>
Vector<T> by_volumes(const Vector<T>& v, const Vector<T>& v1, const Vector<T>& v2, const Vector<T>& v3) {
  return Vector<T>(triple(v, v2, v3), triple(v1, v, v3), triple(v1, v2, v)) / triple(v1, v2, v3);
}
template <class T>
Vector<T> by_volumes(const TetrahedronOf<T>& t, const Vector<T>& p) {
  return by_volumes<T>(p - t.p[0], t.edge(1), t.edge(2), t.edge(3));
}

std::vector<Claim> claims(double seed);
Provables proofs();

}  // namespace oddity::ex08_05
