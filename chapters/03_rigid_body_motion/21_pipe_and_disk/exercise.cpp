// Exercise 3.21: a disk of mass m turns about a pipe of length L. The pipe's other end is a joint, and its
// inclination phi is fixed; psi is the disk's angle about the pipe, theta the pipe's about the vertical. What
// is the effect of gravity?
//   theta'' = F_theta/((m L^2 + mu2) sin(phi)^2), psi'' = -F_theta cos(phi)/((m L^2 + mu2) sin(phi)^2)
// These equations are compared with Lagrange's for the rigid disk. Its kinetic energy is that of its center
// plus tr(R' J R'^T)/2 of its rotation matrix, differentiated by nested dual numbers. mu2 is the moment about
// a diameter, mu3 that about the pipe; J has the second moments of mass, (mu3/2, mu3/2, mu2 - mu3/2). If phi
// were free, gravity would turn the pipe like a top.

#include "chapters/03_rigid_body_motion/21_pipe_and_disk/drawing.hpp"
#include "chapters/03_rigid_body_motion/21_pipe_and_disk/pipe_and_disk.hpp"

#include <cmath>
#include <string>

#include "chapters/energies.hpp"
#include "chapters/in_float.hpp"
#include "chapters/scene.hpp"

namespace oddity {

namespace ex03_21 {

using namespace pipe_and_disk;

constexpr Parameter parameters[] = {
    {"m", usual.m, "kg", "mass of the disk", 1e-3, 1e5},
    {"L", usual.L, "m", "length of the pipe", 1e-3, 1e4},
    {"r", usual.r, "m", "radius of the disk", 1e-3, 1e4},
    {"phi", usual.phi, "rad", "inclination of the pipe from the vertical", 0.01, 3.14},
    {"f", usual.f, "N", "horizontal force on the disk's center", 1e-6, 1e6},
    {"k", usual.k, "N s/m", "friction of the disk's center", 0, 1e4},
    {"theta", usual.theta, "rad", "start: angle of the pipe from the force", -3.14, 3.14},
    {"theta_dot", usual.theta_dot, "rad/s", "start: its speed", -1e3, 1e3},
    {"psi_dot", usual.psi_dot, "rad/s", "start: the disk's speed about the pipe", -1e5, 1e5},
    {"seed", 321, "", "seed of the random samples", 0, 1e9, whole_number},
};

// ---- the quantities ---------------------------------------------------------------------------------------

Given<double> asked(const Parameters& p) {
  return {p["m"], p["L"], p["r"], p["phi"], p["f"], p["k"], p["theta"], p["theta_dot"], p["psi_dot"]};
}

const std::string constant = "constant speeds", two = "two angles", one = "one angle",
                  cartesian = "Cartesian center";

Known true_motion(const Given<double>& d, const Horizon& horizon, const Reference& truth) {
  return trajectory(truth, "03_21_disk", {d.m, d.L, d.r, d.phi, d.f, d.k, d.theta, d.theta_dot, d.psi_dot},
                    horizon);
}

const std::string need_reason = "a hundred-millionth of the angle turned through";

constexpr double seconds = 8;

Quantity under_gravity(const Given<double>& disk, const Reference& truth) {
  const Horizon horizon{seconds};
  Quantity motion = quantity("gravity", "m, m, rad", "center and spin at four times, gravity alone",
                             true_motion(disk, horizon, truth), {});
  motion.need = {1e-8 * size_of(motion.reference.value), need_reason};
  SceneMethods(motion, horizon, halving("step", 0.125, 9), tolerances(3, 11))
      .closed_form(constant, ConstantSpeeds<double>{disk})
      .by<ode::ExplicitEuler>(two, TwoAngles<double>{disk})
      .by<ode::RungeKutta4>(two, TwoAngles<double>{disk})
      .by<ode::RungeKutta4>(cartesian, Center<double>{disk})
      .by<ode::DormandPrince54>(cartesian, Center<double>{disk});
  return motion;
}

enum class Tried { common, whole_catalog };

Quantity under_force(const std::string& name, const std::string& says, const Given<double>& disk,
                     const Horizon& horizon, const Reference& truth, Tried tried = Tried::common) {
  Quantity motion = quantity(name, "m, m, rad", says, true_motion(disk, horizon, truth), {});
  motion.need = {1e-8 * size_of(motion.reference.value), need_reason};
  SceneMethods methods(motion, horizon, halving("step", 0.125, 10), tolerances(3, 11));
  methods.closed_form(constant, ConstantSpeeds<double>{disk}, Outcome::inaccurate, "the force turns the pipe")
      .by_engine_integrators(one, OneAngle<double>{disk});
  if (tried == Tried::whole_catalog)
    methods.by_remaining_integrators(one, OneAngle<double>{disk},
                                     {{"linearly implicit Euler", Outcome::inaccurate,
                                       "its order is too low for this need at this step"}});
  methods.by_engine_integrators(two, TwoAngles<double>{disk})
      .by_engine_integrators(cartesian, Center<double>{disk});
  return motion;
}

/// Observes a mark on the rim of a disk on an upright pipe, at the angle theta + psi.
template <class Model>
struct RimMark : Model {
  std::array<double, 2> mark(double angle) const {
    return {this->p.r * std::cos(angle), this->p.r * std::sin(angle)};
  }
  std::array<double, 2> at(double t) const requires ClosedForm<Model> {
    return mark(this->p.theta + (this->p.theta_dot + this->p.psi_dot) * t);
  }
  template <class State>
  std::array<double, 2> observe(const State& x, double) const {
    return mark(x[0] + x[1]);
  }
};

Quantity upright(Given<double> disk, const Reference& truth) {
  disk.phi = disk.f = disk.k = 0;
  const Horizon horizon{seconds};
  Quantity motion = quantity(
      "upright", "m", "mark on the disk's rim at four times, with the pipe upright",
      trajectory(truth, "03_21_upright", {disk.r, disk.theta, disk.theta_dot, disk.psi_dot}, horizon), {});
  motion.need = {1e-8 * disk.r, "a hundred-millionth of the radius"};
  const std::string why = "$0/0$: nothing resists the angle of an upright pipe";
  SceneMethods(motion, horizon, halving("step", 0.125, 4), tolerances(3, 11))
      .closed_form(constant, RimMark<ConstantSpeeds<double>>{{disk}})
      .by<ode::RungeKutta4>(two, RimMark<TwoAngles<double>>{{disk}}, Outcome::non_finite, why)
      .by<ode::DormandPrince54>(two, RimMark<TwoAngles<double>>{{disk}}, Outcome::non_finite, why);
  return motion.add(
      Breakdown{"Upright, the published equations divide zero by zero, even without any force. The constant "
                "speeds need no division; but only the sum of the two angles is then seen.",
                two + ", Runge-Kutta 4", 0.125, Outcome::non_finite, constant + ", closed form", 0});
}

Quantity wind(const Parameters& p, const Horizon& horizon, const Reference& truth) {
  return with_float(
      under_force("wind", "center and spin at four times, under a horizontal force and friction", asked(p),
                  horizon, truth, Tried::whole_catalog),
      horizon, asked(p), {constant, one, two, cartesian});
}

/// The observables are the center (x, y) and psi.
Energy energy(const Parameters& p, std::span<const double> x) {
  const Given<double> d = asked(p);
  const double turning = (x[0] * x[4] - x[1] * x[3]) / (x[0] * x[0] + x[1] * x[1]),
               spin = x[5] + turning * std::cos(d.phi);
  return energy_seen((d.m + d.mu2() / (d.L * d.L)) * half_square(x.subspan(3, 2)) + d.mu3() * spin * spin / 2,
                     -d.f * x[0]);
}

/// Distance from the center's circle.
double off(const Parameters& p, std::span<const double> x, double) {
  return std::abs(std::hypot(x[0], x[1]) - asked(p).radius());
}

Scene scene() {
  return {
      .motion = wind,
      .horizon = seconds,
      .game_tolerance = centimeter,
      .sweep_parameter = "phi",
      .sweep_values = {1.5, 1, 0.5, 0.2, 0.1, 0.05},
      .perturbed_parameters = {"theta", "theta_dot", "psi_dot"},
      .axes = {{"x", "y", "psi"}, "s", {{"m", {0, 1}}, {"rad", {2}}}},
      .listing = {{"chapters/03_rigid_body_motion/21_pipe_and_disk/models.hpp"},
                  {{"constant speeds",
                    "pipe_and_disk::ConstantSpeeds<double>{{m, L, r, phi, f, k, theta, theta_dot, psi_dot}}"},
                   {"one angle",
                    "pipe_and_disk::OneAngle<double>{{m, L, r, phi, f, k, theta, theta_dot, psi_dot}}"},
                   {"two angles",
                    "pipe_and_disk::TwoAngles<double>{{m, L, r, phi, f, k, theta, theta_dot, psi_dot}}"},
                   {"Cartesian center",
                    "pipe_and_disk::Center<double>{{m, L, r, phi, f, k, theta, theta_dot, psi_dot}}"}}},
      .draw = pipe_and_disk::draw<Parameters>,
      .laws = {energy, off},
  };
}

Findings study(const Parameters& p, const Reference& truth) {
  const Given<double> pushed = asked(p);
  const Horizon horizon{seconds};
  Given<double> free = pushed, frictionless = pushed, steep = pushed;
  free.f = free.k = frictionless.k = 0;
  steep.phi = nearly_upright;
  Quantity fast = under_force(
      "nearly_upright", filled("center and spin with the pipe at @1 rad from the vertical", {steep.phi}),
      steep, horizon, truth);
  fast.add(
      Breakdown{R"(Where the pipe is nearly upright the division by $\sin^2\phi$ makes a slow swing a quick )"
                "one: explicit Euler at @2 steps a second gains energy and whirls round. Runge-Kutta's "
                "stability reaches up the imaginary axis.",
                two + ", explicit Euler",
                0.125,
                Outcome::drifted,
                two + ", Runge-Kutta 4",
                0.0009765625,
                {steps_in_one(Side::broken)}});
  fast.add(Breakdown{
      "In Cartesian coordinates nothing calls the center back to its circle: at steps that are long for its "
      "small radius even Runge-Kutta's center leaves for infinity. An angle cannot leave the circle.",
      cartesian + ", Runge-Kutta 4", 0.125, Outcome::non_finite, one + ", Runge-Kutta 4", 0.0009765625});
  return {
      claims(p["seed"]),
      {under_gravity(free, truth), motion(scene(), p, truth),
       under_force("frictionless", "center and spin under the force alone", frictionless, horizon, truth),
       fast, upright(pushed, truth)},
      roots(),
      R"(The motion is right, {{division by an upright pipe|except for a division by zero where the pipe is upright}}.)"};
}

}  // namespace ex03_21

Exercise exercise_3_21() {
  using namespace ex03_21;
  return {"Pipe and disk",
          "A disk spins about a pipe that is held at the inclination $\\phi$ and free to turn about the "
          "vertical. How do the two angles move under gravity? Under a horizontal force?",
          parameters,
          scene(),
          study,
          proofs,
          Expected::in_whole_ranges};
}

}  // namespace oddity
