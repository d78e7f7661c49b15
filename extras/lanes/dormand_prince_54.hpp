#pragma once

#include "extras/lanes/lanes.hpp"

namespace oddity::lanes {

/// One step of J. R. Dormand and P. J. Prince's pair of orders 5 and 4 (A family of embedded Runge-Kutta
/// formulae, 1980, table 2), each lane with its own h. Goes from x with slope k1 to y with slope k7. Six
/// right-hand sides; the last is the next step's first. Returns the error in units of the tolerance.
template <class Model, class State, class Number>
[[gnu::always_inline]] inline Number dormand_prince_54(const Model& model, const State& x, const State& k1,
                                                       const Number& t, const Number& h,
                                                       const Number& tolerance, State& y, State& k7) {
  using T = typename Number::value_type;
  State k2, k3, k4, k5, k6;
  const auto stage = [&](State& k, double c, const auto& sum) {
    for (std::size_t i = 0; i < x.size(); ++i) y[i] = x[i] + h * sum(i);
    model(y, k, t + T(c) * h);
  };
  const auto a = [](double numerator, double denominator) { return T(numerator / denominator); };
  // clang-format off
  stage(k2, 1. / 5, [&](std::size_t i) { return a(1, 5) * k1[i]; });
  stage(k3, 3. / 10, [&](std::size_t i) { return a(3, 40) * k1[i] + a(9, 40) * k2[i]; });
  stage(k4, 4. / 5, [&](std::size_t i) { return a(44, 45) * k1[i] - a(56, 15) * k2[i] + a(32, 9) * k3[i]; });
  stage(k5, 8. / 9, [&](std::size_t i) {
    return a(19372, 6561) * k1[i] - a(25360, 2187) * k2[i] + a(64448, 6561) * k3[i] - a(212, 729) * k4[i]; });
  stage(k6, 1, [&](std::size_t i) {
    return a(9017, 3168) * k1[i] - a(355, 33) * k2[i] + a(46732, 5247) * k3[i] + a(49, 176) * k4[i] - a(5103, 18656) * k5[i]; });
  stage(k7, 1, [&](std::size_t i) {
    return a(35, 384) * k1[i] + a(500, 1113) * k3[i] + a(125, 192) * k4[i] - a(2187, 6784) * k5[i] + a(11, 84) * k6[i]; });
  Number worst(0);
  for (std::size_t i = 0; i < x.size(); ++i) {
    const Number off = h * (a(71, 57600) * k1[i] - a(71, 16695) * k3[i] + a(71, 1920) * k4[i] - a(17253, 339200) * k5[i]
                            + a(22, 525) * k6[i] - a(1, 40) * k7[i]);
    const Number size = greater(abs(x[i]), abs(y[i]));
    worst = larger_size(worst, abs(off / (tolerance + tolerance * size)));  // NaN counts as the largest
  }
  // clang-format on
  return worst;
}

}  // namespace oddity::lanes
