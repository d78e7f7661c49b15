#pragma once

// The models and quantities of exercise 3.13.

#include <boost/math/special_functions/jacobi_elliptic.hpp>
#include <cmath>
#include <numbers>
#include <string>

#include "chapters/03_rigid_body_motion/height_field.hpp"
#include "chapters/scene.hpp"

namespace oddity::tilted_chute {

using Point = std::array<double, 3>;

/// Radius R; the axis falls by H over its length L. e = (c, 0, -s) down the axis, n = (s, 0, c) normal to it.
struct Chute {
  double R, L, H;

  double c() const { return std::sqrt((L - H) * (L + H)) / L; }
  double s() const { return H / L; }

  /// Where the distance `along` down the axis and the angle phi about it lead, from the origin.
  template <class T>
  std::array<T, 3> position(const T& along, const T& phi) const {
    using std::cos, std::sin;
    const T up = T(R) * (T(1.0) - cos(phi));
    return {along * T(c()) + up * T(s()), T(R) * sin(phi), up * T(c()) - along * T(s())};
  }

  // The same as a height field.
  template <class T>
  T height(const T& x1, const T& x2) const {
    using std::sqrt;
    return (T(R) - T(s()) * x1 - sqrt(T(R * R) - x2 * x2)) / T(c());
  }
  double depth(double x2) const { return std::sqrt((R - x2) * (R + x2)); }
  Pair gradient(const Pair& x) const { return {-s() / c(), x[1] / (depth(x[1]) * c())}; }
  Pair turn(const Pair& x, const Pair& v) const {
    const double d = depth(x[1]);
    return {0, R * R * v[1] / (d * d * d * c())};
  }
  double bend(const Pair& x, const Pair& v) const { return v[1] * turn(x, v)[1]; }
};

/// The Lagrangian of a unit mass in the distance along the axis and the angle about it, of the position
/// alone.
struct AlongAndAbout {
  Chute chute;
  double g;

  template <class T>
  T operator()(const Two<T>& q, const Two<T>& v) const {
    const auto x = chute.position(Dual<T>(q[0], v[0]), Dual<T>(q[1], v[1]));
    return T(0.5) * (x[0].slope * x[0].slope + x[1].slope * x[1].slope + x[2].slope * x[2].slope) -
           T(g) * x[2].value;
  }
};

/// Let go at the angle phi from the lowest line, with the speed u down the axis.
struct Case {
  Chute chute;
  double g, phi, u;

  double along(double t) const { return u * t + g * chute.s() * t * t / 2; }
  double square() const { return g * chute.c() / chute.R; }
};

/// The book's: x2 = 0.
struct CenterLine : Case {
  Point at(double t) const {
    const double theta = std::asin(chute.H / chute.L);
    const double x1 = chute.position(0.0, phi)[0] + u * chute.c() * t + g * std::sin(2 * theta) / 4 * t * t;
    return {x1, 0, chute.height(x1, 0.0)};
  }
};

struct SmallAngle : Case {
  Point at(double t) const { return chute.position(along(t), phi * std::cos(std::sqrt(square()) * t)); }
};

/// phi(t) = 2 asin(k cd(w t, k)), k = sin(phi/2).
struct Jacobi : Case {
  Point at(double t) const {
    const double k = std::sin(phi / 2);
    const double angle = k == 0 ? 0 : 2 * std::asin(k * boost::math::jacobi_cd(k, std::sqrt(square()) * t));
    return chute.position(along(t), angle);
  }
};

/// (phi, phi'); the way along the axis in closed form.
struct Angle : Case {
  using State = std::array<double, 2>;
  State start() const { return {phi, 0}; }
  void operator()(const State& x, State& dxdt, double) const { dxdt = {x[1], -square() * std::sin(x[0])}; }
  void acceleration(const std::array<double, 1>& q, std::array<double, 1>& dv) const {
    dv = {-square() * std::sin(q[0])};
  }
  Point observe(const State& x, double t) const { return chute.position(along(t), x[0]); }
  OneConserved conserved(const State& x, double) const {
    return energy_of(x[1] * x[1] / 2, square() * (1 - std::cos(x[0])));
  }
};

/// (x1, x2, x3, x1', x2', x3') with the chute's force along the way to its axis.
struct InSpace : Case {
  using State = std::array<double, 6>;
  State start() const {
    const Point x = chute.position(0.0, phi);
    return {x[0], x[1], x[2], u * chute.c(), 0, -u * chute.s()};
  }
  void operator()(const State& x, State& dxdt, double) const {
    const double c = chute.c(), s = chute.s(), z = x[2] - chute.R / c;
    const double way = c * x[0] - s * z, speed = c * x[3] - s * x[5];
    const double n1 = x[0] - way * c, n2 = x[1], n3 = z + way * s;
    const double w1 = x[3] - speed * c, w2 = x[4], w3 = x[5] + speed * s;
    const double m = (g * n3 - w1 * w1 - w2 * w2 - w3 * w3) / (n1 * n1 + n2 * n2 + n3 * n3);
    dxdt = {x[3], x[4], x[5], m * n1, m * n2, m * n3 - g};
  }
  Point observe(const State& x, double) const { return {x[0], x[1], x[2]}; }
  OneConserved conserved(const State& x, double) const {
    return energy_of((x[3] * x[3] + x[4] * x[4] + x[5] * x[5]) / 2, g * x[2]);
  }
};

using InPlane = height_field::InPlane<Chute>;

inline InPlane in_plane(const Case& c) {
  const Point x = c.chute.position(0.0, c.phi);
  return {c.chute, c.g, {x[0], x[1], c.u * c.chute.c(), 0}};
}

inline const std::string center = "center line", small = "small angle", exact_angle = "elliptic angle",
                         about = "angle about the axis", plane = "height field",
                         space = "Cartesian with constraint";

inline Quantity slide(const std::string& name, const std::string& says, const Case& c, const Horizon& horizon,
                      const Reference& truth) {
  const Chute& chute = c.chute;
  Quantity position =
      quantity(name, "m", says,
               trajectory(truth, "03_13_chute", {chute.R, chute.L, chute.H, c.g, c.phi, c.u}, horizon), {});
  position.need = {1e-8 * size_of(position.reference.value), "eight digits of the farthest coordinate"};
  return position;
}

/// The ladder up to the angle; the height field and space are the caller's.
inline Ladder swinging(Quantity& position, const Case& c, const Horizon& horizon) {
  Ladder ladder(position, horizon, halving("step", 0.125, 10), tolerances(3, 11));
  ladder.closed_form(center, CenterLine{c}, Outcome::inaccurate, "the ball is beside the center line")
      .closed_form(small, SmallAngle{c}, Outcome::inaccurate, "the period grows with the amplitude")
      .closed_form(exact_angle, Jacobi{c})
      .by_common(about, Angle{c})
      .by_common(space, InSpace{c});
  return ladder;
}

inline const std::string low_order = "its order is too low for this need at this step";

inline Quantity swing(const Case& c, const Horizon& horizon, const Reference& truth) {
  Quantity position =
      slide("swing", "position at " + times_up_to(horizon) + " of a ball let go beside the center line", c,
            horizon, truth);
  swinging(position, c, horizon)
      .by_common(plane, in_plane(c))
      .by_others(about, Angle{c},
                 {{"linearly implicit Euler", Outcome::inaccurate, "of order 1, and it damps every swing"}});
  return position;
}

inline Quantity below_rim(const Case& c, const Horizon& horizon, const Reference& truth) {
  Quantity position = slide("steep", "the same from phi = 1.5, just below the rim", c, horizon, truth);
  swinging(position, c, horizon)
      .by<ode::ExplicitEuler>(plane, in_plane(c), Outcome::inaccurate, low_order)
      .by<ode::RungeKutta4>(plane, in_plane(c))
      .by<ode::CashKarp54>(plane, in_plane(c))
      .by<ode::DormandPrince54>(plane, in_plane(c))
      .by<ode::Fehlberg78>(plane, in_plane(c))
      .by<ode::BulirschStoer>(plane, in_plane(c), Outcome::non_finite,
                              "its long trial steps leave the chute, |x2| > R");
  return position.add(Breakdown{
      "Near the rim the coarse first substeps of a long trial step leave the chute, where the height has no "
      "value, and the step is taken as if all were well. In the angle there is nothing to leave.",
      plane + ", Bulirsch-Stoer", 1e-11, Outcome::non_finite, about + ", Bulirsch-Stoer", 1e-11});
}

inline Quantity on_center(const Case& c, const Horizon& horizon, const Reference& truth) {
  Quantity position = slide("center", "the same from the center line", c, horizon, truth);
  Ladder(position, horizon, halving("step", 0.125, 10), tolerances(3, 11))
      .closed_form(center, CenterLine{c})
      .closed_form(small, SmallAngle{c})
      .closed_form(exact_angle, Jacobi{c})
      .by<ode::ExplicitEuler>(plane, in_plane(c), Outcome::inaccurate, low_order)
      .by<ode::RungeKutta4>(plane, in_plane(c))
      .by<ode::DormandPrince54>(plane, in_plane(c))
      .by<ode::RungeKutta4>(space, InSpace{c})
      .by<ode::DormandPrince54>(space, InSpace{c});
  return position;
}

inline Quantity from_rim(const Case& c, const Horizon& horizon, const Reference& truth) {
  const std::string why = "at |x2| = R the height's slope is infinite";
  Quantity position = slide("rim", "the same from the rim, x2 = R", c, horizon, truth);
  Ladder(position, horizon, halving("step", 0.125, 10), tolerances(3, 11))
      .closed_form(small, SmallAngle{c}, Outcome::inaccurate, "the period grows with the amplitude")
      .closed_form(exact_angle, Jacobi{c})
      .by<ode::RungeKutta4>(about, Angle{c})
      .by<ode::DormandPrince54>(about, Angle{c})
      .by<ode::RungeKutta4>(plane, in_plane(c), Outcome::non_finite, why)
      .by<ode::DormandPrince54>(plane, in_plane(c), Outcome::non_finite, why)
      .by<ode::RungeKutta4>(space, InSpace{c})
      .by<ode::DormandPrince54>(space, InSpace{c});
  return position.add(Breakdown{
      "On the rim the height field has no slope: the ball let go there never gets a state that is "
      "a number. The angle about the axis knows no rim.",
      plane + ", Runge-Kutta 4", 0.0009765625, Outcome::non_finite, about + ", Runge-Kutta 4", 0.0009765625});
}

}  // namespace oddity::tilted_chute
