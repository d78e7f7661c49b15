#pragma once

#include <vector>

#include "chapters/02_basic_concepts/07_curve_on_sphere/models.hpp"
#include "chapters/02_basic_concepts/shared/rotation_matrices.hpp"
#include "chapters/exercise.hpp"

/// Exercise 2.7: the frame by dual numbers; shared by the files of the exercise.
namespace oddity::curve_on_sphere {

template <class T>
Matrix<T> frame(const Vector<T>& r, const Vector<T>& v) {
  const Vector<T> u = unit(v);
  return Matrix<T>::columns(r, u, cross(r, u));
}
template <class T>
Matrix<T> frame(const T& t) {
  return frame(position(t), space::derivative_of(position, t));
}

Quantity angular_velocity_at(double t, const Reference&);
Quantity orientation(const Parameters&, const Horizon&, const Reference&);
/// The same trials without the rest of the catalog, judged by R^T R at T: is the result a rotation?
Quantity orthogonality(const Quantity& orientation);

std::vector<Claim> claims(double seed);
Provables proofs();
std::vector<Root> roots();

}  // namespace oddity::curve_on_sphere
