// Exercise 2.5: the angular velocity w, Skew(w) = R' R^T, of a rotation R by theta(t) about a unit axis D(t):
//   w = theta' D + sin(theta) D' + (1 - cos(theta)) D x D'.
// The independent route does not use Rodrigues' formula: R is the matrix of the unit quaternion
// q = (cos(theta/2), sin(theta/2) D). Derivatives are by dual numbers, and w is the vector part of 2 q' q*
// [Kuipers, Quaternions and Rotation Sequences, 11.4].

#include "chapters/02_basic_concepts/05_rotation_about_moving_axis/rotating_axis.hpp"

namespace oddity {

namespace ex02_05 {

using namespace rotating_axis;

constexpr Parameter parameters[] = {
    {"t", 1, "s", R"(time at which $\mathbf w$ is computed)", -10, 10},
    {"alpha", 0.5, "rad", R"(angle of the axis $\mathbf D$ from $z$)", 0, 3.14},
    {"Omega", 2, "rad/s", R"(rate at which $\mathbf D$ goes round $z$)", -20, 20},
    {"nu", 3, "rad/s", R"(rate of the angle $\theta$)", -20, 20},
    {"seed", 1, "", "seed of the random motions in the proof", 0, 1e9, whole_number},
};

Findings study(const Parameters& p, const Reference& truth) {
  return {
      claims(p["seed"]),
      {angular_velocity(p, truth)},
      roots(),
      R"(The angular velocity is right for any axis; on the way {{length of the axis' rate|$\dot{\mathbf D}$ is taken for a unit vector}} and {{a singular matrix|a singular matrix for an invertible one}}.)"};
}

}  // namespace ex02_05

Exercise exercise_2_5() {
  using namespace ex02_05;
  return {"Rotation about a moving axis",
          R"(A body is turned by the angle $\theta(t)$ about the unit axis $\mathbf D(t)$: show that its )"
          R"(angular velocity is $\mathbf w=\dot\theta\mathbf D+\sin\theta\,\dot{\mathbf D})"
          R"(+(1-\cos\theta)\,\mathbf D\times\dot{\mathbf D}$. Below $\mathbf U_1$, $\mathbf U_2$, )"
          R"($\mathbf U_3$ are $\mathbf D$, $\dot{\mathbf D}$ and $\mathbf D\times\dot{\mathbf D}$, the )"
          R"(columns of $U$, and those of $A$ their images under a matrix $M$; $R$ is the rotation, $S$ is )"
          R"($\mathrm{Skew}(\mathbf D)$, $\sigma$ and $\gamma$ are the sine and the cosine of $\theta$.)",
          parameters,
          {},
          study,
          proofs};
}

}  // namespace oddity
