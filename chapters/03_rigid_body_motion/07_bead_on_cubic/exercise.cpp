// Exercise 3.7: when does a bead, released at rest at q = 1 on the frictionless curve (q, q^2, q^3), reach
// the origin?
//   one coordinate   (1 + 4q^2 + 9q^4) q'' = -(3g q^2 + 2q (2 + 9q^2) q'^2).
//   energy           (1 + 4q^2 + 9q^4) q'^2 = 2g (q0^3 - q^3).
// The equations are compared with Lagrange's equation, whose Lagrangian is differentiated by dual numbers
// from the curve alone, and with the wire's forces in Cartesian coordinates. The energy equation also has the
// constant solution q = q0, and the integrand for the time is infinite at q0; q = q0 (1 - u^2) avoids both.

#include "chapters/03_rigid_body_motion/07_bead_on_cubic/bead_on_cubic.hpp"
#include "chapters/03_rigid_body_motion/07_bead_on_cubic/drawing.hpp"
#include "chapters/energies.hpp"
#include "chapters/in_float.hpp"

namespace oddity {

namespace ex03_07 {

constexpr Parameter parameters[] = {
    {"q0", 1, "m", "release", 1e-3, 1e3},
    {"g", 1, "m/s^2", "gravity", 1e-3, 1e4},
    {"seed", 7, "", "seed of the random samples", 0, 1e9, whole_number},
};

Quantity position(const Parameters& p, const Horizon& horizon, const Reference& truth) {
  const bead_on_cubic::Given<double> bead{p["q0"], p["g"]};
  return with_float(
      slide(bead, horizon, truth), horizon, bead,
      {"straight tangent", "", "energy in u", "one coordinate", "Cartesian with constraints", ""});
}

Energy energy(const Parameters& p, std::span<const double> x) { return point_energy(p["g"], x); }

/// Distance from the wire's point with the same x.
double off(const Parameters&, std::span<const double> x, double) {
  const auto wire = bead_on_cubic::curve(x[0]);
  return std::hypot(x[1] - wire[1], x[2] - wire[2]);
}

Scene scene() {
  return {
      .motion = position,
      .horizon = 4,
      .game_tolerance = centimeter,
      .sweep_parameter = "q0",
      .sweep_values = {0.25, 0.5, 1, 1.5, 2},
      .perturbed_parameters = {"q0"},
      .axes = {{"x", "y", "z"}, "s", {{"m", {0, 1, 2}}}},
      .listing = {{"chapters/03_rigid_body_motion/07_bead_on_cubic/models.hpp"},
                  {{"straight tangent", "bead_on_cubic::StraightTangent<double>{{q0, g}}"},
                   {"energy in q", "bead_on_cubic::EnergyInQ<double>{{q0, g}}"},
                   {"energy in u", "bead_on_cubic::EnergyInU<double>{{q0, g}}"},
                   {"one coordinate", "bead_on_cubic::OneCoordinate<double>{{q0, g}}"},
                   {"Cartesian with constraints",
                    "bead_on_cubic::CartesianWithConstraints<double>{{q0, g}}"}}},
      .draw = bead_on_cubic::draw<Parameters>,
      .laws = {energy, off},
  };
}

Findings study(const Parameters& p, const Reference& truth) {
  return {
      claims(p["seed"], truth),
      {arrival({p["q0"], p["g"]}, truth), motion(scene(), p, truth)},
      roots(),
      R"(The equation of motion and the time to the origin are right; {{beyond the origin|that $\ddot q$ is negative and $\dot q$ falls holds up to the origin only}}.)"};
}

}  // namespace ex03_07

Exercise exercise_3_7() {
  using namespace ex03_07;
  return {
      "Bead on a cubic curve",
      "A bead slides without friction on the curve $(q,q^2,q^3)$ under gravity $-g\\,k$, let go at rest at "
      "$q=1$. Does $q$ decrease all the time, and when is the bead at the origin?",
      parameters,
      scene(),
      study,
      proofs};
}

}  // namespace oddity
