// Exercise 2.15: the inertia components about any origin from those about the center of mass c.
//   Ixx = Ixx' + m (cy^2 + cz^2),  Ixy = Ixy' + m cx cy,  with ' about the center of mass.
// The independent route is the definition, J w = sum of m r x (w x r), which uses no formula of the text. The
// solid is a tetrahedron, with moments m/20 (sum of the vertices' + 16 times the center's).

#include "chapters/02_basic_concepts/15_transfer_theorem/transfer_theorem.hpp"

namespace oddity {

namespace ex02_15 {

using namespace transfer_theorem;

constexpr Parameter parameters[] = {
    {"a", 1, "m", "edge of the tetrahedron along $x$", 0.125, 8},
    {"b", 1.5, "m", "edge along $y$", 0.125, 8},
    {"c", 0.75, "m", "edge along $z$", 0.125, 8},
    {"x", 2, "m", "$x$ of the corner where these edges meet", -10, 10},
    {"y", -1, "m", "$y$ of that corner", -10, 10},
    {"z", 0.5, "m", "$z$ of that corner", -10, 10},
    {"rho", 1, "kg/m^3", "density", 1e-3, 1e3},
    {"far", 0x1p20, "m", "the corner is at (far, 2 far, -far) in the far system", 0, 1e7},
    {"seed", 15, "", "seed of the random systems", 0, 1e9, whole_number},
};

Findings study(const Parameters& p, const Reference& truth) {
  return {claims(p["seed"]), {about_origin(p, truth), about_center(p, truth)}};
}

}  // namespace ex02_15

Exercise exercise_2_15() {
  using namespace ex02_15;
  return {"Transfer theorem",
          "Express the inertia components of particles about the origin, $I_{xx}=\\sum m_i(y_i^2+z_i^2)$, "
          "$I_{xy}=\\sum m_ix_iy_i$, ..., through those about their center of mass $c$. Below "
          "$m$ is the mass of all, and a prime marks what is taken relative to $c$.",
          parameters,
          {},
          study,
          proofs,
          Expected::in_whole_ranges};
}

}  // namespace oddity
