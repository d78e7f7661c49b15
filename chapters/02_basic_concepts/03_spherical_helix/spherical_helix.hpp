#pragma once

#include <cmath>
#include <numbers>
#include <type_traits>
#include <vector>

#include "chapters/02_basic_concepts/shared/recorded_functions.hpp"
#include "chapters/02_basic_concepts/shared/space.hpp"
#include "chapters/exercise.hpp"

/// Exercise 2.3: the spherical helix; shared by the files of the exercise.
namespace oddity::spherical_helix {

using space::Vector, space::Vector3;

inline constexpr auto helix = [](const auto& t) {
  using T = std::decay_t<decltype(t)>;
  return Vector<T>{cos(t), sin(t), t} / sqrt(T(1.0) + t * t);
};
template <class T>
T distance_from_axis(const Vector<T>& r) {
  return hypot(r[0], r[1]);
}
inline constexpr Vector3 pole{0, 0, 1};

/// The components P, Q, R of a vector in the frame of a position.
template <class T>
Vector<T> in_frame(const Vector<T>& position, const Vector<T>& x) {
  const Vector<T> k{T(0.0), T(0.0), T(1.0)}, R = unit(position), P = unit(cross(k, R));
  return {dot(x, P), dot(x, cross(R, P)), dot(x, R)};
}

/// An angle or a length with its first and second derivative.
template <class T>
Vector<T> differentiated(const Dual<Dual<T>>& x) {
  return {x.value.value, x.value.slope, x.slope.slope};
}

/// The motion at one time, independent of the text: Cartesian dual numbers projected on the frame of the
/// position, and its angles as atan2 of the position.
template <class T>
struct AtOf {
  T t, d = 1 + t * t;
  space::Motion<T> m = space::motion_of(helix, t);
  Vector<T> rho, theta, phi;
  Vector<T> v = in_frame(m.r, m.v), a = in_frame(m.r, m.a);
  T speed = length(m.v), pull = length(m.a);

  explicit AtOf(T time) : t(time) {
    using Twice = Dual<Dual<T>>;
    const Vector<Twice> r = helix(Twice(Dual<T>(t, T(1.0)), Dual<T>(1.0)));
    rho = differentiated(length(r));
    theta = differentiated(atan2(r[1], r[0]));
    phi = differentiated(atan2(sqrt(r[0] * r[0] + r[1] * r[1]), r[2]));
  }
};
using At = AtOf<double>;

Quantity motion(double t, const Reference&);
Quantity colatitude(const std::string& name, double t, const Reference&);
Quantity limits_at_infinity();

std::vector<Claim> claims(double seed);
Provables proofs();
std::vector<Root> roots();

}  // namespace oddity::spherical_helix
