// Exercise 3.17: the Foucault pendulum, by Lagrange: a point mass, then a solid cone that hangs by its
// vertex.
//   theta'' sin phi + 2 theta' phi' cos phi = 2 omega phi' b.
//   phi'' - theta'^2 sin phi cos phi = -2 omega theta' sin phi b - (g/L) sin phi.
//   b = sin lambda cos phi - cos lambda sin theta sin phi.
// These hold to first order in omega. They are compared with Lagrange's equations by dual numbers. The
// kinetic energy is that in axes that do not rotate, |r' + w x r|^2/2. Its part linear in omega is half the
// difference for Earths that rotate in opposite directions. The cone's integrals are by quadrature over its
// points.

#include "chapters/03_rigid_body_motion/17_foucault/drawing.hpp"
#include "chapters/03_rigid_body_motion/17_foucault/foucault.hpp"
#include "chapters/in_float.hpp"
#include "chapters/scene.hpp"
#include "solvers/turns.hpp"

namespace oddity {

namespace ex03_17 {

using namespace foucault;

constexpr Parameter parameters[] = {
    {"lambda", 0.75, "rad", "latitude", -1.57, 1.57},
    {"L", 1, "m", "length", 1e-3, 1e5},
    {"omega", 0.0625, "rad/s", R"(angular speed of the Earth; the real one has $7.292115\cdot10^{-5}$)", 0,
     2},
    {"g", 9.81, "m/s^2", "gravity", 1e-3, 1e4},
    {"theta", 0.5, "rad", "direction at the start, from west to north", -10, 10},
    {"phi", 0.25, "rad", "angle at the start, from the lower vertical", 1e-3, 3.14},
    {"theta_dot", 1, "rad/s", "its rate about the vertical", -1e3, 1e3},
    {"phi_dot", 0, "rad/s", "its rate from the vertical", -1e3, 1e3},
    {"h", 1.25, "m", "height of the cone", 1e-3, 1e5},
    {"r", 1.25, "m", "radius of the cone", 1e-3, 1e5},
    {"seed", 317, "", "seed of the random samples", 0, 1e9, whole_number},
};

Given<double> asked(const Parameters& p) {
  return {p["lambda"], p["L"], p["omega"], p["g"], p["theta"], p["phi"], p["theta_dot"], p["phi_dot"]};
}

Quantity swinging_bob(const Parameters& p, const Horizon& horizon, const Reference& truth) {
  return with_float(
      bob(asked(p), horizon, truth), horizon, asked(p),
      {"averaged", "small angle", "two angles as published", "two angles", "Cartesian with constraint"});
}

/// The axes are the book's, with z down.
engines::Staging staging(const Parameters& p) {
  using namespace engines;
  const foucault::Given<double> start = asked(p);
  const auto s = start.cartesian();
  Body bob{1, {0.1, 0.1, 0.1}};
  bob.start.position = {s[0], s[1], s[2]};
  bob.start.velocity = {s[3], s[4], s[5]};
  return {{.gravity = {0, 0, start.g},
           .bodies = {bob},
           .joints = {{.kind = Joint::rod, .end = bob.start.position}},
           .turning = start.w()},
          [](std::span<const State> seen, double) {
            return std::vector{seen[0].position[0], seen[0].position[1]};
          }};
}

/// Energy in the rotating axes.
Energy energy(const Parameters& p, std::span<const double> x) {
  const auto conserved =
      foucault::Cartesian<double>{asked(p)}.conserved({x[0], x[1], x[2], x[3], x[4], x[5]}, 0);
  return {conserved[0].value, conserved[0].moving};
}

/// The slower the initial rotation about the vertical, the closer the bob passes the lowest point, where
/// theta is undefined.
Scene scene() {
  return {
      .motion = swinging_bob,
      .horizon = 16,
      .game_tolerance = centimeter,
      .sweep_parameter = "theta_dot",
      .sweep_values = {3, 1, 0.25, 0.125, 0.0625},
      .perturbed_parameters = {"theta", "phi", "theta_dot"},
      .axes = {{"x", "y"}, "s", {{"m", {0, 1}}}},
      .listing =
          {{"chapters/03_rigid_body_motion/17_foucault/models.hpp"},
           {{"averaged",
             "foucault::SmallAngle<double>{{lambda, L, omega, g, theta, phi, theta_dot, phi_dot}, true}"},
            {"small angle",
             "foucault::SmallAngle<double>{{lambda, L, omega, g, theta, phi, theta_dot, phi_dot}}"},
            {"two angles as published",
             "foucault::TwoAngles<double>{{lambda, L, omega, g, theta, phi, theta_dot, phi_dot}, 0}"},
            {"two angles",
             "foucault::TwoAngles<double>{{lambda, L, omega, g, theta, phi, theta_dot, phi_dot}}"},
            {"Cartesian with constraint",
             "foucault::Cartesian<double>{{lambda, L, omega, g, theta, phi, theta_dot, phi_dot}}"}}},
      .draw = foucault::draw<Parameters>,
      .staging = staging,
      .laws = {energy},
      .faulted = {"two angles as published"},
  };
}

Findings study(const Parameters& p, const Reference& truth) {
  const Horizon horizon{scene().horizon};
  const Given<double> pendulum = asked(p);
  const Cone cone{p["h"], p["r"]};
  return {
      claims(p["seed"]),
      {motion(scene(), p, truth), bob_on_earth(horizon, truth), push(pendulum, horizon, truth), hours(truth),
       cone_swing(pendulum, cone, horizon, truth), inertia(cone)},
      roots(),
      R"(The point's equations are right, {{division at the lowest point|except for a division by zero at the lowest point}}; the cone's are not: {{a center of mass that halves the volume|its center of mass}}, {{moments about the base|its moments}} and {{the cone's own turning|its angular velocity}} are wrong.)"};
}

}  // namespace ex03_17

Exercise exercise_3_17() {
  using namespace ex03_17;
  return {"Foucault pendulum",
          "Derive the motion of a Foucault pendulum of length $L$ at latitude $\\lambda$ on an Earth that "
          "turns at $\\omega$ by Lagrange's equations. Then replace the point mass by a solid cone.",
          parameters,
          scene(),
          study,
          proofs};
}

}  // namespace oddity
