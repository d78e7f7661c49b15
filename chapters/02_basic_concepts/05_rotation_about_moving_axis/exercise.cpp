// Exercise 2.5: the angular velocity of a rotation by theta(t) about a unit axis D(t),
//   w = theta' D + sin(theta) D' + (1 - cos(theta)) D x D'        (Skew(w) = R' R^T)
// The other route never meets Rodrigues' formula: R is the matrix of the unit quaternion
// (cos(theta/2), sin(theta/2) D), derivatives are dual numbers, and w is the vector part of 2 q' q*
// [Kuipers, Quaternions and Rotation Sequences, 11.4].

#include "chapters/02_basic_concepts/05_rotation_about_moving_axis/rotating_axis.hpp"

namespace oddity {

namespace ex02_05 {

using namespace rotating_axis;

constexpr Parameter parameters[] = {
    {"t", 1, "s", "time at which w is computed", -10, 10},
    {"alpha", 0.5, "rad", "angle of the axis D from z", 0, 3.14},
    {"Omega", 2, "rad/s", "rate at which D goes round z", -20, 20},
    {"nu", 3, "rad/s", "rate of the angle theta", -20, 20},
    {"seed", 1, "", "of the random motions in the proof", 0, 1e9, whole_number},
};

Findings study(const Parameters& p, const Reference& truth) {
  return {claims(p["seed"]), {angular_velocity(p, truth)}, roots()};
}

}  // namespace ex02_05

Exercise exercise_2_5() {
  using namespace ex02_05;
  return {
      "Rotation about a moving axis",
      "A body is turned by the angle $\\theta(t)$ about the unit axis $\\mathbf D(t)$: show that its "
      "angular velocity is $\\mathbf w=\\dot\\theta\\mathbf D+\\sin\\theta\\,\\dot{\\mathbf "
      "D}+(1-\\cos\\theta)\\,\\mathbf D\\times\\dot{\\mathbf D}$. Below `U1`, `U2`, `U3` are $\\mathbf D$, "
      "$\\dot{\\mathbf D}$ and $\\mathbf D\\times\\dot{\\mathbf D}$, `S` is Skew(D), `sigma` and `gamma` are "
      "the sine and the cosine of $\\theta$.",
      parameters,
      {},
      study};
}

}  // namespace oddity
