#pragma once

#include <array>
#include <cmath>
#include <type_traits>
#include <vector>

#include "chapters/03_rigid_body_motion/17_foucault/models.hpp"
#include "chapters/03_rigid_body_motion/shared/lagrange.hpp"
#include "chapters/exercise.hpp"
#include "chapters/provable.hpp"

/// Shared by the methods and claims of exercise 3.17: the cone, and the published energy and force.
namespace oddity::ex03_17 {

using foucault::Axes, foucault::Given;

template <class T>
using Space = std::array<T, 3>;

/// dR/dt by dual numbers.
template <class T>
Space<T> axis_velocity(const Two<T>& q, const Two<T>& v) {
  const Axes<Dual<T>> axes({Dual<T>(q[0], v[0]), Dual<T>(q[1], v[1])});
  return {axes.R[0].slope, axes.R[1].slope, axes.R[2].slope};
}

/// Foucault's own pendulum in the Pantheon, released at rest.
inline constexpr Given<double> pantheon{0.8526, 67, 7.292115e-5, 9.81, 0.5, 0.0447, 0, 0};
/// m, the initial distance from the vertical, and the distance at which it passes the lowest point.
inline double let_go_aside() { return pantheon.L * std::sin(pantheon.phi); }
inline double passes_at() {
  return let_go_aside() * pantheon.omega * std::sin(pantheon.lambda) / std::sqrt(pantheon.g / pantheon.L);
}

/// A cone of unit mass that hangs by its vertex: center of mass at L, moments of inertia about it.
template <class T>
struct ConeOf {
  T h, r;
  T L() const { return 3 * h / 4; }
  T across() const { return 3 * (4 * r * r + h * h) / 80; }
  T along() const { return 3 * r * r / 10; }
  /// Length of the point-mass pendulum with the same swing: (L^2 + Ixx)/L.
  T equivalent_length() const { return 4 * h / 5 + r * r / (5 * h); }
};
using Cone = ConeOf<double>;

/// The book's cone: L from the halved volume, moments about the center of the base.
template <class T>
struct BookConeOf {
  T L, Ixx, Izz;
};

template <class T>
BookConeOf<T> book_cone(const ConeOf<T>& c) {
  using std::cbrt;
  return {c.h / cbrt(T(2)), (2 * c.h * c.h + 3 * c.r * c.r) / 20, c.along()};
}

/// Published kinetic energy (per mass), |v|^2/2 + w.J w/2, with J of (Ixx, Ixx, Izz).
template <class N>
struct BookEnergyOf : BookConeOf<N> {
  using BookConeOf<N>::L, BookConeOf<N>::Ixx, BookConeOf<N>::Izz;
  Space<N> w;
  template <class T>
  T operator()(const Two<T>& q, const Two<T>& v) const {
    const Axes<T> a(q);
    const Space<T> earth{T(w[0]), T(w[1]), T(w[2])}, rate = axis_velocity(q, v);
    const T p = dot(a.P, earth), s = dot(a.Q, earth), t = dot(a.R, earth);
    return 0.5 * L * L * dot(rate, rate) + 0.5 * (Ixx * (p * p + s * s) + Izz * t * t);
  }
};

using BookEnergy = BookEnergyOf<double>;

/// The generalized Coriolis force on a point of unit mass at L.
template <class T>
Two<T> coriolis(const T& L, const Space<T>& w, const Two<T>& q, const Two<T>& v) {
  const T wR = dot(Axes<T>(q).R, w), s = sin(q[1]);
  return {-2 * L * L * s * v[1] * wR, 2 * L * L * s * v[0] * wR};
}

Quantity bob(const Given<double>&, const Horizon&, const Reference&);
Quantity bob_on_earth(const Horizon&, const Reference&);
Quantity push(Given<double>, const Horizon&, const Reference&);
Quantity hours(const Reference&);
Quantity cone_swing(Given<double>, const Cone&, const Horizon&, const Reference&);
Quantity inertia(const Cone&);

std::vector<Claim> claims(double seed);
Provables proofs();
/// Proofs of claims about the point mass.
Provables pendulum_proofs();
/// Proofs of claims about the cone.
Provables cone_proofs();
std::vector<Root> roots();

}  // namespace oddity::ex03_17
