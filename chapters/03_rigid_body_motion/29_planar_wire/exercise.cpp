// Exercise 3.29: a rigid curve moves in the plane; what replaces the thin rod's position, kinetic energy and
// generalized forces?
//   r = c + R(theta) b(s), int b delta ds = 0;  T = mu0/2 |c'|^2 + mu2/2 theta'^2, mu2 = int |b|^2 delta ds
//   |r'|^2 = |c'|^2 + theta'^2 |b|^2 + 2 theta' c'.(dR/dtheta b), whose last term vanishes only in the
//   integral
// methods.cpp contains the quantities, claims.cpp the claims.

#include "chapters/03_rigid_body_motion/29_planar_wire/drawing.hpp"
#include "chapters/03_rigid_body_motion/29_planar_wire/planar_wire.hpp"
#include "chapters/energies.hpp"
#include "chapters/in_float.hpp"
#include "chapters/scene.hpp"
#include "solvers/turns.hpp"

namespace oddity {

namespace ex03_29 {

constexpr Parameter parameters[] = {
    {"q", 1, "m", "size of the wires", 1e-3, 1e4},
    {"d", 2, "kg/m", "their density", 1e-6, 1e6},
    {"u", 2, "m/s", "velocity of the center at the start, level", -1e4, 1e4},
    {"v", 5, "m/s", "velocity of the center at the start, upward", -1e4, 1e4},
    {"w", 6, "rad/s", "angular velocity", -1e3, 1e3},
    {"g", 9.81, "m/s^2", "gravity", 0, 1e4},
    {"seed", 29, "", "seed of the random samples", 0, 1e9, whole_number},
};

Given asked(const Parameters& p) { return {p["q"], p["d"], p["u"], p["v"], p["w"], p["g"]}; }

Quantity fall_of(const Parameters& p, const Horizon& horizon, const Reference& truth) {
  return with_float(fall(asked(p), horizon, truth), horizon, asked(p),
                    {"center alone", "free fall", "x, y, theta", "two particles and a rod"});
}

engines::Staging staging(const Parameters& p) {
  const auto wire = planar_wire::thrown<double>(asked(p));
  engines::Body body{wire.mu0, {wire.mu2 / 2, wire.mu2 / 2, wire.mu2}};
  body.start.velocity = {wire.u, wire.v, 0};
  body.start.spin = {0, 0, wire.w};
  return {{.gravity = {0, -wire.g, 0}, .bodies = {body}},
          [wire](std::span<const engines::State> seen, double) {
            const engines::Vector b = engines::turned(seen[0].orientation, {wire.b[0], wire.b[1], 0});
            return std::vector{seen[0].position[0] + b[0], seen[0].position[1] + b[1]};
          }};
}

/// The places are the center of mass and the angle.
Energy energy(const Parameters& p, std::span<const double> x) {
  const auto wire = planar_wire::thrown(asked(p));
  return energy_seen(wire.mu0 * half_square(x.subspan(3, 2)) + wire.mu2 * half_square(x.subspan(5)),
                     wire.mu0 * wire.g * x[1]);
}

Scene scene() {
  return {
      .motion = fall_of,
      .horizon = 2,
      .game_tolerance = centimeter,
      .sweep_parameter = "w",
      .sweep_values = {1, 3, 6, 10, 20},
      .perturbed_parameters = {"u", "v", "w"},
      .axes = {{"x", "y"}, "s", {{"m", {0, 1}}}},
      .listing = {{"chapters/03_rigid_body_motion/29_planar_wire/models.hpp"},
                  {{"center alone",
                    "planar_wire::PointMass<double>{planar_wire::thrown<double>({q, d, u, v, w, g})}"},
                   {"free fall",
                    "planar_wire::FreeFall<double>{planar_wire::thrown<double>({q, d, u, v, w, g})}"},
                   {"x, y, theta",
                    "planar_wire::Generalized<double>{planar_wire::thrown<double>({q, d, u, v, w, g})}"},
                   {"two particles and a rod",
                    "planar_wire::TwoParticles<double>{planar_wire::thrown<double>({q, d, u, v, w, g})}"}}},
      .draw = planar_wire::draw<Parameters>,
      .staging = staging,
      .laws = {energy},
      .is_linear = true,
  };
}

Findings study(const Parameters& p, const Reference& truth) {
  Findings found{
      claims(p["seed"]), inertias(asked(p), truth), roots(),
      R"(Energy and forces of the wire are right; {{cross term left out|the speed of a point lacks a cross term, which integrates to zero}}, and {{friction at rest|friction on a wire at rest is $0/0$}}.)"};
  found.quantities.push_back(motion(scene(), p, truth));
  found.quantities.back().add(
      Breakdown{"Particles and a rod: explicit Euler lets the rod grow and the energy with it. With "
                "the angle as a coordinate there is no rod to keep, and Verlet's method is exact.",
                "two particles and a rod, explicit Euler", 0.125, Outcome::drifted,
                "x, y, theta, velocity Verlet", 0.125});
  return found;
}

}  // namespace ex03_29

Exercise exercise_3_29() {
  using namespace ex03_29;
  return {
      "Rigid curve in the plane",
      R"(A rigid wire of any shape moves in the plane, with unit vectors $\imath$ and $\jmath$. Find its )"
      R"(position, kinetic energy and generalized forces, as for a thin rod. The wire of mass $\mu_0$ has )"
      R"(its center of mass at $c=(x,y)$, the moment $\mu_2$ about it, and is turned by $\theta$. Its )"
      R"(points have the places $b=(b_0,b_1)$ from the center of mass before the turn $R(\theta)$, the )"
      R"(density $\delta$ and the arc length $s$.)",
      parameters,
      scene(),
      study,
      proofs};
}

}  // namespace oddity
