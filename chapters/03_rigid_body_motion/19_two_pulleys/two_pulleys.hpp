#pragma once

// The normal modes and the quantities of exercise 3.19.

#include <Eigen/Core>
#include <cmath>

#include "chapters/03_rigid_body_motion/19_two_pulleys/models.hpp"
#include "chapters/03_rigid_body_motion/shared/two_coordinates.hpp"
#include "chapters/scene.hpp"
#include "solvers/linear.hpp"

namespace oddity::two_pulleys {

struct KineticEnergy {
  Given<double> p;
  template <class T>
  T operator()(const Two<T>&, const Two<T>& v) const {
    return p.kinetic_energy(v);
  }
};

struct PotentialEnergy {
  Given<double> p;
  template <class T>
  T operator()(const Two<T>& y, const Two<T>&) const {
    return p.potential_energy(y);
  }
};

struct Lagrangian {
  Given<double> p;
  template <class T>
  T operator()(const Two<T>& y, const Two<T>& v) const {
    return p.kinetic_energy(v) - p.potential_energy(y);
  }
};

// ---- the normal modes -------------------------------------------------------------------------------------

inline Eigen::Matrix2d mass_matrix(const Given<double>& p) {
  Eigen::Matrix2d m;
  m << p.m2 + p.turn1() + p.turn2(), -p.turn2(), -p.turn2(), p.m3 + p.turn2();
  return m;
}
inline Eigen::Matrix2d stiffness(const Given<double>& p) {
  Eigen::Matrix2d k;
  k << p.c1 + 4 * p.c2, -2 * p.c2, -2 * p.c2, p.c2;
  return k;
}

/// The depths at rest: c2 (S2 - L2) = m3 g, c1 (S1 - L1) = (m2 + 2 m3) g.
inline Pair at_rest(const Given<double>& p) {
  const double down = p.L1 - p.K1 + (p.m2 + 2 * p.m3) * p.g / p.c1;
  return {down, p.L2 - p.K2 + p.m3 * p.g / p.c2 + 2 * down};
}

/// Oscillations about the equilibrium in the directions that diagonalize M and K.
class NormalModes {
 public:
  explicit NormalModes(const Given<double>& p) : rest_(at_rest(p)[0], at_rest(p)[1]) {
    const Modes both = modes(stiffness(p), mass_matrix(p));
    w_ = both.squares.cwiseSqrt();
    shapes_ = both.shapes;
    const Eigen::Matrix2d to_modes = shapes_.transpose() * mass_matrix(p);
    position_ = to_modes * (Eigen::Vector2d(p.y2, p.y3) - rest_);
    velocity_ = to_modes * Eigen::Vector2d(p.v2, p.v3);
  }
  Pair frequencies() const { return {w_[0], w_[1]}; }
  Pair at(double t) const {
    Eigen::Vector2d y = rest_;
    for (int k = 0; k < 2; ++k)
      y += (position_[k] * std::cos(w_[k] * t) + velocity_[k] / w_[k] * std::sin(w_[k] * t)) * shapes_.col(k);
    return {y[0], y[1]};
  }

 private:
  Eigen::Vector2d w_, rest_, position_, velocity_;
  Eigen::Matrix2d shapes_;
};

inline Given<double> without_inertia(Given<double> p) {
  p.I1 = p.I2 = 0;
  return p;
}

// ---- the quantities ---------------------------------------------------------------------------------------

inline Quantity depths(const Given<double>& p, const Horizon& horizon, const Reference& truth) {
  const std::vector<double> inputs{p.m2, p.m3, p.I1, p.I2, p.R1, p.R2, p.c1, p.c2, p.L1,
                                   p.L2, p.K1, p.K2, p.g,  p.y2, p.y3, p.v2, p.v3};
  Quantity y =
      quantity("depths", "m", "depth of the small pulley and of the mass at " + times_up_to(horizon),
               trajectory(truth, "03_19_pulleys", inputs, horizon), {1e-8, "a hundredth of a micrometre"});
  const std::string published = "published equations", why = "the second spring does not pull the pulley";
  Ladder(y, horizon, halving("step", 0.125, 11), tolerances(3, 11))
      .closed_form("normal modes", NormalModes(p))
      .closed_form("normal modes, pulleys without inertia", NormalModes(without_inertia(p)),
                   Outcome::inaccurate, "the pulleys' inertia slows the oscillation")
      .by_common("two coordinates", TwoCoordinates<double>{p}, Outcome::drifted, Outcome::inaccurate)
      .by_others(
          "two coordinates", TwoCoordinates<double>{p},
          {{"modified midpoint", Outcome::inaccurate, "its order is too low for this need at this step"},
           {"linearly implicit Euler", Outcome::drifted, "of order 1, and it damps every swing"}})
      .by_few("four coordinates with tensions", FourCoordinates<double>{p}, Outcome::drifted,
              Outcome::inaccurate)
      .by<ode::RungeKutta4>(published, TwoCoordinates<double>{p, 0}, Outcome::diverged, why)
      .by<ode::Fehlberg78>(published, TwoCoordinates<double>{p, 0}, Outcome::diverged, why);
  y.add(Breakdown{
      "The published equations do not conserve energy however small the tolerance: their two frequencies are "
      "complex, 3.05 +- 1.06 i per second, and the swing grows more than a thousandfold within eight "
      "seconds. "
      "With the second spring's pull on the pulley, 2 c2 (S2 - L2), both are real.",
      published + ", Fehlberg 7(8)", 1e-11, Outcome::diverged, "two coordinates, Fehlberg 7(8)", 1e-11});
  y.add(Breakdown{"Explicit Euler gains energy at every step, the most in the faster mode.",
                  "two coordinates, explicit Euler", 0.125, Outcome::diverged,
                  "two coordinates, Runge-Kutta 4", 0.001953125});
  return y;
}

/// The roots of a s^2 - b s + c by the formula of the textbooks, the smaller from the difference or, by
/// Vieta, from the product; c = c1 c2 without subtraction.
inline Pair by_quadratic(const Given<double>& p, bool vieta) {
  const Eigen::Matrix2d m = mass_matrix(p), k = stiffness(p);
  const double a = m(0, 0) * m(1, 1) - m(0, 1) * m(1, 0),
               b = m(0, 0) * k(1, 1) + m(1, 1) * k(0, 0) - 2 * m(0, 1) * k(0, 1), c = p.c1 * p.c2,
               root = std::sqrt(b * b - 4 * a * c), larger = (b + root) / (2 * a);
  return {std::sqrt(vieta ? c / (a * larger) : (b - root) / (2 * a)), std::sqrt(larger)};
}

/// Ratios to the true frequencies; `graded`: the springs are so unlike that the frequencies are, too.
inline Quantity frequencies(const std::string& name, const std::string& says, const Given<double>& p,
                            bool graded, const Reference& truth) {
  const Known w = truth("03_19_frequencies", {p.m2, p.m3, p.I1, p.I2, p.R1, p.R2, p.c1, p.c2});
  Quantity q{name, "1", says, {"one, " + w.source, {1, 1}}, 1e-16, {1e-12, "twelve digits of each"}};
  const auto ratios = [w](const Pair& by) {
    return Answer{Value{by[0] / w.value[0], by[1] / w.value[1]}, 1};
  };
  const Outcome small = graded ? Outcome::inaccurate : Outcome::ok;
  const std::string why = graded ? "it errs by roundings of the larger eigenvalue" : "";
  q.add({"generalized eigenproblem", "GSL, self-adjoint", no_knob(),
         [=](double) { return ratios(NormalModes(p).frequencies()); }, small, why});
  q.add({"det(K - s M) = 0", "quadratic formula", no_knob(),
         [=](double) { return ratios(by_quadratic(p, false)); }, small, why});
  q.add({"det(K - s M) = 0", "larger root and product", no_knob(),
         [=](double) { return ratios(by_quadratic(p, true)); }});
  return q;
}

}  // namespace oddity::two_pulleys
