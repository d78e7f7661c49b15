// Exercise 5.13: grad (f.g) = f x curl g + g x curl f + (f.grad) g + (g.grad) f, the book's equation (5.21).
// Left side: f.g is differentiated as one field, and each of the four terms by its operator, by dual numbers
// along a randomly rotated frame. Right side: the published components as printed, from partial derivatives
// along the axes. The sum is also compared as an expression, term by term.

#include "chapters/05_fluids_and_gases/13_gradient_of_dot_product/gradient_of_dot_product.hpp"
#include "chapters/05_fluids_and_gases/shared/differentiation.hpp"
#include "solvers/counted_calls.hpp"

namespace oddity {

namespace ex05_13 {

using namespace fields;

Quantity gradient_of_product(const Parameters& p, const Reference& truth) {
  const At at(p);
  const auto f = at.f();
  const auto g = at.g();
  const Point x = at.x;
  const Known known = truth("05_13_gradient", at.inputs());
  Quantity q =
      quantity("gradient_of_product", "1/m",
               R"($\nabla(\mathbf f\cdot\mathbf g)$ at $\mathbf x$, for two fields of wave number $w$)",
               known, nine_digits(known.value));
  add_ways(q, "product as one field", 2, [=](auto& way) { return gradient_by(way, dot_product(f, g), x); });
  add_ways(q, "the four terms", 1, [=](auto& way) {
    const Point a = counted_calls(f, way.calls)(x), b = counted_calls(g, way.calls)(x);
    const Matrix<double> df = slopes_by(way, f, x), dg = slopes_by(way, g, x);
    const Point crosses = combined(1, cross(a, curl_of(dg)), 1, cross(b, curl_of(df)));
    return combined(1, crosses, 1, combined(1, advection_of(dg, a), 1, advection_of(df, b)));
  });
  add_breakdowns(q, "product as one field", at.waves.w);
  return q;
}

Findings study(const Parameters& p, const Reference& truth) {
  return {claims(Random(p["seed"])), {gradient_of_product(p, truth)}};
}

}  // namespace ex05_13

Exercise exercise_5_13() {
  using namespace ex05_13;
  return {
      "Gradient of a dot product",
      "Show that $\\nabla(\\mathbf f\\cdot\\mathbf g) = \\mathbf f\\times(\\nabla\\times\\mathbf g) + "
      "\\mathbf g\\times(\\nabla\\times\\mathbf f) + (\\mathbf f\\cdot\\nabla)\\mathbf g + "
      "(\\mathbf g\\cdot\\nabla)\\mathbf f$. Below $f_{2,1}$ is the derivative of $f_2$ with respect to $x_1$.",
      field_parameters,
      {},
      study,
      proofs};
}

}  // namespace oddity
