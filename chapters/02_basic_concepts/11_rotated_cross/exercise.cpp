// Exercise 2.11: R (a x b) = (R a) x (R b) for every rotation R.
//   R r = c r + s w x r + (1 - c) w (w . r),  c = cos theta, s = sin theta, |w| = 1   (Rodrigues)
// The text computes in an orthonormal frame {u, v, w} along the axis. The independent route is the quaternion
// product q r q* in world coordinates, which uses the half angle and no frame. All samples are random.

#include "chapters/02_basic_concepts/11_rotated_cross/rotated_cross.hpp"
#include "chapters/02_basic_concepts/shared/rotations.hpp"
#include "reference/reference.hpp"

namespace oddity {

namespace ex02_11 {

using namespace rotation;

constexpr Parameter parameters[] = {
    {"theta", 2, "rad", "angle of the rotation", -6.5, 6.5},
    {"gap", 1, "", "distance of the triangle's two edge vectors", least_gap, 1},
    {"seed", 11, "", "seed of the random samples", 0, 1e9, whole_number},
};

Findings study(const Parameters& p, const Reference& truth) {
  return {claims(p["seed"]),
          {rotated_normal(p["theta"], p["gap"], truth), identity_gap(p["theta"]), sliver_normal(truth)}};
}

}  // namespace ex02_11

Exercise exercise_2_11() {
  using namespace ex02_11;
  return {
      "Rotation of a cross product",
      R"(Show that $R(\mathbf a\times\mathbf b)=(R\mathbf a)\times(R\mathbf b)$ for every rotation $R$. Below )"
      R"($c$ and $s$ are cosine and sine of its angle, $\mathbf u$, $\mathbf v$, $\mathbf w$ an orthonormal frame )"
      R"(with $\mathbf w$ along its axis, and $a_i$, $b_i$, $g_i$ the components of $\mathbf a$, $\mathbf b$ and )"
      R"($\mathbf a\times\mathbf b$ in that frame.)",
      parameters,
      {},
      study,
      proofs};
}

}  // namespace oddity
