#pragma once

// The models of exercise 3.35 besides those of the top with a fixed tip.

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <stdexcept>

#include "chapters/03_rigid_body_motion/33_heavy_top/models.hpp"

namespace oddity::top {

/// The same top with its tip left where it is: what the solution proposes for the axis.
inline Top with_fixed_tip(Top top) {
  top.A = 0;
  return top;
}

/// Near the vertical, z = d_x + i d_y: z'' - i a z' - alpha z = (m l A lambda^2/mu1) sin(lambda t).
struct SmallTilt : Top {
  Vector at(double t) const {
    using Complex = std::complex<double>;
    constexpr Complex i(0, 1);
    const double kick = m * l * A * lambda * lambda / mu1;
    const Complex forward = kick / (2.0 * i) / (-lambda * lambda + a() * lambda - alpha());
    const Complex backward = -kick / (2.0 * i) / (-lambda * lambda - a() * lambda - alpha());
    const AxisAndMomentum model{*this};
    AxisAndMomentum::State rate;
    model(model.start(), rate, 0);
    const Complex root = std::sqrt(Complex(a() * a() - 4 * alpha()));
    const Complex fast = (a() + root) / 2.0, slow = (a() - root) / 2.0;
    const Complex z = Complex(axis()[0], axis()[1]) - forward - backward;
    const Complex dz = Complex(rate[0], rate[1]) / i - lambda * (forward - backward);
    const Complex of_fast = (dz - slow * z) / (fast - slow);
    const Complex now = of_fast * std::exp(i * fast * t) + (z - of_fast) * std::exp(i * slow * t) +
                        forward * std::exp(i * lambda * t) + backward * std::exp(-i * lambda * t);
    if (!(std::norm(now) <= 1)) throw std::domain_error("the tilt is no longer small: |z| > 1");
    return {now.real(), now.imag(), std::sqrt(1 - std::norm(now))};
  }
};

/// The motion with the tip fixed, and its answer to the shaking to first order in A:
/// (d, L, delta d, delta L).
struct FirstOrderInA : Top {
  using State = std::array<double, 12>;
  State start() const {
    State x{};
    const auto fixed = AxisAndMomentum{*this}.start();
    std::copy(fixed.begin(), fixed.end(), x.begin());
    return x;
  }
  void operator()(const State& x, State& dxdt, double t) const {
    const Vector d{x[0], x[1], x[2]}, L{x[3], x[4], x[5]}, dd{x[6], x[7], x[8]}, dL{x[9], x[10], x[11]};
    const Vector weight{0, 0, -m * g}, push{-m * tip_acceleration(t), 0, 0};
    const Vector turn = cross(L, d), pull = cross(d, weight), turn_1 = cross(dL, d), turn_2 = cross(L, dd),
                 pull_1 = cross(dd, weight), pull_2 = cross(d, push);
    for (std::size_t i = 0; i < 3; ++i) {
      dxdt[i] = turn[i] / mu1;
      dxdt[3 + i] = l * pull[i];
      dxdt[6 + i] = (turn_1[i] + turn_2[i]) / mu1;
      dxdt[9 + i] = l * (pull_1[i] + pull_2[i]);
    }
  }
  Vector observe(const State& x, double) const {
    const Vector d{x[0] + x[6], x[1] + x[7], x[2] + x[8]};
    const double size = std::sqrt(dot(d, d));
    return {d[0] / size, d[1] / size, d[2] / size};
  }
};

}  // namespace oddity::top
