#pragma once

// The quantities of exercise 3.21.

#include <cmath>
#include <string>

#include "chapters/03_rigid_body_motion/21_pipe_and_disk/models.hpp"
#include "chapters/03_rigid_body_motion/shared/two_coordinates.hpp"
#include "chapters/scene.hpp"

namespace oddity::pipe_and_disk {

inline const std::string constant = "constant speeds", two = "two angles", one = "one angle",
                         cartesian = "Cartesian center";

inline Known true_motion(const Given<double>& d, const Horizon& horizon, const Reference& truth) {
  return trajectory(truth, "03_21_disk", {d.m, d.L, d.r, d.phi, d.f, d.k, d.theta, d.theta_dot, d.psi_dot},
                    horizon);
}

inline const std::string says_need = "a hundred-millionth of the angle turned through";

inline constexpr double seconds = 8;

inline Quantity under_gravity(const Given<double>& disk, const Reference& truth) {
  const Horizon horizon{seconds};
  Quantity motion = quantity("gravity", "m, m, rad", "center and spin at four times, gravity alone",
                             true_motion(disk, horizon, truth), {});
  motion.need = {1e-8 * size_of(motion.reference.value), says_need};
  Ladder(motion, horizon, halving("step", 0.125, 9), tolerances(3, 11))
      .closed_form(constant, ConstantSpeeds<double>{disk})
      .by<ode::ExplicitEuler>(two, TwoAngles<double>{disk})
      .by<ode::RungeKutta4>(two, TwoAngles<double>{disk})
      .by<ode::RungeKutta4>(cartesian, Center<double>{disk})
      .by<ode::DormandPrince54>(cartesian, Center<double>{disk});
  return motion;
}

enum class Tried { common, whole_catalog };

/// `euler`: how explicit Euler ends on the two angles and on the center.
inline Quantity under_force(const std::string& name, const std::string& says, const Given<double>& disk,
                            std::array<Outcome, 2> euler, const Horizon& horizon, const Reference& truth,
                            Tried tried = Tried::common) {
  Quantity motion = quantity(name, "m, m, rad", says, true_motion(disk, horizon, truth), {});
  motion.need = {1e-8 * size_of(motion.reference.value), says_need};
  Ladder ladder(motion, horizon, halving("step", 0.125, 10), tolerances(3, 11));
  ladder.closed_form(constant, ConstantSpeeds<double>{disk}, Outcome::inaccurate, "the force turns the pipe")
      .by_common(one, OneAngle<double>{disk});
  if (tried == Tried::whole_catalog)
    ladder.by_others(one, OneAngle<double>{disk},
                     {{"linearly implicit Euler", Outcome::inaccurate,
                       "its order is too low for this need at this step"}});
  ladder.by_common(two, TwoAngles<double>{disk}, euler[0])
      .by_common(cartesian, Center<double>{disk}, euler[1]);
  return motion;
}

/// What is seen of a disk on an upright pipe: a mark on its rim, at the angle theta + psi.
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

inline Quantity upright(Given<double> disk, const Reference& truth) {
  disk.phi = disk.f = disk.k = 0;
  const Horizon horizon{seconds};
  Quantity motion = quantity(
      "upright", "m", "mark on the disk's rim at four times, with the pipe upright",
      trajectory(truth, "03_21_upright", {disk.r, disk.theta, disk.theta_dot, disk.psi_dot}, horizon), {});
  motion.need = {1e-8 * disk.r, "a hundred-millionth of the radius"};
  const std::string why = "0/0: nothing resists the angle of an upright pipe";
  Ladder(motion, horizon, halving("step", 0.125, 4), tolerances(3, 11))
      .closed_form(constant, RimMark<ConstantSpeeds<double>>{{disk}})
      .by<ode::RungeKutta4>(two, RimMark<TwoAngles<double>>{{disk}}, Outcome::non_finite, why)
      .by<ode::DormandPrince54>(two, RimMark<TwoAngles<double>>{{disk}}, Outcome::non_finite, why);
  return motion.add(
      Breakdown{"Upright, the published equations divide zero by zero, even without any force. The constant "
                "speeds need no division; but only the sum of the two angles is then seen.",
                two + ", Runge-Kutta 4", 0.125, Outcome::non_finite, constant + ", closed form", 0});
}

}  // namespace oddity::pipe_and_disk
