// The claims of exercise 5.11: published lines, computed from partial derivatives along the axes. The
// components of the cross product are compared with determinants by LU.

#include "chapters/05_fluids_and_gases/11_divergence_of_cross_product/divergence_of_cross_product.hpp"
#include "chapters/05_fluids_and_gases/shared/meanings.hpp"
#include "solvers/linear.hpp"

namespace oddity::ex05_11 {

namespace {

using namespace fields;

/// (a x b)_i = det [a b e_i].
Point cross_by_determinants(const Point& a, const Point& b) {
  Point c;
  for (std::size_t i = 0; i < 3; ++i) {
    Eigen::Matrix3d m;
    for (int k = 0; k < 3; ++k) {
      const auto row = static_cast<std::size_t>(k);
      m.row(k) << a[row], b[row], axes[i][row];
    }
    c[i] = determinant(m).value;
  }
  return c;
}

void fill(Sample& s, const Drawn& d) {
  const auto product = [d](const auto& x) {
    const auto f = d.f(x), g = d.g(x);
    return std::array{f[1] * g[2] - f[2] * g[1], f[2] * g[0] - f[0] * g[2], f[0] * g[1] - f[1] * g[0]};
  };
  s.put("div_fxg", divergence(cross_product(d.f, d.g), d.frame)(d.x));
  s.put("fxg", cross_by_determinants(d.f(d.x), d.g(d.x)));
  s.put_vector("f", d.f, d.x);
  s.put_vector("g", d.g, d.x);
  s.put_vector("h", product, d.x);
  s.put("curl_f", curl(d.f, d.frame)(d.x));
  s.put("curl_g", curl(d.g, d.frame)(d.x));
}

const Names names{{"div_fxg", R"(\nabla\cdot(\mathbf f\times\mathbf g))"},
                  {"fxg", R"((\mathbf f\times\mathbf g))"},
                  {"curl_f", R"((\nabla\times\mathbf f))"},
                  {"curl_g", R"((\nabla\times\mathbf g))"}};

Proof proof_of_lines(Random random) {
  Proof proof("5.11", sampled(random, fill), names);
  const std::string whole =
      R"($\mathbf f\times\mathbf g$ differentiated as one field along a turned frame, by dual numbers)";
  const std::string alone = "the bracket differentiated as one field, by dual numbers";
  const std::string curls = "curls along a turned frame, by dual numbers";

  proof.line("cross_product", 3413,
             R"($\mathbf f\times\mathbf g=(f_1g_2-f_2g_1,f_2g_0-f_0g_2,f_0g_1-f_1g_0)$)",
             {{"fxg0", "f1 g2 - f2 g1"}, {"fxg1", "f2 g0 - f0 g2"}, {"fxg2", "f0 g1 - f1 g0"}},
             R"(determinants of $\mathbf f$, $\mathbf g$ and a unit vector, by LU)");
  proof.line(
      "definition", 3411,
      R"(the divergence is the sum of the three brackets' derivatives, with $\mathbf h=\mathbf f\times\mathbf g$)",
      {{"div_fxg", "h0,0 + h1,1 + h2,2"}}, whole);
  proof.line("product_rule_0", 3419, "the first bracket's derivative with respect to $x_0$ has four terms",
             {{"h0,0", "f1,0 g2 + f1 g2,0 - f2,0 g1 - f2 g1,0"}}, alone);
  proof.line("product_rule_1", 3425, "the second bracket's derivative with respect to $x_1$ has four terms",
             {{"h1,1", "f2,1 g0 + f2 g0,1 - f0,1 g2 - f0 g2,1"}}, alone);
  proof.line("product_rule_2", 3431, "the third bracket's derivative with respect to $x_2$ has four terms",
             {{"h2,2", "f0,2 g1 + f0 g1,2 - f1,2 g0 - f1 g0,2"}}, alone);
  proof.line("product_rule", 3419, "the divergence is the sum of these twelve terms",
             {{"div_fxg",
               "f1,0 g2 + f1 g2,0 - f2,0 g1 - f2 g1,0 + f2,1 g0 + f2 g0,1 - f0,1 g2 - f0 g2,1 + f0,2 g1 + "
               "f0 g1,2 - f1,2 g0 - f1 g0,2"}},
             whole);
  proof.line("gathered", 3437, "the twelve terms gathered by the factor that is not differentiated",
             {{"div_fxg",
               "(f2,1 - f1,2) g0 + (f0,2 - f2,0) g1 + (f1,0 - f0,1) g2 - (g2,1 - g1,2) f0 - "
               "(g0,2 - g2,0) f1 - (g1,0 - g0,1) f2"}},
             whole);
  proof.line(
      "curl_f", 3437, R"(the first three terms are $(\nabla\times\mathbf f)\cdot\mathbf g$)",
      {{"curl_f0 g0 + curl_f1 g1 + curl_f2 g2", "(f2,1 - f1,2) g0 + (f0,2 - f2,0) g1 + (f1,0 - f0,1) g2"}},
      curls);
  proof.line("curl_g", 3455, R"(the last three terms are $-(\nabla\times\mathbf g)\cdot\mathbf f$)",
             {{"- curl_g0 f0 - curl_g1 f1 - curl_g2 f2",
               "- (g2,1 - g1,2) f0 - (g0,2 - g2,0) f1 - (g1,0 - g0,1) f2"}},
             curls);
  proof.line(
      "identity", 3473,
      R"($\nabla\cdot(\mathbf f\times\mathbf g)=(\nabla\times\mathbf f)\cdot\mathbf g-(\nabla\times\mathbf g)\cdot\mathbf f$)",
      {{"div_fxg", "(curl_f0 g0 + curl_f1 g1 + curl_f2 g2) - (curl_g0 f0 + curl_g1 f1 + curl_g2 f2)"}},
      whole);
  return proof;
}

}  // namespace

std::vector<Claim> claims(const Random& random) { return proof_of_lines(random).claims.in_order(); }

Provables proofs() {
  Meanings m;
  const CoqVector f = m.any_vector("f"), g = m.any_vector("g");
  m.put("div_fxg", divergence(cross(f, g)));
  m.put("fxg", cross(f, g));
  m.put_vector("f", f);
  m.put_vector("g", g);
  m.put_vector("h", cross(f, g));
  m.put("curl_f", curl(f));
  m.put("curl_g", curl(g));
  return m.proofs("5.11", proof_of_lines(Random(1)));
}

}  // namespace oddity::ex05_11
