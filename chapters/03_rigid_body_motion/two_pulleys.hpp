#pragma once

// The models and quantities of exercise 3.19.

#include <Eigen/Core>
#include <array>
#include <cmath>

#include "chapters/03_rigid_body_motion/two_coordinates.hpp"
#include "chapters/scene.hpp"
#include "solvers/linear.hpp"

namespace oddity::two_pulleys {

struct Pulleys {
  double m2, m3, I1, I2, R1, R2, c1, c2, L1, L2, K1, K2, g, y2, y3, v2, v3;

  double turn1() const { return I1 / (R1 * R1); }
  double turn2() const { return I2 / (R2 * R2); }
  template <class T>
  T stretch1(const Two<T>& y) const {
    return y[0] + (K1 - L1);
  }
  template <class T>
  T stretch2(const Two<T>& y) const {
    return y[1] - 2.0 * y[0] + (K2 - L2);
  }
};

struct KineticEnergy : Pulleys {
  template <class T>
  T operator()(const Two<T>&, const Two<T>& v) const {
    const T turn1 = v[0] / R1, turn2 = (v[1] - v[0]) / R2;
    return 0.5 * (m2 * v[0] * v[0] + I1 * turn1 * turn1 + m3 * v[1] * v[1] + I2 * turn2 * turn2);
  }
};

struct PotentialEnergy : Pulleys {
  template <class T>
  T operator()(const Two<T>& y, const Two<T>&) const {
    const T s1 = stretch1(y), s2 = stretch2(y);
    return 0.5 * (c1 * s1 * s1 + c2 * s2 * s2) - g * (m2 * y[0] + m3 * y[1]);
  }
};

struct Lagrangian : Pulleys {
  template <class T>
  T operator()(const Two<T>& y, const Two<T>& v) const {
    return KineticEnergy{*this}(y, v) - PotentialEnergy{*this}(y, v);
  }
};

inline OneConserved energy(const Pulleys& p, const Pair& y, const Pair& v) {
  return energy_of(KineticEnergy{p}(y, v), PotentialEnergy{p}(y, v));
}

// ---- the models -------------------------------------------------------------------------------------------

/// M a = force in the two depths.
inline Pair solve_for_accelerations(const Pulleys& p, const Pair& force) {
  const double t = p.turn2(), small = p.m2 + p.turn1() + t, large = p.m3 + t, det = small * large - t * t;
  return {(large * force[0] + t * force[1]) / det, (t * force[0] + small * force[1]) / det};
}

/// The depths alone; `lever` is what the second spring's pull counts on the small pulley: twice, and not at
/// all in the published equations.
struct TwoCoordinates : Pulleys {
  double lever = 2;
  using State = std::array<double, 4>;
  State start() const { return {y2, y3, v2, v3}; }
  void acceleration(const Pair& y, Pair& a) const {
    const double pull1 = c1 * stretch1(y), pull2 = c2 * stretch2(y);
    a = solve_for_accelerations(*this, {m2 * g - pull1 + lever * pull2, m3 * g - pull2});
  }
  void operator()(const State& x, State& dxdt, double) const {
    Pair a;
    acceleration({x[0], x[1]}, a);
    dxdt = {x[2], x[3], a[0], a[1]};
  }
  Pair observe(const State& x, double) const { return {x[0], x[1]}; }
  OneConserved conserved(const State& x, double) const { return energy(*this, {x[0], x[1]}, {x[2], x[3]}); }
};

/// Depths and pulley angles, free of one another; the ropes' tensions on the far sides of the pulleys keep
/// them from slipping. The springs are known by the rope that has run over their pulley.
struct FourCoordinates : Pulleys {
  using State = std::array<double, 8>;
  State start() const { return {y2, y3, y2 / R1, (y3 - y2) / R2, v2, v3, v2 / R1, (v3 - v2) / R2}; }
  void acceleration(const std::array<double, 4>& x, std::array<double, 4>& a) const {
    const double pull1 = c1 * (R1 * x[2] + K1 - L1), pull2 = c2 * (R2 * x[3] - x[0] + K2 - L2);
    const double b1 = R1 * R1 / I1, b2 = R2 * R2 / I2;
    const double a11 = b1 + 1 / m2, a12 = -1 / m2, a22 = b2 + 1 / m3 + 1 / m2;
    const double f1 = b1 * pull1 + g + pull2 / m2, f2 = (b2 - 1 / m2) * pull2, det = a11 * a22 - a12 * a12;
    const double t1 = (a22 * f1 - a12 * f2) / det, t2 = (a11 * f2 - a12 * f1) / det;
    a = {g + (pull2 + t2 - t1) / m2, g - t2 / m3, R1 * (t1 - pull1) / I1, R2 * (t2 - pull2) / I2};
  }
  void operator()(const State& x, State& dxdt, double) const {
    std::array<double, 4> a;
    acceleration({x[0], x[1], x[2], x[3]}, a);
    dxdt = {x[4], x[5], x[6], x[7], a[0], a[1], a[2], a[3]};
  }
  Pair observe(const State& x, double) const { return {x[0], x[1]}; }
  OneConserved conserved(const State& x, double) const { return energy(*this, {x[0], x[1]}, {x[4], x[5]}); }
};

inline Eigen::Matrix2d mass_matrix(const Pulleys& p) {
  Eigen::Matrix2d m;
  m << p.m2 + p.turn1() + p.turn2(), -p.turn2(), -p.turn2(), p.m3 + p.turn2();
  return m;
}
inline Eigen::Matrix2d stiffness(const Pulleys& p) {
  Eigen::Matrix2d k;
  k << p.c1 + 4 * p.c2, -2 * p.c2, -2 * p.c2, p.c2;
  return k;
}

/// The depths at rest: c2 (S2 - L2) = m3 g, c1 (S1 - L1) = (m2 + 2 m3) g.
inline Pair at_rest(const Pulleys& p) {
  const double down = p.L1 - p.K1 + (p.m2 + 2 * p.m3) * p.g / p.c1;
  return {down, p.L2 - p.K2 + p.m3 * p.g / p.c2 + 2 * down};
}

/// Oscillations about the equilibrium in the directions that diagonalize M and K.
class NormalModes {
 public:
  explicit NormalModes(const Pulleys& p) : rest_(at_rest(p)[0], at_rest(p)[1]) {
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

inline Pulleys without_inertia(Pulleys p) {
  p.I1 = p.I2 = 0;
  return p;
}

// ---- the quantities ---------------------------------------------------------------------------------------

inline Quantity depths(const Pulleys& p, const Horizon& horizon, const Reference& truth) {
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
      .by_common("two coordinates", TwoCoordinates{p}, Outcome::drifted, Outcome::inaccurate)
      .by_others(
          "two coordinates", TwoCoordinates{p},
          {{"modified midpoint", Outcome::inaccurate, "its order is too low for this need at this step"},
           {"linearly implicit Euler", Outcome::drifted, "of order 1, and it damps every swing"}})
      .by_few("four coordinates with tensions", FourCoordinates{p}, Outcome::drifted, Outcome::inaccurate)
      .by<ode::RungeKutta4>(published, TwoCoordinates{p, 0}, Outcome::diverged, why)
      .by<ode::Fehlberg78>(published, TwoCoordinates{p, 0}, Outcome::diverged, why);
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
inline Pair by_quadratic(const Pulleys& p, bool vieta) {
  const Eigen::Matrix2d m = mass_matrix(p), k = stiffness(p);
  const double a = m(0, 0) * m(1, 1) - m(0, 1) * m(1, 0),
               b = m(0, 0) * k(1, 1) + m(1, 1) * k(0, 0) - 2 * m(0, 1) * k(0, 1), c = p.c1 * p.c2,
               root = std::sqrt(b * b - 4 * a * c), larger = (b + root) / (2 * a);
  return {std::sqrt(vieta ? c / (a * larger) : (b - root) / (2 * a)), std::sqrt(larger)};
}

/// Ratios to the true frequencies; `graded`: the springs are so unlike that the frequencies are, too.
inline Quantity frequencies(const std::string& name, const std::string& says, const Pulleys& p, bool graded,
                            const Reference& truth) {
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
