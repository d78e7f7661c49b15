// Exercise 2.17: the work of the forces (1, 1, 1) and (t, t, 1) on a particle at (r cos wt, r sin wt, 0).
//   W(T) = r (cos x + sin x - 1)  and  r/w (x (cos x + sin x) + cos x - sin x - 1),  x = w T.
// Both are stationary at x = pi/4 + k pi, the second at T = 0 as well.
// The independent route uses the path alone: its velocity by dual numbers, the work by Gauss-Legendre
// quadrature of F . v.

#include "chapters/02_basic_concepts/17_work_on_circle/work_on_circle.hpp"

namespace oddity {

namespace ex02_17 {

using namespace work_on_circle;

constexpr Parameter parameters[] = {
    {"r", 1, "m", "radius", 1e-3, 1e3},
    {"omega", 1, "rad/s", "angular speed", 1e-2, 10},
    {"T", 10, "s", "time", 1e-6, 100},
    {"turn", 0, "", "whole turns before the maximum", 0, 15, whole_number},
    {"seed", 17, "", "seed of the random samples", 0, 1e9, whole_number},
};

Findings study(const Parameters& p, const Reference& truth) {
  const Motion m{p["r"], p["omega"], p["T"]};
  return {
      claims(p["seed"]),
      {work(m, truth), late_work(truth), early_work(truth), maximum(m, p["turn"], truth)},
      roots(),
      R"(The work of both forces is right; of the second, {{a term dropped at the maxima|the value at the maxima lacks a term}}, and {{the start is stationary too|the start is left out of the stationary points}}.)"};
}

}  // namespace ex02_17

Exercise exercise_2_17() {
  using namespace ex02_17;
  return {
      "Work around a circle",
      "A particle is at $(r\\cos\\omega t, r\\sin\\omega t, 0)$. What work do $F=(1,1,1)$ and $F=(t,t,1)$ do "
      "until the time $T$, and when is it extremal? Below $v$ is the velocity, and $W$ the work.",
      parameters,
      {},
      study,
      proofs};
}

}  // namespace oddity
