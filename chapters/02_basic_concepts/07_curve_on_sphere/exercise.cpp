// Exercise 2.7: the orientation of a rigid sphere is R = [r u r x u] along the curve r(t) on it, u = r'/|r'|.
// Find its angular velocity w, Skew(w) = R' R^T.
//   w = r x r' + (r.(r' x r'')/|r'|^2) r          w = Unskew(r' r^T + u' u^T + (r x u')(r x u)^T).
// The text's formulas and its listing need r, r', r''. The independent route differentiates the frame itself
// by dual numbers, or takes w from the formula on the left. This formula follows from r' = w x r and (r x
// u).u' = w.r alone. The scene integrates the orientation by R' = Skew(w) R and compares it with the frame.

#include "chapters/02_basic_concepts/07_curve_on_sphere/curve_on_sphere.hpp"
#include "chapters/02_basic_concepts/07_curve_on_sphere/drawing.hpp"
#include "chapters/scene.hpp"

namespace oddity {

namespace ex02_07 {

using namespace curve_on_sphere;

constexpr Parameter parameters[] = {
    {"pace", 1, "1/s", "units of the curve's time a second", 0.1, 16},
    {"t", 0.75, "1", R"(time at which $\mathbf w$ is computed)", -8, 8},
    {"T", 4, "s", "time until which the orientation is carried on from $t=0$", 0.25, 64},
    {"seed", 1, "", "seed of the random times", 0, 1e9, whole_number},
};

Scene scene() {
  return {
      .motion = orientation,
      .horizon = 4,
      .game_tolerance = degree,
      .sweep_parameter = "pace",
      .sweep_values = {0.25, 0.5, 1, 2, 4, 8},
      .perturbed_parameters = {"pace"},
      .axes = {{"r_x", "u_x", "rxu_x", "r_y", "u_y", "rxu_y", "r_z", "u_z", "rxu_z"},
               "s",
               {{"rad", {0, 3, 6}}, {"rad", {1, 4, 7}}, {"rad", {2, 5, 8}}}},
      .listing = {{"chapters/02_basic_concepts/07_curve_on_sphere/models.hpp"},
                  {{"frame", "curve_on_sphere::Frame<double>{{pace}}"},
                   {"matrix", "curve_on_sphere::AsMatrix<double>{{{pace}}}"},
                   {"quaternion", "curve_on_sphere::AsQuaternion<double>{{{pace}}}"},
                   {"matrix, w of the printed listing", "curve_on_sphere::AsMatrix<double>{{{pace}, true}}"}},
                  {{"matrix, orthonormalized", "which repairs the orientation after each step"},
                   {"quaternion, normalized", "which repairs the orientation after each step"}}},
      .draw = curve_on_sphere::draw<Parameters>,
      .faulted = {"matrix, w of the printed listing"},
  };
}

Findings study(const Parameters& p, const Reference& truth) {
  const Quantity carried = orientation(p, {p["T"]}, truth);
  return {
      claims(p["seed"]),
      {angular_velocity_at(p["t"], truth), carried, orthogonality(carried)},
      roots(),
      R"(The formula for the angular velocity is right; {{R.Dot(U) for A.Dot(U)|the listing that computes it has one product wrong}}.)"};
}

}  // namespace ex02_07

Exercise exercise_2_7() {
  using namespace ex02_07;
  return {"Orientation along a curve on a sphere",
          "A rigid sphere is turned so that a point of it follows $((1-t^2)\\cos\\pi t,(1-t^2)\\sin\\pi "
          "t,t^2)/\\sqrt{(1-t^2)^2+t^4}$: choose an orientation matrix and find the angular velocity.",
          parameters,
          scene(),
          study,
          proofs};
}

}  // namespace oddity
