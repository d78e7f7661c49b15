// Exercise 3.25: three masses on rigid massless rods, hung one from the other, with energies and equations of
// motion; and a chain of n masses.
//   pattern    sum_j mu_max(i,j) r_i r_j (cos(theta_i - theta_j) theta_j''
//              + sin(theta_i - theta_j) theta_j'^2) = -mu_i g r_i sin(theta_i).
//   tensions   (1/m_k + 1/m_(k-1)) t_k - c_k t_(k-1)/m_(k-1) - c_(k+1) t_(k+1)/m_k = r_k theta_k'^2.
//              For k = 1, g cos(theta_1) is added to the right side.
// Here mu_k is the mass from k on, and c_k = cos(theta_k - theta_(k-1)). The tensions' system is tridiagonal,
// so that its solution takes a time linear in n.
// methods.cpp contains the quantities, claims.cpp the claims. References: 60-digit Taylor series in Cartesian
// coordinates, confirmed by extrapolation in the angles. Masses, lengths and initial values are dyadic, so
// that all precisions start from the same state.

#include "chapters/03_rigid_body_motion/25_chain/chain.hpp"
#include "chapters/03_rigid_body_motion/25_chain/drawing.hpp"
#include "chapters/energies.hpp"
#include "chapters/in_float.hpp"
#include "chapters/scene.hpp"
#include "solvers/turns.hpp"

namespace oddity {

namespace ex03_25 {

constexpr Parameter parameters[] = {
    {"m1", 1, "kg", "mass next to the pivot", 1e-4, 1e5},
    {"m2", 0.75, "kg", "mass in the middle", 1e-4, 1e5},
    {"m3", 0.5, "kg", "mass at the end", 1e-4, 1e5},
    {"r1", 1, "m", "length of the rod at the pivot", 1e-3, 1e4},
    {"r2", 0.75, "m", "length of the rod in the middle", 1e-3, 1e4},
    {"r3", 0.5, "m", "length of the rod at the end", 1e-3, 1e4},
    {"g", 9.8125, "m/s^2", "gravity", 1e-3, 1e4},
    {"h", 2.5, "m", "height of the pivot", -1e3, 1e3},
    {"theta1", 0.25, "rad", "angle at the start, from the downward vertical", -7, 7},
    {"theta2", 0.375, "rad", "angle at the start", -7, 7},
    {"theta3", 0.5, "rad", "angle at the start", -7, 7},
    {"omega1", 0, "rad/s", "angular velocity at the start", -1e3, 1e3},
    {"omega2", 0, "rad/s", "angular velocity at the start", -1e3, 1e3},
    {"omega3", 0, "rad/s", "angular velocity at the start", -1e3, 1e3},
    {"seed", 325, "", "seed of the random samples", 0, 1e9, whole_number},
};

// ---- the motion -------------------------------------------------------------------------------------------

Triple asked(const Parameters& p) {
  return {{p["m1"], p["m2"], p["m3"]},
          {p["r1"], p["r2"], p["r3"]},
          p["g"],
          p["h"],
          {p["theta1"], p["theta2"], p["theta3"]},
          {p["omega1"], p["omega2"], p["omega3"]}};
}

Quantity hanging_of(const Parameters& p, const Horizon& horizon, const Reference& truth) {
  return with_float(hanging(asked(p), horizon, truth), horizon, asked(p), {"dense mass matrix", "tensions"});
}

engines::Staging staging(const Parameters& p) {
  using namespace engines;
  const chain::Given<double> chain = asked(p);
  World world{.gravity = {0, -chain.g, 0}};
  Vector at{0, chain.h, 0}, velocity{};
  for (int k = 0; k < 3; ++k) {
    const auto i = static_cast<std::size_t>(k);
    const double r = chain.r[i], c = cos(chain.theta[i]), s = sin(chain.theta[i]);
    Body mass{chain.m[i], {0.1, 0.1, 0.1}};
    mass.start.position = at + Vector{r * s, -r * c, 0};
    mass.start.velocity = velocity = velocity + chain.omega[i] * Vector{r * c, r * s, 0};
    world.joints.push_back({.kind = Joint::rod, .a = k - 1, .b = k, .at = at, .end = mass.start.position});
    at = mass.start.position;
    world.bodies.push_back(mass);
  }
  return {world, [](std::span<const State> seen, double) {
            std::vector<double> all;
            for (const State& mass : seen)
              all.insert(all.end(), mass.position.begin(), mass.position.begin() + 2);
            return all;
          }};
}

Energy energy(const Parameters& p, std::span<const double> x) {
  const double m[]{p["m1"], p["m2"], p["m3"]};
  double kinetic = 0, potential = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    kinetic += m[k] * half_square(x.subspan(6 + 2 * k, 2));
    potential += m[k] * p["g"] * (x[2 * k + 1] - p["h"]);
  }
  return energy_seen(kinetic, potential);
}

/// Largest error of the rods' lengths.
double off(const Parameters& p, std::span<const double> x, double) {
  const double r[]{p["r1"], p["r2"], p["r3"]};
  double most = 0, above_x = 0, above_y = p["h"];
  for (std::size_t k = 0; k < 3; ++k) {
    most = std::max(most, std::abs(std::hypot(x[2 * k] - above_x, x[2 * k + 1] - above_y) - r[k]));
    above_x = x[2 * k], above_y = x[2 * k + 1];
  }
  return most;
}

Scene scene() {
  return {
      .motion = hanging_of,
      .horizon = 4,
      .game_tolerance = centimeter,
      .sweep_parameter = "theta1",
      .sweep_values = {0.0625, 0.25, 0.5, 1, 1.5},
      .perturbed_parameters = {"theta1", "theta2", "theta3"},
      .axes = {{"x1", "y1", "x2", "y2", "x3", "y3"}, "s", {{"m", {0, 1}}, {"m", {2, 3}}, {"m", {4, 5}}}},
      .listing =
          {{"chapters/03_rigid_body_motion/25_chain/models.hpp"},
           {{"dense mass matrix",
             "chain::Angles<double, chain::Equations::dense>{{{m1, m2, m3}, {r1, r2, r3}, g, h, {theta1, theta2, "
             "theta3}, {omega1, omega2, omega3}}}"},
            {"tensions",
             "chain::Angles<double, chain::Equations::tensions>{{{m1, m2, m3}, {r1, r2, r3}, g, h, {theta1, theta2, "
             "theta3}, {omega1, omega2, omega3}}}"},
            {"normal modes",
             "chain::Modes<double>({{m1, m2, m3}, {r1, r2, r3}, g, h, {theta1, theta2, theta3}, {omega1, omega2, "
             "omega3}})"}}},
      .draw = chain::draw<Parameters>,
      .staging = staging,
      .laws = {energy, off},
  };
}

Findings study(const Parameters& p, const Reference& truth) {
  Findings found{claims(p["seed"]), quantities(asked(p), truth)};
  found.quantities.insert(found.quantities.begin(), motion(scene(), p, truth));
  return found;
}

}  // namespace ex03_25

Exercise exercise_3_25() {
  using namespace ex03_25;
  return {
      "Triple pendulum and a chain of n masses",
      R"(Three masses $m_k$ at $(x_k,y_k)$ hang under gravity $g$ one from the other by rigid massless rods of )"
      R"(the lengths $r_k$, the first from a pivot at $(0,h)$. Find the kinetic and the potential energy and the )"
      R"(equations of motion in the rods' angles $\theta_1,\theta_2,\theta_3$ from the downward vertical; what )"
      R"(becomes of them for $n$ masses?)",
      parameters,
      scene(),
      study,
      proofs,
      Expected::in_whole_ranges};
}

}  // namespace oddity
