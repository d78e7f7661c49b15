#pragma once

#include "chapters/02_basic_concepts/shared/rotation_matrices.hpp"
#include "chapters/02_basic_concepts/shared/sides.hpp"
#include "chapters/random.hpp"
#include "reference/reference.hpp"

/// Exercise 2.5: a rotation about a moving axis, and its angular velocity by several methods.
namespace oddity::rotating_axis {

using namespace identities;
using namespace space;

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
  Solved<Value> S_slope;               ///< S' by differences, extrapolated
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
    const double step = 0.25 / (1 + std::abs(rate));
    S_slope = limit_at_zero(
        [&](double h) {
          const auto then = [&](double s) { return skew(turning_axis.axis(t + rate * s)); };
          return Value(0.5 / h * (then(h) - then(-h)));
        },
        step, 8);
    S_slope.error_estimate += 0x1p-48 * std::ldexp(1 / step, 8);
  }
  std::string where() const {
    return "t = " + shortest(t) + ", theta = " + rounded(theta, 4) + ", |D'| = " + rounded(lambda, 4);
  }
};

using M = const Moment&;

inline Matrix3 R_dot_R_transposed(M m) { return m.R_dot * transpose(m.R); }

/// R^T x, R' x and R' R^T x at a moment.
inline Vector3 back(M m, const Vector3& x) { return transpose(m.R) * x; }
inline Vector3 rate(M m, const Vector3& x) { return m.R_dot * x; }
inline Vector3 turned(M m, const Vector3& x) { return rate(m, back(m, x)); }

/// R' R^T U by the text, columns.
inline Matrix3 columns_of_the_text(M m, double k) {
  const auto& [U1, U2, U3] = m.U;
  const double g = 1 - m.gamma, s = m.sigma, w = m.theta_dot;
  return Matrix3::columns(g * U2 - s * U3, -g * U1 + k * w * U3, s * U1 - w * U2);
}

/// b a^T - a b^T with its entries as the text collects them.
inline Matrix3 collected(const Vector3& a, const Vector3& b, double k) {
  const double x = a[1] * b[2] - a[2] * b[1], y = a[2] * b[0] - a[0] * b[2], z = a[0] * b[1] - a[1] * b[0];
  return {0, -z, k * y, z, 0, -x, -k * y, x, 0};
}

/// Moments of random motions: with any |D'|, with the clock set for |D'| = 1, both of these, and all with
/// those about a fixed axis.
struct Moments {
  std::vector<Moment> any, unit_speed, moving, all;
  explicit Moments(double seed) {
    Random random(seed);
    const auto vector = [](const std::array<double, 3>& x) { return Vector3{x[0], x[1], x[2]}; };
    for (int i = 0; i < 200; ++i) {
      Turning motion{3.0 * vector(random.direction()), vector(random.point(0.8)),
                     vector(random.point(0.8)),        random.between(-7, 7),
                     random.magnitude(0.01, 10),       random.between(-1, 1)};
      const double t = random.between(-1, 1);
      if (i % 20 == 9) motion.a += 0.01 - motion.angle(t);
      any.emplace_back(motion, t, random.magnitude(0.1, 10));
      unit_speed.emplace_back(motion, t, 1 / Moment(motion, t, 1).lambda);
      motion.q = motion.r = {0, 0, 0};
      if (i % 20 == 19) all.emplace_back(motion, t, 1);
    }
    moving = any;
    moving.insert(moving.end(), unit_speed.begin(), unit_speed.end());
    all.insert(all.begin(), moving.begin(), moving.end());
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

inline Quantity angular_velocity(double t, const Precession& motion, const Reference& truth) {
  Quantity w = quantity("angular_velocity", "rad/s", "w in x, y, z at t",
                        truth("02_05_angular_velocity", {t, motion.alpha, motion.Omega, motion.nu}),
                        {1e-10, "ten decimals"});
  using D1 = Dual<double>;
  const Knob steps{"h", {0x1p-1, 0x1p-4, 0x1p-7, 0x1p-10, 0x1p-13, 0x1p-16, 0x1p-19, 0x1p-22, 0x1p-25}};
  // w from R near t, whose calls are counted.
  const auto from_rotations = [=](const auto& estimate) {
    return [=](double h) {
      long calls = 0;
      const auto at = [&](double s) { return ++calls, motion.rotation(s); };
      const Vector3 estimated = estimate(at, h);
      return Answer{estimated, calls};
    };
  };
  const auto central = [=](const auto& at, double h) { return 0.5 / h * (at(t + h) - at(t - h)); };
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
         from_rotations([=](const auto& at, double h) { return unskew(central(at, h) * transpose(at(t))); }),
         Outcome::inaccurate, too_small});
  w.add({"Unskew(R' R^T)", "differences of order 4", steps, from_rotations([=](const auto& at, double h) {
           const Matrix3 R_dot = 1.0 / 3 * (4.0 * central(at, h) - central(at, 2 * h));
           return unskew(R_dot * transpose(at(t)));
         }),
         Outcome::inaccurate, too_small});
  w.add({"rotation from t - h to t + h", "its vector over 2h", steps,
         from_rotations([=](const auto& at, double h) {
           return 0.5 / h * rotation_vector(at(t + h) * transpose(at(t - h)));
         }),
         Outcome::inaccurate, too_small});
  w.add(Breakdown{
      "Between two orientations half a second before and after, the body has turned by more than half a "
      "turn. The rotation that leads from one to the other is then the shorter way round, backward.",
      "rotation from t - h to t + h, its vector over 2h", 0.5, Outcome::inaccurate, "2 q' q*, dual numbers",
      0});
  w.add(Breakdown{"A step of $2^{-25}$ leaves $\\epsilon/h$, eight digits. Dual numbers have no step.",
                  "Unskew(R' R^T), differences of order 4", 0x1p-25, Outcome::inaccurate,
                  "Unskew(R' R^T), dual numbers", 0});
  return w;
}

}  // namespace oddity::rotating_axis
