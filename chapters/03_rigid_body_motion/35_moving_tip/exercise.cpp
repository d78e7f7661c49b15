// Exercise 3.35: the heavy symmetric top of exercise 3.33 with a moving tip: p(t) = (A sin(lambda t), 0, 0).
// (A is the book's alpha, which in 3.33 is m g l/mu1.) About the tip, with F = -m g k - m p'':
//   L' = l d x F,   mu1 w1' = (mu1 - mu3) w2 w3 - l F2,   mu1 w2' = (mu3 - mu1) w3 w1 + l F1,   w3' = 0.
// methods.cpp contains the quantities, claims.cpp the claims.

#include "chapters/03_rigid_body_motion/33_heavy_top/heavy_top.hpp"
#include "chapters/03_rigid_body_motion/33_heavy_top/laws.hpp"
#include "chapters/03_rigid_body_motion/35_moving_tip/drawing.hpp"
#include "chapters/03_rigid_body_motion/35_moving_tip/moving_tip.hpp"
#include "chapters/03_rigid_body_motion/shared/top_parameters.hpp"
#include "chapters/in_float.hpp"
#include "chapters/scene.hpp"

namespace oddity {

namespace ex03_35 {

constexpr auto parameters = top_parameters({
    {"A", 0.0625, "m", R"(amplitude of the tip, the book's $\alpha$)", 1e-6, 100},
    {"lambda", 3, "rad/s", "its frequency", 1e-3, 1e3},
    {"seed", 335, "", "seed of the random samples", 0, 1e9, whole_number},
});

Top asked(const Parameters& p) {
  require_a_body(p);
  return {p["m"],   p["l"],      p["mu1"],  p["mu3"],  p["g"], p["theta"], p["phi"],
          p["psi"], p["dtheta"], p["dphi"], p["dpsi"], p["A"], p["lambda"]};
}

Quantity axis_of(const Parameters& p, const Horizon& horizon, const Reference& truth) {
  return with_float(axis(asked(p), horizon, truth), horizon, moving_tip::Given<double>{asked(p)},
                    {"fixed tip, as proposed", "small tilt", "first order in A", "Euler angles",
                     "rigid body, quaternion", "axis and angular momentum"});
}

engines::Staging staged(const Parameters& p) { return ex03_33::staging(asked(p)); }

Scene scene() {
  return {
      .motion = axis_of,
      .horizon = ex03_33::duration,
      .game_tolerance = degree,
      .sweep_parameter = "lambda",
      .sweep_values = {0.5, 1.5, 3, 6, 10, 14},
      .perturbed_parameters = {"phi", "dtheta", "dpsi"},
      .axes = {{"x", "y", "z"}, "s", {{"rad", {0, 1, 2}}}},
      .listing =
          {{"chapters/03_rigid_body_motion/35_moving_tip/models.hpp"},
           {{"fixed tip, as proposed",
             "moving_tip::AxisAndMomentum<double>{moving_tip::with_fixed_tip<double>({m, l, mu1, mu3, g, theta, phi, psi, "
             "dtheta, dphi, dpsi, A, lambda})}"},
            {"small tilt",
             "moving_tip::SmallTilt<double>{{m, l, mu1, mu3, g, theta, phi, psi, dtheta, dphi, dpsi, A, lambda}}"},
            {"first order in A",
             "moving_tip::FirstOrderInA<double>{{m, l, mu1, mu3, g, theta, phi, psi, dtheta, dphi, dpsi, A, lambda}}"},
            {"Euler angles",
             "moving_tip::EulerAngles<double>{{m, l, mu1, mu3, g, theta, phi, psi, dtheta, dphi, dpsi, A, lambda}}"},
            {"rigid body, quaternion",
             "moving_tip::RigidBody<double>{{m, l, mu1, mu3, g, theta, phi, psi, dtheta, dphi, dpsi, A, lambda}}"},
            {"axis and angular momentum",
             "moving_tip::AxisAndMomentum<double>{{m, l, mu1, mu3, g, theta, phi, psi, dtheta, dphi, dpsi, A, lambda}}"}}},
      .draw = moving_tip::draw<Parameters>,
      .staging = staged,
      .laws = {heavy_top::energy<Parameters>, heavy_top::off<Parameters>},
      .faulted = {"fixed tip, as proposed"},
  };
}

Findings study(const Parameters& p, const Reference& truth) {
  const Top top = asked(p);
  auto all = quantities(top, truth);
  const Deviation off(top);
  Findings found{
      claims(p["seed"], top, off), std::move(all), roots(top, off),
      R"(The conclusion is wrong: {{no torque of the force on the tip|the force that moves the tip has a torque about the center of mass}}, so that the tip's motion cannot be handled apart, and {{tip for center of mass|the tip is not the center of mass}}. About the moving tip Euler's equations hold with the force $\mathbf F=-mg\mathbf k-m\ddot{\mathbf p}$ at the center of mass: $\dot{\mathbf L}=\ell\,\boldsymbol\xi_3\times\mathbf F$.)"};
  found.quantities.insert(found.quantities.begin(), motion(scene(), p, truth));
  return found;
}

}  // namespace ex03_35

Exercise exercise_3_35() {
  using namespace ex03_35;
  return {
      "Heavy top on a moving tip",
      R"(The tip of a heavy symmetric top is driven to and fro as $\mathbf p=(\alpha\sin\lambda t,0,0)$. What )"
      R"(becomes of its motion? The top has the mass $m$ under gravity $-g\mathbf k$, its center of mass $\mathbf r$ )"
      R"(at $\ell$ from the tip along the axis $\boldsymbol\xi_3$, and the moments $\mu_1$ and $\mu_3$ about the )"
      R"(tip, across the axis and about it; the angles are $\theta$ (precession), $\phi$ (tilt) and $\psi$ (spin), )"
      R"(the angular velocity in body coordinates is $\mathbf w$.)",
      parameters,
      scene(),
      study,
      proofs};
}

}  // namespace oddity
