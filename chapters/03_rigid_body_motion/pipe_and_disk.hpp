#pragma once

// The models and quantities of exercise 3.21.

#include <cmath>
#include <string>

#include "chapters/03_rigid_body_motion/two_coordinates.hpp"
#include "chapters/scene.hpp"

namespace oddity::pipe_and_disk {

/// Mass m and radius r of the disk, length L and inclination phi of the pipe; on the center act a force f
/// along x and friction -k times its velocity. At the start theta, theta', psi = 0 and psi'.
struct Disk {
  double m, L, r, phi, f, k, theta, theta_dot, psi_dot;

  double mu2() const { return m * r * r / 4; }
  double mu3() const { return m * r * r / 2; }
  double inertia() const { return (m * L * L + mu2()) * std::sin(phi) * std::sin(phi); }
  double spin() const { return psi_dot + theta_dot * std::cos(phi); }
  double spin_energy() const { return mu3() * spin() * spin() / 2; }
  double radius() const { return L * std::sin(phi); }
  std::array<double, 3> seen(double angle, double psi) const {
    return {radius() * std::cos(angle), radius() * std::sin(angle), psi};
  }
};

struct ConstantSpeeds : Disk {
  std::array<double, 3> at(double t) const { return seen(theta + theta_dot * t, psi_dot * t); }
};

/// (theta, psi, theta', psi', work lost to friction): the book's equations.
struct TwoAngles : Disk {
  using State = std::array<double, 5>;
  State start() const { return {theta, 0, theta_dot, psi_dot, 0}; }
  void operator()(const State& x, State& dxdt, double) const {
    const double speed = radius() * x[2];
    const double force = -f * radius() * std::sin(x[0]) - k * radius() * speed;
    dxdt = {x[2], x[3], force / inertia(), -force * std::cos(phi) / inertia(), k * speed * speed};
  }
  std::array<double, 3> observe(const State& x, double) const { return seen(x[0], x[1]); }
  OneConserved conserved(const State& x, double) const {
    const double turn = x[3] + x[2] * std::cos(phi);
    return energy_of(inertia() * x[2] * x[2] / 2 + mu3() * turn * turn / 2,
                     x[4] - f * radius() * std::cos(x[0]));
  }
};

/// (theta, theta'), psi from the conserved spin.
struct OneAngle : Disk {
  using State = std::array<double, 2>;
  State start() const { return {theta, theta_dot}; }
  void operator()(const State& x, State& dxdt, double) const {
    const double arm = radius();
    dxdt = {x[1], (-f * arm * std::sin(x[0]) - k * arm * arm * x[1]) / inertia()};
  }
  std::array<double, 3> observe(const State& x, double t) const {
    return seen(x[0], spin() * t - std::cos(phi) * (x[0] - theta));
  }
};

/// (x, y, x', y', psi, work lost): the center as a mass m + mu2/L^2 on its circle.
struct Center : Disk {
  using State = std::array<double, 6>;
  State start() const {
    const double x = radius() * std::cos(theta), y = radius() * std::sin(theta);
    return {x, y, -y * theta_dot, x * theta_dot, 0, 0};
  }
  double mass() const { return m + mu2() / (L * L); }
  void operator()(const State& s, State& dsdt, double) const {
    const double square = s[0] * s[0] + s[1] * s[1], speeds = s[2] * s[2] + s[3] * s[3];
    const double a = (f - k * s[2]) / mass(), b = -k * s[3] / mass();
    const double inward = (a * s[0] + b * s[1] + speeds) / square;
    const double turning = (s[0] * s[3] - s[1] * s[2]) / square;
    dsdt = {s[2], s[3], a - inward * s[0], b - inward * s[1], spin() - turning * std::cos(phi), k * speeds};
  }
  std::array<double, 3> observe(const State& s, double) const { return {s[0], s[1], s[4]}; }
  OneConserved conserved(const State& s, double) const {
    return energy_of(mass() * (s[2] * s[2] + s[3] * s[3]) / 2 + spin_energy(), s[5] - f * s[0]);
  }
};

inline const std::string constant = "constant speeds", two = "two angles", one = "one angle",
                         cartesian = "Cartesian center";

inline Known true_motion(const Disk& d, const Horizon& horizon, const Reference& truth) {
  return trajectory(truth, "03_21_disk", {d.m, d.L, d.r, d.phi, d.f, d.k, d.theta, d.theta_dot, d.psi_dot},
                    horizon);
}

inline const std::string says_need = "a hundred-millionth of the angle turned through";

inline constexpr double seconds = 8;

inline Quantity under_gravity(const Disk& disk, const Reference& truth) {
  const Horizon horizon{seconds};
  Quantity motion = quantity("gravity", "m, m, rad", "center and spin at four times, gravity alone",
                             true_motion(disk, horizon, truth), {});
  motion.need = {1e-8 * size_of(motion.reference.value), says_need};
  Ladder(motion, horizon, halving("step", 0.125, 9), tolerances(3, 11))
      .closed_form(constant, ConstantSpeeds{disk})
      .by<ode::ExplicitEuler>(two, TwoAngles{disk})
      .by<ode::RungeKutta4>(two, TwoAngles{disk})
      .by<ode::RungeKutta4>(cartesian, Center{disk})
      .by<ode::DormandPrince54>(cartesian, Center{disk});
  return motion;
}

enum class Tried { common, whole_catalog };

/// `euler`: how explicit Euler ends on the two angles and on the center.
inline Quantity under_force(const std::string& name, const std::string& says, const Disk& disk,
                            std::array<Outcome, 2> euler, const Horizon& horizon, const Reference& truth,
                            Tried tried = Tried::common) {
  Quantity motion = quantity(name, "m, m, rad", says, true_motion(disk, horizon, truth), {});
  motion.need = {1e-8 * size_of(motion.reference.value), says_need};
  Ladder ladder(motion, horizon, halving("step", 0.125, 10), tolerances(3, 11));
  ladder.closed_form(constant, ConstantSpeeds{disk}, Outcome::inaccurate, "the force turns the pipe")
      .by_common(one, OneAngle{disk});
  if (tried == Tried::whole_catalog)
    ladder.by_others(one, OneAngle{disk},
                     {{"linearly implicit Euler", Outcome::inaccurate,
                       "its order is too low for this need at this step"}});
  ladder.by_common(two, TwoAngles{disk}, euler[0]).by_common(cartesian, Center{disk}, euler[1]);
  return motion;
}

/// What is seen of a disk on an upright pipe: a mark on its rim, at the angle theta + psi.
template <class Model>
struct RimMark : Model {
  std::array<double, 2> mark(double angle) const {
    return {this->r * std::cos(angle), this->r * std::sin(angle)};
  }
  std::array<double, 2> at(double t) const requires ClosedForm<Model> {
    return mark(this->theta + (this->theta_dot + this->psi_dot) * t);
  }
  template <class State>
  std::array<double, 2> observe(const State& x, double) const {
    return mark(x[0] + x[1]);
  }
};

inline Quantity upright(Disk disk, const Reference& truth) {
  disk.phi = disk.f = disk.k = 0;
  const Horizon horizon{seconds};
  Quantity motion = quantity(
      "upright", "m", "mark on the disk's rim at four times, with the pipe upright",
      trajectory(truth, "03_21_upright", {disk.r, disk.theta, disk.theta_dot, disk.psi_dot}, horizon), {});
  motion.need = {1e-8 * disk.r, "a hundred-millionth of the radius"};
  const std::string why = "0/0: nothing resists the angle of an upright pipe";
  Ladder(motion, horizon, halving("step", 0.125, 4), tolerances(3, 11))
      .closed_form(constant, RimMark<ConstantSpeeds>{{disk}})
      .by<ode::RungeKutta4>(two, RimMark<TwoAngles>{{disk}}, Outcome::non_finite, why)
      .by<ode::DormandPrince54>(two, RimMark<TwoAngles>{{disk}}, Outcome::non_finite, why);
  return motion.add(
      Breakdown{"Upright, the published equations divide zero by zero, even without any force. The constant "
                "speeds need no division; but only the sum of the two angles is then seen.",
                two + ", Runge-Kutta 4", 0.125, Outcome::non_finite, constant + ", closed form", 0});
}

}  // namespace oddity::pipe_and_disk
