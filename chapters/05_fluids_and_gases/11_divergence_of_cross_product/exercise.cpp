// Exercise 5.11: div (f x g) = curl f . g - curl g . f.
// Left side: the product is differentiated as one field by dual numbers along a randomly rotated frame. This
// div h = sum_k u_k.(u_k.grad) h shares no index lists with the proof. Right side: each published line as
// printed, from partial derivatives along the axes. The components of the cross product itself are compared
// with determinants by LU.

#include "chapters/05_fluids_and_gases/11_divergence_of_cross_product/divergence_of_cross_product.hpp"
#include "chapters/05_fluids_and_gases/shared/differentiation.hpp"
#include "solvers/counted_calls.hpp"

namespace oddity {

namespace ex05_11 {

using namespace fields;

Quantity divergence_of_product(const Parameters& p, const Reference& truth) {
  const At at(p);
  const auto f = at.f();
  const auto g = at.g();
  const Point x = at.x;
  const Known known = truth("05_11_divergence", at.inputs());
  Quantity q =
      quantity("divergence_of_product", "1/m",
               R"($\nabla\cdot(\mathbf f\times\mathbf g)$ at $\mathbf x$, for two fields of wave number $w$)",
               known, nine_digits(known.value));
  add_ways(q, "product as one field", 2,
           [=](auto& way) { return divergence_by(way, cross_product(f, g), x); });
  add_ways(q, "curl f . g - curl g . f", 1, [=](auto& way) {
    const auto f_at = counted_calls(f, way.calls);
    const auto g_at = counted_calls(g, way.calls);
    return dot(curl_by(way, f, x), g_at(x)) - dot(curl_by(way, g, x), f_at(x));
  });
  add_breakdowns(q, "product as one field", at.waves.w);
  return q;
}

Findings study(const Parameters& p, const Reference& truth) {
  return {claims(Random(p["seed"])), {divergence_of_product(p, truth)}};
}

}  // namespace ex05_11

Exercise exercise_5_11() {
  using namespace ex05_11;
  return {
      "Divergence of a cross product",
      "Show that $\\nabla\\cdot(\\mathbf f\\times\\mathbf g) = (\\nabla\\times\\mathbf f)\\cdot\\mathbf g "
      "- (\\nabla\\times\\mathbf g)\\cdot\\mathbf f$. Below $f_{2,1}$ is the derivative of $f_2$ with respect to $x_1$.",
      field_parameters,
      {},
      study,
      proofs};
}

}  // namespace oddity
