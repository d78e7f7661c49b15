// Exercise 5.1: (f.grad) x = f, where x is the position.
// The operator f.grad is computed by dual numbers along a randomly rotated frame, sum_k (u_k.f) (u_k.grad),
// and compared with each published line. Since most derivatives of the position are zero, the operator's
// index form is also compared on random fields g, where every index matters.

#include "chapters/05_fluids_and_gases/01_directional_derivative/directional_derivative.hpp"
#include "chapters/05_fluids_and_gases/shared/differentiation.hpp"

namespace oddity {

namespace ex05_01 {

using namespace fields;

Quantity directional(const Parameters& p, const Reference& truth) {
  const At at(p);
  const Point x = at.x, f = at.waves.f(at.x);
  const Known known = truth("05_01_directional", at.inputs());
  Quantity q = quantity("directional", "1",
                        R"($(\mathbf f\cdot\nabla)\mathbf x$ at $\mathbf x$, for a field of wave number $w$)",
                        known, nine_digits(known.value));
  add_ways(q, "along f", 1, [=](auto& way) { return way.along(position, x, f); });
  const auto by_axes = [=](auto& way) { return advection_of(slopes_by(way, position, x), f); };
  add_ways(q, "along the axes", 1, by_axes, Outcome::ok, "");
  q.add(
      Breakdown{"The position is linear, so that a difference has no truncation: the coarsest step is the "
                "best, and a fine one only brings out the rounding of $\\mathbf x \\pm h\\mathbf f$.",
                "along f, central differences 2", 0x1p-31, Outcome::inaccurate,
                "along f, central differences 2", 0x1p-3});
  q.add(Breakdown{
      "Along an axis a step that is a power of two moves the point without rounding, unless a coordinate "
      "passes another power of two. The finest step here is as good as the coarsest.",
      "along f, central differences 4", 0x1p-31, Outcome::inaccurate, "along the axes, central differences 4",
      0x1p-31});
  return q;
}

Findings study(const Parameters& p, const Reference& truth) {
  return {claims(Random(p["seed"])), {directional(p, truth)}};
}

}  // namespace ex05_01

Exercise exercise_5_1() {
  using namespace ex05_01;
  return {"Directional derivative of the position",
          "Show that $(\\mathbf f\\cdot\\nabla)\\mathbf x = \\mathbf f$, where $\\mathbf x$ is the position. "
          "Below $x_{0,1}$ is the derivative of $x_0$ with respect to $x_1$.",
          field_parameters,
          {},
          study,
          proofs};
}

}  // namespace oddity
