#pragma once

#include <array>

#include "reference/make/checkpoints.hpp"
#include "reference/make/extrapolation.hpp"
#include "reference/make/routes.hpp"
#include "reference/make/taylor.hpp"

/// The axis of a heavy symmetric top whose tip is at (A sin(lambda t), 0, 0), by two independent routes.
/// Inputs: m, l, mu1, mu3, g, theta, phi, psi, theta', phi', psi', A, lambda, t.
namespace oddity::truth {

struct ShakenTop {
  Number m, l, mu1, mu3, g, theta, phi, psi, dtheta, dphi, dpsi, A, lambda;

  explicit ShakenTop(const std::vector<double>& in)
      : m(in[0]),
        l(in[1]),
        mu1(in[2]),
        mu3(in[3]),
        g(in[4]),
        theta(in[5]),
        phi(in[6]),
        psi(in[7]),
        dtheta(in[8]),
        dphi(in[9]),
        dpsi(in[10]),
        A(in[11]),
        lambda(in[12]) {}
};

/// (d, L): the axis and the angular momentum about the tip, in world coordinates.
inline Numbers axis_by_momentum(const std::vector<double>& in, Precision digits) {
  const ShakenTop s(in);
  const Number st = sin(s.theta), ct = cos(s.theta), sp = sin(s.phi), cp = cos(s.phi);
  const std::array<Number, 3> d{st * sp, -ct * sp, cp}, node{ct, st, 0}, up{0, 0, 1};
  Numbers start{d[0], d[1], d[2]};
  // L = mu1 (d x d') + mu3 c d, where d x d' is the angular velocity less its part along d.
  for (std::size_t i = 0; i < 3; ++i)
    start.push_back(s.mu1 * (s.dphi * node[i] + s.dtheta * (up[i] - cp * d[i])) +
                    s.mu3 * (s.dpsi + s.dtheta * cp) * d[i]);
  const Number per = 1 / s.mu1, weight = s.m * s.g * s.l, shake = s.m * s.l * s.A * s.lambda * s.lambda;
  const auto rhs = [&](const auto& x, const auto& t) {
    const auto push = shake * sin(s.lambda * t);
    return std::vector{per * (x[4] * x[2] - x[5] * x[1]), per * (x[5] * x[0] - x[3] * x[2]),
                       per * (x[3] * x[1] - x[4] * x[0]), -(weight * x[1]),
                       weight * x[0] + push * x[2],       -(push * x[1])};
  };
  static Checkpoints kept;
  const Numbers end = kept.at(
      in[13], digits, motion_of(in, digits), [&] { return start; },
      [&](const Numbers& x, const Number& t0, const Number& t1) {
        return solve_taylor(rhs, x, t0, t1, digits + 4);
      });
  return {end[0], end[1], end[2]};
}

/// (q, w): quaternion and Euler's equations in body coordinates.
inline Numbers axis_by_quaternion(const std::vector<double>& in, Precision digits) {
  const ShakenTop s(in);
  const Number half = s.phi / 2, sum = (s.theta + s.psi) / 2, difference = (s.theta - s.psi) / 2;
  const Number spin = s.dpsi + s.dtheta * cos(s.phi), across = s.dtheta * sin(s.phi);
  const Numbers start{cos(half) * cos(sum),
                      sin(half) * cos(difference),
                      sin(half) * sin(difference),
                      cos(half) * sin(sum),
                      s.dphi * cos(s.psi) + across * sin(s.psi),
                      across * cos(s.psi) - s.dphi * sin(s.psi)};
  const auto rhs = [&](const Numbers& x, const Number& t) {
    const Number &q = x[0], &i = x[1], &j = x[2], &k = x[3], &w1 = x[4], &w2 = x[5];
    const Number fx = s.m * s.A * s.lambda * s.lambda * sin(s.lambda * t), fz = -s.m * s.g;
    const Number f1 = (q * q + i * i - j * j - k * k) * fx + 2 * (i * k - q * j) * fz;
    const Number f2 = 2 * (i * j - q * k) * fx + 2 * (j * k + q * i) * fz;
    const Number gyro = (s.mu3 / s.mu1 - 1) * spin;
    return Numbers{-(i * w1 + j * w2 + k * spin) / 2, (q * w1 + j * spin - k * w2) / 2,
                   (q * w2 + k * w1 - i * spin) / 2,  (q * spin + i * w2 - j * w1) / 2,
                   -gyro * w2 - s.l * f2 / s.mu1,     gyro * w1 + s.l * f1 / s.mu1};
  };
  static Checkpoints kept;
  const Numbers x = kept.at(
      in[13], digits, motion_of(in, digits), [&] { return start; },
      [&](const Numbers& y, const Number& t0, const Number& t1) {
        return solve_extrapolation(rhs, y, t0, t1, digits + 4);
      });
  return {2 * (x[1] * x[3] + x[0] * x[2]), 2 * (x[2] * x[3] - x[0] * x[1]),
          x[0] * x[0] - x[1] * x[1] - x[2] * x[2] + x[3] * x[3]};
}

}  // namespace oddity::truth
