// Exercise 3.13: the motion of a ball in a cylindrical chute of radius R whose axis falls by H over its
// length L.
//   cylinder  (X - P)^T (I - D D^T) (X - P) = R^2, D = (-cos(theta), 0, sin(theta)), sin(theta) = H/L.
//   height    x3 = (L R - H x1 - L sqrt(R^2 - x2^2)) / (L cos(theta)).
//   motion    x'' = -(x'^T (Hessian of h) x' + g) / (1 + |grad h|^2) grad h.

#include <numbers>

#include "chapters/03_rigid_body_motion/13_tilted_chute/drawing.hpp"
#include "chapters/03_rigid_body_motion/13_tilted_chute/tilted_chute.hpp"
#include "chapters/energies.hpp"
#include "chapters/in_float.hpp"
#include "reference/bad_input.hpp"
#include "solvers/turns.hpp"

namespace oddity {

namespace ex03_13 {

constexpr Parameter parameters[] = {
    {"R", 1, "m", "radius", 1e-3, 1e5},
    {"L", 5, "m", "length of the chute", 1e-2, 1e5},
    {"H", 3, "m", "fall over the length, less than $L$", 1e-3, 1e5},
    {"g", 9.81, "m/s^2", "gravity", 1e-3, 1e4},
    {"phi", 1, "rad", "start: the angle about the axis, from the lowest line", 0.01, 3.14},
    {"u", -1, "m/s", "start: the speed down the chute", -1e3, 1e3},
    {"seed", 313, "", "seed of the random samples", 0, 1e9, whole_number},
};

Ball asked(const Parameters& p) {
  if (!(p["H"] < p["L"])) throw BadInput("the chute's fall H must be less than its length L");
  return {p["R"], p["L"], p["H"], p["g"], p["phi"], p["u"]};
}

Quantity swinging_ball(const Parameters& p, const Horizon& horizon, const Reference& truth) {
  return with_float(swing(asked(p), horizon, truth), horizon, asked(p),
                    {"center line", "small angle", "elliptic angle", "angle about the axis", "height field",
                     "Cartesian with constraint"});
}

/// A rod of 1.5 times the radius that turns about the chute's axis and slides along it.
engines::Staging staging(const Parameters& p) {
  using namespace engines;
  const tilted_chute::Given<double> ball = asked(p);
  const double R = ball.R, c = ball.chute().c(), s = ball.chute().s(), d = 0.75 * R, across = 0.1875 * R * R;
  const Vector e{c, 0, -s}, n{s, 0, c}, side{0, 1, 0}, middle = R * n;
  Body rod{1, {0.01 * R * R, across, across}};
  rod.start.position = middle + d * (sin(ball.phi) * side - cos(ball.phi) * n);
  rod.start.velocity = ball.u * e;
  // its axis along n, its second axis to the side, both rotated about e
  const Quaternion upright = engines::about(side, -std::asin(c));
  rod.start.orientation = product(engines::about(e, ball.phi), upright);
  return {{.gravity = {0, 0, -ball.g},
           .bodies = {rod},
           .joints = {{.kind = Joint::cylinder, .at = middle, .axis = e}}},
          [=](std::span<const State> seen, double) {
            const Vector r = seen[0].position - middle;
            const double phi = std::atan2(dot(r, side), -dot(r, n));
            const auto x = ball.chute().position(dot(r, e), phi);
            return std::vector(x.begin(), x.end());
          }};
}

Energy energy(const Parameters& p, std::span<const double> x) { return point_energy(p["g"], x); }

/// Deviation from the distance R to the axis.
double off(const Parameters& p, std::span<const double> x, double t) {
  return off_constraints(tilted_chute::InSpace<double>{asked(p)}.constraints({x[0], x[1], x[2], 0, 0, 0}, t));
}

Scene scene() {
  return {
      .motion = swinging_ball,
      .horizon = 4,
      .game_tolerance = centimeter,
      .sweep_parameter = "phi",
      .sweep_values = {0.1, 0.5, 1, 1.35, 1.5},
      .perturbed_parameters = {"phi", "u"},
      .axes = {{"x1", "x2", "x3"}, "s", {{"m", {0, 1, 2}}}},
      .listing = {{"chapters/03_rigid_body_motion/13_tilted_chute/models.hpp"},
                  {{"center line", "tilted_chute::CenterLine<double>{{R, L, H, g, phi, u}}"},
                   {"small angle", "tilted_chute::SmallAngle<double>{{R, L, H, g, phi, u}}"},
                   {"elliptic angle", "tilted_chute::EllipticAngle<double>({R, L, H, g, phi, u})"},
                   {"angle about the axis", "tilted_chute::Angle<double>{{R, L, H, g, phi, u}}"},
                   {"height field", "tilted_chute::in_plane<double>({R, L, H, g, phi, u})"},
                   {"Cartesian with constraint", "tilted_chute::InSpace<double>{{R, L, H, g, phi, u}}"}}},
      .draw = tilted_chute::draw<Parameters>,
      .staging = staging,
      .laws = {energy, off},
  };
}

Findings study(const Parameters& p, const Reference& truth) {
  const Horizon horizon{scene().horizon};
  const Ball ball = asked(p);
  Ball centered = ball, steep = ball, rim = ball;
  centered.phi = 0;
  steep.phi = 1.5;
  rim.phi = std::numbers::pi / 2;
  return {
      claims(p["seed"]),
      {motion(scene(), p, truth), on_center(centered, horizon, truth), below_rim(steep, horizon, truth),
       from_rim(rim, horizon, truth)},
      roots(),
      R"(The chute, its equations and the motion on the center line are right; but {{beyond 45 degrees|a steeper chute is faster along $x_1$ up to $45^\circ$ only}}, {{friction across|friction does change the second equation}}, and {{a ball sent up|a ball sent up slows down first}}.)"};
}

}  // namespace ex03_13

Exercise exercise_3_13() {
  using namespace ex03_13;
  return {
      "Ball in a tilted chute",
      "A ball slides in a chute, the lower half of a cylinder of radius $R$ whose axis falls by $H$ over its "
      "length $L$. Write the chute as a height field and find the ball's equations of motion; how does it "
      "move on the center line?",
      parameters,
      scene(),
      study,
      proofs,
      Expected::in_whole_ranges};
}

}  // namespace oddity
