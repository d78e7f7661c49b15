// Exercise 2.3: the motion r(t) = (cos t, sin t, t)/sqrt(1 + t^2) in spherical coordinates.
//   R = r, P = k x R/|k x R|, Q = R x P: P points east, Q towards the pole; phi is the angle from the pole.
//   v = sin(phi) P - phi' Q.
//   a = 2 phi' cos(phi) P + (sin(phi) cos(phi) - phi'') Q - (phi'^2 + sin^2(phi)) R.
// The independent route uses no angle: Cartesian derivatives by dual numbers, projected on the frame of the
// position. For the text's angles it is atan2 of the coordinates in dual numbers.

#include "chapters/02_basic_concepts/03_spherical_helix/spherical_helix.hpp"

namespace oddity {

namespace ex02_03 {

using namespace spherical_helix;

constexpr Parameter parameters[] = {
    {"t", 2, "1", "time at which the motion is computed", -1e9, 1e9},
    {"seed", 1, "", "of the random times in [-50, 50]", 0, 1e9, whole_number},
};

Findings study(const Parameters& p, const Reference& truth) {
  return {
      claims(p["seed"]),
      {motion(p["t"], truth), colatitude("colatitude", p["t"], truth),
       colatitude("colatitude_near_the_north_pole", 1e8, truth),
       colatitude("colatitude_near_the_south_pole", -1e8, truth), limits_at_infinity()},
      roots(),
      R"(The helix, its frame and its ends are right; {{sign of the velocity along $\mathbf Q$|a component of the velocity has the wrong sign}}, and {{square forgotten in $\ddot\phi$|one of the acceleration lacks a square}}.)"};
}

}  // namespace ex02_03

Exercise exercise_2_3() {
  using namespace ex02_03;
  return {
      "Spherical helix",
      R"(The curve $(\cos t,\sin t,t)/\sqrt{1+t^2}$ winds about the unit sphere: find its spherical )"
      R"(coordinates, its velocity and acceleration in the frame $\{\mathbf P,\mathbf Q,\mathbf R\}$, and )"
      R"(where it ends.)",
      parameters,
      {},
      study,
      proofs};
}

}  // namespace oddity
