#pragma once

#include <array>
#include <cstddef>

namespace oddity {

/// One step of the classical Runge-Kutta method in the arithmetic of the book's solver, OdeRungeKutta4, whose
/// clock is the sum of its steps. The sums are in its order, so that its printed digits are reproduced.
template <class System, std::size_t N>
void listed_step(const System& system, std::array<double, N>& x, double& t, double h) {
  using State = std::array<double, N>;
  const auto moved = [&](double by, const State& k) {
    State y;
    for (std::size_t i = 0; i < N; ++i) y[i] = x[i] + by * k[i];
    return y;
  };
  const double half = 0.5 * h, sixth = h / 6;
  State k1, k2, k3, k4;
  system(x, k1, t);
  system(moved(half, k1), k2, t + half);
  system(moved(half, k2), k3, t + half);
  t += h;
  system(moved(h, k3), k4, t);
  for (std::size_t i = 0; i < N; ++i) x[i] += sixth * (k1[i] + 2 * (k2[i] + k3[i]) + k4[i]);
}

}  // namespace oddity
