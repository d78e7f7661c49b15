// Exercise 5.7: curl (phi f) = phi curl f + grad phi x f.
// Left side: the product is differentiated as one field by dual numbers along a randomly rotated frame. This
// curl h = sum_k u_k x (u_k.grad) h shares no index lists with the proof. Right side: each published line as
// printed, from partial derivatives along the axes. The quantity's reference differentiates the product in 60
// digits by extrapolated differences and by Cauchy's integral.

#include "chapters/05_fluids_and_gases/07_curl_of_product/curl_of_product.hpp"
#include "chapters/05_fluids_and_gases/shared/differentiation.hpp"
#include "solvers/counted_calls.hpp"

namespace oddity {

namespace ex05_07 {

using namespace fields;

Quantity curl_of_product(const Parameters& p, const Reference& truth) {
  const At at(p);
  const auto phi = at.phi();
  const auto f = at.f();
  const Point x = at.x;
  const Known known = truth("05_07_curl", at.inputs());
  Quantity q =
      quantity("curl_of_product", "1/m",
               R"($\nabla\times(\varphi\mathbf f)$ at $\mathbf x$, for two fields of wave number $w$)", known,
               nine_digits(known.value));
  add_ways(q, "product as one field", 2, [=](auto& way) { return curl_by(way, times(phi, f), x); });
  add_ways(q, "phi curl f + grad phi x f", 1, [=](auto& way) {
    const auto f_at = counted_calls(f, way.calls);
    const auto phi_at = counted_calls(phi, way.calls);
    const Point curl_f = curl_by(way, f, x), turned = cross(gradient_by(way, phi, x), f_at(x));
    return combined(phi_at(x), curl_f, 1, turned);
  });
  add_breakdowns(q, "product as one field", at.waves.w);
  return q;
}

Findings study(const Parameters& p, const Reference& truth) {
  return {claims(Random(p["seed"])), {curl_of_product(p, truth)}};
}

}  // namespace ex05_07

Exercise exercise_5_7() {
  using namespace ex05_07;
  return {
      "Curl of a scalar times a vector",
      "Show that $\\nabla\\times(\\varphi\\mathbf f) = \\varphi\\,\\nabla\\times\\mathbf f + "
      "\\nabla\\varphi\\times\\mathbf f$. Below $f_{2,1}$ is the derivative of $f_2$ with respect to $x_1$.",
      field_parameters,
      {},
      study,
      proofs};
}

}  // namespace oddity
