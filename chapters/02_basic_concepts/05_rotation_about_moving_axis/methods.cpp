// The quantity of exercise 2.5: the angular velocity by the text's formula, dual numbers and differences.

#include <numbers>

#include "chapters/02_basic_concepts/05_rotation_about_moving_axis/rotating_axis.hpp"
#include "chapters/02_basic_concepts/shared/rotation_matrices.hpp"
#include "reference/reference.hpp"

namespace oddity::rotating_axis {

namespace {

using namespace space;

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

}  // namespace

Quantity angular_velocity(const Parameters& p, const Reference& truth) {
  const double t = p["t"];
  const Precession motion{p["alpha"], p["Omega"], p["nu"]};
  Quantity w = quantity("angular_velocity", "rad/s", R"($\mathbf w$ in $x$, $y$, $z$ at $t$)",
                        truth("02_05_angular_velocity", {t, motion.alpha, motion.Omega, motion.nu}),
                        {1e-10, "ten decimals"});
  using D1 = Dual<double>;
  constexpr double coarse = 0x1p-1;
  const Resolution steps{"h", {coarse, 0x1p-4, 0x1p-7, 0x1p-10, 0x1p-13, 0x1p-16, 0x1p-19, 0x1p-22, 0x1p-25}};
  // w from R near t, counting its evaluations.
  const auto from_rotations = [=](const auto& estimate) {
    return [=](double h) {
      long calls = 0;
      const auto at = [&](double s) { return ++calls, motion.rotation(s); };
      const Vector3 estimated = estimate(at, h);
      return Answer{estimated, calls};
    };
  };
  const auto central = [=](const auto& at, double h) { return 0.5 / h * (at(t + h) - at(t - h)); };
  const char* too_small = "rounding grows as $1/h$ when the step $h$ is halved on";
  w.add(
      {"theta' D + sin(theta) D' + (1 - cos(theta)) D x D'", "closed form", no_resolution(), [=](double) {
         const Vector<D1> D = motion.axis(D1(t, 1));
         const Vector3 d = value_of(D), d_dot = slope_of(D);
         const double theta = motion.nu * t;
         return Answer{motion.nu * d + std::sin(theta) * d_dot + (1 - std::cos(theta)) * cross(d, d_dot), 1};
       }});
  w.add({"Unskew(R' R^T)", "dual numbers", no_resolution(), [=](double) {
           const Matrix<D1> R = motion.rotation(D1(t, 1));
           return Answer{unskew(slope_of(R) * transpose(value_of(R))), 1};
         }});
  w.add({"2 q' q*", "dual numbers", no_resolution(), [=](double) {
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
  const Value& rate = w.reference.value;
  if (const double turned = 2 * coarse * std::hypot(rate[0], rate[1], rate[2]); turned > std::numbers::pi)
    w.add(
        Breakdown{"From @1 s before to @1 s after, the body turns by about @2 rad, more than half a turn. "
                  "The rotation that leads from one orientation to the other is then the shorter way round.",
                  "rotation from t - h to t + h, its vector over 2h",
                  coarse,
                  Outcome::inaccurate,
                  "2 q' q*, dual numbers",
                  0,
                  {coarse, coarse, turned}});
  w.add(Breakdown{R"(A step of $2^{@2}$ leaves $\epsilon/h$, @2 digits. Dual numbers have no step.)",
                  "Unskew(R' R^T), differences of order 4",
                  0x1p-25,
                  Outcome::inaccurate,
                  "Unskew(R' R^T), dual numbers",
                  0,
                  {power_of_two_of(Side::broken), digits_of(Side::broken)}});
  return w;
}

}  // namespace oddity::rotating_axis
