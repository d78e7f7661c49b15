// The claims of exercise 5.7: published lines, computed from partial derivatives along the axes.

#include "chapters/05_fluids_and_gases/07_curl_of_product/curl_of_product.hpp"
#include "chapters/05_fluids_and_gases/shared/meanings.hpp"

namespace oddity::ex05_07 {

namespace {

using namespace fields;

void fill(Sample& s, const Drawn& d) {
  s.put("curl_phi_f", curl(times(d.phi, d.f), d.frame)(d.x));
  s.put_scalar("phi", d.phi, d.x);
  s.put_vector("f", d.f, d.x);
  s.put_vector("phi_f", times(d.phi, d.f), d.x);
  s.put("curl_f", curl(d.f, d.frame)(d.x));
  s.put("grad_phi_x_f", cross(gradient(d.phi, d.frame)(d.x), d.f(d.x)));
}

const Names names{{"curl_phi_f", R"((\nabla\times\varphi\mathbf f))"},
                  {"phi_f", R"((\varphi f))"},
                  {"curl_f", R"((\nabla\times\mathbf f))"},
                  {"grad_phi_x_f", R"((\nabla\varphi\times\mathbf f))"}};

Proof proof_of_lines(Random random) {
  Proof proof("5.7", sampled(random, fill), names);
  const std::string whole =
      R"($\varphi\mathbf f$ differentiated as one field along a turned frame, by dual numbers)";
  const auto component = [&](const std::string& step, std::size_t i, int at, const std::string& says,
                             const std::string& right) {
    proof.line(step + "_" + digit(i), at, "component " + digit(i) + ": " + says,
               {{"curl_phi_f" + digit(i), right}}, whole);
  };
  const std::string definition = "curl of the product, by definition";
  component("definition", 0, 3305, definition, "phi_f2,1 - phi_f1,2");
  component("definition", 1, 3309, definition, "phi_f0,2 - phi_f2,0");
  component("definition", 2, 3311, definition, "phi_f1,0 - phi_f0,1");
  const std::string rule = "two terms for every derivative of a product";
  component("product_rule", 0, 3317, rule, "phi f2,1 + phi,1 f2 - phi f1,2 - phi,2 f1");
  component("product_rule", 1, 3323, rule, "phi f0,2 + phi,2 f0 - phi f2,0 - phi,0 f2");
  component("product_rule", 2, 3331, rule, "phi f1,0 + phi,0 f1 - phi f0,1 - phi,1 f0");
  const std::string gathered = "the terms gathered into two vectors";
  component("gathered", 0, 3343, gathered, "phi (f2,1 - f1,2) + (phi,1 f2 - phi,2 f1)");
  component("gathered", 1, 3345, gathered, "phi (f0,2 - f2,0) + (phi,2 f0 - phi,0 f2)");
  component("gathered", 2, 3349, gathered, "phi (f1,0 - f0,1) + (phi,0 f1 - phi,1 f0)");

  proof.line("first_vector", 3343,
             R"($\varphi(f_{2,1}-f_{1,2},f_{0,2}-f_{2,0},f_{1,0}-f_{0,1})=\varphi\,\nabla\times\mathbf f$)",
             {{"phi curl_f0", "phi (f2,1 - f1,2)"},
              {"phi curl_f1", "phi (f0,2 - f2,0)"},
              {"phi curl_f2", "phi (f1,0 - f0,1)"}},
             R"($\nabla\times\mathbf f$ along a turned frame, by dual numbers)");
  proof.line(
      "second_vector", 3353,
      R"($(\varphi_{,1}f_2-\varphi_{,2}f_1,\varphi_{,2}f_0-\varphi_{,0}f_2,\varphi_{,0}f_1-\varphi_{,1}f_0))"
      R"(=\nabla\varphi\times\mathbf f$)",
      {{"grad_phi_x_f0", "phi,1 f2 - phi,2 f1"},
       {"grad_phi_x_f1", "phi,2 f0 - phi,0 f2"},
       {"grad_phi_x_f2", "phi,0 f1 - phi,1 f0"}},
      R"($\nabla\varphi$ along a turned frame, by dual numbers)");
  proof.line(
      "identity", 3367,
      R"($\nabla\times(\varphi\mathbf f)=\varphi\,\nabla\times\mathbf f+\nabla\varphi\times\mathbf f$)",
      each_component("curl_phi_f#", "phi curl_f# + grad_phi_x_f#"), whole);
  return proof;
}

}  // namespace

std::vector<Claim> claims(const Random& random) { return proof_of_lines(random).claims.in_order(); }

Provables proofs() {
  Meanings m;
  const CoqField phi = m.any_scalar("phi");
  const CoqVector f = m.any_vector("f");
  m.put("curl_phi_f", curl(times(phi, f)));
  m.put_scalar("phi", phi);
  m.put_vector("f", f);
  m.put_vector("phi_f", times(phi, f));
  m.put("curl_f", curl(f));
  m.put("grad_phi_x_f", cross(gradient(phi), f));
  return m.proofs("5.7", proof_of_lines(Random(1)));
}

}  // namespace oddity::ex05_07
