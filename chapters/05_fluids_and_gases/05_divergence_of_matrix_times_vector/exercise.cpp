// Exercise 5.5: div (M f) = (M^T grad).f for a constant matrix M.
// Left side: M f is differentiated as one field by dual numbers along a randomly rotated frame. Right side:
// the published index expressions, with their sums written out. Products of M with a vector are computed by
// Eigen, except in the differentiated field.
// The operator M^T grad has the components "derivative along a column of M", and is computed from these.

#include "chapters/05_fluids_and_gases/05_divergence_of_matrix_times_vector/matrix_times_vector.hpp"
#include "chapters/05_fluids_and_gases/shared/differentiation.hpp"

namespace oddity {

namespace ex05_05 {

using namespace fields;

constexpr auto parameters = [] {
  constexpr Parameter m{"", 0, "", "entry of $M$", -1e3, 1e3};
  constexpr std::string_view names[] = {"m00", "m01", "m02", "m10", "m11", "m12", "m20", "m21", "m22"};
  constexpr double values[] = {2, -1, 0.5, 0.25, 3, -2, 1.5, 0.75, -1};
  std::array<Parameter, 14> all{};
  for (std::size_t i = 0; i < 9; ++i) all[i] = {names[i], values[i], m.unit, m.says, m.least, m.most};
  for (std::size_t i = 0; i < 5; ++i) all[9 + i] = field_parameters[i];
  return all;
}();

Quantity divergence_of_product(const Parameters& p, const Reference& truth) {
  const At at(p);
  const auto f = at.f();
  const Point x = at.x;
  Matrix<double> m;
  std::vector<double> inputs = at.inputs();
  for (std::size_t i = 0; i < 9; ++i) {
    m[i / 3][i % 3] = p[parameters[i].name];
    inputs.push_back(m[i / 3][i % 3]);
  }
  const Known known = truth("05_05_divergence", inputs);
  Quantity q = quantity("divergence_of_product", "1/m",
                        R"($\nabla\cdot(M\mathbf f)$ at $\mathbf x$, for a field of wave number $w$)", known,
                        nine_digits(known.value));
  add_ways(q, "M f as one field", 1, [=](auto& way) { return divergence_by(way, product(m, f), x); });
  add_ways(q, "f_j along column j of M", 1, [=](auto& way) {
    double sum = 0;
    for (std::size_t j = 0; j < 3; ++j) sum += way.along(f, x, column(m, j))[j];
    return sum;
  });
  add_breakdowns(q, "M f as one field", at.waves.w);
  return q;
}

Findings study(const Parameters& p, const Reference& truth) {
  return {claims(Random(p["seed"])), {divergence_of_product(p, truth)}};
}

}  // namespace ex05_05

Exercise exercise_5_5() {
  using namespace ex05_05;
  return {"Divergence of a matrix times a vector",
          "Show that $\\nabla\\cdot(M\\mathbf f) = (M^T\\nabla)\\cdot\\mathbf f$ for a constant matrix $M$. "
          "Below $f_{2,1}$ is the derivative of $f_2$ with respect to $x_1$.",
          parameters,
          {},
          study,
          proofs};
}

}  // namespace oddity
