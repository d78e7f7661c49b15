// Exercise 3.33: the Lagrangian equations of a heavy symmetric top whose tip is fixed.
//   T = mu1/2 (phi'^2 + theta'^2 sin^2 phi) + mu3/2 (psi' + theta' cos phi)^2,   V = m g l cos phi.
//   psi' + theta' cos phi = c,   mu1 theta' sin^2 phi + c mu3 cos phi = gamma,   u = cos phi.
//   u'^2 = (e - 2 alpha u)(1 - u^2) - (b - a u)^2,   alpha = m g l/mu1, a = mu3 c/mu1, b = gamma/mu1.
// methods.cpp contains the quantities, claims.cpp the claims.

#include "chapters/03_rigid_body_motion/33_heavy_top/drawing.hpp"
#include "chapters/03_rigid_body_motion/33_heavy_top/heavy_top.hpp"
#include "chapters/03_rigid_body_motion/33_heavy_top/laws.hpp"
#include "chapters/03_rigid_body_motion/shared/top_parameters.hpp"
#include "chapters/in_float.hpp"
#include "chapters/scene.hpp"
#include "reference/bad_input.hpp"
#include "solvers/turns.hpp"

namespace oddity {

namespace ex03_33 {

constexpr auto parameters = top_parameters({
    {"seed", 333, "", "seed of the random samples", 0, 1e9, whole_number},
});

}  // namespace ex03_33

engines::Staging ex03_33::staging(const heavy_top::Top<double>& top) {
  using namespace engines;
  const double across = top.mu1 - top.m * top.l * top.l;
  require_a_body(top.m, top.l, top.mu1, top.mu3);
  Body body{top.m, {across, across, top.mu3}};
  State& start = body.start;
  const engines::Vector up{0, 0, 1}, rates = top.body_rates();
  start.orientation = product(product(about(up, top.theta), about({1, 0, 0}, top.phi)), about(up, top.psi));
  start.position = top.l * turned(start.orientation, up);
  start.spin = turned(start.orientation, rates);
  start.velocity = cross(start.spin, start.position);
  return {{.gravity = {0, 0, -top.g},
           .bodies = {body},
           .joints = {{Joint::ball}},
           .shaking = {top.A * top.lambda * top.lambda, 0, 0},
           .frequency = top.lambda},
          [](std::span<const State> seen, double) {
            const engines::Vector axis = turned(seen[0].orientation, {0, 0, 1});
            return std::vector(axis.begin(), axis.end());
          }};
}

namespace ex03_33 {

Top asked(const Parameters& p) {
  require_a_body(p);
  return {p["m"],   p["l"],   p["mu1"],    p["mu3"],  p["g"],   p["theta"],
          p["phi"], p["psi"], p["dtheta"], p["dphi"], p["dpsi"]};
}

Quantity axis_of(const Parameters& p, const Horizon& horizon, const Reference& truth) {
  return with_float(axis(asked(p), horizon, truth), horizon, asked(p),
                    {"mean precession of a fast top", "", "", "one angle, precession by quadrature",
                     "Euler angles", "rigid body, quaternion", "axis and angular momentum"});
}

engines::Staging staged(const Parameters& p) { return staging({asked(p)}); }

Scene scene() {
  return {
      .motion = axis_of,
      .horizon = duration,
      .game_tolerance = degree,
      .sweep_parameter = "dpsi",
      .sweep_values = {5, 10, 20, 30, 60, 100},
      .perturbed_parameters = {"phi", "dtheta", "dpsi"},
      .axes = {{"x", "y", "z"}, "s", {{"rad", {0, 1, 2}}}},
      .listing =
          {{"chapters/03_rigid_body_motion/33_heavy_top/models.hpp"},
           {{"mean precession of a fast top",
             "heavy_top::MeanPrecession<double>{{m, l, mu1, mu3, g, theta, phi, psi, dtheta, dphi, dpsi}}"},
            {"one angle, precession by quadrature",
             "heavy_top::OneAngle<double>{{m, l, mu1, mu3, g, theta, phi, psi, dtheta, dphi, dpsi}}"},
            {"Euler angles",
             "heavy_top::EulerAngles<double>{{m, l, mu1, mu3, g, theta, phi, psi, dtheta, dphi, dpsi}}"},
            {"rigid body, quaternion",
             "heavy_top::RigidBody<double>{{m, l, mu1, mu3, g, theta, phi, psi, dtheta, dphi, dpsi}}"},
            {"axis and angular momentum",
             "heavy_top::AxisAndMomentum<double>{{m, l, mu1, mu3, g, theta, phi, psi, dtheta, dphi, dpsi}}"}}},
      .draw = heavy_top::draw<Parameters>,
      .staging = staged,
      .laws = {heavy_top::energy<Parameters>, heavy_top::off<Parameters>},
  };
}

Findings study(const Parameters& p, const Reference& truth) {
  const Top start = asked(p);
  Findings found{
      claims(p["seed"], start), quantities(start, truth), roots(start),
      R"(The equations of motion are right; {{velocity for position|that the center of mass has no velocity in body coordinates}} is not.)"};
  found.quantities.insert(found.quantities.begin(), motion(scene(), p, truth));
  return found;
}

}  // namespace ex03_33

Exercise exercise_3_33() {
  using namespace ex03_33;
  return {
      "Heavy symmetric top",
      R"(A top symmetric about its axis $\boldsymbol\xi_3$ turns with its tip fixed under gravity )"
      R"($-g\mathbf k$: mass $m$, center of mass $\mathbf r$ at $\ell$ from the tip, moments about the tip )"
      R"($\mu_1$ across the axis and $\mu_3$ about it. Find its equations of motion by Lagrange's method, )"
      R"(in the angles $\theta$ (precession), $\phi$ (tilt) and $\psi$ (spin) of )"
      R"($R=R_z(\theta)R_x(\phi)R_z(\psi)$, which takes body to world coordinates. In body coordinates it )"
      R"(has the angular velocity $\mathbf w$ and the inertia tensor $J$.)",
      parameters,
      scene(),
      study,
      proofs};
}

}  // namespace oddity
