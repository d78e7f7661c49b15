#pragma once

#include <cmath>

#include "reference/make/extrapolation.hpp"
#include "reference/make/taylor.hpp"

/// The Foucault pendulum of exercise 3.17 by two routes. Inputs: latitude lambda, L, omega, g, the angles
/// theta and phi, their rates, and the time. Axes: x west, y north, z down, turning with the Earth. z is the
/// direction of the weight at the pivot, so g includes the effect of the Earth's rotation there.
namespace oddity::truth::foucault {

inline const std::vector<std::string> inputs{"lambda", "L",         "omega",   "g", "theta",
                                             "phi",    "theta_dot", "phi_dot", "t"};

/// x, y, z, x', y', z' in the turning axes: the position and its derivative.
inline Numbers start(const std::vector<double>& in) {
  const Number L = in[1], theta = in[4], phi = in[5];
  const Number c = cos(theta), s = sin(theta), cp = cos(phi), sp = sin(phi);
  const Number around = L * Number(in[6]) * sp, outward = L * Number(in[7]);
  return {L * c * sp,   L * s * sp, L * cp, -around * s + outward * c * cp, around * c + outward * s * cp,
          -outward * sp};
}

/// Turning axes: Coriolis and centrifugal force, and the rod's tension from |r| = L, differentiated twice.
/// Divides by r.r, not by L^2: an error of |r| then grows linearly, and not exponentially while the rod
/// pushes.
inline Numbers by_taylor(const std::vector<double>& in, Precision digits) {
  const Number wy = in[2] * cos(Number(in[0])), wz = -in[2] * sin(Number(in[0])), g = in[3];
  const Number two = 2, square = wy * wy + wz * wz;
  const auto rhs = [&](const auto& s, const auto&) {
    const auto along = wy * s[1] + wz * s[2];
    const auto ax = -two * (wy * s[5] - wz * s[4]) + square * s[0];
    const auto ay = -two * (wz * s[3]) + square * s[1] - wy * along;
    const auto az = two * wy * s[3] + square * s[2] - wz * along + g;
    const auto tension = (s[0] * ax + s[1] * ay + s[2] * az + s[3] * s[3] + s[4] * s[4] + s[5] * s[5]) /
                         (s[0] * s[0] + s[1] * s[1] + s[2] * s[2]);
    return std::vector{s[3], s[4], s[5], ax - tension * s[0], ay - tension * s[1], az - tension * s[2]};
  };
  return solve_taylor(rhs, start(in), 0, Number(in[8]), digits + 4);
}

/// The start from the angular velocity: theta' about z, phi' about the horizontal axis turned by theta.
inline Numbers start_by_rotation(const std::vector<double>& in) {
  const Number L = in[1], theta = in[4], phi = in[5], turn = in[6], tilt = in[7];
  const Number x = L * sin(phi) * cos(theta), y = L * sin(phi) * sin(theta), z = L * cos(phi);
  const Number wx = -tilt * sin(theta), wy = tilt * cos(theta);
  return {x, y, z, wy * z - turn * y, turn * x - wx * z, wx * y - wy * x};
}

/// Inertial axes: gravity turns, and the rod pulls; there is no other force. The result is converted to the
/// turning axes.
inline Numbers by_extrapolation(const std::vector<double>& in, Precision digits) {
  const Number w = in[2], c = cos(Number(in[0])), s = sin(Number(in[0])), g = in[3], t = in[8];
  const auto turned = [&](const Number& x, const Number& y, const Number& z, const Number& angle) {
    const Number co = cos(angle), si = sin(angle), along = (y * c - z * s) * (1 - co);
    return Numbers{x * co + (c * z + s * y) * si, y * co - s * x * si + c * along,
                   z * co - c * x * si - s * along};
  };
  Numbers x = start_by_rotation(in);
  x[3] += w * (c * x[2] + s * x[1]);
  x[4] -= w * s * x[0];
  x[5] -= w * c * x[0];
  const auto rhs = [&](const Numbers& q, const Number& time) {
    const Numbers down = turned(0, 0, g, w * time);
    Number pull = 0, square = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      pull += q[i] * down[i] + q[i + 3] * q[i + 3];
      square += q[i] * q[i];
    }
    const Number tension = pull / square;
    return Numbers{
        q[3], q[4], q[5], down[0] - tension * q[0], down[1] - tension * q[1], down[2] - tension * q[2]};
  };
  const int pieces =
      digits.kept ? 1 : 1 + static_cast<int>(in[8] / std::sqrt(in[1] / in[3]));  // each a radian of swing
  for (int i = 0; i < pieces; ++i)
    x = solve_extrapolation(rhs, x, t * i / pieces, t * (i + 1) / pieces, digits + 6);
  const Numbers r = turned(x[0], x[1], x[2], -w * t), u = turned(x[3], x[4], x[5], -w * t);
  return {r[0], r[1], r[2], u[0] - w * (c * r[2] + s * r[1]), u[1] + w * s * r[0], u[2] + w * c * r[0]};
}

inline constexpr const char* formula =
    "r'' = -2 w x r' - w x (w x r) + g k - tau r, |r| = L, w = omega (0, cos lambda, -sin lambda)";
inline constexpr const char* first_route = "Taylor series in the turning axes";
inline constexpr const char* second_route =
    "extrapolated midpoint rule in axes that do not turn, where gravity does";

}  // namespace oddity::truth::foucault
