#pragma once

#include <cmath>
#include <cstddef>

#include "report/plain/runge_kutta_4.hpp"

namespace oddity::plain {

/// Order 4, one evaluation per step. The first three steps, and three after each change of step, are by
/// Runge-Kutta 4.
template <class Model>
struct AdamsBashforth4 {
  using State = typename Model::State;
  using Number = typename State::value_type;
  State f0{}, f1{}, f2{}, f3{};  ///< derivatives at the last states, newest first
  int known = 0;                 ///< number of derivatives known
  Number last = 0;               ///< last step

  void step(const Model& model, State& x, Number t, Number h) {
    using std::abs;
    constexpr double rounding = sizeof(Number) == sizeof(float) ? 0x1p-22 : 1e-10;
    if (abs(h - last) > Number(rounding) * abs(h)) known = 0;
    last = h;
    f3 = f2, f2 = f1, f1 = f0;
    model(x, f0, t);
    if (known < 3) {
      ++known;
      return RungeKutta4<Model>().step(model, x, f0, t, h);
    }
    const Number b0 = Number(55) / 24 * h, b1 = Number(-59) / 24 * h, b2 = Number(37) / 24 * h,
                 b3 = Number(-3) / 8 * h;
    for (std::size_t i = 0; i < x.size(); ++i)
      x[i] = x[i] + b0 * f0[i] + b1 * f1[i] + b2 * f2[i] + b3 * f3[i];
  }
};

}  // namespace oddity::plain
