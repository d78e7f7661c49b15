#pragma once

#include "chapters/02_basic_concepts/sides.hpp"
#include "chapters/02_basic_concepts/space.hpp"
#include "chapters/random.hpp"
#include "reference/reference.hpp"

/// Exercise 2.5: a rotation about a moving axis, and its angular velocity by several methods.
namespace oddity::rotating_axis {

using namespace space;

/// Rodrigues' matrix of the unit axis D and the angle.
template <class T>
Matrix<T> rodrigues(const Vector<T>& D, const T& angle) {
  using std::cos, std::sin;
  const Matrix<T> S = skew(D);
  return identity<T>() + sin(angle) * S + (T(1.0) - cos(angle)) * (S * S);
}

/// (w, x, y, z).
template <class T>
using Quaternion = std::array<T, 4>;

template <class T>
Quaternion<T> quaternion(const Vector<T>& D, const T& angle) {
  using std::cos, std::sin;
  const T half = T(0.5) * angle, s = sin(half);
  return {cos(half), s * D[0], s * D[1], s * D[2]};
}
/// The matrix of a unit quaternion.
template <class T>
Matrix<T> matrix(const Quaternion<T>& q) {
  const T two(2.0), one(1.0);
  const auto& [w, x, y, z] = q;
  return {one - two * (y * y + z * z), two * (x * y - w * z),       two * (x * z + w * y),
          two * (x * y + w * z),       one - two * (x * x + z * z), two * (y * z - w * x),
          two * (x * z - w * y),       two * (y * z + w * x),       one - two * (x * x + y * y)};
}
/// The vector part of 2 q' q*.
inline Vector3 turning(const Quaternion<Dual<double>>& q) {
  const double w = q[0].value, w_dot = q[0].slope;
  const Vector3 v{q[1].value, q[2].value, q[3].value}, v_dot{q[1].slope, q[2].slope, q[3].slope};
  return 2.0 * (w * v_dot - w_dot * v - cross(v_dot, v));
}

/// Axis and angle as functions of time.
struct Turning {
  Vector3 p, q, r;  ///< D is along p + q sin(t) + r t^2
  double a, b, c;   ///< theta = a + b t + c cos(t)

  template <class T>
  Vector<T> axis(const T& t) const {
    using std::sin;
    const auto along = [&](std::size_t i) { return T(p[i]) + T(q[i]) * sin(t) + T(r[i]) * t * t; };
    return unit(Vector<T>{along(0), along(1), along(2)});
  }
  template <class T>
  T angle(const T& t) const {
    using std::cos;
    return T(a) + T(b) * t + T(c) * cos(t);
  }
};

/// A moment of such a motion, in the letters of the text. `U` is the text's: D, D', D x D'.
struct Moment {
  double t, theta, theta_dot, sigma, gamma, lambda;  ///< lambda = |D'|
  Vector3 D, D_dot, w;
  std::array<Vector3, 3> U;
  Matrix3 S, S_dot, S2_dot, R, R_dot;  ///< R of the quaternion; derivatives by dual numbers
  double size;                         ///< of the terms in R' R^T, on unit vectors
  double frame_size;                   ///< of the same on the vectors U

  /// At t, the clock running `rate` times as fast.
  Moment(const Turning& turning_axis, double at, double rate) : t(at) {
    using D1 = Dual<double>;
    const D1 now(t, rate);
    const Vector<D1> axis = turning_axis.axis(now);
    const D1 angle = turning_axis.angle(now);
    const Quaternion<D1> q = quaternion(axis, angle);
    const Matrix<D1> skew_axis = skew(axis), turned = matrix(q);
    theta = angle.value, theta_dot = angle.slope, sigma = std::sin(theta), gamma = std::cos(theta);
    D = value_of(axis), D_dot = slope_of(axis), lambda = length(D_dot), w = turning(q);
    U = {D, D_dot, cross(D, D_dot)};
    S = value_of(skew_axis), S_dot = slope_of(skew_axis), S2_dot = slope_of(skew_axis * skew_axis);
    R = value_of(turned), R_dot = slope_of(turned);
    size = (1 + std::abs(theta)) * (1 + lambda + std::abs(theta_dot));
    frame_size = (1 + lambda * lambda) * size;
  }
  std::string where() const {
    return "t = " + shortest(t) + ", theta = " + rounded(theta, 4) + ", |D'| = " + rounded(lambda, 4);
  }
};

/// Moments of random motions: with any |D'|, with the clock set for |D'| = 1, and about a fixed axis.
struct Moments {
  std::vector<Moment> any, unit_speed, all;
  explicit Moments(double seed) {
    Random random(seed);
    const auto vector = [](const std::array<double, 3>& x) { return Vector3{x[0], x[1], x[2]}; };
    for (int i = 0; i < 200; ++i) {
      Turning motion{3.0 * vector(random.direction()), vector(random.point(0.8)),
                     vector(random.point(0.8)),        random.between(-7, 7),
                     random.magnitude(0.01, 10),       random.between(-1, 1)};
      const double t = random.between(-1, 1);
      if (i % 20 == 9) motion.a -= motion.angle(t);
      any.emplace_back(motion, t, random.magnitude(0.1, 10));
      unit_speed.emplace_back(motion, t, 1 / Moment(motion, t, 1).lambda);
      motion.q = motion.r = {0, 0, 0};
      if (i % 20 == 19) all.emplace_back(motion, t, 1);
    }
    all.insert(all.begin(), unit_speed.begin(), unit_speed.end());
    all.insert(all.begin(), any.begin(), any.end());
  }
};

// ---- the angular velocity as a quantity -------------------------------------------------------------------

/// D at the angle alpha from z, precessing about z with Omega; theta = nu t.
struct Precession {
  double alpha, Omega, nu;
  template <class T>
  Vector<T> axis(const T& t) const {
    using std::cos, std::sin;
    return {T(sin(alpha)) * cos(T(Omega) * t), T(sin(alpha)) * sin(T(Omega) * t), T(cos(alpha))};
  }
  template <class T>
  T angle(const T& t) const {
    return T(nu) * t;
  }
  template <class T>
  Matrix<T> rotation(const T& t) const {
    return rodrigues(axis(t), angle(t));
  }
};

/// The vector along the axis of a rotation, as long as its angle in [0, pi].
inline Vector3 rotation_vector(const Matrix3& R) {
  const Vector3 s = unskew(R);
  const double sine = length(s), cosine = (R(0, 0) + R(1, 1) + R(2, 2) - 1) / 2;
  return sine == 0 ? s : std::atan2(sine, cosine) / sine * s;
}

inline Quantity angular_velocity(double t, const Precession& motion, const Reference& truth) {
  Quantity w = quantity("angular_velocity", "rad/s", "w in x, y, z at t",
                        truth("02_05_angular_velocity", {t, motion.alpha, motion.Omega, motion.nu}),
                        {1e-10, "ten decimals"});
  using D1 = Dual<double>;
  const Knob steps = halving("h", 0.5, 24);
  const auto at = [=](double s) { return motion.rotation(s); };
  const auto central = [=](double h) { return 0.5 / h * (at(t + h) - at(t - h)); };
  const char* too_small = "rounding grows as eps/h when the step is halved on";
  w.add(
      {"theta' D + sin(theta) D' + (1 - cos(theta)) D x D'", "closed form", no_knob(), [=](double) {
         const Vector<D1> D = motion.axis(D1(t, 1));
         const Vector3 d = value_of(D), d_dot = slope_of(D);
         const double theta = motion.nu * t;
         return Answer{motion.nu * d + std::sin(theta) * d_dot + (1 - std::cos(theta)) * cross(d, d_dot), 1};
       }});
  w.add({"Unskew(R' R^T)", "dual numbers", no_knob(), [=](double) {
           const Matrix<D1> R = motion.rotation(D1(t, 1));
           return Answer{unskew(slope_of(R) * transpose(value_of(R))), 1};
         }});
  w.add({"2 q' q*", "dual numbers", no_knob(), [=](double) {
           return Answer{turning(quaternion(motion.axis(D1(t, 1)), motion.angle(D1(t, 1)))), 1};
         }});
  w.add({"Unskew(R' R^T)", "differences of order 2", steps,
         [=](double h) {
           return Answer{unskew(central(h) * transpose(at(t))), 3};
         },
         Outcome::inaccurate, too_small});
  w.add({"Unskew(R' R^T)", "differences of order 4", steps,
         [=](double h) {
           const Matrix3 R_dot = 1.0 / 3 * (4.0 * central(h) - central(2 * h));
           return Answer{unskew(R_dot * transpose(at(t))), 5};
         },
         Outcome::inaccurate, too_small});
  w.add({"rotation from t - h to t + h", "its vector over 2h", steps,
         [=](double h) {
           return Answer{0.5 / h * rotation_vector(at(t + h) * transpose(at(t - h))), 2};
         },
         Outcome::inaccurate, too_small});
  w.add(Breakdown{
      "Between two orientations half a second before and after, the body has turned by more than half a "
      "turn. The rotation that leads from one to the other is then the shorter way round, backward.",
      "rotation from t - h to t + h, its vector over 2h", 0.5, Outcome::inaccurate, "2 q' q*, dual numbers",
      0});
  w.add(Breakdown{"Steps of $2^{-24}$ leave $\\epsilon/h$, eight digits. Dual numbers have no step.",
                  "Unskew(R' R^T), differences of order 4", 0x1p-24, Outcome::inaccurate,
                  "Unskew(R' R^T), dual numbers", 0});
  return w;
}

}  // namespace oddity::rotating_axis
